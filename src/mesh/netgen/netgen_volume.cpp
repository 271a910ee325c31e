// SPDX-License-Identifier: Apache-2.0
// Tetrahedra by Netgen's C++ classes: Delaunay and advancing front per region, then local improvement.
//
// Netgen keeps global state (progress, the order to stop, streams): calls are serialised by a mutex. It works in a
// thread of its own while the calling thread reports progress and passes on cancellation. What it prints is dropped:
// its own streams are set to null; std::cout is filtered for that one thread only. Its triangles point out of region
// `in`; ours point to the front, so that in = back and out = front. Its tetrahedra are left-handed in our convention.
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <iostream>
#include <meshing.hpp>
#include <mutex>
#include <streambuf>
#include <string>
#include <thread>

#include "mesh/errors.h"
#include "mesh/volume_input.h"

namespace netgen {
extern DLL_HEADER int printmessage_importance;
}

namespace aresta::mesh {

namespace {

thread_local bool quiet_thread = false;

/// Drops what the quiet thread writes and passes on what other threads write.
class FilterBuffer : public std::streambuf {
 public:
  explicit FilterBuffer(std::ostream& stream) : stream_(stream), target_(stream.rdbuf(this)) {}
  ~FilterBuffer() override { stream_.rdbuf(target_); }

 protected:
  int_type overflow(int_type c) override {
    if (quiet_thread || traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    return target_->sputc(traits_type::to_char_type(c));
  }
  std::streamsize xsputn(const char* text, std::streamsize count) override {
    return quiet_thread ? count : target_->sputn(text, count);
  }
  int sync() override { return quiet_thread ? 0 : target_->pubsync(); }

 private:
  std::ostream& stream_;
  std::streambuf* target_;
};

std::ostream& null_stream() {
  static std::ostream stream(nullptr);
  return stream;
}

struct Outcome {
  int result = 0;
  bool threw = false;
  std::string reason;
};

void load(const VolumeInput& input, netgen::Mesh& target) {
  for (const Vec3& p : input.points) target.AddPoint(netgen::Point3d(p.x, p.y, p.z), 1, netgen::FIXEDPOINT);
  // One face descriptor per pair of regions, in order of first use.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
  std::size_t last = 0;
  for (const auto& triangle : input.triangles) {
    const std::pair wanted{triangle.back, triangle.front};
    if (last >= sides.size() || sides[last] != wanted) {
      last = static_cast<std::size_t>(std::find(sides.begin(), sides.end(), wanted) - sides.begin());
    }
    if (last == sides.size()) {
      sides.push_back(wanted);
      const int number = static_cast<int>(sides.size());
      target.AddFaceDescriptor(
          netgen::FaceDescriptor(number, static_cast<int>(triangle.back), static_cast<int>(triangle.front), 0));
    }
    netgen::Element2d element(static_cast<int>(triangle.nodes[0]) + 1, static_cast<int>(triangle.nodes[1]) + 1,
                              static_cast<int>(triangle.nodes[2]) + 1);
    element.SetIndex(static_cast<int>(last) + 1);
    target.AddSurfaceElement(element);
  }
}

Outcome run(const VolumeInput& input, netgen::Mesh& target) {
  Outcome outcome;
  try {
    netgen::MeshingParameters parameters;
    double largest = 0;
    netgen::Array<double> sizes;
    for (const double size : input.region_sizes) {
      largest = std::max(largest, size);
      sizes.Append(size);
    }
    parameters.maxh = largest;
    parameters.grading = input.grading;
    parameters.optsteps3d = input.optimisation_steps;
    target.SetGlobalH(largest);
    target.SetMaxHDomain(sizes);
    target.CalcLocalH(input.grading);
    outcome.result = netgen::MeshVolume(parameters, target);
    if (outcome.result == netgen::MESHING3_OK && netgen::multithread.terminate == 0) {
      netgen::RemoveIllegalElements(target);
      outcome.result = netgen::OptimizeVolume(parameters, target);
    }
  } catch (const netgen::NgException& e) {
    outcome = {0, true, e.What()};
  } catch (const std::exception& e) {
    outcome = {0, true, e.what()};
  } catch (...) {
    outcome = {0, true, "unknown exception"};
  }
  return outcome;
}

Result<VolumeOutput> unload(const VolumeInput& input, const netgen::Mesh& target) {
  VolumeOutput output;
  const std::size_t count = target.GetNP();
  if (count < input.points.size())
    return Error{errors::mesh_volume_failed, "the volume mesher lost points of the surface mesh"};
  output.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& p = target[netgen::PointIndex(static_cast<int>(i) + netgen::PointIndex::BASE)];
    output.points.push_back({p(0), p(1), p(2)});
  }
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    if (!(output.points[i] == input.points[i])) {
      return Error{errors::mesh_volume_failed,
                   "the volume mesher moved a point of the surface mesh",
                   {},
                   {{input.points[i].x, input.points[i].y, input.points[i].z}}};
    }
  }
  output.tetras.reserve(target.GetNE());
  for (std::size_t e = 0; e < target.GetNE(); ++e) {
    const auto& element = target[netgen::ElementIndex(static_cast<int>(e))];
    if (element.IsDeleted()) continue;
    if (element.GetNP() != 4)
      return Error{errors::mesh_volume_failed, "the volume mesher made an element that is no tetrahedron"};
    Tetra tetra;
    const int order[4] = {0, 2, 1, 3};
    for (std::size_t i = 0; i < 4; ++i) {
      tetra.nodes[i] = static_cast<std::uint32_t>(int(element[order[i]]) - netgen::PointIndex::BASE);
    }
    tetra.region = static_cast<std::uint32_t>(element.GetIndex());
    output.tetras.push_back(tetra);
  }
  return output;
}

}  // namespace

