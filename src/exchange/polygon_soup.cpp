// SPDX-License-Identifier: Apache-2.0
#include "exchange/polygon_soup.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "exchange/errors.h"
#include "model/builder.h"
#include "topology/polygon_mesh.h"

namespace aresta {

namespace {

constexpr std::uint32_t none = 0xffffffffu;

std::uint64_t mix(std::uint64_t h) {
  h ^= h >> 32;
  h *= 0xd6e8feb86659fd93ull;
  h ^= h >> 32;
  h *= 0xd6e8feb86659fd93ull;
  return h ^ (h >> 32);
}

/// An index per distinct key, in the order of first appearance: a hash table that is only looked up.
template <class Key, class Hash>
class Numbering {
 public:
  explicit Numbering(std::size_t expected) { slots_.assign(std::bit_ceil(2 * expected + 16), none); }

  std::pair<std::uint32_t, bool> number(const Key& key) {
    if (2 * keys_.size() + 2 > slots_.size()) grow();
    std::uint32_t& slot = find(key);
    if (slot != none) return {slot, false};
    slot = static_cast<std::uint32_t>(keys_.size());
    keys_.push_back(key);
    return {slot, true};
  }
  const std::vector<Key>& keys() const { return keys_; }

 private:
  std::uint32_t& find(const Key& key) {
    std::size_t i = Hash()(key) & (slots_.size() - 1);
    while (slots_[i] != none && !(keys_[slots_[i]] == key)) i = (i + 1) & (slots_.size() - 1);
    return slots_[i];
  }
  void grow() {
    slots_.assign(2 * slots_.size(), none);
    for (std::uint32_t i = 0; i < keys_.size(); ++i) find(keys_[i]) = i;
  }

  std::vector<Key> keys_;
  std::vector<std::uint32_t> slots_;
};

struct PointHash {
  std::uint64_t operator()(Vec3 p) const {
    return mix(std::bit_cast<std::uint64_t>(p.x) +
               mix(std::bit_cast<std::uint64_t>(p.y) + mix(std::bit_cast<std::uint64_t>(p.z))));
  }
};
using Pair = std::array<std::uint32_t, 2>;
struct PairHash {
  std::uint64_t operator()(const Pair& p) const { return mix((std::uint64_t{p[0]} << 32) | p[1]); }
};
using Corners = std::vector<std::uint32_t>;
struct CornersHash {
  std::uint64_t operator()(const Corners& c) const {
    std::uint64_t h = c.size();
    for (const std::uint32_t i : c) h = mix(h + i);
    return h;
  }
};

Vec3 area_vector(std::span<const Vec3> points, std::span<const std::uint32_t> polygon) {
  Vec3 twice{};
  const Vec3 o = points[polygon[0]];
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += cross(points[polygon[i]] - o, points[polygon[i + 1]] - o);
  return 0.5 * twice;
}

class SoupImport {
 public:
  SoupImport(const PolygonSoup& soup, const ImportOptions& options, ImportReport& report, const Context& context)
      : soup_(soup), options_(options), report_(report), context_(context) {}

  Result<Model> run() {
    ARESTA_CHECK(weld());
    ARESTA_CHECK(clean());
    if (faces_.size() == 1) return Error{errors::nothing_to_import, "the file holds no polygon with an area"};
    ARESTA_CHECK(find_edges());
    note_counts();
    if (open_edges_ > 0) {
      report_.notes.push_back("the surface is not closed (" + std::to_string(open_edges_) +
                              " edges without a partner): it was read as sheets");
      return build(false, false);
    }
    const bool inverted = signed_volume() < 0;
    Result<Model> solid = build(true, inverted);
    if (solid.ok()) {
      if (inverted) report_.notes.push_back("the surface was inside out and has been turned");
      return solid;
    }
    if (solid.error().code == errors::cancelled) return solid;
    report_.notes.push_back("the surface is closed but bounds no solid (" + solid.error().message +
                            "): it was read as sheets");
    return build(false, false);
  }

 private:
  std::span<const std::uint32_t> polygon(std::size_t i) const {
    return std::span(corners_).subspan(faces_[i], faces_[i + 1] - faces_[i]);
  }

