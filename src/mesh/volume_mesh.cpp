// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "base/module.h"
#include "mesh/errors.h"
#include "mesh/volume_input.h"

namespace aresta::mesh {

namespace {

using Triple = std::array<std::uint32_t, 3>;

/// Sorts the three and tells whether that was an even permutation.
bool sort_triple(Triple& t) {
  bool even = true;
  if (t[0] > t[1]) std::swap(t[0], t[1]), even = !even;
  if (t[1] > t[2]) std::swap(t[1], t[2]), even = !even;
  if (t[0] > t[1]) std::swap(t[0], t[1]), even = !even;
  return even;
}

/// One side of a triangle: whose region it bounds.
struct Side {
  Triple key;
  bool even;  ///< the region lies behind the sorted triple's normal
  std::uint32_t region;
  bool from_tetra;
  std::uint32_t source;  ///< index of the tetrahedron or of the input triangle

  bool operator<(const Side& other) const {
    return std::tie(key, even, region, from_tetra, source) <
           std::tie(other.key, other.even, other.region, other.from_tetra, other.source);
  }
};

double tetra_volume(const std::vector<Vec3>& p, const Tetra& t) {
  return dot(cross(p[t.nodes[1]] - p[t.nodes[0]], p[t.nodes[2]] - p[t.nodes[0]]), p[t.nodes[3]] - p[t.nodes[0]]) / 6;
}

std::array<double, 3> as_place(Vec3 p) {
  return {p.x, p.y, p.z};
}

Error failed(std::string message, std::vector<EntityRef> entities, Vec3 place) {
  return Error{errors::mesh_check_failed, std::move(message), std::move(entities), as_place(place)};
}

EntityRef region_ref(std::uint32_t number) {
  return EntityRef{EntityKind::region, number - 1};
}

Status check_region_volumes(const VolumeInput& input, const VolumeOutput& output) {
  // About a point of the mesh, not the origin: a model far away keeps its digits.
  const Vec3 centre = input.points.empty() ? Vec3{} : input.points[input.triangles.front().nodes[0]];
  std::vector<double> enclosed(input.region_count, 0), magnitude(input.region_count, 0), filled(input.region_count, 0);
  for (const auto& t : input.triangles) {
    const Vec3 a = input.points[t.nodes[0]] - centre, b = input.points[t.nodes[1]] - centre,
               c = input.points[t.nodes[2]] - centre;
    const double v = dot(cross(a, b), c) / 6;
    if (t.back != 0) enclosed[t.back - 1] += v, magnitude[t.back - 1] += std::abs(v);
    if (t.front != 0) enclosed[t.front - 1] -= v, magnitude[t.front - 1] += std::abs(v);
  }
  for (const auto& t : output.tetras) filled[t.region - 1] += tetra_volume(output.points, t);
  for (std::size_t r = 0; r < enclosed.size(); ++r) {
    if (enclosed[r] > 0 && std::abs(filled[r] - enclosed[r]) <= 1e-9 * enclosed[r] + 1e-13 * magnitude[r]) continue;
    return Error{errors::mesh_check_failed,
                 "the tetrahedra of the region fill " + std::to_string(filled[r]) + " but its boundary encloses " +
                     std::to_string(enclosed[r]),
                 {region_ref(static_cast<std::uint32_t>(r + 1))}};
  }
  return {};
}

}  // namespace

Result<VolumeOutput> fill_volumes(const VolumeInput& input, const Context& context) {
  using Function = void (*)(const VolumeInput*, const Context*, Result<VolumeOutput>*);
  ARESTA_TRY(void* symbol, module_function("netgen", "aresta_netgen_volumes"));
  Result<VolumeOutput> output = Error{errors::internal, "the volume mesher gave no answer"};
  reinterpret_cast<Function>(symbol)(&input, &context, &output);
  return output;
}

Status check_volumes(const VolumeInput& input, const VolumeOutput& output) {
  std::vector<Side> sides;
  sides.reserve(4 * output.tetras.size() + 2 * input.triangles.size());
  static constexpr int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};  // normals point out
  for (std::size_t i = 0; i < output.tetras.size(); ++i) {
    const auto& tetra = output.tetras[i];
    if (tetra.region == 0 || tetra.region > input.region_count) {
      return Error{errors::mesh_check_failed, "a tetrahedron belongs to no region"};
    }
    const double volume = tetra_volume(output.points, tetra);
    if (!(volume > 0)) {
      return failed("a tetrahedron has volume " + std::to_string(volume), {region_ref(tetra.region)},
                    output.points[tetra.nodes[0]]);
    }
    for (const auto& face : faces) {
      Triple key{tetra.nodes[face[0]], tetra.nodes[face[1]], tetra.nodes[face[2]]};
      const bool even = sort_triple(key);
      sides.push_back({key, even, tetra.region, true, static_cast<std::uint32_t>(i)});
    }
  }
  // A boundary triangle asks for a region behind it, and one before it: that one sees it the other way round. Turned
  // round, such a wanted side cancels against the tetrahedron's side.
  for (std::size_t i = 0; i < input.triangles.size(); ++i) {
    const auto& triangle = input.triangles[i];
    Triple key = triangle.nodes;
    const bool even = sort_triple(key);
    if (triangle.back != 0) sides.push_back({key, even, triangle.back, false, static_cast<std::uint32_t>(i)});
    if (triangle.front != 0) sides.push_back({key, !even, triangle.front, false, static_cast<std::uint32_t>(i)});
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i;
    int tetra_sides[2] = {0, 0}, wanted[2] = {0, 0};
    std::uint32_t tetra_region[2] = {0, 0}, wanted_region[2] = {0, 0};
    for (; end < sides.size() && sides[end].key == sides[i].key; ++end) {
      const auto& side = sides[end];
      (side.from_tetra ? tetra_sides : wanted)[side.even]++;
      (side.from_tetra ? tetra_region : wanted_region)[side.even] = side.region;
    }
    const bool on_boundary = wanted[0] + wanted[1] > 0;
    bool good = tetra_sides[0] <= 1 && tetra_sides[1] <= 1;
    if (on_boundary) {
      good = good && wanted[0] == tetra_sides[0] && wanted[1] == tetra_sides[1] &&
             wanted_region[0] == tetra_region[0] && wanted_region[1] == tetra_region[1];
    } else {
      good = good && tetra_sides[0] == 1 && tetra_sides[1] == 1 && tetra_region[0] == tetra_region[1];
    }
    if (!good) {
      std::vector<EntityRef> entities;
      for (std::size_t k = i; k < end; ++k) {
        const EntityRef ref = sides[k].from_tetra ? region_ref(sides[k].region)
                                                  : EntityRef{EntityKind::face, input.triangles[sides[k].source].face};
        if (std::find(entities.begin(), entities.end(), ref) == entities.end()) entities.push_back(ref);
      }
      std::sort(entities.begin(), entities.end());
      return failed(
          on_boundary ? "the volume mesh does not meet the surface mesh" : "the volume mesh has a gap or an overlap",
          entities, output.points[sides[i].key[0]]);
    }
    i = end;
  }
  return check_region_volumes(input, output);
}

}  // namespace aresta::mesh
