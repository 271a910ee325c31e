// SPDX-License-Identifier: Apache-2.0
// The cells of space that faces enclose: components of face sides, and which lies in which.
//
// Contract. Given a right radial order, sides of faces that share a sector about an edge bound the same cell; a
// component of such sides that encloses positive volume (divergence theorem) is the outer boundary of one cell. Every
// other component (negative volume: the outside of something, a void; zero: a sheet), every wire and every isolated
// vertex lies in the smallest cell that contains a point of it; decided per candidate cell by the nearest hit of one
// ray, which is cast again in another direction when a hit is doubtful. A cell that shares a face with the component is
// no candidate. Fails (nesting_failed) rather than guess. Cost: near n log n plus one ray per component that lies in
// some cell's box. Numbering: cells follow their smallest face-use. Method: Weiler 1986; compare Requicha and Voelcker
// 1985.
#pragma once

#include "base/context.h"
#include "model/builder.h"

namespace aresta {

/// `incidence` has its radial order; `model` the same loops, regions not looked at.
Result<Cells> find_cells(const Model& model, const Incidence& incidence, const Context& context);

}  // namespace aresta
