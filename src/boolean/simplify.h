// SPDX-License-Identifier: Apache-2.0
// Clean-up: neighbouring faces on one surface become one face, neighbouring edges on one curve one edge.
//
// Contract. The point set does not change. An edge goes when exactly two faces meet there, on the same surface, looking
// the same way, with the same cells on both sides and equal labels and constraint marks, and it carries no label
// itself; on a periodic surface the last edge around the period stays, as a seam. A vertex goes when exactly two edges
// on one curve meet there and it carries no label. Nothing that is loose, dangling, isolated or non-manifold is
// touched. Surfaces: planes by geometry; curved ones only when they are the same object or equal in all parameters.
// Linear apart from sorting.
#pragma once

#include "model/extract.h"

namespace aresta {

Result<Extraction> simplify(const Model& model);

}  // namespace aresta
