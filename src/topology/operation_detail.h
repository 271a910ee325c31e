// SPDX-License-Identifier: Apache-2.0
// Inside: an operator while it runs. It makes changes one by one; unless it is finished, they are all taken back.
#pragma once

#include <string>

#include "topology/editor.h"
#include "topology/operators.h"

namespace aresta::detail {

struct Totals {
  int vertices, edges, faces, loops, shells, regions;
  explicit Totals(const Complex& k);
  CountChange operator-(const Totals& before) const;
};

class Operation {
 public:
  Operation(Complex& k, std::string name) : k_(k), before_(k) { applied_.name = std::move(name); }
  ~Operation();
  Operation(const Operation&) = delete;
  Operation& operator=(const Operation&) = delete;

  /// Makes a change and keeps it; the change with its ids filled in.
  template <class T>
  const T& make(T change) {
    applied_.steps.push_back({std::move(change), false});
    aresta::make(k_, applied_.steps.back());
    return std::get<T>(applied_.steps.back().what);
  }

  /// Kills what a change describes: the change as it would have been made, reversed.
  void kill(AnyChange change);

  /// What was made and killed, as letters in these orders, behind `prefix`.
  Applied finish(const char* prefix, const char* made, const char* killed, bool killed_first);

  Applied& applied() { return applied_; }

 private:
  Complex& k_;
  Applied applied_;
  Totals before_;
  bool finished_ = false;
};

// --- arguments

Error unknown(const char* what, std::uint32_t id);
template <class IdType>
Status want(const Complex& k, IdType id, const char* what) {
  if (k.is_live(id)) return {};
  return unknown(what, id.value);
}

std::string name_of(EntityRef entity);

/// The regions that a vertex touches, sorted.
std::vector<RegionId> regions_at(const Complex& k, VertexId v);
/// `wanted`, or the only region that all the vertices touch.
Result<RegionId> common_region(const Complex& k, std::span<const VertexId> vertices, RegionId wanted);

/// How a face is taken out again: the change that would make it, with the region that dies divided off.
FaceChange face_removal(const Complex& k, FaceId f, RegionId kept);

/// A vertex that is a loop of a face may not be in another loop of it.
Status require_no_double_corner(const Complex& k, VertexId v);

/// About each vertex of the region, its regions must be reached from each other across the faces there: a new region
/// may not cut a wire, or a part that hangs on one.
Status require_regions_meet(const Complex& k, RegionId region);

/// On a small sphere about each vertex, edges are points and corners of faces are arcs: these must not cross.
Status require_fans_fit(const Complex& k, std::vector<VertexId> vertices);

}  // namespace aresta::detail
