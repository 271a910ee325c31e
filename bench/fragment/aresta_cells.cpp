// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "construct/move.h"
#include "construct/primitives.h"
#include "fragment/fragment.h"
#include "fragment/peers.h"
#include "model/measure.h"

namespace aresta::bench {

namespace {

template <class T>
T value(Result<T> result) {
  if (!result.ok()) throw std::runtime_error(result.error().to_line());
  return std::move(*result);
}

Model to_model(const Block& b) {
  Model model = value(block(2 * b.half.x, 2 * b.half.y, 2 * b.half.z, b.is_turned() ? -b.half : b.middle - b.half));
  return b.is_turned() ? value(transform(model, {b.rows(), b.middle})) : model;
}

}  // namespace

Answer cells_with_aresta(const std::vector<Block>& blocks) {
  std::vector<std::shared_ptr<const Model>> operands;
  for (const Block& b : blocks) operands.push_back(std::make_shared<const Model>(to_model(b)));
  Answer answer;
  const Fragment result = timed(answer.seconds, [&] { return value(fragment(operands, {}, {})); });
  const Complex& k = result.model->topology();
  for (const RegionId r : k.regions()) {
    if (r == Complex::infinite_region()) continue;
    const double volume = value(measure(*result.model, r)).measure;
    ++answer.cells;
    answer.volume += volume;
    if (!result.labels.of(r).empty()) answer.solid_volume += volume;
  }
  return answer;
}

}  // namespace aresta::bench
