// SPDX-License-Identifier: Apache-2.0
// Surfaces: a value type over exact analytic forms and free-form surfaces.
//
// Parametrisation equals that of the STEP standard (and of OCCT), in the frame (o; x, y, z), angles in radians:
//   Plane     o + u x + v y
//   Cylinder  o + r (cos u x + sin u y) + v z
//   Cone      o + (r + v sin a)(cos u x + sin u y) + v cos a z          a: half angle, signed; v along the slant
//   Sphere    o + r cos v (cos u x + sin u y) + r sin v z               v in [-pi/2, pi/2]
//   Torus     o + (R + r cos v)(cos u x + sin u y) + r sin v z
// The natural normal is d1u x d1v; a left-handed frame turns it round.
#pragma once

#include <variant>

#include "base/result.h"
#include "geometry/curve.h"
#include "geometry/free_form.h"
#include "math/box.h"
#include "math/transform.h"

namespace aresta {

struct Plane {
  Frame frame;
};

struct Cylinder {
  Frame frame;
  double radius = 0;
};

struct Cone {
  Frame frame;
  double radius = 0;      ///< at v = 0
  double half_angle = 0;  ///< radians, in (-pi/2, pi/2), not 0
};

struct Sphere {
  Frame frame;
  double radius = 0;
};

struct Torus {
  Frame frame;
  double major = 0, minor = 0;
};

/// A box in the parameter plane.
struct Range2 {
  Range u, v;
};

struct SurfaceJet {
  Vec3 point, du, dv, duu, duv, dvv;
};

struct SurfaceProjection {
  Vec2 uv;
  Vec3 point;
  double distance = 0;
};

/// Where a straight line meets a surface.
struct LineHit {
  double t = 0;  ///< parameter on the line
  Vec2 uv;       ///< on the surface
};

class Surface {
 public:
  using Form = std::variant<Plane, Cylinder, Cone, Sphere, Torus, FreeSurface>;

  Surface(Form form) : form_(std::move(form)) {}
  template <class T>
  requires std::constructible_from<Form, T> Surface(T form) : form_(std::move(form)) {}

  const Form& form() const { return form_; }
  template <class T>
  const T* get_if() const {
    return std::get_if<T>(&form_);
  }
  bool is_plane() const { return get_if<Plane>() != nullptr; }
  const char* kind()
      const;  ///< "plane", "cylinder", "cone", "sphere", "torus", "nurbs", "revolution", "extrusion", ...

  Vec3 point(Vec2 uv) const;
  SurfaceJet jet(Vec2 uv) const;
  /// Unit natural normal; at a singular point (pole, apex) the limit along u = const where there is one, else zero.
  Vec3 normal(Vec2 uv) const;
  /// Period in u and in v; 0 where not periodic.
  Vec2 period() const;
  /// Where the surface is defined; infinite where it is.
  Range2 domain() const;

  /// Nearest point. `hint`, when given, chooses the branch: parameters come within half a period of it and, for
  /// free-form surfaces, the search starts there. Exact for analytic forms.
  SurfaceProjection project(Vec3 p, const Vec2* hint = nullptr) const;
  /// Contains the piece; tight for analytic forms.
  Box3 bounds(const Range2& piece) const;

  /// All meetings of the line with the whole surface, by growing t; a touch counts once, a line that lies in the
  /// surface gives none. Closed forms for analytic forms (`near` is not looked at); for free-form ones those with
  /// parameters in `near`, moved there by whole periods: every transversal one by subdivision with a certificate,
  /// touches to 1e-13 of the size. `near` must be finite where the surface's own domain is not.
  std::vector<LineHit> intersect(const Line& line, const Range2& near) const;

  /// As Curve::transformed. `uv_scale` gets the factor by which u and v parameters of old points are multiplied. A
  /// mirror makes the frame left-handed: the natural normal is du x dv after as before.
  Result<Surface> transformed(const Transform& t, Vec2* uv_scale = nullptr) const;
  /// Exact NURBS form of the piece, which must be finite; see Curve::to_nurbs.
  NurbsSurfaceData to_nurbs(const Range2& piece) const;

 private:
  Form form_;
};

/// Are these the same infinite surface (plane, cylinder, ...) within `tolerance` over the piece of `a`? Says also
/// whether the natural normals agree. Free-form surfaces by sampling.
bool coincident(const Surface& a, const Range2& piece, const Surface& b, double tolerance, bool* same_normal = nullptr);

}  // namespace aresta
