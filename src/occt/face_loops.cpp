// SPDX-License-Identifier: Apache-2.0
#include "occt/face_loops.h"

#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "geometry/occt_handles.h"
#include "occt/errors.h"

namespace aresta {

namespace {

constexpr int pole = 0;  // the edge index of an edge without extent
constexpr double two_pi = 2 * std::numbers::pi;

/// An edge in the parameter plane: its image, or for a plane the curve itself seen in the plane's axes.
struct Image {
  Handle(Geom2d_Curve) flat;
  Handle(Geom_Curve) spatial;
  Frame frame;
  double low = 0, high = 0;

  Vec2 point(double t) const {
    if (!flat.IsNull()) {
      const gp_Pnt2d p = flat->Value(t);
      return {p.X(), p.Y()};
    }
    const gp_Pnt p = spatial->Value(t);
    const Vec3 local = frame.to_local({p.X(), p.Y(), p.Z()});
    return {local.x, local.y};
  }
  bool straight() const {
    return flat.IsNull() ? !Handle(Geom_Line)::DownCast(spatial).IsNull()
                         : !Handle(Geom2d_Line)::DownCast(flat).IsNull();
  }
};

struct Half {
  int edge = pole;
  bool reversed = false;
  bool inner = false;
  int twin = -1;  // of an inner edge
  int from = 0, to = 0;
  Image image;
  Vec2 uv_from, uv_to;
  int next = -1;
  bool traced = false;

  double parameter(double fraction) const {
    return reversed ? image.high + fraction * (image.low - image.high)
                    : image.low + fraction * (image.high - image.low);
  }
  Vec2 at(double fraction) const { return image.point(parameter(fraction)); }
};

double angle_of(Vec2 d) {
  return std::atan2(d.y, d.x);
}

/// How far one turns clockwise from angle a to angle b, in (0, 2 pi].
double clockwise(double a, double b) {
  double d = a - b;
  while (d <= 0) d += two_pi;
  while (d > two_pi) d -= two_pi;
  return d;
}

class LoopFinder {
 public:
  LoopFinder(const TopoDS_Face& face, const TopTools_IndexedMapOfShape& vertices,
             const TopTools_IndexedMapOfShape& edges)
      : face_(TopoDS::Face(face.Oriented(TopAbs_FORWARD))), vertices_(vertices), edges_(edges) {}

  Result<std::vector<FaceLoop>> run() {
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face_);
    const Surface form = from_occt(surface);
    if (const Plane* plane = form.get_if<Plane>()) {
      is_plane_ = true;
      frame_ = plane->frame;
    }
    ARESTA_CHECK(collect());
    if (is_plane_ && simple()) {
      for (auto& [vertex, ends] : ends_) halves_[ends.in.front()].next = ends.out.front();
    } else {
      if (!is_plane_) separate_seams(form.period());
      place_images();
      split_poles();
      ARESTA_CHECK(link(form));
    }
    return trace();
  }

 private:
  struct Ends {
    std::vector<int> in, out;
  };

  static Error bad(const std::string& message, Vec3 place = {}) {
    return Error{errors::to_model_failed, message, {}, {{place.x, place.y, place.z}}};
  }

  Vec3 place(int vertex) const {
    const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(vertices_(vertex)));
    return {p.X(), p.Y(), p.Z()};
  }

  Status collect() {
    for (TopoDS_Iterator in_face(face_); in_face.More(); in_face.Next()) {
      const TopoDS_Shape& part = in_face.Value();
      if (part.ShapeType() == TopAbs_VERTEX) {
        points_.push_back(vertices_.FindIndex(part));
        continue;
      }
      if (part.ShapeType() != TopAbs_WIRE) continue;
      for (TopoDS_Iterator in_wire(part); in_wire.More(); in_wire.Next()) {
        if (in_wire.Value().ShapeType() == TopAbs_EDGE) ARESTA_CHECK(add(TopoDS::Edge(in_wire.Value())));
      }
    }
    for (int h = 0; h < static_cast<int>(halves_.size()); ++h) {
      ends_[halves_[h].from].out.push_back(h);
      ends_[halves_[h].to].in.push_back(h);
    }
    for (const auto& [vertex, ends] : ends_) {
      if (ends.in.size() != ends.out.size()) return bad("a wire of a face is open", place(vertex));
    }
    return {};
  }

