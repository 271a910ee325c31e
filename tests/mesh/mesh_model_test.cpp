// SPDX-License-Identifier: Apache-2.0
#include "mesh/mesh_model.h"

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>

#include "mesh/errors.h"
#include "mesh/quality.h"
#include "shapes.h"

namespace aresta {
namespace {

using test::pi;
using test::Shapes;

Mesh made(const Model& model, const MeshOptions& options) {
  auto result = mesh_model(model, options);
  if (!result.ok()) throw std::runtime_error(result.error().to_line());
  return std::move(result).value();
}

double region_volume(const Mesh& mesh, RegionId region) {
  Mesh part;
  part.nodes = mesh.nodes;
  for (const auto& block : mesh.blocks) {
    if (block.entity == EntityRef(region)) part.blocks.push_back(block);
  }
  return linear_volume(part);
}

/// Vertices minus edges plus triangles of the surface blocks.
int surface_euler(const Mesh& mesh) {
  std::vector<std::array<std::uint32_t, 2>> sides;
  std::vector<std::uint32_t> nodes;
  int triangles = 0;
  for (const auto& block : mesh.blocks) {
    if (block.type != ElementType::triangle3) continue;
    for (std::size_t i = 0; i < block.nodes.size(); i += 3) {
      ++triangles;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = block.nodes[i + k], b = block.nodes[i + (k + 1) % 3];
        nodes.push_back(a);
        sides.push_back({std::min(a, b), std::max(a, b)});
      }
    }
  }
  const auto unique = [](auto& list) {
    std::sort(list.begin(), list.end());
    return static_cast<int>(std::unique(list.begin(), list.end()) - list.begin());
  };
  return unique(nodes) - unique(sides) + triangles;
}

TEST(MeshModel, UnitCube) {
  Shapes shapes;
  shapes.box({0, 0, 0}, {1, 1, 1});
  const Mesh mesh = made(shapes.model(), {.size = 0.25});
  EXPECT_NEAR(linear_volume(mesh), 1, 1e-12);
  EXPECT_EQ(surface_euler(mesh), 2);
  const QualityReport volume = quality_report(mesh, 3), surface = quality_report(mesh, 2);
  EXPECT_GT(volume.worst.smallest_angle, 10);
  EXPECT_GT(surface.worst.smallest_angle, 25);
  EXPECT_EQ(volume.inverted, 0u);
  std::cout << volume.to_text() << surface.to_text();
}

TEST(MeshModel, Sphere) {
  Shapes shapes;
  shapes.sphere({1, 2, 3}, 1, 0, 1);
  const Mesh mesh = made(shapes.model(), {.size = 0.3});
  EXPECT_NEAR(linear_volume(mesh), 4 * pi / 3, 0.15);
  EXPECT_EQ(surface_euler(mesh), 2);
  std::cout << quality_report(mesh, 3).to_text() << quality_report(mesh, 2).to_text();
}

TEST(MeshModel, Torus) {
  Shapes shapes;
  shapes.torus({0, 0, 0}, 2, 0.7, 0, 1);
  const Mesh mesh = made(shapes.model(), {.size = 0.4});
  EXPECT_NEAR(linear_volume(mesh), 2 * pi * pi * 2 * 0.49, 0.7);
  EXPECT_EQ(surface_euler(mesh), 0);
  std::cout << quality_report(mesh, 3).to_text() << quality_report(mesh, 2).to_text();
}

TEST(MeshModel, BlockWithHole) {
  for (const double size : {1.0, 0.5, 0.25}) {
    Shapes shapes;
    shapes.block_with_hole(2, 1, 1);
    const Mesh mesh = made(shapes.model(), {.size = size, .angle = 60});
    std::cout << size << " " << linear_volume(mesh) - (16 - pi) << " " << mesh.element_count(3) << "\n"
              << quality_report(mesh, 3).to_text() << quality_report(mesh, 2).to_text();
  }
}

}  // namespace
}  // namespace aresta
