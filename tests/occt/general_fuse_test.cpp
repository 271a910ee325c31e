// SPDX-License-Identifier: Apache-2.0
// Expected counts are written by hand from pictures of the situations.
#include "occt/general_fuse.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>

#include <atomic>

#include "occt/errors.h"
#include "shapes.h"

namespace aresta::test {
namespace {

using Operands = std::vector<std::shared_ptr<const Model>>;

std::shared_ptr<const Model> model_of(const TopoDS_Shape& shape) {
  auto read = to_model(wrap(shape));
  if (!read.ok()) {
    ADD_FAILURE() << text(read.error());
    return std::make_shared<const Model>();
  }
  return std::make_shared<const Model>(std::move(read->model));
}

struct Fused {
  FuseResult result;
  Model model;
  std::string counts;  // cells besides the infinite one/faces/edges/vertices
};

Fused fuse(std::initializer_list<TopoDS_Shape> shapes, double tolerance = 0) {
  Operands operands;
  for (const TopoDS_Shape& shape : shapes) operands.push_back(model_of(shape));
  auto result = general_fuse(*side_by_side(operands), tolerance);
  if (!result.ok()) {
    ADD_FAILURE() << text(result.error());
    return {};
  }
  ModelBuilder builder = result->builder;
  auto model = builder.build({});
  if (!model.ok()) {
    ADD_FAILURE() << text(model.error());
    return {};
  }
  Fused fused{std::move(*result), std::move(*model), {}};
  const Complex& built = fused.model.topology();
  fused.counts = std::to_string(built.region_count() - 1) + "/" + std::to_string(built.face_count()) + "/" +
                 std::to_string(built.edge_count()) + "/" + std::to_string(built.vertex_count());
  return fused;
}

/// Loops of the first face: their lengths, 0 for a point.
std::vector<std::size_t> loop_lengths(const Model& model, FaceId f = FaceId(std::size_t{0})) {
  std::vector<std::size_t> lengths;
  const Complex& k = model.topology();
  for (const LoopId l : k.loops(f)) lengths.push_back(k.is_vertex_loop(l) ? 0 : k.coedges(l).count());
  return lengths;
}

using Lengths = std::vector<std::size_t>;

TopoDS_Face square() {
  return polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
}

TEST(GeneralFuse, TwoBoxesThatOverlap) {
  const Fused f = fuse({box(0, 0, 0, 2, 2, 2), box(1, 1, 1, 2, 2, 2)});
  // Three cells. Each box: 3 faces untouched, 3 cut into two; no face is shared. Edges: 24, 6 of them cut in two, and 6
  // new ones of the hexagon in which the surfaces meet. Vertices: 16 and the 6 of the hexagon.
  EXPECT_EQ(f.counts, "3/18/36/22");
  ASSERT_EQ(f.result.faces.size(), 18u);
  for (const auto& parents : f.result.faces) EXPECT_EQ(parents.size(), 1u);
  int of_one = 0, of_two_faces = 0;
  for (const auto& parents : f.result.edges) {
    if (parents.size() == 1) {
      ++of_one;
      EXPECT_EQ(parents[0].entity.kind, EntityKind::edge);
    } else {
      ++of_two_faces;
      ASSERT_EQ(parents.size(), 2u);
      EXPECT_EQ(parents[0].operand, 0u);
      EXPECT_EQ(parents[0].entity.kind, EntityKind::face);
      EXPECT_EQ(parents[1].operand, 1u);
      EXPECT_EQ(parents[1].entity.kind, EntityKind::face);
    }
  }
  EXPECT_EQ(of_one, 30);
  EXPECT_EQ(of_two_faces, 6);
  int pierced = 0;
  for (const auto& parents : f.result.vertices) {
    if (parents.size() != 2) continue;
    ++pierced;
    const bool first_edge = parents[0].entity.kind == EntityKind::edge;
    EXPECT_EQ(parents[first_edge ? 0 : 1].entity.kind, EntityKind::edge);
    EXPECT_EQ(parents[first_edge ? 1 : 0].entity.kind, EntityKind::face);
  }
  EXPECT_EQ(pierced, 6);
}

TEST(GeneralFuse, SharedFaceHasBothParents) {
  const Fused f = fuse({box(0, 0, 0, 1, 1, 1), box(1, 0, 0, 1, 1, 1)});
  EXPECT_EQ(f.counts, "2/11/20/12");
  int shared = 0;
  for (const auto& parents : f.result.faces) {
    if (parents.size() < 2) continue;
    ++shared;
    EXPECT_EQ(parents[0].operand, 0u);
    EXPECT_EQ(parents[1].operand, 1u);
    EXPECT_NE(parents[0].opposite, parents[1].opposite);
  }
  EXPECT_EQ(shared, 1);
}

TEST(GeneralFuse, PartlyCoincidentFaces) {
  // The small box stands on the big one: its base is a piece of the big one's top, which is left with a hole.
  const Fused f = fuse({box(0, 0, 0, 4, 4, 1), box(1, 1, 1, 2, 2, 1)});
  EXPECT_EQ(f.counts, "2/12/24/16");
}

TEST(GeneralFuse, PartsOfOneOperandAreImprintedToo) {
  const Fused f = fuse({compound({box(0, 0, 0, 1, 1, 1), box(1, 0, 0, 1, 1, 1)})});
  EXPECT_EQ(f.counts, "2/11/20/12");
}

TEST(GeneralFuse, OneOperandComesBackAsItIs) {
  const Fused f = fuse({box(0, 0, 0, 1, 1, 1)});
  EXPECT_EQ(f.counts, "1/6/12/8");
  for (const auto& parents : f.result.faces) ASSERT_EQ(parents.size(), 1u);
}

TEST(GeneralFuse, WireOnASquare) {
  const Fused f = fuse({square(), segment({1, 1, 0}, {2, 3, 0})});
  EXPECT_EQ(f.counts, "0/1/5/6");
  EXPECT_EQ(loop_lengths(f.model), (Lengths{4, 2}));
  // The loose edge has the wire and the face.
  int both = 0;
  for (const auto& parents : f.result.edges) both += parents.size() == 2;
  EXPECT_EQ(both, 1);
}

TEST(GeneralFuse, WireFromTheBoundaryInwards) {
  const Fused f = fuse({square(), segment({2, 0, 0}, {2, 3, 0})});
  EXPECT_EQ(f.counts, "0/1/6/6");
  EXPECT_EQ(loop_lengths(f.model), (Lengths{7}));
}

TEST(GeneralFuse, WireAcrossASquareDividesIt) {
  const Fused f = fuse({square(), segment({2, -1, 0}, {2, 5, 0})});
  EXPECT_EQ(f.counts, "0/2/9/8");
}

TEST(GeneralFuse, PointOnAFace) {
  const Fused f = fuse({square(), BRepBuilderAPI_MakeVertex(gp_Pnt(1, 2, 0)).Shape()});
  EXPECT_EQ(f.counts, "0/1/4/5");
  EXPECT_EQ(loop_lengths(f.model), (Lengths{4, 0}));
  ASSERT_EQ(f.result.vertices.back().size(), 2u);
}

TEST(GeneralFuse, PointOnAFaceOfABox) {
  const Fused f = fuse({box(0, 0, 0, 4, 4, 4), BRepBuilderAPI_MakeVertex(gp_Pnt(1, 2, 4)).Shape()});
  EXPECT_EQ(f.counts, "1/6/12/9");
  int points = 0;
  for (const LoopId l : f.model.topology().loops()) points += f.model.topology().is_vertex_loop(l);
  EXPECT_EQ(points, 1);
}

TEST(GeneralFuse, EdgeTouchesAFaceWithItsEnd) {
  const Fused f = fuse({square(), segment({1, 2, 0}, {1, 2, 5})});
  EXPECT_EQ(f.counts, "0/1/5/6");
  EXPECT_EQ(loop_lengths(f.model), (Lengths{4, 0}));
  int wires = 0;
  for (const EdgeId e : f.model.topology().edges()) wires += f.model.topology().is_wire(e);
  EXPECT_EQ(wires, 1);
}

TEST(GeneralFuse, EdgePiercesAFace) {
  const Fused f = fuse({square(), segment({1, 2, -5}, {1, 2, 5})});
  EXPECT_EQ(f.counts, "0/1/6/7");
  EXPECT_EQ(loop_lengths(f.model), (Lengths{4, 0}));
}

TEST(GeneralFuse, CrossingWires) {
  const Fused f = fuse({segment({0, 0, 0}, {2, 0, 0}), segment({1, -1, 0}, {1, 1, 0})});
  EXPECT_EQ(f.counts, "0/0/4/5");
}

TEST(GeneralFuse, CrossingWiresInAFace) {
  const Fused f = fuse({square(), segment({1, 2, 0}, {3, 2, 0}), segment({2, 1, 0}, {2, 3, 0})});
  EXPECT_EQ(f.counts, "0/1/8/9");
  EXPECT_EQ(loop_lengths(f.model), (Lengths{4, 8}));
}

TEST(GeneralFuse, WiresThatLieOnEachOther) {
  const Fused f = fuse({segment({0, 0, 0}, {3, 0, 0}), segment({1, 0, 0}, {5, 0, 0})});
  EXPECT_EQ(f.counts, "0/0/3/4");
}

TEST(GeneralFuse, ApexOfAConeOnAFace) {
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(2, 2, 0), gp_Dir(0, 0, 1)), 0, 1, 2).Shape();
  const Fused f = fuse({square(), cone});
  EXPECT_EQ(f.counts, "1/3/6/6");
  EXPECT_EQ(loop_lengths(f.model), (Lengths{4, 0}));
}

