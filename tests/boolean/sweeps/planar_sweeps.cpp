// SPDX-License-Identifier: Apache-2.0
// Union, intersection and difference of blocks in degenerate positions, every coordinate moved by some ulps or by some
// tolerances; of a cube and its copy, turned or shifted by next to nothing; of walls that are next to nothing.
//
//   planar_sweeps COUNT SEED
//
// A result is wrong when the full checker is silent and the volume is not that of clipping, to ten tolerances around
// the surfaces; refused when the operation says that it cannot. Prints a line of figures for each family; the status is
// 1 when anything was wrong.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <random>
#include <string>

#include "boolean/boolean.h"
#include "boolean/sweeps/convex.h"
#include "math/transform.h"
#include "model/measure.h"
#include "planar/box.h"

using namespace aresta;
using namespace aresta::sweeps;

namespace {

using Corners = std::array<Vec3, 8>;
using ModelPtr = std::shared_ptr<const Model>;

Corners moved(const Corners& corners, const Transform& motion) {
  Corners result;
  for (std::size_t i = 0; i < 8; ++i) result[i] = motion.point(corners[i]);
  return result;
}

Result<Model> to_model(const Corners& corners) {
  ModelBuilder b;
  for (const Vec3 p : corners) b.add_vertex(p);
  std::map<std::pair<std::size_t, std::size_t>, EdgeId> edges;
  for (const auto& side : test::box_sides) {
    const Vec3 normal = normalized(cross(corners[side[2]] - corners[side[0]], corners[side[3]] - corners[side[1]]));
    b.begin_face(b.add_surface(Plane{Frame::along(corners[side[0]], normal)}), false);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t from = side[i], to = side[(i + 1) % 4];
      const auto [edge, fresh] = edges.try_emplace({std::min(from, to), std::max(from, to)});
      if (fresh) edge->second = b.add_edge(VertexId(std::min(from, to)), VertexId(std::max(from, to)));
      b.add_coedge(edge->second, from > to);
    }
    b.close_loop();
    b.end_face();
    b.set_fill(Fill::empty, Fill::filled);
  }
  return b.build({});
}

struct Tally {
  std::size_t cases = 0, wrong = 0, refused = 0;
  std::map<std::string, std::size_t> refusals;
};

const char* name_of(BooleanKind kind) {
  return kind == BooleanKind::unite ? "union" : kind == BooleanKind::intersect ? "intersection" : "difference";
}

void try_pair(const std::string& what, const Corners& a, const Corners& b, Tally& tally) {
  auto one = to_model(a), two = to_model(b);
  const Convex first = hexahedron(a), second = hexahedron(b);
  const Real va = volume(first), vb = volume(second), common = common_volume(first, second);
  for (const BooleanKind kind : {BooleanKind::unite, BooleanKind::intersect, BooleanKind::subtract}) {
    ++tally.cases;
    const auto refuse = [&](const Error& error) {
      ++tally.refused;
      if (++tally.refusals[error.code.name] == 1)
        std::printf("  first refusal: %s, %s: %s\n", what.c_str(), name_of(kind), error.to_line().c_str());
    };
    if (!one.ok() || !two.ok()) {
      refuse(one.ok() ? two.error() : one.error());
      continue;
    }
    const ModelPtr p = std::make_shared<const Model>(*one), q = std::make_shared<const Model>(*two);
    BooleanOptions options;
    options.kind = kind;
    options.check = CheckLevel::full;
    const auto result = boolean({p, q}, {whole_operand("A", 0, *p), whole_operand("B", 1, *q)}, options, {});
    if (!result.ok()) {
      refuse(result.error());
      continue;
    }
    const Real expected = kind == BooleanKind::unite       ? va + vb - common
                          : kind == BooleanKind::intersect ? common
                                                           : va - common;
    const Real allowed = 10 * result->report.tolerance * (area(first) + area(second)) + 1e-12L * (va + vb);
    const auto found = total_volume(result->model);
    if (found.ok() && std::abs(*found - expected) <= allowed) continue;
    ++tally.wrong;
    std::printf("  wrong: %s, %s: volume %.17g, by clipping %.17Lg\n", what.c_str(), name_of(kind),
                found.ok() ? *found : std::nan(""), expected);
  }
}

void print(const char* family, std::uint64_t seed, const Tally& tally, const std::string& coverage) {
  std::string why;
  for (const auto& [code, count] : tally.refusals) why += ", " + code + " " + std::to_string(count);
  std::printf("planar_sweeps %s: seed %llu, cases %zu, wrong %zu, refused %zu, skipped 0, coverage: %s%s\n", family,
              static_cast<unsigned long long>(seed), tally.cases, tally.wrong, tally.refused, coverage.c_str(),
              why.c_str());
}

