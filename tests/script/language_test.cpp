// SPDX-License-Identifier: Apache-2.0
// What the language means, as a table: a script and what it prints. Each row also runs in Python 3 with the same output
// (sin, cos and their like excepted: degrees here), which is how the expectations were made.
#include <gtest/gtest.h>

#include "run.h"

namespace aresta::script {
namespace {

struct Row {
  const char* script;
  const char* printed;
};

const Row rows[] = {
    // Numbers.
    {"print(1 + 2 * 3)", "7\n"},
    {"print(7 / 2, 8 / 2)", "3.5 4.0\n"},
    {"print(7 // 2, -7 // 2, 7 // -2, -7 // -2)", "3 -4 -4 3\n"},
    {"print(7 % 3, -7 % 3, 7 % -3, -7 % -3)", "1 2 -2 -1\n"},
    {"print(7.5 // 2, -7.5 // 2, -7.5 % 2)", "3.0 -4.0 0.5\n"},
    {"print(2 ** 10, 2 ** -1, 2 ** 0.5)", "1024 0.5 1.4142135623730951\n"},
    {"print(-2 ** 2, (-2) ** 2, 2 ** 3 ** 2, 2 ** -1 ** 2)", "-4 4 512 0.5\n"},
    {"print(0x1f, 0b101, 0o17, 1_000, 1e3, .5, 5., 1_0.2_5e-0_1)", "31 5 15 1000 1000.0 0.5 5.0 1.025\n"},
    {"print(9223372036854775807, -9223372036854775807 - 1)", "9223372036854775807 -9223372036854775808\n"},
    {"print(0.1 + 0.2, 1e22, 1e16, 123456789012345680.0, 1e-5, 0.0001, 1e15)",
     "0.30000000000000004 1e+22 1e+16 1.2345678901234568e+17 1e-05 0.0001 1000000000000000.0\n"},
    {"print(- -3, +4, -0.0, 10 - 4 - 3, 100 / 10 / 5)", "3 4 -0.0 3 2.0\n"},
    {"print(True + True, True * 3, 6 & 3)", "2 3 2\n"},
    {"print(1 == 1.0, 1 is None, None is None, 3 != 3)", "True False True False\n"},
    {"print(2 ** 53 == 9007199254740993, 9007199254740993 == 9007199254740992.0)", "False False\n"},
    {"print(round(2.5), round(3.5), round(-2.5), round(2.675, 2), round(1234, -2), round(0.5))",
     "2 4 -2 2.67 1200 0\n"},
    {"print(abs(-3), abs(-3.5), min(3, 1, 2), max([3, 1, 2]), max(1, 2.0), sum([1, 2, 3]), sum([0.5, 1], 2))",
     "3 3.5 1 3 2.0 6 3.5\n"},
    {"print(int(3.9), int(-3.9), int('42'), float('2.5'), float(3), int(True), str(1.0), str([1, 'a']))",
     "3 -3 42 2.5 3.0 1 1.0 [1, 'a']\n"},
    {"print(floor(2.7), floor(-2.2), ceil(2.2), ceil(-2.7), hypot(3, 4), sqrt(16))", "2 -3 3 -2 5.0 4.0\n"},
    // Comparison and logic.
    {"print(1 < 2 < 3, 1 < 3 < 2, 3 > 2 >= 2 != 1)", "True False True\n"},
    {"print(1 < 2 == True)", "False\n"},
    {"print(not 1 == 2, not True, not [])", "True False True\n"},
    {"print(0 or 'x', 1 and 2, None and 1 / 0, 1 or 1 / 0)", "x 2 None 1\n"},
    {"print('a' if 1 > 2 else 'b' if 3 > 4 else 'c')", "c\n"},
    {"print([1, 2] < [1, 3], (1, 2) == (1, 2.0), [1] == (1,), 'abc' < 'abd', 'Z' < 'a')",
     "True True False True True\n"},
    {"print(2 in [1, 2], 3 not in (1, 2), 'ell' in 'hello', 4 in range(0, 10, 2), 5 in range(0, 10, 2), 2.0 in "
     "range(3))",
     "True True True True False True\n"},
    {"a = [1]\nb = a\nc = [1]\nprint(a is b, a is c, a == c, a is not c)", "True False True True\n"},
    // Text.
    {"print('it\\'s', \"a\\tb\", 'x' 'y', r'\\n', 'a\\x41\\u00e9\\n', end='')", "it's a\tb xy \\n aAé\n"},
    {"print(\"\"\"two\nlines\"\"\")", "two\nlines\n"},
    {"print('ab' * 3, 2 * 'xy', 'a' + 'b', 'a' * 0 + '|')", "ababab xyxy ab |\n"},
    {"s = 'héllo'\nprint(len(s), s[1], s[-1], s[1:3], s[::-1])", "5 é o él olléh\n"},
    {"print(['a', \"it's\", 'q\"'], ('x',), [], (), [[1], (2,)])", "['a', \"it's\", 'q\"'] ('x',) [] () [[1], (2,)]\n"},
    {"print(', '.join(['a', 'b']), 'a b  c'.split(), 'a,b,,c'.split(','), ' x '.strip(), 'Ab'.upper(), 'Ab'.lower())",
     "a, b ['a', 'b', 'c'] ['a', 'b', '', 'c'] x AB ab\n"},
    {"print('banana'.replace('an', 'AN'), 'file.ars'.endswith('.ars'), 'file'.startswith('x'))", "bANANa True False\n"},
    {"x = 3.14159\nn = "
     "42\nprint(f'{x:.2f}|{x:8.3f}|{n:5d}|{n:<5d}|{n:05d}|{x:.3e}|{n}|{{}}|{\"t\":>3}|{x:.3g}|{n:+d}')",
     "3.14|   3.142|   42|42   |00042|3.142e+00|42|{}|  t|3.14|+42\n"},
    {"v = [1, 2]\nprint(f'{v[0]} and {v[1] + 1}: {\"a\" if v else \"b\"}' ' end', f\"{len('x:y')}\")",
     "1 and 3: a end 3\n"},
    {"print(1, 'a', sep='-', end='!\\n')\nprint()\nprint('x', end='')", "1-a!\n\nx"},
    // Lists, tuples, ranges.
    {"a = [1, 2, 3, 4, 5]\nprint(a[0], a[-1], a[1:3], a[:2], a[3:], a[::2], a[::-1], a[10:], a[-2:])",
     "1 5 [2, 3] [1, 2] [4, 5] [1, 3, 5] [5, 4, 3, 2, 1] [] [4, 5]\n"},
    {"a = [1, 2, 3]\nb = a\nb[0] = 9\na.append(4)\nprint(a, b is a, len(b))", "[9, 2, 3, 4] True 4\n"},
    {"a = [3, 1, 2]\na.extend((5, 6))\na.insert(0, 7)\na.insert(-100, 8)\nprint(a.pop(), a.pop(0), a, a.index(1), "
     "a.count(3))\na.reverse()\nprint(a)",
     "6 8 [7, 3, 1, 2, 5] 2 1\n[5, 2, 1, 3, 7]\n"},
    {"a, b = 1, 2\na, b = b, a\n(c, [d, e]), f = (3, (4, 5)), 6\nx = y = [0]\nprint(a, b, c, d, e, f, x is y)",
     "2 1 3 4 5 6 True\n"},
    {"a = [1, 2] + [3]\na += [4]\na[0] += 10\nt = (1,) + (2, 3)\nprint(a, t, [0] * 3, (1, 2) * 2)",
     "[11, 2, 3, 4] (1, 2, 3) [0, 0, 0] (1, 2, 1, 2)\n"},
    {"x = 5\nx += 2\nx *= 3\nx -= 1\nx //= 3\nx **= 2\nx %= 7\nx /= 2\nprint(x)", "0.5\n"},
    {"print(list(range(5)), list(range(2, 8, 3)), list(range(5, 0, -2)), len(range(10)), range(3)[1], range(10)[2:5], "
     "range(0, 6, 2))",
     "[0, 1, 2, 3, 4] [2, 5] [5, 3, 1] 10 1 range(2, 5) range(0, 6, 2)\n"},
    {"print([i * i for i in range(5) if i % 2 == 0], [(i, j) for i in range(2) for j in range(i + 1)], sum(i for i in "
     "range(4)))",
     "[0, 4, 16] [(0, 0), (1, 0), (1, 1)] 6\n"},
    {"i = 7\nx = [i for i in range(3)]\nprint(i, x, [[j * k for j in range(2)] for k in range(2)])",
     "7 [0, 1, 2] [[0, 0], [0, 1]]\n"},
    {"print([a + b for a, b in zip([1, 2], [10, 20, 30])], [x for p in [[1, 2], [3]] for x in p])",
     "[11, 22] [1, 2, 3]\n"},
    {"print(sorted([3, 1, 2]), sorted((1, 3, 2), reverse=True), sorted(['b', 'a']), sorted([-3, 2, -1], key=abs), "
     "max([-5, 3], key=abs))",
     "[1, 2, 3] [3, 2, 1] ['a', 'b'] [-1, 2, -3] -5\n"},
    {"print(sorted([[2, 'a'], [1, 'b'], [2, 'A']]), sorted(range(20), reverse=True)[:3])",
     "[[1, 'b'], [2, 'A'], [2, 'a']] [19, 18, 17]\n"},
    {"print(list(enumerate(['a', 'b'])), list(enumerate('xy', 5)), tuple([1]), list('ab'))",
     "[(0, 'a'), (1, 'b')] [(5, 'x'), (6, 'y')] (1,) ['a', 'b']\n"},
    {"print(all([1, 2]), all([]), any([0, None]), any([0, 3]), bool(''), bool([0]))",
     "True True False True False True\n"},
    {"v = (1, 2, 3)\nprint(max(*v), *v, sep='/')", "3/1/2/3\n"},
    {"print(repr('a'), str('a'), [None, True])", "'a' a [None, True]\n"},
    // Statements.
    {"for i in range(5):\n    if i == 1:\n        continue\n    if i == 3:\n        break\n    print(i)\nelse:\n    "
     "print('no')\nprint('end', i)",
     "0\n2\nend 3\n"},
    {"for i in []:\n  pass\nelse:\n  print('else')", "else\n"},
    {"n = 0\nwhile n < 3:\n    n += 1\n    if n == 2: continue\n    print(n)\nelse: print('done')", "1\n3\ndone\n"},
    {"while True:\n    while True:\n        break\n    break\nelse:\n    print('no')\nprint('yes')", "yes\n"},
    {"x = 5\nif x > 10: print('a')\nelif x > 3: print('b'); print('c')\nelse:\n    print('d')", "b\nc\n"},
    {"for a, (b, c) in [(1, (2, 3)), [4, [5, 6]]]: print(a + b + c)", "6\n15\n"},
    {"for c in 'ab': print(c)", "a\nb\n"},
    {"a = [1]\nfor x in a:\n    if len(a) < 4: a.append(x + 1)\nprint(a)", "[1, 2, 3, 4]\n"},
    {"assert 1 < 2, 'fine'\nassert True\nprint('ok')", "ok\n"},
    {"from aresta import *\n# a comment\n\n   # an indented comment\nx = (1 +\n     2,  # inside\n     3)\ny = 1 + "
     "\\\n    2\nprint(x, y);  print('z')",
     "(3, 3) 3\nz\n"},
    {"if True:\n\n    # first\n  # odd comment\n    print(1)\n\n    print(2)\nprint(3)", "1\n2\n3\n"},
    {"if True:\n\tprint(1)\n\tif True:\n\t\tprint(2)\r\nprint(3)\r\n", "1\n2\n3\n"},
    {"\xef\xbb\xbfprint('bom')", "bom\n"},
    {"", ""},
    {"\n\n# only a comment", ""},
    {"'a doc string'\n3\nprint(None)", "None\n"},
    {"area = 3\nlen = 4\nprint(area * len)", "12\n"},
    {"f = abs\nprint(f(-2), [g(-1.5) for g in [abs, int]])", "2 [1.5, -1]\n"},
    {"x = [1, [2, [3]]]\nprint(x[1][1][0], len(x[1]))\nx[1][0] = 'b'\nprint(x)", "3 2\n[1, ['b', [3]]]\n"},
    {"expect(1.0000000001, 1)\nexpect([1, (2, 3)], [1.0, (2, 3)])\nexpect(0.1, 0, abs=0.2)\nexpect('a', "
     "'a')\nexpect(3, 3)\nprint('ok')",
     "ok\n"},
};

TEST(Language, Table) {
  for (const Row& row : rows) {
    const Ran ran = run_text(row.script);
    EXPECT_EQ(ran.error, "") << row.script;
    EXPECT_EQ(ran.printed, row.printed) << row.script;
  }
}

// Angles are in degrees, and exact where the function is.
const Row degrees[] = {
    {"print(sin(0), sin(30), sin(90), sin(150), sin(180), sin(210), sin(270), sin(360), sin(-30))",
     "0.0 0.5 1.0 0.5 0.0 -0.5 -1.0 0.0 -0.5\n"},
    {"print(cos(0), cos(60), cos(90), cos(120), cos(180), cos(240), cos(300), cos(450))",
     "1.0 0.5 0.0 -0.5 -1.0 -0.5 0.5 0.0\n"},
    {"print(tan(45), tan(-45), tan(135), tan(0), tan(225))", "1.0 -1.0 -1.0 0.0 1.0\n"},
    {"print(sin(45) == cos(45), sin(20) == sin(160), cos(20) == -cos(200), abs(sin(20) ** 2 + cos(20) ** 2 - 1) < "
     "1e-15)",
     "True True True True\n"},
    {"print(asin(0.5), acos(0.5), atan(1), atan2(1, -1), atan2(0, -1), asin(-1), acos(0))",
     "30.0 60.0 45.0 135.0 180.0 -90.0 90.0\n"},
    {"print(pi, abs(sin(57.29577951308232) - 0.8414709848078965) < 1e-15, round(exp(log(7)), 12))",
     "3.141592653589793 True 7.0\n"},
};

TEST(Language, AnglesAreInDegrees) {
  for (const Row& row : degrees) {
    const Ran ran = run_text(row.script);
    EXPECT_EQ(ran.error, "") << row.script;
    EXPECT_EQ(ran.printed, row.printed) << row.script;
  }
}

TEST(Language, SeventeenDigitsWhenAsked) {
  EXPECT_EQ(run_text("print(0.1, [2.5, 1/3], 3, 3.0, f'{0.1}')", document::Digits::seventeen).printed,
            "0.10000000000000001 [2.5, 0.33333333333333331] 3 3.0 0.1\n");
}

TEST(Language, VariablesStayBetweenRunsAndCanBeGiven) {
  document::Session session;
  session.registry = &language();
  Interpreter interpreter(session);
  interpreter.set("n", document::Value(4));
  ASSERT_TRUE(interpreter.run("m = n + 1", "a.ars").ok());
  const auto value = interpreter.evaluate("m * 2", "b.ars");
  ASSERT_TRUE(value.ok());
  EXPECT_EQ(value->integer(), 10);
  EXPECT_EQ(interpreter.get("m")->integer(), 5);
  EXPECT_EQ(interpreter.get("zzz"), nullptr);
}

TEST(Language, Definitions) {
  EXPECT_EQ(document::repr(value_of_definition("3")), "3");
  EXPECT_EQ(document::repr(value_of_definition("-2.5")), "-2.5");
  EXPECT_EQ(document::repr(value_of_definition("(1, 2)")), "(1, 2)");
  EXPECT_EQ(document::repr(value_of_definition("True")), "True");
  EXPECT_EQ(document::repr(value_of_definition("None")), "None");
  EXPECT_EQ(document::repr(value_of_definition("steel")), "'steel'");
  EXPECT_EQ(document::repr(value_of_definition("out/plate one.step")), "'out/plate one.step'");
  EXPECT_EQ(document::repr(value_of_definition("'3'")), "'3'");
  EXPECT_EQ(document::repr(value_of_definition("")), "''");
  EXPECT_EQ(document::repr(value_of_definition("x = 3")), "'x = 3'");
}

TEST(Language, LongSumsAreNoTrouble) {
  std::string sum = "x = 0";
  for (int i = 0; i < 20000; ++i) sum += " + 1";
  EXPECT_EQ(run_text(sum + "\nprint(x)").printed, "20000\n");
}

TEST(Language, AMillionLevelsOfListsAreReleased) {
  EXPECT_EQ(run_text("a = []\nfor i in range(1000000): a = [a]\nprint('ok')").printed, "ok\n");
  EXPECT_EQ(run_text("a = []\na.append(a)\na[0][0].append(1)\nprint(a[0] is a, len(a))").printed, "True 2\n");
}

}  // namespace
}  // namespace aresta::script
