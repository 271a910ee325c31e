// SPDX-License-Identifier: Apache-2.0
#include "fragment/oracle/contacts.h"

#include <algorithm>

namespace aresta::grid {

namespace {

using Counts = std::map<std::string, std::size_t>;

/// What two entities share: how many pieces, and the largest dimension of one.
struct Shared {
  std::size_t pieces = 0;
  int dimension = 0;
};

std::string kind_of(EntityRef a, EntityRef b, const Shared& shared, std::size_t pieces_a, std::size_t pieces_b) {
  const int da = static_cast<int>(a.kind), db = static_cast<int>(b.kind);
  const bool all_a = shared.pieces == pieces_a, all_b = shared.pieces == pieces_b;
  const std::string name_a = to_string(a.kind), name_b = to_string(b.kind);
  if (da == db) {
    const std::string both = name_a + "/" + name_b;
    if (shared.dimension < da) return both + " crossing";
    if (all_a && all_b) return both + " equal";
    return both + (all_a || all_b ? " part of the other" : " in part");
  }
  if (shared.dimension < da) return name_a + " pierces " + name_b;
  if (da == 0) return name_a + " in " + name_b;
  return name_a + " in " + name_b + (all_a ? "" : ", in part");
}

void count_pairs(const GridOperand& a, const GridOperand& b, Counts& counts) {
  const Lattice& g = a.complex.lattice();
  const auto counted = [](const GridOperand& o, EntityRef entity) {
    return entity.kind != EntityKind::region || o.filled[entity.index];
  };
  std::map<EntityRef, std::size_t> size_a, size_b;
  std::map<std::pair<EntityRef, EntityRef>, Shared> pairs;
  for (Piece p = 0; p < g.size(); ++p) {
    const EntityRef of_a = a.complex.carrier(p), of_b = b.complex.carrier(p);
    const bool in_a = counted(a, of_a), in_b = counted(b, of_b);
    if (in_a) ++size_a[of_a];
    if (in_b) ++size_b[of_b];
    if (!in_a || !in_b) continue;
    Shared& shared = pairs[{of_a, of_b}];
    ++shared.pieces;
    shared.dimension = std::max(shared.dimension, g.dimension(p));
  }
  for (const auto& [pair, shared] : pairs) {
    const auto [first, second] = pair;
    const bool swapped = second.kind < first.kind;
    const std::size_t pieces_a = size_a.at(first), pieces_b = size_b.at(second);
    ++counts[swapped ? kind_of(second, first, shared, pieces_b, pieces_a)
                     : kind_of(first, second, shared, pieces_a, pieces_b)];
  }
}

/// Faces that regions of two operands have in common, by the sides on which the regions are.
void count_walls(const Enumeration& e, Counts& counts) {
  const Lattice& g = e.whole.lattice();
  for (std::size_t f = 0; f < e.whole.count(EntityKind::face); ++f) {
    const Piece square = e.whole.pieces(FaceId(f)).front();
    int below = 0, above = 0;
    for (const GridOperand& operand : e.operands) {
      if (!operand.complex.is_marked(square)) continue;
      const bool b = operand.filled[operand.complex.carrier(g.next(square, g.axis(square), false)).index];
      const bool a = operand.filled[operand.complex.carrier(g.next(square, g.axis(square), true)).index];
      if (b != a) ++(b ? below : above);
    }
    if (below > 0 && above > 0) ++counts["walls back to back"];
    if (below > 1 || above > 1) ++counts["walls with regions on one side"];
  }
}

void count_situations(const Enumeration& e, Counts& counts) {
  const GridComplex& whole = e.whole;
  const Lattice& g = whole.lattice();
  for (std::size_t v = 0; v < whole.count(EntityKind::vertex); ++v) {
    const auto parents = e.parents(VertexId(v));
    const auto faces = std::count_if(parents.begin(), parents.end(),
                                     [](const Parent& p) { return p.entity.kind == EntityKind::face; });
    if (faces >= 3 && faces == static_cast<long>(parents.size())) ++counts["three faces in a point"];
  }
  for (std::size_t f = 0; f < whole.count(EntityKind::face); ++f) {
    const Piece square = whole.pieces(FaceId(f)).front();
    const EntityRef below = whole.carrier(g.next(square, g.axis(square), false));
    if (below == whole.carrier(g.next(square, g.axis(square), true)) && below.index != 0) ++counts["sheet in a cell"];
    std::size_t outlines = 0;
    bool dangles = false, has_point = false;
    for (const GridLoop& loop : whole.loops(FaceId(f))) {
      outlines += loop.area != 0 ? 1 : 0;
      has_point |= loop.passes.empty();
      auto passes = loop.passes;
      std::sort(passes.begin(), passes.end());
      dangles |= std::any_of(passes.begin(), passes.end(), [&](const Pass& pass) {
        return std::binary_search(passes.begin(), passes.end(), pass.reversed());
      });
    }
    if (outlines > 1) ++counts["face with a hole"];
    if (dangles) ++counts["face with an edge inside"];
    if (has_point) ++counts["face with a point inside"];
  }
  const auto shells = e.shells();
  for (std::size_t c = 1; c < shells.size(); ++c) {
    bool in_operand = false;
    for (std::size_t o = 0; o < e.operands.size(); ++o)
      in_operand |= e.operands[o].filled[e.region_of(o, RegionId(c)).index()];
    if (!in_operand) ++counts[e.filled[c] ? "cell closed by sheets" : "empty cell"];
    std::size_t outlines = 0;
    for (const auto& shell : shells[c]) {
      // A shell that is a sheet has both sides of all its faces.
      const bool both = std::all_of(shell.begin(), shell.end(), [&](const Enumeration::ShellPart& part) {
        return part.entity.kind != EntityKind::face ||
               std::binary_search(shell.begin(), shell.end(), Enumeration::ShellPart{part.entity, !part.up});
      });
      outlines += both ? 0 : 1;
      for (const auto& part : shell) {
        if (part.entity.kind == EntityKind::edge) ++counts["wire in a cell"];
        if (part.entity.kind == EntityKind::vertex) ++counts["point in a cell"];
      }
    }
    if (outlines > 1) ++counts["cell with a nested void"];
  }
}

void count_repetitions(const Recipe& recipe, Counts& counts) {
  for (auto a = recipe.operands.begin(); a != recipe.operands.end(); ++a) {
    for (auto b = recipe.operands.begin(); b != a; ++b) {
      if (*a == *b) ++counts["repeated operand"];
      for (const Shape& shape : *a)
        counts["repeated shape"] += static_cast<std::size_t>(std::count(b->begin(), b->end(), shape));
    }
  }
}

}  // namespace

const std::vector<std::string>& contact_kinds() {
  static const std::vector<std::string> kinds{
      "vertex/vertex equal",      "vertex in edge",        "vertex in face",
      "vertex in region",         "edge/edge equal",       "edge/edge part of the other",
      "edge/edge in part",        "edge/edge crossing",    "edge in face",
      "edge in face, in part",    "edge pierces face",     "edge in region",
      "edge in region, in part",  "face/face equal",       "face/face part of the other",
      "face/face in part",        "face/face crossing",    "face in region",
      "face in region, in part",  "region/region equal",   "region/region part of the other",
      "region/region in part",    "walls back to back",    "walls with regions on one side",
      "three faces in a point",   "face with a hole",      "face with an edge inside",
      "face with a point inside", "sheet in a cell",       "wire in a cell",
      "point in a cell",          "cell closed by sheets", "empty cell",
      "cell with a nested void",  "repeated operand",      "repeated shape"};
  return kinds;
}

void count_contacts(const Recipe& recipe, const Enumeration& e, std::map<std::string, std::size_t>& counts) {
  count_repetitions(recipe, counts);
  for (std::size_t a = 0; a < e.operands.size(); ++a) {
    for (std::size_t b = a + 1; b < e.operands.size(); ++b) count_pairs(e.operands[a], e.operands[b], counts);
  }
  count_walls(e, counts);
  count_situations(e, counts);
}

}  // namespace aresta::grid
