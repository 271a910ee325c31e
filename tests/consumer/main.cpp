// SPDX-License-Identifier: Apache-2.0
// Two overlapping blocks make three regions: the two rests (8 - 1 each) and what they share (1).
#include <cmath>
#include <cstdio>
#include <memory>

#include "construct/primitives.h"
#include "fragment/fragment.h"
#include "model/measure.h"

int fail(const aresta::Error& error) {
  std::fprintf(stderr, "%s\n", error.to_line().c_str());
  return 1;
}

int main() {
  auto a = aresta::block(2, 2, 2);
  auto b = aresta::block(2, 2, 2, {1, 1, 1});
  if (!a.ok()) return fail(a.error());
  if (!b.ok()) return fail(b.error());
  const auto all = aresta::fragment(
      {std::make_shared<const aresta::Model>(std::move(*a)), std::make_shared<const aresta::Model>(std::move(*b))}, {},
      {});
  if (!all.ok()) return fail(all.error());
  const auto volume = aresta::total_volume(*all.value().model);
  if (!volume.ok()) return fail(volume.error());
  std::printf("volume %.17g\n", volume.value());
  return std::abs(volume.value() - 15) < 1e-9 ? 0 : 1;
}
