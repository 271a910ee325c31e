// SPDX-License-Identifier: Apache-2.0
// Polygons as mesh files hold them, made into a model.
//
// Points with the same coordinates are one vertex; nothing else is moved or joined. Plane polygons become one face,
// others are cut into triangles. Polygons without area and repeated ones are left out, with a note. When the surface is
// closed (at each edge as many polygons run one way as the other) the space behind its faces is filled: solids with
// voids as their orientation says. When it is not closed, or does not bound solids, the model has sheets, and a note
// says why. Linear up to nesting.
#pragma once

#include <cstdint>
#include <vector>

#include "exchange/formats.h"

namespace aresta {

struct PolygonSoup {
  std::vector<Vec3> points;
  std::vector<std::uint32_t> corners;   ///< indices of points
  std::vector<std::uint32_t> begin{0};  ///< polygon i has corners[begin[i]] .. corners[begin[i + 1] - 1]
  std::vector<std::pair<std::uint32_t, std::string>>
      groups;  ///< from polygon `first` on, polygons are of group `second`

  std::size_t size() const { return begin.size() - 1; }
  void close_polygon() { begin.push_back(static_cast<std::uint32_t>(corners.size())); }
};

/// Errors: bad_content (a coordinate that is not finite, an index out of range), nothing_to_import, those of
/// ModelBuilder::build, cancelled.
Result<Model> import_soup(const PolygonSoup& soup, const ImportOptions& options, ImportReport& report,
                          const Context& context);

}  // namespace aresta
