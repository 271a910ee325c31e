// SPDX-License-Identifier: Apache-2.0
// The complex against the meshes of other libraries: time to build a sphere of 1,003,520 triangles from the indices,
// storage per edge, and the price of a snapshot and of a change after it.
//
//   bench_topology [REPETITIONS]     default 15
//
// The rounds of the libraries are interleaved, so that whatever else the machine does meets all alike; times are
// processor time, medians are compared, once with memory fresh from the system, each build in a process of its own, and
// once with memory that the process has used before; the bounds hold for both. In the time of Aresta is everything from
// the indices on: a copy of the points, finding edges, the radial order, checking it all, shells and two regions. The
// end is a line for each figure that has a bound; the exit status is 1 when one is passed.
#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>

#include "topology/operators.h"
#include "topology/peers.h"
#include "topology/polygon_mesh.h"

namespace {

using namespace aresta;

struct ArestaMesh : bench::Built {
  Pages<std::array<double, 3>> points;
  Complex complex;
  std::size_t edge_count() const override { return complex.edge_count(); }
};

template <class T>
T value_or_exit(Result<T> result) {
  if (result.ok()) return std::move(*result);
  std::fprintf(stderr, "bench_topology: %s\n", result.error().to_line().c_str());
  std::exit(2);
}

std::unique_ptr<bench::Built> build_with_aresta(const test::TriangleMesh& mesh) {
  auto built = std::make_unique<ArestaMesh>();
  built->points.generate(mesh.points.size(), [&](std::size_t v) { return mesh.points[v]; });
  Incidence in = value_or_exit(incidence_of_triangles(static_cast<std::uint32_t>(mesh.points.size()), mesh.triangles));
  enclose_one_region(in);
  built->complex = value_or_exit(assemble(in));
  return built;
}

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

struct Library {
  std::string name;
  std::function<std::unique_ptr<bench::Built>(const test::TriangleMesh&)> build;
  std::vector<double> seconds{};
};

double seconds_to_build(const Library& library, const test::TriangleMesh& mesh) {
  const double before = processor_seconds();
  const auto built = library.build(mesh);
  const double seconds = processor_seconds() - before;
  const std::size_t edges = 3 * mesh.triangles.size() / 2;
  if (built->edge_count() != edges) {
    std::fprintf(stderr, "bench_topology: %s made %zu edges of %zu\n", library.name.c_str(), built->edge_count(),
                 edges);
    std::exit(2);
  }
  return seconds;
}

/// In a process that has built nothing before.
double seconds_to_build_fresh(const Library& library, const test::TriangleMesh& mesh) {
  int ends[2];
  const pid_t child = pipe(ends) == 0 ? fork() : -1;
  double seconds = 0;
  if (child == 0) {
    seconds = seconds_to_build(library, mesh);
    _exit(write(ends[1], &seconds, sizeof seconds) == sizeof seconds ? 0 : 2);
  }
  int status = 0;
  if (child < 0 || read(ends[0], &seconds, sizeof seconds) != sizeof seconds || waitpid(child, &status, 0) != child ||
      status != 0) {
    std::fprintf(stderr, "bench_topology: no figure from the process of %s\n", library.name.c_str());
    std::exit(2);
  }
  close(ends[0]);
  close(ends[1]);
  return seconds;
}

/// Fills in the seconds of each library and prints them.
void compare(std::vector<Library>& libraries, const test::TriangleMesh& mesh, int repetitions,
             double (*seconds_of)(const Library&, const test::TriangleMesh&)) {
  for (Library& library : libraries) library.seconds.clear();
  for (int round = 0; round < repetitions; ++round) {
    for (Library& library : libraries) library.seconds.push_back(seconds_of(library, mesh));
  }
  const double own = median(libraries.front().seconds);
  for (const Library& library : libraries) {
    const auto [least, most] = std::minmax_element(library.seconds.begin(), library.seconds.end());
    const double middle = median(library.seconds);
    std::printf("%-28s median %.3f s, %.3f to %.3f s; Aresta takes %.2f of it\n", library.name.c_str(), middle, *least,
                *most, own / middle);
  }
}

bool all_within = true;

void bound(const char* what, double value, double limit) {
  const bool within = value <= limit;
  all_within = all_within && within;
  std::printf("%-7s %-44s %12.4g   at most %g\n", within ? "ok" : "BEYOND", what, value, limit);
}

void bound_ratios(const char* memory, const std::vector<Library>& libraries) {
  const double own = median(libraries[0].seconds);
  bound((std::string("build, ratio to CGAL, memory ") + memory).c_str(), own / median(libraries[1].seconds), 1.5);
  bound((std::string("build, ratio to OpenMesh, memory ") + memory).c_str(), own / median(libraries[2].seconds), 2);
}

double bytes_per_edge(const Complex& k) {
  return static_cast<double>(k.allocated_bytes()) / static_cast<double>(k.edge_count());
}

}  // namespace

int main(int count, char** arguments) {
  const int repetitions = count > 1 ? std::max(1, std::atoi(arguments[1])) : 15;
  const auto mesh = test::sphere_of_triangles(224);
  std::printf("%zu triangles, %zu vertices; %d repetitions\n", mesh.triangles.size(), mesh.points.size(), repetitions);

  std::vector<Library> libraries{{"Aresta " ARESTA_VERSION, build_with_aresta},
                                 {"CGAL " + bench::cgal_version() + " Surface_mesh", bench::build_with_cgal},
                                 {"OpenMesh " + bench::openmesh_version() + " TriMesh", bench::build_with_openmesh}};
  std::puts("memory fresh from the system:");
  std::fflush(stdout);
  compare(libraries, mesh, repetitions, seconds_to_build_fresh);
  bound_ratios("fresh", libraries);
  // From here on the process keeps what it frees.
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, INT_MAX);
  for (const Library& library : libraries) library.build(mesh);
  std::puts("memory used before:");
  compare(libraries, mesh, repetitions, seconds_to_build);

  const auto built = build_with_aresta(mesh);
  Complex& k = static_cast<ArestaMesh&>(*built).complex;
  std::vector<double> copy_seconds, change_seconds;
  double copied = 0;
  for (int i = 0; i < 101; ++i) {
    const double before = processor_seconds();
    const Complex snapshot = k;
    copy_seconds.push_back(processor_seconds() - before);
    // One triangle gets a strut into its inside.
    const FaceId face(k.face_count() / 2);
    const double start = processor_seconds();
    auto applied = mm_ev(k, Corner{k.first_coedge(k.first_loop(face)), LoopId()});
    change_seconds.push_back(processor_seconds() - start);
    copied = static_cast<double>(k.bytes_not_shared_with(snapshot));
    if (!applied.ok()) return 2;
    take_back(k, *applied);
  }
  const Complex cubes = value_or_exit(assemble(test::grid_of_cubes(20)));

  std::printf("first change after a snapshot: %.4g ms\n", 1e3 * median(change_seconds));
  bound_ratios("used before", libraries);
  bound("bytes per edge, sphere", bytes_per_edge(k), 110);
  bound("bytes per edge, 20^3 cubes", bytes_per_edge(cubes), 170);
  bound("snapshot, ms", 1e3 * median(copy_seconds), 1);
  bound("bytes copied by the first change", copied, 512 * 1024);
  return all_within ? 0 : 1;
}
