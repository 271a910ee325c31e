// SPDX-License-Identifier: Apache-2.0
// Our own primitives through the kernel library's shapes and back.
#include <gtest/gtest.h>
#include <BRepCheck_Analyzer.hxx>

#include <cmath>
#include <numbers>

#include "construct/primitives.h"
#include "model/measure.h"
#include "shapes.h"

namespace aresta::test {
namespace {

constexpr double pi = std::numbers::pi;

struct Primitive {
  const char* name;
  Result<Model> model;
  double volume;
};

std::vector<Primitive> primitives() {
  const Placement tilted{{1, 2, 3}, {1, 1, 1}};
  std::vector<Primitive> all;
  all.push_back({"block", block(1, 2, 3), 6});
  all.push_back({"wedge", wedge(4, 2, 3, 1, tilted), 15});
  all.push_back({"prism", prism(6, 2, 3, tilted), 6 * std::sqrt(3.0) * 3});
  all.push_back({"pyramid", pyramid(4, std::sqrt(2.0), 3, tilted), 4});
  for (const int patches : {1, 2, 3}) {
    const Patches split{patches, 25};
    all.push_back({"cylinder", cylinder(2, 5, tilted, split), 20 * pi});
    all.push_back({"cone", cone(2, 0, 3, tilted, split), 4 * pi});
    all.push_back({"cone on its apex", cone(0, 2, 3, tilted, split), 4 * pi});
    all.push_back({"truncated cone", cone(2, 1, 3, tilted, split), 7 * pi});
    all.push_back({"sphere", sphere(1.5, tilted, split), 4.5 * pi});
    all.push_back({"torus", torus(3, 1, tilted, split), 6 * pi * pi});
  }
  return all;
}

TEST(Primitives, ComeBackTheSame) {
  for (const Primitive& p : primitives()) {
    SCOPED_TRACE(p.name);
    ASSERT_TRUE(p.model.ok()) << text(p.model.error());
    auto shape = to_shape(*p.model);
    ASSERT_TRUE(shape.ok()) << text(shape.error());
    EXPECT_EQ(counts(shape->whole()), counts(*p.model));
    EXPECT_TRUE(BRepCheck_Analyzer(shape->whole().data().shape).IsValid());
    EXPECT_NEAR(*shape->whole().volume(), p.volume, 1e-9 * p.volume);
    auto back = to_model(shape->whole());
    ASSERT_TRUE(back.ok()) << text(back.error());
    EXPECT_EQ(counts(back->model), counts(*p.model));
    auto volume = total_volume(back->model);
    ASSERT_TRUE(volume.ok()) << text(volume.error());
    EXPECT_NEAR(*volume, p.volume, 1e-9 * p.volume);
    // Exact shapes have no deviation to speak of, and get none.
    for (const EdgeId e : back->model.topology().edges()) EXPECT_EQ(back->model.tolerance(e), 0);
    for (const VertexId v : back->model.topology().vertices()) EXPECT_EQ(back->model.tolerance(v), 0);
  }
}

}  // namespace
}  // namespace aresta::test