TEST(GeneralFuse, SphereCutByASquare) {
  const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(gp_Pnt(2, 2, 0), 1).Shape();
  const Fused f = fuse({square(), sphere});
  // The equator divides sphere and square; it begins where it crosses the seam, which it cuts in two.
  EXPECT_EQ(f.counts, "2/4/7/7");
}

TEST(GeneralFuse, CylinderThroughABox) {
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(2, 2, -1), gp_Dir(0, 0, 1)), 1, 6).Shape();
  const Fused f = fuse({box(0, 0, 0, 4, 4, 4), rod});
  // Box outside the rod, rod in the box, two stumps. Box: 4 sides, top and bottom each with a disc; rod: three pieces
  // of its side, two ends. Edges: 12 + 2 + 2 circles + 3 pieces of the seam.
  EXPECT_EQ(f.counts, "4/13/19/12");
}

TEST(GeneralFuse, CoincidentCylinders) {
  const gp_Ax2 axis(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  const Fused f = fuse({BRepPrimAPI_MakeCylinder(axis, 1, 2).Shape(),
                        BRepPrimAPI_MakeCylinder(axis.Translated(gp_Vec(0, 0, 1)), 1, 2).Shape()});
  EXPECT_EQ(f.counts, "3/7/7/4");
}

TEST(GeneralFuse, SameTwice) {
  const Fused f = fuse({box(0, 0, 0, 1, 2, 3), box(0, 0, 0, 1, 2, 3)});
  EXPECT_EQ(f.counts, "1/6/12/8");
  for (const auto& parents : f.result.vertices) EXPECT_EQ(parents.size(), 2u);
  for (const auto& parents : f.result.edges) EXPECT_EQ(parents.size(), 2u);
  for (const auto& parents : f.result.faces) {
    ASSERT_EQ(parents.size(), 2u);
    EXPECT_EQ(parents[0].opposite, parents[1].opposite);
  }
}

TEST(GeneralFuse, ToleranceClosesAGap) {
  const double gap = 1e-5;
  const Fused apart = fuse({box(0, 0, 0, 1, 1, 1), box(1 + gap, 0, 0, 1, 1, 1)});
  EXPECT_EQ(apart.counts, "2/12/24/16");
  const Fused closed = fuse({box(0, 0, 0, 1, 1, 1), box(1 + gap, 0, 0, 1, 1, 1)}, 1e-4);
  EXPECT_EQ(closed.counts, "2/11/20/12");
}

TEST(GeneralFuse, ThinnerThanTheToleranceIsRefused) {
  const Operands operands{model_of(box(0, 0, 0, 1, 1, 1e-5)), model_of(box(0, 0, 0, 1, 1, 1))};
  auto result = general_fuse(*side_by_side(operands), 1e-4);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, errors::general_fuse_failed);
  EXPECT_FALSE(result.error().entities.empty() && !result.error().place.has_value()) << text(result.error());
}

