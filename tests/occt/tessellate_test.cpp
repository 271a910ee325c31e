// SPDX-License-Identifier: Apache-2.0
#include "occt/tessellate.h"

#include <gtest/gtest.h>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_Circle.hxx>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "shapes.h"

namespace aresta::test {
namespace {

constexpr double pi = std::numbers::pi;

Model model_of(const TopoDS_Shape& shape) {
  auto read = to_model(wrap(shape));
  EXPECT_TRUE(read.ok());
  return std::move(read->model);
}

using Key = std::array<double, 3>;
Key key(Vec3 p) {
  return {p.x, p.y, p.z};
}

/// Volume under the triangles of a one-region model; checks that they close without cracks and look outwards.
double closed_volume(const Model& model, const Tessellation& t) {
  double six = 0;
  std::map<std::pair<Key, Key>, int> sides;
  for (const FaceId f : model.topology().faces()) {
    const FaceTriangles& face = t.faces[f.index()];
    EXPECT_EQ(face.points.size(), face.normals.size());
    for (const auto& tri : face.triangles) {
      const Vec3 a = face.points[tri[0]], b = face.points[tri[1]], c = face.points[tri[2]];
      if (key(a) == key(b) || key(b) == key(c) || key(c) == key(a)) continue;  // a pole
      six += dot(a, cross(b, c));
      const Vec3 n = cross(b - a, c - a);
      EXPECT_GT(dot(n, face.normals[tri[0]]), 0);
      ++sides[{key(a), key(b)}];
      ++sides[{key(b), key(c)}];
      ++sides[{key(c), key(a)}];
    }
  }
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(sides.contains({side.second, side.first})) << "a crack";
  }
  return six / 6;
}

TEST(Tessellate, VolumesConvergeToClosedForms) {
  struct Case {
    const char* name;
    TopoDS_Shape shape;
    double volume;
  };
  const gp_Ax2 tilted(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 1));
  const Case cases[] = {
      {"box", box(0, 0, 0, 1, 2, 3), 6},
      {"cylinder", BRepPrimAPI_MakeCylinder(tilted, 1, 2).Shape(), 2 * pi},
      {"cone", BRepPrimAPI_MakeCone(tilted, 1, 0, 3).Shape(), pi},
      {"sphere", BRepPrimAPI_MakeSphere(tilted, 1).Shape(), 4 * pi / 3},
      {"torus", BRepPrimAPI_MakeTorus(tilted, 3, 1).Shape(), 6 * pi * pi},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const Model model = model_of(c.shape);
    double first = -1;
    for (const double deflection : {0.02, 0.002}) {
      TessellationOptions options;
      options.deflection = deflection;
      auto t = tessellate(model, options);
      ASSERT_TRUE(t.ok()) << text(t.error());
      const double off = std::abs(closed_volume(model, *t) - c.volume) / c.volume;
      EXPECT_LE(off, std::max(1e-12, 4 * deflection));
      if (first < 0) {
        first = off;
      } else {
        EXPECT_LE(off, std::max(1e-12, 0.7 * first));
      }
    }
  }
}

TEST(Tessellate, EdgesRunFromStartToEndThroughPointsOfTheirFaces) {
  const Model model = model_of(BRepPrimAPI_MakeCylinder(1, 2).Shape());
  auto t = tessellate(model);
  ASSERT_TRUE(t.ok());
  const Complex& k = model.topology();
  for (const EdgeId e : k.edges()) {
    const auto& line = t->edges[e.index()];
    ASSERT_GE(line.size(), 2u);
    EXPECT_EQ(line.front(), model.point(k.start(e)));
    EXPECT_EQ(line.back(), model.point(k.end(e)));
    for (const CoedgeId c : k.coedges(e)) {
      std::set<Key> points;
      for (const Vec3 p : t->faces[k.face(c).index()].points) points.insert(key(p));
      for (const Vec3 p : line) EXPECT_TRUE(points.contains(key(p)));
    }
  }
}

TEST(Tessellate, WiresAndSheets) {
  const TopoDS_Shape circle =
      BRepBuilderAPI_MakeEdge(new Geom_Circle(gp_Ax2(gp_Pnt(9, 0, 0), gp_Dir(0, 0, 1)), 2.0)).Shape();
  const Model model = model_of(compound({circle, polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})}));
  TessellationOptions options;
  options.deflection = 1e-3;
  auto t = tessellate(model, options);
  ASSERT_TRUE(t.ok()) << text(t.error());
  double length = 0;
  for (const EdgeId e : model.topology().edges()) {
    if (!model.topology().is_wire(e)) continue;
    const auto& line = t->edges[e.index()];
    EXPECT_EQ(line.front(), line.back());
    for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  }
  EXPECT_NEAR(length, 4 * pi, 4 * pi * 1e-3);
  double area = 0;
  for (const auto& tri : t->faces[0].triangles) {
    const auto& p = t->faces[0].points;
    area += 0.5 * norm(cross(p[tri[1]] - p[tri[0]], p[tri[2]] - p[tri[0]]));
  }
  EXPECT_NEAR(area, 1, 1e-12);
}

TEST(Tessellate, TheSameTwice) {
  const Model model = model_of(BRepPrimAPI_MakeTorus(3, 1).Shape());
  auto a = tessellate(model), b = tessellate(model);
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_EQ(a->faces[0].points, b->faces[0].points);
  EXPECT_EQ(a->faces[0].triangles, b->faces[0].triangles);
}

}  // namespace
}  // namespace aresta::test
