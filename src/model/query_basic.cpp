// SPDX-License-Identifier: Apache-2.0
// A point inside a region: half way along a ray that starts on one of its faces. query.cpp takes this file's place.
#include "model/query.h"

namespace aresta {

Result<Vec3> interior_point(const Model& model, RegionId region) {
  const RayCaster caster(model);
  for (const ShellId s : model.topology().shells(region)) {
    for (const FaceUse use : model.topology().face_uses(s)) {
      const auto uv = FaceTrim(model, use.face()).interior_point();
      if (!uv.ok()) continue;
      const Vec3 p = model.surface(use.face()).point(*uv);
      const Vec3 n = use.side() == 0 ? model.normal(use.face(), *uv) : -model.normal(use.face(), *uv);
      for (const RayHit& hit : caster.cast(p, n)) {
        if (hit.t <= 10 * model.tolerance()) continue;
        if (!hit.doubtful) return p + 0.5 * hit.t * n;
        break;
      }
    }
  }
  return Error{errors::measure_failed, "no point inside a region was found", {region}};
}

}  // namespace aresta
