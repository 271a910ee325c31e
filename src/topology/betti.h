// SPDX-License-Identifier: Apache-2.0
// Counts of a complex, its Betti numbers and the Euler-Poincare formula of its solids.
//
// Betti numbers are those of the union of vertices, edges and faces, a closed subset of space:
//   components  b0  connected parts
//   tunnels     b1  ways round that cannot be drawn together: a ring has one, a torus two
//   voids       b2  parts of space that are enclosed
// For open cells the Euler characteristic is V - E + the sum over faces of 2 - (loops of the face), as a face is a
// sphere less a disc or a point for each loop; so chi = V - E + 2 F - L, which holds for faces with holes, with loops
// that are vertices, and for a sphere with a single one. b0 is counted; b2 is the number of regions less one, by
// Alexander duality in space; b1 follows from chi = b0 - b1 + b2.
//
// Assumed: the complex passes the full check (check.h). Numbers of what has a place in space are the same over all
// fields. A closed sheet with one side, which has none, bounds nothing here: it is counted as over the rationals (a
// Klein bottle has one tunnel and no void). Filled or not makes no difference to a region.
//
// Linear, but for the inverse Ackermann function.
// After J. W. Alexander, 1922, for duality; M. Mantyla, "An introduction to solid modeling", 1988, for the formula.
#pragma once

#include <vector>

#include "topology/complex.h"

namespace aresta {

struct ComplexCounts {
  std::size_t vertices = 0, edges = 0, faces = 0, loops = 0, shells = 0;
  std::size_t regions = 0;         ///< the infinite one and empty ones included
  std::size_t filled_regions = 0;  ///< volumes of the model
  std::size_t isolated_vertices = 0;
  std::size_t wires = 0, laminas = 0, manifold_edges = 0, non_manifold_edges = 0;  ///< edges by their uses
  std::size_t components = 0, tunnels = 0, voids = 0;                              ///< Betti numbers

  long euler_characteristic() const {
    return static_cast<long>(vertices) - static_cast<long>(edges) + 2 * static_cast<long>(faces) -
           static_cast<long>(loops);
  }
};

ComplexCounts counts(const Complex& complex);

/// A closed surface that sides of faces make where they are connected through sectors: copies of the sides, sewn along
/// one edge for each sector, at one vertex for each fan and each loop that is a vertex. It is always orientable. A
/// sheet's surface goes round it: that of a triangle is a sphere, that of a Klein bottle a torus.
struct SideSurface {
  FaceUse first;  ///< its smallest side
  ShellId shell;
  std::size_t sides = 0, loops = 0, sectors = 0;
  std::size_t corners = 0;  ///< fans, and loops that are vertices

  long euler_characteristic() const {
    return static_cast<long>(corners) - static_cast<long>(sectors) + 2 * static_cast<long>(sides) -
           static_cast<long>(loops);
  }
  std::size_t genus() const { return static_cast<std::size_t>((2 - euler_characteristic()) / 2); }
};

/// All of them, by their smallest side.
std::vector<SideSurface> side_surfaces_of(const Complex& complex);

/// The Euler-Poincare formula V - E + F - (L - F) - 2 (S - G) = 0 of a region whose boundary is manifold: every face
/// has one side in the region, every edge one sector, every vertex one fan or one loop, and there are no wires nor
/// isolated vertices. G, the genus of all shells together, is counted on their surfaces and not taken from the formula.
struct EulerPoincare {
  RegionId region;
  long vertices = 0, edges = 0, faces = 0, loops = 0, shells = 0, genus = 0;

  long residual() const { return vertices - edges + faces - (loops - faces) - 2 * (shells - genus); }
};

/// For each region with a manifold boundary, in order. The infinite one is among them where it has a shell.
std::vector<EulerPoincare> euler_poincare(const Complex& complex);

}  // namespace aresta