TEST(GeneralFuse, CancelsWhenAsked) {
  const Operands operands{model_of(box(0, 0, 0, 1, 1, 1)), model_of(box(0.5, 0.5, 0.5, 1, 1, 1))};
  std::atomic<bool> stop = false;
  Context context;
  context.cancel = &stop;
  int reports = 0;
  context.progress = [&](double fraction, std::string_view) {
    ++reports;
    if (fraction > 0.2) stop = true;
  };
  auto result = general_fuse(*side_by_side(operands), 0, context);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, errors::cancelled);
  EXPECT_GT(reports, 1);
}

TEST(GeneralFuse, SameInputSameResult) {
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(2, 2, -1), gp_Dir(0, 0, 1)), 1, 6).Shape();
  const Fused first = fuse({box(0, 0, 0, 4, 4, 4), rod, box(1, 1, 1, 5, 5, 5)});
  const Fused second = fuse({box(0, 0, 0, 4, 4, 4), rod, box(1, 1, 1, 5, 5, 5)});
  ASSERT_EQ(first.counts, second.counts);
  for (const VertexId v : first.model.topology().vertices()) EXPECT_EQ(first.model.point(v), second.model.point(v));
  EXPECT_EQ(first.result.faces, second.result.faces);
  EXPECT_EQ(first.result.edges, second.result.edges);
}

}  // namespace
}  // namespace aresta::test
