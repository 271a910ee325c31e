// SPDX-License-Identifier: Apache-2.0
// Files that a command writes: all of them, or none.
#include <gtest/gtest.h>
#include <unistd.h>

#include "apps/shell.h"

namespace aresta::app {
namespace {

constexpr const char* a_block = "echo 'export(block(1, 2, 3), \"b.brep\")' | aresta run - && ";
constexpr const char* half_way = "aresta cut b.brep --plane 0,0,1,0,0,1 ";

TEST(Outputs, ACutWritesAllItsFiles) {
  const Shell shell("apps_cut");
  const Outcome o = shell(std::string(a_block) + half_way + "--above up.brep --below down.step --section at.brep");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(shell.files(), "at.brep\nb.brep\ndown.step\nup.brep\n");
  EXPECT_EQ(o.out.substr(0, o.out.find(',')), "up.brep: 1 region");
  EXPECT_NE(o.out.find("down.step: 1 region"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("at.brep: 0 regions, 1 face"), std::string::npos) << o.out;
}

TEST(Outputs, ACutThatFailsLeavesNothing) {
  const Shell shell("apps_cut_fails");
  Outcome o = shell(std::string(a_block) + half_way + "--above up.brep --below none/down.brep");
  EXPECT_EQ(o.status, 3);
  EXPECT_EQ(o.err, "aresta: file.unwritable: cannot write none/down.brep: No such file or directory\n");
  EXPECT_EQ(o.out, "");
  EXPECT_EQ(shell.files(), "b.brep\n");
  // A format that nobody knows is found while writing, and so is a full disk.
  for (const char* rest : {"--above up.brep --section at.xyz", "--above up.brep --below /dev/full",
                           "--above up.brep --below - --format brep > /dev/full"}) {
    o = shell(half_way + std::string(rest));
    EXPECT_EQ(o.status == 0 ? rest : "", std::string());
    EXPECT_EQ(o.err.find("/tmp"), std::string::npos) << o.err;
    EXPECT_EQ(shell.files(), "b.brep\n") << rest;
  }
  put(shell.folder() / "up.brep", "old");
  o = shell(half_way + std::string("--above up.brep --below /dev/full"));
  EXPECT_EQ(o.status, 3);
  EXPECT_EQ(text_of(shell.folder() / "up.brep"), "old");
}

TEST(Outputs, TwoNamesOfOneFileAreRefused) {
  const Shell shell("apps_cut_names");
  const Outcome o = shell(std::string(a_block) + half_way + "--above up.brep --below ./up.brep");
  EXPECT_EQ(o.status, 2);
  EXPECT_EQ(o.err, "aresta: usage: cut: './up.brep' is given for two results\n");
}

TEST(Outputs, AreRefusedBeforeTheWorkBegins) {
  const Shell shell("apps_outputs_first");
  put(shell.folder() / "print.ars", "print('it ran')\n");
  const Outcome o = shell("aresta run print.ars --summary-file none/s.json");
  EXPECT_EQ(o.status, 3);
  EXPECT_EQ(o.out, "");
  EXPECT_EQ(o.err, "aresta: file.unwritable: cannot write none/s.json: No such file or directory\n");
  // What is to be read is not even looked at.
  for (const char* command : {"convert missing.step none/a.brep", "mesh missing.step -o none/a.inp",
                              "render missing.step -o none/a.png", "fragment missing.step -o none/a.brep"}) {
    const Outcome refused = shell(std::string("aresta ") + command);
    EXPECT_EQ(refused.status, 3);
    EXPECT_NE(refused.err.find("cannot write none/a."), std::string::npos) << refused.err;
  }
}

}  // namespace
}  // namespace aresta::app
