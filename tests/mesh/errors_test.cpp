// SPDX-License-Identifier: Apache-2.0
// Every error of mesh/errors.h that is not one of options, provoked.
#include "mesh/errors.h"

#include <gtest/gtest.h>

#include <limits>

#include "mesh/mesh_model.h"
#include "mesh/volume_input.h"
#include "shapes.h"

namespace aresta {
namespace {

using test::pi;
using test::Shapes;

const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// One tetrahedron's surface, normals outward.
mesh::VolumeInput tetra_surface() {
  mesh::VolumeInput input;
  input.points = corners;
  input.triangles = {{{0, 2, 1}, 0, 0, 1}, {{0, 1, 3}, 1, 0, 1}, {{1, 2, 3}, 2, 0, 1}, {{2, 0, 3}, 3, 0, 1}};
  input.region_count = 1;
  input.region_sizes = {2};
  return input;
}

TEST(MeshErrors, SheetsThatCrossAreNotMeshed) {
  Shapes shapes;
  shapes.polygon({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, 0, 0);
  shapes.polygon({{1, 0.5, -1}, {1, 1.5, -1}, {1, 1.5, 1}, {1, 0.5, 1}}, 0, 0);
  const auto result = mesh_model(shapes.model(), {.size = 0.8});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, errors::mesh_surfaces_cross);
  EXPECT_EQ(result.error().entities, (std::vector<EntityRef>{FaceId(0), FaceId(1)}));
  ASSERT_TRUE(result.error().place.has_value());
  EXPECT_NEAR((*result.error().place)[0], 1, 1e-12);
  EXPECT_NEAR((*result.error().place)[2], 0, 1e-12);
}

TEST(MeshErrors, ClosedFaceWithoutSeamIsRefused) {
  // The side of a tube between two circles, without the edge that cuts it open.
  Shapes shapes;
  auto& builder = shapes.builder;
  const EdgeId bottom = shapes.circle(Frame{}, 1), top = shapes.circle(Frame{{0, 0, 1}}, 1);
  builder.begin_face(builder.add_surface(Cylinder{Frame{}, 1}), false);
  builder.add_coedge(bottom, false, Curve2(Line2{{0, 0}, {1, 0}}));
  builder.close_loop();
  builder.add_coedge(top, true, Curve2(Line2{{0, 1}, {1, 0}}));
  builder.close_loop();
  builder.end_face();
  const auto result = mesh_model(shapes.model(), {.size = 0.5, .dimension = 2});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, errors::mesh_bad_input);
  EXPECT_EQ(result.error().entities, (std::vector<EntityRef>{FaceId(0)}));
}

TEST(MeshErrors, BoundaryThatCrossesItself) {
  Shapes shapes;
  auto& builder = shapes.builder;
  builder.begin_face(builder.add_surface(Plane{}), false);
  shapes.polygon_loop({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}});
  builder.end_face();
  const auto result = mesh_model(shapes.model(), {.size = 0.5, .dimension = 2});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, errors::mesh_face_boundary);
}

TEST(MeshErrors, EdgeThatCannotBeEvaluated) {
  Shapes shapes;
  auto& builder = shapes.builder;
  const VertexId v = builder.add_vertex({1, 0, 0});
  builder.add_edge(v, v, builder.add_curve(Circle{Frame{}, std::numeric_limits<double>::quiet_NaN()}), {0, 2 * pi});
  Cells cells;
  cells.of_edge = {0};
  cells.of_vertex = {Incidence::none};
  auto model = builder.build(cells, {false});
  ASSERT_TRUE(model.ok()) << model.error().to_line();
  const auto result = mesh_model(*model, {.size = 0.5});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, errors::mesh_edge_failed);
}

TEST(MeshErrors, WireInTheSkinHasNoRoom) {
  // The wire lies in the block's top face without being an edge of it.
  Shapes shapes;
  shapes.box({0, 0, 0}, {2, 2, 2});
  shapes.wire({0.5, 0.5, 2 - 1e-9}, {1.5, 1.5, 2 - 1e-9});
  const auto result = mesh_model(shapes.model(), {.size = 1});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, errors::mesh_embedded_wire);
  EXPECT_EQ(result.error().entities, (std::vector<EntityRef>{EdgeId(12)}));
}

TEST(MeshErrors, OpenSurfaceIsNotFilled) {
  mesh::VolumeInput input = tetra_surface();
  input.triangles.pop_back();
  const auto result = mesh::fill_volumes(input, {});
  const auto checked = result.ok() ? mesh::check_volumes(input, *result) : Status(result.error());
  ASSERT_FALSE(checked.ok());
  EXPECT_TRUE(checked.error().code == errors::mesh_volume_failed || checked.error().code == errors::mesh_check_failed);
}

TEST(MeshErrors, BrokenVolumeMeshesFailTheCheck) {
  const mesh::VolumeInput input = tetra_surface();
  const mesh::VolumeOutput good{corners, {{{0, 1, 2, 3}, 1}}};
  EXPECT_TRUE(mesh::check_volumes(input, good).ok());
  const auto refused = [&](const mesh::VolumeOutput& bad) {
    const auto status = mesh::check_volumes(input, bad);
    return !status.ok() && status.error().code == errors::mesh_check_failed;
  };
  EXPECT_TRUE(refused({corners, {{{0, 2, 1, 3}, 1}}}));                     // inside out
  EXPECT_TRUE(refused({corners, {}}));                                      // empty
  EXPECT_TRUE(refused({corners, {{{0, 1, 2, 3}, 2}}}));                     // a region that does not exist
  EXPECT_TRUE(refused({corners, {{{0, 1, 2, 3}, 1}, {{0, 1, 2, 3}, 1}}}));  // twice
  auto points = corners;
  points.push_back({0.1, 0.1, 0.1});
  EXPECT_TRUE(
      mesh::check_volumes(input, {points, {{{0, 1, 2, 4}, 1}, {{0, 3, 1, 4}, 1}, {{1, 3, 2, 4}, 1}, {{2, 3, 0, 4}, 1}}})
          .ok());
  EXPECT_TRUE(refused({points, {{{0, 1, 2, 4}, 1}, {{0, 3, 1, 4}, 1}, {{1, 3, 2, 4}, 1}}}));  // a gap
}

}  // namespace
}  // namespace aresta
