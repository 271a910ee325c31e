// SPDX-License-Identifier: Apache-2.0
#include "model/measure.h"

#include <cmath>

#include "math/quadrature.h"
#include "model/face_moments_detail.h"

namespace aresta {

using model_detail::face_moments;

namespace {

std::array<double, 3> as_array(Vec3 p) {
  return {p.x, p.y, p.z};
}

/// The integral of q q^T changes so when q becomes q + d.
void shift_second(std::array<double, 6>& second, double measure, Vec3 first, Vec3 d) {
  const auto add = [&](int k, double qa, double qb, double da, double db) {
    second[k] += qa * db + qb * da + measure * da * db;
  };
  add(0, first.x, first.x, d.x, d.x);
  add(1, first.y, first.y, d.y, d.y);
  add(2, first.z, first.z, d.z, d.z);
  add(3, first.x, first.y, d.x, d.y);
  add(4, first.y, first.z, d.y, d.z);
  add(5, first.z, first.x, d.z, d.x);
}

Status known(std::size_t index, std::size_t count, EntityRef entity) {
  if (index < count) return {};
  return Error{errors::unknown_entity,
               std::string("the model has no ") + to_string(entity.kind) + " " + std::to_string(entity.index),
               {entity}};
}

Moments negated(Moments m) {
  m.measure = -m.measure;
  m.first = -m.first;
  for (double& x : m.second) x = -x;
  return m;
}

}  // namespace

Moments Moments::about(Vec3 point) const {
  Moments m = *this;
  const Vec3 d = reference - point;
  shift_second(m.second, measure, first, d);
  m.first += measure * d;
  m.reference = point;
  return m;
}

std::array<double, 6> Moments::inertia() const {
  const std::array<double, 6> s = about(centroid()).second;
  return {s[1] + s[2], s[0] + s[2], s[0] + s[1], -s[3], -s[4], -s[5]};
}

Moments& Moments::operator+=(const Moments& other) {
  if (measure == 0 && error == 0 && first == Vec3{} && second == std::array<double, 6>{}) return *this = other;
  const Moments m = other.reference == reference ? other : other.about(reference);
  measure += m.measure;
  first += m.first;
  for (std::size_t i = 0; i < 6; ++i) second[i] += m.second[i];
  error += m.error;
  return *this;
}

Result<Moments> measure(const Model& model, EdgeId edge, const MeasureOptions& options) {
  ARESTA_CHECK(known(edge.index(), model.topology().edge_count(), edge));
  const Range range = model.range(edge);
  Moments m;
  if (model.is_straight(edge)) {
    const Vec3 a = model.edge_point(edge, range.low), b = model.edge_point(edge, range.high);
    m.reference = lerp(a, b, 0.5);
    m.measure = distance(a, b);
    m.error = 2e-16 * m.measure;
    const Vec3 h = 0.5 * (b - a);
    const double k = m.measure / 3;
    m.second = {k * h.x * h.x, k * h.y * h.y, k * h.z * h.z, k * h.x * h.y, k * h.y * h.z, k * h.z * h.x};
    return m;
  }
  m.reference = model.edge_point(edge, range.middle());
  const double size = model.bounds(edge).diagonal();
  const auto density = [&](double t) {
    const CurveJet jet = model.edge_jet(edge, t);
    const Vec3 q = (jet.point - m.reference) / size;
    const double w = norm(jet.d1) / size;
    return std::array<double, 10>{w,
                                  w * q.x,
                                  w * q.y,
                                  w * q.z,
                                  w * q.x * q.x,
                                  w * q.y * q.y,
                                  w * q.z * q.z,
                                  w * q.x * q.y,
                                  w * q.y * q.z,
                                  w * q.z * q.x};
  };
  const auto sum = integrate(density, range.low, range.high, QuadratureOptions{.relative = 0.1 * options.relative});
  if (!std::isfinite(sum.value[0])) {
    return Error{errors::measure_failed, "the length of an edge is not finite", {edge}, as_array(m.reference)};
  }
  m.measure = size * sum.value[0];
  m.error = size * sum.error;
  m.first = size * size * Vec3{sum.value[1], sum.value[2], sum.value[3]};
  for (std::size_t i = 0; i < 6; ++i) m.second[i] = size * size * size * sum.value[4 + i];
  return m;
}

Result<Moments> measure(const Model& model, FaceId face, const MeasureOptions& options) {
  ARESTA_CHECK(known(face.index(), model.topology().face_count(), face));
  return face_moments(model, face, nullptr, options);
}

Result<Moments> flux(const Model& model, FaceId face, Vec3 reference, const MeasureOptions& options) {
  ARESTA_CHECK(known(face.index(), model.topology().face_count(), face));
  return face_moments(model, face, &reference, options);
}

Result<Moments> measure(const Model& model, RegionId region, const MeasureOptions& options) {
  const Complex& topology = model.topology();
  ARESTA_CHECK(known(region.index(), topology.region_count(), region));
  if (region == Complex::infinite_region()) {
    return Error{errors::measure_failed, "the infinite region has no volume", {region}};
  }
  Box3 box;
  for (const ShellId s : topology.shells(region)) {
    for (const FaceUse use : topology.face_uses(s)) {
      if (!topology.has_same_region_on_both_sides(use.face())) box.add(model.bounds(use.face()));
    }
  }
  Moments sum;
  sum.reference = box.empty() ? Vec3{} : box.centre();
  for (const ShellId s : topology.shells(region)) {
    for (const FaceUse use : topology.face_uses(s)) {
      if (topology.has_same_region_on_both_sides(use.face())) continue;
      ARESTA_TRY(const Moments m, flux(model, use.face(), sum.reference, options));
      sum += use.side() == 0 ? negated(m) : m;
    }
  }
  return sum;
}

Result<double> total_volume(const Model& model, const Context& context) {
  // Region by region, as each has a reference point of its own near it.
  double sum = 0;
  const auto regions = model.regions();
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (i % 64 == 0) {
      ARESTA_CHECK(context.step(static_cast<double>(i) / static_cast<double>(regions.size()), "measuring volumes"));
    }
    ARESTA_TRY(const Moments m, measure(model, regions[i]));
    sum += m.measure;
  }
  return sum;
}

Result<double> total_area(const Model& model, const Context& context) {
  double sum = 0;
  const std::size_t count = model.topology().face_count();
  for (const FaceId f : model.topology().faces()) {
    if (f.index() % 64 == 0) {
      ARESTA_CHECK(context.step(static_cast<double>(f.index()) / static_cast<double>(count), "measuring areas"));
    }
    ARESTA_TRY(const Moments m, measure(model, f));
    sum += m.measure;
  }
  return sum;
}

Result<double> total_length(const Model& model, const Context& context) {
  double sum = 0;
  const std::size_t count = model.topology().edge_count();
  for (const EdgeId e : model.topology().edges()) {
    if (e.index() % 256 == 0) {
      ARESTA_CHECK(context.step(static_cast<double>(e.index()) / static_cast<double>(count), "measuring lengths"));
    }
    ARESTA_TRY(const Moments m, measure(model, e));
    sum += m.measure;
  }
  return sum;
}

}  // namespace aresta
