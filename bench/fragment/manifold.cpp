// SPDX-License-Identifier: Apache-2.0
// manifold-3d under Node: the problem goes into a file, manifold/run.mjs reads it and takes the time itself. The folder
// where that script lies beside its node_modules is named by the environment (BENCH_MANIFOLD); see
// tests/full/planar_peers.sh.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "fragment/peers.h"

namespace aresta::bench {

namespace {

template <class T>
void put(std::ostream& out, T value) {
  static_assert(sizeof value == 4);
  out.write(reinterpret_cast<const char*>(&value), 4);
}

void put(std::ostream& out, const PolygonMesh& mesh) {
  const auto triangles = triangles_of(mesh);
  put(out, static_cast<std::uint32_t>(mesh.points.size()));
  put(out, static_cast<std::uint32_t>(triangles.size()));
  for (const Vec3 p : mesh.points) {
    for (int i = 0; i < 3; ++i) put(out, static_cast<float>(p[i]));
  }
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t v : triangle) put(out, v);
  }
}

/// What the script prints.
std::string run(const std::string& arguments) {
  const char* folder = std::getenv("BENCH_MANIFOLD");
  if (folder == nullptr) throw std::runtime_error("BENCH_MANIFOLD does not say where manifold-3d is");
  FILE* out = popen(("node '" + std::string(folder) + "/run.mjs' " + arguments).c_str(), "r");
  std::string text;
  for (int c = 0; out != nullptr && (c = std::fgetc(out)) != EOF;) text += static_cast<char>(c);
  if (out == nullptr || pclose(out) != 0) throw std::runtime_error("node failed");
  return text;
}

}  // namespace

Answer chain_with_manifold(const Chain& chain) {
  char path[] = "/tmp/bench_fragment_XXXXXX";
  const int file = mkstemp(path);
  if (file < 0) throw std::runtime_error("no file for the problem");
  close(file);
  {
    std::ofstream out(path, std::ios::binary);
    put(out, std::uint32_t{chain.is_difference});
    put(out, static_cast<std::uint32_t>(1 + chain.steps.size()));
    put(out, std::uint32_t{1});
    put(out, chain.first);
    for (const auto& step : chain.steps) {
      put(out, static_cast<std::uint32_t>(step.size()));
      for (const PolygonMesh& mesh : step) put(out, mesh);
    }
  }
  const auto remove = [&] { unlink(path); };
  std::string text;
  try {
    text = run(path);
  } catch (...) {
    remove();
    throw;
  }
  remove();
  Answer answer;
  unsigned long long solids = 0;
  if (std::sscanf(text.c_str(), "%lf %llu %lf", &answer.seconds, &solids, &answer.volume) != 3)
    throw std::runtime_error("node said: " + text);
  answer.cells = solids;
  answer.solid_volume = answer.volume;
  return answer;
}

std::string manifold_version() {
  try {
    const std::string text = run("");
    return text.substr(0, text.find('\n'));
  } catch (const std::exception&) {
    return "(not there)";
  }
}

}  // namespace aresta::bench
