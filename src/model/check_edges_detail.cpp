// SPDX-License-Identifier: Apache-2.0
// Where two edges meet that should not.
//
// Straight edges: closed form. Curved ones: chords with a bound of their deviation; pairs of chords that may be near
// are refined by Gauss-Newton steps on the distance of the curves, kept inside the pair's intervals, from several
// starts. Edges that share a vertex are near each other there; how far depends on how they leave it. A meeting counts
// when it lies beyond a radius that a contact of second order would need, and, in the first tenth of the edges, when
// between it and the vertex the edges part. Edges that overlap from a shared vertex on do so for longer.
#include <algorithm>
#include <cmath>

#include "math/box_tree.h"
#include "model/check_detail.h"

namespace aresta::model_detail {

namespace {

struct Closest {
  double s = 0, t = 0, distance = 0;
  Vec3 place{};
};

/// Closest points of the segments a + s u and b + t v, s and t in [0, 1]. After Ericson, Real-Time Collision Detection.
Closest closest(Vec3 a, Vec3 u, Vec3 b, Vec3 v) {
  const Vec3 r = a - b;
  const double uu = dot(u, u), vv = dot(v, v), rv = dot(v, r);
  double s = 0, t = 0;
  if (uu <= 0 && vv <= 0) {
  } else if (uu <= 0) {
    t = std::clamp(rv / vv, 0.0, 1.0);
  } else {
    const double ru = dot(u, r);
    if (vv <= 0) {
      s = std::clamp(-ru / uu, 0.0, 1.0);
    } else {
      const double uv = dot(u, v), determinant = uu * vv - uv * uv;
      s = determinant > 1e-14 * uu * vv ? std::clamp((uv * rv - ru * vv) / determinant, 0.0, 1.0) : 0;
      t = (uv * s + rv) / vv;
      if (t < 0) {
        t = 0;
        s = std::clamp(-ru / uu, 0.0, 1.0);
      } else if (t > 1) {
        t = 1;
        s = std::clamp((uv - ru) / uu, 0.0, 1.0);
      }
    }
  }
  const Vec3 p = a + s * u, q = b + t * v;
  return {s, t, distance(p, q), lerp(p, q, 0.5)};
}

struct Chord {
  double t0 = 0, t1 = 0;
  Vec3 a, b;
  double sagitta = 0;
  Box3 box;
};

std::vector<Chord> chords_of(const Model& model, EdgeId e) {
  const Range range = model.range(e);
  const int count = model.is_straight(e) ? 1 : 16;
  std::vector<Chord> chords;
  Vec3 a = model.edge_point(e, range.low);
  for (int i = 0; i < count; ++i) {
    Chord c;
    c.t0 = range.at(static_cast<double>(i) / count);
    c.t1 = range.at(static_cast<double>(i + 1) / count);
    c.a = a;
    c.b = model.edge_point(e, c.t1);
    if (count > 1) {
      for (const double w : {0.25, 0.5, 0.75}) {
        const Vec3 p = model.edge_point(e, c.t0 + w * (c.t1 - c.t0));
        const Vec3 d = c.b - c.a;
        const double dd = norm2(d), k = dd > 0 ? std::clamp(dot(p - c.a, d) / dd, 0.0, 1.0) : 0;
        c.sagitta = std::max(c.sagitta, 1.5 * distance(p, c.a + k * d));
      }
    }
    c.box.add(c.a);
    c.box.add(c.b);
    c.box = c.box.grown(c.sagitta);
    a = c.b;
    chords.push_back(c);
  }
  return chords;
}

class Meeting {
 public:
  Meeting(const Model& model, EdgeId a, EdgeId b, double tolerance)
      : model_(model), k_(model.topology()), a_(a), b_(b), tolerance_(tolerance) {
    for (const VertexId v : {k_.start(a), k_.end(a)}) {
      if ((v == k_.start(b) || v == k_.end(b)) && (shared_count_ == 0 || shared_[0] != v)) shared_[shared_count_++] = v;
    }
  }

  std::optional<EdgeMeeting> find() {
    if (model_.is_straight(a_) && model_.is_straight(b_)) return straight();
    if (!model_.bounds(a_).grown(tolerance_).overlaps(model_.bounds(b_))) return {};
    const auto chords_a = chords_of(model_, a_), chords_b = chords_of(model_, b_);
    double length_a = 0, length_b = 0;
    for (const Chord& c : chords_a) length_a += distance(c.a, c.b);
    for (const Chord& c : chords_b) length_b += distance(c.a, c.b);
    shorter_ = std::min(length_a, length_b);
    radius_ = std::max(10 * tolerance_, std::sqrt(16 * tolerance_ * std::max(length_a, length_b)));
    for (const Chord& c : chords_a) {
      const Box3 box = c.box.grown(tolerance_);
      for (const Chord& d : chords_b) {
        if (!box.overlaps(d.box)) continue;
        const Closest near = closest(c.a, c.b - c.a, d.a, d.b - d.a);
        if (near.distance > c.sagitta + d.sagitta + tolerance_) continue;
        if (const auto met = refine(c, d, near)) return met;
      }
    }
    return {};
  }

