// SPDX-License-Identifier: Apache-2.0
// Measures against closed forms, in place and moved: far away, tiny, turned and mirrored.
#include "model/measure.h"

#include <gtest/gtest.h>

#include "model/measure_shapes.h"

using namespace aresta;
using namespace aresta::testing;

namespace {

Model built(Draft& d) {
  auto model = d.builder.build(Context{});
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.error().to_line());
  return model.ok() ? std::move(model).value() : Model{};
}

struct Expected {
  double volume = 0, area = 0;
  Vec3 centroid{};
  std::array<double, 3> inertia{};  ///< diagonal, about the centroid; zeros: not compared
};

struct Case {
  const char* name;
  std::function<void(Draft&)> add;
  Expected expected;
};

Expected frustum(double r0, double r1, double h) {
  const double volume = pi * h / 3 * (r0 * r0 + r0 * r1 + r1 * r1);
  const double area = pi * (r0 * r0 + r1 * r1 + (r0 + r1) * std::hypot(h, r1 - r0));
  const double z = h / 4 * (r0 * r0 + 2 * r0 * r1 + 3 * r1 * r1) / (r0 * r0 + r0 * r1 + r1 * r1);
  return {volume, area, {0, 0, z}, {}};
}

std::vector<Case> cases() {
  std::vector<Case> list;
  list.push_back({"block",
                  [](Draft& d) {
                    add_block(d, {1, 2, 3}, {3, 5, 7});
                  },
                  {24, 52, {2, 3.5, 5}, {24 * (9.0 + 16) / 12, 24 * (4.0 + 16) / 12, 24 * (4.0 + 9) / 12}}});
  list.push_back(
      {"frame",
       [](Draft& d) { add_frame(d); },
       {12,
        24 + 16 + 8,
        {2, 2, 0.5},
        {(16 * (16.0 + 1) - 4 * (4.0 + 1)) / 12, (16 * (16.0 + 1) - 4 * (4.0 + 1)) / 12, (16 * 32.0 - 4 * 8.0) / 12}}});
  for (const Seam seam : {Seam::none, Seam::bare, Seam::with_images}) {
    const double r = 2, h = 5, m = pi * r * r * h;
    list.push_back({"cylinder",
                    [=](Draft& d) { add_frustum(d, r, r, h, seam); },
                    {m,
                     2 * pi * r * h + 2 * pi * r * r,
                     {0, 0, h / 2},
                     {m * (3 * r * r + h * h) / 12, m * (3 * r * r + h * h) / 12, m * r * r / 2}}});
    list.push_back({"frustum", [=](Draft& d) { add_frustum(d, 3, 1, 4, seam); }, frustum(3, 1, 4)});
    list.push_back({"widening frustum", [=](Draft& d) { add_frustum(d, 1, 3, 4, seam); }, frustum(1, 3, 4)});
    Expected cone = frustum(3, 0, 4);
    cone.inertia = {cone.volume * 3 / 80 * (4 * 9 + 16), cone.volume * 3 / 80 * (4 * 9 + 16), cone.volume * 0.3 * 9};
    list.push_back({"cone", [=](Draft& d) { add_frustum(d, 3, 0, 4, seam); }, cone});
    const double v = 4.0 / 3 * pi * 27;
    list.push_back({"sphere",
                    [=](Draft& d) { add_sphere(d, 3, seam); },
                    {v, 4 * pi * 9, {}, {0.4 * v * 9, 0.4 * v * 9, 0.4 * v * 9}}});
    const double t = 2 * pi * pi * 5 * 4;
    list.push_back({"torus",
                    [=](Draft& d) { add_torus(d, 5, 2, seam); },
                    {t,
                     4 * pi * pi * 10,
                     {},
                     {t * (5.0 / 8 * 4 + 0.5 * 25), t * (5.0 / 8 * 4 + 0.5 * 25), t * (3.0 / 4 * 4 + 25)}}});
  }
  for (const double c : {-1.5, 0.0, 1.5, 1.99}) {
    const double r = 2, h = r - c, volume = pi * h * h * (3 * r - h) / 3,
                 z = 3 * (2 * r - h) * (2 * r - h) / 4 / (3 * r - h);
    const double area = 2 * pi * r * h + pi * (r * r - c * c);
    list.push_back({"cap", [=](Draft& d) { add_cap(d, r, c); }, {volume, area, {0, 0, z}, {}}});
    list.push_back({"side cap", [=](Draft& d) { add_side_cap(d, r, c); }, {volume, area, {z, 0, 0}, {}}});
  }
  // Half a torus: centroid by Pappus, (R^2 + r^2 / 4) 2 / (pi R).
  list.push_back({"half torus",
                  [](Draft& d) { add_half_torus(d, 5, 2); },
                  {pi * pi * 5 * 4, 2 * pi * pi * 10 + 2 * pi * 4, {0, 2 * (25 + 1.0) / (pi * 5), 0}, {}}});
  list.push_back({"upper half of a torus",
                  [](Draft& d) { add_upper_torus(d, 5, 2); },
                  {pi * pi * 5 * 4, 2 * pi * pi * 10 + pi * (49 - 9.0), {0, 0, 4 * 2 / (3 * pi)}, {}}});
  const double s = 0.75;  // z-moment: integral of (h + s x)^2 / 2 over the disc
  list.push_back({"oblique cylinder",
                  [=](Draft& d) { add_oblique(d, 2, 5, s); },
                  {pi * 4 * 5,
                   2 * pi * 2 * 5 + pi * 4 + pi * 4 * std::hypot(1, s),
                   {s * 4 / (4 * 5), 0, (25 + s * s * 4 / 4) / (2 * 5)},
                   {}}});
  list.push_back({"Steinmetz", [](Draft& d) { add_steinmetz(d, 2); }, {128.0 / 3, 64, {}, {}}});
  return list;
}

