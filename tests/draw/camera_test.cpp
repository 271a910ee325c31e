// SPDX-License-Identifier: Apache-2.0
#include "draw/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "draw/errors.h"

namespace aresta::draw {
namespace {

void expect_near(Vec3 a, Vec3 b, double eps = 1e-12) {
  EXPECT_LT(distance(a, b), eps) << a.x << ' ' << a.y << ' ' << a.z;
}

/// Where the world's axes point to in each view: {right, up} in the picture and the axis that comes towards the eye.
TEST(Camera, StandardViewsAreRightHandedWithZUp) {
  struct Row {
    StandardView view;
    Vec3 right, up, back;
  };
  const double h = std::sqrt(0.5), s = std::sqrt(1.0 / 6), t = std::sqrt(1.0 / 3);
  const Row rows[] = {
      {StandardView::iso, {h, h, 0}, {-s, s, 2 * s}, {t, -t, t}},
      {StandardView::front, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
      {StandardView::back, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
      {StandardView::left, {0, -1, 0}, {0, 0, 1}, {-1, 0, 0}},
      {StandardView::right, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}},
      {StandardView::top, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      {StandardView::bottom, {1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
  };
  for (const Row& row : rows) {
    const Projector p(standard_camera(row.view), {});
    SCOPED_TRACE(to_string(row.view));
    expect_near(p.right(), row.right);
    expect_near(p.up(), row.up);
    expect_near(-p.forward(), row.back);
    ASSERT_TRUE(standard_view(to_string(row.view)).ok());
    EXPECT_EQ(*standard_view(to_string(row.view)), row.view);
  }
  const auto unknown = standard_view("sideways");
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.error().code, errors::draw_unknown_view);
  EXPECT_NE(unknown.error().hint.find("iso, front, back"), std::string::npos);
}

TEST(Camera, ParallelProjectionByHand) {
  Camera camera = standard_camera(StandardView::front);
  camera.eye = {0, -10, 0};
  camera.target = {0, 0, 0};
  camera.view_width = 8;  // 100 pixels a unit
  const Projector p(camera, {800, 600});
  expect_near(p.to_screen({0, 0, 0}), {400, 300, 10});
  expect_near(p.to_screen({1, 5, 2}), {500, 100, 15});
  EXPECT_DOUBLE_EQ(p.pixel_size(3), 0.01);
  expect_near(p.to_world(p.screen_to_view({500, 100}, 15)), {1, 5, 2});
}

TEST(Camera, PerspectiveProjectionByHand) {
  Camera camera = standard_camera(StandardView::front, Projection::perspective);
  camera.eye = {0, -10, 0};
  camera.target = {0, 0, 0};
  camera.field_of_view = 90;  // half the width is seen at a slope of one
  const Projector p(camera, {800, 600});
  expect_near(p.to_screen({1, 0, 0}), {440, 300, 10}, 1e-11);
  expect_near(p.to_screen({-10, 0, 5}), {0, 100, 10}, 1e-11);
  expect_near(p.to_screen({10, 10, 0}), {600, 300, 20}, 1e-11);
  expect_near(p.to_world(p.screen_to_view({600, 300}, 20)), {10, 10, 0}, 1e-11);
}

TEST(Camera, FitTouchesTheMargin) {
  const Box3 box{{2, 3, 4}, {6, 5, 5}};
  for (const StandardView view : {StandardView::iso, StandardView::front, StandardView::top, StandardView::left}) {
    for (const Projection projection : {Projection::parallel, Projection::perspective}) {
      const Viewport viewport{800, 500};
      const Projector p(fit(standard_camera(view, projection), viewport, box, 0.1), viewport);
      double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
      for (int i = 0; i < 8; ++i) {
        const Vec3 s = p.to_screen(
            {i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y, i & 4 ? box.high.z : box.low.z});
        left = std::min(left, s.x), right = std::max(right, s.x), top = std::min(top, s.y),
        bottom = std::max(bottom, s.y);
      }
      // The picture is 800 x 500 with a tenth left free: 640 x 400 to be filled in one direction, centred in both.
      EXPECT_NEAR(std::max((right - left) / 640, (bottom - top) / 400), 1, 1e-6);
      EXPECT_NEAR(left + right, 800, 1e-3);
      EXPECT_NEAR(top + bottom, 500, 1e-3);
    }
  }
}

TEST(Camera, FitOfOnePointIsAViewOfWidthOne) {
  Box3 box;
  box.add(Vec3{5, 6, 7});
  const Camera camera = fit(standard_camera(StandardView::iso), {100, 100}, box, 0);
  EXPECT_DOUBLE_EQ(camera.view_width, 1);
  expect_near(camera.target, {5, 6, 7}, 1e-12);
  EXPECT_TRUE(check_view(camera, {100, 100}).ok());
}

TEST(Camera, BadCamerasAndSizes) {
  const Camera good = standard_camera(StandardView::iso);
  EXPECT_TRUE(check_view(good, {1, 1}).ok());
  for (const Viewport v : {Viewport{0, 10}, Viewport{10, 0}, Viewport{-1, 10}, Viewport{32769, 10}}) {
    EXPECT_EQ(check_view(good, v).error().code, errors::draw_bad_size);
  }
  Camera c = good;
  c.eye = c.target;
  EXPECT_EQ(check_view(c, {}).error().code, errors::draw_bad_camera);
  c = good;
  c.up = 3.0 * (c.target - c.eye);
  EXPECT_EQ(check_view(c, {}).error().code, errors::draw_bad_camera);
  c = good;
  c.eye.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(check_view(c, {}).error().code, errors::draw_bad_camera);
  c = good;
  c.view_width = 0;
  EXPECT_EQ(check_view(c, {}).error().code, errors::draw_bad_camera);
  c = good;
  c.projection = Projection::perspective;
  c.field_of_view = 180;
  EXPECT_EQ(check_view(c, {}).error().code, errors::draw_bad_camera);
}

}  // namespace
}  // namespace aresta::draw
