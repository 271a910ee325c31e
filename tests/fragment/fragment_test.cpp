// SPDX-License-Identifier: Apache-2.0
#include "fragment/fragment.h"

#include <gtest/gtest.h>

#include <numbers>

#include "construct/primitives.h"
#include "construct/profiles.h"
#include "model/check.h"
#include "model/copy.h"
#include "model/measure.h"

namespace aresta {
namespace {

using ModelPtr = std::shared_ptr<const Model>;

ModelPtr take(Result<Model> model) {
  if (!model.ok()) throw std::runtime_error(model.error().to_line());
  return std::make_shared<const Model>(std::move(*model));
}

template <class T>
T take(Result<T> result) {
  if (!result.ok()) throw std::runtime_error(result.error().to_line());
  return std::move(*result);
}

TEST(Fragment, CellsAreLabelledByTheRegionsThatContainThem) {
  const ModelPtr a = take(block(2, 2, 2)), b = take(block(2, 2, 2, {1, 1, 1}));
  const Fragment f = take(fragment({a, b}, {}, {}));
  ASSERT_EQ(f.model->regions().size(), 3u);
  std::map<std::pair<bool, bool>, double> volume;
  for (const RegionId r : f.model->regions()) {
    const std::pair inside{a->is_region(f.labels.region_of(0, r)), b->is_region(f.labels.region_of(1, r))};
    volume[inside] += measure(*f.model, r)->measure;
  }
  EXPECT_NEAR((volume[{true, false}]), 7, 1e-12);
  EXPECT_NEAR((volume[{false, true}]), 7, 1e-12);
  EXPECT_NEAR((volume[{true, true}]), 1, 1e-12);
  EXPECT_EQ(f.labels.region_of(0, RegionId(0)), Complex::infinite_region());
}

TEST(Fragment, EveryPieceKnowsItsParents) {
  const ModelPtr a = take(block(2, 2, 2)), b = take(block(2, 2, 2, {1, 0, 0}));  // faces partly coincide
  const Fragment f = take(fragment({a, b}, {}, {}));
  std::size_t of_both = 0;
  for (const FaceId face : f.model->topology().faces()) {
    const auto parents = f.parents(face);
    ASSERT_FALSE(parents.empty());
    of_both += parents.size() == 2 ? 1 : 0;
  }
  EXPECT_EQ(of_both, 4u);  // the four sides where both blocks lie
  for (const FaceId face : a->topology().faces()) {
    double area = 0;
    for (const std::uint32_t piece : f.pieces(0, face)) area += measure(*f.model, FaceId(piece))->measure;
    EXPECT_NEAR(area, 4, 1e-12);
  }
}

TEST(Fragment, SheetsThatEncloseMakeARegionAndVoidsStayEmpty) {
  const ModelPtr a = take(block(3, 3, 3)), hole = take(block(1, 1, 1, {1, 1, 1}));
  const Fragment nested = take(fragment({a, hole}, {}, {}));
  EXPECT_EQ(nested.model->regions().size(), 2u);

  // The six faces of a block as sheets: nothing is filled in them.
  ModelBuilder builder = to_builder(*hole);
  const ModelPtr shell = take(builder.build(Context{}));
  ASSERT_TRUE(shell->regions().empty());
  EXPECT_EQ(take(fragment({shell, take(block(1, 1, 1, {9, 0, 0}))}, {}, {})).model->regions().size(), 2u);
  FragmentOptions plain;
  plain.detect_regions = false;
  EXPECT_EQ(take(fragment({shell, take(block(1, 1, 1, {9, 0, 0}))}, plain, {})).model->regions().size(), 1u);
}

TEST(Fragment, AVoidStaysEmptyWhateverHangsInIt) {
  ModelBuilder both = to_builder(*take(block(4, 4, 4)));
  append(both, *take(block(2, 2, 2, {1, 1, 1})));
  const Cells cells = take(both.find_cells({}));
  const std::uint32_t outer = cells.of_face_use[1];  // behind the first face
  std::vector<bool> filled(cells.count, false);
  filled[outer] = true;
  const ModelPtr hollow = take(both.build(cells, filled));
  const ModelPtr sheet = take(polygon(std::vector<Vec3>{{1.5, 1.5, 2}, {2.5, 1.5, 2}, {2, 2.5, 2}}));
  EXPECT_EQ(take(fragment({hollow, sheet}, {}, {})).model->regions().size(), 1u);
  // Across the whole void the sheet encloses its halves.
  const ModelPtr wall = take(polygon(std::vector<Vec3>{{1, 1, 2}, {3, 1, 2}, {3, 3, 2}, {1, 3, 2}}));
  EXPECT_EQ(take(fragment({hollow, wall}, {}, {})).model->regions().size(), 3u);
}

TEST(Fragment, LabelsAndConstraintsFollowThePieces) {
  Model a = *take(block(2, 2, 2));
  a.labels.set_name(a.regions().front(), "steel");
  a.labels.groups.push_back({"clamped", {FaceId(std::size_t{0})}});
  const auto first = std::make_shared<const Model>(a);
  const Fragment f = take(fragment({first, take(cylinder(0.5, 4, {{1, 1, -1}, {0, 0, 1}}))}, {}, {}));
  std::size_t named = 0;
  for (const RegionId r : f.model->regions()) named += f.model->labels.name(r) == "steel" ? 1 : 0;
  EXPECT_EQ(named, 2u);  // the block outside the cylinder and the core inside both
  ASSERT_EQ(f.model->labels.groups.size(), 1u);
  EXPECT_EQ(f.model->labels.groups[0].entities.size(), f.pieces(0, FaceId(std::size_t{0})).size());
}

TEST(Fragment, OneOperandIsItsOwnFragment) {
  const ModelPtr a = take(sphere(1));
  const Fragment f = take(fragment({a}, {}, {}));
  EXPECT_EQ(f.model->topology().face_count(), a->topology().face_count());
  EXPECT_NEAR(*total_volume(*f.model), 4 * std::numbers::pi / 3, 1e-10);
}

/// The same model; the curved sides' surfaces begin `angle` before their seams, as files write them.
ModelPtr with_turned_sides(const Model& model, double angle) {
  GeometryChanges changes;
  const Complex& k = model.topology();
  for (const FaceId f : k.faces()) {
    const auto* side = model.surface(f).get_if<Cylinder>();
    if (side == nullptr) continue;
    Cylinder turned = *side;
    turned.frame.x = std::cos(angle) * side->frame.x - std::sin(angle) * side->frame.y;
    turned.frame.y = std::sin(angle) * side->frame.x + std::cos(angle) * side->frame.y;
    changes.surfaces.emplace(f, GeometryChanges::NewSurface{turned});
    for (const LoopId l : k.loops(f)) {
      for (const CoedgeId c : k.coedges(l)) changes.images.emplace(c, model.pcurve(c)->translated({angle, 0}));
    }
  }
  return take(with_geometry(model, changes));
}

TEST(Fragment, CoincidentSidesAreOneWhereverTheirSeamsAre) {
  // Two equal rods. Seams at one place: a side and two ends. Apart: the side is two pieces.
  const double pi = std::numbers::pi;
  const auto rod = [](double turn) { return take(cylinder(1, 4, {}, {1, turn})); };
  const ModelPtr inner = rod(0);
  ASSERT_TRUE(require_valid(*with_turned_sides(*inner, pi), CheckLevel::full).ok());
  for (const double turn : {0.0, 60.0, 180.0}) {
    for (const double angle : {0.0, 1.0, pi}) {
      const ModelPtr other = with_turned_sides(*rod(turn), angle);
      const Fragment f = take(fragment({with_turned_sides(*inner, pi), other}, {}, {}));
      EXPECT_EQ(f.model->regions().size(), 1u) << turn << " " << angle;
      EXPECT_EQ(f.model->topology().face_count(), turn == 0 ? 3u : 4u) << turn << " " << angle;
      EXPECT_NEAR(*total_volume(*f.model), 4 * pi, 1e-9);
      const ModelPtr block_around = take(block(4, 4, 4, {-2, -2, 0}));
      const Fragment nested = take(fragment({block_around, with_turned_sides(*inner, pi), other}, {}, {}));
      EXPECT_EQ(nested.model->regions().size(), 2u) << turn << " " << angle;
      EXPECT_TRUE(require_valid(*nested.model, CheckLevel::full).ok());
    }
  }
}

/// An engine that forgets a face: the checks above it must notice.
class ForgetfulEngine final : public FragmentEngine {
 public:
  const char* name() const override { return "forgetful"; }
  Result<Imprint> imprint(std::span<const ModelPtr> operands, double, const Context&) const override {
    // Says that the second block's faces are pieces of the first one's, a size too small.
    Imprint out{to_builder(*operands[1]), {}, {}, {}, {}};
    const Complex& k = operands[1]->topology();
    for (const VertexId v : k.vertices()) out.vertex_parents.push_back({{0, v}, {1, v}});
    for (const EdgeId e : k.edges()) out.edge_parents.push_back({{0, e}, {1, e}});
    for (const FaceId face : k.faces()) out.face_parents.push_back({{0, face}, {1, face}});
    return out;
  }
};

TEST(Fragment, WhatAnEngineLosesIsNotReturned) {
  const ForgetfulEngine forgetful;
  FragmentOptions options;
  options.engine = &forgetful;
  const auto result = fragment({take(block(2, 2, 2)), take(block(1, 1, 1))}, options, {});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, errors::not_conserved) << result.error().to_line();
}

TEST(Fragment, ErrorsAndCancellation) {
  EXPECT_EQ(fragment({}, {}, {}).error().code, errors::no_operands);
  std::atomic<bool> stop = true;
  Context context;
  context.cancel = &stop;
  EXPECT_EQ(fragment({take(block(1, 1, 1)), take(sphere(1))}, {}, context).error().code, errors::cancelled);
}

}  // namespace
}  // namespace aresta
