// SPDX-License-Identifier: Apache-2.0
// Free-form curves and surfaces: immutable, shared, evaluated by a library that only geometry/ and occt/ see.
//
// FreeCurve and FreeSurface hold any form that is not one of the analytic ones: NURBS, surfaces of revolution and of
// extrusion, offsets, conics other than circle and ellipse. They keep the parametrisation they came with.
#pragma once

#include <memory>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

namespace aresta {

namespace errors {  // geometry: 200-299
inline constexpr ErrorCode bad_geometry{200, "geometry.invalid"};
inline constexpr ErrorCode bad_transform{201, "geometry.transform"};
inline constexpr ErrorCode projection_failed{202, "geometry.projection"};
inline constexpr ErrorCode kernel_failed{203, "geometry.kernel"};
}  // namespace errors

struct NurbsCurveData {
  int degree = 0;
  bool periodic = false;
  std::vector<double> knots;  ///< strictly growing
  std::vector<int> multiplicities;
  std::vector<Vec3> poles;
  std::vector<double> weights;  ///< empty when not rational
};

struct NurbsSurfaceData {
  int degree_u = 0, degree_v = 0;
  bool periodic_u = false, periodic_v = false;
  std::vector<double> knots_u, knots_v;
  std::vector<int> multiplicities_u, multiplicities_v;
  std::size_t count_u = 0, count_v = 0;
  std::vector<Vec3> poles;      ///< poles[i * count_v + j]
  std::vector<double> weights;  ///< as poles; empty when not rational
};

struct NurbsCurve2Data {
  int degree = 0;
  bool periodic = false;
  std::vector<double> knots;
  std::vector<int> multiplicities;
  std::vector<Vec2> poles;
  std::vector<double> weights;
};

/// The library's own objects; defined in geometry/occt_handles.h, which only code that sees the library includes.
struct OcctCurve;
struct OcctCurve2;
struct OcctSurface;

class FreeCurve {
 public:
  static Result<FreeCurve> from_nurbs(const NurbsCurveData& data);
  explicit FreeCurve(std::shared_ptr<const OcctCurve> handle) : handle_(std::move(handle)) {}
  const OcctCurve& handle() const { return *handle_; }
  /// Two objects of one origin are one curve: identity by name.
  bool same_object(const FreeCurve& other) const { return handle_ == other.handle_; }

 private:
  std::shared_ptr<const OcctCurve> handle_;
};

class FreeCurve2 {
 public:
  static Result<FreeCurve2> from_nurbs(const NurbsCurve2Data& data);
  explicit FreeCurve2(std::shared_ptr<const OcctCurve2> handle) : handle_(std::move(handle)) {}
  const OcctCurve2& handle() const { return *handle_; }

 private:
  std::shared_ptr<const OcctCurve2> handle_;
};

class FreeSurface {
 public:
  static Result<FreeSurface> from_nurbs(const NurbsSurfaceData& data);
  explicit FreeSurface(std::shared_ptr<const OcctSurface> handle) : handle_(std::move(handle)) {}
  const OcctSurface& handle() const { return *handle_; }
  bool same_object(const FreeSurface& other) const { return handle_ == other.handle_; }

 private:
  std::shared_ptr<const OcctSurface> handle_;
};

}  // namespace aresta
