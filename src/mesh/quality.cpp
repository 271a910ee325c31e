// SPDX-License-Identifier: Apache-2.0
#include "mesh/quality.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace aresta {

namespace {

/// Fixed digits after the point, whatever the locale.
std::string fixed(double value, int digits) {
  if (!std::isfinite(value)) return value > 0 ? "infinite" : "undefined";
  char text[400];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits);
  return {text, end.ptr};
}

constexpr double degrees = 180 / std::numbers::pi;

double angle_between(Vec3 a, Vec3 b) {
  return degrees * std::atan2(norm(cross(a, b)), dot(a, b));
}

ElementQuality triangle_quality(Vec3 a, Vec3 b, Vec3 c) {
  ElementQuality q;
  const double angles[3] = {angle_between(b - a, c - a), angle_between(c - b, a - b), angle_between(a - c, b - c)};
  q.smallest_angle = std::min({angles[0], angles[1], angles[2]});
  q.largest_angle = std::max({angles[0], angles[1], angles[2]});
  const double la = distance(b, c), lb = distance(c, a), lc = distance(a, b);
  const double area = 0.5 * norm(cross(b - a, c - a));
  const double longest = std::max({la, lb, lc});
  const double inradius = la + lb + lc > 0 ? 2 * area / (la + lb + lc) : 0;
  q.aspect_ratio = inradius > 0 ? longest / (2 * std::sqrt(3.0) * inradius) : HUGE_VAL;
  const double product = std::max({la * lb, lb * lc, lc * la});
  q.scaled_jacobian = product > 0 ? 2 / std::sqrt(3.0) * 2 * area / product : 0;
  return q;
}

ElementQuality tetra_quality(const std::array<Vec3, 4>& p) {
  ElementQuality q;
  // Faces opposite to each corner, normals pointing out when the volume is positive.
  static constexpr int faces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  std::array<Vec3, 4> normals;
  double area = 0, longest = 0;
  for (int f = 0; f < 4; ++f) {
    normals[f] = cross(p[faces[f][1]] - p[faces[f][0]], p[faces[f][2]] - p[faces[f][0]]);
    area += 0.5 * norm(normals[f]);
  }
  q.smallest_angle = 180;
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      const double dihedral = 180 - angle_between(normals[i], normals[j]);
      q.smallest_angle = std::min(q.smallest_angle, dihedral);
      q.largest_angle = std::max(q.largest_angle, dihedral);
      longest = std::max(longest, distance(p[i], p[j]));
    }
  }
  const double six_volumes = dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]);
  const double inradius = area > 0 ? 0.5 * std::abs(six_volumes) / area : 0;
  q.aspect_ratio = inradius > 0 ? longest / (2 * std::sqrt(6.0) * inradius) : HUGE_VAL;
  double product = 0;
  for (int i = 0; i < 4; ++i) {
    double lengths = 1;
    for (int j = 0; j < 4; ++j) {
      if (j != i) lengths *= distance(p[i], p[j]);
    }
    product = std::max(product, lengths);
  }
  q.scaled_jacobian = product > 0 ? std::sqrt(2.0) * six_volumes / product : 0;
  return q;
}

/// Least over the corners of the normalised determinant of the three sides that meet there.
double corner_jacobian(const std::vector<Vec3>& p, int corners) {
  static constexpr int wedge[6][4] = {{0, 2, 1, 3}, {1, 0, 2, 4}, {2, 1, 0, 5},
                                      {3, 4, 5, 0}, {4, 5, 3, 1}, {5, 3, 4, 2}};
  static constexpr int hexa[8][4] = {{0, 1, 3, 4}, {1, 2, 0, 5}, {2, 3, 1, 6}, {3, 0, 2, 7},
                                     {4, 7, 5, 0}, {5, 4, 6, 1}, {6, 5, 7, 2}, {7, 6, 4, 3}};
  static constexpr int quad[4][3] = {{0, 1, 3}, {1, 2, 0}, {2, 3, 1}, {3, 0, 2}};
  double least = 1;
  if (corners == 4) {
    const Vec3 normal = normalized(cross(p[2] - p[0], p[3] - p[1]));
    for (const auto& c : quad)
      least = std::min(least, dot(cross(normalized(p[c[1]] - p[c[0]]), normalized(p[c[2]] - p[c[0]])), normal));
    return least;
  }
  for (int i = 0; i < corners; ++i) {
    const int* c = corners == 6 ? wedge[i] : hexa[i];
    const double det =
        dot(cross(normalized(p[c[1]] - p[c[0]]), normalized(p[c[2]] - p[c[0]])), normalized(p[c[3]] - p[c[0]]));
    least = std::min(least, corners == 6 ? det * 2 / std::sqrt(3.0) : det);
  }
  return least;
}

