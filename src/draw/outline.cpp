// SPDX-License-Identifier: Apache-2.0
#include "draw/outline.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace aresta::draw {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

std::uint64_t mixed(std::uint64_t h) {
  h ^= h >> 33;
  h *= 0xff51afd7ed558ccdull;
  h ^= h >> 33;
  h *= 0xc4ceb9fe1a85ec53ull;
  return h ^ (h >> 33);
}

using SideKey = std::uint64_t;

SideKey side_key(std::uint32_t a, std::uint32_t b) {
  return (SideKey(std::min(a, b)) << 32) | std::max(a, b);
}

/// A side of a triangle.
struct Side {
  SideKey key;
  std::uint32_t triangle;
  bool forwards;  ///< from the smaller number to the larger
};

struct Sliver {
  std::uint32_t triangle;
  SideKey longest;
};

/// A segment of one of the scene's edges.
struct EdgeSegment {
  SideKey key;
  std::uint32_t edge;  ///< in Scene::edges
};

struct Fold {
  std::uint32_t patch;
  std::uint32_t edge;  ///< in Scene::edges, or none
  std::uint32_t a, b;
  bool behind;
};

/// Chains folds of one patch and edge into lines.
void chain(const Scene& scene, const PointNumbers& numbers, const Fold* first, const Fold* last,
           std::vector<DrawnLine>& lines) {
  struct End {
    std::uint32_t point, fold;
  };
  const std::size_t n = last - first;
  std::vector<End> ends;
  for (std::uint32_t i = 0; i < n; ++i) {
    ends.push_back({first[i].a, i});
    ends.push_back({first[i].b, i});
  }
  std::sort(ends.begin(), ends.end(),
            [](End x, End y) { return x.point != y.point ? x.point < y.point : x.fold < y.fold; });
  const auto range = [&](std::uint32_t point) {
    return std::equal_range(ends.begin(), ends.end(), End{point, 0}, [](End x, End y) { return x.point < y.point; });
  };
  std::vector<bool> used(n, false);
  const auto follow = [&](std::uint32_t start) {
    DrawnLine line;
    line.kind = LineKind::silhouette;
    line.face = scene.faces[first->patch].face;
    line.faces = {line.face};
    if (first->edge != none) {
      line.edge = scene.edges[first->edge].edge;
      line.faces = scene.edges[first->edge].faces;
    }
    line.points.push_back(numbers.place(start));
    for (std::uint32_t at = start;;) {
      const auto [from, to] = range(at);
      if (line.points.size() > 1 && to - from != 2) break;  // ends and forks begin and end lines
      const auto next = std::find_if(from, to, [&](End e) { return !used[e.fold]; });
      if (next == to) break;
      used[next->fold] = true;
      line.behind.push_back(first[next->fold].behind);
      at = first[next->fold].a == at ? first[next->fold].b : first[next->fold].a;
      line.points.push_back(numbers.place(at));
    }
    lines.push_back(std::move(line));
  };
  const auto has_unused = [&](std::uint32_t point) {
    const auto [from, to] = range(point);
    return std::any_of(from, to, [&](End e) { return !used[e.fold]; });
  };
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const auto [from, to] = range(ends[i].point);
    if (to - from == 2) continue;
    while (has_unused(ends[i].point)) follow(ends[i].point);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    if (!used[i]) follow(first[i].a);
  }
}

/// What the normals of a patch say of a silhouette.
class RadialCurvature {
 public:
  RadialCurvature(const Scene& scene, const TriangleSoup& soup, const Projector& projector)
      : scene_(scene), soup_(soup), projector_(projector) {}

  /// Whether the fold between two triangles lies behind the surface that they stand for, though it is convex towards
  /// the eye. `faces_eye` is of the first; `same_sense`: the fronts of both are on one side.
  bool is_behind(std::uint32_t p, std::uint32_t q, bool faces_eye, bool same_sense) const {
    const double own = of(p), other = same_sense ? of(q) : -of(q);
    const auto c = corners(p);
    Vec3 towards_eye = cross(c[1] - c[0], c[2] - c[0]);
    if (!faces_eye) towards_eye = -towards_eye;
    // Of the two, which lie on one side of the fold in the picture, the second is nearer when it is before the plane of
    // the first. The near one is seen from its side that faces the eye.
    double ahead = 0;
    for (const Vec3 corner : corners(q)) {
      const double d = dot(towards_eye, corner - c[0]);
      if (std::abs(d) > std::abs(ahead)) ahead = d;
    }
    const double seen_side = (ahead > 0) == faces_eye ? -1 : 1;
    return seen_side * (own + other) < -least;
  }

