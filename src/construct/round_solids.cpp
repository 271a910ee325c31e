// SPDX-License-Identifier: Apache-2.0
// Solids of revolution as rings (circles about the axis, or points on it) joined by discs and bands.
#include <numbers>

#include "construct/arguments.h"
#include "construct/drafts.h"
#include "construct/primitives.h"
#include "construct/turn.h"

namespace aresta {

namespace {

constexpr double pi = std::numbers::pi;

/// A circle about the axis, cut at every seam; or one point on the axis.
struct Ring {
  double radius = 0, height = 0;
  std::vector<VertexId> vertices;  ///< one per seam, or one
  std::vector<EdgeId> arcs;        ///< from vertex k to vertex k + 1; none on the axis
  bool on_axis() const { return radius == 0; }
  VertexId at(std::size_t k) const { return vertices[on_axis() ? 0 : k % vertices.size()]; }
};

/// The curves that join two rings at every seam, with the parameter v that they reach on the band's surface.
struct Meridians {
  std::vector<EdgeId> edges;
  double v_offset = 0;  ///< v on the surface is v_offset + the edge's parameter
};

class RoundSolid {
 public:
  RoundSolid(const Placement& placement, const Patches& patches, const ConstructOptions& options)
      : frame_(turned(Frame::along(placement.at, placement.axis), patches.seam)),
        count_(static_cast<std::size_t>(patches.count)),
        names_(options.names) {
    builder_.length_unit = options.length_unit;
    builder_.tolerance = options.tolerance;
  }

  const Frame& frame() const { return frame_; }

  /// The frame in the half-plane through seam k: x away from the axis, y along it.
  Frame half_plane(std::size_t k, Vec3 origin) const {
    const Vec3 x = radial(k);
    return {origin, x, frame_.z, cross(x, frame_.z)};
  }

  Ring add_ring(double radius, double height) {
    Ring ring{radius, height, {}, {}};
    const Vec3 centre = frame_.to_world({0, 0, height});
    if (radius == 0) {
      ring.vertices.push_back(add_vertex(centre));
      return ring;
    }
    for (std::size_t k = 0; k < count_; ++k) ring.vertices.push_back(add_vertex(centre + radius * radial(k)));
    Frame at_height = frame_;
    at_height.origin = centre;
    const CurveId circle = builder_.add_curve(Circle{at_height, radius});
    for (std::size_t k = 0; k < count_; ++k) {
      ring.arcs.push_back(add_edge(ring.at(k), ring.at(k + 1), circle, {angle(k), angle(k + 1)}));
    }
    return ring;
  }

  /// Straight meridians from a to b.
  Meridians add_slants(const Ring& a, const Ring& b) {
    Meridians meridians;
    for (std::size_t k = 0; k < count_; ++k) {
      meridians.edges.push_back(builder_.add_edge(a.at(k), b.at(k)));
      ++edges_;
    }
    return meridians;
  }

  /// Arcs in the half-planes about points `centre_radius` away from the axis; parameters as the surface's v.
  Meridians add_arcs(const Ring& a, const Ring& b, double centre_radius, double radius, Range range) {
    Meridians meridians;
    for (std::size_t k = 0; k < count_; ++k) {
      const Vec3 centre = frame_.origin + centre_radius * radial(k);
      const CurveId circle = builder_.add_curve(Circle{half_plane(k, centre), radius});
      meridians.edges.push_back(add_edge(a.at(k), b.at(k), circle, range));
    }
    return meridians;
  }

