// SPDX-License-Identifier: Apache-2.0
// The triangles that triangle formats get: the outside of a model.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "exchange/exchange.h"

namespace aresta {

struct Skin {
  std::vector<Vec3> points;                             ///< each once
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counterclockwise seen from outside
  std::vector<std::pair<std::uint32_t, FaceId>> faces;  ///< from triangle `first` on, triangles are of face `second`
};

/// Faces between a region and empty space look out of the region; faces between two regions are left out, so that the
/// skin bounds the union; sheets are taken as they are. Error export_failed when there is no face; those of tessellate.
Result<Skin> make_skin(const Model& model, const ExportOptions& options, const Context& context);

}  // namespace aresta
