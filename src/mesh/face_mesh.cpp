// SPDX-License-Identifier: Apache-2.0
#include "mesh/face_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/plane_triangulation.h"
#include "mesh/errors.h"
#include "mesh/remesh.h"

namespace aresta::mesh {

namespace {

/// The initial grid has a line wherever the surface or its parameter lines turned by this much.
constexpr double grid_angle = 20 * std::numbers::pi / 180;
/// Cosine between triangle and surface normals below which a finished triangle counts as folded.
constexpr double least_alignment = 0.2;
/// Largest distance of a triangle's centre from the surface, over its longest side.
constexpr double largest_deviation = 0.3;

constexpr double largest_cell_aspect = 3;
constexpr double most_cells = 60000;
/// How often the grid is made twice as fine when a seam or a pole shows that it is too coarse.
constexpr int grid_attempts = 4;

using Segment = std::array<std::uint32_t, 2>;

double angle_between(Vec3 a, Vec3 b) {
  const double product = norm(a) * norm(b);
  return product > 0 ? std::acos(std::clamp(dot(a, b) / product, -1.0, 1.0)) : 0;
}

class FaceMesher {
 public:
  FaceMesher(const Model& model, FaceId face, const EdgeMesh& edges, const SizeField& field, const Context& context)
      : model_(model),
        topology_(model.topology()),
        face_(face),
        surface_(model.surface(face)),
        edges_(edges),
        field_(field),
        context_(context) {}

  Result<FaceMesh> run() {
    measure_parameters();
    ARESTA_CHECK(collect_loops());
    ARESTA_CHECK(collect_points());
    ARESTA_CHECK(triangulate_with_grid());
    ARESTA_TRY(RemeshOutput made, remesh(remesh_input(), context_));
    ARESTA_CHECK(check(made));
    return pack(made);
  }

 private:
  Error failure(ErrorCode code, const std::string& message, Vec3 place) const {
    return Error{code, message, {face_}, {{place.x, place.y, place.z}}, "a smaller element size at this face"};
  }

  // --- the parameter plane, scaled so that lengths are about those in space ---

  /// Where lengths are about those in space.
  double length(Vec2 uv) const { return std::hypot(uv.x * scale_.x, uv.y * scale_.y); }
  /// Where the triangulation is made: the grid's cells are no slimmer than largest_cell_aspect.
  Vec2 scaled(Vec2 uv) const { return {uv.x * plane_scale_.x, uv.y * plane_scale_.y}; }

  void measure_parameters() {
    box_ = parameter_box(model_, face_);
    if (surface_.is_plane()) return;
    double du = 0, dv = 0;
    for (int i = 0; i < 5; ++i) {
      for (int j = 0; j < 5; ++j) {
        const SurfaceJet jet = surface_.jet({box_.u.at((i + 0.5) / 5), box_.v.at((j + 0.5) / 5)});
        du += norm(jet.du) / 25;
        dv += norm(jet.dv) / 25;
      }
    }
    if (std::isfinite(du) && du > 0) scale_.x = du;
    if (std::isfinite(dv) && dv > 0) scale_.y = dv;
    columns_ = turns(true), rows_ = turns(false);
    choose_grid();
  }

  void choose_grid() {
    plane_scale_ = scale_;
    if (columns_ < 2 && rows_ < 2) return;
    columns_ = std::max(columns_, 2), rows_ = std::max(rows_, 2);
    const double width = box_.u.length() * scale_.x, height = box_.v.length() * scale_.y;
    const auto wanted = [](double cells) { return static_cast<int>(std::clamp(std::ceil(cells), 2.0, 4000.0)); };
    columns_ = std::max(columns_, wanted(width / height * rows_ / largest_cell_aspect));
    rows_ = std::max(rows_, wanted(height / width * columns_ / largest_cell_aspect));
    while (static_cast<double>(columns_) * rows_ > most_cells) {
      (columns_ > rows_ ? columns_ : rows_) = std::max(2, (columns_ > rows_ ? columns_ : rows_) * 3 / 4);
    }
    const double cell_width = width / columns_, cell_height = height / rows_;
    if (cell_width > largest_cell_aspect * cell_height)
      plane_scale_.x *= largest_cell_aspect * cell_height / cell_width;
    if (cell_height > largest_cell_aspect * cell_width)
      plane_scale_.y *= largest_cell_aspect * cell_width / cell_height;
  }

