// SPDX-License-Identifier: Apache-2.0
// The limits of storage, held at size: bytes per edge, and bytes copied by a change after a snapshot. Times are
// measured by bench/topology.
//
//   topology_size [SCALE]     SCALE 1 (default): 1,003,520 triangles and 20^3 cubes; 0.01: about a hundredth of them
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "large/large_models.h"
#include "topology/check.h"
#include "topology/operators.h"
#include "topology/polygon_mesh.h"

namespace {

using namespace aresta;

int cases = 0, wrong = 0;

void expect(bool holds, const std::string& what) {
  ++cases;
  std::cout << (holds ? "  " : "wrong: ") << what << '\n';
  if (!holds) ++wrong;
}

void expect_equal(const char* what, std::size_t count, std::size_t expected) {
  expect(count == expected, std::string(what) + " " + std::to_string(count) + " of " + std::to_string(expected));
}

void expect_at_most(const std::string& what, double value, double limit) {
  expect(value <= limit, what + " " + std::to_string(value) + ", at most " + std::to_string(limit));
}

double bytes_per_edge(const Complex& k) {
  return static_cast<double>(k.allocated_bytes()) / static_cast<double>(k.edge_count());
}

void expect_sound(const Complex& k) {
  const auto findings = check_structure(k);
  expect(findings.empty(), std::to_string(findings.size()) + " findings of the checker");
}

/// What the change copies; afterwards it is taken back, and the snapshot must not have seen any of it.
template <class Operator>
void expect_cheap_change(Complex& k, const char* name, Operator&& apply) {
  constexpr double limit = 512 * 1024;
  const Complex snapshot = k;
  const std::size_t edges = k.edge_count();
  expect_equal("bytes that a snapshot copies:", k.bytes_not_shared_with(snapshot), 0);
  auto applied = apply(k);
  if (!applied.ok()) return expect(false, applied.error().to_line());
  expect_at_most(std::string("bytes that ") + name + " copies:", static_cast<double>(k.bytes_not_shared_with(snapshot)),
                 limit);
  expect_equal("edges of the snapshot:", snapshot.edge_count(), edges);
  expect(k.edge_count() != edges, "the change is there");
  take_back(k, *applied);
  expect_equal("edges after taking it back:", k.edge_count(), edges);
}

void measure_sphere(std::uint32_t n) {
  const std::size_t square = std::size_t{n} * n;
  std::cout << "sphere of " << 20 * square << " triangles\n";
  const auto mesh = test::sphere_of_triangles(n);
  auto incidence = incidence_of_triangles(static_cast<std::uint32_t>(mesh.points.size()), mesh.triangles);
  if (!incidence.ok()) return expect(false, incidence.error().to_line());
  enclose_one_region(*incidence);
  auto k = assemble(*incidence);
  if (!k.ok()) return expect(false, k.error().to_line());
  expect_equal("vertices", k->vertex_count(), 10 * square + 2);
  expect_equal("edges", k->edge_count(), 30 * square);
  expect_equal("faces", k->face_count(), 20 * square);
  expect_equal("shells", k->shell_count(), 2);
  expect_equal("regions", k->region_count(), 2);
  expect_at_most("bytes per edge", bytes_per_edge(*k), 110);
  expect_sound(*k);

  const EdgeId edge(k->edge_count() / 2);
  const FaceId face(k->face_count() / 2);
  expect_cheap_change(*k, "ESPLIT", [&](Complex& c) { return esplit(c, edge); });
  expect_cheap_change(*k, "MM_EV", [&](Complex& c) {
    return mm_ev(c, Corner{c.first_coedge(c.first_loop(face)), LoopId()});
  });
  expect_cheap_change(*k, "K_E", [&](Complex& c) { return k_e(c, edge); });
}

void measure_cubes(std::uint32_t n) {
  const std::size_t m = n + 1;
  std::cout << "complex of " << n << "^3 cubes\n";
  auto k = assemble(test::grid_of_cubes(n));
  if (!k.ok()) return expect(false, k.error().to_line());
  expect_equal("vertices", k->vertex_count(), m * m * m);
  expect_equal("edges", k->edge_count(), 3 * n * m * m);
  expect_equal("faces", k->face_count(), 3 * n * n * m);
  expect_equal("shells", k->shell_count(), std::size_t{n} * n * n + 1);
  expect_equal("regions", k->region_count(), std::size_t{n} * n * n + 1);
  expect_at_most("bytes per edge", bytes_per_edge(*k), 170);
  expect_sound(*k);
  expect_cheap_change(*k, "ESPLIT", [](Complex& c) { return esplit(c, EdgeId(c.edge_count() / 2)); });
}

}  // namespace

int main(int count, char** arguments) {
  const double scale = count > 1 ? std::atof(arguments[1]) : 1;
  const auto sphere = static_cast<std::uint32_t>(std::lround(224 * std::sqrt(scale)));
  const auto cubes = static_cast<std::uint32_t>(std::lround(20 * std::cbrt(scale)));
  measure_sphere(sphere);
  measure_cubes(cubes);
  std::cout << "topology_size: seed 0, cases " << cases << ", wrong " << wrong
            << ", refused 0, skipped 0, coverage: " << 20 * std::size_t{sphere} * sphere << " triangles, " << cubes
            << "^3 cubes\n";
  return wrong == 0 ? 0 : 1;
}
