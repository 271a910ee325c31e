// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <numeric>

#include "base/union_find.h"
#include "construct/arguments.h"
#include "construct/planar.h"
#include "construct/primitives.h"
#include "model/check.h"

namespace aresta {

namespace {

std::string face_text(std::size_t f) {
  return "face " + std::to_string(f);
}

std::array<double, 3> place_of(Vec3 p) {
  return {p.x, p.y, p.z};
}

/// Points nearer than the tolerance get the smallest index among them: sorted by x, compared within the strip.
std::vector<std::size_t> merge_points(std::span<const Vec3> points, double tolerance) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return std::pair(points[a].x, a) < std::pair(points[b].x, b); });
  UnionFind same(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size() && points[order[j]].x - points[order[i]].x <= tolerance; ++j) {
      if (distance(points[order[i]], points[order[j]]) <= tolerance) same.unite(order[i], order[j]);
    }
  }
  std::vector<std::size_t> first(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) first[i] = same.find(i);
  return first;
}

struct Mesh {
  std::vector<Vec3> points;
  std::vector<std::vector<IndexLoop>> faces;
};

/// Renumbers the points that faces use and checks the indices.
Result<Mesh> read_faces(std::span<const Vec3> points, std::span<const PolyhedronFace> faces, double tolerance) {
  const std::vector<std::size_t> same = merge_points(points, tolerance);
  Mesh mesh;
  std::vector<std::size_t> number(points.size(), points.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    auto& loops = mesh.faces.emplace_back();
    Arguments arguments("polyhedron");
    arguments.require(!faces[f].loops.empty(), face_text(f), "a list of at least one loop", "an empty list");
    ARESTA_CHECK(arguments.status());
    for (const auto& given : faces[f].loops) {
      arguments.require(given.size() >= 3, face_text(f), "made of loops of three points or more",
                        "one of " + std::to_string(given.size()));
      ARESTA_CHECK(arguments.status());
      IndexLoop loop;
      for (const std::size_t i : given) {
        arguments.require(i < points.size(), face_text(f),
                          "made of indices below the number of points, " + std::to_string(points.size()),
                          "of index " + std::to_string(i));
        ARESTA_CHECK(arguments.status());
        std::size_t& n = number[same[i]];
        if (n == points.size()) {
          n = mesh.points.size();
          mesh.points.push_back(points[same[i]]);
        }
        if (!loop.empty() && loop.back() == n) {
          return Error{errors::points_coincide,
                       "polyhedron: two neighbouring points of " + face_text(f) + " coincide within the tolerance " +
                           number_text(tolerance),
                       {},
                       place_of(points[i])};
        }
        loop.push_back(n);
      }
      if (loop.front() == loop.back()) {
        return Error{errors::points_coincide,
                     "polyhedron: the first and last point of a loop of " + face_text(f) + " coincide",
                     {},
                     place_of(mesh.points[loop.front()]),
                     "leave the last one out: loops close by themselves"};
      }
      loops.push_back(std::move(loop));
    }
  }
  return mesh;
}

/// Each face plane, simple, with area; holes turned against the outer loop.
Status check_faces(Mesh& mesh, double tolerance, const Context& context) {
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (f % 256 == 0) {
      ARESTA_CHECK(context.step(0.3 * static_cast<double>(f) / static_cast<double>(mesh.faces.size()),
                                "checking the faces of the polyhedron"));
    }
    auto& loops = mesh.faces[f];
    const Vec3 area = newell(mesh.points, loops[0]);
    double extent = 0;
    for (const std::size_t i : loops[0]) extent = std::max(extent, distance(mesh.points[i], mesh.points[loops[0][0]]));
    if (norm(area) <= extent * tolerance) {
      return Error{errors::bad_size,
                   "polyhedron: " + face_text(f) + " has no area: its points lie on one line",
                   {},
                   place_of(mesh.points[loops[0][0]])};
    }
    double deviation = 0;
    const Frame plane = plane_of(mesh.points, loops[0], &deviation);
    for (const IndexLoop& loop : loops) {
      for (const std::size_t i : loop) deviation = std::max(deviation, std::abs(plane.to_local(mesh.points[i]).z));
    }
    if (deviation > tolerance) {
      return Error{errors::not_planar,
                   "polyhedron: the points of " + face_text(f) + " do not lie in one plane: they deviate by " +
                       number_text(deviation) + ", allowed is " + number_text(tolerance),
                   {},
                   place_of(mesh.points[loops[0][0]]),
                   "split the face into triangles, or give a larger tolerance"};
    }
    if (const auto crossing = find_crossing(mesh.points, loops, plane, tolerance)) {
      return Error{errors::self_intersection,
                   "polyhedron: the boundary of " + face_text(f) + " meets itself (segments " +
                       std::to_string(crossing->first) + " and " + std::to_string(crossing->second) + ")",
                   {},
                   place_of(crossing->place)};
    }
    for (std::size_t l = 1; l < loops.size(); ++l) {
      if (dot(newell(mesh.points, loops[l]), plane.z) > 0) std::reverse(loops[l].begin(), loops[l].end());
    }
  }
  return {};
}

