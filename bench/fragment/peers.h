// SPDX-License-Identifier: Apache-2.0
// The same problems in Aresta and in other libraries, each in a source of its own so that headers do not meet. Operands
// are made, and results measured, outside of the time. What a library refuses is an exception.
#pragma once

#include <string>

#include "fragment/answer.h"
#include "fragment/blocks.h"
#include "fragment/chains.h"

namespace aresta::bench {

/// All cells: fragment(), with labels, conservation and voids.
Answer cells_with_aresta(const std::vector<Block>& blocks);

/// BOPAlgo_MakerVolume, which intersects its arguments and makes all bounded volumes, voids too.
Answer cells_with_occt(const std::vector<Block>& blocks);
std::string occt_version();

/// The boundaries of the blocks as Nef polyhedra, united two by two; exact constructions of the kernel
/// Exact_predicates_exact_constructions_kernel, which was faster here than Cartesian<Gmpq> and Homogeneous<Gmpz>.
Answer cells_with_nef(const std::vector<Block>& blocks);
std::string cgal_version();

// Chains of set operations, each step with the operation that the library has for several operands at once.

/// boolean(), regularised, all solids of a step in one group.
Answer chain_with_aresta(const Chain& chain);
/// The operands' triangles combined as meshes, without a complex.
Answer meshes_with_aresta(const Chain& chain);
/// BRepAlgoAPI_Cut and _Fuse.
Answer chain_with_occt(const Chain& chain);
/// The solids of a step as one Nef polyhedron.
Answer chain_with_nef(const Chain& chain);
/// Triangles, the solids of a step as one mesh: corefine_and_compute_difference and _union with
/// Exact_predicates_inexact_constructions_kernel.
Answer chain_with_corefinement(const Chain& chain);
/// Triangles, in WebAssembly under Node; warm.
Answer chain_with_manifold(const Chain& chain);
std::string manifold_version();

}  // namespace aresta::bench
