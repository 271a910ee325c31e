// SPDX-License-Identifier: Apache-2.0
#include "topology/dump.h"

#include <charconv>
#include <string_view>

#include "topology/canonical.h"

namespace aresta {

namespace {

class Writer {
 public:
  template <class... Parts>
  void put(const Parts&... parts) {
    (add(parts), ...);
  }
  std::string take() { return std::move(text_); }

 private:
  void add(std::string_view words) { text_ += words; }
  void add(VertexId v) { add_id('v', v.value); }
  void add(EdgeId e) { add_id('e', e.value); }
  void add(CoedgeId c) { add_id('c', c.value); }
  void add(LoopId l) { add_id('l', l.value); }
  void add(FaceId f) { add_id('f', f.value); }
  void add(RegionId r) { add_id('r', r.value); }
  void add(std::size_t count) { add_number(count); }
  void add(Item item) {
    switch (item.kind) {
      case Item::Kind::side:
        put(item.side().side() == 0 ? "+" : "-", item.side().face());
        return;
      case Item::Kind::wire:
        add(item.wire());
        return;
      case Item::Kind::point:
        add(item.point());
        return;
    }
  }
  void add_id(char letter, std::uint32_t id) {
    text_ += letter;
    add_number(id);
  }
  void add_number(std::size_t number) {
    char digits[20];
    text_.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
  }

  std::string text_;
};

void put_region(Writer& out, const Complex& k, RegionId r) {
  out.put("region ", r, ": ", k.is_filled(r) ? "filled" : r == k.infinite_region() ? "infinite" : "empty", "\n");
  for (const auto& items : canonical_shells(k, r)) {
    out.put("  shell");
    for (const Item item : items) out.put(" ", item);
    out.put("\n");
  }
}

void put_face(Writer& out, const Complex& k, FaceId f) {
  out.put("face ", f, ": front ", k.region(FaceUse(f, 0)), ", back ", k.region(FaceUse(f, 1)), "\n");
  for (const LoopId l : canonical_loops(k, f)) {
    if (k.is_vertex_loop(l)) {
      out.put("  loop ", l, ": ", k.loop_vertex(l), "\n");
      continue;
    }
    out.put("  loop ", l, "\n");
    for (const CoedgeId c : canonical_coedges(k, l)) {
      out.put("    coedge ", c, ": ", k.reversed(c) ? "-" : "+", k.edge(c), ", ", k.start(c), " to ", k.end(c),
              ", radial ", k.radial(c), "\n");
    }
  }
}

void put_edge(Writer& out, const Complex& k, EdgeId e) {
  out.put("edge ", e, ": ", k.start(e), " to ", k.end(e), ", ");
  if (k.is_wire(e)) {
    out.put("wire in ", k.region(k.wire_shell(e)), "\n");
    return;
  }
  out.put("radial");
  for (const CoedgeId c : canonical_coedges(k, e)) out.put(" ", c);
  out.put("\n");
}

void put_vertex(Writer& out, const Complex& k, VertexId v) {
  out.put("vertex ", v, ":");
  for (const EdgeEnd end : canonical_edge_ends(k, v)) out.put(end.end == 0 ? " +" : " -", end.edge);
  for (const LoopId l : canonical_vertex_loops(k, v)) out.put(" ", l);
  const ShellId s = k.isolated_in_shell(v);
  if (s.valid()) out.put(" in ", k.region(s));
  out.put("\n");
}

}  // namespace

std::string dump(const Complex& k) {
  Writer out;
  out.put("aresta complex 1\n");
  out.put("# regions ", k.region_count(), ", shells ", k.shell_count(), ", faces ", k.face_count(), ", loops ",
          k.loop_count(), ", edges ", k.edge_count(), ", vertices ", k.vertex_count(), "\n");
  for (const RegionId r : k.regions()) put_region(out, k, r);
  for (const FaceId f : k.faces()) put_face(out, k, f);
  for (const EdgeId e : k.edges()) put_edge(out, k, e);
  for (const VertexId v : k.vertices()) put_vertex(out, k, v);
  return out.take();
}

}  // namespace aresta
