// SPDX-License-Identifier: Apache-2.0
// Free-form surfaces, on the hidden library: evaluation, bounds and change of form.
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <gp_GTrsf2d.hxx>
#include <gp_Trsf.hxx>
#include <string_view>

#include "geometry/analytic.h"
#include "geometry/free_eval.h"
#include "geometry/nurbs_data.h"
#include "geometry/occt_guard.h"
#include "geometry/occt_handles.h"

namespace aresta::free_form {

using occt::guarded;
using occt::nowhere;
using occt::vec;

namespace {

const Handle(Geom_Surface) & of(const FreeSurface& s) {
  return s.handle().surface;
}
double opened(double t) {
  return std::abs(t) >= 1e100 ? std::copysign(analytic::infinity, t) : t;
}

FreeSurface wrapped(const Handle(Geom_Surface) & s) {
  return FreeSurface(std::make_shared<const OcctSurface>(OcctSurface{s}));
}

bool finite(const Range2& r) {
  return std::isfinite(r.u.low) && std::isfinite(r.u.high) && std::isfinite(r.v.low) && std::isfinite(r.v.high);
}

}  // namespace

const char* kind(const FreeSurface& s) {
  const Handle(Geom_Surface)& g = of(s);
  if (g->IsKind(STANDARD_TYPE(Geom_BSplineSurface))) return "nurbs";
  if (g->IsKind(STANDARD_TYPE(Geom_BezierSurface))) return "bezier";
  if (g->IsKind(STANDARD_TYPE(Geom_SurfaceOfRevolution))) return "revolution";
  if (g->IsKind(STANDARD_TYPE(Geom_SurfaceOfLinearExtrusion))) return "extrusion";
  if (g->IsKind(STANDARD_TYPE(Geom_OffsetSurface))) return "offset";
  return "other";
}

Vec3 point(const FreeSurface& s, Vec2 uv) {
  return guarded([&] { return vec(of(s)->Value(uv.x, uv.y)); }, nowhere);
}

SurfaceJet jet(const FreeSurface& s, Vec2 uv) {
  return guarded(
      [&] {
        gp_Pnt p;
        gp_Vec du, dv, duu, dvv, duv;
        of(s)->D2(uv.x, uv.y, p, du, dv, duu, dvv, duv);
        return SurfaceJet{vec(p), vec(du), vec(dv), vec(duu), vec(duv), vec(dvv)};
      },
      SurfaceJet{nowhere, nowhere, nowhere, nowhere, nowhere, nowhere});
}

Vec3 normal(const FreeSurface& s, Vec2 uv) {
  const SurfaceJet j = jet(s, uv);
  const auto unit = [](Vec3 a, Vec3 b, double scale) {
    const Vec3 n = cross(a, b);
    const double length = norm(n);
    return length > 1e-10 * scale ? n / length : Vec3{};
  };
  const double lu = norm(j.du), lv = norm(j.dv);
  // Singular points: a vanishing derivative is replaced by its growth along the other parameter, into the domain.
  const Range2 d = domain(s);
  const double step_u = uv.x >= d.u.high ? -1 : 1, step_v = uv.y >= d.v.high ? -1 : 1;
  const double size = std::max({lu, lv, norm(j.duv)});
  if (lu > 1e-9 * size && lv > 1e-9 * size) {
    const Vec3 n = unit(j.du, j.dv, lu * lv);
    if (n != Vec3{}) return n;
  }
  if (lu <= 1e-9 * size && lv > 0) {
    const Vec3 n = unit(step_v * j.duv, j.dv, norm(j.duv) * lv);
    if (n != Vec3{}) return n;
  }
  if (lv <= 1e-9 * size && lu > 0) {
    const Vec3 n = unit(j.du, step_u * j.duv, norm(j.duv) * lu);
    if (n != Vec3{}) return n;
  }
  // Parallel tangents, or everything vanishes: the normal a little way inside.
  const double hu = std::isfinite(d.u.length()) ? d.u.length() * 1e-5 : 1e-5;
  const double hv = std::isfinite(d.v.length()) ? d.v.length() * 1e-5 : 1e-5;
  const SurfaceJet k = jet(s, {uv.x + step_u * hu, uv.y + step_v * hv});
  return unit(k.du, k.dv, norm(k.du) * norm(k.dv));
}

Vec2 period(const FreeSurface& s) {
  return guarded(
      [&] {
        const Handle(Geom_Surface)& g = of(s);
        return Vec2{g->IsUPeriodic() ? g->UPeriod() : 0.0, g->IsVPeriodic() ? g->VPeriod() : 0.0};
      },
      Vec2{});
}

Range2 domain(const FreeSurface& s) {
  double u0, u1, v0, v1;
  of(s)->Bounds(u0, u1, v0, v1);
  return {{opened(u0), opened(u1)}, {opened(v0), opened(v1)}};
}

Box3 bounds(const FreeSurface& s, const Range2& piece) {
  constexpr double inf = analytic::infinity;
  if (const auto offset = Handle(Geom_OffsetSurface)::DownCast(of(s))) {
    return from_occt(offset->BasisSurface()).bounds(piece).grown(std::abs(offset->Offset()));
  }
  Box3 box;
  if (const auto extrusion = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(of(s))) {
    const Box3 base = from_occt(extrusion->BasisCurve()).bounds(piece.u);
    const gp_Dir d = extrusion->Direction();
    const Box3 way = analytic::bounds(Line{{}, {d.X(), d.Y(), d.Z()}}, piece.v);
    return {base.low + way.low, base.high + way.high};
  }
  for (const Vec3 p : to_nurbs(s, piece).poles) box.add(p);
  if (box.empty()) return {{-inf, -inf, -inf}, {inf, inf, inf}};
  return box.grown(8 * analytic::epsilon * (norm(box.low) + norm(box.high)));
}

Result<Surface> transformed(const FreeSurface& s, const Transform& t, Vec2* uv_scale) {
  if (!std::isfinite(t.determinant()) || t.determinant() == 0 || !is_finite(t.offset)) {
    return Error{errors::bad_transform, "this transformation is singular or not finite"};
  }
  return occt::attempted("transform a surface", [&]() -> Result<Surface> {
    if (uv_scale != nullptr) *uv_scale = {1, 1};
    const auto moved = [&](const auto& from, auto to) {
      for (int i = 1; i <= from->NbUPoles(); ++i) {
        for (int j = 1; j <= from->NbVPoles(); ++j) to->SetPole(i, j, occt::pnt(t.point(vec(from->Pole(i, j)))));
      }
      return Surface(wrapped(to));
    };
    if (auto spline = Handle(Geom_BSplineSurface)::DownCast(of(s))) {
      return moved(spline, Handle(Geom_BSplineSurface)::DownCast(spline->Copy()));
    }
    if (auto bezier = Handle(Geom_BezierSurface)::DownCast(of(s))) {
      return moved(bezier, Handle(Geom_BezierSurface)::DownCast(bezier->Copy()));
    }
    if (!t.is_similarity()) {
      return Error{
          errors::bad_transform,
          std::string("a surface of kind ") + kind(s) + " takes moves, turns, mirrors and uniform scalings only",
          {},
          {},
          "convert the surface to NURBS first"};
    }
    const auto& r = t.rows;
    gp_Trsf trsf;
    trsf.SetValues(r[0].x, r[0].y, r[0].z, t.offset.x, r[1].x, r[1].y, r[1].z, t.offset.y, r[2].x, r[2].y, r[2].z,
                   t.offset.z);
    const Handle(Geom_Surface) copy = Handle(Geom_Surface)::DownCast(of(s)->Transformed(trsf));
    if (uv_scale != nullptr) {
      const gp_GTrsf2d map = of(s)->ParametricTransformation(trsf);
      *uv_scale = {map.Value(1, 1), map.Value(2, 2)};
    }
    return Surface(wrapped(copy));
  });
}

NurbsSurfaceData to_nurbs(const FreeSurface& s, const Range2& piece) {
  if (!finite(piece) || !(piece.u.low < piece.u.high) || !(piece.v.low < piece.v.high)) return {};
  return guarded(
      [&] {
        const Handle(Geom_RectangularTrimmedSurface) part =
            new Geom_RectangularTrimmedSurface(of(s), piece.u.low, piece.u.high, piece.v.low, piece.v.high);
        Handle(Geom_BSplineSurface) spline = GeomConvert::SurfaceToBSplineSurface(part);
        if (spline->IsUPeriodic() || spline->IsVPeriodic()) {
          spline = Handle(Geom_BSplineSurface)::DownCast(spline->Copy());
          if (spline->IsUPeriodic()) spline->SetUNotPeriodic();
          if (spline->IsVPeriodic()) spline->SetVNotPeriodic();
        }
        return data_of(spline);
      },
      NurbsSurfaceData{});
}

}  // namespace aresta::free_form
