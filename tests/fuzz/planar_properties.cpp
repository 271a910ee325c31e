// SPDX-License-Identifier: Apache-2.0
#include "fuzz/planar_properties.h"

#include <cmath>
#include <map>

#include "planar/cells.h"
#include "planar/imprint.h"
#include "planar/meshes.h"
#include "planar/soups.h"
#include "planar/triangle_mesh.h"

namespace aresta::test {

namespace {

using namespace planar;

constexpr double tolerance = 1e-8;

/// Numbers from bytes; zeros when they are used up.
class Numbers {
 public:
  explicit Numbers(std::string_view bytes) : bytes_(bytes) {}
  bool more() const { return at_ < bytes_.size(); }
  int below(int n) { return more() ? static_cast<unsigned char>(bytes_[at_++]) % n : 0; }
  /// On a grid of quarters, one in eight moved by up to some tolerances.
  double coordinate() {
    const double x = below(17) * 0.25;
    constexpr double small[] = {1e-16, 4e-16, 1e-12, 3e-9, 9e-9, 1.1e-8, 3e-8, 1e-6};
    if (below(8) != 0) return x;
    const double d = small[below(8)];
    return below(2) == 0 ? x + d : x - d;
  }
  Vec3 point() {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

std::pair<Vec3, Vec3> low_and_high(Vec3 a, Vec3 b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
          {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
}

void add_tetrahedron(TriangleMesh& mesh, Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  if (dot(cross(b - a, c - a), d - a) < 0) std::swap(b, c);
  const auto first = static_cast<Index>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {a, b, c, d});
  for (const auto& [i, j, k] : {std::array<Index, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
    mesh.triangles.push_back({first + i, first + j, first + k});
}

TriangleMesh read_mesh(Numbers& in) {
  TriangleMesh mesh;
  if (in.below(2) == 0) {
    const Vec3 a = in.point();
    const auto [low, high] = low_and_high(a, in.point());
    planar::test::add_box(mesh, low, high);
  } else {
    const Vec3 a = in.point(), b = in.point(), c = in.point();
    add_tetrahedron(mesh, a, b, c, in.point());
  }
  return mesh;
}

bool is_closed(const TriangleMesh& mesh) {
  std::map<IndexPair, int> runs;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3];
      runs[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  for (const auto& [edge, count] : runs) {
    if (count != 0) return false;
  }
  return true;
}

std::string conserved(const Soup& soup, const Imprinted& pieces) {
  const auto vertices = static_cast<Index>(soup.points.size()), edges = soup.shape.edge_count();
  std::vector<double> length(edges, 0), area(soup.shape.face_count(), 0);
  const auto area_of = [](const std::vector<Vec3>& points, const Incidence& shape, Index f, double& perimeter) {
    const Index first = shape.loop_begin[shape.face_begin[f]], last = shape.loop_begin[shape.face_begin[f + 1]];
    Vec3 sum;
    const Vec3 o = points[shape.edges[shape.coedges[first] / 2][0]];
    for (Index c = first; c < last; ++c) {
      const auto& e = shape.edges[shape.coedges[c] / 2];
      const Vec3 a = points[e[shape.coedges[c] % 2]], b = points[e[1 - shape.coedges[c] % 2]];
      sum += cross(a - o, b - o);
      perimeter += distance(a, b);
    }
    return 0.5 * norm(sum);
  };
  double unused = 0;
  for (Index e = 0; e < pieces.shape.edge_count(); ++e) {
    const auto& [a, b] = pieces.shape.edges[e];
    for (const Index name : pieces.edge_names[e]) {
      if (name >= vertices && name < vertices + edges)
        length[name - vertices] += distance(pieces.points[a], pieces.points[b]);
    }
  }
  for (Index f = 0; f < pieces.shape.face_count(); ++f) {
    const double part = area_of(pieces.points, pieces.shape, f, unused);
    for (const Index name : pieces.face_names[f]) area[name - vertices - edges] += part;
  }
  for (Index e = 0; e < edges; ++e) {
    const double whole = distance(soup.points[soup.shape.edges[e][0]], soup.points[soup.shape.edges[e][1]]);
    if (std::abs(length[e] - whole) > 20 * tolerance)
      return "edge " + std::to_string(e) + " of length " + std::to_string(whole) + " has pieces of " +
             std::to_string(length[e]);
  }
  for (Index f = 0; f < soup.shape.face_count(); ++f) {
    double perimeter = 0;
    const double whole = area_of(soup.points, soup.shape, f, perimeter);
    if (std::abs(area[f] - whole) > 20 * tolerance * perimeter)
      return "face " + std::to_string(f) + " of area " + std::to_string(whole) + " has pieces of " +
             std::to_string(area[f]);
  }
  return {};
}

}  // namespace

Verdict check_planar_groups(std::string_view bytes) {
  Numbers in(bytes);
  planar::test::SoupMaker maker;
  for (int o = 0; o < 4 && (o == 0 || in.more()); ++o) {
    // Nobody vouches for an operand of several entities.
    const int count = 1 + in.below(3);
    maker.operand(count == 1);
    for (int i = 0; i < count; ++i) {
      const Vec3 a = in.point(), b = in.point();
      switch (in.below(4)) {
        case 0: {
          const auto [low, high] = low_and_high(a, b);
          maker.box(low, high);
          break;
        }
        case 1:
          maker.polygon(std::vector<Vec3>{a, b, in.point()});
          break;
        case 2:
          maker.segment(a, b);
          break;
        default: {
          const int axis = in.below(3);  // a rectangle
          Vec3 c = b;
          c[axis] = a[axis];
          Vec3 along = a;
          along[(axis + 1) % 3] = c[(axis + 1) % 3];
          Vec3 across = a;
          across[(axis + 2) % 3] = c[(axis + 2) % 3];
          maker.polygon(std::vector<Vec3>{a, along, c, across});
        }
      }
    }
  }
  Verdict verdict;
  auto pieces = imprint(maker.soup(), tolerance, {});
  if (!pieces.ok()) return verdict;
  verdict.wrong = conserved(maker.soup(), *pieces);
  if (!verdict.wrong.empty() || !order_radially(pieces->faces(), pieces->shape).ok()) return verdict;
  verdict.accepted = find_cells(pieces->faces(), {}).ok();
  return verdict;
}

Verdict check_planar_meshes(std::string_view bytes) {
  Numbers in(bytes);
  const TriangleMesh a = read_mesh(in), b = read_mesh(in);
  Verdict verdict;
  std::array<double, 3> volumes{};
  for (const MeshOperation operation : {MeshOperation::unite, MeshOperation::intersect, MeshOperation::subtract}) {
    const auto result = combine(a, b, operation, {.tolerance = tolerance}, {});
    if (!result.ok()) return verdict;
    if (!is_closed(result->mesh)) verdict.wrong = "a result is not closed";
    volumes[static_cast<std::size_t>(operation)] = result->volume;
  }
  verdict.accepted = true;
  const double one = planar::test::volume(a), two = planar::test::volume(b), allowed = 1e3 * tolerance;
  if (std::abs(volumes[0] + volumes[1] - one - two) > allowed || std::abs(volumes[1] + volumes[2] - one) > allowed)
    verdict.wrong = "volumes do not fit: union " + std::to_string(volumes[0]) + ", intersection " +
                    std::to_string(volumes[1]) + ", difference " + std::to_string(volumes[2]) + " of " +
                    std::to_string(one) + " and " + std::to_string(two);
  return verdict;
}

}  // namespace aresta::test
