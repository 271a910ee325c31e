// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include <TopExp_Explorer.hxx>
#include <cmath>
#include <numbers>

#include "occt/errors.h"
#include "shapes.h"

namespace aresta::test {
namespace {

constexpr double pi = std::numbers::pi;

struct Case {
  std::string name;
  TopoDS_Shape shape;
  std::string counts;  // regions/faces/edges/vertices
  double volume;
};

TopoDS_Solid solid_of(std::initializer_list<TopoDS_Shell> shells) {
  TopoDS_Solid solid;
  BRep_Builder build;
  build.MakeSolid(solid);
  for (const TopoDS_Shell& shell : shells) build.Add(solid, shell);
  return solid;
}

TopoDS_Shape moved(const TopoDS_Shape& shape, double x, double y, double z) {
  gp_Trsf t;
  t.SetTranslation(gp_Vec(x, y, z));
  return shape.Moved(TopLoc_Location(t));
}

TopoDS_Shape mirrored(const TopoDS_Shape& shape) {
  gp_Trsf t;
  t.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)));
  return BRepBuilderAPI_Transform(shape, t, Standard_True).Shape();
}

std::vector<Case> cases() {
  const gp_Ax2 tilted(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 1));
  const TopoDS_Shape one = box(0, 0, 0, 2, 3, 4);
  const TopoDS_Shell cavity = TopoDS::Shell(BRepPrimAPI_MakeBox(gp_Pnt(0.5, 0.5, 0.5), 1, 1, 1).Shell().Reversed());
  const TopoDS_Shell outside = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 2, 3, 4).Shell();
  const TopoDS_Face square = polygon({{3, 0, 0}, {4, 0, 0}, {4, 0, 1}, {3, 0, 1}});
  const gp_Ax1 z_axis(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  return {
      {"box", one, "1/6/12/8", 24},
      {"wedge", BRepPrimAPI_MakeWedge(4, 2, 3, 1).Shape(), "1/6/12/8", 0.5 * (4 + 1) * 2 * 3},
      {"pointed wedge", BRepPrimAPI_MakeWedge(4, 2, 3, 0).Shape(), "1/5/9/6", 12},
      {"cylinder", BRepPrimAPI_MakeCylinder(tilted, 2, 5).Shape(), "1/3/3/2", 20 * pi},
      {"half cylinder", BRepPrimAPI_MakeCylinder(tilted, 2, 5, pi).Shape(), "1/5/9/6", 10 * pi},
      {"cone", BRepPrimAPI_MakeCone(tilted, 2, 0, 3).Shape(), "1/2/2/2", 4 * pi},
      {"cone upside down", BRepPrimAPI_MakeCone(tilted, 0, 2, 3).Shape(), "1/2/2/2", 4 * pi},
      {"truncated cone", BRepPrimAPI_MakeCone(tilted, 2, 1, 3).Shape(), "1/3/3/2", 7 * pi},
      {"sphere", BRepPrimAPI_MakeSphere(tilted, 1.5).Shape(), "1/1/1/2", 4.5 * pi},
      {"quarter of a sphere", BRepPrimAPI_MakeSphere(1.0, pi / 2).Shape(), "1/3/3/2", pi / 3},
      {"torus", BRepPrimAPI_MakeTorus(tilted, 3, 1).Shape(), "1/1/2/1", 6 * pi * pi},
      {"box with a void", solid_of({outside, cavity}), "1/12/24/16", 23},
      {"two boxes apart", compound({one, moved(one, 10, 0, 0)}), "2/12/24/16", 48},
      {"two boxes that touch without sharing", compound({one, moved(one, 2, 0, 0)}), "2/12/24/16", 48},
      {"a box in the void of another", compound({solid_of({outside, cavity}), box(0.75, 0.75, 0.75, 0.5, 0.5, 0.5)}),
       "2/18/36/24", 23.125},
      {"mirrored cylinder", mirrored(BRepPrimAPI_MakeCylinder(tilted, 2, 5).Shape()), "1/3/3/2", 20 * pi},
      {"mirrored sphere", mirrored(BRepPrimAPI_MakeSphere(tilted, 1.5).Shape()), "1/1/1/2", 4.5 * pi},
      {"tube by revolution", BRepPrimAPI_MakeRevol(square, z_axis).Shape(), "1/4/6/4", pi * (16 - 9)},
      {"cylinder as NURBS", BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeCylinder(tilted, 2, 5).Shape()).Shape(),
       "1/3/3/2", 20 * pi},
      {"sphere as NURBS", BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeSphere(tilted, 1.5).Shape()).Shape(), "1/1/1/2",
       4.5 * pi},
      {"torus as NURBS", BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(tilted, 3, 1).Shape()).Shape(), "1/1/2/1",
       6 * pi * pi},
      {"a sheet, a wire and a point beside a box",
       compound({one, moved(square, 5, 5, 5), segment({20, 0, 0}, {21, 0, 0}),
                 BRepBuilderAPI_MakeVertex(gp_Pnt(30, 0, 0)).Shape()}),
       "1/7/17/15", 24},
      {"a whole sphere without wires", BRepBuilderAPI_MakeFace(new Geom_SphericalSurface(gp_Ax3(), 2.0), 1e-7).Shape(),
       "0/1/1/2", 0},
  };
}

