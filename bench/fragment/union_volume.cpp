// SPDX-License-Identifier: Apache-2.0
// The volume of a union of blocks by the divergence theorem: a third of the sum over all faces of the area that no
// other block covers, times the distance of the face's plane from the origin. Each face is a list of convex polygons,
// from which one block after the other takes away what it covers.
#include "fragment/blocks.h"

namespace aresta::bench {

namespace {

using Polygon = std::vector<Vec3>;

struct HalfSpace {
  Vec3 normal;
  double offset;  // inside: normal . p <= offset
};

struct Sides {
  std::array<HalfSpace, 6> half_spaces;
  std::array<Polygon, 6> faces;
};

Sides sides_of(const Block& block) {
  Sides sides;
  const auto rows = block.rows();
  const std::array<Vec3, 3> axes{
      {{rows[0].x, rows[1].x, rows[2].x}, {rows[0].y, rows[1].y, rows[2].y}, {rows[0].z, rows[1].z, rows[2].z}}};
  const std::array<double, 3> half{block.half.x, block.half.y, block.half.z};
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t a = i / 2, b = (a + 1) % 3, c = (a + 2) % 3;
    const Vec3 normal = i % 2 == 0 ? axes[a] : -1. * axes[a];
    const Vec3 middle = block.middle + half[a] * normal, u = half[b] * axes[b], v = half[c] * axes[c];
    sides.half_spaces[i] = {normal, dot(normal, middle)};
    sides.faces[i] = {middle + u + v, middle - u + v, middle - u - v, middle + u - v};
  }
  return sides;
}

/// Splits a convex polygon at a plane.
void split(const Polygon& polygon, const HalfSpace& plane, Polygon& inside, Polygon& outside) {
  inside.clear();
  outside.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
    const double at_p = dot(plane.normal, p) - plane.offset, at_q = dot(plane.normal, q) - plane.offset;
    (at_p <= 0 ? inside : outside).push_back(p);
    if ((at_p <= 0) == (at_q <= 0)) continue;
    const Vec3 crossing = p + at_p / (at_p - at_q) * (q - p);
    inside.push_back(crossing);
    outside.push_back(crossing);
  }
}

double area(const Polygon& polygon) {
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum = sum + cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return 0.5 * norm(sum);
}

std::vector<Polygon> without(const std::vector<Polygon>& polygons, const Sides& block) {
  std::vector<Polygon> rest;
  for (const Polygon& polygon : polygons) {
    Polygon piece = polygon, inside, outside;
    std::vector<Polygon> parts;
    for (const HalfSpace& plane : block.half_spaces) {
      split(piece, plane, inside, outside);
      if (outside.size() > 2) parts.push_back(outside);
      piece = inside;
      if (piece.size() < 3) break;
    }
    // Not covered at all: as it was, not in the parts into which the planes of the block have cut it.
    if (piece.size() < 3) parts = {polygon};
    rest.insert(rest.end(), parts.begin(), parts.end());
  }
  return rest;
}

}  // namespace

double volume_of_union(const std::vector<Block>& blocks) {
  std::vector<Sides> all;
  for (const Block& block : blocks) all.push_back(sides_of(block));
  double volume = 0;
  for (std::size_t b = 0; b < all.size(); ++b) {
    for (std::size_t i = 0; i < 6; ++i) {
      std::vector<Polygon> free{all[b].faces[i]};
      for (std::size_t other = 0; other < all.size(); ++other) {
        if (other != b) free = without(free, all[other]);
      }
      for (const Polygon& polygon : free) volume += area(polygon) * all[b].half_spaces[i].offset / 3;
    }
  }
  return volume;
}

}  // namespace aresta::bench
