// SPDX-License-Identifier: Apache-2.0
#include "fragment/oracle/operand_model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace aresta::grid {

Vec3 Placement::point(const Steps& p) const {
  std::array<double, 3> result{};
  for (std::size_t row = 0; row < 3; ++row)
    result[row] = matrix_[row][0] * p[0] + matrix_[row][1] * p[1] + matrix_[row][2] * p[2];
  return {result[0], result[1], result[2]};
}

Vec3 Placement::direction(int axis) const {
  const auto a = static_cast<std::size_t>(axis);
  return Vec3{double(matrix_[0][a]), double(matrix_[1][a]), double(matrix_[2][a])} / scale_;
}

std::optional<Steps> Placement::steps(Vec3 p) const {
  Steps result{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double c = (matrix_[0][a] * p.x + matrix_[1][a] * p.y + matrix_[2][a] * p.z) / (double(scale_) * scale_);
    const double nearest = std::round(c);
    if (!(std::abs(c) < 1e6) || std::abs(c - nearest) > 1e-6) return std::nullopt;
    result[a] = static_cast<int>(nearest);
  }
  return result;
}

std::vector<RadialUse> radial_uses(const GridComplex& complex, EdgeId e) {
  const Lattice& g = complex.lattice();
  const Piece p = complex.pieces(e).front();
  std::vector<RadialUse> result;
  for (int q = 0; q < 4; ++q) {
    const Direction d = around(g.axis(p), q);
    const Piece square = g.next(p, d.axis, d.up);
    if (!complex.is_marked(square)) continue;
    // The face lies to the left, seen against the axis across it: along = inwards x across.
    const bool cyclic = (d.axis + 1) % 3 == g.axis(square);
    result.push_back({FaceId(complex.carrier(square).index), cyclic == d.up});
  }
  return result;
}

namespace {

class ModelMaker {
 public:
  ModelMaker(const GridOperand& operand, const Turn& turn)
      : operand_(operand), grid_(operand.complex), lattice_(grid_.lattice()), placement_(turn) {}

  Result<Model> run() {
    for (std::size_t v = 0; v < grid_.count(EntityKind::vertex); ++v)
      builder_.add_vertex(placement_.point(lattice_.low(grid_.pieces(VertexId(v)).front())));
    for (std::size_t e = 0; e < grid_.count(EntityKind::edge); ++e) {
      const auto [low, high] = grid_.ends(EdgeId(e));
      const bool down = runs_down(EdgeId(e));
      builder_.add_edge(VertexId(down ? high : low), VertexId(down ? low : high));
    }
    for (std::size_t f = 0; f < grid_.count(EntityKind::face); ++f) add_face(FaceId(f));
    link_radially();
    return builder_.build(cells(), operand_.filled);
  }

 private:
  using Use = std::tuple<std::uint32_t, std::uint32_t, bool>;  // edge, face, up as in the grid's loop

  void add_face(FaceId f) {
    const int axis = grid_.axis(f);
    const bool down = runs_down(f);
    Frame frame{placement_.point(lattice_.low(grid_.pieces(f).front())), placement_.direction((axis + 1) % 3),
                placement_.direction((axis + 2) % 3), placement_.direction(axis)};
    builder_.begin_face(builder_.add_surface(Plane{frame}), down);
    for (const GridLoop& loop : grid_.loops(f)) {
      if (loop.passes.empty()) {
        builder_.add_point_loop(VertexId(grid_.carrier(loop.point).index));
        continue;
      }
      std::vector<Pass> passes;  // one for each edge, in the order of the face's own side
      for (const Pass& pass : loop.passes) {
        const EntityRef from = grid_.carrier(lattice_.next(pass.piece, lattice_.axis(pass.piece), !pass.up));
        if (from.kind == EntityKind::vertex) passes.push_back(pass);
      }
      if (down) std::reverse(passes.begin(), passes.end());
      for (const Pass& pass : passes) {
        const EntityRef edge = grid_.carrier(pass.piece);
        uses_[{edge.index, f.value, pass.up}] = coedges_++;
        builder_.add_coedge(EdgeId(edge.index), (pass.up == down) != runs_down(edge));
      }
      builder_.close_loop();
    }
    builder_.end_face();
  }

  void link_radially() {
    std::vector<std::uint32_t> next(coedges_);
    for (std::size_t e = 0; e < grid_.count(EntityKind::edge); ++e) {
      const auto uses = radial_uses(grid_, EdgeId(e));
      const auto coedge = [&](std::size_t i) {
        const RadialUse& use = uses[i % uses.size()];
        return uses_.at({static_cast<std::uint32_t>(e), use.face.value, use.up});
      };
      const bool down = runs_down(EdgeId(e));
      for (std::size_t i = 0; i < uses.size(); ++i) next[coedge(down ? i + 1 : i)] = coedge(down ? i : i + 1);
    }
    builder_.set_radial_order(std::move(next));
  }

  std::uint32_t cell_at(Piece p) const {
    while (lattice_.dimension(p) < 3) {
      for (int a = 0; a < 3; ++a) {
        if (!lattice_.spans(p, a)) p = lattice_.next(p, a, true);
      }
    }
    return grid_.carrier(p).index;
  }

  Cells cells() const {
    Cells cells;
    cells.count = static_cast<std::uint32_t>(grid_.count(EntityKind::region));
    for (std::size_t f = 0; f < grid_.count(EntityKind::face); ++f) {
      const Piece square = grid_.pieces(FaceId(f)).front();
      const bool down = runs_down(FaceId(f));
      for (const bool front : {true, false})
        cells.of_face_use.push_back(grid_.carrier(lattice_.next(square, lattice_.axis(square), front != down)).index);
    }
    for (std::size_t e = 0; e < grid_.count(EntityKind::edge); ++e)
      cells.of_edge.push_back(grid_.is_wire(EdgeId(e)) ? cell_at(grid_.pieces(EdgeId(e)).front()) : Incidence::none);
    for (std::size_t v = 0; v < grid_.count(EntityKind::vertex); ++v) {
      const VertexId id(v);
      const bool isolated = grid_.is_without_edges(id) && !grid_.face_around(id).valid();
      cells.of_vertex.push_back(isolated ? cell_at(grid_.pieces(id).front()) : Incidence::none);
    }
    return cells;
  }

  const GridOperand& operand_;
  const GridComplex& grid_;
  const Lattice& lattice_;
  Placement placement_;
  ModelBuilder builder_;
  std::map<Use, std::uint32_t> uses_;
  std::uint32_t coedges_ = 0;
};

}  // namespace

Result<Model> to_model(const GridOperand& operand, const Turn& turn) {
  return ModelMaker(operand, turn).run();
}

}  // namespace aresta::grid
