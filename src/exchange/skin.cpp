// SPDX-License-Identifier: Apache-2.0
#include "exchange/skin.h"

#include <map>

#include "exchange/errors.h"
#include "occt/tessellate.h"

namespace aresta {

Result<Skin> make_skin(const Model& model, const ExportOptions& options, const Context& context) {
  TessellationOptions fineness;
  fineness.deflection = options.deflection;
  fineness.angle = options.angle;
  ARESTA_TRY(const Tessellation all, tessellate(model, fineness, context));
  const Complex& k = model.topology();
  Skin skin;
  std::map<std::array<double, 3>, std::uint32_t> number;
  for (const FaceId f : k.faces()) {
    const RegionId front = k.region(FaceUse(f, 0)), back = k.region(FaceUse(f, 1));
    if (front != back && model.is_region(front) && model.is_region(back)) continue;
    const bool turn = model.is_region(front) && !model.is_region(back);
    const FaceTriangles& face = all.faces[f.index()];
    std::vector<std::uint32_t> index;
    for (const Vec3 p : face.points) {
      const auto [found, is_new] = number.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(skin.points.size()));
      if (is_new) skin.points.push_back(p);
      index.push_back(found->second);
    }
    skin.faces.emplace_back(static_cast<std::uint32_t>(skin.triangles.size()), f);
    for (auto t : face.triangles) {
      if (turn) std::swap(t[1], t[2]);
      const std::array<std::uint32_t, 3> corner{index[t[0]], index[t[1]], index[t[2]]};
      if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;  // at a pole
      skin.triangles.push_back(corner);
    }
  }
  if (skin.triangles.empty()) return Error{errors::export_failed, "the model has no faces to write as triangles"};
  return skin;
}

}  // namespace aresta