 private:
  std::optional<EdgeMeeting> straight() const {
    const Vec3 a = model_.point(k_.start(a_)), u = model_.point(k_.end(a_)) - a;
    const Vec3 b = model_.point(k_.start(b_)), v = model_.point(k_.end(b_)) - b;
    if (shared_count_ == 2) return {};  // a duplicate, found elsewhere
    if (shared_count_ == 0) {
      const Closest c = closest(a, u, b, v);
      if (c.distance <= tolerance_) return EdgeMeeting{c.place, c.distance};
      return {};
    }
    // Two segments from one point overlap when the far end of one lies on the other.
    const Vec3 far_a = k_.start(a_) == shared_[0] ? a + u : a, far_b = k_.start(b_) == shared_[0] ? b + v : b;
    const Closest on_b = closest(far_a, {}, b, v), on_a = closest(far_b, {}, a, u);
    if (on_b.distance <= tolerance_) return EdgeMeeting{far_a, on_b.distance};
    if (on_a.distance <= tolerance_) return EdgeMeeting{far_b, on_a.distance};
    return {};
  }

  std::optional<EdgeMeeting> refine(const Chord& c, const Chord& d, const Closest& near) const {
    const double starts[5][2] = {{near.s, near.t}, {0, 0}, {1, 1}, {0, 1}, {1, 0}};
    const int count = shared_count_ > 0 ? 5 : 2;
    for (int i = 0; i < count; ++i) {
      double s = c.t0 + starts[i][0] * (c.t1 - c.t0), t = d.t0 + starts[i][1] * (d.t1 - d.t0);
      double best = std::numeric_limits<double>::infinity();
      Vec3 place{};
      double at = s;
      for (int k = 0; k < 25; ++k) {
        const CurveJet p = model_.edge_jet(a_, s), q = model_.edge_jet(b_, t);
        const Vec3 r = p.point - q.point;
        const double gap = norm(r);
        if (gap < best) {
          best = gap;
          place = lerp(p.point, q.point, 0.5);
          at = s;
        }
        // min |r + ds p' - dt q'|^2
        const double pp = dot(p.d1, p.d1), qq = dot(q.d1, q.d1), pq = dot(p.d1, q.d1), rp = dot(r, p.d1),
                     rq = dot(r, q.d1), determinant = pp * qq - pq * pq;
        double ds = 0, dt = 0;
        if (determinant > 1e-12 * pp * qq) {
          ds = (pq * rq - qq * rp) / determinant;
          dt = (pp * rq - pq * rp) / determinant;
        } else if (qq > 0) {
          dt = rq / qq;  // nearly parallel: only b moves
        }
        const double new_s = std::clamp(s + ds, c.t0, c.t1), new_t = std::clamp(t + dt, d.t0, d.t1);
        if (new_s == s && new_t == t) break;
        const bool still = std::abs(new_s - s) <= 1e-15 * std::abs(s) && std::abs(new_t - t) <= 1e-15 * std::abs(t);
        s = new_s, t = new_t;
        if (still) break;
      }
      if (best <= tolerance_ && apart_from_shared(place, at)) return EdgeMeeting{place, best};
    }
    return {};
  }

  /// Is a meeting at parameter s of edge a more than the nearness at a shared vertex?
  bool apart_from_shared(Vec3 place, double s) const {
    for (int i = 0; i < shared_count_; ++i) {
      const VertexId v = shared_[i];
      const double off = distance(place, model_.point(v));
      if (off <= std::max(radius_, 4 * model_.tolerance(v))) return false;
      if (off > 0.1 * shorter_) continue;
      const Range range = model_.range(a_);
      const bool from_start = k_.start(a_) == v && (k_.end(a_) != v || s < range.middle());
      const double from = from_start ? range.low : range.high;
      bool parts = false;
      for (int k = 1; k < 8 && !parts; ++k) {
        const Vec3 p = model_.edge_point(a_, from + (s - from) * k / 8);
        parts = distance_to_b(p) > 2 * tolerance_;
      }
      if (!parts) return false;
    }
    return true;
  }

  double distance_to_b(Vec3 p) const {
    if (!model_.is_straight(b_)) return model_.curve(b_).project(p, model_.range(b_)).distance;
    const Vec3 b = model_.point(k_.start(b_));
    return closest(p, {}, b, model_.point(k_.end(b_)) - b).distance;
  }

  const Model& model_;
  const Complex& k_;
  EdgeId a_, b_;
  double tolerance_ = 0, radius_ = 0, shorter_ = 0;
  VertexId shared_[2];
  int shared_count_ = 0;
};

}  // namespace

std::optional<EdgeMeeting> find_meeting(const Model& model, EdgeId a, EdgeId b, double tolerance) {
  return Meeting(model, a, b, tolerance).find();
}

}  // namespace aresta::model_detail
