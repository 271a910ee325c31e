// SPDX-License-Identifier: Apache-2.0
// Integers of a fixed width, a multiple of 64 bits to 768, in two's complement, and their quotients as doubles.
//
// Guarantees: sums, differences and products of one width are exact modulo 2^bits, so exact when the value fits;
// multiply() returns a width that always fits. Conversion to double, of an integer or of a quotient of two, is
// correctly rounded (to nearest, ties to even) in the default rounding mode. Nothing allocates. Not guaranteed:
// overflow is not noticed. Whoever chooses a width proves that it suffices (math/exact_points.h does). Cost:
// proportional to the words, for products to the product of the words; a quotient takes one division of 128 by 64 bits
// and a pass over the words.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <compare>
#include <concepts>
#include <cstdint>

namespace aresta {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 Uint128;

/// The signed integers of the language, and Int128, which the standard library does not always count among them.
template <class T>
concept BuiltinSigned = std::signed_integral<T> || std::same_as<T, Int128>;

namespace wide {

/// Words of a non-negative integer, lowest first.
template <int count>
using Words = std::array<std::uint64_t, static_cast<std::size_t>(count)>;

/// How many bits the number takes: 0 for 0, 1 for 1, 2 for 2 and 3.
template <std::size_t count>
constexpr int bit_length(const std::array<std::uint64_t, count>& words) {
  for (std::size_t i = count; i-- > 0;) {
    if (words[i] != 0) return static_cast<int>(i) * 64 + std::bit_width(words[i]);
  }
  return 0;
}

/// The number times 2^shift, rounded towards zero; `lost` becomes true when that dropped a bit which was set. The
/// result has `to` words and must fit.
template <int to, std::size_t from>
constexpr Words<to> shifted(const std::array<std::uint64_t, from>& words, int shift, bool& lost) {
  // Word i of the result starts at bit 64 i - shift of the source, which is bit `offset` of word i + first.
  const int first = shift > 0 ? -((shift + 63) / 64) : -shift / 64;
  const int offset = -shift - 64 * first;
  const auto word = [&](int i) {
    return i < 0 || i >= static_cast<int>(from) ? 0 : words[static_cast<std::size_t>(i)];
  };
  Words<to> result{};
  for (int i = 0; i < to; ++i) {
    const std::uint64_t low = word(i + first) >> offset;
    const std::uint64_t high = offset == 0 ? 0 : word(i + first + 1) << (64 - offset);
    result[static_cast<std::size_t>(i)] = low | high;
  }
  for (int i = 0; i < first; ++i) lost |= word(i) != 0;
  if (first >= 0 && offset != 0) lost |= word(first) << (64 - offset) != 0;
  return result;
}

/// 2^exponent, for exponents of normal doubles.
constexpr double power_of_two(int exponent) {
  assert(exponent >= -1022 && exponent <= 1023);
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
}

/// (leading + rest) * 2^exponent as a double, where 0 <= rest < 1, and `has_rest` says whether it is above zero.
/// `leading` has 63 bits at least, unless the rest is zero: then a bit set below those that a double keeps tells the
/// rounding all there is to know of the rest.
constexpr double rounded(std::uint64_t leading, bool has_rest, int exponent) {
  return static_cast<double>(leading | static_cast<std::uint64_t>(has_rest)) * power_of_two(exponent);
}

/// The one digit, in base 2^64, of a / b; `a` becomes the remainder. The top bit of b is set, that of a is not.
template <std::size_t count>
constexpr std::uint64_t divide_one_digit(std::array<std::uint64_t, count + 1>& a,
                                         const std::array<std::uint64_t, count>& b) {
  assert(b[count - 1] >> 63 == 1 && a[count] >> 63 == 0);
  const Uint128 top = static_cast<Uint128>(a[count]) << 64 | a[count - 1];
  auto digit = static_cast<std::uint64_t>(top / b[count - 1]);
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Uint128 product = static_cast<Uint128>(digit) * b[i] + carry;
    const auto low = static_cast<std::uint64_t>(product);
    carry = static_cast<std::uint64_t>(product >> 64) + (a[i] < low ? 1 : 0);
    a[i] -= low;
  }
  a[count] -= carry;
  // The guess from the top words is never too small, and too large by two at most since the top bit of b is set
  // (Knuth, The Art of Computer Programming 2, 4.3.1, theorem B).
  while (a[count] >> 63 == 1) {
    --digit;
    std::uint64_t above = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Uint128 sum = static_cast<Uint128>(a[i]) + b[i] + above;
      a[i] = static_cast<std::uint64_t>(sum);
      above = static_cast<std::uint64_t>(sum >> 64);
    }
    a[count] += above;
  }
  return digit;
}

}  // namespace wide