  /// How many grid cells the turning of the surface along u (or v) asks for.
  int turns(bool along_u) const {
    constexpr int lines = 5, samples = 40;
    double most = 0;
    for (int line = 0; line < lines; ++line) {
      double turned = 0;
      Vec3 normal{}, direction{};
      for (int i = 0; i <= samples; ++i) {
        const double s = static_cast<double>(i) / samples, fixed = (line + 0.5) / lines;
        const Vec2 uv = along_u ? Vec2{box_.u.at(s), box_.v.at(fixed)} : Vec2{box_.u.at(fixed), box_.v.at(s)};
        const SurfaceJet jet = surface_.jet(uv);
        const Vec3 n = cross(jet.du, jet.dv), d = along_u ? jet.du : jet.dv;
        if (i > 0) turned += std::max(angle_between(normal, n), angle_between(direction, d));
        normal = n, direction = d;
      }
      most = std::max(most, turned);
    }
    return std::clamp(static_cast<int>(std::ceil(most / grid_angle - 1e-6)), 1, 400);
  }

  // --- boundary ---

  struct BoundaryPoint {
    std::uint32_t node;
    Vec2 uv;
    bool pole = false;  ///< on a gap in parameter space that is one point in space
  };

  Vec3 node_point(std::uint32_t node) const { return edges_.nodes[node]; }

  Status collect_loops() {
    for (const LoopId l : topology_.loops(face_)) {
      if (topology_.is_vertex_loop(l)) continue;
      auto& loop = loops_.emplace_back();
      Vec2 shift{};
      for (const CoedgeId c : topology_.coedges(l)) {
        const EdgeChain& chain = edges_.chains[topology_.edge(c).index()];
        std::vector<BoundaryPoint> part;
        for (std::size_t i = 0; i < chain.nodes.size(); ++i)
          part.push_back({chain.nodes[i], model_.uv(c, chain.parameters[i])});
        if (topology_.reversed(c)) std::reverse(part.begin(), part.end());
        for (auto& p : part) p.uv += shift;
        if (!loop.empty()) {
          ARESTA_TRY(const Vec2 more, bridge(loop, part.front()));
          shift += more;
          for (auto& p : part) p.uv += more;
          loop.back().pole = loop.back().pole || part.front().pole;
          part.erase(part.begin());
        }
        loop.insert(loop.end(), part.begin(), part.end());
      }
      ARESTA_TRY(const Vec2 winding, bridge(loop, loop.front()));
      if (!(winding == Vec2{})) {
        return failure(errors::mesh_bad_input, "a loop of the face goes round a closed surface without a seam",
                       node_point(loop.front().node));
      }
      const bool pole = loop.back().pole;
      loop.pop_back();
      if (loop.empty()) return failure(errors::mesh_bad_input, "a loop of the face is empty", {});
      loop.front().pole = loop.front().pole || pole;
    }
    if (loops_.empty()) {
      return Error{errors::mesh_bad_input, "the face has no boundary: a closed face needs a seam edge", {face_}};
    }
    shift_inner_loops();
    number_points();
    return {};
  }

