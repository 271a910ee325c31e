// SPDX-License-Identifier: Apache-2.0
#include "geometry/occt_handles.h"

#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>

namespace aresta {

namespace {

Vec3 vec(const gp_Pnt& p) {
  return {p.X(), p.Y(), p.Z()};
}
Vec3 vec(const gp_Dir& d) {
  return {d.X(), d.Y(), d.Z()};
}
Vec2 vec(const gp_Pnt2d& p) {
  return {p.X(), p.Y()};
}
Vec2 vec(const gp_Dir2d& d) {
  return {d.X(), d.Y()};
}
gp_Pnt pnt(Vec3 p) {
  return {p.x, p.y, p.z};
}
gp_Dir dir(Vec3 d) {
  return {d.x, d.y, d.z};
}

Frame frame(const gp_Ax2& a) {
  return {vec(a.Location()), vec(a.XDirection()), vec(a.YDirection()), vec(a.Direction())};
}
Frame frame(const gp_Ax3& a) {
  return {vec(a.Location()), vec(a.XDirection()), vec(a.YDirection()), vec(a.Direction())};
}

/// For curves: only x and y matter, so z is what makes the axes right-handed.
gp_Ax2 curve_axes(const Frame& f) {
  return {pnt(f.origin), dir(cross(f.x, f.y)), dir(f.x)};
}

gp_Ax3 surface_axes(const Frame& f) {
  gp_Ax3 axes(pnt(f.origin), dir(f.z), dir(f.x));
  if (!f.right_handed()) axes.YReverse();
  return axes;
}

struct ToOcctCurve {
  Handle(Geom_Curve) operator()(const Line& c) const { return new Geom_Line(pnt(c.origin), dir(c.direction)); }
  Handle(Geom_Curve) operator()(const Circle& c) const { return new Geom_Circle(curve_axes(c.frame), c.radius); }
  Handle(Geom_Curve) operator()(const Ellipse& c) const {
    return new Geom_Ellipse(curve_axes(c.frame), c.major, c.minor);
  }
  Handle(Geom_Curve) operator()(const FreeCurve& c) const { return c.handle().curve; }
};

struct ToOcctCurve2 {
  Handle(Geom2d_Curve) operator()(const Line2& c) const {
    return new Geom2d_Line(gp_Pnt2d(c.origin.x, c.origin.y), gp_Dir2d(c.direction.x, c.direction.y));
  }
  Handle(Geom2d_Curve) operator()(const Ellipse2& c) const {
    const gp_Ax22d axes(gp_Pnt2d(c.origin.x, c.origin.y), gp_Dir2d(c.x.x, c.x.y), gp_Dir2d(c.y.x, c.y.y));
    if (c.major == c.minor) return new Geom2d_Circle(axes, c.major);
    return new Geom2d_Ellipse(axes, c.major, c.minor);
  }
  Handle(Geom2d_Curve) operator()(const FreeCurve2& c) const { return c.handle().curve; }
};

struct ToOcctSurface {
  Handle(Geom_Surface) operator()(const Plane& s) const { return new Geom_Plane(surface_axes(s.frame)); }
  Handle(Geom_Surface) operator()(const Cylinder& s) const {
    return new Geom_CylindricalSurface(surface_axes(s.frame), s.radius);
  }
  Handle(Geom_Surface) operator()(const Cone& s) const {
    return new Geom_ConicalSurface(surface_axes(s.frame), s.half_angle, s.radius);
  }
  Handle(Geom_Surface) operator()(const Sphere& s) const {
    return new Geom_SphericalSurface(surface_axes(s.frame), s.radius);
  }
  Handle(Geom_Surface) operator()(const Torus& s) const {
    return new Geom_ToroidalSurface(surface_axes(s.frame), s.major, s.minor);
  }
  Handle(Geom_Surface) operator()(const FreeSurface& s) const { return s.handle().surface; }
};

}  // namespace

Curve from_occt(const Handle(Geom_Curve) & given) {
  Handle(Geom_Curve) curve = given;
  while (auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve)) curve = trimmed->BasisCurve();
  if (auto line = Handle(Geom_Line)::DownCast(curve)) {
    return Line{vec(line->Position().Location()), vec(line->Position().Direction())};
  }
  if (auto circle = Handle(Geom_Circle)::DownCast(curve)) return Circle{frame(circle->Position()), circle->Radius()};
  if (auto ellipse = Handle(Geom_Ellipse)::DownCast(curve)) {
    return Ellipse{frame(ellipse->Position()), ellipse->MajorRadius(), ellipse->MinorRadius()};
  }
  return FreeCurve(std::make_shared<const OcctCurve>(OcctCurve{curve}));
}

Curve2 from_occt(const Handle(Geom2d_Curve) & given) {
  Handle(Geom2d_Curve) curve = given;
  while (auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(curve)) curve = trimmed->BasisCurve();
  if (auto line = Handle(Geom2d_Line)::DownCast(curve)) return Line2{vec(line->Location()), vec(line->Direction())};
  if (auto circle = Handle(Geom2d_Circle)::DownCast(curve)) {
    const gp_Ax22d& axes = circle->Position();
    return Ellipse2{vec(axes.Location()), vec(axes.XDirection()), vec(axes.YDirection()), circle->Radius(),
                    circle->Radius()};
  }
  if (auto ellipse = Handle(Geom2d_Ellipse)::DownCast(curve)) {
    const gp_Ax22d& axes = ellipse->Position();
    return Ellipse2{vec(axes.Location()), vec(axes.XDirection()), vec(axes.YDirection()), ellipse->MajorRadius(),
                    ellipse->MinorRadius()};
  }
  return FreeCurve2(std::make_shared<const OcctCurve2>(OcctCurve2{curve}));
}

Surface from_occt(const Handle(Geom_Surface) & given) {
  Handle(Geom_Surface) surface = given;
  while (auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface)) surface = trimmed->BasisSurface();
  if (auto plane = Handle(Geom_Plane)::DownCast(surface)) return Plane{frame(plane->Position())};
  if (auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface)) {
    return Cylinder{frame(cylinder->Position()), cylinder->Radius()};
  }
  if (auto cone = Handle(Geom_ConicalSurface)::DownCast(surface)) {
    return Cone{frame(cone->Position()), cone->RefRadius(), cone->SemiAngle()};
  }
  if (auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface)) {
    return Sphere{frame(sphere->Position()), sphere->Radius()};
  }
  if (auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface)) {
    return Torus{frame(torus->Position()), torus->MajorRadius(), torus->MinorRadius()};
  }
  return FreeSurface(std::make_shared<const OcctSurface>(OcctSurface{surface}));
}

Handle(Geom_Curve) to_occt(const Curve& curve) {
  return std::visit(ToOcctCurve{}, curve.form());
}
Handle(Geom2d_Curve) to_occt(const Curve2& curve) {
  return std::visit(ToOcctCurve2{}, curve.form());
}
Handle(Geom_Surface) to_occt(const Surface& surface) {
  return std::visit(ToOcctSurface{}, surface.form());
}

}  // namespace aresta
