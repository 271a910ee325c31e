// SPDX-License-Identifier: Apache-2.0
#include "geometry/swept.h"

#include <Geom2dConvert.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <gp_Ax1.hxx>

#include "geometry/occt_guard.h"
#include "geometry/occt_handles.h"

namespace aresta {

namespace {

template <class F>
Result<Surface> made(const char* what, F&& make) {
  try {
    const Handle(Geom_Surface) surface = make();
    return Surface(FreeSurface(std::make_shared<const OcctSurface>(OcctSurface{surface})));
  } catch (const Standard_Failure& failure) {
    const char* text = failure.GetMessageString();
    return Error{errors::bad_geometry, std::string("no ") + what + ": " + (text != nullptr ? text : "refused")};
  }
}

}  // namespace

Result<Surface> extrusion_surface(const Curve& curve, Vec3 direction) {
  return made("surface of extrusion can be made of this curve", [&]() -> Handle(Geom_Surface) {
    return new Geom_SurfaceOfLinearExtrusion(to_occt(curve), gp_Dir(direction.x, direction.y, direction.z));
  });
}

Result<Surface> revolution_surface(const Curve& curve, Vec3 origin, Vec3 axis) {
  return made("surface of revolution can be made of this curve", [&]() -> Handle(Geom_Surface) {
    return new Geom_SurfaceOfRevolution(to_occt(curve),
                                        gp_Ax1(gp_Pnt(origin.x, origin.y, origin.z), gp_Dir(axis.x, axis.y, axis.z)));
  });
}

Result<Curve2> rescaled(const Curve2& image, Vec2 uv_scale, double t_scale, Range range) {
  if (uv_scale == Vec2{1, 1} && t_scale == 1) return image;
  const auto scaled = [&](Vec2 p) { return Vec2{uv_scale.x * p.x, uv_scale.y * p.y}; };
  if (const Line2* line = image.get_if<Line2>()) {
    const Vec2 direction = scaled(line->direction) / t_scale;
    if (std::abs(norm(direction) - 1) <= 1e-13) return Curve2(Line2{scaled(line->origin), direction / norm(direction)});
  }
  if (const Ellipse2* e = image.get_if<Ellipse2>()) {
    const bool aligned = e->x.x == 0 || e->x.y == 0;
    if (t_scale == 1 && (uv_scale.x == uv_scale.y || aligned)) {
      const Vec2 x = scaled(e->x), y = scaled(e->y);
      return Curve2(Ellipse2{scaled(e->origin), x / norm(x), y / norm(y), e->major * norm(x), e->minor * norm(y)});
    }
    return Error{errors::bad_transform, "the elliptic image of an edge in its surface cannot be rescaled"};
  }
  try {
    const Handle(Geom2d_TrimmedCurve) piece = new Geom2d_TrimmedCurve(to_occt(image), range.low, range.high);
    const Handle(Geom2d_BSplineCurve) spline = Geom2dConvert::CurveToBSplineCurve(piece);
    NurbsCurve2Data data;
    data.degree = spline->Degree();
    for (int i = 1; i <= spline->NbKnots(); ++i) {
      data.knots.push_back(t_scale * spline->Knot(i));
      data.multiplicities.push_back(spline->Multiplicity(i));
    }
    for (int i = 1; i <= spline->NbPoles(); ++i) {
      data.poles.push_back(scaled({spline->Pole(i).X(), spline->Pole(i).Y()}));
      if (spline->IsRational()) data.weights.push_back(spline->Weight(i));
    }
    ARESTA_TRY(FreeCurve2 curve, FreeCurve2::from_nurbs(data));
    return Curve2(std::move(curve));
  } catch (const Standard_Failure&) {
    return Error{errors::bad_transform, "the image of an edge in its surface cannot be rescaled"};
  }
}

}  // namespace aresta
