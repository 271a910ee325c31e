// SPDX-License-Identifier: Apache-2.0
// Blocks on a small lattice, which touch, share and contain each other in every way that blocks can: volumes, areas and
// numbers of regions are counted in unit cubes.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <set>

#include "script/run.h"

namespace aresta::script {
namespace {

using Cube = std::array<int, 3>;
using Cubes = std::set<Cube>;

constexpr int side = 4;

std::vector<Cube> neighbours(Cube c) {
  std::vector<Cube> list;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int step : {-1, 1}) {
      list.push_back(c);
      list.back()[static_cast<std::size_t>(axis)] += step;
    }
  }
  return list;
}

/// Sets of cubes that hang together by faces.
int components(Cubes cubes) {
  int count = 0;
  while (!cubes.empty()) {
    ++count;
    std::vector<Cube> stack{*cubes.begin()};
    cubes.erase(cubes.begin());
    while (!stack.empty()) {
      const Cube c = stack.back();
      stack.pop_back();
      for (const Cube& n : neighbours(c)) {
        if (cubes.erase(n) > 0) stack.push_back(n);
      }
    }
  }
  return count;
}

int area(const Cubes& cubes) {
  int count = 0;
  for (const Cube& c : cubes) {
    for (const Cube& n : neighbours(c)) count += cubes.count(n) == 0;
  }
  return count;
}

struct Shape {
  std::string text;
  Cubes cubes;
};

class Shapes {
 public:
  explicit Shapes(std::uint64_t seed) : random_(seed) {
    for (int i = 0; i < side * side * side; ++i) everywhere_.insert({i % side, i / side % side, i / side / side});
  }

  Shape make(int depth) {
    if (depth == 0 || below(4) == 0) return block();
    const Shape a = make(depth - 1), b = make(depth - 1);
    Shape s;
    const int operation = below(4);
    for (const Cube& c : everywhere_) {
      const bool in_a = a.cubes.count(c) > 0, in_b = b.cubes.count(c) > 0;
      const bool in[] = {in_a || in_b, in_a && in_b, in_a && !in_b, in_a != in_b};
      if (in[operation]) s.cubes.insert(c);
    }
    const char* sign[] = {" + ", " & ", " - "};
    s.text = operation < 3 ? "(" + a.text + sign[operation] + b.text + ")"
                           : "symmetric_difference(" + a.text + ", " + b.text + ", regularise=True)";
    return s;
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }

  Shape block() {
    int low[3], high[3];
    for (int i = 0; i < 3; ++i) {
      low[i] = below(side);
      high[i] = low[i] + 1 + below(side - low[i]);
    }
    Shape s;
    for (int x = low[0]; x < high[0]; ++x) {
      for (int y = low[1]; y < high[1]; ++y) {
        for (int z = low[2]; z < high[2]; ++z) s.cubes.insert({x, y, z});
      }
    }
    const auto three = [](int a, int b, int c) {
      return std::to_string(a) + ", " + std::to_string(b) + ", " + std::to_string(c);
    };
    s.text = "block(" + three(high[0] - low[0], high[1] - low[1], high[2] - low[2]) + ", at=(" +
             three(low[0], low[1], low[2]) + "))";
    return s;
  }

  std::mt19937_64 random_;
  Cubes everywhere_;
};

/// "volume, regions, findings" of a result.
std::string expectation(std::size_t volume, int regions) {
  return "expect([volume(x), count(x), check(x)], [" + std::to_string(volume) + ", " + std::to_string(regions) +
         ", 0])\n";
}

std::string fragment_case(const std::vector<Shape>& shapes) {
  std::map<std::vector<bool>, Cubes> cells;
  std::string list;
  for (const Shape& s : shapes) {
    list += (list.empty() ? "" : ", ") + s.text;
    for (const Cube& c : s.cubes) {
      std::vector<bool> in;
      for (const Shape& other : shapes) in.push_back(other.cubes.count(c) > 0);
      cells[in].insert(c);
    }
  }
  std::size_t volume = 0;
  int regions = 0;
  for (const auto& [in, cubes] : cells) {
    volume += cubes.size();
    regions += components(cubes);
  }
  return "x = fragment(" + list + ")\n" + expectation(volume, regions);
}

TEST(Lattice, BooleansAndFragmentsAreCountedInCubes) {
  constexpr std::uint64_t seed = 3;
  Shapes shapes(seed);
  for (int round = 0; round < 40; ++round) {
    const Shape s = shapes.make(3);
    std::string text = "x = " + s.text + "\n" + expectation(s.cubes.size(), components(s.cubes));
    if (!s.cubes.empty()) text += "expect(area(x), " + std::to_string(area(s.cubes)) + ")\n";
    text += fragment_case({shapes.make(1), shapes.make(1), shapes.make(1)});
    EXPECT_EQ(run_shapes(text).error, "") << "seed " << seed << ", round " << round << ":\n" << text;
  }
}

TEST(Lattice, AVertexMergedTwiceIsNotLost) {
  EXPECT_EQ(run_shapes("p = block(3, 1, 1, at=(1, 3, 2))\n"
                       "q = block(2, 2, 1, at=(1, 1, 2)) + block(2, 3, 1, at=(2, 1, 3))\n"
                       "r = block(1, 2, 1, at=(2, 2, 2))\n"
                       "x = fragment(p, q, r)\n"
                       "expect([volume(x), count(x), check(x)], [13, 5, 0])\n")
                .error,
            "");
}

TEST(Lattice, AnEdgeInTwoFacesOfOnePlaneDividesBoth) {
  EXPECT_EQ(run_shapes("a = block(1, 1, 1, at=(3, 3, 1))\n"
                       "b = block(1, 2, 1, at=(3, 2, 1)) + block(2, 1, 2, at=(2, 3, 2))\n"
                       "c = block(2, 2, 2, at=(2, 2, 1))\n"
                       "x = fragment(a, b, c)\n"
                       "expect([volume(x), count(x), check(x)], [10, 5, 0])\n")
                .error,
            "");
}

}  // namespace
}  // namespace aresta::script