  /// Makes the loop's end reach the next point: nothing to do, or a whole period to shift what follows by (the answer),
  /// or points along a gap that is one point in space.
  Result<Vec2> bridge(std::vector<BoundaryPoint>& loop, const BoundaryPoint next) {
    BoundaryPoint& last = loop.back();
    if (last.node != next.node) {
      return failure(errors::mesh_bad_input, "a loop of the face does not close", node_point(last.node));
    }
    const Vec2 gap = next.uv - last.uv;
    const double diagonal = length({box_.u.length(), box_.v.length()});
    const double near = 1e-4 * diagonal + 10 * model_.tolerance(face_);
    if (length(gap) <= near) return Vec2{};
    const Vec3 here = node_point(last.node);
    const double tolerance = 1e-6 * diagonal + 10 * std::max(model_.tolerance(face_), model_.tolerance());
    bool one_point = true;
    for (const double s : {0.25, 0.5, 0.75})
      one_point = one_point && distance(surface_.point(last.uv + s * gap), here) <= tolerance;
    if (one_point) {
      last.pole = true;
      const int pieces = std::max(3, std::abs(gap.x) * scale_.x > std::abs(gap.y) * scale_.y ? columns_ : rows_);
      const Vec2 start = last.uv;
      for (int i = 1; i <= pieces; ++i) {
        loop.push_back({next.node, i == pieces ? next.uv : start + (static_cast<double>(i) / pieces) * gap, true});
      }
      return Vec2{};
    }
    const Vec2 period = surface_.period();
    const Vec2 whole{period.x > 0 ? period.x * std::round(gap.x / period.x) : 0,
                     period.y > 0 ? period.y * std::round(gap.y / period.y) : 0};
    if (length(gap - whole) <= near) return Vec2{-whole.x, -whole.y};
    return failure(errors::mesh_bad_input, "the images of two edges of the face do not meet in its surface", here);
  }

  static double area(const std::vector<BoundaryPoint>& loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
      sum += 0.5 * cross(loop[i].uv - loop[0].uv, loop[(i + 1) % loop.size()].uv - loop[0].uv);
    return sum;
  }

  static bool within(const std::vector<BoundaryPoint>& loop, Vec2 p) {
    bool inside = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = loop[i].uv, b = loop[(i + 1) % loop.size()].uv;
      if ((a.y > p.y) != (b.y > p.y) && (p.y - a.y) / (b.y - a.y) * (b.x - a.x) + a.x > p.x) inside = !inside;
    }
    return inside;
  }