/// Every edge is used as often one way as the other, or the faces enclose nothing.
Status check_closed(const Mesh& mesh) {
  struct Uses {
    int forward = 0, backward = 0;
    std::size_t face = 0;
  };
  std::map<std::pair<std::size_t, std::size_t>, Uses> uses;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (const IndexLoop& loop : mesh.faces[f]) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::size_t a = loop[i], b = loop[(i + 1) % loop.size()];
        Uses& u = uses[std::minmax(a, b)];
        (a < b ? u.forward : u.backward) += 1;
        u.face = f;
      }
    }
  }
  for (const auto& [ends, u] : uses) {
    if (u.forward == u.backward) continue;
    const Vec3 middle = 0.5 * (mesh.points[ends.first] + mesh.points[ends.second]);
    const bool open = u.forward + u.backward == 1;
    return Error{open ? errors::not_closed : errors::inside_out,
                 open ? "polyhedron: an edge of " + face_text(u.face) + " has no other face"
                      : "polyhedron: the faces at an edge of " + face_text(u.face) + " do not look the same way: " +
                            std::to_string(u.forward) + " run along it and " + std::to_string(u.backward) + " against",
                 {},
                 place_of(middle),
                 open ? "" : "loops run counterclockwise seen from outside"};
  }
  return {};
}

double volume_of(const Mesh& mesh) {
  double six_volumes = 0;
  const Vec3 origin = mesh.points[0];
  for (const auto& loops : mesh.faces) {
    for (const IndexLoop& loop : loops) six_volumes += dot(newell(mesh.points, loop), mesh.points[loop[0]] - origin);
  }
  return six_volumes / 6;
}

}  // namespace

Result<Model> polyhedron(std::span<const Vec3> points, std::span<const PolyhedronFace> faces,
                         const ConstructOptions& options, const Context& context) {
  Arguments arguments("polyhedron");
  arguments.require(points.size() >= 4, "points", "a list of four or more", std::to_string(points.size()));
  arguments.require(faces.size() >= 4, "faces", "a list of four or more", std::to_string(faces.size()));
  arguments.points("points", points);
  arguments.options(options);
  ARESTA_CHECK(arguments.status());
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  const double tolerance = working_tolerance(box, options);
  ARESTA_TRY(Mesh mesh, read_faces(points, faces, tolerance));
  ARESTA_CHECK(check_faces(mesh, tolerance, context));
  ARESTA_CHECK(check_closed(mesh));
  if (volume_of(mesh) <= 0) {
    return Error{errors::inside_out,
                 "polyhedron: the faces enclose the volume " + number_text(volume_of(mesh)) + ": they look inward",
                 {},
                 {},
                 "list each face counterclockwise as seen from outside"};
  }
  ModelBuilder builder;
  builder.tolerance = std::max(options.tolerance, rounding_tolerance(box));
  builder.length_unit = options.length_unit;
  PlanarParts parts(builder, mesh.points);
  for (const auto& loops : mesh.faces) parts.add_face(loops);
  Result<Model> model = builder.build(context);
  if (!model.ok()) {
    const ErrorCode code = model.error().code;
    if (code == errors::open_solid || code == errors::ambiguous_fill) {
      model.error().code = errors::inside_out;
      model.error().message = "polyhedron: " + model.error().message;
    }
    return model;
  }
  ARESTA_CHECK(require_valid(*model, CheckLevel::full, context));
  return model;
}

}  // namespace aresta