const std::uint32_t* element_nodes(const ElementBlock& block, std::size_t element) {
  return &block.nodes[element * static_cast<std::size_t>(node_count(block.type))];
}

}  // namespace

JacobianRange tetra10_jacobian(const Vec3* n) {
  // Columns of the Jacobian are linear in the barycentric coordinates: at corner k, derivative along side i is
  // 4 m - 3 a - b and so on. The determinant is cubic; its 20 Bernstein coefficients are symmetrised products of corner
  // values, because a Bernstein coefficient of a product of linear forms is the mean over all ways to deal the corners.
  static constexpr int mid[4][4] = {{-1, 4, 6, 7}, {4, -1, 5, 8}, {6, 5, -1, 9}, {7, 8, 9, -1}};
  Vec3 column[3][4];  // derivative along (corner i+1 - corner 0), at each corner
  for (int k = 0; k < 4; ++k) {
    // d x / d lambda_j at corner k: 4 * mid(j, k), or 3 * corner k for j = k.
    const auto gradient = [&](int j) { return j == k ? 3 * n[k] : 4 * n[mid[j][k]] - n[j]; };
    for (int i = 0; i < 3; ++i) column[i][k] = gradient(i + 1) - gradient(0);
  }
  const double linear = dot(cross(n[1] - n[0], n[2] - n[0]), n[3] - n[0]);
  JacobianRange range{HUGE_VAL, -HUGE_VAL};
  for (int a = 0; a < 4; ++a) {
    for (int b = a; b < 4; ++b) {
      for (int c = b; c < 4; ++c) {
        const int deals[6][3] = {{a, b, c}, {a, c, b}, {b, a, c}, {b, c, a}, {c, a, b}, {c, b, a}};
        double sum = 0;
        for (const auto& d : deals) sum += dot(cross(column[0][d[0]], column[1][d[1]]), column[2][d[2]]);
        const double ratio = linear != 0 ? sum / 6 / std::abs(linear) : -HUGE_VAL;
        range.least = std::min(range.least, ratio);
        range.largest = std::max(range.largest, ratio);
      }
    }
  }
  return range;
}

ElementQuality element_quality(const Mesh& mesh, ElementName name) {
  const auto& block = mesh.blocks[name.block];
  const std::uint32_t* nodes = element_nodes(block, name.element);
  const int corners = corner_count(block.type);
  const auto p = [&](int i) { return mesh.nodes[nodes[i]]; };
  switch (block.type) {
    case ElementType::triangle3:
    case ElementType::triangle6:
      return triangle_quality(p(0), p(1), p(2));
    case ElementType::tetra4:
      return tetra_quality({p(0), p(1), p(2), p(3)});
    case ElementType::tetra10: {
      ElementQuality q = tetra_quality({p(0), p(1), p(2), p(3)});
      Vec3 points[10];
      for (int i = 0; i < 10; ++i) points[i] = p(i);
      const JacobianRange range = tetra10_jacobian(points);
      q.scaled_jacobian = std::min(q.scaled_jacobian, q.scaled_jacobian * range.least);
      if (range.least <= 0) q.scaled_jacobian = std::min(q.scaled_jacobian, range.least);
      return q;
    }
    default: {
      ElementQuality q;
      if (dimension(block.type) < 2) return q;
      std::vector<Vec3> points;
      for (int i = 0; i < corners; ++i) points.push_back(p(i));
      q.scaled_jacobian = corner_jacobian(points, corners);
      if (block.type == ElementType::wedge15) q.scaled_jacobian = -q.scaled_jacobian;  // see corner_volume in mesh.cpp
      return q;
    }
  }
}

