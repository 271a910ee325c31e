// SPDX-License-Identifier: Apache-2.0
// Each sub-case of each operator on a smallest model: a row of operator_cases.h, which is found by the test's name.
#include "topology/operators.h"

#include <gtest/gtest.h>

#include <string_view>

#include "operator_cases.h"
#include "outline.h"
#include "topology/check.h"
#include "topology/dump.h"
#include "topology/notation.h"

namespace aresta {
namespace {

std::string findings(const Complex& k) {
  std::string text;
  for (const auto& finding : check_structure(k, StructureLevel::full)) text += describe(finding) + "\n";
  return text;
}

VertexId v(std::size_t i) {
  return VertexId(i);
}
EdgeId e(std::size_t i) {
  return EdgeId(i);
}
FaceId f(std::size_t i) {
  return FaceId(i);
}
Corner at(std::size_t coedge) {
  return {CoedgeId(coedge), {}};
}
Corner at_point(std::size_t loop) {
  return {{}, LoopId(loop)};
}

EdgeUseSpec along(EdgeId edge) {
  return {edge, false, {}};
}
EdgeUseSpec against(EdgeId edge) {
  return {edge, true, {}};
}

/// A face spec of circuits of edges.
FaceSpec face(std::vector<std::vector<EdgeUseSpec>> circuits) {
  FaceSpec spec;
  for (auto& uses : circuits) spec.circuits.push_back({std::move(uses), {}});
  return spec;
}

class Operators : public testing::Test {
 protected:
  void start(const char* notation) {
    auto read = parse_notation(notation);
    ASSERT_TRUE(read.ok()) << read.error().to_line();
    k = std::move(read).value();
    before_ = dump(k);
  }

  /// The operator, just applied, did what the row says, left this, and is taken back and made again.
  void gives(Result<Applied> result, std::string_view after) {
    ASSERT_TRUE(result.ok()) << result.error().to_line();
    applied = std::move(result).value();
    const OperatorCase* row = this->row();
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(applied.name, row->name);
    ASSERT_EQ(applied.sub_case, row->sub_case);
    EXPECT_EQ(applied.change, row->change);
    EXPECT_EQ(findings(k), "");
    EXPECT_EQ(outline(k), after);
    const std::string now = dump(k);
    EXPECT_NE(now, before_);
    take_back(k, applied);
    ASSERT_EQ(dump(k), before_);
    EXPECT_EQ(findings(k), "");
    make_again(k, applied);
    ASSERT_EQ(dump(k), now);
    EXPECT_EQ(findings(k), "");
    reached_ = true;
    reversed_ = std::string_view(row->inverse) == "take_back";
  }

  /// The inverse operator, just applied, is the one of the row and led back to the same dump.
  void reversed_by(Result<Applied> result) {
    ASSERT_TRUE(result.ok()) << result.error().to_line();
    ASSERT_NE(row(), nullptr);
    EXPECT_EQ(result->name + " " + result->sub_case, row()->inverse);
    EXPECT_EQ(dump(k), before_);
    reversed_ = true;
  }

  void TearDown() override {
    EXPECT_TRUE(reached_) << "the sub-case was not reached";
    EXPECT_TRUE(reversed_) << "the inverse was not tried";
  }

  static const OperatorCase* row() {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    for (const OperatorCase& row : operator_cases()) {
      if (row.test() == test) return &row;
    }
    return nullptr;
  }

  Complex k;
  Applied applied;
  bool reached_ = false, reversed_ = false;

