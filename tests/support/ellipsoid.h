// SPDX-License-Identifier: Apache-2.0
// An ellipsoid of revolution as files hold it: one NURBS face whose u runs along the meridian, from pole to pole, and
// whose v runs round the axis, periodic.
#pragma once

#include <cmath>
#include <stdexcept>

#include "model/builder.h"

namespace aresta::test {

struct EllipsoidShape {
  double radius = 1, half_height = 1;
  double turn = 0;       ///< radians by which the seam is turned about z
  bool outwards = true;  ///< false: the side of a hollow: material is around it
};

inline void add_ellipsoid(ModelBuilder& builder, const EllipsoidShape& shape) {
  const double s = std::sqrt(0.5), c = std::cos(shape.turn), n = std::sin(shape.turn);
  const double meridian[5][3] = {{0, -1, 1}, {1, -1, s}, {1, 0, 1}, {1, 1, s}, {0, 1, 1}};
  const double around[8][3] = {{1, 0, 1},  {1, 1, s},   {0, 1, 1},  {-1, 1, s},
                               {-1, 0, 1}, {-1, -1, s}, {0, -1, 1}, {1, -1, s}};
  NurbsSurfaceData surface;
  surface.degree_u = surface.degree_v = 2;
  surface.periodic_v = true;
  surface.knots_u = {0, 1, 2};
  surface.multiplicities_u = {3, 2, 3};
  surface.knots_v = {0, 1, 2, 3, 4};
  surface.multiplicities_v = {2, 2, 2, 2, 2};
  surface.count_u = 5;
  surface.count_v = 8;
  NurbsCurveData seam;
  seam.degree = 2;
  seam.knots = surface.knots_u;
  seam.multiplicities = surface.multiplicities_u;
  for (const auto& m : meridian) {
    for (const auto& a : around) {
      const double r = m[0] * shape.radius;
      surface.poles.push_back({r * (c * a[0] - n * a[1]), r * (n * a[0] + c * a[1]), m[1] * shape.half_height});
      surface.weights.push_back(m[2] * a[2]);
    }
    seam.poles.push_back({m[0] * shape.radius * c, m[0] * shape.radius * n, m[1] * shape.half_height});
    seam.weights.push_back(m[2]);
  }
  const auto made = FreeSurface::from_nurbs(surface);
  const auto curve = FreeCurve::from_nurbs(seam);
  if (!made.ok() || !curve.ok()) throw std::runtime_error("an ellipsoid cannot be made");
  const VertexId south = builder.add_vertex({0, 0, -shape.half_height});
  const VertexId north = builder.add_vertex({0, 0, shape.half_height});
  const EdgeId edge = builder.add_edge(south, north, builder.add_curve(*curve), {0, 2});
  // The natural normal points to the axis.
  builder.begin_face(builder.add_surface(*made), shape.outwards);
  const Line2 first{{0, 0}, {1, 0}}, last{{0, 4}, {1, 0}};
  builder.add_coedge(edge, shape.outwards, first);
  builder.add_coedge(edge, !shape.outwards, last);
  builder.close_loop();
  builder.end_face();
  builder.set_fill(Fill::empty, Fill::filled);  // the normal points out of the material
}

}  // namespace aresta::test
