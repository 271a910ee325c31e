// SPDX-License-Identifier: Apache-2.0
// The operators as commands: what they give, undo and redo, and what they say about wrong arguments.
#include <gtest/gtest.h>

#include "document/commands.h"
#include "run.h"

namespace aresta::script {
namespace {

Ran run_commands(const std::string& text) {
  static const document::Registry registry = [] {
    document::Registry r;
    register_language(r);
    document::register_modelling(r);
    return r;
  }();
  return run_text(text, document::Digits::shortest, nullptr, registry);
}

TEST(ScriptTopology, OperatorsGiveNumbersAndSubCases) {
  const Ran ran = run_commands(R"(m = m_mr()
v = m_sv(m, 0)
e, w = m_ev(m, v)
print(v, e, w, m_e(m, w, v))
print(m_f(m, "e0 e1"), m_f(m, "-e1 -e0", side=1))
print(count(m), count(m, "shells"), count(m, "faces"), count(m, "edges"), count(m, "vertices"), check(m), betti(m))
print(esplit(m, 0), mm_ev(m, "c0"), mm_vl(m, 1))
print(k_e(m, 1), k_v(m, 3))
print(undo(m), undo(m), redo(m))
)");
  EXPECT_EQ(ran.error, "");
  EXPECT_EQ(ran.printed,
            "0 0 1 1\n(0, None) (1, 1)\n1 1 2 2 2 0 (1, 0, 1)\n(2, 2) (3, 3) (4, 2)\nkefl kve\n"
            "K_V kve K_E kefl K_E kefl\n");
}

TEST(ScriptTopology, DumpsAreReadBack) {
  const Ran ran = run_commands(R"(b = block(1, 2, 3)
m = read_complex(dump(b))
assert dump(m) == dump(b)
assert dump(read_complex(dump(b, "json"), "json")) == dump(b)
print(count(m, "faces"), k_f(m, 0), count(b, "faces"))
)");
  EXPECT_EQ(ran.error, "");
  EXPECT_EQ(ran.printed, "6 kflrs 6\n");
}

TEST(ScriptTopology, WrongArgumentsAreNamedAndNothingChanges) {
  const std::string start = "m = m_mr()\na = m_sv(m, 0)\nb = m_sv(m, 0)\n";
  const auto error = [&](const std::string& line) { return run_commands(start + line + "\n").error; };
  EXPECT_NE(error("m_sv(m, 7)").find("topology.unknown_entity: there is no region 7"), std::string::npos);
  EXPECT_NE(error("m_ev(m, 5)").find("topology.unknown_entity: there is no vertex 5"), std::string::npos);
  EXPECT_NE(error("m_f(m, \"e0\")").find("there is no edge 0"), std::string::npos);
  EXPECT_NE(error("m_f(m, \"0 1\")").find("command.type: m_f: circuits must be"), std::string::npos);
  EXPECT_NE(error("m_f(m, \"\")").find("circuits must be"), std::string::npos);
  EXPECT_NE(error("m_f(m, \"v0 e1\")").find("circuits must be"), std::string::npos);
  EXPECT_NE(error("mm_ev(m, \"x\")").find("corner must be"), std::string::npos);
  EXPECT_NE(error("mm_ev(m, \"c99999999999\")").find("corner must be"), std::string::npos);
  EXPECT_NE(error("m_sv(block(1, 1, 1), 0)").find("must be a complex"), std::string::npos);
  EXPECT_NE(error("m_sv(m, -1)").find("command.range"), std::string::npos);
  EXPECT_NE(error("k_m(m)").find("topology.in_use: the model still holds 2 vertices"), std::string::npos);
  EXPECT_NE(error("undo(m_mr())").find("no operator"), std::string::npos);
  EXPECT_NE(error("redo(m)").find("nothing was undone"), std::string::npos);
  EXPECT_NE(error("read_complex(\"nonsense\")").find("topology."), std::string::npos);
  EXPECT_NE(error("volume(m)").find("volume"), std::string::npos);
  EXPECT_NE(error("g_f(m, 0, 0, 1, 0, [1])").find("pairs"), std::string::npos);
}

}  // namespace
}  // namespace aresta::script
