// SPDX-License-Identifier: Apache-2.0
// Keeps the library's exceptions inside. Include only in sources.
#pragma once

#include <Standard_Failure.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <limits>
#include <new>
#include <string>

#include "base/result.h"
#include "geometry/free_form.h"
#include "math/vec.h"

namespace aresta::occt {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr Vec3 nowhere{nan, nan, nan};

inline Vec3 vec(const gp_Pnt& p) {
  return {p.X(), p.Y(), p.Z()};
}
inline Vec3 vec(const gp_Vec& v) {
  return {v.X(), v.Y(), v.Z()};
}
inline gp_Pnt pnt(Vec3 p) {
  return {p.x, p.y, p.z};
}

/// f(), or `otherwise` when the library throws.
template <class F, class T>
T guarded(F&& f, T otherwise) {
  try {
    return f();
  } catch (const Standard_Failure&) {
  } catch (const std::exception&) {
  }
  return otherwise;
}

/// f(), or an error that says what was attempted and what the library answered.
template <class F>
auto attempted(const char* what, F&& f) -> decltype(f()) {
  std::string reason;
  try {
    return f();
  } catch (const Standard_Failure& failure) {
    reason = failure.GetMessageString() != nullptr ? failure.GetMessageString() : "";
    if (reason.empty()) reason = failure.DynamicType()->Name();
  } catch (const std::exception& failure) {
    reason = failure.what();
  }
  return Error{errors::kernel_failed, std::string("the geometry kernel could not ") + what + ": " + reason};
}

}  // namespace aresta::occt