Result<VolumeOutput> netgen_volumes(const VolumeInput& input, const Context& context) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  ARESTA_CHECK(context.step(0, "volume mesh"));

  netgen::printmessage_importance = 0;
  netgen::mycout = &null_stream();
  netgen::myerr = &null_stream();
  ngcore::testout = &null_stream();
  netgen::multithread.terminate = 0;
  netgen::multithread.percent = 0;

  const FilterBuffer quiet_out(std::cout);
  const FilterBuffer quiet_err(std::cerr);
  netgen::Mesh target;
  load(input, target);

  Outcome outcome;
  std::mutex mutex;
  std::condition_variable finished;
  bool done = false;
  std::thread worker([&] {
    quiet_thread = true;
    outcome = run(input, target);
    const std::lock_guard guard(mutex);
    done = true;
    finished.notify_one();
  });
  Status status;
  {
    std::unique_lock guard(mutex);
    while (!finished.wait_for(guard, std::chrono::milliseconds(20), [&] { return done; })) {
      if (!status.ok()) continue;
      const double fraction = std::clamp(0.01 * netgen::multithread.percent, 0.0, 1.0);
      guard.unlock();
      status = context.step(fraction, "volume mesh");
      guard.lock();
      if (!status.ok()) netgen::multithread.terminate = 1;
    }
  }
  worker.join();
  netgen::multithread.terminate = 0;
  if (!status.ok()) return std::move(status).error();
  ARESTA_CHECK(context.step(1, "volume mesh"));
  if (outcome.threw) return Error{errors::mesh_volume_failed, "the volume mesher stopped: " + outcome.reason};
  if (outcome.result != netgen::MESHING3_OK) {
    return Error{errors::mesh_volume_failed,
                 "the volume mesher gave up (its code " + std::to_string(outcome.result) + ")",
                 {},
                 {},
                 "a smaller element size, above all where faces come close to each other"};
  }
  return unload(input, target);
}

}  // namespace aresta::mesh

extern "C" void aresta_netgen_volumes(const aresta::mesh::VolumeInput* input, const aresta::Context* context,
                                      aresta::Result<aresta::mesh::VolumeOutput>* output) {
  *output = aresta::mesh::netgen_volumes(*input, *context);
}
