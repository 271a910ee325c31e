// SPDX-License-Identifier: Apache-2.0
#include "mesh/mesh_model.h"

#include <gtest/gtest.h>

#include <cstring>

#include "measures.h"
#include "mesh/errors.h"
#include "mesh/quality.h"
#include "shapes.h"

namespace aresta {
namespace {

using namespace test;

const RegionId first_region(1);

TEST(MeshModel, UnitCube) {
  Shapes shapes;
  shapes.box({0, 0, 0}, {1, 1, 1});
  const Mesh mesh = made(shapes.model(), {.size = 0.25});
  EXPECT_NEAR(linear_volume(mesh), 1, 1e-12);
  EXPECT_EQ(surface_euler(mesh), 2);
  EXPECT_TRUE(is_conforming(mesh));
  EXPECT_EQ(mesh.element_count(0), 8u);
  EXPECT_EQ(mesh.element_count(1), 12u * 4);
  for (int f = 0; f < 6; ++f) EXPECT_NEAR(face_area(mesh, FaceId(f)), 1, 1e-13);
  const QualityReport volume = quality_report(mesh, 3), surface = quality_report(mesh, 2);
  EXPECT_GT(volume.worst.smallest_angle, 15);
  EXPECT_GT(surface.worst.smallest_angle, 25);
  EXPECT_EQ(volume.inverted, 0u);
}

TEST(MeshModel, TwoCubesShareOneMeshOfTheirFace) {
  Shapes shapes;
  shapes.box({0, 0, 0}, {1, 1, 1}, 1, 0, 1);
  const FaceId shared = shapes.polygon({{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}, 1, 1);
  shapes.box({1, 0, 0}, {2, 1, 1}, 1, 0, 0);
  const Model model = shapes.model();
  const Mesh mesh = made(model, {.size = 0.3});
  ASSERT_EQ(model.regions().size(), 2u);
  EXPECT_NEAR(region_volume(mesh, model.regions()[0]), 1, 1e-12);
  EXPECT_NEAR(region_volume(mesh, model.regions()[1]), 1, 1e-12);
  EXPECT_TRUE(is_conforming(mesh));
  EXPECT_EQ(regions_at(mesh, shared), (std::vector<EntityRef>{model.regions()[0], model.regions()[1]}));
  // No two nodes at one place.
  std::set<std::array<double, 3>> places;
  for (const Vec3& p : mesh.nodes) EXPECT_TRUE(places.insert({p.x, p.y, p.z}).second);
}

TEST(MeshModel, CubeWithSphericalVoid) {
  Shapes shapes;
  shapes.box({-1, -1, -1}, {1, 1, 1});
  const FaceId void_face = shapes.sphere({0, 0, 0}, 0.5, 1, 0);
  const Mesh mesh = made(shapes.model(), {.size = 0.4, .angle = 15});
  // Triangles of sides a R lose 3 a^2 / 8 of a sphere's volume; a = 15 degrees.
  EXPECT_NEAR(region_volume(mesh, first_region), 8 - pi / 6, 3.0 / 8 * (pi / 12) * (pi / 12) * pi / 6);
  EXPECT_LT(region_volume(mesh, first_region), 8);
  EXPECT_GT(region_volume(mesh, first_region), 8 - pi / 6);  // the void's mesh is inscribed
  EXPECT_EQ(surface_euler(mesh), 4);
  EXPECT_TRUE(is_conforming(mesh));
  for (const std::uint32_t n : nodes_of(mesh, void_face)) EXPECT_NEAR(norm(mesh.nodes[n]), 0.5, 1e-13);
  EXPECT_GT(quality_report(mesh, 3).worst.smallest_angle, 8);
}

TEST(MeshModel, CylinderNodesLieOnIt) {
  Shapes shapes;
  shapes.cylinder({0, 0, 0}, 1, 3);
  const Mesh mesh = made(shapes.model(), {.size = 0.5});
  EXPECT_EQ(surface_euler(mesh), 2);
  EXPECT_TRUE(is_conforming(mesh));
  for (const std::uint32_t n : nodes_of(mesh, FaceId(0)))
    EXPECT_NEAR(std::hypot(mesh.nodes[n].x, mesh.nodes[n].y), 1, 1e-13);
  // 18 sides of 20 degrees: between the inscribed prism and the cylinder.
  EXPECT_LT(linear_volume(mesh), 3 * pi);
  EXPECT_GT(linear_volume(mesh), 3 * 0.5 * 18 * std::sin(2 * pi / 18) * (1 - 1e-3));
  EXPECT_GT(quality_report(mesh, 3).worst.smallest_angle, 8);
  EXPECT_GT(quality_report(mesh, 2).worst.smallest_angle, 20);
}

TEST(MeshModel, SphereWithSeamAndPoles) {
  Shapes shapes;
  shapes.sphere({1, 2, 3}, 1, 0, 1);
  const Mesh mesh = made(shapes.model(), {.size = 0.3});
  EXPECT_EQ(surface_euler(mesh), 2);
  EXPECT_TRUE(is_conforming(mesh));
  for (const std::uint32_t n : nodes_of(mesh, FaceId(0))) EXPECT_NEAR(distance(mesh.nodes[n], {1, 2, 3}), 1, 1e-13);
  EXPECT_NEAR(linear_volume(mesh), 4 * pi / 3, 0.03 * 4 * pi / 3);
  EXPECT_GT(quality_report(mesh, 3).worst.smallest_angle, 8);
  EXPECT_GT(quality_report(mesh, 2).worst.smallest_angle, 25);
}

TEST(MeshModel, TorusWithTwoSeams) {
  Shapes shapes;
  shapes.torus({0, 0, 0}, 2, 0.7, 0, 1);
  const Mesh mesh = made(shapes.model(), {.size = 0.4});
  EXPECT_EQ(surface_euler(mesh), 0);
  EXPECT_TRUE(is_conforming(mesh));
  const double exact = 2 * pi * pi * 2 * 0.49;
  EXPECT_LT(linear_volume(mesh), exact);
  EXPECT_GT(linear_volume(mesh), 0.95 * exact);
  EXPECT_GT(quality_report(mesh, 3).worst.smallest_angle, 8);
}

TEST(MeshModel, HollowSphere) {
  Shapes shapes;
  shapes.sphere({0, 0, 0}, 1, 0, 1);
  shapes.sphere({0, 0, 0}, 0.6, 1, 0);
  const Mesh mesh = made(shapes.model(), {.size = 0.25, .angle = 15});
  EXPECT_EQ(surface_euler(mesh), 4);
  EXPECT_TRUE(is_conforming(mesh));
  EXPECT_NEAR(linear_volume(mesh), 4 * pi / 3 * (1 - 0.216), 0.08);
}

TEST(MeshModel, SheetInsideARegionIsMet) {
  Shapes shapes;
  shapes.box({0, 0, 0}, {1, 1, 1});
  const FaceId sheet =
      shapes.polygon({{0.25, 0.25, 0.5}, {0.75, 0.25, 0.5}, {0.75, 0.75, 0.5}, {0.25, 0.75, 0.5}}, 1, 1);
  const Model model = shapes.model();
  const Mesh mesh = made(model, {.size = 0.25});
  EXPECT_NEAR(region_volume(mesh, first_region), 1, 1e-12);
  EXPECT_NEAR(face_area(mesh, sheet), 0.25, 1e-13);
  EXPECT_TRUE(is_conforming(mesh));
  EXPECT_EQ(regions_at(mesh, sheet), (std::vector<EntityRef>{first_region, first_region}));
}

TEST(MeshModel, SheetAloneIsSurfaceElements) {
  Shapes shapes;
  shapes.polygon({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, 0, 0);
  shapes.wire({5, 0, 0}, {6, 0, 0});
  shapes.vertex({9, 9, 9});
  const Mesh mesh = made(shapes.model(), {.size = 0.5});
  EXPECT_EQ(mesh.element_count(3), 0u);
  EXPECT_NEAR(face_area(mesh, FaceId(0)), 2, 1e-13);
  EXPECT_EQ(nodes_of(mesh, EdgeId(4)).size(), 3u);
  EXPECT_EQ(nodes_of(mesh, VertexId(6)).size(), 1u);
  EXPECT_EQ(mesh.element_count(0), 7u);
}

/// A plate with a dangling edge from its boundary, a loose edge and a point inside.
TEST(MeshModel, EdgesAndPointsInsideAFaceAreMet) {
  Shapes shapes;
  auto& builder = shapes.builder;
  builder.begin_face(builder.add_surface(Plane{}), false);
  bool reversed = false;
  const Vec3 a{0, 0, 0}, b{4, 0, 0}, c{4, 3, 0}, d{0, 3, 0}, tip{1.5, 1, 0};
  const auto add = [&](Vec3 p, Vec3 q) {
    const EdgeId e = shapes.edge(p, q, reversed);
    builder.add_coedge(e, reversed);
  };
  add(a, b), add(b, c), add(c, d), add(d, a), add(a, tip), add(tip, a);
  builder.close_loop();
  add({2.5, 2, 0}, {3.5, 2.2, 0}), add({3.5, 2.2, 0}, {2.5, 2, 0});
  builder.close_loop();
  const VertexId isolated = shapes.vertex({1, 2.2, 0});
  builder.add_point_loop(isolated);
  builder.end_face();
  const Mesh mesh = made(shapes.model(), {.size = 0.5});
  EXPECT_NEAR(face_area(mesh, FaceId(0)), 12, 1e-12);
  EXPECT_EQ(surface_euler(mesh), 1);
  EXPECT_TRUE(nodes_of(mesh, FaceId(0)).contains(isolated.value));
  // Each line element of each edge is a side of as many triangles as the edge has face sides.
  std::map<std::array<std::uint32_t, 2>, int> sides;
  for (const auto& block : mesh.blocks) {
    if (block.type != ElementType::triangle3) continue;
    for (std::size_t i = 0; i < block.nodes.size(); i += 3) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t p = block.nodes[i + k], q = block.nodes[i + (k + 1) % 3];
        ++sides[{std::min(p, q), std::max(p, q)}];
      }
    }
  }
  for (const auto& block : mesh.blocks) {
    if (block.type != ElementType::line2) continue;
    for (std::size_t i = 0; i < block.nodes.size(); i += 2) {
      const int expected = block.entity.index < 4 ? 1 : 2;
      EXPECT_EQ((sides[{std::min(block.nodes[i], block.nodes[i + 1]), std::max(block.nodes[i], block.nodes[i + 1])}]),
                expected);
    }
  }
}

/// Wires inside a region, touching its boundary, and meeting each other; an arc; points.
TEST(MeshModel, WiresAndPointsInsideARegionAreMet) {
  Shapes shapes;
  shapes.box({0, 0, 0}, {2, 2, 2});
  std::vector<EdgeId> wires{shapes.wire({0.5, 0.5, 0.5}, {1.5, 1.5, 1.2}),
                            shapes.wire({1.5, 1.5, 1.2}, {1.5, 0.5, 1.2}),
                            shapes.wire({1.5, 1.5, 1.2}, {1.6, 1.6, 1.8}), shapes.wire({0, 0, 0}, {0.5, 0.4, 0.2}),
                            shapes.circle(Frame::along({1, 1, 0.7}, {0, 1, 1}), 0.4)};
  const VertexId points[2] = {shapes.vertex({1, 0.3, 1.7}), shapes.vertex({0.4, 1.6, 1.9})};
  for (const int order : {1, 2}) {
    const Mesh mesh = made(shapes.model(), {.size = 0.4, .order = order});
    EXPECT_NEAR(region_volume(mesh, first_region), 8, 1e-11);
    EXPECT_TRUE(is_conforming(mesh));
    EXPECT_GT(quality_report(mesh, 3).worst.smallest_angle, 8);
    std::set<std::array<std::uint32_t, 2>> sides;
    std::set<std::uint32_t> corners;
    for (const auto& block : mesh.blocks) {
      if (dimension(block.type) != 3) continue;
      const auto step = static_cast<std::size_t>(node_count(block.type));
      for (std::size_t e = 0; e < block.nodes.size(); e += step) {
        for (std::size_t i = 0; i < 4; ++i) {
          corners.insert(block.nodes[e + i]);
          for (std::size_t j = 0; j < i; ++j) {
            sides.insert(
                {std::min(block.nodes[e + i], block.nodes[e + j]), std::max(block.nodes[e + i], block.nodes[e + j])});
          }
        }
      }
    }
    for (const EdgeId wire : wires) {
      for (const auto& block : mesh.blocks) {
        if (block.entity != EntityRef(wire)) continue;
        const auto step = static_cast<std::size_t>(node_count(block.type));
        for (std::size_t e = 0; e < block.nodes.size(); e += step) {
          EXPECT_TRUE(sides.contains(
              {std::min(block.nodes[e], block.nodes[e + 1]), std::max(block.nodes[e], block.nodes[e + 1])}));
        }
      }
    }
    for (const VertexId v : points) EXPECT_TRUE(corners.contains(v.value));
    for (const std::uint32_t n : nodes_of(mesh, wires[4]))
      EXPECT_NEAR(distance(mesh.nodes[n], {1, 1, 0.7}), 0.4, 1e-13);
  }
}

TEST(MeshModel, VolumeConvergesWithTheSquareOfTheSize) {
  double error[3];
  const double sizes[3] = {1, 0.5, 0.25};
  for (int i = 0; i < 3; ++i) {
    Shapes shapes;
    shapes.block_with_hole(2, 1, 1);
    const Mesh mesh = made(shapes.model(), {.size = sizes[i], .angle = 60});
    error[i] = linear_volume(mesh) - (16 - pi);
    EXPECT_EQ(surface_euler(mesh), 0);
  }
  for (int i = 0; i < 3; ++i) EXPECT_GT(error[i], 0);
  EXPECT_GT(std::log2(error[0] / error[1]), 1.7);
  EXPECT_GT(std::log2(error[1] / error[2]), 1.7);
  EXPECT_LT(error[2] / (16 - pi), 0.002);
}

TEST(MeshModel, SecondOrderConvergesFaster) {
  double linear[2], curved[2];
  const double sizes[2] = {0.8, 0.4};
  for (int i = 0; i < 2; ++i) {
    Shapes shapes;
    shapes.sphere({0, 0, 0}, 1, 0, 1);
    const Mesh mesh = made(shapes.model(), {.size = sizes[i], .angle = 60, .order = 2});
    linear[i] = 4 * pi / 3 - linear_volume(mesh);
    curved[i] = std::abs(4 * pi / 3 - region_volume(mesh, first_region));
    const QualityReport report = quality_report(mesh, 3);
    EXPECT_EQ(report.inverted, 0u);
    for (const std::uint32_t n : nodes_of(mesh, FaceId(0))) EXPECT_NEAR(norm(mesh.nodes[n]), 1, 1e-13);
  }
  EXPECT_LT(curved[0], 0.1 * linear[0]);
  EXPECT_LT(curved[1], 0.03 * linear[1]);
  EXPECT_GT(std::log2(curved[0] / curved[1]), 3);
}

TEST(MeshModel, SameInputSameBytes) {
  const auto once = [] {
    Shapes shapes;
    shapes.box({-1, -1, -1}, {1, 1, 1});
    shapes.sphere({0, 0, 0}, 0.5, 1, 0);
    return made(shapes.model(), {.size = 0.4, .order = 2});
  };
  const Mesh a = once(), b = once();
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  EXPECT_EQ(std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(Vec3)), 0);
  ASSERT_EQ(a.blocks.size(), b.blocks.size());
  for (std::size_t i = 0; i < a.blocks.size(); ++i) EXPECT_EQ(a.blocks[i].nodes, b.blocks[i].nodes);
}

TEST(MeshModel, OwnSizesMakeFiner) {
  Shapes shapes;
  shapes.box({0, 0, 0}, {1, 1, 1});
  const Model model = shapes.model();
  const Mesh coarse = made(model, {.size = 0.5});
  const Mesh at_vertex = made(model, {.size = 0.5, .sizes = {{VertexId(0), 0.05}}});
  const Mesh in_region = made(model, {.size = 0.5, .sizes = {{first_region, 0.2}}});
  const Mesh on_edge = made(model, {.size = 0.5, .sizes = {{EdgeId(0), 0.1}}});
  EXPECT_GT(at_vertex.element_count(3), 2 * coarse.element_count(3));
  EXPECT_GT(in_region.element_count(3), 5 * coarse.element_count(3));
  EXPECT_GE(nodes_of(on_edge, EdgeId(0)).size(), 10u);
  EXPECT_LE(nodes_of(on_edge, EdgeId(0)).size(), 13u);
}

TEST(MeshModel, LowerDimensions) {
  Shapes shapes;
  shapes.box({0, 0, 0}, {1, 1, 1});
  const Model model = shapes.model();
  const Mesh lines = made(model, {.size = 0.5, .dimension = 1});
  EXPECT_EQ(lines.element_count(1), 24u);
  EXPECT_EQ(lines.element_count(2), 0u);
  EXPECT_EQ(lines.nodes.size(), 20u);
  const Mesh surface = made(model, {.size = 0.5, .order = 2, .dimension = 2});
  EXPECT_EQ(surface.element_count(3), 0u);
  EXPECT_EQ(surface_euler(surface), 2);
}

TEST(MeshModel, NamesAndGroupsBecomeSets) {
  Shapes shapes;
  shapes.box({0, 0, 0}, {1, 1, 1});
  shapes.builder.labels.set_name(first_region, "steel");
  shapes.builder.labels.groups.push_back({"ends", {FaceId(0), FaceId(1)}});
  const Mesh mesh = made(shapes.model(), {.size = 0.5});
  ASSERT_EQ(mesh.sets.size(), 2u);
  EXPECT_EQ(mesh.sets[0].name, "steel");
  EXPECT_EQ(mesh.sets[0].entities, (std::vector<EntityRef>{first_region}));
  EXPECT_EQ(mesh.sets[1].name, "ends");
  EXPECT_EQ(mesh.sets[1].entities, (std::vector<EntityRef>{FaceId(0), FaceId(1)}));
}

TEST(MeshModel, ThinWallIsRefinedUntilItFits) {
  // A tube of wall 0.01: with the wished coarse circles the two surfaces' meshes would cross.
  Shapes shapes;
  const EdgeId rims[4] = {shapes.circle(Frame{}, 1), shapes.circle(Frame{{0, 0, 1}}, 1), shapes.circle(Frame{}, 0.99),
                          shapes.circle(Frame{{0, 0, 1}}, 0.99)};
  shapes.cylinder_side({}, 1, 1, rims[0], rims[1], 0, 1);
  shapes.cylinder_side({}, 0.99, 1, rims[2], rims[3], 1, 0);
  shapes.ring({0, 0, 1}, rims[1], rims[3], true);
  shapes.ring({0, 0, 0}, rims[0], rims[2], false);
  const auto result = mesh_model(shapes.model(), {.size = 0.5, .angle = 60});
  ASSERT_TRUE(result.ok()) << result.error().to_line();
  EXPECT_TRUE(is_conforming(*result));
  EXPECT_NEAR(linear_volume(*result), pi * (1 - 0.9801), 0.05 * pi * (1 - 0.9801));
  EXPECT_EQ(surface_euler(*result), 0);
}

TEST(MeshModel, BadOptionsAreRefusedInWords) {
  Shapes shapes;
  shapes.box({0, 0, 0}, {1, 1, 1});
  const Model model = shapes.model();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const MeshOptions& options : {MeshOptions{.size = -1}, MeshOptions{.size = nan}, MeshOptions{.size = 1e-9},
                                     MeshOptions{.angle = 0}, MeshOptions{.grading = 2}, MeshOptions{.order = 3},
                                     MeshOptions{.dimension = 4}, MeshOptions{.sizes = {{first_region, 0.0}}}}) {
    const auto result = mesh_model(model, options);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, errors::mesh_bad_options);
  }
}

TEST(MeshModel, CancelStopsSoon) {
  Shapes shapes;
  shapes.box({0, 0, 0}, {1, 1, 1});
  const Model model = shapes.model();
  for (const std::string stop_at : {"element sizes", "edge mesh", "surface mesh", "volume mesh"}) {
    std::atomic<bool> stop = false;
    Context context;
    context.cancel = &stop;
    context.progress = [&](double, std::string_view stage) {
      if (stage == stop_at) stop = true;
    };
    const auto result = mesh_model(model, {.size = 0.04}, context);
    ASSERT_FALSE(result.ok()) << stop_at;
    EXPECT_EQ(result.error().code, errors::cancelled) << stop_at;
  }
}

}  // namespace
}  // namespace aresta
