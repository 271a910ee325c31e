// SPDX-License-Identifier: Apache-2.0
// What a volume mesher is given and gives back: closed surface meshes of regions, and tetrahedra.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/context.h"
#include "math/vec.h"

namespace aresta::mesh {

/// A triangle of a face's mesh and the regions on its sides. The front is the side its normal (counterclockwise) points
/// to. Region numbers count from 1; 0 is no region. Equal numbers on both sides: a sheet inside a region.
struct VolumeTriangle {
  std::array<std::uint32_t, 3> nodes{};
  std::uint32_t face = 0;  ///< for messages
  std::uint32_t front = 0, back = 0;
};

struct VolumeInput {
  std::vector<Vec3> points;  ///< each used by a triangle
  std::vector<VolumeTriangle> triangles;
  std::uint32_t region_count = 0;
  std::vector<double> region_sizes;  ///< largest element size per region, [region - 1]
  double grading = 0.3;              ///< growth of the size per unit of distance
  int optimisation_steps = 3;
};

struct Tetra {
  std::array<std::uint32_t, 4>
      nodes{};               ///< positive volume: the fourth lies on the side the first three's normal points to
  std::uint32_t region = 0;  ///< from 1
};

struct VolumeOutput {
  std::vector<Vec3> points;  ///< the input's points, unmoved and in their order, then new ones
  std::vector<Tetra> tetras;
};

/// Fills all regions with tetrahedra through the module that holds the mesher. The result is NOT checked here.
/// Errors: module.missing, mesh.volume_failed (with a region as entity where one is to blame), cancelled.
Result<VolumeOutput> fill_volumes(const VolumeInput& input, const Context& context);

/// Checks a volume mesh against its input: every input triangle is a face of exactly the tetrahedra its regions ask
/// for, every other triangle is shared by two tetrahedra of one region, all volumes are positive, and each region's
/// volume is what its boundary encloses to 1e-9. Error: mesh.check_failed.
Status check_volumes(const VolumeInput& input, const VolumeOutput& output);

}  // namespace aresta::mesh
