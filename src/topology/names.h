// SPDX-License-Identifier: Apache-2.0
// How dumps and messages name what has an id: v5, e7, c40, l3, f12, r0; sides of faces +f12 and -f12.
#pragma once

#include <string>

#include "topology/item.h"

namespace aresta {

inline std::string name(VertexId v) {
  return "v" + std::to_string(v.value);
}
inline std::string name(EdgeId e) {
  return "e" + std::to_string(e.value);
}
inline std::string name(CoedgeId c) {
  return "c" + std::to_string(c.value);
}
inline std::string name(LoopId l) {
  return "l" + std::to_string(l.value);
}
inline std::string name(FaceId f) {
  return "f" + std::to_string(f.value);
}
inline std::string name(RegionId r) {
  return "r" + std::to_string(r.value);
}
inline std::string name(FaceUse u) {
  return (u.side() == 0 ? "+" : "-") + name(u.face());
}
inline std::string name(Item item) {
  switch (item.kind) {
    case Item::Kind::side:
      return name(item.side());
    case Item::Kind::wire:
      return name(item.wire());
    case Item::Kind::point:
      return name(item.point());
  }
  return {};
}

}  // namespace aresta
