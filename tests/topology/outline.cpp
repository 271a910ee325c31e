// SPDX-License-Identifier: Apache-2.0
#include "outline.h"

#include "topology/canonical.h"

namespace aresta {

namespace {

template <class IdType>
std::string word(const char* letter, IdType id) {
  return letter + std::to_string(id.value);
}

std::string word(Item item) {
  switch (item.kind) {
    case Item::Kind::side:
      return word(item.side().side() == 0 ? "+f" : "-f", item.side().face());
    case Item::Kind::wire:
      return word("e", item.wire());
    case Item::Kind::point:
      return word("v", item.point());
  }
  return "";
}

}  // namespace

std::string outline(const Complex& k) {
  std::string text;
  const auto begin = [&](const std::string& name) { text += (text.empty() ? "" : "; ") + name + ":"; };
  for (const RegionId r : k.regions()) {
    begin(word("r", r));
    const char* comma = "";
    for (const auto& shell : canonical_shells(k, r)) {
      text += comma;
      for (const Item item : shell) text += " " + word(item);
      comma = ",";
    }
  }
  for (const FaceId f : k.faces()) {
    begin(word("f", f));
    const char* comma = "";
    for (const LoopId l : canonical_loops(k, f)) {
      text += comma;
      if (k.is_vertex_loop(l)) text += " " + word("v", k.loop_vertex(l));
      for (const CoedgeId c : canonical_coedges(k, l)) text += " " + word(k.reversed(c) ? "-e" : "+e", k.edge(c));
      comma = ",";
    }
  }
  for (const EdgeId e : k.edges()) {
    begin(word("e", e));
    text += " " + word("v", k.start(e)) + " " + word("v", k.end(e));
    const auto uses = canonical_coedges(k, e);
    if (uses.size() < 3) continue;
    text += ",";
    for (const CoedgeId c : uses) text += " " + word(k.reversed(c) ? "-f" : "+f", k.face(c));
  }
  return text;
}

}  // namespace aresta
