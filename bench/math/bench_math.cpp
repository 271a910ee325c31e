// SPDX-License-Identifier: Apache-2.0
// What each stage of the exact arithmetic costs: the double filter alone, and the filter that fails with the integers
// after it. Inputs take turns, so that branches and caches are as in use; a benchmark whose inputs are not all decided
// by its stage ends in an error. The options are those of Google Benchmark.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "math/exact_points.h"

namespace {

using namespace aresta;

constexpr std::size_t inputs = 1024;
enum class Stage { filter, exact };

struct Case {
  ExactPlane p, q, r;
  LatticePoint a, b, in_p;
};

/// Planes through random triangles, as long as the range, and a point of the first that is none of its vertices.
std::vector<Case> make_cases() {
  std::mt19937_64 random(1);
  const auto point = [&] {
    LatticePoint result;
    for (auto& x : result) x = static_cast<std::int64_t>(random() % (Lattice::range / 2)) - Lattice::range / 4;
    return result;
  };
  const auto plane = [&](const LatticePoint& a) {
    const LatticePoint b = point(), c = point();
    return *plane_through(a, b, c);
  };
  std::vector<Case> cases;
  while (cases.size() < inputs) {
    const LatticePoint o = point(), u = point(), v = point(), a = point(), b = point(), c = point(), d = point();
    // The fourth corner of a parallelogram.
    const LatticePoint in_p{u[0] + v[0] - o[0], u[1] + v[1] - o[1], u[2] + v[2] - o[2]};
    cases.push_back({*plane_through(o, u, v), plane(a), plane(b), c, d, in_p});
  }
  return cases;
}

/// Runs `decide` on the cases in turn; all must be decided by `stage`.
template <class Decide>
void run(benchmark::State& state, Stage stage, Decide decide) {
  const std::vector<Case> cases = make_cases();
  Stages stages;
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(decide(cases[i], stages));
    i = (i + 1) % inputs;
  }
  const std::uint64_t others = stage == Stage::filter ? stages.exact : stages.filter;
  // Random inputs may hold a nearly parallel pair.
  if (others * 100 > stages.filter + stages.exact) state.SkipWithError("the other stage decided");
}

const Lattice lattice(-51);
// In units of a model of size one: what an engine asks for, and what makes the filter give up.
constexpr double usual = 1e-9, all_bits = 0;

void side_of(benchmark::State& state, Stage stage) {
  run(state, stage,
      [&](const Case& c, Stages& stages) { return side(c.p, stage == Stage::filter ? c.a : c.in_p, stages); });
}
void order_along_line(benchmark::State& state, Stage stage) {
  run(state, stage, [&](const Case& c, Stages& stages) {
    // The same plane twice is met in one point, which no filter can prove.
    return compare_along_line(c.a, c.b, c.p, stage == Stage::filter ? c.q : c.p, stages).has_value();
  });
}
void line_plane(benchmark::State& state, Stage stage) {
  const double precision = stage == Stage::filter ? usual : all_bits;
  run(state, stage,
      [&](const Case& c, Stages& stages) { return line_plane_point(c.a, c.b, c.p, lattice, precision, stages)->x; });
}
void three_planes(benchmark::State& state, Stage stage) {
  const double precision = stage == Stage::filter ? usual : all_bits;
  run(state, stage,
      [&](const Case& c, Stages& stages) { return three_plane_point(c.p, c.q, c.r, lattice, precision, stages)->x; });
}
void make_plane(benchmark::State& state) {
  const std::vector<Case> cases = make_cases();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(plane_through(cases[i].a, cases[i].b, cases[i].in_p));
    i = (i + 1) % inputs;
  }
}

BENCHMARK(make_plane);
BENCHMARK_CAPTURE(side_of, filter, Stage::filter);
BENCHMARK_CAPTURE(side_of, exact, Stage::exact);
BENCHMARK_CAPTURE(order_along_line, filter, Stage::filter);
BENCHMARK_CAPTURE(order_along_line, exact, Stage::exact);
BENCHMARK_CAPTURE(line_plane, filter, Stage::filter);
BENCHMARK_CAPTURE(line_plane, exact, Stage::exact);
BENCHMARK_CAPTURE(three_planes, filter, Stage::filter);
BENCHMARK_CAPTURE(three_planes, exact, Stage::exact);

}  // namespace

BENCHMARK_MAIN();
