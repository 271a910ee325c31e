// SPDX-License-Identifier: Apache-2.0
// Every error with its place: a script and the beginning of the line that is reported.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "run.h"

namespace aresta::script {
namespace {

struct Row {
  std::string script;
  std::string error;
};

std::string times(const char* text, int n) {
  std::string out;
  for (int i = 0; i < n; ++i) out += text;
  return out;
}

std::vector<Row> rows() {
  return {
      // Text that is no script.
      {"x = 1\ny = (2,\n3", "t.ars:2:5: script.syntax: '(' is never closed"},
      {"x = 1)", "t.ars:1:6: script.syntax: ')' closes nothing"},
      {"x = (1\n]", "t.ars:2:1: script.syntax: ']' does not match '(' of line 1"},
      {"x = 'abc\ny = 2", "t.ars:1:5: script.syntax: the string is never closed"},
      {"x = '''abc\ny = 2", "t.ars:1:5: script.syntax: the string is never closed"},
      {"x = 1 +", "t.ars:1:8: script.syntax: expected a value, not the end of the line"},
      {"x = ", "t.ars:1:5: script.syntax: expected a value, not the end of the line"},
      {"1 2", "t.ars:1:3: script.syntax: a number is not expected here"},
      {"block 3 5",
       "t.ars:1:7: script.syntax: a number is not expected here; try: a command's arguments in brackets, as in name(1, "
       "2)"},
      {"print x",
       "t.ars:1:7: script.syntax: 'x' is not expected here; try: a command's arguments in brackets, as in name(1, 2)"},
      {"x = 3x", "t.ars:1:5: script.syntax: this is no number"},
      {"x = 012", "t.ars:1:5: script.syntax: a whole number does not start with 0"},
      {"x = 0x", "t.ars:1:5: script.syntax: this is no number"},
      {"x = 1__0", "t.ars:1:5: script.syntax: this is no number"},
      {"x = $", "t.ars:1:5: script.syntax: unexpected character '$'"},
      {"x = é", "t.ars:1:5: script.syntax: unexpected character 'é'"},
      {"x = '\\x4'", "t.ars:1:5: script.syntax: the escape \\x in this string needs 2 hexadecimal digits"},
      {"x = '\\ud800'", "t.ars:1:5: script.syntax: the escape \\u in this string"},
      {"x = \\ 1", "t.ars:1:5: script.syntax: nothing may follow '\\' on its line"},
      {"  x = 1", "t.ars:1:3: script.syntax: this line is indented, but belongs to no block"},
      {"if 1:\nx = 2", "t.ars:2:1: script.syntax: expected an indented block after the condition"},
      {"if 1:\n    x = 2\n  y = 3", "t.ars:3:3: script.syntax: this line's indentation matches no block above it"},
      {"if 1:\n    x = 2\n\ty = 3", "t.ars:3:2: script.syntax: this line's indentation matches no block above it"},
      {"if 1\n  x = 2", "t.ars:1:5: script.syntax: expected ':' after the condition, not the end of the line"},
      {"else: x = 2", "t.ars:1:1: script.syntax: 'else' without an if before it"},
      {"for 3 in x: pass", "t.ars:1:5: script.syntax: only variables and items of lists can be assigned to"},
      {"for x of y: pass", "t.ars:1:7: script.syntax: expected 'in' after the variables of a for, not 'of'"},
      {"1 = x", "t.ars:1:1: script.syntax: only variables and items of lists can be assigned to"},
      {"f() = 2", "t.ars:1:1: script.syntax: only variables"},
      {"a == b = 2", "t.ars:1:3: script.syntax: a comparison cannot be assigned to"},
      {"(a, 3) = 2", "t.ars:1:5: script.syntax: only variables"},
      {"(a, b) += 2", "t.ars:1:8: script.syntax: only a variable or an item of a list can stand left of '+='"},
      {"break", "t.ars:1:1: script.syntax: 'break' outside of a loop"},
      {"for i in []: pass\nelse: continue", "t.ars:2:7: script.syntax: 'continue' outside of a loop"},
      {"abs(x=1, 2)", "t.ars:1:10: script.syntax: an argument without a name cannot follow one with a name"},
      {"x = [1, 2", "t.ars:1:5: script.syntax: '[' is never closed"},
      {"x = [1 2]", "t.ars:1:8: script.syntax: expected ']' or ',' in the list, not a number"},
      {"x = a[]", "t.ars:1:6: script.syntax: nothing stands between '[' and ']'"},
      {"x = a[1:2:3:4]", "t.ars:1:13: script.syntax: a slice has at most two ':'"},
      {"x = 1 if 2", "t.ars:1:11: script.syntax: expected 'else' in the conditional expression"},
      {"x = f'{1'", "t.ars:1:7: script.syntax: a '{' in this formatted string is never closed"},
      {"x = f'}'", "t.ars:1:7: script.syntax: a single '}' in a formatted string"},
      {"x = f'{}'", "t.ars:1:7: script.syntax: nothing stands between '{' and '}'"},
      {std::string("x = 1\0y", 7), "t.ars:1:6: script.not_text: this is not a text file: it holds a zero byte"},
      {std::string("x = '\0'", 7), "t.ars:1:6: script.not_text"},
      {"x = \x01", "t.ars:1:5: script.not_text: a control character (byte 1)"},
      {"x = \xff", "t.ars:1:5: script.syntax: a byte that is no text (255)"},
      {std::string(17 << 20, '#'), "t.ars:1:1: script.too_large: the script is larger than 16 MB"},
      // Python, but not part of the language.
      {"def f(): pass", "t.ars:1:1: script.unsupported: 'def' is Python"},
      {"x = lambda: 1", "t.ars:1:5: script.unsupported: 'lambda' is Python"},
      {"import math", "t.ars:1:1: script.unsupported: only 'from aresta import *'"},
      {"from aresta import block", "t.ars:1:1: script.unsupported"},
      {"x = {1: 2}", "t.ars:1:5: script.unsupported: '{' (dictionaries and sets)"},
      {"x = 1 | 2", "t.ars:1:7: script.unsupported: the operator '|'"},
      {"x |= 2", "t.ars:1:3: script.unsupported: the operator '|='"},
      {"x = ~1", "t.ars:1:5: script.unsupported: the operator '~'"},
      {"x = y.z", "t.ars:1:6: script.unsupported: values have no attributes in this language, as in '.z'"},
      {"x: int = 3", "t.ars:1:2: script.unsupported: annotated"},
      {"x = b'a'", "t.ars:1:5: script.unsupported: strings with the prefix 'b'"},
      {"x[1:2] = 3", "t.ars:1:2: script.unsupported: a slice cannot be assigned to"},
      {"print(**x)", "t.ars:1:7: script.unsupported: '**' before an argument"},
      {"(x := 3)", "t.ars:1:4: script.unsupported: ':=' is Python"},
      // Too deep.
      {"x = " + times("(", 5000) + "1" + times(")", 5000),
       "t.ars:1:105: script.too_deep: brackets are nested more than 100 deep"},
      {"x = " + times("-", 100000) + "1", "t.ars:1:153: script.too_deep"},
      {"x = " + times("not ", 100000) + "1", "t.ars:1:597: script.too_deep"},
      {"x = " + times("2 ** ", 100000) + "1", "t.ars:1:7"},
      {"x = " + times("1 if 1 else ", 100000) + "1", "t.ars:1:17"},
      {"x = [0]\ny = x" + times("[0]", 100000), "t.ars:2:4"},
      {times("if 1: ", 1), "t.ars:1:7: script.syntax: expected an indented block after the condition"},
      // Names.
      {"a = 1\nprint(b)", "t.ars:2:7: script.name: unknown name 'b'"},
      {"volume_of_box = 1\nprint(volume_of_bx)",
       "t.ars:2:7: script.name: unknown name 'volume_of_bx'; did you mean 'volume_of_box'?"},
      {"x = squrt(2)", "t.ars:1:5: script.name: unknown name 'squrt'; did you mean 'sqrt'?"},
      {"print(x)\nx = 1", "t.ars:1:7: script.name: 'x' has no value yet: it is assigned further below"},
      {"y = [i for i in range(2)]\nprint(i)", "t.ars:2:7: script.name: unknown name 'i'"},
      // Wrong types, at the operator.
      {"x = 1\ny = x + 'a'", "t.ars:2:7: script.type: '+' is not defined between a whole number and a text"},
      {"x = [1] < 2", "t.ars:1:9: script.type: '<' is not defined between a list and a whole number"},
      {"x = 1 < 'a'", "t.ars:1:7: script.type: '<' is not defined between a whole number and a text"},
      {"x = -'a'", "t.ars:1:5: script.type: '-' is not defined for a text"},
      {"x = +[]", "t.ars:1:5: script.type: '+' is not defined for a list"},
      {"x = 3(4)", "t.ars:1:5: script.type: this is 3, a whole number, and cannot be called"},
      {"abs = 3\nabs(4)",
       "t.ars:2:1: script.type: 'abs' is 3, a whole number, and cannot be called; a variable of that name hides the "
       "command"},
      {"x = 3[0]", "t.ars:1:6: script.type: a whole number has no items: 3"},
      {"x = [1]['a']", "t.ars:1:8: script.type: the index must be a whole number, not 'a', a text"},
      {"x = (1, 2)\nx[0] = 3", "t.ars:2:2: script.type: the items of a tuple cannot be changed"},
      {"for i in 3: pass", "t.ars:1:10: script.type: a whole number cannot be gone through item by item: 3"},
      {"x = len(3)", "t.ars:1:5: script.type: a whole number has no length"},
      {"x = 2 in 3", "t.ars:1:7: script.type: 'in' is not defined between a whole number and a whole number"},
      {"x = sorted([1, 'a'])", "t.ars:1:5: script.type: '<' is not defined between"},
      {"x = ','.join([1])", "t.ars:1:9: script.type: .join takes a list of texts; item 0 is 1, a whole number"},
      {"x = [].push(1)", "t.ars:1:8: script.name: a list has no method 'push'; try: append"},
      {"x = [].append()", "t.ars:1:8: script.type: .append takes 1 argument, 0 were given"},
      {"x = (1,).append(2)", "t.ars:1:10: script.type: a tuple has no method 'append'"},
      {"x = f'{1:zz}'", "t.ars:1:8: script.value: the format 'zz' is not known"},
      {"x = f'{\"a\":d}'", "t.ars:1:8: script.type: the format 'd' takes a whole number, not 'a', a text"},
      // Values.
      {"x = [1, 2][2]",
       "t.ars:1:11: script.index: the index 2 is outside of a list of 2 items (items are counted from 0)"},
      {"x = [1, 2][-3]", "t.ars:1:11: script.index: the index -3 is outside of a list of 2 items"},
      {"x = [].pop()", "t.ars:1:8: script.index: the index -1 is outside of a list of 0 items"},
      {"x = 1 / 0", "t.ars:1:7: script.zero_division: 1, a whole number, is divided by zero"},
      {"x = 1 // 0.0", "t.ars:1:7: script.zero_division"},
      {"x = 5 % 0", "t.ars:1:7: script.zero_division"},
      {"x = 0 ** -1", "t.ars:1:7: script.zero_division: 0 has no negative power"},
      {"x = 9223372036854775807 + 1",
       "t.ars:1:25: script.overflow: the result of '+' does not fit in 64 bits; try: real numbers"},
      {"x = 2 ** 64", "t.ars:1:7: script.overflow"},
      {"x = -(-9223372036854775807 - 1)", "t.ars:1:5: script.overflow"},
      {"x = (-9223372036854775807 - 1) // -1", "t.ars:1:32: script.overflow"},
      {"x = abs(-9223372036854775807 - 1)", "t.ars:1:5: script.overflow"},
      {"x = 9223372036854775808", "t.ars:1:5: script.overflow: the whole number does not fit in 64 bits"},
      {"x = 1e999", "t.ars:1:5: script.overflow: the number is too large"},
      {"x = 1e308 * 10", "t.ars:1:11: script.overflow: the result of '*' is too large for a number"},
      {"x = 10.0 ** 400", "t.ars:1:10: script.overflow"},
      {"x = exp(1000)", "t.ars:1:5: script.overflow: the result of exp is too large"},
      {"x = int(1e300)", "t.ars:1:5: script.overflow"},
      {"x = sqrt(-1)", "t.ars:1:5: script.value: sqrt takes a number that is not negative, not -1"},
      {"x = asin(1.5)", "t.ars:1:5: script.value: asin takes a number from -1 to 1, not 1.5"},
      {"x = tan(90)", "t.ars:1:5: script.value: tan has no value at 90 degrees"},
      {"x = log(0)", "t.ars:1:5: script.value: log takes a number greater than 0, not 0"},
      {"x = (-8) ** 0.5", "t.ars:1:10: script.value: a negative number has no real power"},
      {"x = int('3.5')", "t.ars:1:5: script.value: the text '3.5' is no whole number"},
      {"x = float('nan')", "t.ars:1:5: script.value: the text 'nan' is no number"},
      {"x = range(1, 2, 0)", "t.ars:1:5: script.value: the step of a range cannot be 0"},
      {"x = [1][::0]", "t.ars:1:8: script.value: the step of a slice cannot be 0"},
      {"x = max([])", "t.ars:1:5: script.value: max of nothing"},
      {"x = [0] * 10 ** 12", "t.ars:1:9: script.too_large: the list would be too long"},
      {"x = 'ab' * 10 ** 12", "t.ars:1:10: script.too_large: the text would be too long"},
      {"x = list(range(10 ** 12))",
       "t.ars:1:5: script.too_large: a range of 1000000000000 numbers is too long for a list"},
      {"x = 'aaaa'\nwhile True: x = x + x", "t.ars:2:19: script.too_large: the text would be too long"},
      {"x = [1]\nwhile True: x += x", "t.ars:2:15: script.too_large: the list would be too long"},
      {"a, b = 1, 2, 3", "t.ars:1:1: script.unpack: 2 variables, but 3 values"},
      {"a, b = 5", "t.ars:1:1: script.unpack: a whole number cannot be shared out to 2 variables"},
      {"a, b = range(10 ** 15)", "t.ars:1:1: script.unpack: 2 variables, but 1000000000000000 values"},
      {"x = []\nx.append(x)\ny = []\ny.append(y)\nz = x < y",
       "t.ars:5:7: script.too_deep: the lists compared are nested too deeply"},
      // Arguments of commands.
      {"sqrt()", "t.ars:1:1: command.missing_argument: sqrt: 'x' is missing: a number; try: sqrt(x)"},
      {"sqrt(1, 2)",
       "t.ars:1:1: command.too_many_arguments: sqrt takes at most 1 argument, 2 were given; try: sqrt(x)"},
      {"sqrt(y=1)", "t.ars:1:1: command.unknown_parameter: sqrt has no parameter 'y'"},
      {"round(1.5, digit=2)",
       "t.ars:1:1: command.unknown_parameter: round has no parameter 'digit'; did you mean 'digits'?"},
      {"round(1.5, x=2)", "t.ars:1:1: command.repeated_argument: round: 'x' is given twice"},
      {"sqrt('a')", "t.ars:1:1: command.type: sqrt: x must be a number, not 'a', a text"},
      {"sqrt(True)", "t.ars:1:1: command.type: sqrt: x must be a number, not True, a truth value"},
      {"round(1.5, 2.5)", "t.ars:1:1: command.type: round: digits must be a whole number, not 2.5, a number"},
      {"round(1.5, 1000)", "t.ars:1:1: command.range: round: digits must be between -300 and 300, not 1000"},
      {"expect(1, 1, rel=-1)", "t.ars:1:1: command.range: expect: rel must be at least 0, not -1"},
      {"sorted([1], key=3)",
       "t.ars:1:1: command.type: sorted: key must be the name of a command, not 3, a whole number"},
      {"x = 1\nprint('a',\n      sqrt(\n        'b'))", "t.ars:3:7: command.type"},
      // Checks.
      {"assert 1 > 2", "t.ars:1:1: script.assertion: the assertion is not true: 1 > 2"},
      {"x = 5\nassert x == 6, 'six ' + str(x)", "t.ars:2:1: script.assertion: six 5"},
      {"x = 1.5\ny = 2\nassert x == y", "t.ars:3:1: script.assertion: the assertion is not true: 1.5 == 2"},
      {"expect(1.1, 1)",
       "t.ars:1:1: script.expectation: expected 1, got 1.1000000000000001 (off by 0.10000000000000009, relative"},
      {"expect([1, [2, 3]], [1, [2, 4]])", "t.ars:1:1: script.expectation: expected 4, got 3 in item 1 in item 1"},
      {"expect([1, 2], [1, 2, 3])",
       "t.ars:1:1: script.expectation: expected [1, 2, 3], got [1, 2]: 2 items instead of 3"},
      {"expect('a', 'b')", "t.ars:1:1: script.expectation: expected 'b', got 'a'"},
      {"expect(True, 1)", ""},
      {"expect(None, 0)", "t.ars:1:1: script.expectation: expected 0, got None"},
      {"\n\n\n\n\n\nx = nothing", "t.ars:7:5: script.name: unknown name 'nothing'"},
  };
}

TEST(Errors, TableOfPlacesAndMessages) {
  for (const Row& row : rows()) {
    const Ran ran = run_text(row.script);
    const std::string shown = row.script.substr(0, 80);
    if (row.error.empty()) {
      EXPECT_EQ(ran.error, "") << shown;
    } else {
      EXPECT_EQ(ran.error.substr(0, row.error.size()), row.error) << shown;
    }
    EXPECT_EQ(ran.error.find('\n'), std::string::npos) << "errors are one line: " << shown;
  }
}

TEST(Errors, DeepNestingOfEveryKindIsRefused) {
  for (const std::string& script :
       {"x = " + times("[", 99) + times("]", 99), "x = " + times("abs(", 99) + "1" + times(")", 99),
        "x = " + times("(1 + ", 90) + "1" + times(")", 90)}) {
    EXPECT_EQ(run_text(script).error, "");
  }
  std::string blocks;
  for (int i = 0; i < 60; ++i) blocks += std::string(static_cast<std::size_t>(i), ' ') + "if 1:\n";
  EXPECT_NE(run_text(blocks + std::string(60, ' ') + "x = 1").error.find("script.too_deep"), std::string::npos);
  std::string nested = "1";
  for (int i = 0; i < 30; ++i) nested = "f'{" + nested + "}'";
  EXPECT_NE(run_text("x = " + nested).error, "");
}

TEST(Errors, WhatWasPrintedBeforeAnErrorStays) {
  const Ran ran = run_text("print(1)\nprint(2)\nx = 1 / 0\nprint(3)");
  EXPECT_EQ(ran.printed, "1\n2\n");
  EXPECT_EQ(ran.error.substr(0, 10), "t.ars:3:7:");
}

TEST(Errors, AFailingPrintStopsTheScript) {
  document::Session session;
  session.registry = &language();
  int calls = 0;
  session.print = [&](const std::string&) -> Status {
    if (++calls == 2) return Error{errors::internal, "no room"};
    return {};
  };
  Interpreter interpreter(session);
  const Status status = interpreter.run("print(1)\nprint(2)\nprint(3)", "t.ars");
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().to_line(), "t.ars:2:1: internal: no room");
  EXPECT_EQ(calls, 2);
}

TEST(Errors, EndlessLoopsAreInterrupted) {
  for (const char* script : {"while True: pass", "for i in range(10**18): x = i",
                             "x = [i for i in range(10**18) if False]", "a = [0]\nfor x in a:\n  a.append(x)"}) {
    std::atomic<bool> cancel = false;
    std::thread later([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      cancel = true;
    });
    const Ran ran = run_text(script, document::Digits::shortest, &cancel);
    later.join();
    EXPECT_NE(ran.error.find(": cancelled: the script was interrupted"), std::string::npos)
        << script << ": " << ran.error;
  }
}

}  // namespace
}  // namespace aresta::script