  Status weld() {
    Numbering<Vec3, PointHash> numbers(soup_.points.size() / 3);
    vertex_of_.resize(soup_.points.size());
    for (std::size_t i = 0; i < soup_.points.size(); ++i) {
      if (i % 65536 == 0) ARESTA_CHECK(context_.step(0, "joining equal points"));
      const Vec3 p = soup_.points[i] + Vec3{0, 0, 0};  // -0 becomes 0
      if (!is_finite(p)) {
        return Error{errors::bad_content,
                     "point " + std::to_string(i + 1) + " has a coordinate that is not a finite number"};
      }
      vertex_of_[i] = numbers.number(p).first;
    }
    points_ = numbers.keys();
    Box3 box;
    for (const Vec3 p : points_) box.add(p);
    flat_ = box.empty() ? 0 : 1e-9 * box.diagonal();
    return {};
  }

  Status clean() {
    Numbering<Corners, CornersHash> seen(soup_.size());
    std::size_t group = 0;
    for (std::size_t i = 0; i < soup_.size(); ++i) {
      if (i % 65536 == 0) ARESTA_CHECK(context_.step(0.1, "reading polygons"));
      while (group + 1 < soup_.groups.size() && soup_.groups[group + 1].first <= i) ++group;
      current_group_ = soup_.groups.empty() || soup_.groups[group].first > i ? none : static_cast<std::uint32_t>(group);
      Corners p;
      for (std::uint32_t c = soup_.begin[i]; c < soup_.begin[i + 1]; ++c) {
        if (soup_.corners[c] >= vertex_of_.size()) {
          return Error{errors::bad_content, "polygon " + std::to_string(i + 1) + " names a point that does not exist"};
        }
        const std::uint32_t v = vertex_of_[soup_.corners[c]];
        if (p.empty() || p.back() != v) p.push_back(v);
      }
      while (p.size() > 1 && p.front() == p.back()) p.pop_back();
      Corners sorted = p;
      std::sort(sorted.begin(), sorted.end());
      if (p.size() < 3 || std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
        ++degenerate_;
      } else if (!seen.number(sorted).second) {
        ++repeated_;
      } else {
        add(p);
      }
    }
    return {};
  }

  void add(const Corners& p) {
    const Vec3 area = area_vector(points_, p);
    double longest = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
      longest = std::max(longest, distance(points_[p[i]], points_[p[(i + 1) % p.size()]]));
    if (!(norm(area) > 1e-12 * longest * longest)) {
      ++degenerate_;
      return;
    }
    if (p.size() > 3) {
      const Vec3 n = normalized(area), o = points_[p[0]];
      for (const std::uint32_t v : p) {
        if (std::abs(dot(points_[v] - o, n)) > flat_) {
          cut(p, n);
          return;
        }
      }
    }
    keep(p);
  }

  void keep(const Corners& p) {
    corners_.insert(corners_.end(), p.begin(), p.end());
    faces_.push_back(static_cast<std::uint32_t>(corners_.size()));
    group_of_.push_back(current_group_);
  }

