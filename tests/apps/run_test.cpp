// SPDX-License-Identifier: Apache-2.0
// `aresta run` and the command line: every exit status, every kind of wrong input, one line of error each.
#include <gtest/gtest.h>
#include <unistd.h>

#include "apps/shell.h"

namespace aresta::app {
namespace {

void expect_error(const Outcome& o, int status, const std::string& beginning) {
  EXPECT_EQ(o.status, status) << o.err;
  EXPECT_EQ(o.err.substr(0, beginning.size()), beginning);
  ASSERT_FALSE(o.err.empty());
  EXPECT_EQ(o.err.find('\n'), o.err.size() - 1) << "one line: " << o.err;
}

TEST(Run, PrintsWithSeventeenDigits) {
  const Shell shell("apps_run");
  put(shell.folder() / "a.ars", "print('volume', volume(block(1, 2, 3)), 1 / 3)\n");
  const Outcome o = shell("aresta run a.ars");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(o.out, "volume 6.0 0.33333333333333331\n");
  EXPECT_EQ(o.err, "");
}

TEST(Run, StandardInputAndDefinitions) {
  const Shell shell("apps_run_stdin");
  const Outcome o = shell("echo 'print(n + 1, word, at)' | aresta run - -D n=4 -D word=steel -D 'at=(1, 2)'");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(o.out, "5 steel (1, 2)\n");
}

TEST(Run, ErrorsNameFileAndLine) {
  const Shell shell("apps_run_errors");
  put(shell.folder() / "seven.ars", "\n\n\n\n\n\nx = blok(1, 2, 3)\n");
  expect_error(shell("aresta run seven.ars"), 1,
               "aresta: seven.ars:7:5: script.name: unknown name 'blok'; did you mean 'block'?");
  put(shell.folder() / "size.ars", "x = block(1, -2, 3)\n");
  expect_error(shell("aresta run size.ars"), 1,
               "aresta: size.ars:1:5: command.range: block: dy must be greater than 0, not -2");
  put(shell.folder() / "type.ars", "x = block(1, 2)\n");
  expect_error(shell("aresta run type.ars"), 1,
               "aresta: type.ars:1:5: command.missing_argument: block: 'dz' is missing");
  put(shell.folder() / "name.ars", "x = cylinder(1, 2, hight=3)\n");
  expect_error(shell("aresta run name.ars"), 1,
               "aresta: name.ars:1:5: command.unknown_parameter: cylinder has no parameter 'hight'");
  put(shell.folder() / "text.ars", "x = volume('a')\n");
  expect_error(shell("aresta run text.ars"), 1,
               "aresta: text.ars:1:5: command.type: volume: x must be a shape, not 'a', a text");
  put(shell.folder() / "expect.ars", "expect(volume(block(1, 2, 3)), 7)\n");
  expect_error(shell("aresta run expect.ars"), 1, "aresta: expect.ars:1:1: script.expectation: expected 7, got 6.0");
  put(shell.folder() / "huge.ars", "x = block(1e300, 1, 1)\n");
  expect_error(shell("aresta run huge.ars"), 1, "aresta: huge.ars:1:5: construct.argument");
  put(shell.folder() / "file.ars", "\nx = import_file('missing.step')\n");
  expect_error(shell("aresta run file.ars"), 3, "aresta: file.ars:2:5: file.unreadable: cannot read missing.step");
}

TEST(Run, WhatIsNoScript) {
  const Shell shell("apps_run_no_script");
  expect_error(shell("aresta run missing.ars"), 3,
               "aresta: file.unreadable: cannot read missing.ars: No such file or directory");
  expect_error(shell("aresta run ."), 3, "aresta: file.unreadable: cannot read .: Is a directory");
  expect_error(shell("aresta run /dev/zero"), 3, "aresta: file.unreadable: cannot read /dev/zero: File too large");
  std::string bytes;
  for (int i = 0; i < 4096; ++i) bytes += static_cast<char>(255 - i * 7 % 256);
  put(shell.folder() / "bytes.ars", bytes);
  expect_error(shell("aresta run bytes.ars"), 1, "aresta: bytes.ars:1:1: script.");
}

TEST(Run, WrongUsage) {
  const Shell shell("apps_usage");
  expect_error(shell("aresta"), 2, "aresta: usage: say what to do, as in 'aresta info part.step'; try: aresta --help");
  expect_error(shell("aresta rnu x"), 2,
               "aresta: usage: there is no command 'rnu'; did you mean 'run'?; try: aresta --help");
  expect_error(shell("aresta run"), 2, "aresta: usage: FILE is required; try: aresta run --help");
  expect_error(shell("aresta rnu --help"), 2, "aresta: usage: there is no command 'rnu'; did you mean 'run'?");
  expect_error(shell("aresta --frobnicate"), 2,
               "aresta: usage: the first word is a command, and there is no option '--frobnicate'; try: aresta --help");
  expect_error(shell("aresta run a.ars --colour red"), 2,
               "aresta: usage: there is no option '--colour'; try: aresta run --help");
  expect_error(shell("aresta run a.ars --summary-fil s"), 2,
               "aresta: usage: there is no option '--summary-fil'; did you mean '--summary-file'?");
  expect_error(shell("aresta run a.ars b.ars"), 2, "aresta: usage: nothing more is expected here: b.ars");
  expect_error(shell("aresta run a.ars -D"), 2, "aresta: usage: --define needs a value");
  expect_error(shell("aresta mesh a.step -o a.inp --size many"), 2,
               "aresta: usage: --size: it must be a number, not 'many'");
  expect_error(shell("aresta mesh a.step -o a.inp --order 1.5"), 2,
               "aresta: usage: --order: it must be a whole number, not '1.5'");
  expect_error(shell("echo 'x = 1' > own.ars; aresta run own.ars --summary-file ./own.ars"), 2,
               "aresta: usage: --summary-file './own.ars' is the script itself");
  EXPECT_EQ(text_of(shell.folder() / "own.ars"), "x = 1\n");
  expect_error(shell("aresta run a.ars --threads 0"), 2,
               "aresta: usage: --threads: it must be a whole number from 1 to 1024");
  expect_error(shell("aresta run a.ars --threads many"), 2, "aresta: ");
  expect_error(shell("aresta run a.ars --tolerance -1"), 2,
               "aresta: usage: --tolerance: it must be a number greater than 0");
  expect_error(shell("aresta run a.ars --tolerance nan"), 2,
               "aresta: usage: --tolerance: it must be a number greater than 0");
  expect_error(shell("echo 1 | aresta run - -D 3=4"), 2, "aresta: usage: -D takes name=value");
  expect_error(shell("echo 1 | aresta run - -D for=4"), 2, "aresta: usage: -D takes name=value");
  expect_error(shell("aresta help blokc"), 2, "aresta: usage: there is no command 'blokc'; did you mean 'block'?");
}

TEST(Run, HelpIsForReaders) {
  const Shell shell("apps_help");
  for (const char* command : {"--help", "run --help", "info --help", "check --help", "convert --help",
                              "fragment --help", "boolean --help", "mesh --help", "render --help", "cut --help",
                              "help --help", "help", "help block", "help run", "help mesh", "--version"}) {
    const Outcome o = shell(std::string("aresta ") + command);
    EXPECT_EQ(o.status, 0) << command;
    EXPECT_EQ(o.err, "") << command;
    EXPECT_GT(o.out.size(), 10u) << command;
    EXPECT_EQ(o.out.find("Example") != std::string::npos, std::string(command) != "help" && command[2] != 'v')
        << command;
  }
}

TEST(Run, SummaryFile) {
  const Shell shell("apps_summary");
  put(shell.folder() / "a.ars",
      "print('one')\nx = block(1, 2, 3)\n\ny = x - block(1, 1, 1)\nprint('two', volume(y), end='')\n");
  Outcome o = shell("aresta run a.ars --summary-file s.json --threads 1");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(o.out, "one\ntwo 5.0");
  const std::string json = text_of(shell.folder() / "s.json");
  for (const char* part : {"\"version\"", "\"seconds\"", "\"peak_rss_bytes\"", "\"threads\": 1", "\"line\": 4",
                           "\"command\": \"difference\"", "\"ok\": true", "\"one\"", "\"two 5.0\"", "\"regions\": 1",
                           "\"shells\": 1", "\"volume\": 5.0", "\"findings\": 0"}) {
    EXPECT_NE(json.find(part), std::string::npos) << part << " in " << json;
  }
  // Also when the script fails; and never where it cannot be written.
  put(shell.folder() / "bad.ars", "x = block(1, 1, 1)\ny = sphere(-1)\n");
  o = shell("aresta run bad.ars --summary-file t.json");
  EXPECT_EQ(o.status, 1);
  EXPECT_NE(text_of(shell.folder() / "t.json").find("bad.ars:2:5"), std::string::npos);
  expect_error(shell("aresta run a.ars --summary-file missing/s.json"), 3,
               "aresta: file.unwritable: cannot write missing/s.json");
  // As the output itself.
  o = shell("aresta run a.ars --json");
  EXPECT_EQ(o.status, 0);
  EXPECT_EQ(o.out[0], '{');
}

TEST(Run, OutputThatCannotBeWritten) {
  const Shell shell("apps_output");
  put(shell.folder() / "a.ars", "print(1)\n");
  put(shell.folder() / "many.ars", "for i in range(1000000): print(i)\n");
  expect_error(shell("aresta run a.ars > /dev/full"), 3,
               "aresta: file.unwritable: cannot write to standard output: No space left on device");
  expect_error(shell("aresta run a.ars >&-"), 3,
               "aresta: file.unwritable: cannot write to standard output: it is closed");
  expect_error(shell("aresta --version > /dev/full; true"), 0, "aresta: file.unwritable");
  const Outcome o = shell("(aresta run many.ars; echo $? > status) | head -n 1");
  EXPECT_EQ(o.out, "0\n");
  EXPECT_EQ(text_of(shell.folder() / "status"), "3\n");
  EXPECT_NE(o.err.find("Broken pipe"), std::string::npos);
  expect_error(shell("aresta run - <&-"), 3, "aresta: file.unreadable: cannot read standard input: it is closed");
}

TEST(Run, InterruptsEndIt) {
  const Shell shell("apps_interrupt");
  put(shell.folder() / "loop.ars", "while True: pass\n");
  for (const char* signal : {"INT", "TERM", "HUP"}) {
    const Outcome o = shell(std::string("'") + test::program().string() +
                            "' run loop.ars --summary-file s.json & p=$!; sleep 0.3; kill -" + signal + " $p; wait $p");
    EXPECT_EQ(o.status, 130) << signal << o.err;
    EXPECT_NE(o.err.find("aresta: loop.ars:1:"), std::string::npos) << o.err;
    EXPECT_NE(o.err.find("cancelled"), std::string::npos) << o.err;
  }
}

TEST(Run, AnInterruptSentTwiceIsOne) {
  const Shell shell("apps_interrupt_twice");
  const std::string start = "mkfifo silent.step; '" + test::program().string() + "' info silent.step & p=$!; sleep 1; ";
  const Outcome o = shell(start + "kill -INT $p; kill -INT $p; kill -TERM $p; wait $p");
  EXPECT_EQ(o.status, 130) << o.err;
  EXPECT_NE(o.err.find("aresta: cancelled: "), std::string::npos) << o.err;
}

TEST(Run, AnInterruptStopsALongOperation) {
  const Shell shell("apps_interrupt_operation");
  put(shell.folder() / "long.ars",
      "x = fragment(grid(cylinder(0.7, 1), n=(12, 12, 12), step=(1, 1, 1)))\nexport(x, 'x.brep')\n");  // half a minute
  const Outcome o = shell("'" + test::program().string() + "' run long.ars & p=$!; sleep 1; kill -INT $p; wait $p");
  EXPECT_EQ(o.status, 130) << o.err;
  EXPECT_EQ(shell.files(), "long.ars\n") << "nothing half-written is left";
}

TEST(Run, FullDisk) {
  if (::geteuid() != 0) GTEST_SKIP() << "mounting a small disk needs root";
  const Shell shell("apps_full_disk");
  if (shell("mkdir small && mount -t tmpfs -o size=64k tmpfs small").status != 0)
    GTEST_SKIP() << "no small disk can be mounted here";
  put(shell.folder() / "a.ars",
      "export(fragment(grid(block(1, 1, 1), n=(4, 4, 4), step=(2, 2, 2))), 'small/a.brep')\n");
  const Outcome o = shell("aresta run a.ars; s=$?; ls small | wc -l; umount small; exit $s");
  EXPECT_EQ(o.status, 3) << o.err;
  EXPECT_EQ(o.out, "0\n") << "no half-written file is left";
  EXPECT_NE(o.err.find("No space left on device"), std::string::npos) << o.err;
}

}  // namespace
}  // namespace aresta::app