template <int bits>
class WideInt {
  static_assert(bits > 0 && bits % 64 == 0 && bits <= 768, "beyond 768 bits a quotient may leave the range of doubles");

 public:
  static constexpr int word_count = bits / 64;
  using Words = wide::Words<word_count>;

  constexpr WideInt() = default;
  template <BuiltinSigned T>
  requires(sizeof(T) * 8 <= bits) constexpr WideInt(T value) {
    const Int128 extended = value;
    words_.fill(value < 0 ? ~std::uint64_t{0} : 0);
    words_[0] = static_cast<std::uint64_t>(extended);
    if constexpr (word_count > 1) words_[1] = static_cast<std::uint64_t>(extended >> 64);
  }
  /// A narrower one is taken as it is, a wider one on request: its low bits, which are the value if that fits.
  template <int other>
  explicit(other > bits) constexpr WideInt(const WideInt<other>& value) {
    constexpr int kept = std::min(word_count, WideInt<other>::word_count);
    words_.fill(value.negative() ? ~std::uint64_t{0} : 0);
    for (std::size_t i = 0; i < kept; ++i) words_[i] = value.words()[i];
  }

  /// From the two's complement, lowest word first.
  static constexpr WideInt from_words(const Words& words) {
    WideInt result;
    result.words_ = words;
    return result;
  }

  /// The two's complement, lowest word first.
  constexpr const Words& words() const { return words_; }
  constexpr bool negative() const { return words_.back() >> 63 != 0; }
  /// -1, 0 or 1.
  constexpr int sign() const {
    if (negative()) return -1;
    std::uint64_t any = 0;
    for (const std::uint64_t word : words_) any |= word;
    return any != 0 ? 1 : 0;
  }
  /// The absolute value; that of -2^(bits - 1) fits too, since no sign is kept.
  constexpr Words magnitude() const { return negative() ? (-*this).words_ : words_; }
  /// How many bits the absolute value takes; 0 for 0.
  constexpr int bit_length() const { return wide::bit_length(magnitude()); }

  /// The nearest double; of two, the even one.
  constexpr double to_double() const {
    const Words size = magnitude();
    const int length = wide::bit_length(size);
    if (length == 0) return 0;
    bool lost = false;
    const std::uint64_t leading = wide::shifted<1>(size, 64 - length, lost)[0];
    const double value = wide::rounded(leading, lost, length - 64);
    return negative() ? -value : value;
  }

  constexpr WideInt operator-() const { return WideInt{} - *this; }
  friend constexpr WideInt operator+(const WideInt& a, const WideInt& b) {
    WideInt sum;
    std::uint64_t carry = 0;
#pragma GCC unroll 12
    for (std::size_t i = 0; i < word_count; ++i) {
      const Uint128 word = static_cast<Uint128>(a.words_[i]) + b.words_[i] + carry;
      sum.words_[i] = static_cast<std::uint64_t>(word);
      carry = static_cast<std::uint64_t>(word >> 64);
    }
    return sum;
  }
  friend constexpr WideInt operator-(const WideInt& a, const WideInt& b) {
    WideInt difference;
    difference.words_ = a.words_;
    difference.template subtract_from<0>(b.words_, ~std::uint64_t{0});
    return difference;
  }
  /// The low bits of the product; see multiply() for all of it.
  friend constexpr WideInt operator*(const WideInt& a, const WideInt& b) {
    WideInt product;
    for (std::size_t i = 0; i < word_count; ++i) {
      std::uint64_t carry = 0;
#pragma GCC unroll 12
      for (std::size_t j = 0; i + j < word_count; ++j) {
        const Uint128 word = static_cast<Uint128>(a.words_[i]) * b.words_[j] + product.words_[i + j] + carry;
        product.words_[i + j] = static_cast<std::uint64_t>(word);
        carry = static_cast<std::uint64_t>(word >> 64);
      }
    }
    return product;
  }
  constexpr WideInt& operator+=(const WideInt& b) {
    return *this = *this + b;
  }
  constexpr WideInt& operator-=(const WideInt& b) {
    return *this = *this - b;
  }
  constexpr WideInt& operator*=(const WideInt& b) {
    return *this = *this * b;
  }