 private:
  static constexpr double least = 1e-6;

  std::array<Vec3, 3> corners(std::uint32_t t) const {
    const auto& c = soup_.corners[t];
    return {soup_.numbers.place(c[0]), soup_.numbers.place(c[1]), soup_.numbers.place(c[2])};
  }

  /// How much the normal turns towards the sight over the triangle's size, along the sight; 0 without normals.
  double of(std::uint32_t t) const {
    const std::uint32_t f = soup_.patch[t];
    const FacePatch& patch = scene_.faces[f];
    if (patch.normals.empty()) return 0;
    const auto& ids = patch.triangles[t - soup_.first[f]];
    const auto c = corners(t);
    const Vec3 normal = cross(c[1] - c[0], c[2] - c[0]);
    const double twice = norm2(normal);
    if (twice == 0) return 0;
    const Vec3 sight = projector_.sight((c[0] + c[1] + c[2]) / 3);
    double change = 0, longest = 0;
    for (int i = 0; i < 3; ++i) {
      const Vec3 across = c[(i + 2) % 3] - c[(i + 1) % 3];
      change += dot(patch.normals[ids[i]], sight) * dot(cross(normal, across), sight) / twice;
      longest = std::max(longest, norm(across));
    }
    return change * longest;
  }

  const Scene& scene_;
  const TriangleSoup& soup_;
  const Projector& projector_;
};

}  // namespace

std::size_t PointNumbers::slot(Vec3 p) const {
  std::uint64_t h = 0;
  for (int i = 0; i < 3; ++i) h = mixed(h + std::bit_cast<std::uint64_t>(p[i] + 0.0) * 0x9e3779b97f4a7c15ull);
  std::size_t s = h & (table_.size() - 1);
  while (table_[s] != none && !(points_[table_[s]] == p)) s = (s + 1) & (table_.size() - 1);
  return s;
}

void PointNumbers::grow() {
  table_.assign(std::max<std::size_t>(1024, 2 * table_.size()), none);
  for (std::uint32_t i = 0; i < points_.size(); ++i) table_[slot(points_[i])] = i;
}

std::uint32_t PointNumbers::number(Vec3 p) {
  if (2 * (points_.size() + 1) > table_.size()) grow();
  const std::size_t s = slot(p);
  if (table_[s] == none) {
    table_[s] = std::uint32_t(points_.size());
    points_.push_back(p);
  }
  return table_[s];
}

std::uint32_t PointNumbers::find(Vec3 p) const {
  return table_.empty() ? unknown : table_[slot(p)];
}

TriangleSoup triangle_soup(const Scene& scene) {
  TriangleSoup soup;
  std::vector<std::uint32_t> of_point;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    const FacePatch& patch = scene.faces[f];
    soup.first.push_back(std::uint32_t(soup.corners.size()));
    of_point.clear();
    for (const Vec3 p : patch.points) of_point.push_back(soup.numbers.number(p));
    for (const auto& t : patch.triangles) {
      soup.corners.push_back({of_point[t[0]], of_point[t[1]], of_point[t[2]]});
      soup.patch.push_back(f);
    }
  }
  return soup;
}

