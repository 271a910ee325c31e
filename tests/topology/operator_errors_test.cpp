// SPDX-License-Identifier: Apache-2.0
// What operators refuse: each code of topology/errors.h that is theirs, and the complex stays as it was.
#include <gtest/gtest.h>

#include "topology/dump.h"
#include "topology/notation.h"
#include "topology/operators.h"

namespace aresta {
namespace {

constexpr RegionId infinite = Complex::infinite_region();

Complex model(const char* notation) {
  auto read = parse_notation(notation);
  EXPECT_TRUE(read.ok()) << read.error().to_line();
  return std::move(read).value();
}

template <class Operator>
void expect_refused(const char* notation, const ErrorCode& code, Operator&& apply) {
  Complex k = model(notation);
  const std::string before = dump(k);
  const auto result = apply(k);
  ASSERT_FALSE(result.ok()) << dump(k);
  EXPECT_STREQ(result.error().code.name, code.name) << result.error().to_line();
  EXPECT_FALSE(result.error().message.empty());
  EXPECT_EQ(dump(k), before);
}

FaceSpec face(std::vector<EdgeUseSpec> uses, RegionId region = {}) {
  FaceSpec spec;
  spec.circuits.push_back({std::move(uses), {}});
  spec.region = region;
  return spec;
}
FaceSpec sphere(VertexId v) {
  FaceSpec spec;
  spec.circuits.push_back({{}, v});
  return spec;
}

constexpr const char* sphere_with_points_inside_and_outside =
    "f: 0\nregion inside filled: -f\npoint 1 in inside\npoint 2";

TEST(OperatorErrors, UnknownPart) {
  const VertexId v(7);
  const EdgeId e(7);
  const FaceId f(7);
  const RegionId r(7);
  const auto expect = [](auto apply) { expect_refused("f: 0 1 2 | 3", errors::unknown_part, apply); };
  expect([&](Complex& k) { return m_sv(k, r); });
  expect([&](Complex& k) { return m_ev(k, v); });
  expect([&](Complex& k) { return m_ev(k, VertexId(0), r); });
  expect([&](Complex& k) { return m_e(k, VertexId(0), v); });
  expect([&](Complex& k) { return m_f(k, face({{e, false, {}}})); });
  expect([&](Complex& k) { return m_f(k, sphere(v)); });
  expect([&](Complex& k) { return m_rsfl(k, v); });
  expect([&](Complex& k) { return mm_vl(k, f); });
  expect([&](Complex& k) { return mm_ev(k, {CoedgeId(7), {}}); });
  expect([&](Complex& k) { return mm_ev(k, {}); });
  expect([&](Complex& k) { return mm_e(k, {CoedgeId(0), {}}, {{}, LoopId(7)}); });
  expect([&](Complex& k) { return k_v(k, v); });
  expect([&](Complex& k) { return k_e(k, e); });
  expect([&](Complex& k) { return k_e(k, EdgeId(0), f); });
  expect([&](Complex& k) { return k_f(k, f); });
  expect([&](Complex& k) { return k_f(k, FaceId(0), r); });
  expect([&](Complex& k) { return g_v(k, VertexId(0), v); });
  expect([&](Complex& k) { return g_e(k, e, EdgeId(0)); });
  expect([&](Complex& k) { return g_f(k, {FaceId(0), 0}, {f, 0}, {}); });
  expect([&](Complex& k) { return esplit(k, e); });
  expect([&](Complex& k) { return esqueeze(k, e); });
}

TEST(OperatorErrors, NotInRegion) {
  const auto expect = [](auto apply) {
    expect_refused(sphere_with_points_inside_and_outside, errors::not_in_region, apply);
  };
  const VertexId inner(1), outer(2);
  expect([&](Complex& k) { return m_ev(k, inner, infinite); });
  expect([&](Complex& k) { return m_e(k, inner, outer); });
  expect([&](Complex& k) { return m_rsfl(k, outer, RegionId(1)); });
  expect([&](Complex& k) { return g_v(k, inner, outer); });
  const auto expect_of_wires = [](auto apply) {
    expect_refused("f: 0\nregion inside filled: -f\nwire 0 1 in inside\nwire 0 2", errors::not_in_region, apply);
  };
  const EdgeUseSpec in{EdgeId(0), false, {}}, back{EdgeId(0), true, {}};
  expect_of_wires([&](Complex& k) { return m_f(k, face({in, back}, infinite)); });
  expect_of_wires([](Complex& k) { return g_e(k, EdgeId(0), EdgeId(1)); });
  expect_refused("f: 0\ng: 1\nregion a filled: -f\nregion b empty: -g", errors::not_in_region, [](Complex& k) {
    return g_f(k, {FaceId(0), 1}, {FaceId(1), 1}, {});
  });
  expect_refused("f: 0\ng: 1\nregion a filled: -f\nregion b empty: -g", errors::not_in_region,
                 [](Complex& k) { return k_f(k, FaceId(0), RegionId(2)); });
}

TEST(OperatorErrors, AmbiguousPlace) {
  const char* const in_two_regions = "f: 0\nregion inside filled: -f";
  expect_refused(in_two_regions, errors::ambiguous_place, [](Complex& k) { return m_ev(k, VertexId(0)); });
  expect_refused(in_two_regions, errors::ambiguous_place, [](Complex& k) { return m_e(k, VertexId(0), VertexId(0)); });
  expect_refused(in_two_regions, errors::ambiguous_place, [](Complex& k) { return m_rsfl(k, VertexId(0)); });
  // Two sheets at the wire's edge leave two sectors for a third.
  const char* const two_sheets = "f: 0 1 2\ng: 1 0 3\nwire 0 4 1";
  const EdgeUseSpec circuit[] = {{EdgeId(0), true, {}}, {EdgeId(5), false, {}}, {EdgeId(6), false, {}}};
  expect_refused(two_sheets, errors::ambiguous_place, [&](Complex& k) {
    return m_f(k, face({std::begin(circuit), std::end(circuit)}));
  });
  expect_refused(two_sheets, errors::ambiguous_place, [](Complex& k) { return g_e(k, EdgeId(0), EdgeId(5)); });
}

TEST(OperatorErrors, OpenCircuit) {
  expect_refused("wire 0 1 2", errors::open_circuit, [](Complex& k) {
    return m_f(k, face({{EdgeId(0), false, {}}, {EdgeId(1), false, {}}}));
  });
  expect_refused("wire 0 1", errors::open_circuit, [](Complex& k) { return m_f(k, {}); });
}

TEST(OperatorErrors, WrongPlace) {
  const auto expect = [](const char* notation, auto apply) { expect_refused(notation, errors::wrong_place, apply); };
  const char* const two_triangles = "f: 0 1 2\ng: 3 4 5";
  expect(two_triangles, [](Complex& k) { return mm_ev(k, {{}, LoopId(0)}); });
  expect(two_triangles, [](Complex& k) { return mm_e(k, {CoedgeId(0), {}}, {CoedgeId(3), {}}); });
  const LoopId first(0), second(1);
  expect(two_triangles, [&](Complex& k) {
    return mm_e(k, {CoedgeId(0), {}}, {CoedgeId(1), {}}, std::span(&second, 1));
  });
  expect("f: 0 1 2 | 3", [&](Complex& k) { return mm_e(k, {CoedgeId(0), {}}, {{}, LoopId(1)}, std::span(&first, 1)); });
  const LoopId twice[] = {second, second};
  expect("f: 0 1 2 | 3", [&](Complex& k) { return mm_e(k, {CoedgeId(0), {}}, {CoedgeId(1), {}}, twice); });
  expect(two_triangles, [](Complex& k) { return k_e(k, EdgeId(0), FaceId(1)); });
  expect(two_triangles, [](Complex& k) { return g_v(k, VertexId(0), VertexId(0)); });
  expect(two_triangles, [](Complex& k) { return g_e(k, EdgeId(0), EdgeId(0)); });
  expect(two_triangles, [](Complex& k) { return g_f(k, {FaceId(0), 0}, {FaceId(0), 1}, {}); });
  expect(two_triangles, [](Complex& k) { return g_f(k, {FaceId(0), 0}, {FaceId(1), 1}, {}); });
  expect(two_triangles, [](Complex& k) { return esqueeze(k, EdgeId(0), VertexId(3)); });
  // Loops of three and of two edges.
  const std::pair<CoedgeId, CoedgeId> pair(CoedgeId(0), CoedgeId(3));
  expect("f: 0 1 2\ng: 3 4.1", [&](Complex& k) { return g_f(k, {FaceId(0), 0}, {FaceId(1), 1}, std::span(&pair, 1)); });
  // A closed edge and one that is not.
  expect("wire 0 0\nwire 1 2", [](Complex& k) { return g_e(k, EdgeId(0), EdgeId(1)); });
  // The vertex would be a loop of the face and in another one.
  expect("f: 0 1 2 | 3", [](Complex& k) { return g_v(k, VertexId(0), VertexId(3)); });
  // A use named for another edge, an edge three times in one face, a face at a vertex of its own circuit.
  expect("f: 0 1 2\nwire 0 3 1", [](Complex& k) {
    return m_f(k, face({{EdgeId(0), true, CoedgeId(1)}, {EdgeId(3), false, {}}, {EdgeId(4), false, {}}}));
  });
  expect("wire 0 0", [](Complex& k) {
    return m_f(k, face({{EdgeId(0), false, {}}, {EdgeId(0), true, {}}, {EdgeId(0), false, {}}}));
  });
  expect("wire 0 0", [](Complex& k) {
    FaceSpec spec = face({{EdgeId(0), false, {}}});
    spec.circuits.push_back({{}, VertexId(0)});
    return m_f(k, spec);
  });
  // What the face is made of cannot also go into what it closes off.
  expect("point 0", [](Complex& k) {
    FaceSpec spec = sphere(VertexId(0));
    spec.division.others = {Item(VertexId(0))};
    return m_f(k, spec);
  });
  expect("wire 0 0", [](Complex& k) {
    FaceSpec spec = face({{EdgeId(0), false, {}}});
    spec.division.others = {Item(EdgeId(0))};
    return m_f(k, spec);
  });
  // Nothing is closed off that the point could be inside of.
  expect("wire 0 0\npoint 1", [](Complex& k) {
    FaceSpec spec = face({{EdgeId(0), false, {}}});
    spec.division.others = {Item(VertexId(1))};
    return m_f(k, spec);
  });
}

TEST(OperatorErrors, InUse) {
  expect_refused("point 0", errors::in_use, [](Complex& k) { return m_sv(k, infinite, VertexId(0)); });
  expect_refused("point 0", errors::in_use, [](Complex& k) { return m_sv(k, infinite, VertexId(5)); });
  expect_refused("point 0", errors::in_use, [](Complex& k) { return k_m(k); });
  expect_refused("f: 0\nregion inside filled: -f", errors::in_use,
                 [](Complex& k) { return k_f(k, FaceId(0), RegionId(1)); });
}

TEST(OperatorErrors, WouldPinch) {
  expect_refused("f: 0.0", errors::would_pinch, [](Complex& k) { return esqueeze(k, EdgeId(0)); });
  // A point between the faces would have nowhere to be.
  expect_refused("f: 0.0\ng: 0.0-\nregion inside filled: -f\npoint 1 in inside", errors::would_pinch, [](Complex& k) {
    const std::pair<CoedgeId, CoedgeId> pair(CoedgeId(0), CoedgeId(1));
    return g_f(k, {FaceId(0), 1}, {FaceId(1), 1}, std::span(&pair, 1));
  });
}

TEST(OperatorErrors, SensesDisagree) {
  expect_refused("f: 0 1.1\ng: 0 1.2", errors::senses_disagree, [](Complex& k) {
    const std::pair<CoedgeId, CoedgeId> pair(CoedgeId(0), CoedgeId(2));
    return g_f(k, {FaceId(0), 0}, {FaceId(1), 0}, std::span(&pair, 1));
  });
}

TEST(OperatorErrors, CutsWire) {
  // Of two wires between the same vertices a sphere at one cannot have one inside and the other outside.
  expect_refused("wire 0 1\nwire 0.1 1", errors::cuts_wire, [](Complex& k) {
    FaceSpec spec = sphere(VertexId(1));
    spec.division.others = {Item(EdgeId(0))};
    return m_f(k, spec);
  });
}

/// A wire from the inside of one face that looks into the space around both: nothing of that space is left there.
TEST(OperatorErrors, GluingFacesCutsNoWire) {
  expect_refused("f: 0.0 0.1\ng: 0.0- 0 1\nh: 0.1- 0 2\nregion inside filled: -f -g -h\nwire 1 3 0", errors::cuts_wire,
                 [](Complex& k) {
                   const std::pair<CoedgeId, CoedgeId> pair(CoedgeId(3), CoedgeId(7));
                   return g_f(k, {FaceId(1), 0}, {FaceId(2), 0}, std::span(&pair, 1));
                 });
}

TEST(OperatorErrors, NoSpace) {
  // Four sheets about vertex 4 and one across; another across the other way, on the same side, would pass through it.
  const char* const pyramid =
      "p: 4 0 1\nq: 4 1 2\nr: 4 2 3\ns: 4 3 0\nt: 4 0 2\nabout 4 0: p s t\nabout 4 2: r q t\nwire 1 3";
  int refused = 0, made = 0;
  Complex k = model(pyramid);
  const auto edge = [&](std::size_t a, std::size_t b) {
    for (const EdgeId e : k.edges()) {
      if (k.start(e) == VertexId(a) && k.end(e) == VertexId(b)) return EdgeUseSpec{e, false, {}};
      if (k.start(e) == VertexId(b) && k.end(e) == VertexId(a)) return EdgeUseSpec{e, true, {}};
    }
    ADD_FAILURE() << a << " to " << b;
    return EdgeUseSpec{};
  };
  const EdgeUseSpec out = edge(4, 1), across = edge(1, 3), back = edge(3, 4);
  for (const CoedgeId a : k.coedges(out.edge)) {
    for (const CoedgeId b : k.coedges(back.edge)) {
      const std::string before = dump(k);
      EdgeUseSpec first = out, last = back;
      first.after = a;
      last.after = b;
      auto applied = m_f(k, face({first, across, last}));
      if (applied.ok()) {
        ++made;
        take_back(k, *applied);
      } else {
        ++refused;
        EXPECT_STREQ(applied.error().code.name, errors::no_space.name) << applied.error().to_line();
      }
      EXPECT_EQ(dump(k), before);
    }
  }
  // Of the four choices of sectors only both on the other side have room.
  EXPECT_EQ(made, 1);
  EXPECT_EQ(refused, 3);
}

}  // namespace
}  // namespace aresta