TEST(RoundTrip, KeepsCountsAndVolumes) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const OcctShape first = wrap(c.shape);
    auto model = to_model(first);
    ASSERT_TRUE(model.ok()) << text(model.error());
    EXPECT_EQ(counts(model->model), c.counts);
    auto back = to_shape(model->model);
    ASSERT_TRUE(back.ok()) << text(back.error());
    const OcctShape second = back->whole();
    EXPECT_EQ(counts(second), c.counts);
    EXPECT_TRUE(BRepCheck_Analyzer(second.data().shape).IsValid());
    auto volume = second.volume();
    ASSERT_TRUE(volume.ok());
    // The library integrates NURBS to about six digits.
    const bool nurbs = c.name.find("NURBS") != std::string::npos;
    EXPECT_NEAR(*volume, c.volume, (nurbs ? 1e-6 : 1e-9) * (1 + c.volume));
    EXPECT_NEAR(*volume, *first.volume(), 1e-9 * (1 + c.volume));
    auto again = to_model(second);
    ASSERT_TRUE(again.ok()) << text(again.error());
    EXPECT_EQ(counts(again->model), c.counts);
  }
}

TEST(RoundTrip, SharedFaceStaysShared) {
  BRepAlgoAPI_BuilderAlgo fuse;
  TopTools_ListOfShape arguments;
  arguments.Append(box(0, 0, 0, 1, 1, 1));
  arguments.Append(box(1, 0, 0, 1, 1, 1));
  fuse.SetArguments(arguments);
  fuse.Build();
  auto model = to_model(wrap(fuse.Shape()));
  ASSERT_TRUE(model.ok()) << text(model.error());
  EXPECT_EQ(counts(model->model), "2/11/20/12");
  int shared = 0;
  const Complex& k = model->model.topology();
  for (const FaceId f : k.faces()) {
    if (model->model.is_region(k.region(FaceUse(f, 0))) && model->model.is_region(k.region(FaceUse(f, 1)))) ++shared;
  }
  EXPECT_EQ(shared, 1);
  auto back = to_shape(model->model);
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(counts(back->whole()), "2/11/20/12");
  EXPECT_NEAR(*back->whole().volume(), 2.0, 1e-12);
}

TEST(RoundTrip, EntitiesAreFoundAgain) {
  const TopoDS_Shape shape = compound({box(0, 0, 0, 1, 1, 1), box(5, 0, 0, 2, 2, 2)});
  auto read = to_model(wrap(shape));
  ASSERT_TRUE(read.ok());
  TopExp_Explorer solids(shape, TopAbs_SOLID);
  solids.Next();
  const EntityRef second = read->entity_of(wrap(solids.Current()));
  ASSERT_EQ(second.kind, EntityKind::region);
  auto back = to_shape(read->model);
  ASSERT_TRUE(back.ok());
  EXPECT_NEAR(*back->of(second).volume(), 8.0, 1e-12);
  EXPECT_TRUE(back->of(RegionId(std::size_t{0})).null());
  const TopoDS_Shape face = TopExp_Explorer(shape, TopAbs_FACE).Current();
  EXPECT_EQ(read->entity_of(wrap(face)), EntityRef(FaceId(std::size_t{0})));
}

