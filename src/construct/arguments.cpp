// SPDX-License-Identifier: Apache-2.0
#include "construct/arguments.h"

#include <charconv>
#include <limits>

namespace aresta {

std::string number_text(double value) {
  if (std::isnan(value)) return "nan";
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
  return std::string(buffer, end.ptr);
}

std::string number_text(Vec3 value) {
  return "(" + number_text(value.x) + ", " + number_text(value.y) + ", " + number_text(value.z) + ")";
}

void Arguments::require(bool holds, const std::string& name, const std::string& expected, const std::string& given) {
  if (holds || !status_.ok()) return;
  status_ = Error{errors::bad_size, function_ + ": " + name + " must be " + expected + ", not " + given};
}

void Arguments::finite(const std::string& name, double value) {
  require(std::isfinite(value), name, "a finite number", number_text(value));
}

void Arguments::point(const std::string& name, Vec3 value) {
  require(is_finite(value), name, "a point with finite coordinates", number_text(value));
  const bool small =
      std::abs(value.x) <= largest_length && std::abs(value.y) <= largest_length && std::abs(value.z) <= largest_length;
  require(small, name, "a point with coordinates below 1e30", number_text(value));
}

void Arguments::points(const std::string& name, std::span<const Vec3> values) {
  for (std::size_t i = 0; i < values.size() && ok(); ++i) point(name + "[" + std::to_string(i) + "]", values[i]);
}

void Arguments::length(const std::string& name, double value) {
  finite(name, value);
  require(value > 0, name, "positive", number_text(value));
  require(value >= smallest_length && value <= largest_length, name, "between 1e-30 and 1e30", number_text(value));
}

void Arguments::length_or_zero(const std::string& name, double value) {
  finite(name, value);
  require(value >= 0, name, "zero or positive", number_text(value));
  require(value == 0 || (value >= smallest_length && value <= largest_length), name, "zero or between 1e-30 and 1e30",
          number_text(value));
}

void Arguments::direction(const std::string& name, Vec3 value) {
  point(name, value);
  require(value != Vec3{}, name, "a direction other than (0, 0, 0)", number_text(value));
  require(!ok() || norm(value) >= smallest_length, name, "longer than 1e-30", number_text(value));
}

void Arguments::count(const std::string& name, long long value, long long low, long long high) {
  require(value >= low && value <= high, name,
          "a whole number between " + std::to_string(low) + " and " + std::to_string(high), std::to_string(value));
}

void Arguments::placement(const Placement& placement) {
  point("at", placement.at);
  direction("axis", placement.axis);
}

void Arguments::patches(const Patches& patches) {
  count("patches", patches.count, 1, 100000);
  finite("seam", patches.seam);
}

void Arguments::options(const ConstructOptions& options) {
  require(std::isfinite(options.tolerance) && options.tolerance >= 0, "tolerance", "zero or positive",
          number_text(options.tolerance));
  require(std::isfinite(options.length_unit) && options.length_unit > 0, "length_unit", "positive",
          number_text(options.length_unit));
}

void Arguments::resolvable(const std::string& name, double value, double tolerance) {
  require(value > tolerance, name, "larger than the tolerance " + number_text(tolerance), number_text(value));
}

double rounding_tolerance(const Box3& box) {
  if (box.empty()) return 0;
  double largest = 0;
  for (int i = 0; i < 3; ++i) largest = std::max({largest, std::abs(box.low[i]), std::abs(box.high[i])});
  return 32 * std::numeric_limits<double>::epsilon() * largest;
}

double working_tolerance(const Box3& box, const ConstructOptions& options) {
  return std::max({options.tolerance, 1e-9 * box.diagonal(), rounding_tolerance(box)});
}

}  // namespace aresta
