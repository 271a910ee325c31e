// SPDX-License-Identifier: Apache-2.0
// A radial edge complex as scripts hold it: topology without coordinates, changed in place by operators, each of which
// can be undone and redone.
#pragma once

#include <memory>

#include "document/registry.h"
#include "topology/operators.h"

namespace aresta::document {

class ComplexShape final : public Shape {
 public:
  struct State {
    Complex complex;
    std::vector<Applied> done, undone;
  };

  explicit ComplexShape(Complex complex) : state_(std::make_shared<State>()) { state_->complex = std::move(complex); }

  std::string describe() const override;
  bool same_as(const Shape& other) const override { return this == &other; }
  const Complex& complex() const { return state_->complex; }
  /// What operators change. The shape is a handle: all who hold it see the change.
  State& state() const { return *state_; }

 private:
  std::shared_ptr<State> state_;
};

/// The argument as a complex, or an error that says what it is.
Result<const ComplexShape*> complex_shape(const Call& call, std::string_view parameter);

}  // namespace aresta::document
