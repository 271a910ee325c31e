// SPDX-License-Identifier: Apache-2.0
// A model made of some of the vertices, edges and faces of another one: how selections over cells become models.
//
// Contract. Kept entities stay as they are; what bounds them must be kept too. Space is kept as it was: cells that were
// separated by a dropped face become one, and the new cell is filled when its parts are (parts that disagree are an
// error, never a guess). No geometry is asked: radial order, shells and nesting follow from the source. A face whose
// loose or dangling edges are dropped has its loops traced anew; a kept vertex left alone inside it becomes a loop of
// its own. Linear in the size of the source.
#pragma once

#include "model/builder.h"

namespace aresta {

struct Selection {
  std::vector<bool> vertices, edges, faces;  ///< per entity of the source: kept?
  std::vector<bool> filled;                  ///< per region (cell) of the source: part of the result's volume?
  std::vector<bool> constraint;              ///< per face: mark it as a constraint of the result
};

/// Entities of the source that become one in the result. Faces of a class lie on one surface, look the same way and
/// have the same cells on both sides; the edges between them are not kept. Edges of a chain lie on one curve.
struct Merging {
  struct Link {
    EdgeId edge;
    bool reversed = false;  ///< runs against the chain
  };
  std::vector<FaceId> face_class;         ///< per face: the smallest face of its class
  std::vector<Vec2> shift;                ///< per face: added to its parameters they continue those of the class
  std::vector<std::vector<Link>> chains;  ///< in order, along the curve's direction; at least two links each
  std::vector<std::uint32_t> chain_of;    ///< per edge: its chain, or Incidence::none
};

/// Where the entities of a result come from: for every entity of the result the one of the source; a region of the
/// result has several cells.
struct ExtractionMap {
  std::vector<VertexId> vertices;
  std::vector<EdgeId> edges;
  std::vector<FaceId> faces;
  std::vector<std::vector<RegionId>> regions;
};

struct Extraction {
  Model model;
  ExtractionMap from;
};

/// A selection that keeps nothing, sized for the model.
Selection empty_selection(const Model& model);
/// Adds everything that bounds what is kept: edges and vertices of kept faces (the loose and dangling ones inside them
/// only when `inner`), vertices of kept edges.
void close_downwards(const Model& model, Selection& selection, bool inner);

/// Is the edge loose or dangling inside face f (both its uses are in f and lie on top of each other), not a seam of f?
bool is_inner_edge(const Model& model, EdgeId edge, FaceId face);

/// Where a merged entity comes from ExtractionMap says by its smallest part.
/// The extracted model; labels and provenance are left empty for the caller, who knows what they mean.
/// Errors: bad_incidence (a kept entity's boundary is not kept), ambiguous_fill (a dropped face separates volume from
/// empty space).
Result<Extraction> extract(const Model& source, const Selection& selection, const Merging* merging = nullptr);

}  // namespace aresta
