// SPDX-License-Identifier: Apache-2.0
// Inner integrals of Green's theorem: moments of a surface strip between v0 and v, per unit of u.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "model/model.h"

namespace aresta::model_detail {

/// [0] area; [1] measure, [2..4] first and [5..10] second moments (xx, yy, zz, xy, yz, zx): of area, or, for flux, of
/// the cones from the reference point to the surface. Lengths are in units of `size`, moments about `reference`.
using PatchMoments = std::array<double, 11>;

struct PatchOptions {
  bool flux = false;
  Vec3 reference{};
  double size = 1;
  double relative = 1e-11;
};

/// The strip G(u, v) = integral from v0 to v of the densities at u; closed form on analytic surfaces.
/// For free-form surfaces `swapped` exchanges the roles of u and v (the strip then runs along u).
class Patch {
 public:
  Patch(const Surface& surface, const Range2& box, bool swapped, const PatchOptions& options);

  PatchMoments strip(double u, double v) const;
  /// The u strictly between two others, in order, where the surface is less smooth than elsewhere: an integral of
  /// strips is a sum over the pieces between them.
  std::vector<double> breaks(double from, double to) const;
  /// The largest error of the strips asked for so far (free-form surfaces).
  double worst_error() const { return worst_; }

  /// Lines v = const that are one point of the surface, or where the surface closes upon itself: the ends of v.
  std::optional<double> low_end, high_end;
  /// Is the surface closed: is the whole of it, between low_end and high_end and over a period of u, finite and without
  /// boundary?
  bool closed = false;

 private:
  void start_at_singular_end(Range along, double end);
  PatchMoments ruled(double u, double v) const;
  PatchMoments round(double u, double v) const;
  PatchMoments free(double u, double v) const;

  const Surface& surface_;
  PatchOptions options_;
  bool swapped_;
  double v0_ = 0, sign_ = 1;
  std::vector<double> knots_, breaks_;  ///< along v and u; of a periodic parameter those of one period in breaks_
  double period_ = 0;                   ///< of u
  mutable double worst_ = 0;
};

}  // namespace aresta::model_detail