std::vector<DrawnLine> silhouettes(const Scene& scene, const TriangleSoup& soup, const Projector& projector) {
  std::vector<EdgeSegment> segments;
  for (std::uint32_t e = 0; e < scene.edges.size(); ++e) {
    const auto& points = scene.edges[e].points;
    std::uint32_t last = soup.numbers.find(points[0]);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const std::uint32_t next = soup.numbers.find(points[i]);
      if (last != PointNumbers::unknown && next != PointNumbers::unknown) segments.push_back({side_key(last, next), e});
      last = next;
    }
  }
  std::sort(segments.begin(), segments.end(), [](const EdgeSegment& a, const EdgeSegment& b) {
    return a.key != b.key ? a.key < b.key : a.edge < b.edge;
  });
  const auto edge_at = [&](SideKey key) {
    const auto found = std::lower_bound(segments.begin(), segments.end(), key,
                                        [](const EdgeSegment& a, SideKey k) { return a.key < k; });
    return found != segments.end() && found->key == key ? found->edge : none;
  };

  // Does the front side of a triangle face the eye? A triangle seen edge-on counts as facing, so that a flat face seen
  // edge-on has no silhouettes inside.
  std::vector<bool> faces_eye(soup.corners.size());
  std::vector<Side> sides;
  sides.reserve(3 * soup.corners.size());
  std::vector<Sliver> slivers;
  for (std::uint32_t t = 0; t < soup.corners.size(); ++t) {
    const auto& c = soup.corners[t];
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;  // a point of collapse, as a pole: no triangle
    const Vec3 a = soup.numbers.place(c[0]), b = soup.numbers.place(c[1]), d = soup.numbers.place(c[2]);
    const Vec3 normal = cross(b - a, d - a);
    faces_eye[t] = dot(normalized(normal), projector.sight(a)) < 1e-9;
    const double lengths[3] = {norm2(b - a), norm2(d - b), norm2(a - d)};
    const int longest = int(std::max_element(lengths, lengths + 3) - lengths);
    if (norm(normal) <= 1e-10 * lengths[longest]) slivers.push_back({t, side_key(c[longest], c[(longest + 1) % 3])});
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t from = c[k], to = c[(k + 1) % 3];
      sides.push_back({side_key(from, to), t, from < to});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.key != b.key ? a.key < b.key : a.triangle < b.triangle; });
  // A triangle without area has no normal of its own: it belongs to its neighbour over its longest side.
  for (const Sliver& sliver : slivers) {
    auto side = std::lower_bound(sides.begin(), sides.end(), sliver.longest,
                                 [](const Side& a, SideKey k) { return a.key < k; });
    const auto last =
        std::upper_bound(side, sides.end(), sliver.longest, [](SideKey k, const Side& a) { return k < a.key; });
    const auto own = std::find_if(side, last, [&](const Side& a) { return a.triangle == sliver.triangle; });
    for (; side != last; ++side) {
      if (side->triangle == sliver.triangle || soup.patch[side->triangle] != soup.patch[sliver.triangle]) continue;
      faces_eye[sliver.triangle] = faces_eye[side->triangle] == (side->forwards != own->forwards);
    }
  }

  const RadialCurvature curvature(scene, soup, projector);
  std::vector<Fold> folds;
  for (std::size_t i = 0, end; i < sides.size(); i = end) {
    end = i + 1;
    while (end < sides.size() && sides[end].key == sides[i].key) ++end;
    if (end - i < 2) continue;
    // A fold is between two triangles of one patch, or of two patches that meet in a smooth edge.
    const std::uint32_t edge = edge_at(sides[i].key);
    if (edge != none && !scene.edges[edge].smooth) continue;
    for (std::size_t j = i; j < end; ++j) {
      for (std::size_t k = j + 1; k < end; ++k) {
        const Side &p = sides[j], &q = sides[k];
        const bool one_patch = soup.patch[p.triangle] == soup.patch[q.triangle];
        if (!one_patch && (edge == none || end - i != 2)) continue;
        const bool same_sense = p.forwards != q.forwards;  // the fronts of both are on one side
        if ((faces_eye[p.triangle] == faces_eye[q.triangle]) == same_sense) continue;
        folds.push_back({soup.patch[p.triangle], edge, std::uint32_t(p.key >> 32), std::uint32_t(p.key),
                         curvature.is_behind(p.triangle, q.triangle, faces_eye[p.triangle], same_sense)});
        k = end;
        j = end;
      }
    }
  }
  std::stable_sort(folds.begin(), folds.end(), [](const Fold& a, const Fold& b) {
    return a.patch != b.patch ? a.patch < b.patch : a.edge != b.edge ? a.edge < b.edge : false;
  });
  std::vector<DrawnLine> lines;
  for (std::size_t i = 0, end; i < folds.size(); i = end) {
    end = i + 1;
    while (end < folds.size() && folds[end].patch == folds[i].patch && folds[end].edge == folds[i].edge) ++end;
    chain(scene, soup.numbers, folds.data() + i, folds.data() + end, lines);
  }
  return lines;
}

}  // namespace aresta::draw