  // Ears of the polygon seen along its mean normal, the sharpest-cornered triangle last: each ear is the first that
  // holds no other corner.
  void cut(Corners p, Vec3 n) {
    ++bent_;
    const Frame frame = Frame::along(points_[p[0]], n);
    const auto flat = [&](std::uint32_t v) {
      const Vec3 q = frame.to_local(points_[v]);
      return Vec2{q.x, q.y};
    };
    while (p.size() > 3) {
      std::size_t ear = 0;
      for (std::size_t i = 0; i < p.size(); ++i) {
        const std::size_t before = (i + p.size() - 1) % p.size(), after = (i + 1) % p.size();
        const Vec2 a = flat(p[before]), b = flat(p[i]), c = flat(p[after]);
        if (cross(b - a, c - b) <= 0) continue;
        bool empty = true;
        for (std::size_t j = 0; j < p.size(); ++j) {
          if (j == before || j == i || j == after) continue;
          const Vec2 q = flat(p[j]);
          empty = empty && !(cross(b - a, q - a) >= 0 && cross(c - b, q - b) >= 0 && cross(a - c, q - c) >= 0);
        }
        if (empty) {
          ear = i;
          break;
        }
      }
      keep({p[(ear + p.size() - 1) % p.size()], p[ear], p[(ear + 1) % p.size()]});
      p.erase(p.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    keep(p);
  }

  Status find_edges() {
    ARESTA_CHECK(context_.step(0.2, "finding edges"));
    PolygonEdges found = edges_of_polygons(static_cast<std::uint32_t>(points_.size()), corners_, faces_);
    edges_ = std::move(found.edges);
    edge_of_ = std::move(found.of_corner);
    std::vector<int> balance(edges_.size(), 0);
    for (std::size_t c = 0; c < corners_.size(); ++c)
      balance[edge_of_[c]] += corners_[c] == edges_[edge_of_[c]][0] ? 1 : -1;
    open_edges_ = static_cast<std::size_t>(std::count_if(balance.begin(), balance.end(), [](int b) { return b != 0; }));
    return {};
  }

  void note_counts() {
    const auto note = [&](std::size_t n, const char* text) {
      if (n > 0) report_.notes.push_back(std::to_string(n) + text);
    };
    note(degenerate_, " polygons without area were left out");
    note(repeated_, " polygons that repeat another one were left out");
    note(bent_, " polygons that are not plane were cut into triangles");
  }

  double signed_volume() const {
    double six = 0;
    const Vec3 o = points_[corners_[0]];
    for (std::size_t f = 0; f + 1 < faces_.size(); ++f) {
      const auto p = polygon(f);
      for (std::size_t i = 1; i + 1 < p.size(); ++i)
        six += dot(points_[p[0]] - o, cross(points_[p[i]] - o, points_[p[i + 1]] - o));
    }
    return six / 6;
  }

  Result<Model> build(bool filled, bool turned) {
    ModelBuilder builder;
    builder.length_unit = options_.length_unit;
    std::vector<bool> used(points_.size(), false);
    for (const std::uint32_t v : corners_) used[v] = true;
    std::vector<VertexId> vertex(points_.size());
    for (std::size_t v = 0; v < points_.size(); ++v) {
      if (used[v]) vertex[v] = builder.add_vertex(points_[v]);
    }
    for (const Pair& e : edges_) builder.add_edge(vertex[e[0]], vertex[e[1]]);
    std::vector<Group> groups(soup_.groups.size());
    for (std::size_t f = 0; f + 1 < faces_.size(); ++f) {
      if (f % 16384 == 0) ARESTA_CHECK(context_.step(0.3, "making faces"));
      const auto p = polygon(f);
      Vec3 normal = area_vector(points_, p);
      if (turned) normal = -normal;
      const Vec3 o = points_[p[0]];
      const FaceId face =
          builder.begin_face(builder.add_surface(Plane{Frame::along(o, normal, points_[p[1]] - o)}), false);
      const std::size_t n = p.size();
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = turned ? n - 1 - k : k;
        const std::uint32_t edge = edge_of_[faces_[f] + i];
        const bool along = edges_[edge][0] == p[i];
        builder.add_coedge(EdgeId(edge), along == turned);
      }
      builder.close_loop();
      builder.end_face();
      if (filled) builder.set_fill(Fill::empty, Fill::filled);
      if (group_of_[f] != none) groups[group_of_[f]].entities.push_back(face);
    }
    for (std::size_t g = 0; g < groups.size(); ++g) {
      groups[g].name = soup_.groups[g].second;
      add_group(builder.labels.groups, std::move(groups[g]));
    }
    return builder.build(context_);
  }

  static void add_group(std::vector<Group>& groups, Group group) {
    if (group.entities.empty() || group.name.empty()) return;
    for (Group& other : groups) {
      if (other.name != group.name) continue;
      other.entities.insert(other.entities.end(), group.entities.begin(), group.entities.end());
      return;
    }
    groups.push_back(std::move(group));
  }

  const PolygonSoup& soup_;
  const ImportOptions& options_;
  ImportReport& report_;
  const Context& context_;
  std::vector<std::uint32_t> vertex_of_;
  std::vector<Vec3> points_;
  double flat_ = 0;
  std::vector<std::uint32_t> corners_, faces_{0}, group_of_;
  std::uint32_t current_group_ = none;
  std::vector<std::uint32_t> edge_of_;  // per corner: the edge that leaves it
  std::vector<Pair> edges_;
  std::size_t open_edges_ = 0, degenerate_ = 0, repeated_ = 0, bent_ = 0;
};

}  // namespace

Result<Model> import_soup(const PolygonSoup& soup, const ImportOptions& options, ImportReport& report,
                          const Context& context) {
  return SoupImport(soup, options, report, context).run();
}

}  // namespace aresta
