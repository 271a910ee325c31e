// SPDX-License-Identifier: Apache-2.0
// What GMP, whose numbers have no widths, says of the numbers that the exact arithmetic of math/ is tested with.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "math/wide_int.h"

namespace aresta::oracle {

template <int bits>
mpz_class to_gmp(const WideInt<bits>& value) {
  const auto magnitude = value.magnitude();
  mpz_class result;
  mpz_import(result.get_mpz_t(), magnitude.size(), -1, sizeof(std::uint64_t), 0, 0, magnitude.data());
  return value.negative() ? mpz_class(-result) : result;
}

inline mpz_class to_gmp(Int128 value) {
  return to_gmp(WideInt<128>(value));
}

/// The nearest double, of two the even one; by comparing distances, not by looking at bits of quotients.
inline double nearest_double(const mpq_class& value) {
  const double below = value.get_d();  // GMP rounds towards zero
  const double infinity = std::numeric_limits<double>::infinity();
  const double above = std::nextafter(below, value < 0 ? -infinity : infinity);
  const mpq_class to_below = abs(value - mpq_class(below)), to_above = abs(mpq_class(above) - value);
  if (to_below != to_above) return to_below < to_above ? below : above;
  return std::bit_cast<std::uint64_t>(below) % 2 == 0 ? below : above;
}

/// A source of integers that takes the same values with every standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  std::uint64_t word() { return engine_(); }
  /// From low to high, both included.
  std::int64_t between(std::int64_t low, std::int64_t high) {
    const std::uint64_t count = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + (count == 0 ? word() : word() % count));
  }
  /// Of random length, so that all sizes occur, often with long runs of zeros and ones, where carries run.
  template <int bits>
  WideInt<bits> integer() {
    const int length = static_cast<int>(between(0, bits));
    typename WideInt<bits>::Words words;
    for (int i = 0; i < bits / 64; ++i) {
      const std::uint64_t kind = word() % 4;
      const std::uint64_t any = kind == 0 ? 0 : kind == 1 ? ~std::uint64_t{0} : kind == 2 ? word() : word() % 3 << 62;
      const int used = std::clamp(length - 64 * i, 0, 64);
      words[static_cast<std::size_t>(i)] = used == 0 ? 0 : any & ~std::uint64_t{0} >> (64 - used);
    }
    const auto value = WideInt<bits>::from_words(words);
    return word() % 2 == 0 ? value : -value;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace aresta::oracle
