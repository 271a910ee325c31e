// SPDX-License-Identifier: Apache-2.0
#include "fragment/chains.h"

#include <cmath>
#include <numbers>

#include "large/large_models.h"

namespace aresta::bench {

std::vector<Triangle> triangles_of(const PolygonMesh& mesh) {
  std::vector<Triangle> triangles;
  for (const auto& face : mesh.faces) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) triangles.push_back({face[0], face[i], face[i + 1]});
  }
  return triangles;
}

double volume_of(const PolygonMesh& mesh) {
  double sixfold = 0;
  for (const auto& [a, b, c] : triangles_of(mesh))
    sixfold += dot(mesh.points[a], cross(mesh.points[b], mesh.points[c]));
  return sixfold / 6;
}

namespace {

PolygonMesh block_between(Vec3 low, Vec3 high) {
  PolygonMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.push_back(
        {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z});
  mesh.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return mesh;
}

/// The polygon, counterclockwise seen from above, from one height to another.
PolygonMesh prism_over(const std::vector<Vec2>& polygon, double low, double high) {
  PolygonMesh mesh;
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (const double z : {low, high}) {
    for (const Vec2 p : polygon) mesh.points.push_back({p.x, p.y, z});
  }
  std::vector<std::uint32_t> bottom, top;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.faces.push_back({i, next, n + next, n + i});
    bottom.push_back(n - 1 - i);
    top.push_back(n + i);
  }
  mesh.faces.push_back(bottom);
  mesh.faces.push_back(top);
  return mesh;
}

double rounded(double x, double steps) {
  return std::round(x * steps) / steps;
}

}  // namespace

Chain two_spheres(std::uint32_t n) {
  const auto sphere = test::sphere_of_triangles(n);
  Chain chain;
  chain.steps.resize(1);
  PolygonMesh& second = chain.steps[0].emplace_back();
  const double c = std::cos(1.), s = std::sin(1.);
  for (const auto& [x, y, z] : sphere.points) {
    const auto as_floats = [](double px, double py, double pz) {
      return Vec3{static_cast<float>(px), static_cast<float>(py), static_cast<float>(pz)};
    };
    chain.first.points.push_back(as_floats(x, y, z));
    second.points.push_back(as_floats(c * x - s * y + 0.61, s * x + c * y + 0.37, z + 0.23));
  }
  for (const auto& [a, b, d] : sphere.triangles) {
    chain.first.faces.push_back({a, b, d});
    second.faces.push_back({a, b, d});
  }
  return chain;
}

Chain plate_with_holes(int count) {
  constexpr int sides = 32;
  constexpr double steps = 1 << 16;  // what is left of a float for the fraction
  Chain chain{true, block_between({0, 0, 0}, {2. * count, 2. * count, 1}), {}};
  std::vector<Vec2> hole;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / sides;
    hole.push_back({rounded(0.7 * std::cos(angle), steps), rounded(0.7 * std::sin(angle), steps)});
  }
  chain.steps.resize(1);
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      std::vector<Vec2> moved;
      for (const Vec2 p : hole) moved.push_back(p + Vec2{2. * i + 1, 2. * j + 1});
      chain.steps[0].push_back(prism_over(moved, -0.5, 1.5));
    }
  }
  chain.volume = volume_of(chain.first) - count * count * volume_of(prism_over(hole, 0, 1));
  return chain;
}

Chain sponge(int level) {
  double side = 1;
  for (int i = 0; i < level; ++i) side *= 3;
  Chain chain{true, block_between({0, 0, 0}, {side, side, side}), {}};
  chain.volume = std::pow(20, level);
  int rows = 1;
  double width = side / 3;
  for (int k = 0; k < level; ++k, rows *= 3, width /= 3) {
    for (int axis = 0; axis < 3; ++axis) {
      auto& bars = chain.steps.emplace_back();
      for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < rows; ++j) {
          Vec3 low, high;
          low[axis] = -1;
          high[axis] = side + 1;
          low[(axis + 1) % 3] = (3 * i + 1) * width;
          high[(axis + 1) % 3] = (3 * i + 2) * width;
          low[(axis + 2) % 3] = (3 * j + 1) * width;
          high[(axis + 2) % 3] = (3 * j + 2) * width;
          bars.push_back(block_between(low, high));
        }
      }
    }
  }
  return chain;
}

Chain terrain(int size) {
  constexpr double ground = -16, depth = -8;
  const auto width = static_cast<std::uint32_t>(size + 1);
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i) * width + static_cast<std::uint32_t>(j); };
  Chain chain{true, {}, {}};
  auto& [points, faces] = chain.first;
  for (int i = 0; i <= size; ++i) {
    for (int j = 0; j <= size; ++j) {
      const double rough = std::sin(12.9898 * i + 78.233 * j);
      const double height = 3 * std::sin(i / 31.) * std::cos(j / 23.) + 0.3 * rough;
      points.push_back({1. * i, 1. * j, rounded(height, 1024)});
    }
  }
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  // The walls go round the height field counterclockwise seen from above, the bottom is a fan.
  std::vector<std::uint32_t> border;
  for (int i = 0; i < size; ++i) border.push_back(at(i, 0));
  for (int j = 0; j < size; ++j) border.push_back(at(size, j));
  for (int i = size; i > 0; --i) border.push_back(at(i, size));
  for (int j = size; j > 0; --j) border.push_back(at(0, j));
  const auto below = static_cast<std::uint32_t>(points.size()), n = static_cast<std::uint32_t>(border.size());
  for (const std::uint32_t v : border) points.push_back({points[v].x, points[v].y, ground});
  points.push_back({0.5 * size, 0.5 * size, ground});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    faces.push_back({below + i, below + next, border[next], border[i]});
    faces.push_back({below + n, below + next, below + i});
  }
  chain.volume = volume_of(chain.first);
  chain.steps.resize(1);
  const int pitch_x = size / 20, pitch_y = size / 10;
  for (int bx = 0; bx < 20; ++bx) {
    for (int by = 0; by < 10; ++by) {
      const int x = bx * pitch_x, y = by * pitch_y, dx = pitch_x / 2, dy = pitch_y / 2;
      chain.steps[0].push_back(block_between({1. * x, 1. * y, depth}, {1. * x + dx, 1. * y + dy, 8}));
      for (int i = x; i < x + dx; ++i) {
        for (int j = y; j < y + dy; ++j) {
          const double ends = points[at(i, j)].z + points[at(i + 1, j + 1)].z;
          chain.volume -= (2 * ends + points[at(i + 1, j)].z + points[at(i, j + 1)].z) / 6 - depth;
        }
      }
    }
  }
  return chain;
}

}  // namespace aresta::bench