QualityReport quality_report(const Mesh& mesh, int wanted, std::size_t worst_count) {
  QualityReport report;
  report.dimension = wanted;
  report.histogram.assign(18, 0);
  report.worst = {180, 0, 0, 1};
  std::vector<WorstElement> all;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const auto& block = mesh.blocks[b];
    if (dimension(block.type) != wanted) continue;
    for (std::size_t e = 0; e < block.size(); ++e) {
      const ElementQuality q = element_quality(mesh, {b, e});
      ++report.elements;
      report.worst.smallest_angle = std::min(report.worst.smallest_angle, q.smallest_angle);
      report.worst.largest_angle = std::max(report.worst.largest_angle, q.largest_angle);
      report.worst.aspect_ratio = std::max(report.worst.aspect_ratio, q.aspect_ratio);
      report.worst.scaled_jacobian = std::min(report.worst.scaled_jacobian, q.scaled_jacobian);
      report.mean_smallest_angle += q.smallest_angle;
      report.histogram[std::min<std::size_t>(17, static_cast<std::size_t>(q.smallest_angle / 10))]++;
      if (!(q.scaled_jacobian > 0)) ++report.inverted;
      Vec3 centre{};
      const int corners = corner_count(block.type);
      for (int i = 0; i < corners; ++i) centre += mesh.nodes[element_nodes(block, e)[i]] / corners;
      all.push_back({{b, e}, block.entity, centre, q});
    }
  }
  if (report.elements == 0) report.worst = {};
  if (report.elements > 0) report.mean_smallest_angle /= static_cast<double>(report.elements);
  const auto worse = [](const WorstElement& a, const WorstElement& b) {
    if (a.quality.scaled_jacobian != b.quality.scaled_jacobian)
      return a.quality.scaled_jacobian < b.quality.scaled_jacobian;
    return std::pair{a.name.block, a.name.element} < std::pair{b.name.block, b.name.element};
  };
  const auto kept = static_cast<std::ptrdiff_t>(std::min(worst_count, all.size()));
  std::partial_sort(all.begin(), all.begin() + kept, all.end(), worse);
  report.worst_elements.assign(all.begin(), all.begin() + kept);
  return report;
}

std::string QualityReport::to_text() const {
  const std::string angle = dimension == 3 ? "dihedral angle" : "angle";
  std::string text = std::to_string(elements) + (dimension == 3 ? " volume elements\n" : " surface elements\n");
  if (elements == 0) return text;
  text += "  smallest " + angle + "  " + fixed(worst.smallest_angle, 2) +
          " degrees (mean of the elements' smallest: " + fixed(mean_smallest_angle, 2) + ")\n";
  text += "  largest " + angle + "  " + fixed(worst.largest_angle, 2) + " degrees\n";
  text += "  largest aspect ratio  " + fixed(worst.aspect_ratio, 2) + "\n";
  text += "  smallest scaled Jacobian  " + fixed(worst.scaled_jacobian, 4) +
          ", not positive: " + std::to_string(inverted) + "\n";
  text += "  elements by smallest " + angle + "\n";
  for (std::size_t i = 0; i < histogram.size(); ++i) {
    if (histogram[i] == 0) continue;
    text += "    " + std::to_string(10 * i) + " to " + std::to_string(10 * i + 10) + ": " +
            std::to_string(histogram[i]) + " (" +
            fixed(100.0 * static_cast<double>(histogram[i]) / static_cast<double>(elements), 1) + " %)\n";
  }
  text += "  worst elements\n";
  for (const auto& w : worst_elements) {
    text += "    element " + std::to_string(w.name.element) + " of " + to_string(w.entity.kind) + " " +
            std::to_string(w.entity.index) + ": scaled Jacobian " + fixed(w.quality.scaled_jacobian, 4) +
            ", smallest angle " + fixed(w.quality.smallest_angle, 2) + ", at " + fixed(w.centre.x, 6) + " " +
            fixed(w.centre.y, 6) + " " + fixed(w.centre.z, 6) + "\n";
  }
  return text;
}

}  // namespace aresta
