// SPDX-License-Identifier: Apache-2.0
// Random bytes, random tokens and damaged scripts: every one either runs or is refused with an error that has a place.
#include <gtest/gtest.h>

#include <random>
#include <thread>

#include "run.h"

namespace aresta::script {
namespace {

/// Runs with a limit of time: random loops may be endless.
void try_script(const std::string& text) {
  std::atomic<bool> cancel = false;
  std::atomic<bool> done = false;
  std::thread watch([&] {
    for (int i = 0; i < 100 && !done; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    cancel = true;
  });
  const Ran ran = run_text(text, document::Digits::shortest, &cancel);
  done = true;
  watch.join();
  if (!ran.error.empty()) {
    EXPECT_EQ(ran.error.substr(0, 6), "t.ars:") << ran.error << "\n" << text;
  }
}

const char* const pieces[] = {"x",
                              "y",
                              "abs",
                              "print",
                              "range",
                              "len",
                              "sorted",
                              "1",
                              "2.5",
                              "'s'",
                              "\"t\"",
                              "f'{x}'",
                              "None",
                              "True",
                              "False",
                              "pi",
                              "(",
                              ")",
                              "[",
                              "]",
                              "{",
                              "}",
                              ",",
                              ":",
                              ";",
                              ".",
                              "=",
                              "==",
                              "+=",
                              "-",
                              "+",
                              "*",
                              "**",
                              "//",
                              "%",
                              "&",
                              "<",
                              ">=",
                              "in",
                              "not",
                              "is",
                              "and",
                              "or",
                              "if",
                              "else",
                              "elif",
                              "for",
                              "while",
                              "\n",
                              "\n ",
                              "\n  ",
                              "\t",
                              "break",
                              "pass",
                              "continue",
                              "assert",
                              "def",
                              "from aresta import *",
                              "\\\n",
                              "#c\n",
                              " ",
                              "9223372036854775807",
                              ".append(x)",
                              "x = [1, 2]\n",
                              "for x in y:\n  ",
                              "[x for x in ",
                              "1e308",
                              "expect(",
                              "key=",
                              "@",
                              "0x",
                              "'''"};

TEST(Fuzz, RandomBytes) {
  std::mt19937 random(20240607);
  for (int n = 0; n < 3000; ++n) {
    std::string text(random() % 60, ' ');
    for (char& c : text) c = static_cast<char>(random() % 256);
    try_script(text);
  }
}

TEST(Fuzz, RandomPrintableCharacters) {
  std::mt19937 random(7);
  for (int n = 0; n < 3000; ++n) {
    std::string text(random() % 40, ' ');
    for (char& c : text) c = static_cast<char>(random() % 97 == 0 ? '\n' : 32 + random() % 95);
    try_script(text);
  }
}

TEST(Fuzz, RandomTokens) {
  std::mt19937 random(11);
  for (int n = 0; n < 6000; ++n) {
    std::string text;
    for (unsigned i = 0; i < 1 + random() % 25; ++i) {
      text += pieces[random() % std::size(pieces)];
      if (random() % 3 == 0) text += " ";
    }
    try_script(text);
  }
}

TEST(Fuzz, DamagedScript) {
  const std::string whole =
      "from aresta import *\nn = 4\npoints = [(cos(90 * i), sin(90 * i), 0) for i in range(n)]\nfor i, (x, y, z) in "
      "enumerate(points):\n"
      "    if x > 0.5 and not y < -0.5:\n        print(f'{i}: {x:.3f}', y, sep=\", \")\n    else:\n        n += i ** 2 "
      "// 3\n"
      "assert len(points[1:]) == 3, 'text'\nexpect(sum([p[0] for p in points]), 0, abs=1e-9)\n";
  ASSERT_EQ(run_text(whole).error, "");
  std::mt19937 random(3);
  for (int n = 0; n < 4000; ++n) {
    std::string text = whole;
    for (unsigned k = 0; k <= random() % 3; ++k) {
      const std::size_t at = random() % text.size();
      switch (random() % 4) {
        case 0:
          text.erase(at, 1 + random() % 5);
          break;
        case 1:
          text.insert(at, pieces[random() % std::size(pieces)]);
          break;
        case 2:
          text[at] = static_cast<char>(random() % 256);
          break;
        default:
          text.resize(at + 1);
          break;
      }
    }
    try_script(text);
  }
}

}  // namespace
}  // namespace aresta::script
