// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace aresta {

/// The library's name of a unit of length; null for one it does not know.
inline const char* unit_name(double metres) {
  struct Unit {
    double metres;
    const char* name;
  };
  static constexpr Unit units[] = {{1e-3, "MM"},     {1, "M"},       {1e-2, "CM"},     {1e3, "KM"},     {1e-6, "UM"},
                                   {0.0254, "INCH"}, {0.3048, "FT"}, {1609.344, "MI"}, {2.54e-5, "MIL"}};
  for (const Unit& unit : units) {
    if (std::abs(metres - unit.metres) <= 1e-9 * unit.metres) return unit.name;
  }
  return nullptr;
}

}  // namespace aresta
