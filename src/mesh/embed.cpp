// SPDX-License-Identifier: Apache-2.0
#include "mesh/embed.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/box.h"
#include "mesh/crossings.h"
#include "mesh/errors.h"

namespace aresta::mesh {

namespace {

using Corners = std::array<std::uint32_t, 3>;

constexpr int directions = 16;
constexpr double first_height = 0.6, least_height = 0.05;  // of a helper, over the side's length
constexpr double least_clearance = 0.3;                    // of a helper's own corners, over its height

/// Distance from p to the triangle. After C. Ericson, Real-Time Collision Detection, 2005, section 5.1.5: by regions.
double distance_to_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return norm(ap);
  const Vec3 bp = p - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return norm(bp);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return distance(p, a + d1 / (d1 - d3) * ab);
  const Vec3 cp = p - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return norm(cp);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return distance(p, a + d2 / (d2 - d6) * ac);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return distance(p, b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b));
  const double sum = va + vb + vc;
  return sum > 0 ? distance(p, a + vb / sum * ab + vc / sum * ac) : norm(ap);
}

class Embedder {
 public:
  explicit Embedder(const EmbedInput& input) : in_(input) {
    out_.points = input.points;
    Box3 all;
    for (const auto& t : input.surface) add_obstacle(t);
    // Sides of wires that have no helper yet keep helpers off too, as triangles without extent.
    for (const auto& s : input.sides) add_obstacle({s.a, s.b, s.b});
    for (const auto& p : input.points) all.add(p);
    tolerance_ = 1e-12 * all.diagonal();
  }

  Result<Helpers> run() {
    for (const auto& side : in_.sides) {
      if (!place_tooth(side)) return no_room(side.entity, 0.5 * (point(side.a) + point(side.b)));
    }
    for (const auto& p : in_.isolated) {
      if (!place_flag(p)) return no_room(p.entity, point(p.node));
    }
    return std::move(out_);
  }

 private:
  Vec3 point(std::uint32_t n) const { return out_.points[n]; }

  static Error no_room(EntityRef entity, Vec3 p) {
    return Error{errors::mesh_embedded_wire,
                 std::string("there is no room for tetrahedra around the ") +
                     (entity.kind == EntityKind::edge ? "wire" : "point") + " inside the region",
                 {entity},
                 {{p.x, p.y, p.z}},
                 "a smaller element size there, or fragment the model first if it lies on a face"};
  }

  void add_obstacle(const Corners& t) {
    Box3 box;
    for (const std::uint32_t n : t) box.add(point(n));
    obstacles_.push_back(t);
    boxes_.push_back(box);
  }

  void collect(const Box3& box) {
    near_.clear();
    for (std::size_t i = 0; i < obstacles_.size(); ++i) {
      if (boxes_[i].overlaps(box)) near_.push_back(obstacles_[i]);
    }
  }

  /// How far p is from what is near; obstacles with one of the nodes given are left out.
  double clearance(Vec3 p) const {
    double least = HUGE_VAL;
    for (const auto& t : near_) least = std::min(least, distance_to_triangle(p, point(t[0]), point(t[1]), point(t[2])));
    return least;
  }

  static bool degenerate(const Corners& t) { return t[1] == t[2]; }

  bool is_free(const Corners& helper) const {
    for (const auto& t : near_) {
      if (degenerate(t)) {
        if (segment_meets(t[0], t[1], helper)) return false;
      } else if (triangles_meet(out_.points, helper, t, tolerance_)) {
        return false;
      }
    }
    return true;
  }

  /// Does a wire's side come too near to the helper, other than at nodes that they share?
  bool segment_meets(std::uint32_t a, std::uint32_t b, const Corners& helper) const {
    const auto has = [&](std::uint32_t n) { return helper[0] == n || helper[1] == n || helper[2] == n; };
    if (has(a) && has(b)) return false;
    const double length = distance(point(a), point(b));
    for (int i = 0; i <= 8; ++i) {
      const double s = i / 8.0;
      const double shared = has(a) ? s : has(b) ? 1 - s : 1;
      if (shared == 0) continue;
      const double d =
          distance_to_triangle(lerp(point(a), point(b), s), point(helper[0]), point(helper[1]), point(helper[2]));
      if (d < 0.02 * shared * length) return true;
    }
    return false;
  }

  bool accept(const std::vector<Vec3>& own, Corners helper, std::uint32_t region, double height) {
    const auto first = static_cast<std::uint32_t>(out_.points.size());
    for (const Vec3& p : own) {
      if (clearance(p) < least_clearance * height) return false;
    }
    out_.points.insert(out_.points.end(), own.begin(), own.end());
    if (is_free(helper)) {
      out_.triangles.push_back({helper, 0xffffffffu, region, region});
      add_obstacle(helper);
      return true;
    }
    out_.points.resize(first);
    return false;
  }

  /// The triangle over a wire's side, in the roomiest direction.
  bool place_tooth(const EmbeddedSide& side) {
    const Vec3 a = point(side.a), b = point(side.b), axis = normalized(b - a), middle = 0.5 * (a + b);
    const double length = distance(a, b);
    Box3 box;
    box.add(a);
    box.add(b);
    collect(box.grown(1.5 * length));
    for (const auto& t : near_) {
      if (!degenerate(t) && segment_meets(side.a, side.b, t)) return false;
    }
    const Vec3 x = any_perpendicular(axis), y = cross(axis, x);
    const auto apex = static_cast<std::uint32_t>(out_.points.size());
    for (double height = first_height; height > least_height; height *= 0.5) {
      std::vector<std::pair<double, int>> order;
      const auto at = [&](int k) {
        const double angle = 2 * std::numbers::pi * k / directions;
        return middle + height * length * (std::cos(angle) * x + std::sin(angle) * y);
      };
      for (int k = 0; k < directions; ++k) order.emplace_back(-clearance(at(k)), k);
      std::sort(order.begin(), order.end());
      for (const auto& [room, k] : order) {
        if (accept({at(k)}, {side.a, side.b, apex}, side.region, height * length)) return true;
      }
    }
    return false;
  }

  /// A small triangle with the point as a corner.
  bool place_flag(const EmbeddedPoint& p) {
    const Vec3 centre = point(p.node);
    Box3 box;
    box.add(centre);
    collect(box.grown(2 * p.size));
    const double room = std::min(p.size, clearance(centre));
    const auto first = static_cast<std::uint32_t>(out_.points.size());
    static constexpr Vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (double side = 0.7 * room; side > 0.05 * room; side *= 0.5) {
      for (int k = 0; k < 6; ++k) {
        const Vec3 u = (k < 3 ? 1 : -1) * axes[k % 3], v = (k < 3 ? 1 : -1) * axes[(k + 1) % 3];
        const Vec3 q = centre + side * u, r = centre + side * (0.5 * u + std::sqrt(0.75) * v);
        if (accept({q, r}, {p.node, first, first + 1}, p.region, 0.5 * side)) return true;
      }
    }
    return false;
  }

  const EmbedInput& in_;
  Helpers out_;
  std::vector<Corners> obstacles_, near_;
  std::vector<Box3> boxes_;
  double tolerance_ = 0;
};

}  // namespace

Result<Helpers> embed(const EmbedInput& input) {
  return Embedder(input).run();
}

}  // namespace aresta::mesh
