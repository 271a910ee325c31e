// SPDX-License-Identifier: Apache-2.0
#include "occt/seat_seams.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace aresta {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double full_turn = two_pi * (1 - 1e-9);

/// The surface with its frame turned so that the points of u = `from` get u = 0; nothing for forms without an axis.
std::optional<Surface> turned(const Surface& surface, double from) {
  const auto turn = [&](auto form) {
    const double c = std::cos(from), s = std::sin(from);
    const Vec3 x = form.frame.x, y = form.frame.y;
    form.frame.x = c * x + s * y;
    form.frame.y = c * y - s * x;
    return Surface(form);
  };
  if (const auto* s = surface.get_if<Cylinder>()) return turn(*s);
  if (const auto* s = surface.get_if<Cone>()) return turn(*s);
  if (const auto* s = surface.get_if<Sphere>()) return turn(*s);
  if (const auto* s = surface.get_if<Torus>()) return turn(*s);
  return std::nullopt;
}

Range reach_in_u(const Model& model, FaceId f) {
  constexpr int samples = 8;
  Range reach{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const Complex& k = model.topology();
  for (const LoopId l : k.loops(f)) {
    if (k.is_vertex_loop(l)) continue;
    for (const CoedgeId c : k.coedges(l)) {
      for (int i = 0; i <= samples; ++i) {
        const double u = model.uv(c, model.range(k.edge(c)).at(static_cast<double>(i) / samples)).x;
        reach = {std::min(reach.low, u), std::max(reach.high, u)};
      }
    }
  }
  return reach;
}

}  // namespace

GeometryChanges seat_seams(const Model& model) {
  const Complex& k = model.topology();
  GeometryChanges changes;
  for (const FaceId f : k.faces()) {
    const Surface& surface = model.surface(f);
    if (surface.is_plane() || surface.get_if<FreeSurface>() != nullptr) continue;
    const Range reach = reach_in_u(model, f);
    if (!(reach.length() >= full_turn) || std::abs(reach.low) < 1e-12) continue;
    auto seated = turned(surface, reach.low);
    if (!seated) continue;
    changes.surfaces.emplace(f, GeometryChanges::NewSurface{*seated});
    for (const LoopId l : k.loops(f)) {
      if (k.is_vertex_loop(l)) continue;
      for (const CoedgeId c : k.coedges(l)) {
        if (const Curve2* image = model.pcurve(c)) changes.images.emplace(c, image->translated({-reach.low, 0}));
      }
    }
  }
  return changes;
}

}  // namespace aresta