  Status add(const TopoDS_Edge& edge) {
    const bool is_pole = BRep_Tool::Degenerated(edge);
    const bool inner = edge.Orientation() == TopAbs_INTERNAL || edge.Orientation() == TopAbs_EXTERNAL;
    if (is_pole && (is_plane_ || inner)) return {};
    Half h;
    h.edge = is_pole ? pole : edges_.FindIndex(edge);
    h.reversed = edge.Orientation() == TopAbs_REVERSED;
    h.inner = inner;
    TopoDS_Vertex first, last;
    TopExp::Vertices(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)), first, last);
    h.from = vertices_.FindIndex(first);
    h.to = vertices_.FindIndex(last);
    if (h.from == 0 || h.to == 0) return bad("an edge of a face has no vertices");
    if (h.reversed) std::swap(h.from, h.to);
    if (is_plane_) {
      h.image.spatial = BRep_Tool::Curve(edge, h.image.low, h.image.high);
      h.image.frame = frame_;
    } else {
      // For a seam the sense chooses between the two images; an inner edge has one.
      h.image.flat = BRep_Tool::CurveOnSurface(edge, face_, h.image.low, h.image.high);
      if (h.image.flat.IsNull()) return bad("an edge has no image in the parameters of its face", place(h.from));
    }
    halves_.push_back(h);
    if (inner) {
      Half back = h;
      back.reversed = true;
      std::swap(back.from, back.to);
      back.twin = static_cast<int>(halves_.size()) - 1;
      halves_.back().twin = back.twin + 1;
      halves_.push_back(back);
    }
    return {};
  }

  // A seam that the face shares with another one's seam comes with one image for both of its uses. With the face to the
  // left, the use that goes up in the other parameter is the one at the far end of the period.
  void separate_seams(Vec2 period) {
    for (std::size_t i = 0; i < halves_.size(); ++i) {
      for (std::size_t j = i + 1; j < halves_.size(); ++j) {
        Half &a = halves_[i], &b = halves_[j];
        if (a.edge == pole || a.edge != b.edge || a.reversed == b.reversed || a.inner || b.inner) continue;
        if (a.image.flat.IsNull() || b.image.flat.IsNull() || distance(a.at(0.5), b.at(0.5)) > 1e-9) continue;
        const Vec2 along = a.at(1) - a.at(0);
        const bool across_u = std::abs(along.y) >= std::abs(along.x);
        const double whole = across_u ? period.x : period.y;
        if (whole == 0) continue;
        const bool a_far = across_u ? along.y > 0 : along.x < 0;
        Half &far = a_far ? a : b, &low = a_far ? b : a;
        const double here = across_u ? a.at(0.5).x : a.at(0.5).y;
        if (here < middle_of_others(across_u)) {
          shift(far, across_u, whole);
        } else {
          shift(low, across_u, -whole);
        }
      }
    }
  }

  double middle_of_others(bool across_u) const {
    double low = 1e300, high = -1e300;
    for (const Half& h : halves_) {
      for (const double share : {0.0, 0.5, 1.0}) {
        const double x = across_u ? h.at(share).x : h.at(share).y;
        low = std::min(low, x);
        high = std::max(high, x);
      }
    }
    return 0.5 * (low + high);
  }

  static void shift(Half& h, bool across_u, double by) {
    h.image.flat =
        Handle(Geom2d_Curve)::DownCast(h.image.flat->Translated(across_u ? gp_Vec2d(by, 0) : gp_Vec2d(0, by)));
  }

  bool simple() const {
    return std::all_of(ends_.begin(), ends_.end(), [](const auto& e) { return e.second.in.size() == 1; });
  }

  void place_images() {
    for (Half& h : halves_) {
      h.uv_from = h.at(0);
      h.uv_to = h.at(1);
      constexpr int samples = 8;  // a closed curve reaches further than its ends and middle
      for (int k = 0; k <= samples; ++k) {
        const Vec2 p = h.at(static_cast<double>(k) / samples);
        low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
        high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
      }
    }
  }

  bool near(Vec2 a, Vec2 b) const {
    constexpr double share = 1e-3;
    return std::abs(a.x - b.x) <= share * (high_.x - low_.x) && std::abs(a.y - b.y) <= share * (high_.y - low_.y);
  }

  // An inner edge may end in a pole anywhere along the image of the pole: that image is cut there.
  void split_poles() {
    for (std::size_t h = 0; h < halves_.size(); ++h) {
      if (halves_[h].edge != pole) continue;
      std::vector<double> cuts;
      const Vec2 a = halves_[h].uv_from, d = halves_[h].uv_to - a;
      for (const Half& other : halves_) {
        if (!other.inner || other.from != halves_[h].from) continue;
        const double share = dot(other.uv_from - a, d) / dot(d, d);
        if (share > 1e-3 && share < 1 - 1e-3 && near(a + share * d, other.uv_from)) cuts.push_back(share);
      }
      std::sort(cuts.begin(), cuts.end());
      for (std::size_t i = cuts.size(); i-- > 0;) {
        if (i > 0 && cuts[i] - cuts[i - 1] < 1e-9) continue;
        Half rest = halves_[h];
        const double t = rest.parameter(cuts[i]);
        (rest.reversed ? rest.image.high : rest.image.low) = t;
        Half& kept = halves_[h];
        (kept.reversed ? kept.image.low : kept.image.high) = t;
        // Shares refer to the whole image: what is kept now ends at this cut.
        for (std::size_t j = 0; j < i; ++j) cuts[j] /= cuts[i];
        rest.uv_from = kept.uv_to = rest.at(0);
        const int index = static_cast<int>(halves_.size());
        auto& ends = ends_[kept.from];
        ends.out.push_back(index);
        ends.in.push_back(index);
        halves_.push_back(rest);
      }
    }
  }

  Status link(const Surface& form) {
    const Vec2 period = form.period();
    const double wide_u = 0.25 * (period.x > 0 ? period.x : high_.x - low_.x);
    const double wide_v = 0.25 * (period.y > 0 ? period.y : high_.y - low_.y);
    for (auto& [vertex, ends] : ends_) {
      if (ends.in.size() == 1) {
        halves_[ends.in.front()].next = ends.out.front();
      } else {
        link_corners(ends);
      }
      for (const int h : ends.in) {
        const Vec2 jump = halves_[halves_[h].next].uv_from - halves_[h].uv_to;
        if (std::abs(jump.x) > wide_u || std::abs(jump.y) > wide_v) {
          return bad("a loop of a face does not close in the surface's parameters: a seam or a pole edge is missing",
                     place(vertex));
        }
      }
    }
    return {};
  }

  void link_corners(const Ends& ends) {
    // Corners: ends with one image.
    std::vector<Ends> corners;
    std::vector<Vec2> at;
    const auto corner_of = [&](Vec2 uv) -> Ends& {
      for (std::size_t i = 0; i < at.size(); ++i) {
        if (near(at[i], uv)) return corners[i];
      }
      at.push_back(uv);
      return corners.emplace_back();
    };
    for (const int h : ends.in) corner_of(halves_[h].uv_to).in.push_back(h);
    for (const int h : ends.out) corner_of(halves_[h].uv_from).out.push_back(h);
    const bool balanced =
        std::all_of(corners.begin(), corners.end(), [](const Ends& c) { return c.in.size() == c.out.size(); });
    if (!balanced) {
      link_nearest(ends);
      return;
    }
    for (const Ends& corner : corners) {
      if (corner.in.size() == 1) {
        halves_[corner.in.front()].next = corner.out.front();
      } else {
        link_by_angle(corner);
      }
    }
  }

  void link_nearest(const Ends& ends) {
    std::vector<int> free = ends.out;
    for (const int h : ends.in) {
      const auto best = std::min_element(free.begin(), free.end(), [&](int a, int b) {
        return distance(halves_[a].uv_from, halves_[h].uv_to) < distance(halves_[b].uv_from, halves_[h].uv_to);
      });
      halves_[h].next = *best;
      free.erase(best);
    }
  }

  void link_by_angle(const Ends& corner) {
    // Directions as seen at a common distance: tangent edges part there.
    double reach = 1e300;
    const auto length = [](const Half& h) {
      return std::max(distance(h.at(0), h.at(0.5)), distance(h.at(0), h.at(1)));
    };
    for (const int h : corner.in) reach = std::min(reach, length(halves_[h]));
    for (const int h : corner.out) reach = std::min(reach, length(halves_[h]));
    reach *= 0.02;
    std::vector<std::pair<double, int>> out;
    for (const int h : corner.out) out.emplace_back(departure(halves_[h], false, reach), h);
    std::set<int> used;
    // Narrow turns first, so that every arrival gets the next departure clockwise and none is taken twice.
    for (const int h : corner.in) {
      const double angle = departure(halves_[h], true, reach);
      int best = -1;
      double least = 0;
      for (const auto& [other_angle, other] : out) {
        const double turn = other == halves_[h].twin ? two_pi + 1 : clockwise(angle, other_angle);
        if (used.contains(other)) continue;
        if (best < 0 || turn < least) {
          best = other;
          least = turn;
        }
      }
      halves_[h].next = best;
      used.insert(best);
    }
  }

  /// The direction in which the half-edge leaves its corner (its end when `at_end`).
  static double departure(const Half& h, bool at_end, double reach) {
    const auto point = [&](double s) { return h.at(at_end ? 1 - s : s); };
    const Vec2 origin = point(0);
    double low = 0, high = 1e-6;
    while (high < 0.5 && distance(point(high), origin) < reach) high *= 2;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      (distance(point(middle), origin) < reach ? low : high) = middle;
    }
    return angle_of(point(high) - origin);
  }

  Result<std::vector<FaceLoop>> trace() {
    std::vector<FaceLoop> loops;
    const bool measure_all = !is_plane_ || halves_.size() > 0;
    for (Half& start : halves_) {
      if (start.traced) continue;
      FaceLoop loop;
      Vec2 last = start.at(0);
      const Vec2 origin = last;
      double twice = 0;
      for (Half* h = &start; !h->traced; h = &halves_[h->next]) {
        h->traced = true;
        if (h->edge != pole) loop.edges.push_back({h->edge, h->reversed, is_plane_ ? nullptr : h->image.flat});
        if (!measure_all) continue;
        const int samples = h->image.straight() ? 1 : 16;
        for (int i = 0; i <= samples; ++i) {
          const Vec2 p = h->at(static_cast<double>(i) / samples);
          twice += cross(last - origin, p - origin);
          last = p;
        }
      }
      loop.area = 0.5 * twice;
      if (!loop.edges.empty()) loops.push_back(std::move(loop));
    }
    if (loops.empty()) return bad("a face has no boundary");
    const auto outer = std::max_element(loops.begin(), loops.end(),
                                        [](const FaceLoop& a, const FaceLoop& b) { return a.area < b.area; });
    const double whole = outer->area;
    const auto turned =
        std::count_if(loops.begin(), loops.end(), [&](const FaceLoop& l) { return l.area > 1e-6 * whole; });
    if (whole <= 0 || turned > 1) {
      const Vec3 where = place(halves_.front().from);
      return whole <= 0 ? bad("the outer boundary of a face runs the wrong way round", where)
                        : bad("a face has two outer boundaries, or edges inside it cut it in two", where);
    }
    std::rotate(loops.begin(), outer, outer + 1);
    std::sort(points_.begin(), points_.end());
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    for (const int v : points_) {
      if (ends_.contains(v)) continue;
      FaceLoop loop;
      loop.vertex = v;
      loops.push_back(loop);
    }
    return loops;
  }

  TopoDS_Face face_;
  const TopTools_IndexedMapOfShape& vertices_;
  const TopTools_IndexedMapOfShape& edges_;
  bool is_plane_ = false;
  Frame frame_;
  std::vector<Half> halves_;
  std::map<int, Ends> ends_;
  std::vector<int> points_;
  Vec2 low_{1e300, 1e300}, high_{-1e300, -1e300};
};

}  // namespace

Result<std::vector<FaceLoop>> find_face_loops(const TopoDS_Face& face, const TopTools_IndexedMapOfShape& vertices,
                                              const TopTools_IndexedMapOfShape& edges) {
  return LoopFinder(face, vertices, edges).run();
}

}  // namespace aresta