TEST(RoundTrip, EdgesAndPointsInsideAFace) {
  // A square with a dangling edge from a corner, a loose edge, and a point.
  TopoDS_Face face = polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  BRep_Builder build;
  TopoDS_Vertex corner;
  for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More(); it.Next()) {
    corner = TopoDS::Vertex(it.Current());
    if (BRep_Tool::Pnt(corner).Distance(gp_Pnt(4, 4, 0)) < 1e-9) break;
  }
  const TopoDS_Vertex middle = BRepBuilderAPI_MakeVertex(gp_Pnt(2, 2, 0)).Vertex();
  const TopoDS_Edge dangling = BRepBuilderAPI_MakeEdge(TopoDS::Vertex(corner.Oriented(TopAbs_FORWARD)), middle).Edge();
  const TopoDS_Edge loose = segment({1, 0.5, 0}, {2, 0.5, 0});
  for (const TopoDS_Edge& edge : {dangling, loose}) {
    TopoDS_Wire wire;
    build.MakeWire(wire);
    build.Add(wire, edge.Oriented(TopAbs_INTERNAL));
    face.Free(Standard_True);
    build.Add(face, wire);
  }
  build.Add(face, BRepBuilderAPI_MakeVertex(gp_Pnt(3, 1, 0)).Vertex().Oriented(TopAbs_INTERNAL));
  for (const bool turned : {false, true}) {
    const TopoDS_Shape shape = turned ? face.Reversed() : TopoDS_Shape(face);
    auto read = to_model(wrap(shape));
    ASSERT_TRUE(read.ok()) << text(read.error());
    const Complex& k = read->model.topology();
    EXPECT_EQ(counts(read->model), "0/1/6/8");
    std::vector<std::size_t> lengths;
    for (const LoopId l : k.loops(FaceId(std::size_t{0}))) {
      lengths.push_back(k.is_vertex_loop(l) ? 0 : k.coedges(l).count());
    }
    EXPECT_EQ(lengths, (std::vector<std::size_t>{6, 2, 0}));  // the dangling edge is part of the outer loop, twice
    auto back = to_shape(read->model);
    ASSERT_TRUE(back.ok()) << text(back.error());
    EXPECT_EQ(counts(back->whole()), "0/1/6/8");
    auto again = to_model(back->whole());
    ASSERT_TRUE(again.ok()) << text(again.error());
    EXPECT_EQ(counts(again->model), "0/1/6/8");
  }
}

TEST(ToModel, NamesWhatIsWrong) {
  EXPECT_EQ(to_model(OcctShape()).error().code, errors::to_model_failed);
  // One face of a box left out: the solid does not enclose its material.
  TopoDS_Solid open;
  TopoDS_Shell shell;
  BRep_Builder build;
  build.MakeSolid(open);
  build.MakeShell(shell);
  TopExp_Explorer it(box(0, 0, 0, 1, 1, 1), TopAbs_FACE);
  for (it.Next(); it.More(); it.Next()) build.Add(shell, it.Current());
  build.Add(open, shell);
  auto result = to_model(wrap(open));
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, errors::open_solid);
  // A box in the material of another.
  auto nested = to_model(wrap(compound({box(0, 0, 0, 4, 4, 4), box(1, 1, 1, 1, 1, 1)})));
  ASSERT_FALSE(nested.ok());
  EXPECT_EQ(nested.error().code, errors::solids_overlap);
  ASSERT_TRUE(nested.error().place.has_value());
  // A plane without end.
  auto endless = to_model(wrap(BRepBuilderAPI_MakeFace(gp_Pln()).Face()));
  ASSERT_FALSE(endless.ok());
  EXPECT_EQ(endless.error().code, errors::to_model_failed);
}

TEST(ToModel, CancelsWhenAsked) {
  const std::atomic<bool> stop = true;
  Context context;
  context.cancel = &stop;
  auto result = to_model(wrap(box(0, 0, 0, 1, 1, 1)), {}, context);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, errors::cancelled);
}

}  // namespace
}  // namespace aresta::test
