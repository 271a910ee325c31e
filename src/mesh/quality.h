// SPDX-License-Identifier: Apache-2.0
// How good a mesh is: measures per element, a histogram, and the worst elements by name.
#pragma once

#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace aresta {

/// Measures of one triangle or tetrahedron, by its corners (curved elements: scaled_jacobian also at the nodes'
/// controls). Other types get scaled_jacobian only (least over the corners); angles and aspect are then zero.
struct ElementQuality {
  double smallest_angle = 0;   ///< degrees: between sides of a triangle, between faces (dihedral) of a tetrahedron
  double largest_angle = 0;    ///< degrees
  double aspect_ratio = 0;     ///< longest side over the inradius, scaled to 1 for the regular element
  double scaled_jacobian = 0;  ///< at most 1 (regular); negative when turned inside out
};

struct ElementName {
  std::size_t block = 0, element = 0;  ///< in Mesh::blocks and within the block
};

struct WorstElement {
  ElementName name;
  EntityRef entity;
  Vec3 centre;
  ElementQuality quality;
};

/// Figures over all elements of one dimension (2 or 3).
struct QualityReport {
  int dimension = 3;
  std::size_t elements = 0;
  ElementQuality worst;  ///< smallest of the smallest angles, largest of the largest, and so on
  double mean_smallest_angle = 0;
  std::vector<std::size_t> histogram;        ///< of smallest angles: 18 classes of 10 degrees
  std::vector<WorstElement> worst_elements;  ///< by scaled Jacobian, worst first; ties by name
  std::size_t inverted = 0;                  ///< elements whose scaled Jacobian is not positive

  /// A page of text for a person.
  std::string to_text() const;
};

ElementQuality element_quality(const Mesh& mesh, ElementName name);
QualityReport quality_report(const Mesh& mesh, int dimension, std::size_t worst_count = 5);

/// Least and largest determinant control of a ten-node tetrahedron's map, over six times its linear volume: the map is
/// one-to-one when the least is positive (sufficient: Bernstein coefficients bound a polynomial from below).
/// Nodes in VTK's order. Source: A. Johnen, J.-F. Remacle, C. Geuzaine, Geometrical validity of curvilinear finite
/// elements, J. Comp. Phys. 233 (2013).
struct JacobianRange {
  double least = 0, largest = 0;
};
JacobianRange tetra10_jacobian(const Vec3* nodes);

}  // namespace aresta
