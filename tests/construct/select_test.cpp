// SPDX-License-Identifier: Apache-2.0
#include "construct/select.h"

#include "audit.h"
#include "construct/primitives.h"
#include "construct/profiles.h"
#include "construct/sweep.h"
#include "model/measure.h"

namespace aresta {
namespace {

std::shared_ptr<const Model> shared(Result<Model> result) {
  return std::make_shared<const Model>(std::move(result).value());
}

TEST(Extract, FaceEdgeVertexAndRegionWithTheirBoundaries) {
  Model cube = *block(1, 2, 3, {}, {.names = true});
  cube.labels.groups.push_back({"ends", {FaceId(4), FaceId(5)}});
  cube.labels.groups.push_back({"sides", {FaceId(0)}});
  const auto source = std::make_shared<const Model>(cube);
  const auto face = extract_entities(source, std::vector<EntityRef>{FaceId(5)});
  ASSERT_BUILT(face);
  EXPECT_EQ(counts(*face), (Counts{4, 4, 1, 0}));
  EXPECT_EQ(face->labels.name(FaceId(0)), "top");
  ASSERT_EQ(face->labels.groups.size(), 1u);
  EXPECT_EQ(face->labels.groups[0].entities, std::vector<EntityRef>{FaceId(0)});
  EXPECT_EQ(face->provenance->of(FaceId(0))[0], (Parent{0, FaceId(5)}));
  EXPECT_NEAR(total_area(*face).value(), 2, 1e-15);
  EXPECT_EQ(counts(*extract_entities(source, std::vector<EntityRef>{EdgeId(3)})), (Counts{2, 1, 0, 0}));
  EXPECT_EQ(counts(*extract_entities(source, std::vector<EntityRef>{VertexId(3)})), (Counts{1, 0, 0, 0}));
  const auto whole = extract_entities(source, std::vector<EntityRef>{RegionId(1)});
  EXPECT_EQ(counts(*whole), (Counts{8, 12, 6, 1}));
  EXPECT_EQ(whole->provenance->of(whole->regions()[0])[0], (Parent{0, RegionId(1)}));
}

TEST(Extract, AllFacesOfASolidEncloseEmptySpace) {
  const auto source = shared(cylinder(1, 2));
  const auto shell = extract_entities(source, std::vector<EntityRef>{FaceId(0), FaceId(1), FaceId(2)});
  ASSERT_BUILT(shell);
  EXPECT_EQ(counts(*shell), (Counts{2, 3, 3, 0}));
  EXPECT_EQ(shell->topology().region_count(), 2u);
  const auto again = detect_regions(std::make_shared<const Model>(*shell));
  ASSERT_BUILT(again);
  EXPECT_EQ(counts(*again), (Counts{2, 3, 3, 1}));
  EXPECT_NEAR(total_volume(*again).value(), 2 * 3.14159265358979323846, 1e-9);
}

TEST(Extract, UnknownEntitiesAreNamed) {
  const auto source = shared(block(1, 1, 1));
  expect_error(extract_entities(source, std::vector<EntityRef>{FaceId(6)}), errors::unknown_entity, "no such entity");
  expect_error(extract_entities(source, std::vector<EntityRef>{RegionId(0)}), errors::unknown_entity, "no such entity");
}

TEST(DetectRegions, FillsVoidsToo) {
  // A square ring revolved has a void; detected, it is a second region.
  const auto profile = shared(polygon(std::vector<Vec3>{{1, 0, 0}, {5, 0, 0}, {5, 0, 4}, {1, 0, 4}},
                                      std::vector<std::vector<Vec3>>{{{2, 0, 1}, {4, 0, 1}, {4, 0, 3}, {2, 0, 3}}}));
  const auto ring = shared(revolve(profile));
  EXPECT_EQ(ring->regions().size(), 1u);
  const auto filled = detect_regions(ring);
  ASSERT_BUILT(filled);
  EXPECT_EQ(filled->regions().size(), 2u);
  EXPECT_NEAR(total_volume(*filled).value(), 2 * 3.14159265358979323846 * 3 * 16, 1e-8);
}

TEST(DetectRegions, OfSomeFacesOnly) {
  const auto source = shared(block(1, 1, 1));
  const std::vector<FaceId> five{FaceId(0), FaceId(1), FaceId(2), FaceId(3), FaceId(4)};
  EXPECT_EQ(counts(*detect_regions(source, five)), (Counts{8, 12, 5, 0}));
  std::vector<FaceId> six = five;
  six.push_back(FaceId(5));
  const auto m = detect_regions(source, six);
  EXPECT_EQ(counts(*m), (Counts{8, 12, 6, 1}));
  EXPECT_EQ(m->provenance->of(FaceId(2))[0], (Parent{0, FaceId(2)}));
}

}  // namespace
}  // namespace aresta
