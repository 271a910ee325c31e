// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "mesh/linear_mesh.h"
#include "mesh/quality.h"

namespace aresta::mesh {

namespace {

/// Least Jacobian of a curved tetrahedron over that of the straight one.
constexpr double least_jacobian = 0.05;

constexpr int tetra_sides[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};  // VTK's order of mid-side nodes

/// The point of the curve between two parameters that lies half-way along the chord.
Vec3 curve_middle(const Model& model, EdgeId e, double t0, double t1) {
  const Vec3 a = model.edge_point(e, t0), b = model.edge_point(e, t1), chord = b - a, middle = 0.5 * (a + b);
  double t = 0.5 * (t0 + t1);
  for (int i = 0; i < 8; ++i) {
    const CurveJet jet = model.edge_jet(e, t);
    const double slope = dot(jet.d1, chord);
    if (!(slope > 0)) break;
    const double next = t - dot(jet.point - middle, chord) / slope;
    if (!(next > t0 && next < t1)) break;
    if (next == t) break;
    t = next;
  }
  return model.edge_point(e, t);
}

}  // namespace

SecondOrder::SecondOrder(const Model& model, LinearMesh& mesh) : mesh_(mesh), mids_(mesh.nodes.size()) {
  const auto& topology = model.topology();
  for (const EdgeId e : topology.edges()) {
    const EdgeChain& chain = mesh.chains[e.index()];
    const bool straight = model.is_straight(e);
    for (std::size_t i = 1; i < chain.nodes.size(); ++i) {
      const std::uint32_t a = chain.nodes[i - 1], b = chain.nodes[i];
      const Vec3 chord_middle = 0.5 * (mesh.nodes[a] + mesh.nodes[b]);
      add(a, b, straight ? chord_middle : curve_middle(model, e, chain.parameters[i - 1], chain.parameters[i]));
    }
  }
  for (const FaceId f : topology.faces()) {
    if (mesh.faces.empty()) break;
    const LinearFace& face = mesh.faces[f.index()];
    const Surface& surface = model.surface(f);
    const auto position = [&](std::uint32_t node) {
      return static_cast<std::size_t>(std::lower_bound(face.nodes.begin(), face.nodes.end(), node) -
                                      face.nodes.begin());
    };
    for (const auto& t : face.triangles) {
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
        if (known(a, b)) continue;
        const Vec3 middle = 0.5 * (mesh.nodes[a] + mesh.nodes[b]);
        Vec3 best = middle;
        if (!surface.is_plane()) {
          double best_distance = 0.3 * distance(mesh.nodes[a], mesh.nodes[b]);
          for (const bool inner : {true, false}) {
            for (const std::uint32_t node : {a, b, c}) {
              const std::size_t at = position(node);
              if (face.inner[at] != inner) continue;
              const Vec2 hint = face.uv[at];
              const SurfaceProjection found = surface.project(middle, &hint);
              if (found.distance < best_distance) best = found.point, best_distance = found.distance;
            }
          }
        }
        add(a, b, best);
      }
    }
  }
  const std::size_t curved_end = mesh_.nodes.size();
  for (const Tetra& t : mesh.tetras) {
    for (const auto& side : tetra_sides) {
      const std::uint32_t a = t.nodes[side[0]], b = t.nodes[side[1]];
      if (!known(a, b)) add(a, b, 0.5 * (mesh.nodes[a] + mesh.nodes[b]));
    }
  }
  if (curved_end > 0) straighten();
}

bool SecondOrder::known(std::uint32_t a, std::uint32_t b) const {
  const auto& list = mids_[std::min(a, b)];
  return std::any_of(list.begin(), list.end(), [&](const auto& entry) { return entry.first == std::max(a, b); });
}

std::uint32_t SecondOrder::mid(std::uint32_t a, std::uint32_t b) const {
  for (const auto& [other, node] : mids_[std::min(a, b)]) {
    if (other == std::max(a, b)) return node;
  }
  return 0xffffffffu;
}

std::uint32_t SecondOrder::add(std::uint32_t a, std::uint32_t b, Vec3 p) {
  const auto node = static_cast<std::uint32_t>(mesh_.nodes.size());
  mids_[std::min(a, b)].emplace_back(std::max(a, b), node);
  mesh_.nodes.push_back(p);
  return node;
}

/// Halves the bulge of the sides of a bad tetrahedron until it is good; straight sides always are.
void SecondOrder::straighten() {
  std::vector<char> touched(mesh_.nodes.size(), 0);
  for (int round = 0; round < 8; ++round) {
    bool any = false;
    for (const Tetra& t : mesh_.tetras) {
      Vec3 p[10];
      std::uint32_t middle[6];
      double bulge = 0;
      for (int i = 0; i < 4; ++i) p[i] = mesh_.nodes[t.nodes[i]];
      for (int i = 0; i < 6; ++i) {
        middle[i] = mid(t.nodes[tetra_sides[i][0]], t.nodes[tetra_sides[i][1]]);
        p[4 + i] = mesh_.nodes[middle[i]];
        bulge = std::max(bulge, distance(p[4 + i], 0.5 * (p[tetra_sides[i][0]] + p[tetra_sides[i][1]])));
      }
      if (bulge == 0 || tetra10_jacobian(p).least > least_jacobian) continue;
      any = true;
      for (int i = 0; i < 6; ++i) {
        const Vec3 straight = 0.5 * (p[tetra_sides[i][0]] + p[tetra_sides[i][1]]);
        if (mesh_.nodes[middle[i]] == straight) continue;
        if (!touched[middle[i]]) touched[middle[i]] = 1, ++straightened_;
        mesh_.nodes[middle[i]] = round >= 4 ? straight : 0.5 * (mesh_.nodes[middle[i]] + straight);
      }
    }
    if (!any) break;
  }
}

}  // namespace aresta::mesh