 private:
  std::string before_;
};

constexpr const char* sphere_of_two_discs = "f: 0.0\ng: 0.0-\nregion inside filled: -f";

// --- constructive

TEST_F(Operators, M_MR_mmr) {
  k = m_mr();
  EXPECT_EQ(findings(k), "");
  EXPECT_EQ(outline(k), "r0:");
  EXPECT_EQ(k.region_count(), 1u);
  reached_ = true;
  reversed_ = k_m(k).ok();
}

TEST_F(Operators, M_SV_msv) {
  start("");
  gives(m_sv(k, Complex::infinite_region()), "r0: v0");
  reversed_by(k_v(k, applied.vertex));
}

TEST_F(Operators, M_RSFL_mrsfl) {
  start("point 0");
  gives(m_rsfl(k, v(0)), "r0: +f0; r1: -f0; f0: v0");
  reversed_by(k_f(k, applied.face));
}

TEST_F(Operators, M_EV_mev) {
  start("point 0");
  gives(m_ev(k, v(0)), "r0: e0; e0: v0 v1");
  reversed_by(k_v(k, applied.vertex));
}

TEST_F(Operators, M_E_me) {
  start("wire 0 1 2");
  gives(m_e(k, v(2), v(0)), "r0: e0 e1 e2; e0: v0 v1; e1: v1 v2; e2: v2 v0");
  reversed_by(k_e(k, applied.edge));
}

TEST_F(Operators, M_E_meks) {
  start("point 0 1");
  gives(m_e(k, v(0), v(1)), "r0: e0; e0: v0 v1");
  reversed_by(k_e(k, applied.edge));
}

TEST_F(Operators, M_F_mfl) {
  start("wire 0 1 2 0");
  gives(m_f(k, face({{along(e(0)), along(e(1)), along(e(2))}})),
        "r0: +f0 -f0; f0: +e0 +e1 +e2; e0: v0 v1; e1: v1 v2; e2: v2 v0");
  reversed_by(k_f(k, applied.face));
}

TEST_F(Operators, M_F_mflrs) {
  start("f: 0.0");
  gives(m_f(k, face({{against(e(0))}})), "r0: +f0 +f1; r1: -f0 -f1; f0: +e0; f1: -e0; e0: v0 v0");
  reversed_by(k_f(k, applied.face));
}

TEST_F(Operators, M_F_mflks) {
  start("wire 0 0\nwire 1 1");
  gives(m_f(k, face({{along(e(0))}, {against(e(1))}})), "r0: +f0 -f0; f0: +e0, -e1; e0: v0 v0; e1: v1 v1");
  reversed_by(k_f(k, applied.face));
}

TEST_F(Operators, MM_VL_mvl) {
  start("f: 0.0");
  gives(mm_vl(k, f(0)), "r0: +f0 -f0; f0: +e0, v1; e0: v0 v0");
  reversed_by(k_v(k, applied.vertex));
}

TEST_F(Operators, MM_EV_mev) {
  start("f: 0.0");
  gives(mm_ev(k, at(0)), "r0: +f0 -f0; f0: +e0 +e1 -e1; e0: v0 v0; e1: v0 v1");
  reversed_by(k_v(k, applied.vertex));
}

TEST_F(Operators, MM_E_mefl) {
  start("f: 0 1.1");
  gives(mm_e(k, at(0), at(1)), "r0: +f0 -f0 +f1 -f1; f0: +e1 +e2; f1: +e0 -e2; e0: v0 v1; e1: v1 v0; e2: v0 v1");
  reversed_by(k_e(k, applied.edge));
}

TEST_F(Operators, MM_E_mekl) {
  start("f: 0.0 | 1");
  gives(mm_e(k, at(0), at_point(1)), "r0: +f0 -f0; f0: +e0 +e1 -e1; e0: v0 v0; e1: v0 v1");
  reversed_by(k_e(k, applied.edge));
}

// --- destructive

TEST_F(Operators, K_V_kvs) {
  start("point 0");
  gives(k_v(k, v(0)), "r0:");
  reversed_by(m_sv(k, Complex::infinite_region()));
}

TEST_F(Operators, K_V_kve) {
  start("wire 0 1");
  gives(k_v(k, v(1)), "r0: v0");
  reversed_by(m_ev(k, v(0)));
}

TEST_F(Operators, K_V_kvl) {
  start("f: 0.0 | 1");
  gives(k_v(k, v(1)), "r0: +f0 -f0; f0: +e0; e0: v0 v0");
  reversed_by(mm_vl(k, f(0)));
}

TEST_F(Operators, K_V_kvlms) {
  start("f: 0.0 | 2\ng: 1.0 | 2");
  gives(k_v(k, v(2)), "r0: +f0 -f0, +f1 -f1; f0: +e0; f1: +e1; e0: v0 v0; e1: v1 v1");
}

TEST_F(Operators, K_V_kvfle) {
  start("f: 0 1.1");
  gives(k_v(k, v(1)), "r0: v0");
}

TEST_F(Operators, K_V_kvsfle) {
  start("f: 0.0");
  gives(k_v(k, v(0)), "r0:");
}

TEST_F(Operators, K_V_kvrsfl) {
  start("f: 0\nregion inside filled: -f");
  gives(k_v(k, v(0)), "r0:");
}

TEST_F(Operators, K_V_kvrsfle) {
  start(sphere_of_two_discs);
  gives(k_v(k, v(0)), "r0:");
}

TEST_F(Operators, K_E_ke) {
  start("wire 0 1 2 0");
  gives(k_e(k, e(2)), "r0: e0 e1; e0: v0 v1; e1: v1 v2");
  reversed_by(m_e(k, v(2), v(0)));
}

TEST_F(Operators, K_E_kems) {
  start("wire 0 1");
  gives(k_e(k, e(0)), "r0: v0, v1");
  reversed_by(m_e(k, v(0), v(1)));
}

TEST_F(Operators, K_E_keml) {
  start("f: 0.0 0.1 1.1");
  gives(k_e(k, e(1)), "r0: +f0 -f0; f0: +e0, v1; e0: v0 v0");
  reversed_by(mm_e(k, at(0), at_point(1)));
}

TEST_F(Operators, K_E_kefl) {
  start("f: 0.1 1.2\ng: 0 1.1");
  gives(k_e(k, e(0)), "r0: +f0 -f0; f0: +e1 +e2; e1: v1 v0; e2: v0 v1");
  reversed_by(mm_e(k, at(2), at(1)));
}

TEST_F(Operators, K_E_keflms) {
  start("f: 0.0 | 1.0-");
  gives(k_e(k, e(0)), "r0: e1, v0; e1: v1 v1");
}

TEST_F(Operators, K_F_kfl) {
  start("f: 0.0");
  gives(k_f(k, f(0)), "r0: e0; e0: v0 v0");
  reversed_by(m_f(k, face({{along(e(0))}})));
}

TEST_F(Operators, K_F_kflms) {
  start("f: 0.0 | 1.0-");
  gives(k_f(k, f(0)), "r0: e0, e1; e0: v0 v0; e1: v1 v1");
  reversed_by(m_f(k, face({{along(e(0))}, {against(e(1))}})));
}

TEST_F(Operators, K_F_kflrs) {
  start(sphere_of_two_discs);
  gives(k_f(k, f(1)), "r0: +f0 -f0; f0: +e0; e0: v0 v0");
  FaceSpec spec = face({{against(e(0))}});
  spec.division.filled = true;
  reversed_by(m_f(k, spec));
}

TEST_F(Operators, K_M_kmr) {
  start("");
  EXPECT_TRUE(k_m(k).ok());
  reached_ = true;
  reversed_ = dump(k) == dump(m_mr());
}

// --- gluing

TEST_F(Operators, G_V_gvksv) {
  start("point 0 1");
  gives(g_v(k, v(0), v(1)), "r0: v0");
}

TEST_F(Operators, G_V_gvkv) {
  start("wire 0 1 2");
  gives(g_v(k, v(0), v(2)), "r0: e0 e1; e0: v0 v1; e1: v1 v0");
}

TEST_F(Operators, G_E_geke) {
  start("wire 0 1\nwire 0.1 1");
  gives(g_e(k, e(0), e(1)), "r0: e0; e0: v0 v1");
}

TEST_F(Operators, G_E_gekfle) {
  start("f: 0 1.1");
  gives(g_e(k, e(0), e(1)), "r0: e0; e0: v0 v1");
}

TEST_F(Operators, G_E_gekev) {
  start("wire 0 1\nwire 0 2");
  gives(g_e(k, e(0), e(1)), "r0: e0; e0: v0 v1");
}

TEST_F(Operators, G_E_geksev) {
  start("wire 0 1\nwire 2 3");
  gives(g_e(k, e(0), e(1)), "r0: e0; e0: v0 v1");
}

TEST_F(Operators, G_F_gfksflev) {
  start("f: 0.0\ng: 1.0");
  const std::pair<CoedgeId, CoedgeId> pairs[] = {{CoedgeId(0), CoedgeId(1)}};
  gives(g_f(k, {f(0), 0}, {f(1), 1}, pairs), "r0: +f0 -f0; f0: +e0; e0: v0 v0");
}

TEST_F(Operators, G_F_gfkflev) {
  start("f: 0 1.1\ng: 0 2.1");
  const std::pair<CoedgeId, CoedgeId> pairs[] = {{CoedgeId(0), CoedgeId(2)}};
  gives(g_f(k, {f(0), 0}, {f(1), 1}, pairs), "r0: +f0 -f0; f0: +e0 +e1; e0: v0 v1; e1: v1 v0");
}

// --- composed

TEST_F(Operators, ESPLIT_mev) {
  start("wire 0 1");
  gives(esplit(k, e(0)), "r0: e0 e1; e0: v0 v2; e1: v2 v1");
  reversed_by(esqueeze(k, applied.edge, v(1)));
}

TEST_F(Operators, ESQUEEZE_kev) {
  start("wire 0 1 2");
  gives(esqueeze(k, e(1), v(2)), "r0: e0; e0: v0 v2");
  reversed_by(esplit(k, e(0)));
}

TEST_F(Operators, ESQUEEZE_ke) {
  start("wire 0 0");
  gives(esqueeze(k, e(0)), "r0: v0");
  reversed_by(m_e(k, v(0), v(0)));
}

}  // namespace
}  // namespace aresta
