// SPDX-License-Identifier: Apache-2.0
// Curves and surfaces of every form, in crooked frames of both hands, for tests that loop over all.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/curve.h"
#include "geometry/surface.h"

namespace aresta::samples {

inline constexpr double pi = std::numbers::pi;

inline Frame crooked(bool left_handed = false) {
  Frame f = Frame::along({1.5, -2.25, 0.75}, {0.3, -0.5, 0.8}, {1, 0.2, 0.1});
  if (left_handed) f.y = -f.y;
  return f;
}

inline FreeCurve free_curve() {
  NurbsCurveData d;
  d.degree = 3;
  d.knots = {0, 1, 2.5, 4};
  d.multiplicities = {4, 1, 2, 4};
  d.poles = {{0, 0, 0}, {1, 2, 0}, {2, -1, 1}, {3, 1, 2}, {4, 0, 1}, {5, 2, 0}, {6, 0, -1}};
  d.weights = {1, 2, 0.5, 1, 1.5, 1, 1};
  return *FreeCurve::from_nurbs(d);
}

inline FreeSurface free_surface() {
  NurbsSurfaceData d;
  d.degree_u = 3;
  d.degree_v = 2;
  d.knots_u = {0, 1, 2};
  d.multiplicities_u = {4, 1, 4};
  d.knots_v = {-1, 0, 3};
  d.multiplicities_v = {3, 1, 3};
  d.count_u = 5;
  d.count_v = 4;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 4; ++j) {
      d.poles.push_back({i * 1.0, j * 1.5, std::sin(1.3 * i) * std::cos(0.9 * j)});
      d.weights.push_back(1 + 0.3 * ((i + 2 * j) % 3));
    }
  }
  return *FreeSurface::from_nurbs(d);
}

struct NamedCurve {
  std::string name;
  Curve curve;
  Range range;
};

inline std::vector<NamedCurve> curves() {
  return {{"line", Line{{1, 2, 3}, normalized(Vec3{1, -2, 0.5})}, {-3, 7}},
          {"circle", Circle{crooked(), 2.5}, {0.3, 4.1}},
          {"full circle", Circle{crooked(), 2.5}, {1, 1 + 2 * pi}},
          {"mirrored circle", Circle{crooked(true), 0.7}, {-1, 2}},
          {"ellipse", Ellipse{crooked(), 3, 1.25}, {0.3, 4.1}},
          {"mirrored ellipse", Ellipse{crooked(true), 3, 0.5}, {-2, 3}},
          {"nurbs", free_curve(), {0.25, 3.75}}};
}

struct NamedSurface {
  std::string name;
  Surface surface;
  Range2 piece;
};

inline std::vector<NamedSurface> surfaces() {
  std::vector<NamedSurface> all;
  for (const bool left : {false, true}) {
    const std::string hand = left ? "left-handed " : "";
    const Frame f = crooked(left);
    all.push_back({hand + "plane", Plane{f}, {{-2, 3}, {1, 4}}});
    all.push_back({hand + "cylinder", Cylinder{f, 1.5}, {{0.2, 3.9}, {-1, 5}}});
    all.push_back({hand + "cone", Cone{f, 1.5, 0.4}, {{0.2, 3.9}, {-2, 5}}});
    all.push_back({hand + "narrowing cone", Cone{f, 2, -0.6}, {{-1, 2.5}, {-2, 3}}});
    all.push_back({hand + "cone across its apex", Cone{f, 0.5, 0.7}, {{0.2, 3.9}, {-3, 2}}});
    all.push_back({hand + "sphere", Sphere{f, 2}, {{0.2, 5.5}, {-1.2, 1.4}}});
    all.push_back({hand + "torus", Torus{f, 3, 1}, {{0.2, 5.5}, {1, 6}}});
    all.push_back({hand + "spindle torus", Torus{f, 1, 1.5}, {{0.2, 5.5}, {-1, 1}}});
  }
  all.push_back({"nurbs", free_surface(), {{0.1, 1.8}, {-0.8, 2.7}}});
  return all;
}

}  // namespace aresta::samples
