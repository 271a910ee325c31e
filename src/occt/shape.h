// SPDX-License-Identifier: Apache-2.0
// A shape of the kernel library, opaque here: shared, never changed once made. Its inside is in occt/shape_data.h,
// which only code that sees the library includes.
#pragma once

#include <cstddef>
#include <memory>

#include "base/result.h"

namespace aresta {

struct OcctShapeData;

/// Distinct subshapes; edges without extent (poles, apexes) are not counted.
struct ShapeCounts {
  std::size_t solids = 0, faces = 0, edges = 0, vertices = 0;
  constexpr bool operator==(const ShapeCounts&) const = default;
};

class OcctShape {
 public:
  /// Null: no shape at all.
  OcctShape() = default;
  explicit OcctShape(std::shared_ptr<const OcctShapeData> data) : data_(std::move(data)) {}

  bool null() const { return data_ == nullptr; }
  /// Must not be null.
  const OcctShapeData& data() const { return *data_; }

  ShapeCounts counts() const;
  /// Sum over the solids of the shape; by the library's quadrature: about nine digits on analytic forms, six on NURBS.
  Result<double> volume() const;

 private:
  std::shared_ptr<const OcctShapeData> data_;
};

}  // namespace aresta
