// SPDX-License-Identifier: Apache-2.0
#include "geometry/nurbs_data.h"

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "geometry/occt_guard.h"
#include "geometry/occt_handles.h"

namespace aresta {

namespace {

Error invalid(const std::string& message) {
  return {errors::bad_geometry, "invalid NURBS: " + message};
}

/// Knots, multiplicities and number of poles of one direction fit together.
Status check_knots(const char* name, int degree, bool periodic, const std::vector<double>& knots,
                   const std::vector<int>& multiplicities, std::size_t poles) {
  const std::string in = name;
  constexpr int max_degree = 25;
  if (degree < 1 || degree > max_degree) {
    return invalid("the " + in + "degree is " + std::to_string(degree) + "; it must be from 1 to 25");
  }
  if (knots.size() < 2) return invalid("there are fewer than two " + in + "knots");
  if (knots.size() != multiplicities.size()) {
    return invalid("there are " + std::to_string(knots.size()) + " " + in + "knots but " +
                   std::to_string(multiplicities.size()) + " multiplicities");
  }
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!std::isfinite(knots[i])) return invalid(in + "knot " + std::to_string(i) + " is not a finite number");
    // The kernel tells knots apart by their own rounding; closer ones would divide by zero in its evaluation.
    if (i > 0 && !(knots[i] - knots[i - 1] > 4e-16 * std::max(std::abs(knots[i]), std::abs(knots[i - 1])))) {
      return invalid(in + "knot " + std::to_string(i) + " is not larger than the one before");
    }
  }
  long sum = 0;
  for (std::size_t i = 0; i < multiplicities.size(); ++i) {
    const bool end = i == 0 || i + 1 == multiplicities.size();
    const int most = end && !periodic ? degree + 1 : degree;
    if (multiplicities[i] < 1 || multiplicities[i] > most) {
      return invalid(in + "knot " + std::to_string(i) + " has multiplicity " + std::to_string(multiplicities[i]) +
                     "; it must be from 1 to " + std::to_string(most));
    }
    sum += multiplicities[i];
  }
  if (poles < 2) return invalid("there are fewer than two " + in + "poles");
  const long count = static_cast<long>(poles);
  if (periodic) {
    if (multiplicities.front() != multiplicities.back()) {
      return invalid("the first and the last " + in + "multiplicity of a periodic form differ");
    }
    if (sum - multiplicities.back() != count) {
      return invalid("a periodic form with these " + in + "multiplicities has " +
                     std::to_string(sum - multiplicities.back()) + " poles, not " + std::to_string(count));
    }
  } else if (sum != count + degree + 1) {
    return invalid("the " + in + "multiplicities sum to " + std::to_string(sum) + "; " + std::to_string(count) +
                   " poles of degree " + std::to_string(degree) + " need " + std::to_string(count + degree + 1));
  }
  return {};
}

Status check_weights(const std::vector<double>& weights, std::size_t poles) {
  if (weights.empty()) return {};
  if (weights.size() != poles) {
    return invalid("there are " + std::to_string(poles) + " poles but " + std::to_string(weights.size()) + " weights");
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!(weights[i] > 1e-100) || !(weights[i] < 1e100)) {
      return invalid("weight " + std::to_string(i) + " is not a positive finite number");
    }
  }
  return {};
}

bool usable(Vec3 p) {
  return std::abs(p.x) < 1e100 && std::abs(p.y) < 1e100 && std::abs(p.z) < 1e100;
}
bool usable(Vec2 p) {
  return std::abs(p.x) < 1e100 && std::abs(p.y) < 1e100;
}

template <class V>
Status check_poles(const std::vector<V>& poles) {
  for (std::size_t i = 0; i < poles.size(); ++i) {
    if (!usable(poles[i])) return invalid("pole " + std::to_string(i) + " is not finite");
  }
  return {};
}

TColStd_Array1OfReal reals(const std::vector<double>& v) {
  TColStd_Array1OfReal a(1, static_cast<int>(v.size()));
  for (int i = 1; i <= a.Length(); ++i) a(i) = v[static_cast<std::size_t>(i - 1)];
  return a;
}

TColStd_Array1OfInteger integers(const std::vector<int>& v) {
  TColStd_Array1OfInteger a(1, static_cast<int>(v.size()));
  for (int i = 1; i <= a.Length(); ++i) a(i) = v[static_cast<std::size_t>(i - 1)];
  return a;
}

}  // namespace

Result<FreeCurve> FreeCurve::from_nurbs(const NurbsCurveData& data) {
  ARESTA_CHECK(check_knots("", data.degree, data.periodic, data.knots, data.multiplicities, data.poles.size()));
  ARESTA_CHECK(check_weights(data.weights, data.poles.size()));
  ARESTA_CHECK(check_poles(data.poles));
  return occt::attempted("build a NURBS curve", [&]() -> Result<FreeCurve> {
    TColgp_Array1OfPnt poles(1, static_cast<int>(data.poles.size()));
    for (int i = 1; i <= poles.Length(); ++i) poles(i) = occt::pnt(data.poles[static_cast<std::size_t>(i - 1)]);
    Handle(Geom_BSplineCurve) curve;
    if (data.weights.empty()) {
      curve =
          new Geom_BSplineCurve(poles, reals(data.knots), integers(data.multiplicities), data.degree, data.periodic);
    } else {
      curve = new Geom_BSplineCurve(poles, reals(data.weights), reals(data.knots), integers(data.multiplicities),
                                    data.degree, data.periodic, false);
    }
    return FreeCurve(std::make_shared<const OcctCurve>(OcctCurve{curve}));
  });
}