/// Blocks that touch and overlap in every way, as a second block beside the cube [0, 2]^3.
const std::pair<Vec3, Vec3> positions[] = {
    {{0, 0, 0}, {2, 2, 2}},           // the same
    {{2, 0, 0}, {4, 2, 2}},           // a common face
    {{2, 1, 1}, {4, 3, 3}},           // part of a face
    {{2, 0.5, 0.5}, {4, 1.5, 1.5}},   // a face inside a face
    {{2, 2, 0}, {4, 4, 2}},           // a common edge
    {{2, 2, 2}, {4, 4, 4}},           // a common corner
    {{1, 0, 0}, {3, 2, 2}},           // four coplanar sides
    {{1, 1, 0}, {3, 3, 2}},           // two coplanar sides
    {{1, 1, 1}, {3, 3, 3}},           // corner in corner
    {{0, 0, 0}, {1, 1, 1}},           // inside, three coplanar sides
    {{0.5, 0.5, 0}, {1.5, 1.5, 2}},   // through, flush at both ends
    {{0.5, 0.5, -1}, {1.5, 1.5, 3}},  // through
    {{0, 0.5, 0.5}, {2, 1.5, 1.5}},   // through, flush
    {{0, 0, 1}, {2, 2, 3}},           // on top in part
    {{-1, 0, 0}, {3, 1, 1}},          // along an edge
};

double shifted(double x, int ulps) {
  const double to = ulps > 0 ? 1e300 : -1e300;
  for (int i = 0; i < std::abs(ulps); ++i) x = std::nextafter(x, to);
  return x;
}

void sweep_coordinates(const char* family, std::size_t count, std::uint64_t seed, bool ulps) {
  Tally tally;
  std::mt19937_64 random(seed);
  const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [low, high] = positions[i % std::size(positions)];
    Corners a = test::box_corners({0, 0, 0}, {2, 2, 2}), b = test::box_corners(low, high);
    const double tolerance = 1e-9 * norm(Vec3{2, 2, 2});
    const bool turned = i % 3 == 2;  // then no coordinate is a round one
    const Transform motion = turned ? Transform::rotation(below(360), {1.0 + below(5), 1.0 + below(5), 1.0 + below(5)})
                                    : Transform::translation({});
    a = moved(a, motion);
    b = moved(b, motion);
    if (ulps) {
      for (Corners* c : {&a, &b}) {
        for (Vec3& p : *c) {
          for (int k = 0; k < 3; ++k) p[k] = shifted(p[k], below(7) - 3);
        }
      }
    } else {
      // Whole sides move, so that faces stay plane: a block is moved by 0.1 to 10 tolerances along each axis.
      const auto step = [&] {
        const double size = tolerance * std::pow(10.0, -1 + 2 * (below(1000) / 999.0));
        return below(2) == 0 ? size : -size;
      };
      b = moved(b, Transform::translation({step(), step(), step()}));
    }
    try_pair("position " + std::to_string(i % std::size(positions)) + (turned ? " turned" : "") + ", case " +
                 std::to_string(i),
             a, b, tally);
  }
  print(family, seed, tally, std::to_string(std::size(positions)) + " positions, two in three along the axes");
}

void near_copies() {
  Tally turned, shifts, walls;
  const Corners cube = test::box_corners({0, 0, 0}, {1, 1, 1});
  for (int k = 1; k <= 15; ++k) {
    const double e = std::pow(10.0, -k);
    const std::string by = " by 1e-" + std::to_string(k);
    try_pair("turned" + by, cube, moved(cube, Transform::rotation(e * 57.29577951308232, {1, 2, 3})), turned);
    try_pair("turned in the middle" + by, cube,
             moved(cube, Transform::rotation(e * 57.29577951308232, {1, 2, 3}, {0.5, 0.5, 0.5})), turned);
    try_pair("shifted" + by, cube, moved(cube, Transform::translation(e * normalized(Vec3{1, 2, 3}))), shifts);
    try_pair("shifted along x" + by, cube, moved(cube, Transform::translation({e, 0, 0})), shifts);
    if (k <= 8) try_pair("a wall of" + by, cube, test::box_corners({0, 0, 0.5}, {1, 1, 0.5 + e}), walls);
    if (k <= 8) try_pair("all but a wall of" + by, cube, test::box_corners({0, 0, e}, {1, 1, 1}), walls);
  }
  print("turned copies", 0, turned, "1e-1 to 1e-15 rad about (1, 2, 3)");
  print("shifted copies", 0, shifts, "1e-1 to 1e-15");
  print("thin walls", 0, walls, "1e-1 to 1e-8");
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::fprintf(stderr, "usage: planar_sweeps COUNT SEED\n");
    return 2;
  }
  const auto cases = static_cast<std::size_t>(std::atoll(arguments[1]));
  const auto seed = static_cast<std::uint64_t>(std::atoll(arguments[2]));
  sweep_coordinates("ulps", cases, seed, true);
  sweep_coordinates("tolerances", cases, seed, false);
  near_copies();
  return 0;
}