  /// The side between ring a, at v = va of the surface, and ring b at vb > va.
  void add_band(const Ring& a, double va, const Ring& b, double vb, const Meridians& meridians, Surface surface) {
    const SurfaceId id = builder_.add_surface(std::move(surface));
    for (std::size_t k = 0; k < count_; ++k) {
      FaceDraft face{.surface = id, .loops = {{}}};
      auto& loop = face.loops[0].coedges;
      if (!a.on_axis()) loop.push_back({a.arcs[k], false, straight_image(0, va, 1, 0)});
      loop.push_back(
          {meridians.edges[(k + 1) % count_], false, straight_image(angle(k + 1), meridians.v_offset, 0, 1)});
      if (!b.on_axis()) loop.push_back({b.arcs[k], true, straight_image(0, vb, 1, 0)});
      loop.push_back({meridians.edges[k], true, straight_image(angle(k), meridians.v_offset, 0, 1)});
      add(face, "side");
    }
  }

  /// The flat end inside a ring; `up` when it looks along the axis. Nothing for a ring on the axis.
  void add_disc(const Ring& ring, bool up) {
    if (ring.on_axis()) return;
    Frame plane = frame_;
    plane.origin = frame_.to_world({0, 0, ring.height});
    if (!up) plane = {plane.origin, plane.x, -plane.y, -plane.z};
    FaceDraft face{.surface = builder_.add_surface(Plane{plane}), .loops = {{}}};
    for (std::size_t k = 0; k < count_; ++k) {
      face.loops[0].coedges.push_back({ring.arcs[up ? k : count_ - 1 - k], !up});
    }
    add(face, up ? "top" : "bottom");
  }

  Result<Model> build() {
    builder_.tolerance = std::max(builder_.tolerance, rounding_tolerance(box_));
    return builder_.build(one_solid(builder_.face_count(), edges_, vertices_), {false, true});
  }

 private:
  double angle(std::size_t k) const { return 2 * pi * static_cast<double>(k) / static_cast<double>(count_); }
  Vec3 radial(std::size_t k) const {
    const auto [c, s] = part_of_turn(static_cast<long long>(k), static_cast<long long>(count_));
    return c * frame_.x + s * frame_.y;
  }
  VertexId add_vertex(Vec3 p) {
    box_.add(p);
    ++vertices_;
    return builder_.add_vertex(p);
  }
  EdgeId add_edge(VertexId a, VertexId b, CurveId curve, Range range) {
    ++edges_;
    return builder_.add_edge(a, b, curve, range);
  }
  void add(FaceDraft& face, const char* name) {
    face.front = Fill::empty;
    face.back = Fill::filled;
    const FaceId id = add_face(builder_, face);
    if (names_) builder_.labels.set_name(id, name);
  }

