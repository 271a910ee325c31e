// SPDX-License-Identifier: Apache-2.0
// Random operators with random arguments, most of them sensible, on any complex.
#pragma once

#include <optional>
#include <random>
#include <string>

#include "topology/operators.h"

namespace aresta {

class RandomOperators {
 public:
  explicit RandomOperators(std::uint64_t seed) : random_(seed) {}

  /// Tries one operator. No value: it refused, with `refusal` saying why.
  std::optional<Applied> apply(Complex& k);
  const std::optional<Error>& refusal() const { return refusal_; }
  /// What was tried last, for messages: operator and arguments.
  const std::string& tried() const { return tried_; }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }
  bool chance(int percent) { return below(100) < static_cast<std::size_t>(percent); }
  template <class IdType>
  void note(const char* kind, IdType id);

  Corner any_corner(const Complex& k, FaceId f);
  std::optional<FaceSpec> any_face(const Complex& k);
  std::vector<EdgeUseSpec> any_circuit(const Complex& k, RegionId r);
  Result<Applied> one(Complex& k);

  std::mt19937_64 random_;
  std::optional<Error> refusal_;
  std::string tried_;
};

}  // namespace aresta
