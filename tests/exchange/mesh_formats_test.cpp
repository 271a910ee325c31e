// SPDX-License-Identifier: Apache-2.0
#include "exchange/mesh_formats.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "exchange/errors.h"
#include "mesh/measures.h"
#include "mesh/shapes.h"
#include "support/paths.h"

namespace aresta {
namespace {

using namespace test;

/// Two cubes that share a face, with names and groups that trouble formats.
Mesh two_cubes(int order, int dim = 3) {
  Shapes shapes;
  shapes.box({0, 0, 0}, {1, 1, 1}, 1, 0, 1);
  shapes.polygon({{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}, 1, 1);
  shapes.box({1, 0, 0}, {2, 1, 1}, 1, 0, 0);
  shapes.builder.labels.set_name(RegionId(1), "steel <&> \"a\"");
  shapes.builder.labels.groups.push_back({"1 interface", {FaceId(5)}});
  shapes.builder.labels.groups.push_back({"1_INTERFACE", {FaceId(0), EdgeId(0), VertexId(0)}});
  shapes.builder.labels.groups.push_back({"all", {RegionId(1), RegionId(2)}});
  return made(shapes.model(), {.size = 0.6, .order = order, .dimension = dim});
}

/// One element of every type, with nodes of its own.
Mesh every_type() {
  Mesh mesh;
  for (int t = 0; t <= static_cast<int>(ElementType::hexa20); ++t) {
    const auto type = static_cast<ElementType>(t);
    ElementBlock block{type, EntityRef(static_cast<EntityKind>(dimension(type)), static_cast<std::uint32_t>(t)), {}};
    for (int i = 0; i < node_count(type); ++i) {
      block.nodes.push_back(static_cast<std::uint32_t>(mesh.nodes.size()));
      mesh.nodes.push_back({t + 0.1 * i, i / 3.0, -1e-17 * i});
    }
    mesh.blocks.push_back(block);
  }
  std::sort(mesh.blocks.begin(), mesh.blocks.end(), [](const auto& a, const auto& b) { return a.entity < b.entity; });
  return mesh;
}

void expect_same(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  for (std::size_t i = 0; i < a.nodes.size(); ++i) EXPECT_EQ(a.nodes[i], b.nodes[i]) << i;
  ASSERT_EQ(a.blocks.size(), b.blocks.size());
  for (std::size_t i = 0; i < a.blocks.size(); ++i) {
    EXPECT_EQ(a.blocks[i].type, b.blocks[i].type);
    EXPECT_EQ(a.blocks[i].entity, b.blocks[i].entity);
    EXPECT_EQ(a.blocks[i].nodes, b.blocks[i].nodes) << i;
  }
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(MshFormat, RoundTripKeepsEverything) {
  for (const MshVersion version : {MshVersion::v41, MshVersion::v22}) {
    for (const int order : {1, 2}) {
      const Mesh mesh = two_cubes(order);
      const auto text = to_msh(mesh, version);
      ASSERT_TRUE(text.ok());
      const auto again = from_msh(*text);
      ASSERT_TRUE(again.ok()) << again.error().to_line();
      expect_same(mesh, *again);
      ASSERT_EQ(again->sets.size(), mesh.sets.size());
      for (std::size_t i = 0; i < mesh.sets.size(); ++i) EXPECT_EQ(again->sets[i].entities, mesh.sets[i].entities);
      EXPECT_EQ(again->sets[1].name, "1 interface");
    }
    const auto types = from_msh(*to_msh(every_type(), version));
    ASSERT_TRUE(types.ok()) << types.error().to_line();
    expect_same(every_type(), *types);
  }
}

TEST(MshFormat, NodeOrderIsGmshs) {
  // Corners of a unit tetrahedron and its middles: Gmsh numbers the sides 01 12 20 30 23 13.
  Mesh mesh;
  mesh.nodes = {{0, 0, 0},     {1, 0, 0},   {0, 1, 0},   {0, 0, 1},     {0.5, 0, 0},
                {0.5, 0.5, 0}, {0, 0.5, 0}, {0, 0, 0.5}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
  mesh.blocks.push_back({ElementType::tetra10, RegionId(1), {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}});
  const auto text = to_msh(mesh, MshVersion::v22);
  EXPECT_NE(text->find("\n1 11 2 1 2 1 2 3 4 5 6 7 8 10 9\n"), std::string::npos);
  EXPECT_NE(text->find("3 1 \"region_1\"\n"), std::string::npos);
}

TEST(MshFormat, EntitiesKnowTheirBoundary) {
  const auto text = to_msh(two_cubes(1), MshVersion::v41);
  std::istringstream lines(text->substr(text->find("$Entities\n") + 10));
  std::size_t counts[4];
  lines >> counts[0] >> counts[1] >> counts[2] >> counts[3];
  EXPECT_EQ(counts[0], 12u);
  EXPECT_EQ(counts[1], 20u);
  EXPECT_EQ(counts[2], 11u);
  EXPECT_EQ(counts[3], 2u);
  std::string line;
  std::getline(lines, line);
  const auto bounding = [&](int dim) {
    std::getline(lines, line);
    std::istringstream words(line);
    double x;
    std::size_t n = 0;
    for (int i = 0; i < (dim == 0 ? 4 : 7); ++i) words >> x;
    words >> n;
    for (std::size_t i = 0; i < n; ++i) words >> x;
    n = 0;
    words >> n;
    return n;
  };
  for (std::size_t i = 0; i < counts[0]; ++i) EXPECT_EQ(bounding(0), 0u);
  for (std::size_t i = 0; i < counts[1]; ++i) EXPECT_EQ(bounding(1), 2u);
  for (std::size_t i = 0; i < counts[2]; ++i) EXPECT_EQ(bounding(2), 4u);
  for (std::size_t i = 0; i < counts[3]; ++i) EXPECT_EQ(bounding(3), 6u);
}

TEST(MshFormat, BrokenFilesAreRefusedWithTheLine) {
  const std::string good = *to_msh(two_cubes(1), MshVersion::v41);
  for (std::size_t cut = 0; cut + 16 < good.size(); cut += 97) {
    const auto result = from_msh(good.substr(0, cut));
    // A cut between sections leaves a whole file with fewer sections.
    if (result.ok())
      EXPECT_NE(good.rfind("$End", cut), std::string::npos);
    else
      EXPECT_EQ(result.error().code, errors::exchange_bad_mesh_file);
  }
  for (const std::string text :
       {"", "solid x", "$MeshFormat\n3 0 8\n$EndMeshFormat\n", "$MeshFormat\n4.1 1 8\n$EndMeshFormat\n",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n99999999999\n",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 nan 0 0\n$EndNodes\n",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 15 2 0 1 "
        "7\n$EndElements\n"}) {
    const auto result = from_msh(text);
    ASSERT_FALSE(result.ok()) << text;
    EXPECT_EQ(result.error().code, errors::exchange_bad_mesh_file);
  }
  EXPECT_NE(from_msh("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\nx\n").error().message.find("line 5"),
            std::string::npos);
}

/// Decodes one array of a binary VTU file.
std::string vtu_array(const std::string& text, const std::string& name) {
  const std::size_t tag = text.find("Name=\"" + name + "\"");
  if (tag == std::string::npos) throw std::runtime_error("no array " + name);
  const std::size_t offset = std::stoul(text.substr(text.find("offset=\"", tag) + 8));
  const std::size_t start = text.find('_', text.find("<AppendedData")) + 1 + offset;
  const auto decode = [&](std::size_t from, std::size_t bytes) {
    std::string out;
    std::uint32_t word = 0;
    int bits = 0;
    for (std::size_t i = from; out.size() < bytes; ++i) {
      const char c = text[i];
      const int v = c >= 'A' && c <= 'Z'   ? c - 'A'
                    : c >= 'a' && c <= 'z' ? c - 'a' + 26
                    : c >= '0' && c <= '9' ? c - '0' + 52
                    : c == '+'             ? 62
                                           : 63;
      word = word << 6 | static_cast<std::uint32_t>(v);
      bits += 6;
      if (bits >= 8) bits -= 8, out += static_cast<char>(word >> bits & 255);
    }
    return out;
  };
  std::uint64_t size = 0;
  std::memcpy(&size, decode(start, 8).data(), 8);
  return decode(start, 8 + size).substr(8);
}

TEST(VtuFormat, BinaryAndTextHoldTheSame) {
  const Mesh mesh = two_cubes(2);
  const std::string binary = *to_vtu(mesh), text = *to_vtu(mesh, {.binary = false});
  const std::string points = vtu_array(binary, "points");
  ASSERT_EQ(points.size(), mesh.nodes.size() * 24);
  EXPECT_EQ(std::memcmp(points.data(), mesh.nodes.data(), points.size()), 0);
  std::size_t cells = 0;
  for (int dim = 0; dim < 4; ++dim) cells += mesh.element_count(dim);
  const std::string types = vtu_array(binary, "types");
  ASSERT_EQ(types.size(), cells);
  EXPECT_EQ(static_cast<std::size_t>(std::count(types.begin(), types.end(), char(24))), mesh.element_count(3));
  EXPECT_EQ(static_cast<std::size_t>(std::count(types.begin(), types.end(), char(22))), mesh.element_count(2));
  const std::string regions = vtu_array(binary, "region");
  std::map<std::int32_t, std::size_t> per_region;
  for (std::size_t i = 0; i < cells; ++i) {
    std::int32_t r;
    std::memcpy(&r, regions.data() + 4 * i, 4);
    ++per_region[r];
  }
  EXPECT_EQ(per_region[1] + per_region[2], mesh.element_count(3));
  EXPECT_EQ(per_region[-1], cells - mesh.element_count(3));
  EXPECT_NE(binary.find("Name=\"group steel &lt;&amp;&gt; &quot;a&quot;\""), std::string::npos);
  EXPECT_EQ(count(text, "<DataArray"), count(binary, "<DataArray"));
  EXPECT_EQ(count(text, "format=\"ascii\""), count(text, "<DataArray"));
}

TEST(InpFormat, NamesAreSaneAndUnique) {
  const std::string text = *to_inp(two_cubes(1));
  EXPECT_NE(text.find("**   STEEL_A_ = steel <&> \"a\"\n"), std::string::npos);
  EXPECT_NE(text.find("**   SET_1_INTERFACE = 1 interface\n"), std::string::npos);
  EXPECT_NE(text.find("**   SET_1_INTERFACE_2 = 1_INTERFACE\n"), std::string::npos);
  EXPECT_NE(text.find("*ELSET, ELSET=ALL\nREGION_1\nREGION_2\n"), std::string::npos);
  EXPECT_EQ(count(text, "*ELEMENT, TYPE=C3D4, ELSET=REGION_"), 2u);
  EXPECT_EQ(count(text, "TYPE=S3"), 0u);
}

TEST(InpFormat, SurfacesNameTheSidesOfElements) {
  const Mesh mesh = two_cubes(1);
  const std::string text = *to_inp(mesh);
  std::size_t at = text.find("*SURFACE, NAME=SET_1_INTERFACE, TYPE=ELEMENT\n");
  ASSERT_NE(at, std::string::npos);
  std::istringstream lines(text.substr(text.find('\n', at) + 1));
  std::string line;
  std::size_t sides = 0;
  // Elements are numbered through the blocks of the two regions; corners of side 1 to 4 in Abaqus' order.
  const int corners[4][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  std::vector<std::uint32_t> tetras;
  for (const auto& block : mesh.blocks) {
    if (block.type == ElementType::tetra4) tetras.insert(tetras.end(), block.nodes.begin(), block.nodes.end());
  }
  while (std::getline(lines, line) && line[0] != '*') {
    const std::size_t element = std::stoul(line) - 1, side = std::stoul(line.substr(line.find('S') + 1)) - 1;
    for (const int c : corners[side]) EXPECT_EQ(mesh.nodes[tetras[4 * element + static_cast<std::size_t>(c)]].x, 1);
    ++sides;
  }
  std::size_t triangles = 0;
  for (const auto& block : mesh.blocks) triangles += block.entity == EntityRef(FaceId(5)) ? block.size() : 0;
  EXPECT_EQ(sides, triangles);
}

TEST(InpFormat, ShellsOnlyWhenAsked) {
  const Mesh mesh = two_cubes(2, 2);
  const auto refused = to_inp(mesh);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, errors::exchange_bad_mesh);
  const auto shells = to_inp(mesh, {.shells = true});
  ASSERT_TRUE(shells.ok());
  EXPECT_EQ(count(*shells, "*ELEMENT, TYPE=S6, ELSET=FACE_"), 11u);
}

TEST(InpFormat, NumbersFitIntoTwentyCharacters) {
  Mesh mesh;
  mesh.nodes = {{-1.2345678901234567e-05, 1e300 / 3, 1.0 / 3}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.blocks.push_back({ElementType::tetra4, RegionId(1), {0, 1, 2, 3}});
  const std::string text = *to_inp(mesh);
  std::istringstream line(text.substr(text.find("\n1, ") + 4));
  for (const double exact : {mesh.nodes[0].x, mesh.nodes[0].y, mesh.nodes[0].z}) {
    std::string word;
    line >> word;
    if (word.back() == ',') word.pop_back();
    EXPECT_LE(word.size(), 20u);
    EXPECT_NEAR(std::stod(word) / exact, 1, 1e-12);
  }
}

TEST(MeshFiles, BadMeshAndBadPathAreErrors) {
  Mesh mesh;
  mesh.nodes = {{0, 0, 0}};
  mesh.blocks.push_back({ElementType::line2, EdgeId(0), {0, 1}});
  EXPECT_EQ(to_msh(mesh, MshVersion::v41).error().code, errors::exchange_bad_mesh);
  EXPECT_EQ(to_vtu(mesh).error().code, errors::exchange_bad_mesh);
  EXPECT_EQ(to_inp(mesh).error().code, errors::exchange_bad_mesh);
  mesh.blocks[0].nodes = {0};
  EXPECT_FALSE(to_msh(mesh, MshVersion::v22).ok());
  const Mesh good = every_type();
  EXPECT_EQ(write_vtu(good, "/no/such/folder/x.vtu").error().code.failure, Failure::file);
  EXPECT_EQ(write_mesh(good, "x.doc").error().code, errors::exchange_bad_mesh);
  EXPECT_EQ(read_msh("/no/such/file.msh").error().code.failure, Failure::file);
}

TEST(MeshFiles, FullDiskLeavesNothing) {
  // A device that is always full stands for the disk.
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const auto status = write_msh(every_type(), "/dev/full");
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code.failure, Failure::file);
}

/// A bar of two materials in series under tension: steps of the closed form F = sigma A, u = sigma (L1 / E1 + L2 / E2).
TEST(CalculiX, TwoRegionBarUnderTension) {
  if (std::system("command -v ccx > /dev/null 2>&1") != 0) {
    ASSERT_EQ(std::getenv("CI"), nullptr) << "ccx must be there in CI (package calculix-ccx)";
    GTEST_SKIP() << "ccx is not installed (package calculix-ccx)";
  }
  for (const int order : {1, 2}) {
    Shapes shapes;
    shapes.box({0, 0, 0}, {2, 1, 1}, 1, 0, 1);
    const FaceId middle = shapes.polygon({{2, 0, 0}, {2, 1, 0}, {2, 1, 1}, {2, 0, 1}}, 1, 1);
    shapes.box({2, 0, 0}, {5, 1, 1}, 1, 0, 0);
    auto& labels = shapes.builder.labels;
    labels.set_name(RegionId(1), "soft");
    labels.set_name(RegionId(2), "stiff");
    labels.groups.push_back({"fixed x", {FaceId(0)}});
    labels.groups.push_back({"fixed y", {FaceId(1), FaceId(7)}});
    labels.groups.push_back({"fixed z", {FaceId(3), FaceId(9)}});
    labels.groups.push_back({"pulled", {FaceId(6)}});
    const Model model = shapes.model();
    const Mesh mesh = made(model, {.size = 0.4, .order = order});
    for (const std::uint32_t n : nodes_of(mesh, FaceId(6))) ASSERT_EQ(mesh.nodes[n].x, 5);
    for (const std::uint32_t n : nodes_of(mesh, middle)) ASSERT_EQ(mesh.nodes[n].x, 2);

    const auto folder = output_folder("ccx" + std::to_string(order));
    ASSERT_TRUE(write_inp(mesh, (folder / "mesh.inp").string()).ok());
    std::ofstream(folder / "bar.inp")
        << "*INCLUDE, INPUT=mesh.inp\n"
           "*MATERIAL, NAME=M1\n*ELASTIC\n1000., 0.\n*MATERIAL, NAME=M2\n*ELASTIC\n4000., 0.\n"
           "*SOLID SECTION, ELSET=SOFT, MATERIAL=M1\n*SOLID SECTION, ELSET=STIFF, MATERIAL=M2\n"
           "*BOUNDARY\nFIXED_X, 1, 1\nFIXED_Y, 2, 2\nFIXED_Z, 3, 3\n"
           "*STEP\n*STATIC\n*DSLOAD\nPULLED, P, -10.\n"
           "*NODE PRINT, NSET=PULLED\nU\n*EL PRINT, ELSET=SOFT\nS\n*EL PRINT, ELSET=STIFF\nS\n*END STEP\n";
    ASSERT_EQ(std::system(("cd '" + folder.string() + "' && OMP_NUM_THREADS=1 ccx bar > ccx.log 2>&1").c_str()), 0);
    std::ifstream results(folder / "bar.dat");
    std::string line;
    bool displacements = false;
    double stress = 0, pulled = 0;
    int stresses = 0, displaced = 0;
    while (std::getline(results, line)) {
      if (line.find("displacements") != std::string::npos) displacements = true;
      if (line.find("stresses") != std::string::npos) displacements = false;
      std::istringstream words(line);
      double node, point, value;
      if (displacements && words >> node >> value) pulled += value, ++displaced;
      if (!displacements && words >> node >> point >> value) stress += value, ++stresses;
    }
    ASSERT_GT(stresses, 100);
    ASSERT_GT(displaced, 4);
    EXPECT_NEAR(stress / stresses, 10, 0.1) << "order " << order;
    EXPECT_NEAR(pulled / displaced, 10 * (2.0 / 1000 + 3.0 / 4000), 0.01 * 0.0275) << "order " << order;
  }
}

}  // namespace
}  // namespace aresta