  ModelBuilder builder_;
  Frame frame_;
  std::size_t count_;
  bool names_;
  std::size_t edges_ = 0, vertices_ = 0;
  Box3 box_;
};

/// The tolerance of a shape that reaches `radius` from its axis between heights `low` and `high`.
double round_tolerance(const Placement& placement, double radius, double low, double high,
                       const ConstructOptions& options) {
  const Frame frame = Frame::along(placement.at, placement.axis);
  Box3 box;
  for (const double x : {-radius, radius}) {
    for (const double y : {-radius, radius}) {
      for (const double z : {low, high}) box.add(frame.to_world({x, y, z}));
    }
  }
  return working_tolerance(box, options);
}

/// Shortest edge that cutting a circle of this radius leaves.
void check_arcs(Arguments& arguments, double radius, const Patches& patches, double tolerance) {
  const double arc = 2 * pi * radius / patches.count;
  arguments.require(arc > tolerance, "patches",
                    "fewer, so that each patch is wider than the tolerance " + number_text(tolerance),
                    std::to_string(patches.count));
}

Result<Model> frustum(double r1, double r2, double h, const Placement& placement, const Patches& patches,
                      const ConstructOptions& options) {
  RoundSolid solid(placement, patches, options);
  const Ring low = solid.add_ring(r1, 0), high = solid.add_ring(r2, h);
  const Meridians slants = solid.add_slants(low, high);
  solid.add_disc(low, false);
  if (r1 == r2) {
    solid.add_band(low, 0, high, h, slants, Cylinder{solid.frame(), r1});
  } else {
    const Cone cone{solid.frame(), r1, std::atan2(r2 - r1, h)};
    solid.add_band(low, 0, high, std::hypot(r2 - r1, h), slants, cone);
  }
  solid.add_disc(high, true);
  return solid.build();
}

}  // namespace

Result<Model> cylinder(double r, double h, const Placement& placement, const Patches& patches,
                       const ConstructOptions& options) {
  Arguments arguments("cylinder");
  arguments.length("r", r);
  arguments.length("h", h);
  arguments.placement(placement);
  arguments.patches(patches);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  const double tolerance = round_tolerance(placement, r, 0, h, options);
  arguments.resolvable("r", r, tolerance);
  arguments.resolvable("h", h, tolerance);
  check_arcs(arguments, r, patches, tolerance);
  ARESTA_CHECK(arguments.status());
  return frustum(r, r, h, placement, patches, options);
}

Result<Model> cone(double r1, double r2, double h, const Placement& placement, const Patches& patches,
                   const ConstructOptions& options) {
  Arguments arguments("cone");
  arguments.length_or_zero("r1", r1);
  arguments.length_or_zero("r2", r2);
  arguments.require(r1 > 0 || r2 > 0, "r1 or r2", "positive", "0 both");
  arguments.length("h", h);
  arguments.placement(placement);
  arguments.patches(patches);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  const double tolerance = round_tolerance(placement, std::max(r1, r2), 0, h, options);
  if (r1 != 0) arguments.resolvable("r1", r1, tolerance);
  if (r2 != 0) arguments.resolvable("r2", r2, tolerance);
  arguments.resolvable("h", h, tolerance);
  for (const double r : {r1, r2}) {
    if (r != 0) check_arcs(arguments, r, patches, tolerance);
  }
  ARESTA_CHECK(arguments.status());
  if (std::abs(r1 - r2) <= tolerance) r1 = r2 = 0.5 * (r1 + r2);
  return frustum(r1, r2, h, placement, patches, options);
}

Result<Model> sphere(double r, const Placement& placement, const Patches& patches, const ConstructOptions& options) {
  Arguments arguments("sphere");
  arguments.length("r", r);
  arguments.placement(placement);
  arguments.patches(patches);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  const double tolerance = round_tolerance(placement, r, -r, r, options);
  arguments.resolvable("r", r, tolerance);
  check_arcs(arguments, r, patches, tolerance);
  ARESTA_CHECK(arguments.status());
  RoundSolid solid(placement, patches, options);
  const Ring south = solid.add_ring(0, -r), north = solid.add_ring(0, r);
  const Meridians meridians = solid.add_arcs(south, north, 0, r, {-pi / 2, pi / 2});
  solid.add_band(south, -pi / 2, north, pi / 2, meridians, Sphere{solid.frame(), r});
  return solid.build();
}

Result<Model> torus(double major, double minor, const Placement& placement, const Patches& patches,
                    const ConstructOptions& options) {
  Arguments arguments("torus");
  arguments.length("R", major);
  arguments.length("r", minor);
  arguments.placement(placement);
  arguments.patches(patches);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  const double tolerance = round_tolerance(placement, major + minor, -minor, minor, options);
  arguments.resolvable("r", minor, tolerance);
  arguments.require(minor < major, "r", "smaller than R = " + number_text(major) + " (else the torus meets itself)",
                    number_text(minor));
  arguments.resolvable("R - r", major - minor, tolerance);
  check_arcs(arguments, major - minor, patches, tolerance);
  ARESTA_CHECK(arguments.status());
  RoundSolid solid(placement, patches, options);
  const Ring equator = solid.add_ring(major + minor, 0);
  const Meridians meridians = solid.add_arcs(equator, equator, major, minor, {0, 2 * pi});
  solid.add_band(equator, 0, equator, 2 * pi, meridians, Torus{solid.frame(), major, minor});
  return solid.build();
}

}  // namespace aresta
