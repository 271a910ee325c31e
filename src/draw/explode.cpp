// SPDX-License-Identifier: Apache-2.0
#include "draw/explode.h"

#include <algorithm>
#include <array>
#include <set>

namespace aresta::draw {
namespace {

/// Centres nearer than this part of the smaller region's size are one: moved by the way between them, that region would
/// still be inside the other at any factor that a picture can show.
constexpr double one_centre = 0.05;
/// Part of its height that is left free around a region that goes up.
constexpr double gap = 0.05;

struct RegionBox {
  RegionId region;
  Box3 box;
};

/// Regions with one centre, the largest first.
struct Nest {
  Vec3 centre;
  double top;                                   ///< of what was moved up so far, above the centre
  std::vector<std::pair<Box3, double>> lifted;  ///< from where, by how much
};

/// Whether what goes up from `from` would run into what is at `there`.
bool is_above(const Box3& there, const Box3& from) {
  return there.low.x < from.high.x && from.low.x < there.high.x && there.low.y < from.high.y &&
         from.low.y < there.high.y && there.low.z >= from.centre().z;
}

std::vector<Vec3> moved(std::vector<Vec3> points, Vec3 by) {
  for (Vec3& p : points) p += by;
  return points;
}

}  // namespace

std::map<RegionId, Vec3> ways_apart(const Scene& scene) {
  std::map<RegionId, Box3> box_of;
  for (const FacePatch& f : scene.faces) {
    for (const RegionId r : f.regions) {
      if (!r.valid()) continue;
      for (const Vec3 p : f.points) box_of[r].add(p);
    }
  }
  std::vector<RegionBox> by_size;
  for (const auto& [region, box] : box_of) by_size.push_back({region, box});
  std::stable_sort(by_size.begin(), by_size.end(),
                   [](const RegionBox& a, const RegionBox& b) { return a.box.diagonal() > b.box.diagonal(); });

  const Vec3 centre = scene.bounds().centre();
  std::map<RegionId, Vec3> ways;
  std::multimap<double, Nest> nests;  // by the centre's x
  for (const auto& [region, box] : by_size) {
    const Vec3 own = box.centre();
    ways[region] = own - centre;
    const double near = one_centre * box.diagonal();
    auto nest = nests.lower_bound(own.x - near);
    while (nest != nests.end() && nest->first <= own.x + near && distance(nest->second.centre, own) > near) ++nest;
    const double room = (0.5 + gap) * (box.high.z - box.low.z);
    if (nest == nests.end() || nest->first > own.x + near) {
      nests.emplace(own.x, Nest{own, room, {}});
    } else {
      const double lift = nest->second.top + room;
      ways[region].z += lift;
      nest->second.lifted.emplace_back(box, lift);
      nest->second.top += 2 * room;
    }
  }
  for (const auto& [x, nest] : nests) {
    for (const auto& [region, box] : by_size) {
      double most = 0;
      for (const auto& [from, lift] : nest.lifted) {
        if (is_above(box, from)) most = std::max(most, lift);
      }
      ways[region].z += most;
    }
  }
  return ways;
}

Scene exploded(const Scene& scene, double factor) {
  if (factor == 0) return scene;
  const std::map<RegionId, Vec3> ways = ways_apart(scene);
  std::map<FaceId, std::array<RegionId, 2>> regions_of;
  for (const FacePatch& f : scene.faces) regions_of[f.face] = f.regions;
  const auto shift = [&](RegionId r) {
    const auto way = ways.find(r);
    return way == ways.end() ? Vec3{} : factor * way->second;
  };

  Scene result = scene;
  result.faces.clear();
  result.edges.clear();
  for (const FacePatch& f : scene.faces) {
    const auto [front, back] = f.regions;
    if (front == back || !front.valid() || !back.valid()) {
      result.faces.push_back(f);
      result.faces.back().points = moved(f.points, shift(front.valid() ? front : back));
      continue;
    }
    for (int side = 0; side < 2; ++side) {
      FacePatch copy = f;
      copy.regions[1 - side] = RegionId{};
      copy.points = moved(f.points, shift(f.regions[side]));
      result.faces.push_back(std::move(copy));
    }
  }
  for (const EdgeLine& e : scene.edges) {
    std::set<RegionId> regions;  // an invalid id stands for what stays in place
    for (const FaceId face : e.faces) {
      const auto found = regions_of.find(face);
      if (found == regions_of.end()) continue;
      const auto& sides = found->second;
      if (!sides[0].valid() && !sides[1].valid()) regions.insert(RegionId{});
      for (const RegionId r : sides) {
        if (r.valid()) regions.insert(r);
      }
    }
    if (regions.empty()) regions.insert(RegionId{});
    for (const RegionId r : regions) {
      result.edges.push_back(e);
      result.edges.back().points = moved(e.points, shift(r));
    }
  }
  return result;
}

}  // namespace aresta::draw