Result<FreeCurve2> FreeCurve2::from_nurbs(const NurbsCurve2Data& data) {
  ARESTA_CHECK(check_knots("", data.degree, data.periodic, data.knots, data.multiplicities, data.poles.size()));
  ARESTA_CHECK(check_weights(data.weights, data.poles.size()));
  ARESTA_CHECK(check_poles(data.poles));
  return occt::attempted("build a NURBS curve", [&]() -> Result<FreeCurve2> {
    TColgp_Array1OfPnt2d poles(1, static_cast<int>(data.poles.size()));
    for (int i = 1; i <= poles.Length(); ++i) {
      const Vec2 p = data.poles[static_cast<std::size_t>(i - 1)];
      poles(i) = gp_Pnt2d(p.x, p.y);
    }
    Handle(Geom2d_BSplineCurve) curve;
    if (data.weights.empty()) {
      curve =
          new Geom2d_BSplineCurve(poles, reals(data.knots), integers(data.multiplicities), data.degree, data.periodic);
    } else {
      curve = new Geom2d_BSplineCurve(poles, reals(data.weights), reals(data.knots), integers(data.multiplicities),
                                      data.degree, data.periodic);
    }
    return FreeCurve2(std::make_shared<const OcctCurve2>(OcctCurve2{curve}));
  });
}

Result<FreeSurface> FreeSurface::from_nurbs(const NurbsSurfaceData& data) {
  if (data.count_u > 1000000 || data.count_v > 1000000 || data.poles.size() != data.count_u * data.count_v) {
    return invalid("there are " + std::to_string(data.poles.size()) + " poles, not " + std::to_string(data.count_u) +
                   " x " + std::to_string(data.count_v));
  }
  ARESTA_CHECK(check_knots("u ", data.degree_u, data.periodic_u, data.knots_u, data.multiplicities_u, data.count_u));
  ARESTA_CHECK(check_knots("v ", data.degree_v, data.periodic_v, data.knots_v, data.multiplicities_v, data.count_v));
  ARESTA_CHECK(check_weights(data.weights, data.poles.size()));
  ARESTA_CHECK(check_poles(data.poles));
  return occt::attempted("build a NURBS surface", [&]() -> Result<FreeSurface> {
    const int nu = static_cast<int>(data.count_u), nv = static_cast<int>(data.count_v);
    TColgp_Array2OfPnt poles(1, nu, 1, nv);
    TColStd_Array2OfReal weights(1, nu, 1, nv);
    weights.Init(1);
    for (int i = 1; i <= nu; ++i) {
      for (int j = 1; j <= nv; ++j) {
        const std::size_t k = static_cast<std::size_t>(i - 1) * data.count_v + static_cast<std::size_t>(j - 1);
        poles(i, j) = occt::pnt(data.poles[k]);
        if (!data.weights.empty()) weights(i, j) = data.weights[k];
      }
    }
    const Handle(Geom_BSplineSurface) surface = new Geom_BSplineSurface(
        poles, weights, reals(data.knots_u), reals(data.knots_v), integers(data.multiplicities_u),
        integers(data.multiplicities_v), data.degree_u, data.degree_v, data.periodic_u, data.periodic_v);
    return FreeSurface(std::make_shared<const OcctSurface>(OcctSurface{Handle(Geom_Surface)(surface)}));
  });
}

NurbsCurveData data_of(const Handle(Geom_BSplineCurve) & curve) {
  NurbsCurveData d;
  d.degree = curve->Degree();
  d.periodic = curve->IsPeriodic();
  for (int i = 1; i <= curve->NbKnots(); ++i) {
    d.knots.push_back(curve->Knot(i));
    d.multiplicities.push_back(curve->Multiplicity(i));
  }
  for (int i = 1; i <= curve->NbPoles(); ++i) {
    d.poles.push_back(occt::vec(curve->Pole(i)));
    if (curve->IsRational()) d.weights.push_back(curve->Weight(i));
  }
  return d;
}

NurbsSurfaceData data_of(const Handle(Geom_BSplineSurface) & s) {
  NurbsSurfaceData d;
  d.degree_u = s->UDegree();
  d.degree_v = s->VDegree();
  d.periodic_u = s->IsUPeriodic();
  d.periodic_v = s->IsVPeriodic();
  for (int i = 1; i <= s->NbUKnots(); ++i) {
    d.knots_u.push_back(s->UKnot(i));
    d.multiplicities_u.push_back(s->UMultiplicity(i));
  }
  for (int i = 1; i <= s->NbVKnots(); ++i) {
    d.knots_v.push_back(s->VKnot(i));
    d.multiplicities_v.push_back(s->VMultiplicity(i));
  }
  d.count_u = static_cast<std::size_t>(s->NbUPoles());
  d.count_v = static_cast<std::size_t>(s->NbVPoles());
  const bool rational = s->IsURational() || s->IsVRational();
  for (int i = 1; i <= s->NbUPoles(); ++i) {
    for (int j = 1; j <= s->NbVPoles(); ++j) {
      d.poles.push_back(occt::vec(s->Pole(i, j)));
      if (rational) d.weights.push_back(s->Weight(i, j));
    }
  }
  return d;
}

}  // namespace aresta
