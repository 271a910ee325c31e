// SPDX-License-Identifier: Apache-2.0
// Triangle files: real ones, and a large one made here.
#include <chrono>
#include <cstdio>
#include <cstring>
#include <numbers>

#include "files.h"

namespace aresta::test {
namespace {

struct MeshFile {
  const char* name;
  std::size_t vertices, faces, edges;  ///< edges by Euler's formula or the count of open sides
  bool closed;
};

class RealMesh : public ::testing::TestWithParam<MeshFile> {};

TEST_P(RealMesh, IsReadAsItIs) {
  const MeshFile& file = GetParam();
  const auto path = data_file(std::string("mesh/") + file.name);
  if (!path) GTEST_SKIP() << "the test data are not here (ARESTA_DATA)";
  ImportReport report;
  ImportOptions options;
  options.report = &report;
  auto model = import_file(path->string(), options);
  ASSERT_TRUE(model.ok()) << model.error().to_line();
  EXPECT_EQ(model->topology().vertex_count(), file.vertices);
  EXPECT_EQ(model->topology().face_count(), file.faces);
  EXPECT_EQ(model->topology().edge_count(), file.edges);
  EXPECT_EQ(!model->regions().empty(), file.closed) << notes(report);
  std::printf("%-20s %s volume %.9g %s\n", file.name, counts(*model).c_str(), volume(*model), notes(report).c_str());
}

// Two sides per edge where closed: edges = 3 faces / 2; an open side adds half an edge.
INSTANTIATE_TEST_SUITE_P(
    All, RealMesh,
    ::testing::Values(MeshFile{"1514499.stl", 13350, 26700, 40050, true}, MeshFile{"65004.stl", 731, 1466, 2199, true},
                      MeshFile{"Cray_left.obj", 292, 576, 864, true}, MeshFile{"Cray_right.obj", 8, 12, 18, true},
                      MeshFile{"ballA.off", 1900, 3796, 5694, true},
                      MeshFile{"featuretype.STL", 2010, 3476, (3 * 3476 + 576) / 2, false},
                      MeshFile{"hull-body.obj", 2736, 5460, 8190, true}, MeshFile{"torus.STL", 4350, 8700, 13050, true},
                      MeshFile{"soup.stl", 300, 100, 300, false}),
    [](const auto& given) {
      std::string name = given.param.name;
      for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
      return name;
    });

TEST(LargeMesh, TorusOfManyTriangles) {
  // At full size (ARESTA_SCALE=1) a million triangles.
  const auto n = static_cast<int>(std::lround(1000 * std::sqrt(scale())));
  const int m = n / 2;
  std::string data(84, '\0');
  const auto append = [&](float x) {
    char bytes[4];
    std::memcpy(bytes, &x, 4);
    data.append(bytes, 4);
  };
  const auto at = [&](int i, int j) {
    const double u = 2 * std::numbers::pi * (i % n) / n, v = 2 * std::numbers::pi * (j % m) / m;
    return Vec3{(3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u), std::sin(v)};
  };
  std::uint32_t count = 0;
  const auto triangle = [&](Vec3 a, Vec3 b, Vec3 c) {
    for (const Vec3 p : {Vec3{}, a, b, c}) {
      for (int k = 0; k < 3; ++k) append(static_cast<float>(p[k]));
    }
    data.append(2, '\0');
    ++count;
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  std::memcpy(data.data() + 80, &count, 4);
  const std::string path = file_with("large.stl", data);
  ImportOptions options;
  options.check = false;
  const auto start = std::chrono::steady_clock::now();
  auto model = import_file(path, options);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ASSERT_TRUE(model.ok()) << model.error().to_line();
  EXPECT_EQ(model->topology().face_count(), count);
  EXPECT_EQ(model->topology().vertex_count(), count / 2);
  EXPECT_EQ(model->regions().size(), 1u);
  const double whole = 2 * std::numbers::pi * std::numbers::pi * 3;
  EXPECT_NEAR(volume(*model), whole, 40.0 / count * whole);
  std::printf("%u triangles read in %.2f s\n", count, seconds);
}

}  // namespace
}  // namespace aresta::test
