// SPDX-License-Identifier: Apache-2.0
// Regions moved apart, so that what lies between and inside them is seen.
#pragma once

#include <map>

#include "draw/scene.h"

namespace aresta::draw {

/// The way that each region goes at factor 1: from the scene's centre to the region's (middles of boxes), so that it
/// ends at twice its distance. Regions with one centre would stay in one another: of these the largest goes that way,
/// and the others go up (z) besides, in order of size, each clear of the one before it; what is above them goes up as
/// far.
std::map<RegionId, Vec3> ways_apart(const Scene& scene);

/// The scene with each region moved by `factor` times its way. A face between two regions, and its edges, are there
/// once for each. Faces without a region, wires and points stay.
Scene exploded(const Scene& scene, double factor);

}  // namespace aresta::draw