void compare(const Case& c, const Transform& t, double factor, double slack) {
  SCOPED_TRACE(c.name);
  Draft d(t);
  c.add(d);
  const Model model = built(d);
  const auto regions = model.regions();
  ASSERT_EQ(regions.size(), 1u);
  const double size = model.bounds().diagonal();
  const auto m = measure(model, regions[0]);
  ASSERT_TRUE(m.ok()) << m.error().to_line();
  const double volume = c.expected.volume * factor * factor * factor;
  EXPECT_NEAR(m->measure / volume, 1, slack);
  EXPECT_LE(std::abs(m->measure - volume), std::max(m->error, 1e-14 * volume)) << "the stated error is too small";
  EXPECT_LE(m->error, 10 * slack * volume) << "the stated error is too large";
  EXPECT_LE(distance(m->centroid(), t.point(c.expected.centroid)), slack * size);
  const auto area = total_area(model);
  ASSERT_TRUE(area.ok()) << area.error().to_line();
  EXPECT_NEAR(*area / (c.expected.area * factor * factor), 1, slack);
  if (c.expected.inertia[0] != 0) {
    // Turned about a general axis only the trace stays.
    const auto inertia = m->inertia();
    const double power = std::pow(factor, 5), trace = inertia[0] + inertia[1] + inertia[2];
    EXPECT_NEAR(trace / (c.expected.inertia[0] + c.expected.inertia[1] + c.expected.inertia[2]) / power, 1, slack);
    if (t.rows[0] == Vec3{factor, 0, 0}) {
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(inertia[i] / c.expected.inertia[i] / power, 1, slack);
      for (std::size_t i = 3; i < 6; ++i) EXPECT_NEAR(inertia[i] / c.expected.inertia[0] / power, 0, slack);
    }
  }
}

}  // namespace

TEST(Measure, ClosedForms) {
  for (const Case& c : cases()) compare(c, {}, 1, 1e-10);
}

TEST(Measure, Turned) {
  const Transform t = Transform::rotation(37, {1, 2, -0.5}, {3, 1, 2});
  for (const Case& c : cases()) compare(c, t, 1, 1e-10);
}

TEST(Measure, FarFromTheOrigin) {
  // Coordinates of 1e6 carry 1e-10 of rounding each, which a thin cap feels most.
  const Transform t = Transform::translation({1e6, -2e6, 1.5e6});
  for (const Case& c : cases()) compare(c, t, 1, c.expected.volume > 1 ? 1e-8 : 1e-6);
}

TEST(Measure, Tiny) {
  for (const Case& c : cases()) compare(c, Transform::scaling(1e-6), 1e-6, 1e-10);
}

TEST(Measure, Huge) {
  for (const Case& c : cases()) compare(c, Transform::scaling(1e6), 1e6, 1e-10);
}

TEST(Measure, Mirrored) {
  for (const Case& c : cases()) compare(c, Transform::reflection({0.3, 0, 0}, {1, 1, 0.2}), 1, 1e-10);
}

TEST(Measure, EdgesOffTheSurfaceCountByTheirFeet) {
  // A sphere in two halves whose common edge leaves it by a hundredth of the radius, as edges with tolerances do: its
  // feet divide the sphere, so that the halves' areas add up to the whole; by symmetry each is half of it.
  const double r = 2, off = 1.02;
  ModelBuilder b;
  const VertexId v = b.add_vertex({r * off, 0, 0}, 0.1);
  const EdgeId e = b.add_edge(v, v, b.add_curve(Circle{{}, r * off}), {0, 2 * pi}, 0.1);
  // A wave about the equator at changing heights: feet on both sides of it, off the sphere by different distances.
  const VertexId w = b.add_vertex({r * 1.01, 0, 0}, 0.1);
  const EdgeId tilted = b.add_edge(
      w, w,
      b.add_curve(Ellipse{{{}, {1, 0, 0}, normalized({0, 1, 0.3}), normalized({0, -0.3, 1})}, r * 1.01, r * 0.98}),
      {0, 2 * pi}, 0.1);
  for (const EdgeId rim : {e, tilted}) {
    for (const bool upper : {true, false}) {
      b.begin_face(b.add_surface(Sphere{{}, r}), false, 0);
      b.add_coedge(rim, !upper);
      b.close_loop();
      b.end_face();
    }
  }
  const auto cells = b.find_cells(Context{});
  ASSERT_TRUE(cells.ok()) << cells.error().to_line();
  auto model = b.build(*cells, std::vector<bool>(cells->count, false));
  ASSERT_TRUE(model.ok());
  for (const FaceId f : model->topology().faces()) {
    const auto m = measure(*model, f);
    ASSERT_TRUE(m.ok());
    EXPECT_NEAR(m->measure, 2 * pi * r * r, 1e-9) << "face " << f.value;
  }
}
