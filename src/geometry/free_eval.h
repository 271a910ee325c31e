// SPDX-License-Identifier: Apache-2.0
// What Curve, Curve2 and Surface ask of free forms; implemented on the hidden library in *_free.cpp.
// No exception leaves these functions: where the library fails to evaluate, coordinates are NaN.
#pragma once

#include "geometry/curve.h"
#include "geometry/curve2.h"
#include "geometry/surface.h"

namespace aresta::free_form {

const char* kind(const FreeCurve& c);
Vec3 point(const FreeCurve& c, double t);
CurveJet jet(const FreeCurve& c, double t);
double period(const FreeCurve& c);
Range domain(const FreeCurve& c);
CurveProjection project(const FreeCurve& c, Vec3 p, Range range);
Box3 bounds(const FreeCurve& c, Range range);
double length(const FreeCurve& c, Range range, double relative);
double parameter_factor(const FreeCurve& c, const Transform& t);
Result<Curve> transformed(const FreeCurve& c, const Transform& t);
NurbsCurveData to_nurbs(const FreeCurve& c, Range range);
/// Parameters between which the curve is smooth, the ends of `range` included.
std::vector<double> smooth_breaks(const FreeCurve& c, Range range);

Vec2 point(const FreeCurve2& c, double t);
Curve2Jet jet(const FreeCurve2& c, double t);
FreeCurve2 translated(const FreeCurve2& c, Vec2 by);
double period(const FreeCurve2& c);
Range domain(const FreeCurve2& c);
const char* kind(const FreeCurve2& c);

const char* kind(const FreeSurface& s);
Vec3 point(const FreeSurface& s, Vec2 uv);
SurfaceJet jet(const FreeSurface& s, Vec2 uv);
Vec3 normal(const FreeSurface& s, Vec2 uv);
Vec2 period(const FreeSurface& s);
Range2 domain(const FreeSurface& s);
SurfaceProjection project(const FreeSurface& s, Vec3 p, const Vec2* hint);
Box3 bounds(const FreeSurface& s, const Range2& piece);
std::vector<LineHit> intersect(const FreeSurface& s, const Line& line, const Range2& near);
Result<Surface> transformed(const FreeSurface& s, const Transform& t, Vec2* uv_scale);
NurbsSurfaceData to_nurbs(const FreeSurface& s, const Range2& piece);

}  // namespace aresta::free_form
