// SPDX-License-Identifier: Apache-2.0
#include "fragment/conservation.h"

#include "model/measure.h"

namespace aresta {

namespace {

constexpr double conservation_relative = 1e-6;

double perimeter(const Model& model, FaceId f) {
  double sum = 0;
  for (const LoopId l : model.topology().loops(f)) {
    for (const CoedgeId c : model.topology().coedges(l)) {
      const EdgeId e = model.topology().edge(c);
      sum += model.curve(e).length(model.range(e), 1e-3);
    }
  }
  return sum;
}

}  // namespace

Status check_conservation(const Fragment& result, const Context& context) {
  const Model& model = *result.model;
  const Complex& k = model.topology();
  MeasureOptions coarse;
  coarse.relative = 1e-8;
  std::vector<double> area(k.face_count()), outflow(k.face_count());
  const Vec3 reference = model.bounds().centre();
  double scale = 0;
  for (const FaceId f : k.faces()) {
    if (f.index() % 256 == 0)
      ARESTA_CHECK(context.step(static_cast<double>(f.index()) / static_cast<double>(k.face_count()),
                                "checking areas and volumes"));
    ARESTA_TRY(const Moments a, measure(model, f, coarse));
    ARESTA_TRY(const Moments v, flux(model, f, reference, coarse));
    area[f.index()] = a.measure;
    outflow[f.index()] = v.measure;
    scale = std::max(scale, model.tolerance(f));
  }
  const double tolerance = std::max(scale, model.tolerance());
  std::vector<double> cell_volume(k.region_count(), 0), cell_surface(k.region_count(), 0);
  for (const FaceId f : k.faces()) {
    for (int side = 0; side < 2; ++side) {
      const std::size_t cell = k.region(FaceUse(f, side)).index();
      cell_volume[cell] += side == 0 ? -outflow[f.index()] : outflow[f.index()];
      cell_surface[cell] += area[f.index()];
    }
  }
  for (std::uint32_t o = 0; o < result.operands.size(); ++o) {
    const Model& operand = *result.operands[o];
    for (const FaceId g : operand.topology().faces()) {
      ARESTA_TRY(const Moments whole, measure(operand, g, coarse));
      double sum = 0;
      for (const std::uint32_t piece : result.pieces(o, g)) sum += area[piece];
      const double allowed = conservation_relative * whole.measure + 10 * tolerance * perimeter(operand, g);
      if (std::abs(sum - whole.measure) > allowed) {
        return Error{errors::not_conserved,
                     "the pieces of a face of operand " + std::to_string(o + 1) + " have area " + std::to_string(sum) +
                         ", the face has " + std::to_string(whole.measure),
                     {g},
                     {},
                     "a larger --tolerance, or cleaner input"};
      }
    }
    for (const RegionId r : operand.regions()) {
      ARESTA_TRY(const Moments whole, measure(operand, r, coarse));
      double volume = 0, surface = 0;
      for (const RegionId c : result.labels.cells_in({o, r})) {
        volume += cell_volume[c.index()];
        surface += cell_surface[c.index()];
      }
      const double allowed = conservation_relative * whole.measure + 10 * tolerance * surface;
      if (std::abs(volume - whole.measure) > allowed) {
        return Error{errors::not_conserved,
                     "the cells of a region of operand " + std::to_string(o + 1) + " have volume " +
                         std::to_string(volume) + ", the region has " + std::to_string(whole.measure),
                     {r},
                     {},
                     "a larger --tolerance, or cleaner input"};
      }
    }
  }
  return {};
}

}  // namespace aresta
