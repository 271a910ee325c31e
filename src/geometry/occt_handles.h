// SPDX-License-Identifier: Apache-2.0
// The library's objects behind FreeCurve, FreeCurve2 and FreeSurface. Include only where OCCT may be seen.
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <memory>
#include <mutex>

#include "geometry/curve.h"
#include "geometry/curve2.h"
#include "geometry/surface.h"

namespace aresta {

/// Something computed from the object when first asked for, by whichever thread comes first; a copy starts empty.
template <class T>
class ComputedOnce {
 public:
  ComputedOnce() = default;
  ComputedOnce(const ComputedOnce&) {}
  ComputedOnce& operator=(const ComputedOnce&) = delete;

  template <class F>
  const T& get(F&& compute) const {
    std::call_once(once_, [&] { value_ = std::make_shared<const T>(compute()); });
    return *value_;
  }

 private:
  mutable std::once_flag once_;
  mutable std::shared_ptr<const T> value_;
};

/// Points on a curve or surface at a grid of parameters, where searches for a nearest point start.
struct CurveSamples;
struct SurfaceSamples;
/// The surface in Bezier patches, where searches for meetings start.
struct SurfacePatches;

struct OcctCurve {
  Handle(Geom_Curve) curve;
  ComputedOnce<CurveSamples> samples = {};
};
struct OcctCurve2 {
  Handle(Geom2d_Curve) curve;
};
struct OcctSurface {
  Handle(Geom_Surface) surface;
  ComputedOnce<SurfaceSamples> samples = {};
  ComputedOnce<SurfacePatches> patches = {};
};

/// Conversions keep the parametrisation. Trimmed curves and surfaces become their basis. Handles must not be null.
/// to_occt throws Standard_Failure, as the library does, for a form with impossible sizes (a radius <= 0, ...).
Curve from_occt(const Handle(Geom_Curve) & curve);
Curve2 from_occt(const Handle(Geom2d_Curve) & curve);
Surface from_occt(const Handle(Geom_Surface) & surface);
Handle(Geom_Curve) to_occt(const Curve& curve);
Handle(Geom2d_Curve) to_occt(const Curve2& curve);
Handle(Geom_Surface) to_occt(const Surface& surface);

}  // namespace aresta
