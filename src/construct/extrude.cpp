// SPDX-License-Identifier: Apache-2.0
#include "construct/arguments.h"
#include "construct/drafts.h"
#include "construct/sweep.h"
#include "construct/sweep_core.h"
#include "geometry/swept.h"

namespace aresta {

namespace {

class Translation : public SweepMotion {
 public:
  Translation(Vec3 vector, double tolerance)
      : vector_(vector), direction_(normalized(vector)), length_(norm(vector)), tolerance_(tolerance) {}

  std::string name() const override { return "extrude"; }
  Vec3 velocity(Vec3) const override { return direction_; }
  bool is_fixed(Vec3) const override { return false; }
  SweptPath path(Vec3) const override { return {}; }
  Transform end() const override { return Transform::translation(vector_); }
  bool is_closed() const override { return false; }

  Result<SweptSurface> surface(const Model& profile, EdgeId e) const override {
    const Range range = profile.range(e);
    if (profile.is_straight(e)) {
      const CurveJet jet = profile.edge_jet(e, range.low);
      const Vec3 normal = cross(jet.d1, direction_);
      if (norm(normal) * range.length() <= tolerance_ || norm(normal) * length_ <= tolerance_) {
        return Error{errors::bad_profile, "extrude: an edge of the profile is parallel to the vector", {e}};
      }
      return SweptSurface{Plane{Frame::along(jet.point, normal, jet.d1)}};
    }
    const Curve curve = profile.curve(e);
    const auto image = [](double u0, double v0, double du, double dv) { return straight_image(u0, v0, du, dv); };
    if (const Circle* c = curve.get_if<Circle>()) {
      const double along = dot(c->frame.z, direction_);
      if (norm(cross(c->frame.z, direction_)) * (length_ + c->radius) <= 0.1 * tolerance_) {
        const double up = along > 0 ? 1 : -1;
        return SweptSurface{Cylinder{c->frame, c->radius}, image(0, 0, 1, 0), image(0, up * length_, 1, 0),
                            image(range.low, 0, 0, up), image(range.high, 0, 0, up)};
      }
    }
    ARESTA_TRY(Surface swept, extrusion_surface(curve, direction_));
    return SweptSurface{std::move(swept), image(0, 0, 1, 0), image(0, length_, 1, 0), image(range.low, 0, 0, 1),
                        image(range.high, 0, 0, 1)};
  }

  Status check_face(const Model&, FaceId f, Vec3 normal) const override {
    if (std::abs(dot(normal, vector_)) > tolerance_) return {};
    return Error{
        errors::bad_profile, "extrude: the vector " + number_text(vector_) + " lies in the plane of a face", {f}};
  }

 private:
  Vec3 vector_, direction_;
  double length_, tolerance_;
};

}  // namespace

Result<Model> extrude(const std::shared_ptr<const Model>& profile, Vec3 vector, const ConstructOptions& options,
                      const Context& context) {
  Arguments arguments("extrude");
  arguments.direction("vector", vector);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  Box3 box = profile->bounds();
  if (!box.empty()) {
    const Box3 moved{box.low + vector, box.high + vector};
    box.add(moved);
  }
  const double tolerance = std::max(working_tolerance(box, options), profile->tolerance());
  arguments.resolvable("the length of the vector", norm(vector), tolerance);
  ARESTA_CHECK(arguments.status());
  const double asked = std::max({options.tolerance, profile->tolerance(), rounding_tolerance(box)});
  return sweep(profile, Translation(vector, tolerance), asked, options.names, context);
}

}  // namespace aresta