  std::size_t outer_loop() const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < loops_.size(); ++i) {
      if (std::abs(area(loops_[i])) > std::abs(area(loops_[best]))) best = i;
    }
    return best;
  }

  /// By which periods must p move to lie within the outer loop?
  Vec2 shift_into(Vec2 p) const {
    const Vec2 period = surface_.period();
    const auto& outer = loops_[outer_loop()];
    for (const int i : {0, 1, -1, 2, -2}) {
      for (const int j : {0, 1, -1, 2, -2}) {
        if ((i != 0 && period.x == 0) || (j != 0 && period.y == 0)) continue;
        const Vec2 shift{i * period.x, j * period.y};
        if (within(outer, p + shift)) return shift;
      }
    }
    return {};
  }

  void shift_inner_loops() {
    const Vec2 period = surface_.period();
    if (period.x == 0 && period.y == 0) return;
    const std::size_t outer = outer_loop();
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      if (i == outer) continue;
      Vec2 middle{};
      for (const auto& p : loops_[i]) middle += p.uv / static_cast<double>(loops_[i].size());
      const Vec2 shift = shift_into(middle);
      for (auto& p : loops_[i]) p.uv += shift;
    }
  }

  std::uint32_t local_node(std::uint32_t node) {
    const auto found = std::lower_bound(local_.begin(), local_.end(), std::pair{node, 0u});
    if (found != local_.end() && found->first == node) return found->second;
    const auto number = static_cast<std::uint32_t>(boundary_.size());
    local_.insert(found, {node, number});
    boundary_.push_back(node);
    points_of_node_.emplace_back();
    return number;
  }

  /// The point of the parameter plane with this node and place; images of one node that agree are one point.
  std::uint32_t plane_point(const BoundaryPoint& p, double tolerance) {
    const std::uint32_t node = local_node(p.node);
    for (const std::uint32_t known : points_of_node_[node]) {
      if (distance(plane_.points[known], scaled(p.uv)) <= tolerance) {
        is_pole_[known] = is_pole_[known] || p.pole;
        return known;
      }
    }
    const auto number = static_cast<std::uint32_t>(plane_.points.size());
    plane_.points.push_back(scaled(p.uv));
    uv_.push_back(p.uv);
    node_of_.push_back(node);
    is_pole_.push_back(p.pole);
    points_of_node_[node].push_back(number);
    return number;
  }

  void number_points() {
    double shortest = HUGE_VAL, total_area = 0;
    for (const auto& loop : loops_) {
      total_area += area(loop);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto& next = loop[(i + 1) % loop.size()];
        if (loop.size() > 1) shortest = std::min(shortest, distance(scaled(loop[i].uv), scaled(next.uv)));
      }
    }
    const double tolerance = std::min(0.2 * shortest, 1e-4 * norm(scaled({box_.u.length(), box_.v.length()})));
    for (auto& loop : loops_) {
      std::vector<std::uint32_t> numbers;
      for (const auto& p : loop) numbers.push_back(plane_point(p, tolerance));
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        Segment s{numbers[i], numbers[(i + 1) % numbers.size()]};
        if (total_area < 0) std::swap(s[0], s[1]);
        if (s[0] != s[1]) plane_.segments.push_back(s);
      }
    }
  }

  Status collect_points() {
    for (const LoopId l : topology_.loops(face_)) {
      if (!topology_.is_vertex_loop(l)) continue;
      const std::uint32_t node = topology_.loop_vertex(l).value;
      const auto found = surface_.project(node_point(node));
      plane_point({node, found.uv + shift_into(found.uv)}, 0);
    }
    return {};
  }

  // --- inner points for the topology's sake ---

  Status triangulate_with_grid() {
    first_inner_ = plane_.points.size();
    for (int attempt = 1;; ++attempt) {
      bool too_coarse = false;
      add_grid();
      auto status = triangulate(too_coarse);
      if (!too_coarse || attempt == grid_attempts || columns_ < 2) return status;
      columns_ *= 2, rows_ *= 2;
      plane_.points.resize(first_inner_);
      uv_.resize(first_inner_);
      node_of_.resize(first_inner_);
      is_pole_.resize(first_inner_);
      triangles_.clear();
    }
  }

  void add_grid() {
    if (columns_ < 2 || rows_ < 2) return;
    const Vec2 cell{box_.u.length() / columns_, box_.v.length() / rows_};
    const double clearance = 0.35 * std::min(scaled(cell).x, scaled(cell).y);
    const double reach_x = scaled(cell).x;
    // Segments by the column of the grid that they touch, so that each point looks at few.
    std::vector<std::vector<Segment>> buckets(static_cast<std::size_t>(columns_) + 1);
    const double left = scaled({box_.u.low, 0}).x;
    const auto bucket = [&](double x) {
      return static_cast<int>(std::clamp(std::floor((x - left) / reach_x), 0.0, static_cast<double>(columns_)));
    };
    for (const Segment& s : plane_.segments) {
      const double a = plane_.points[s[0]].x, b = plane_.points[s[1]].x;
      for (int k = bucket(std::min(a, b) - clearance); k <= bucket(std::max(a, b) + clearance); ++k)
        buckets[static_cast<std::size_t>(k)].push_back(s);
    }
    const std::size_t boundary_points = first_inner_;
    for (int i = 1; i < columns_; ++i) {
      for (int j = 1; j < rows_; ++j) {
        const Vec2 uv{box_.u.low + i * cell.x, box_.v.low + j * cell.y};
        const Vec2 p = scaled(uv);
        bool clear = inside(p);
        for (const Segment& s : buckets[static_cast<std::size_t>(bucket(p.x))]) {
          if (!clear) break;
          const Vec2 a = plane_.points[s[0]], ab = plane_.points[s[1]] - a;
          const double t = std::clamp(dot(p - a, ab) / dot(ab, ab), 0.0, 1.0);
          clear = distance(p, a + t * ab) > clearance;
        }
        if (!clear) continue;
        // Isolated points have no segments.
        for (std::size_t k = 0; k < boundary_points && clear; ++k)
          clear = distance(p, plane_.points[k]) > 0.2 * clearance;
        if (!clear) continue;
        plane_.points.push_back(p);
        uv_.push_back(uv);
        node_of_.push_back(static_cast<std::uint32_t>(boundary_.size() + plane_.points.size() - 1 - first_inner_));
        is_pole_.push_back(false);
      }
    }
  }

  /// By the rule of even and odd; segments used both ways count twice.
  bool inside(Vec2 p) const {
    bool odd = false;
    for (const Segment& s : plane_.segments) {
      const Vec2 a = plane_.points[s[0]], b = plane_.points[s[1]];
      if ((a.y > p.y) != (b.y > p.y) && (p.y - a.y) / (b.y - a.y) * (b.x - a.x) + a.x > p.x) odd = !odd;
    }
    return odd;
  }

  /// `too_coarse`: glued at the seam or the pole, the triangulation is no surface; more inner points help.
  Status triangulate(bool& too_coarse) {
    const PlaneOutput made = triangulate_plane(plane_);
    if (made.bad_point || made.triangles.empty()) {
      const std::uint32_t bad = made.bad_point.value_or(0);
      return failure(errors::mesh_face_boundary, "the subdivided boundary of the face touches or crosses itself",
                     surface_.point(uv_[bad]));
    }
    std::vector<Segment> directed;
    for (const auto& t : made.triangles) {
      const std::array<std::uint32_t, 3> nodes{node_of_[t[0]], node_of_[t[1]], node_of_[t[2]]};
      bool dropped = false;
      for (int i = 0; i < 3 && !dropped; ++i) {
        const int j = (i + 1) % 3;
        if (nodes[i] != nodes[j]) continue;
        if (!is_pole_[t[i]] || !is_pole_[t[j]]) {
          too_coarse = true;
          return failure(errors::mesh_face_boundary, "the boundary of the face is subdivided too coarsely at its seam",
                         surface_.point(uv_[t[i]]));
        }
        dropped = true;
      }
      if (dropped) continue;
      triangles_.push_back(nodes);
      for (int i = 0; i < 3; ++i) directed.push_back({nodes[i], nodes[(i + 1) % 3]});
    }
    std::sort(directed.begin(), directed.end());
    const auto twice = std::adjacent_find(directed.begin(), directed.end());
    if (twice != directed.end()) {
      too_coarse = true;
      return failure(errors::mesh_face_boundary, "the boundary of the face is subdivided too coarsely",
                     place_of((*twice)[0]));
    }
    return {};
  }

  Vec3 place_of(std::uint32_t local) const {
    if (local < boundary_.size()) return node_point(boundary_[local]);
    return surface_.point(uv_[local - boundary_.size() + first_inner_]);
  }

  // --- remeshing in space ---

  RemeshInput remesh_input() {
    RemeshInput input;
    input.vertices.resize(boundary_.size() + plane_.points.size() - first_inner_);
    for (std::size_t i = plane_.points.size(); i-- > 0;) {
      RemeshVertex& v = input.vertices[node_of_[i]];
      v.fixed = i < first_inner_;
      v.uv = uv_[i];  // the first image of a node wins: the loop runs backwards
      v.point = v.fixed ? node_point(boundary_[node_of_[i]]) : surface_.point(uv_[i]);
      v.normal = surface_.normal(uv_[i]);
    }
    input.triangles = triangles_;
    for (const Segment& s : plane_.segments) {
      const std::uint32_t a = node_of_[s[0]], b = node_of_[s[1]];
      if (a != b) input.constrained.push_back({a, b});
    }
    constrained_ = input.constrained;
    input.project = [this](Vec3 p, Vec2& uv) {
      const SurfaceProjection found = surface_.project(p, &uv);
      uv = found.uv;
      return found.point;
    };
    input.normal = [this](Vec2 uv) { return surface_.normal(uv); };
    input.size = [this](Vec3 p) { return field_.at(p); };
    return input;
  }

  Status check(const RemeshOutput& made) const {
    std::vector<Segment> sides, wanted = constrained_;
    const auto point = [&](std::uint32_t v) { return made.vertices[v].point; };
    for (const auto& t : made.triangles) {
      for (int i = 0; i < 3; ++i) sides.push_back({t[i], t[(i + 1) % 3]});
    }
    std::sort(sides.begin(), sides.end());
    std::sort(wanted.begin(), wanted.end());
    const auto has = [](const std::vector<Segment>& list, Segment s) {
      return std::binary_search(list.begin(), list.end(), s);
    };
    for (std::size_t i = 1; i < sides.size(); ++i) {
      if (sides[i] == sides[i - 1])
        return failure(errors::mesh_face_failed, "two triangles of the face overlap", point(sides[i][0]));
    }
    for (const Segment& s : wanted) {
      if (!has(sides, s))
        return failure(errors::mesh_face_failed, "the mesh of the face misses a side of its boundary", point(s[0]));
    }
    for (const Segment& s : sides) {
      const Segment back{s[1], s[0]};
      const bool is_border = has(wanted, s) && !has(wanted, back);
      if (has(sides, back) == is_border)
        return failure(errors::mesh_face_failed, "the mesh of the face does not end at its boundary", point(s[0]));
    }
    for (const auto& t : made.triangles) {
      const Vec3 a = point(t[0]), b = point(t[1]), c = point(t[2]);
      const Vec3 n = area_vector(a, b, c);
      const Vec3 normal = made.vertices[t[0]].normal + made.vertices[t[1]].normal + made.vertices[t[2]].normal;
      const Vec3 centre = (a + b + c) / 3;
      if (!(dot(n, normal) > least_alignment * norm(n) * norm(normal)) && norm2(normal) > 0) {
        return failure(errors::mesh_face_failed, "a triangle of the face is folded over", centre);
      }
      if (!(norm2(n) > 0)) return failure(errors::mesh_face_failed, "a triangle of the face has no area", centre);
      if (surface_.is_plane()) continue;
      double deviation = HUGE_VAL;
      for (const std::uint32_t v : t) {
        const Vec2 hint = made.vertices[v].uv;
        deviation = std::min(deviation, surface_.project(centre, &hint).distance);
      }
      const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
      if (!(deviation <= largest_deviation * longest))
        return failure(errors::mesh_face_failed, "a triangle of the face leaves its surface", centre);
    }
    return {};
  }

  FaceMesh pack(const RemeshOutput& made) const {
    FaceMesh mesh;
    mesh.boundary = boundary_;
    for (std::size_t i = 0; i < made.vertices.size(); ++i) {
      const auto& v = made.vertices[i];
      if (i < boundary_.size()) {
        mesh.boundary_uv.push_back(v.uv);
      } else {
        mesh.inner.push_back(v.point);
        mesh.inner_uv.push_back(v.uv);
      }
    }
    mesh.triangles = made.triangles;
    if (model_.is_reversed(face_)) {
      for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    }
    return mesh;
  }

  const Model& model_;
  const Complex& topology_;
  FaceId face_;
  const Surface& surface_;
  const EdgeMesh& edges_;
  const SizeField& field_;
  const Context& context_;

  Range2 box_;
  Vec2 scale_{1, 1}, plane_scale_{1, 1};
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<BoundaryPoint>> loops_;

  std::vector<std::uint32_t> boundary_;                         // local node -> node of the edge mesh
  std::vector<std::pair<std::uint32_t, std::uint32_t>> local_;  // sorted: node of the edge mesh -> local node
  std::vector<std::vector<std::uint32_t>> points_of_node_;      // local node -> points of the plane
  PlaneInput plane_;
  std::vector<Vec2> uv_;                // per point of the plane
  std::vector<std::uint32_t> node_of_;  // per point of the plane: its local node
  std::vector<bool> is_pole_;           // per point of the plane
  std::size_t first_inner_ = 0;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Segment> constrained_;
};

}  // namespace

Result<FaceMesh> mesh_face(const Model& model, FaceId face, const EdgeMesh& edges, const SizeField& field,
                           const Context& context) {
  return FaceMesher(model, face, edges, field, context).run();
}

}  // namespace aresta::mesh
