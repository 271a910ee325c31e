// SPDX-License-Identifier: Apache-2.0
// Just enough of the script language to read the constructors in the boolean test data, with volumes in closed form.
#pragma once

#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "construct/move.h"
#include "construct/primitives.h"
#include "construct/profiles.h"
#include "construct/sweep.h"

namespace aresta {

struct Built {
  Result<Model> model;
  double measure = 0;  ///< expected volume, or area of a polygon
};

class ScriptCalls {
 public:
  explicit ScriptCalls(std::string text) : text_(std::move(text)) {}

  Built call() {
    const std::string name = word();
    expect('(');
    Built built = name == "transform" ? transformed() : name == "extrude" ? extruded() : primitive(name);
    expect(')');
    return built;
  }

 private:
  Built primitive(const std::string& name) {
    constexpr double pi = std::numbers::pi;
    if (name == "polygon") {
      std::vector<Vec3> points;
      expect('[');
      do points.push_back(vector());
      while (accept(','));
      expect(']');
      Vec3 twice{};
      for (std::size_t i = 0; i < points.size(); ++i) twice += cross(points[i], points[(i + 1) % points.size()]);
      return {polygon(points), 0.5 * norm(twice)};
    }
    const std::vector<double> n = numbers();
    if (name == "block") return {block(n.at(0), n.at(1), n.at(2)), n[0] * n[1] * n[2]};
    if (name == "cylinder") return {cylinder(n.at(0), n.at(1)), pi * n[0] * n[0] * n[1]};
    if (name == "cone")
      return {cone(n.at(0), n.at(1), n.at(2)), pi * n[2] / 3 * (n[0] * n[0] + n[0] * n[1] + n[1] * n[1])};
    if (name == "sphere") return {sphere(n.at(0)), 4 * pi / 3 * n[0] * n[0] * n[0]};
    if (name == "torus") return {torus(n.at(0), n.at(1)), 2 * pi * pi * n[0] * n[1] * n[1]};
    throw std::runtime_error("unknown function " + name);
  }

  Built transformed() {
    const Built inner = call();
    expect(',');
    expect('[');
    const std::vector<double> n = numbers();
    expect(']');
    std::array<double, 12> m{};
    std::copy_n(n.begin(), 12, m.begin());
    const Transform map = Transform::from_rows(m);
    if (!inner.model.ok()) return inner;
    return {transform(*inner.model, map), inner.measure * std::abs(map.determinant())};
  }

  Built extruded() {
    const Built inner = call();
    expect(',');
    const Vec3 v = vector();
    if (!inner.model.ok()) return inner;
    const Vec3 n = inner.model->normal(FaceId(0), {0, 0});
    return {extrude(std::make_shared<const Model>(*inner.model), v), inner.measure * std::abs(dot(n, v))};
  }

  Vec3 vector() {
    expect('(');
    const std::vector<double> n = numbers();
    expect(')');
    return {n.at(0), n.at(1), n.at(2)};
  }
  std::vector<double> numbers() {
    std::vector<double> n;
    do {
      skip();
      char* end = nullptr;
      n.push_back(std::strtod(text_.c_str() + at_, &end));
      at_ = static_cast<std::size_t>(end - text_.c_str());
    } while (accept(','));
    return n;
  }
  std::string word() {
    skip();
    std::string w;
    while (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_') w += text_[at_++];
    return w;
  }
  bool accept(char c) {
    skip();
    if (text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!accept(c)) throw std::runtime_error("expected " + std::string(1, c) + " in " + text_);
  }
  void skip() {
    while (text_[at_] == ' ') ++at_;
  }

  std::string text_;
  std::size_t at_ = 0;
};

}  // namespace aresta
