// SPDX-License-Identifier: Apache-2.0
// The library's object behind OcctShape. Include only where OCCT may be seen.
#pragma once

#include <TopoDS_Shape.hxx>

#include "occt/shape.h"

namespace aresta {

struct OcctShapeData {
  TopoDS_Shape shape;
};

inline OcctShape wrap(const TopoDS_Shape& shape) {
  return shape.IsNull() ? OcctShape() : OcctShape(std::make_shared<const OcctShapeData>(OcctShapeData{shape}));
}

}  // namespace aresta
