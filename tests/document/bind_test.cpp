// SPDX-License-Identifier: Apache-2.0
// Arguments against declarations: what is taken, and the message for each way to get it wrong.
#include <gtest/gtest.h>

#include <cmath>

#include "document/registry.h"

namespace aresta::document {
namespace {

class Thing : public Shape {
 public:
  std::string describe() const override { return "a thing"; }
  bool same_as(const Shape& other) const override { return this == &other; }
};

const Command command{
    .name = "make",
    .group = "test",
    .parameters =
        {{.name = "r", .type = Type::number, .doc = "radius", .unit = "length", .limits = positive},
         {.name = "at", .type = Type::point, .default_value = Value::tuple({0, 0, 0})},
         {.name = "axis", .type = Type::direction, .default_value = Value::tuple({0, 0, 1})},
         {.name = "patches", .type = Type::integer, .default_value = 1, .limits = {1, 64}},
         {.name = "kind", .type = Type::string, .default_value = "face", .choices = {"face", "edge", "vertex"}},
         {.name = "x", .type = Type::shape, .default_value = Value()},
         {.name = "matrix", .type = Type::numbers, .default_value = Value(), .size = 4},
         {.name = "path", .type = Type::points, .default_value = Value()},
         {.name = "flag", .type = Type::boolean, .default_value = false, .keyword_only = true}},
    .doc = "Makes a thing.",
    .example = "make(1)",
    .function = [](Call&) -> Result<Value> { return Value(); }};

const Command many{.name = "many",
                   .group = "test",
                   .parameters = {{.name = "items", .type = Type::shapes, .variadic = true},
                                  {.name = "name", .type = Type::string, .default_value = "", .keyword_only = true}},
                   .doc = "Takes many.",
                   .function = [](Call&) -> Result<Value> { return Value(); }};

Value point(double x, double y, double z) {
  return Value::tuple({x, y, z});
}

std::string message(const Command& c, Arguments arguments) {
  const auto bound = bind(c, std::move(arguments));
  return bound.ok() ? "" : bound.error().to_line();
}

TEST(Bind, DefaultsAndKeywords) {
  const auto bound = bind(command, {.positional = {2}, .keywords = {{"flag", true}, {"at", Value::list({1, 2.5, 3})}}});
  ASSERT_TRUE(bound.ok());
  ASSERT_EQ(bound->size(), 9u);
  EXPECT_EQ((*bound)[0].integer(), 2);
  EXPECT_EQ(repr((*bound)[1]), "[1, 2.5, 3]");
  EXPECT_EQ(repr((*bound)[2]), "(0, 0, 1)");
  EXPECT_TRUE((*bound)[5].is_none());
  EXPECT_TRUE((*bound)[8].boolean());
}

TEST(Bind, NoneForWhatMayBeLeftOut) {
  EXPECT_EQ(message(command, {.positional = {1}, .keywords = {{"x", Value()}}}), "");
  EXPECT_EQ(message(command, {.positional = {1}, .keywords = {{"at", Value()}}}),
            "command.type: make: at must be a point (x, y, z), not None, no value");
}

TEST(Bind, EachWayToGetItWrong) {
  const Value shape(std::make_shared<const Thing>());
  const struct {
    Arguments arguments;
    std::string message;
  } rows[] = {
      {{},
       "command.missing_argument: make: 'r' is missing: a number; try: make(r, at=(0, 0, 0), axis=(0, 0, 1), "
       "patches=1, "
       "kind='face', x=None, matrix=None, path=None, *, flag=False)"},
      {{.positional = {0}}, "command.range: make: r must be greater than 0, not 0"},
      {{.positional = {-1.5}}, "command.range: make: r must be greater than 0, not -1.5"},
      {{.positional = {NAN}}, "command.not_finite: make: r must be a finite number, not nan"},
      {{.positional = {INFINITY}}, "command.not_finite: make: r must be a finite number, not inf"},
      {{.positional = {"2"}}, "command.type: make: r must be a number, not '2', a text"},
      {{.positional = {shape}}, "command.type: make: r must be a number, not <a thing>"},
      {{.positional = {1, Value::tuple({1, 2})}},
       "command.type: make: at must be a point (x, y, z), not (1, 2), a tuple"},
      {{.positional = {1, Value::tuple({1, 2, "3"})}}, "command.type: make: at[2] must be a number, not '3', a text"},
      {{.positional = {1, point(1, NAN, 2)}}, "command.not_finite: make: at[1] must be a finite number, not nan"},
      {{.positional = {1, point(0, 0, 0), point(0, 0, 0)}},
       "command.range: make: axis must be a direction (x, y, z) other than (0, 0, 0), not (0.0, 0.0, 0.0)"},
      {{.positional = {1}, .keywords = {{"patches", 2.5}}},
       "command.type: make: patches must be a whole number, not 2.5, a number"},
      {{.positional = {1}, .keywords = {{"patches", 65}}},
       "command.range: make: patches must be between 1 and 64, not 65"},
      {{.positional = {1}, .keywords = {{"kind", "edg"}}},
       "command.range: make: kind must be one of 'face', 'edge', 'vertex', not 'edg'; try: 'edge'"},
      {{.positional = {1}, .keywords = {{"x", 3}}}, "command.type: make: x must be a shape, not 3, a whole number"},
      {{.positional = {1}, .keywords = {{"matrix", Value::list({1, 2, 3})}}},
       "command.type: make: matrix must be a list of 4 numbers (it has 3), not [1, 2, 3], a list"},
      {{.positional = {1}, .keywords = {{"path", Value::list({point(0, 0, 0), 3})}}},
       "command.type: make: path[1] must be a point (x, y, z), not 3, a whole number"},
      {{.positional = {1}, .keywords = {{"flag", 1}}},
       "command.type: make: flag must be True or False, not 1, a whole number"},
  };
  for (const auto& row : rows) EXPECT_EQ(message(command, row.arguments), row.message);

  const Arguments too_many{.positional = std::vector<Value>(9, Value(1))};
  EXPECT_EQ(message(command, too_many).substr(0, 80),
            "command.too_many_arguments: make takes at most 8 arguments, 9 were given; try: m");
  EXPECT_EQ(message(command, {.positional = {1}, .keywords = {{"pathces", 3}}}).substr(0, 85),
            "command.unknown_parameter: make has no parameter 'pathces'; did you mean 'patches'?; ");
  EXPECT_EQ(message(command, {.positional = {1}, .keywords = {{"r", 3}}}).substr(0, 53),
            "command.repeated_argument: make: 'r' is given twice; ");
}

TEST(Bind, VariadicTakesTheRest) {
  const Value shape(std::make_shared<const Thing>());
  const auto bound = bind(many, {.positional = {shape, Value::list({shape, shape})}, .keywords = {{"name", "A"}}});
  ASSERT_TRUE(bound.ok());
  Session session;
  const Call call(many, *bound, session);
  EXPECT_EQ(call.shapes("items").size(), 3u);
  EXPECT_EQ(call.string("name"), "A");
  EXPECT_EQ(message(many, {.positional = {shape, 3}}),
            "command.type: many: items[1] must be a shape or a list of shapes, not 3, a whole number");
  EXPECT_EQ(message(many, {.positional = {Value::list({shape, 3})}}),
            "command.type: many: items[0][1] must be a shape, not 3, a whole number");
  EXPECT_EQ(message(many, {}), "");
}

TEST(Registry, HelpComesFromTheDeclaration) {
  const std::string help = Registry::help(command);
  EXPECT_NE(help.find("make(r, at=(0, 0, 0)"), std::string::npos);
  EXPECT_NE(help.find("r: a number, greater than 0 [length]\n      radius"), std::string::npos) << help;
  EXPECT_NE(help.find("Example:\n  make(1)"), std::string::npos);
}

TEST(NearestName, OnlyWhatIsNear) {
  const std::vector<std::string> names{"block", "volume", "union", "intersection"};
  EXPECT_EQ(nearest_name("blok", names), "block");
  EXPECT_EQ(nearest_name("volmue", names), "volume");
  EXPECT_EQ(nearest_name("intersect", names), "intersection");
  EXPECT_EQ(nearest_name("sphere", names), "");
  EXPECT_EQ(nearest_name("", names), "");
}

TEST(Value, NumbersAsPythonWritesThem) {
  EXPECT_EQ(number_text(3), "3.0");
  EXPECT_EQ(number_text(-0.0), "-0.0");
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(1e16), "1e+16");
  EXPECT_EQ(number_text(0.1, Digits::seventeen), "0.10000000000000001");
  EXPECT_EQ(number_text(1.0 / 3, Digits::seventeen), "0.33333333333333331");
}

}  // namespace
}  // namespace aresta::document
