// SPDX-License-Identifier: Apache-2.0
#include "mesh/quality.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/size_field.h"

namespace aresta {
namespace {

Mesh one_element(ElementType type, std::vector<Vec3> nodes) {
  Mesh mesh;
  ElementBlock block{type, RegionId(1), {}};
  for (std::uint32_t i = 0; i < nodes.size(); ++i) block.nodes.push_back(i);
  mesh.nodes = std::move(nodes);
  mesh.blocks.push_back(block);
  return mesh;
}

const std::vector<Vec3> regular_tetra{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};

std::vector<Vec3> with_middles(std::vector<Vec3> p) {
  for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}) p.push_back(0.5 * (p[i] + p[j]));
  return p;
}

TEST(Quality, RegularElements) {
  // Dihedral angle of the regular tetrahedron: arccos(1/3).
  const auto tetra = element_quality(
      one_element(ElementType::tetra4, {regular_tetra[0], regular_tetra[2], regular_tetra[1], regular_tetra[3]}),
      {0, 0});
  EXPECT_NEAR(tetra.smallest_angle, 70.528779365509, 1e-9);
  EXPECT_NEAR(tetra.largest_angle, 70.528779365509, 1e-9);
  EXPECT_NEAR(tetra.aspect_ratio, 1, 1e-12);
  EXPECT_NEAR(std::abs(tetra.scaled_jacobian), 1, 1e-12);
  const auto triangle =
      element_quality(one_element(ElementType::triangle3, {{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}}), {0, 0});
  EXPECT_NEAR(triangle.smallest_angle, 60, 1e-10);
  EXPECT_NEAR(triangle.aspect_ratio, 1, 1e-12);
  EXPECT_NEAR(triangle.scaled_jacobian, 1, 1e-12);
}

TEST(Quality, CornerOfACube) {
  const Mesh mesh = one_element(ElementType::tetra4, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const auto q = element_quality(mesh, {0, 0});
  EXPECT_NEAR(linear_volume(mesh), 1.0 / 6, 1e-15);
  EXPECT_NEAR(q.largest_angle, 90, 1e-10);
  EXPECT_NEAR(q.smallest_angle, 54.735610317245, 1e-9);  // arctan(sqrt 2)
  EXPECT_GT(q.scaled_jacobian, 0);
  const auto turned =
      element_quality(one_element(ElementType::tetra4, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}), {0, 0});
  EXPECT_NEAR(turned.scaled_jacobian, -q.scaled_jacobian, 1e-14);
}

TEST(Quality, JacobianOfQuadraticTetrahedron) {
  std::vector<Vec3> nodes = with_middles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  JacobianRange range = tetra10_jacobian(nodes.data());
  EXPECT_NEAR(range.least, 1, 1e-14);
  EXPECT_NEAR(range.largest, 1, 1e-14);
  // Node 4 at x = 1/4: along that side x = r (4 * 1/4) (1 - r) + ... so that dx/dr vanishes at r = 0.
  nodes[4] = {0.25, 0, 0};
  EXPECT_NEAR(tetra10_jacobian(nodes.data()).least, 0, 1e-14);
  nodes[4] = {0.2, 0, 0};
  EXPECT_LT(tetra10_jacobian(nodes.data()).least, 0);
}

TEST(Quality, VolumesOfOtherTypes) {
  const std::vector<Vec3> hexa{{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}, {0, 0, 4}, {2, 0, 4}, {2, 3, 4}, {0, 3, 4}};
  EXPECT_NEAR(linear_volume(one_element(ElementType::hexa8, hexa)), 24, 1e-12);
  EXPECT_NEAR(element_quality(one_element(ElementType::hexa8, hexa), {0, 0}).scaled_jacobian, 1, 1e-14);
  // VTK's linear wedge: the first triangle's normal points out.
  const std::vector<Vec3> wedge{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 2}, {0, 1, 2}, {1, 0, 2}};
  EXPECT_NEAR(linear_volume(one_element(ElementType::wedge6, wedge)), 1, 1e-14);
  EXPECT_GT(element_quality(one_element(ElementType::wedge6, wedge), {0, 0}).scaled_jacobian, 0);
}

TEST(Quality, ReportCountsAndNames) {
  Mesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}, {0.5, -0.05, 0}};
  mesh.blocks.push_back({ElementType::triangle3, FaceId(4), {0, 1, 2, 0, 3, 1}});
  const QualityReport report = quality_report(mesh, 2, 1);
  EXPECT_EQ(report.elements, 2u);
  EXPECT_EQ(report.inverted, 0u);
  ASSERT_EQ(report.worst_elements.size(), 1u);
  EXPECT_EQ(report.worst_elements[0].name.element, 1u);
  EXPECT_EQ(report.worst_elements[0].entity, EntityRef(FaceId(4)));
  EXPECT_EQ(report.histogram[0], 1u);
  EXPECT_NEAR(report.worst.smallest_angle, std::atan2(0.05, 0.5) * 180 / M_PI, 1e-10);
  const std::string text = report.to_text();
  EXPECT_NE(text.find("2 surface elements"), std::string::npos);
  EXPECT_NE(text.find("element 1 of face 4"), std::string::npos);
  EXPECT_EQ(quality_report(mesh, 3).elements, 0u);
}

TEST(SizeField, GradesAwayFromASmallPlace) {
  const Box3 box{{0, 0, 0}, {10, 10, 10}};
  mesh::SizeField field(box, 2, 0.01, 0.3);
  EXPECT_EQ(field.at({5, 5, 5}), 2);
  field.restrict({5, 5, 5}, 0.1);
  EXPECT_LE(field.at({5, 5, 5}), 0.11);
  // No faster than by the grading (the field is constant in cells no larger than its size: twice that is allowed).
  for (const double d : {0.2, 0.5, 1.0, 2.0, 4.0}) {
    EXPECT_LE(field.at({5 + d, 5, 5}), 0.1 + 0.3 * 2 * d + 0.1) << d;
    EXPECT_GE(field.at({5 + d, 5, 5}), std::min(2.0, 0.1 + 0.3 * 0.4 * d)) << d;
  }
  EXPECT_EQ(field.at({9.9, 9.9, 9.9}), 2);
  field.restrict({1, 1, 1}, 1e-9);
  EXPECT_GE(field.at({1, 1, 1}), 0.01);
}

}  // namespace
}  // namespace aresta
