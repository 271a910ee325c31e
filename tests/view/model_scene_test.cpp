// SPDX-License-Identifier: Apache-2.0
#include "view/model_scene.h"

#include <gtest/gtest.h>

#include <numbers>

#include "construct/primitives.h"
#include "draw/errors.h"

namespace aresta {
namespace {

const draw::EdgeLine& edge_of(const draw::Scene& scene, EdgeId e) {
  return scene.edges[e.index()];
}

TEST(ModelScene, CylinderWithColoursAndNames) {
  auto made = cylinder(2, 5);
  ASSERT_TRUE(made.ok()) << made.error().to_line();
  Model model = std::move(made).value();
  const RegionId region = model.regions().front();
  model.labels.set_name(region, "rod");
  model.labels.attributes[region]["color"] = std::string("#102030");
  model.labels.attributes[FaceId(std::size_t{1})]["color"] = std::string("#A0b0C0");
  auto scene = make_scene(model);
  ASSERT_TRUE(scene.ok()) << scene.error().to_line();
  ASSERT_EQ(scene->regions.size(), 1u);
  EXPECT_EQ(scene->regions[0].name, "rod");
  EXPECT_NEAR(scene->regions[0].volume, 20 * std::numbers::pi, 1e-6);
  ASSERT_EQ(scene->faces.size(), 3u);
  EXPECT_EQ(scene->faces[0].color, (draw::Color{0x10, 0x20, 0x30, 255}));
  EXPECT_EQ(scene->faces[1].color, (draw::Color{0xa0, 0xb0, 0xc0, 255}));
  EXPECT_EQ(scene->faces[2].color, (draw::Color{0x10, 0x20, 0x30, 255}));
  // The seam is smooth, the two circles are not.
  int smooth = 0;
  for (const EdgeId e : model.topology().edges()) {
    const bool seam = !model.topology().is_closed(e);
    EXPECT_EQ(edge_of(*scene, e).smooth, seam);
    smooth += edge_of(*scene, e).smooth;
  }
  EXPECT_EQ(smooth, 1);
  for (const auto& patch : scene->faces) {
    EXPECT_EQ(patch.regions[1], region);
    EXPECT_FALSE(patch.regions[0].valid());
  }
}

TEST(ModelScene, AColourThatCannotBeReadIsAnError) {
  for (const EntityRef entity : {EntityRef(FaceId(std::size_t{2})), EntityRef(EdgeId(std::size_t{1}))}) {
    for (const AttributeValue& color : {AttributeValue(std::string("no colour")), AttributeValue(3.0)}) {
      auto model = block(1, 2, 3);
      ASSERT_TRUE(model.ok());
      model->labels.attributes[entity]["color"] = color;
      const auto scene = make_scene(*model);
      ASSERT_FALSE(scene.ok());
      EXPECT_EQ(scene.error().code, errors::draw_bad_color);
      EXPECT_EQ(scene.error().entities, std::vector<EntityRef>{entity});
    }
  }
}

TEST(ModelScene, EdgesHaveTheirColoursUnlessTooPale) {
  auto made = block(1, 2, 3);
  ASSERT_TRUE(made.ok());
  const EdgeId green(std::size_t{3}), white(std::size_t{4});
  made->labels.attributes[green]["color"] = std::string("#208040");
  made->labels.attributes[white]["color"] = std::string("#fffff0");
  auto scene = make_scene(*made);
  ASSERT_TRUE(scene.ok()) << scene.error().to_line();
  EXPECT_EQ(edge_of(*scene, green).color, (draw::Color{0x20, 0x80, 0x40, 255}));
  EXPECT_EQ(edge_of(*scene, white).color, draw::EdgeLine{}.color);
}

TEST(ModelScene, BoxHasNoSmoothEdge) {
  auto made = block(1, 2, 3);
  ASSERT_TRUE(made.ok());
  auto scene = make_scene(*made);
  ASSERT_TRUE(scene.ok()) << scene.error().to_line();
  EXPECT_EQ(scene->faces.size(), 6u);
  EXPECT_EQ(scene->edges.size(), 12u);
  for (const auto& edge : scene->edges) {
    EXPECT_FALSE(edge.smooth);
    EXPECT_EQ(edge.faces.size(), 2u);
  }
  EXPECT_NEAR(scene->regions[0].volume, 6, 1e-12);
}

}  // namespace
}  // namespace aresta
