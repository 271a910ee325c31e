// SPDX-License-Identifier: Apache-2.0
// Shapes in the language: each script asserts closed-form values by itself; the tables here are scripts that must run,
// and scripts that must be refused, with the beginning of the message.
#include <gtest/gtest.h>

#include "run.h"

namespace aresta::script {
namespace {

struct Row {
  const char* what;
  const char* script;
};

const Row rows[] = {
    {"a torus cut obliquely and put together again", R"(
for normal in [(1, 2, 3), (3, 1, 0.5)]:
    above, below = cut(torus(6, 1), (0, 0, 0), normal)
    expect([volume(above), volume(below)], [6 * pi ** 2] * 2, rel=1e-8)
    expect([volume(x) for x in [union(above, below), above + below]], [12 * pi ** 2] * 2, rel=1e-8)
)"},
    {"block", R"(
b = block(1, 2, 3, at=(4, 5, 6))
expect([count(b, k) for k in ["regions", "shells", "faces", "edges", "vertices", "components"]], [1, 1, 6, 12, 8, 1])
expect([volume(b), area(b), length(b)], [6, 22, 24])
expect(bounds(b), ((4, 5, 6), (5, 7, 9)))
expect(centroid(b), (4.5, 6, 7.5))
expect(inertia(b), [[6.5, 0, 0], [0, 5, 0], [0, 0, 2.5]], abs=1e-9)
expect(genus(b), 0)
)"},
    {"round solids", R"(
expect(volume(cylinder(2, 10, at=(0, 0, -5))), 40 * pi)
expect(volume(cylinder(2, 10, axis=(1, 2, 3), patches=4, seam=30)), 40 * pi)
expect(count(cylinder(1, 1, patches=4), "faces"), 6)
expect(volume(cone(2, 0, 3)), 4 * pi)
expect(volume(cone(2, 1, 3)), 7 * pi)
expect(volume(sphere(2)), 32 * pi / 3)
expect(area(sphere(2)), 16 * pi)
expect(volume(torus(3, 1)), 6 * pi ** 2)
expect([genus(sphere(1)), genus(torus(3, 1)), genus(cylinder(1, 1))], [0, 1, 0])
)"},
    {"plane solids", R"(
expect(volume(prism(6, 2, 3)), 3 * 3 * sqrt(3) / 2 * 4)
expect(volume(pyramid(4, sqrt(2), 3)), 4)
expect(volume(wedge(4, 2, 3, 1)), (4 + 1) / 2 * 2 * 3)
t = polyhedron([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
expect(volume(t), 1 / 6)
)"},
    {"sweeps", R"(
expect(volume(extrude(polygon([(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0)]), (0, 0, 5))), 10)
expect(area(extrude(polyline([(0, 0, 0), (3, 0, 0), (3, 4, 0)]), (0, 0, 2))), 14)
expect(length(extrude(point((0, 0, 0)), (3, 4, 0))), 5)
expect(volume(revolve(polygon([(1, 0, 0), (2, 0, 0), (2, 0, 3), (1, 0, 3)]), 180)), 4.5 * pi)
)"},
    {"sheets and wires", R"(
p = polygon([(0, 0, 0), (4, 0, 0), (4, 3, 0), (0, 3, 0)], holes=[[(1, 1, 0), (2, 1, 0), (2, 2, 0), (1, 2, 0)]])
expect([area(p), volume(p), count(p), count(p, "faces"), count(p, "edges")], [11, 0, 0, 1, 8])
expect(area(disk(2)), 4 * pi)
expect(length(circle(2)), 4 * pi)
expect(length(arc((0, 0, 0), (1, 0, 0), (0, 1, 0))), pi / 2)
expect(length(line((0, 0, 0), (1, 2, 2))), 3)
expect(area(face(circle(2), ellipse(0.5, 1))), 3.5 * pi, rel=1e-9)
expect(length(arc_through((1, 0, 0), (0, 1, 0), (-1, 0, 0))), pi)
expect(length(arc((0, 0, 0), (1, 0, 0), (0, 1, 0), axis=(0, 0, -1))), 1.5 * pi)
expect(length(polyline([(0, 0, 0), (3, 0, 0), (3, 4, 0)], closed=True)), 12)
expect(centroid(point((1, 2, 3))), (1, 2, 3))
)"},
    {"moves", R"(
b = block(1, 2, 3)
expect(centroid(translate(b, 1, 0, 0)), (1.5, 1, 1.5))
expect(bounds(rotate(b, 90)), ((-2, 0, 0), (0, 1, 3)), abs=1e-12)
expect(volume(scale(b, 2)), 48)
expect(bounds(mirror(b, "xy")), ((0, 0, -3), (1, 2, 0)))
expect(bounds(mirror(b, ((0, 0, 4), (0, 0, 1)))), ((0, 0, 5), (1, 2, 8)))
expect(centroid(transform(b, [1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7])), (5.5, 7, 8.5))
g = grid(b, n=(2, 3, 1), step=(5, 5, 5))
expect([len(g), volume(g[5])], [6, 6])
expect(bounds(g[5]), ((5, 10, 0), (6, 12, 3)))
expect(volume(b), 6)
)"},
    {"booleans", R"(
a = block(2, 2, 2)
b = block(2, 2, 2, at=(1, 1, 1))
expect(volume(a + b), 15)
expect(volume(a & b), 1)
expect(volume(a - b), 7)
expect(volume(symmetric_difference(a, b)), 14)
expect(volume(union(a, b)), 15)
expect(count(union(a, b)), 1)
expect(volume(fragment(a, b)), 15)
expect(count(fragment(a, b)), 3)
expect(volume(union(a, b, block(1, 1, 1, at=(5, 0, 0)))), 16)
expect(volume(union([a, b])), 15)
expect(volume(intersection(a, b, block(1.5, 1.5, 1.5))), 0.125)
expect(volume(a - a), 0)
expect(count(a - a, "vertices"), 0)
expect(volume((a - a) + b), 8)
expect(volume(b - (a - a)), 8)
expect(volume((a - a) & b), 0)
expect(volume((a - a) - b), 0)
expect(volume(union(a - a, a - a)), 0)
expect(check(a + b), 0)
)"},
    {"an empty result is a model", R"(
e = intersection(block(1, 1, 1), block(1, 1, 1, at=(5, 0, 0)))
expect([volume(e), area(e), count(e), count(e, "vertices"), len(faces(e)), check(e)], [0, 0, 0, 0, 0, 0])
print(e)
)"},
    {"touching in lower dimensions", R"(
c = block(1, 1, 1)
expect([count(intersection(c, block(1, 1, 1, at=(1, 0, 0))), k) for k in ["regions", "faces", "edges", "vertices"]], [0, 1, 4, 4])
expect([count(intersection(c, block(1, 1, 1, at=(1, 1, 0))), k) for k in ["regions", "faces", "edges", "vertices"]], [0, 0, 1, 2])
expect([count(intersection(c, block(1, 1, 1, at=(1, 1, 1))), k) for k in ["regions", "faces", "edges", "vertices"]], [0, 0, 0, 1])
)"},
    {"two edges that cross share a vertex", R"(
v = intersection(line((-1, 0, 0), (1, 0, 0)), line((0, -1, 0), (0, 1, 0)))
expect([count(v, "edges"), count(v, "vertices")], [0, 1])
expect(centroid(v), (0, 0, 0), abs=1e-12)
)"},
    {"access", R"(
b = block(1, 2, 3)
expect([len(faces(b)), len(edges(b)), len(vertices(b)), len(regions(b))], [6, 12, 8, 1])
f = nearest(b, (0.5, 1, 9), "face")
expect(centroid(f), (0.5, 1, 3))
expect([len(edges(f)), len(vertices(f)), len(regions(f)), count(f, "faces")], [4, 4, 0, 1])
expect(centroid(nearest(b, (9, 9, 9), "vertex")), (1, 2, 3))
name(f, "top")
attribute(f, "load", 2.5)
expect(centroid(part(b, "top")), (0.5, 1, 3))
expect(attributes(part(b, "top")), [("load", 2.5), ("name", "top")])
expect(area(max(faces(b), key=area)), 6)
expect(f == part(b, "top"), True)
expect(f == faces(b)[0], False)
)"},
    {"names follow, and origins are known", R"(
a = block(2, 2, 2)
b = block(2, 2, 2, at=(1, 1, 1))
name(nearest(a, (1, 1, 0), "face"), "floor")
name(nearest(a, (1, 1, 2), "face"), "roof")
u = a + b
expect(area(part(u, "floor")), 4)
expect(area(part(u, "roof")), 3)
expect(sum([area(f) for f in images(part(a, "roof"), u)]), 3)
expect(sum([area(f) for f in images(part(a, "roof"))]), 3)
expect([area(f) for f in origin(part(u, "roof"))], [4])
expect(count(fragment(a, b), "faces"), len(faces(fragment(a, b))))
)"},
    {"groups", R"(
a = block(1, 1, 1)
b = block(1, 1, 1, at=(1, 0, 0))
w = line((0.5, 0.5, -1), (0.5, 0.5, 2))
g = group(a, w, name="A")
print(g)
d = intersection(g, block(9, 9, 0.5))
expect([count(d), volume(d)], [1, 0.5])
g = group_add(g, b)
expect(volume(g), 2)
expect(volume(group_remove(g, b)), 1)
expect(volume(difference(group(a, b), block(2, 1, 0.25))), 1.5)
f = faces(a)[:2]
t = group(f, name="two")
expect(count(part(a, "two"), "faces"), 2)
)"},
    {"cuts, sections and half-spaces", R"(
s = sphere(1)
above, below = cut(s, (0, 0, 0.5), (0, 0, 1))
cap = pi * 0.5 ** 2 * (3 - 0.5) / 3
expect(volume(above), cap, rel=1e-7)
expect(volume(below), 4 * pi / 3 - cap, rel=1e-7)
expect(area(section(s, (0, 0, 0.5), (0, 0, 1))), 0.75 * pi, rel=1e-7)
pair = fragment(block(1, 1, 2), block(1, 1, 2, at=(1, 0, 0)))
above, below = cut(pair, (0, 0, 0.5), (0, 0, 1))
expect([count(above), count(below), volume(above), volume(below)], [2, 2, 3, 1])
expect(count(section(pair, (0, 0, 0.5), (0, 0, 1)), "faces"), 2)
above, below = cut(pair, (0, 0, 9), (0, 0, 1))
expect([count(above), count(below)], [0, 2])
for z, k in [(1e20, 1), (-1e30, 0), (1e3, 1)]:
    for long in [1, 1e300, 1e-300]:
        halves = cut(pair, (5, 7, z), (0, 0, long))
        expect([volume(h) for h in halves], [volume(pair) * (1 - k), volume(pair) * k])
        expect(count(section(pair, (5, 7, z), (0, 0, long)), "faces"), 0)
above, below = cut(pair, (0, 0, 2), (0, 0, 1))
expect([count(above), count(below)], [0, 2])
above, below = cut(line((0, 0, -1), (0, 0, 3)), (0, 0, 0), (0, 0, 1))
expect([length(above), length(below)], [3, 1])
expect(volume(intersection(block(2, 2, 2), half_space((1, 1, 0.5), (0, 0, 1)))), 2)
expect(volume(block(2, 2, 2) - half_space((1, 1, 0.5), (0, 0, 1))), 6)
)"},
    {"regions from faces", R"(
b = block(1, 2, 3)
expect(count(group(faces(b))), 0)
expect(volume(detect_regions(faces(b))), 6)
expect(genus(group(faces(b))), 0)
)"},
    {"clean-up", R"(
u = block(1, 1, 1) + block(1, 1, 1, at=(1, 0, 0))
expect(count(u, "faces"), 10)
s = simplify(u)
expect([count(s, "faces"), count(s, "edges"), count(s, "vertices")], [6, 12, 8])
expect(volume(s), 2)
)"},
    {"shells and components", R"(
hollow = block(3, 3, 3) - block(1, 1, 1, at=(1, 1, 1))
expect([count(hollow, "shells"), count(hollow, "components"), genus(hollow)], [2, 1, 0])  # the solid joins its two shells
expect(contains(hollow, (1.5, 1.5, 1.5)), False)
expect(contains(hollow, (0.5, 0.5, 0.5)), True)
expect(contains(hollow, (0, 0, 0)), True)
two = union(block(1, 1, 1), block(1, 1, 1, at=(3, 0, 0)))
expect([len(components(two)), count(two, "components")], [2, 2])
)"},
    {"genus where pieces touch in edges", R"(
pieces = block(2, 2, 2, at=(-1, -1, -1)) - cylinder(1, 4, at=(0, 0, -2))
expect(count(pieces), 4)
expect([genus(r) for r in regions(pieces)], [0, 0, 0, 0])
expect(genus(pieces), 0)
expect(volume(pieces), 8 - 2 * pi, rel=1e-7)
)"},
    {"classes", R"(
a = block(2, 2, 2)
b = block(1, 1, 3, at=(0.5, 0.5, 1))
expect(class_counts(a, b), [("AoutB", 6), ("BoutA", 5), ("INTERS", 0), ("AinB", 1), ("BinA", 5)])
expect(len(classes(a, b, kind="face")), 17)
expect(len([c for e, c in classes(a, b, kind="vertex") if c == "INTERS"]), 4)
)"},
};

TEST(Shapes, ScriptsThatAssert) {
  for (const Row& row : rows) {
    const Ran ran = run_shapes(row.script);
    EXPECT_EQ(ran.error, "") << row.what;
  }
}

const struct {
  const char* script;
  const char* error;
} refused[] = {
    {"x = block(0, 1, 1)", "t.ars:1:5: command.range: block: dx must be greater than 0, not 0"},
    {"x = block(1, 1, 1, at=(1, 2))", "t.ars:1:5: command.type: block: at must be a point (x, y, z), not (1, 2)"},
    {"x = cylinder(1, 1, axis=(0, 0, 0))", "t.ars:1:5: command.range: cylinder: axis must be a direction"},
    {"x = torus(1, 2)", "t.ars:1:5: construct.argument: "},
    {"x = cone(0, 0, 1)", "t.ars:1:5: construct.argument: "},
    {"x = prism(2, 1, 1)", "t.ars:1:5: command.range: prism: n must be between 3 and 10000, not 2"},
    {"x = polygon([(0, 0, 0), (1, 0, 0)])", "t.ars:1:5: construct."},
    {"x = polygon([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 1)])", "t.ars:1:5: construct.not_planar"},
    {"x = polygon([(0, 0, 0), (1, 1, 0), (1, 0, 0), (0, 1, 0)])", "t.ars:1:5: construct.self_intersection"},
    {"x = polyhedron([(0, 0, 0)], [[0, 1, 2]])",
     "t.ars:1:5: construct.argument: polyhedron: faces[0] names point 1, but there are only 1"},
    {"x = polyhedron([(0, 0, 0)], [['a']])",
     "t.ars:1:5: command.type: polyhedron: faces[0][0] must be the number of a point, from 0, not 'a'"},
    {"x = union(block(1, 1, 1))", "t.ars:1:5: boolean.too_few_groups: union takes at least two shapes, 1 was given"},
    {"x = union(block(1, 1, 1), 3)",
     "t.ars:1:5: command.type: union: shapes[1] must be a shape or a list of shapes, not 3"},
    {"x = block(1, 1, 1) + 3", "t.ars:1:20: script.type: '+' is not defined between a shape and a whole number"},
    {"x = block(1, 1, 1) * block(1, 1, 1)", "t.ars:1:20: script.type: '*' is not defined between a shape and a shape"},
    {"x = union(block(1, 1, 1), half_space((0, 0, 0), (0, 0, 1)))",
     "t.ars:1:5: command.type: union: the result would reach to infinity"},
    {"x = volume(half_space((0, 0, 0), (0, 0, 1)))",
     "t.ars:1:5: command.type: volume: x must be a shape of a model, not <half-space>"},
    {"x = part(block(1, 1, 1), 'lid')",
     "t.ars:1:5: model.unknown_entity: part: nothing in the shape has the name 'lid'"},
    {"b = block(1, 1, 1, names=True)\nx = part(b, 'botom')",
     "t.ars:2:5: model.unknown_entity: part: nothing in the shape has the name 'botom'; did you mean 'bottom'?"},
    {"x = nearest(line((0, 0, 0), (1, 0, 0)), (0, 0, 0), 'face')",
     "t.ars:1:5: model.unknown_entity: nearest: the shape has no face"},
    {"x = nearest(block(1, 1, 1), (0, 0, 0), 'fase')",
     "t.ars:1:5: command.range: nearest: kind must be one of 'vertex', 'edge', 'face', 'region', not 'fase'; "
     "try: 'face'"},
    {"x = count(block(1, 1, 1), 'holes')", "t.ars:1:5: command.range: count: what must be one of"},
    {"x = mirror(block(1, 1, 1), 'up')",
     "t.ars:1:5: construct.argument: mirror: plane must be 'xy', 'yz', 'xz' or (point, normal)"},
    {"x = scale(block(1, 1, 1), 0)", "t.ars:1:5: command.range: scale: s must be greater than 0, not 0"},
    {"x = transform(block(1, 1, 1), [1, 2])",
     "t.ars:1:5: command.type: transform: matrix must be a list of 12 numbers (it has 2)"},
    {"x = difference(group(block(2, 2, 2), block(2, 2, 2, at=(1, 0, 0))), block(1, 1, 1, at=(5, 0, 0)))",
     "t.ars:1:5: boolean.regions_overlap"},
    {"x = bounds(block(1, 1, 1) - block(2, 2, 2))", "t.ars:1:5: model.unknown_entity: bounds: the shape is empty"},
    {"b = block(1, 1, 1)\nprint(b.volume())", "t.ars:2:9: script.type: a shape has no method 'volume'; try: volume(x)"},
    {"b = block(1, 1, 1)\nattribute(b, 'color', 'notacolor')",
     "t.ars:2:1: draw.bad_color: 'notacolor' is not a colour"},
    {"attribute(block(1, 1, 1), 'color', '#12345')", "t.ars:1:1: draw.bad_color: '#12345' is not a colour"},
    {"attribute(block(1, 1, 1), 'color', '#-12345')", "t.ars:1:1: draw.bad_color: '#-12345' is not a colour"},
    {"attribute(block(1, 1, 1), 'color', 3)",
     "t.ars:1:1: command.type: attribute: the value of \"color\" must be a text, not 3"},
    {"attribute(block(1, 1, 1), 'name', True)",
     "t.ars:1:1: command.type: attribute: the value of \"name\" must be a text, not True"},
    {"x = attribute(block(1, 1, 1), 'a', [1])",
     "t.ars:1:5: command.type: attribute: value must be a number, a text, True or False"},
    {"x = grid(block(1, 1, 1), (1000, 1000, 1000), (1, 1, 1))",
     "t.ars:1:5: construct.argument: grid: at most a million copies"},
    {"volume = volume(block(1, 2, 3))\ny = volume(block(1, 1, 1))",
     "t.ars:2:5: script.type: 'volume' is 6.0, a number, and cannot be called; a variable of that name hides the "
     "command"},
};

TEST(Shapes, RefusedWithPlaceAndReason) {
  for (const auto& row : refused) {
    const Ran ran = run_shapes(row.script);
    EXPECT_EQ(ran.error.substr(0, std::string(row.error).size()), row.error) << row.script;
    EXPECT_EQ(ran.error.find('\n'), std::string::npos);
  }
}

TEST(Shapes, EveryCommandHasHelpThatReads) {
  for (const auto& [name, command] : modeller().commands()) {
    EXPECT_FALSE(command.doc.empty()) << name;
    EXPECT_EQ(command.doc.back(), command.doc.back() == '?' ? '?' : '.') << name << ": " << command.doc;
    EXPECT_FALSE(command.example.empty()) << name;
    EXPECT_TRUE(parse(command.example, name).ok()) << name << ": " << command.example;
    EXPECT_NE(document::Registry::help(command).find("Example:"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace aresta::script
