// SPDX-License-Identifier: Apache-2.0
// Destructive operators.
#include <algorithm>

#include "topology/operation_detail.h"

namespace aresta {

using namespace detail;

namespace {

std::vector<FaceId> faces_at(const Complex& k, VertexId v) {
  std::vector<FaceId> faces;
  for_each_item_at(k, v, [&](Item item) {
    if (item.kind == Item::Kind::side) faces.push_back(item.side().face());
  });
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

std::vector<FaceId> faces_at(const Complex& k, EdgeId e) {
  std::vector<FaceId> faces;
  for (const CoedgeId c : k.coedges(e)) faces.push_back(k.face(c));
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

WireChange wire_removal(const Complex& k, EdgeId e) {
  return {e, k.start(e), k.end(e), k.region(k.wire_shell(e))};
}

/// An edge that one loop uses twice, in both senses: the change that would join the two loops that remain.
JoiningChange joining_removal(const Complex& k, EdgeId e) {
  JoiningChange x;
  x.edge = e;
  x.ahead = k.first_coedge(e);
  x.back = k.radial(x.ahead);
  if (k.reversed(x.ahead)) std::swap(x.ahead, x.back);
  x.loop = k.loop(x.ahead);
  x.start = k.start(e);
  x.end = k.end(e);
  if (k.next(x.back) != x.ahead) x.from = k.next(x.back);
  if (k.next(x.ahead) != x.back) x.to = k.next(x.ahead);
  return x;
}

bool is_used_twice_by_one_loop(const Complex& k, EdgeId e) {
  const CoedgeId c = k.first_coedge(e);
  if (!c.valid()) return false;
  const CoedgeId d = k.radial(c);
  return d != c && k.radial(d) == c && k.loop(c) == k.loop(d) && k.reversed(c) != k.reversed(d);
}

/// Would the face be left with a vertex that is a loop and also in another loop of it?
bool leaves_double_corner(const Complex& k, const JoiningChange& x) {
  const auto occurs = [&](VertexId v) {
    for (const LoopId l : k.loops(k.face(x.loop))) {
      if (k.loop_vertex(l) == v) return true;
      for (const CoedgeId c : k.coedges(l)) {
        if (c != x.ahead && c != x.back && k.start(c) == v) return true;
      }
    }
    return false;
  };
  if (!x.from.valid() && !x.to.valid() && x.start == x.end) return true;
  return (!x.from.valid() && occurs(x.start)) || (!x.to.valid() && occurs(x.end));
}

/// An edge between two faces of agreeing orientation: the change that would divide the face that remains.
AcrossChange across_removal(const Complex& k, EdgeId e, FaceId kept) {
  AcrossChange x;
  x.edge = e;
  x.ahead = k.first_coedge(e);
  x.back = k.radial(x.ahead);
  const auto is_lone = [&](CoedgeId c) { return k.next(c) == c; };
  // A loop that is this edge alone can only be the one that goes; else it is a matter of choice.
  const bool swap = is_lone(x.ahead) != is_lone(x.back) ? is_lone(x.ahead)
                    : kept.valid()                      ? k.face(x.back) == kept
                                                        : k.face(x.back) < k.face(x.ahead);
  if (swap) std::swap(x.ahead, x.back);
  x.reversed = k.reversed(x.ahead);
  x.loop = k.loop(x.ahead);
  x.new_loop = k.loop(x.back);
  x.face = k.face(x.ahead);
  x.new_face = k.face(x.back);
  if (is_lone(x.ahead)) {
    x.vertex = k.start(x.ahead);
  } else {
    x.from = is_lone(x.back) ? k.next(x.ahead) : k.next(x.back);
    x.to = k.next(x.ahead);
  }
  for (const LoopId l : k.loops(x.new_face)) {
    if (l != x.new_loop) x.moved.push_back(l);
  }
  return x;
}

bool parts_two_agreeing_faces(const Complex& k, EdgeId e) {
  const CoedgeId c = k.first_coedge(e), d = k.radial(c);
  return d != c && k.radial(d) == c && k.face(c) != k.face(d) && k.reversed(c) != k.reversed(d);
}

/// Would the faces of the edge's two uses, made one, have a vertex that is a loop and also in another loop?
bool merges_double_corner(const Complex& k, const AcrossChange& x) {
  if (!x.from.valid()) {
    // Both loops are this edge alone and become its vertex.
    for (const FaceId f : {x.face, x.new_face}) {
      for (const LoopId l : k.loops(f)) {
        for (const CoedgeId c : k.coedges(l)) {
          if (c != x.ahead && c != x.back && k.start(c) == x.vertex) return true;
        }
        if (k.loop_vertex(l) == x.vertex) return true;
      }
    }
  }
  for (const FaceId f : {x.face, x.new_face}) {
    const FaceId other = f == x.face ? x.new_face : x.face;
    for (const LoopId l : k.loops(f)) {
      if (!k.is_vertex_loop(l)) continue;
      bool meets = false;
      for_each_vertex_of(k, Item(FaceUse(other, 0)), [&](VertexId v) { meets = meets || v == k.loop_vertex(l); });
      if (meets) return true;
    }
  }
  return false;
}

}  // namespace

Result<Applied> k_v(Complex& k, VertexId v) {
  ARESTA_CHECK(want(k, v, "vertex"));
  Operation op(k, "K_V");
  if (!k.has_no_edge(v)) {
    const EdgeEnd end = *k.edge_ends(v).begin();
    // A strut inside a face goes with its vertex and leaves the face.
    if (k.edge_ends(v).count() == 1 && k.vertex_loops(v).empty() && is_used_twice_by_one_loop(k, end.edge)) {
      const JoiningChange x = joining_removal(k, end.edge);
      if (!leaves_double_corner(k, x)) {
        const FaceId f = k.face(x.loop);
        op.kill(x);
        const LoopId l = k.vertex_loops(v).front();
        op.kill(LoopPointChange{v, {LoopPlacement{l, v, {}}}, {f}});
        return op.finish("", "sl", "vrsfle", true);
      }
    }
    for (const FaceId f : faces_at(k, v)) op.kill(face_removal(k, f, {}));
    while (!k.has_no_edge(v)) op.kill(wire_removal(k, (*k.edge_ends(v).begin()).edge));
  }
  // Faces of which the vertex is the only loop go; others only lose the loop.
  for (const FaceId f : faces_at(k, v)) {
    if (k.loops(f).count() == 1) op.kill(face_removal(k, f, {}));
  }
  if (const ShellId s = k.isolated_in_shell(v); s.valid()) {
    op.kill(PointChange{v, k.region(s)});
  } else {
    LoopPointChange x;
    x.vertex = v;
    for (const LoopId l : k.vertex_loops(v)) {
      x.loops.push_back({l, v, {}});
      x.faces.push_back(k.face(l));
    }
    op.kill(x);
  }
  return op.finish("", "sl", "vrsfle", true);
}

Result<Applied> k_e(Complex& k, EdgeId e, FaceId kept) {
  ARESTA_CHECK(want(k, e, "edge"));
  Operation op(k, "K_E");
  if (kept.valid()) {
    ARESTA_CHECK(want(k, kept, "face"));
    const auto faces = faces_at(k, e);
    if (!std::binary_search(faces.begin(), faces.end(), kept)) {
      return Error{errors::wrong_place, name_of(kept) + " is no face of " + name_of(e), {kept, e}};
    }
  }
  if (!k.is_wire(e)) {
    if (is_used_twice_by_one_loop(k, e)) {
      const JoiningChange x = joining_removal(k, e);
      if (!leaves_double_corner(k, x)) {
        op.kill(x);
        return op.finish("", "lsr", "eflrsv", true);
      }
    } else if (parts_two_agreeing_faces(k, e)) {
      const AcrossChange x = across_removal(k, e, kept);
      if (!merges_double_corner(k, x)) {
        op.kill(x);
        return op.finish("", "lsr", "eflrsv", true);
      }
    }
    for (const FaceId f : faces_at(k, e)) op.kill(face_removal(k, f, {}));
  }
  op.kill(wire_removal(k, e));
  return op.finish("", "lsr", "eflrsv", true);
}

Result<Applied> k_f(Complex& k, FaceId f, RegionId kept) {
  ARESTA_CHECK(want(k, f, "face"));
  if (kept.valid()) {
    ARESTA_CHECK(want(k, kept, "region"));
    const RegionId front = k.region(FaceUse(f, 0)), back = k.region(FaceUse(f, 1));
    if (kept != front && kept != back) {
      return Error{errors::not_in_region, name_of(f) + " does not touch " + name_of(kept), {f, kept}};
    }
    if (kept != Complex::infinite_region() &&
        (front == Complex::infinite_region() || back == Complex::infinite_region())) {
      return Error{errors::in_use, "the infinite region cannot be killed", {f, kept}};
    }
  }
  Operation op(k, "K_F");
  op.kill(face_removal(k, f, kept));
  return op.finish("", "lrs", "flrsve", true);
}

Status k_m(const Complex& k) {
  for (const VertexId v : k.vertices()) {
    return Error{errors::in_use,
                 "the model still holds " + std::to_string(k.vertex_count()) + " vertices, the first is " + name_of(v),
                 {v}};
  }
  return {};
}

}  // namespace aresta
