// SPDX-License-Identifier: Apache-2.0
// The kernel library's general fuse of any mix of faces, wires and points, with its history in terms of our entities.
//
// Contract
//   The result holds all pieces of the operands, each once: no two of its vertices, edges or faces coincide; entities
//   meet only in shared lower-dimensional entities. Edges and points lying in faces of other operands are inside those
//   faces (dangling and loose edges, point loops). No fills are set: regions are found by whoever builds the model.
//   Nothing is dropped and nothing is left unsaid: each warning of the library that can mean a damaged result is an
//   error, and so is an entity without an image, or a coincidence that is left.
// Parts of one operand that do not hang together are imprinted on each other too; parts that do are taken to be right.
// Not guaranteed: intersections that the library misses without saying so. Its least tolerance is 1e-7 of a unit.
// Serial and deterministic. Cost: candidates by bounding volumes, then per pair of faces.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/context.h"
#include "model/builder.h"
#include "occt/shape.h"

namespace aresta {

struct FuseParent {
  std::uint32_t operand = 0;
  EntityRef entity;
  bool opposite = false;  ///< of two faces: their normals point to opposite sides
  constexpr auto operator<=>(const FuseParent&) const = default;
};

/// Per entity of the result, for every operand that contains it: the entity of least dimension of that operand in which
/// it lies (several only where tolerance has merged them). So an edge where two faces cross has both faces, a vertex
/// where an edge pierces a face has the edge and the face, a piece of a face that two operands share has both faces.
struct FuseResult {
  ModelBuilder builder;  ///< all faces, edges and vertices; not built, no fills
  std::vector<std::vector<FuseParent>> vertices, edges, faces;
};

/// What is to be fused: the operands' entities in one model. An entity that several operands have (or that is known to
/// coincide as a whole) is there once, with a parent for each of them: it is not compared with itself. The model's
/// cells, fills and radial order are not looked at (ModelBuilder::provisional gives enough). A parent may be of higher
/// dimension than its entity, as in the result of a fuse, which can be fused again.
struct FuseInput {
  std::shared_ptr<const Model> model;
  std::size_t operands = 0;
  std::vector<std::vector<FuseParent>> vertices, edges, faces;  ///< per entity; sorted, never empty
};

/// The operands side by side, nothing known about them.
Result<FuseInput> side_by_side(std::span<const std::shared_ptr<const Model>> operands);

/// `tolerance`: points closer than this are one (the library's fuzzy value; at least 1e-7 works). Parents in the result
/// are those of the input.
/// Errors: general_fuse_failed with what the library said and the entities (operands counted from 1 in the message),
/// to_shape_failed, to_model_failed, cancelled.
Result<FuseResult> general_fuse(const FuseInput& input, double tolerance, const Context& context = {});

}  // namespace aresta
