// SPDX-License-Identifier: Apache-2.0
// The order of plane faces around straight edges, and the cells of space that they enclose.
//
// Contract. order_radially puts the coedges of every edge in counterclockwise order about it, by the normals of the
// faces' planes; two faces in the same direction are refused (faces_coincide). find_cells needs that order: sides of
// faces that share a sector bound the same cell; a component of such sides that encloses positive volume opens a cell;
// every other component, wire and isolated vertex lies in the smallest cell around it, told by the first face of that
// cell's boundary on a ray; a ray that passes too near an edge is cast again elsewhere, and when none decides that is
// an error (nesting_undecided). Cells are numbered by their smallest face-use; cell 0 is infinite.
// Cost: linear, n log n when rays are needed. Method: Weiler 1986.
#pragma once

#include "base/context.h"
#include "planar/errors.h"
#include "planar/plane_faces.h"
#include "topology/cells.h"

namespace aresta::planar {

/// Fills in shape.radial_next. Errors: faces_coincide.
Status order_radially(const PlaneFaces& faces, Incidence& shape);

/// `faces.shape` has its radial order. Errors: nesting_undecided, cancelled.
Result<Cells> find_cells(const PlaneFaces& faces, const Context& context);

}  // namespace aresta::planar