  friend constexpr bool operator==(const WideInt&, const WideInt&) = default;
  friend constexpr std::strong_ordering operator<=>(const WideInt& a, const WideInt& b) {
    // Words below the top one compare as they are; the top one carries the sign.
    constexpr std::uint64_t flip = std::uint64_t{1} << 63;
    if (a.words_.back() != b.words_.back()) return (a.words_.back() ^ flip) <=> (b.words_.back() ^ flip);
    for (std::size_t i = word_count; i-- > 0;) {
      if (a.words_[i] != b.words_[i]) return a.words_[i] <=> b.words_[i];
    }
    return std::strong_ordering::equal;
  }

  template <int a_bits, int b_bits>
  friend constexpr WideInt<a_bits + b_bits> multiply(const WideInt<a_bits>& a, const WideInt<b_bits>& b);

 private:
  /// Takes `other`, each word under `mask`, times 2^(64 from) away; what would borrow beyond the top is dropped.
  template <int from, std::size_t count>
  constexpr void subtract_from(const std::array<std::uint64_t, count>& other, std::uint64_t mask) {
    std::uint64_t borrow = 0;
#pragma GCC unroll 12
    for (std::size_t i = 0; i < count; ++i) {
      const Uint128 word = static_cast<Uint128>(words_[from + i]) - (other[i] & mask) - borrow;
      words_[from + i] = static_cast<std::uint64_t>(word);
      borrow = static_cast<std::uint64_t>(word >> 64) & 1;
    }
  }

  Words words_{};
};

/// The whole product, in the width that always holds it.
template <int a_bits, int b_bits>
constexpr WideInt<a_bits + b_bits> multiply(const WideInt<a_bits>& a, const WideInt<b_bits>& b) {
  constexpr std::size_t a_count = a_bits / 64, b_count = b_bits / 64;
  WideInt<a_bits + b_bits> product;
#pragma GCC unroll 12
  for (std::size_t i = 0; i < a_count; ++i) {
    std::uint64_t carry = 0;
#pragma GCC unroll 12
    for (std::size_t j = 0; j < b_count; ++j) {
      const Uint128 word = static_cast<Uint128>(a.words()[i]) * b.words()[j] + product.words_[i + j] + carry;
      product.words_[i + j] = static_cast<std::uint64_t>(word);
      carry = static_cast<std::uint64_t>(word >> 64);
    }
    product.words_[i + b_count] = carry;
  }
  // That took words as unsigned: a negative a was read as a + 2^a_bits, which brought in 2^a_bits b. Masks, not
  // branches: signs are as good as random.
  product.template subtract_from<a_count>(b.words(), a.negative() ? ~std::uint64_t{0} : 0);
  product.template subtract_from<b_count>(a.words(), b.negative() ? ~std::uint64_t{0} : 0);
  return product;
}

/// The double nearest to the exact quotient; of two, the even one. The denominator is not zero. 0 is +0 whatever the
/// denominator's sign.
template <int a_bits, int b_bits>
constexpr double ratio_to_double(const WideInt<a_bits>& numerator, const WideInt<b_bits>& denominator) {
  constexpr int count = b_bits / 64;
  const auto a = numerator.magnitude();
  const auto b = denominator.magnitude();
  const int a_length = wide::bit_length(a), b_length = wide::bit_length(b);
  assert(b_length > 0);
  if (a_length == 0) return 0;
  // Both are moved to fixed lengths such that the quotient has 63 or 64 bits. The floor of the quotient does not change
  // when the numerator is rounded down to an integer first; bits lost in that only add to the rest.
  bool has_rest = false, none_lost = false;
  auto a_moved = wide::shifted<count + 1>(a, 64 * count + 63 - a_length, has_rest);
  const auto b_moved = wide::shifted<count>(b, 64 * count - b_length, none_lost);
  const std::uint64_t leading = wide::divide_one_digit(a_moved, b_moved);
  for (const std::uint64_t word : a_moved) has_rest |= word != 0;
  const double value = wide::rounded(leading, has_rest, a_length - b_length - 63);
  return numerator.negative() != denominator.negative() ? -value : value;
}

}  // namespace aresta
