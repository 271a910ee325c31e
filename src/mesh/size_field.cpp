// SPDX-License-Identifier: Apache-2.0
#include "mesh/size_field.h"

#include <deque>
#include <utility>

namespace aresta::mesh {

namespace {

/// A request is dropped where the field already is within this factor: it bounds the work and loses no more than that.
constexpr double good_enough = 1.1;

int octant(Vec3 p, Vec3 centre) {
  return (p.x > centre.x ? 1 : 0) + (p.y > centre.y ? 2 : 0) + (p.z > centre.z ? 4 : 0);
}

/// Moves the centre of a cell of half-width `half` to that of a child.
Vec3 child_centre(Vec3 centre, double half, int index) {
  const double d = 0.5 * half;
  return centre + Vec3{index & 1 ? d : -d, index & 2 ? d : -d, index & 4 ? d : -d};
}

}  // namespace

SizeField::SizeField(const Box3& box, double largest, double least, double grading)
    : largest_(largest), least_(std::min(least, largest)), grading_(grading), cells_{{largest, 0}} {
  const Vec3 centre = box.empty() ? Vec3{} : box.centre();
  const Vec3 extent = box.empty() ? Vec3{1, 1, 1} : box.high - box.low;
  const double half = 0.505 * std::max({extent.x, extent.y, extent.z, least_});
  cube_ = {centre - Vec3{half, half, half}, centre + Vec3{half, half, half}};
}

void SizeField::restrict(Vec3 start, double wanted) {
  if (!(wanted > 0) || !is_finite(start)) return;
  std::deque<std::pair<Vec3, double>> pending{{start, std::max(wanted, least_)}};
  while (!pending.empty()) {
    const auto [p, size] = pending.front();
    pending.pop_front();
    if (!cube_.contains(p) || size >= largest_ || at(p) <= good_enough * size) continue;
    Vec3 centre = cube_.centre();
    double half = 0.5 * (cube_.high.x - cube_.low.x);
    std::uint32_t cell = 0;
    while (cells_[cell].first_child != 0 || 2 * half > size) {
      if (cells_[cell].first_child == 0) {
        const double inherited = cells_[cell].size;
        cells_[cell].first_child = static_cast<std::uint32_t>(cells_.size());
        cells_.resize(cells_.size() + 8, {inherited, 0});
      }
      const int index = octant(p, centre);
      cell = cells_[cell].first_child + static_cast<std::uint32_t>(index);
      centre = child_centre(centre, half, index);
      half *= 0.5;
    }
    cells_[cell].size = std::min(cells_[cell].size, size);
    const double next = size + grading_ * 2 * half;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-2 * half, 2 * half}) {
        Vec3 q = p;
        q[axis] += side;
        pending.emplace_back(q, next);
      }
    }
  }
}

double SizeField::at(Vec3 p) const {
  Vec3 centre = cube_.centre();
  double half = 0.5 * (cube_.high.x - cube_.low.x);
  std::uint32_t cell = 0;
  while (cells_[cell].first_child != 0) {
    const int index = octant(p, centre);
    cell = cells_[cell].first_child + static_cast<std::uint32_t>(index);
    centre = child_centre(centre, half, index);
    half *= 0.5;
  }
  return cells_[cell].size;
}

}  // namespace aresta::mesh
