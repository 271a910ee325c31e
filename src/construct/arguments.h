// SPDX-License-Identifier: Apache-2.0
// Checking arguments: the first one that is wrong makes the error, with its name, what was expected and what was given.
#pragma once

#include <span>
#include <string>

#include "construct/options.h"
#include "math/box.h"

namespace aresta {

/// Lengths and coordinates beyond this are refused: fifth powers of them must stay finite (moments of inertia).
inline constexpr double largest_length = 1e30;
inline constexpr double smallest_length = 1e-30;

/// The shortest text that reads back as the same number.
std::string number_text(double value);
std::string number_text(Vec3 value);

class Arguments {
 public:
  explicit Arguments(std::string function) : function_(std::move(function)) {}

  void finite(const std::string& name, double value);
  void point(const std::string& name, Vec3 value);
  void points(const std::string& name, std::span<const Vec3> values);
  void length(const std::string& name, double value);          ///< positive
  void length_or_zero(const std::string& name, double value);  ///< zero or positive
  void direction(const std::string& name, Vec3 value);         ///< finite and not zero
  void count(const std::string& name, long long value, long long low, long long high);
  void placement(const Placement& placement);
  void patches(const Patches& patches);
  void options(const ConstructOptions& options);
  void require(bool holds, const std::string& name, const std::string& expected, const std::string& given);
  /// A size of a shape of this tolerance must be larger than it.
  void resolvable(const std::string& name, double value, double tolerance);

  bool ok() const { return status_.ok(); }
  const Status& status() const { return status_; }

 private:
  std::string function_;
  Status status_;
};

/// Rounding of coordinates in this box: how near two points can be and still be told apart with sound derived data.
double rounding_tolerance(const Box3& box);
/// The larger of what was asked for, 1e-9 of the diagonal and rounding.
double working_tolerance(const Box3& box, const ConstructOptions& options);

}  // namespace aresta
