// SPDX-License-Identifier: Apache-2.0
#include "math/wide_int.h"

#include <gtest/gtest.h>

#include "math/gmp_oracle.h"

namespace aresta {
namespace {

using oracle::nearest_double;
using oracle::Random;
using oracle::to_gmp;

constexpr int rounds = 20000;

// What is known when compiling.
static_assert(WideInt<128>(-1).sign() == -1 && WideInt<256>(0).sign() == 0 && WideInt<192>(7).sign() == 1);
static_assert(multiply(WideInt<64>(-3), WideInt<128>(5)) == WideInt<192>(-15));
static_assert(WideInt<128>(Int128{1} << 100).bit_length() == 101);
static_assert(WideInt<256>(-5) < WideInt<128>(4) && WideInt<256>(-5) > WideInt<128>(-6));
static_assert(ratio_to_double(WideInt<256>(1), WideInt<128>(-3)) == -1.0 / 3);
static_assert(sizeof(WideInt<192>) == 24);
// Narrowing must be asked for.
static_assert(std::is_convertible_v<WideInt<128>, WideInt<256>> && !std::is_convertible_v<WideInt<256>, WideInt<128>> &&
              std::is_constructible_v<WideInt<128>, WideInt<256>> && !std::is_constructible_v<WideInt<64>, Int128>);

/// The value of width `bits` that is congruent: what overflow leaves.
mpz_class wrapped(const mpz_class& value, int bits) {
  mpz_class result;
  mpz_fdiv_r_2exp(result.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(bits));
  const mpz_class half = mpz_class(1) << (bits - 1);
  return result >= half ? mpz_class(result - 2 * half) : result;
}

template <int bits>
void arithmetic_agrees() {
  Random random(bits);
  for (int i = 0; i < rounds; ++i) {
    const auto a = random.integer<bits>(), b = random.integer<bits>();
    const mpz_class x = to_gmp(a), y = to_gmp(b);
    ASSERT_EQ(to_gmp(a + b), wrapped(x + y, bits)) << x << " + " << y;
    ASSERT_EQ(to_gmp(a - b), wrapped(x - y, bits)) << x << " - " << y;
    ASSERT_EQ(to_gmp(a * b), wrapped(x * y, bits)) << x << " * " << y;
    ASSERT_EQ(to_gmp(-a), wrapped(-x, bits)) << x;
    ASSERT_EQ(a < b, x < y) << x << ", " << y;
    ASSERT_EQ(a == b, x == y) << x << ", " << y;
    ASSERT_EQ(a.sign(), sgn(x)) << x;
    ASSERT_EQ(a.bit_length(), x == 0 ? 0 : static_cast<int>(mpz_sizeinbase(x.get_mpz_t(), 2))) << x;
    ASSERT_EQ(a.to_double(), nearest_double(x)) << x;
    const WideInt<bits + 64> wider = a;
    ASSERT_EQ(to_gmp(wider), x);
    ASSERT_EQ(WideInt<bits>(wider), a);
  }
}

template <int a_bits, int b_bits>
void products_and_ratios_agree() {
  Random random(1000 * a_bits + b_bits);
  for (int i = 0; i < rounds; ++i) {
    const auto a = random.integer<a_bits>();
    const auto b = random.integer<b_bits>();
    const mpz_class x = to_gmp(a), y = to_gmp(b);
    if constexpr (a_bits + b_bits <= 768) {
      ASSERT_EQ(to_gmp(multiply(a, b)), x * y) << x << " * " << y;
    }
    if (y == 0) continue;
    mpq_class ratio(x, y);
    ratio.canonicalize();
    ASSERT_EQ(ratio_to_double(a, b), nearest_double(ratio)) << x << " / " << y;
  }
}

TEST(WideInt, AgreesWithGmp) {
  arithmetic_agrees<64>();
  arithmetic_agrees<128>();
  arithmetic_agrees<192>();
  arithmetic_agrees<256>();
  arithmetic_agrees<384>();
  arithmetic_agrees<512>();
  arithmetic_agrees<704>();
}

TEST(WideInt, ProductsAndRatiosAgreeWithGmp) {
  products_and_ratios_agree<64, 64>();
  products_and_ratios_agree<128, 64>();
  products_and_ratios_agree<64, 192>();
  products_and_ratios_agree<128, 128>();
  products_and_ratios_agree<256, 192>();
  products_and_ratios_agree<128, 256>();
  products_and_ratios_agree<192, 192>();
  products_and_ratios_agree<448, 384>();
  products_and_ratios_agree<384, 384>();
  products_and_ratios_agree<64, 768>();
  products_and_ratios_agree<768, 64>();
  products_and_ratios_agree<768, 768>();
}

TEST(WideInt, ExtremesOfAWidth) {
  WideInt<128> low(1);
  for (int i = 0; i < 127; ++i) low += low;
  EXPECT_EQ(low.sign(), -1);
  EXPECT_EQ(low.bit_length(), 128);
  EXPECT_EQ(low.to_double(), -0x1p127);
  EXPECT_EQ(-low, low) << "the only overflow of a negation";
  EXPECT_EQ(to_gmp(multiply(low, low)), mpz_class(1) << 254);
  EXPECT_EQ(ratio_to_double(low, low), 1);
  EXPECT_EQ(ratio_to_double(low, WideInt<64>(-1)), 0x1p127);
  EXPECT_EQ(to_gmp(low - WideInt<128>(1)), (mpz_class(1) << 127) - 1);
}

TEST(WideInt, ReadsBuiltinIntegers) {
  EXPECT_EQ(to_gmp(WideInt<64>(INT64_MIN)), mpz_class(-1) << 63);
  EXPECT_EQ(to_gmp(WideInt<192>(-7)), -7);
  EXPECT_EQ(to_gmp(WideInt<128>(-(Int128{1} << 90))), mpz_class(-1) << 90);
  EXPECT_EQ(to_gmp(WideInt<384>((Int128{1} << 90) + 1)), (mpz_class(1) << 90) + 1);
}

TEST(WideInt, TiesGoToTheEvenDouble) {
  const auto value = [](std::int64_t leading, int doublings, std::int64_t rest) {
    WideInt<256> result(leading);
    for (int i = 0; i < doublings; ++i) result += result;
    return result + WideInt<256>(rest);
  };
  constexpr std::int64_t odd = (std::int64_t{1} << 53) + 1;  // halfway between 2^53 and 2^53 + 2
  for (const int doublings : {0, 1, 9, 10, 11, 12, 63, 64, 65, 150}) {
    const double scale = std::ldexp(1.0, doublings);
    EXPECT_EQ(value(odd, doublings, 0).to_double(), 0x1p53 * scale);
    EXPECT_EQ(value(odd + 2, doublings, 0).to_double(), (0x1p53 + 4) * scale);
    EXPECT_EQ(value(-odd, doublings, 0).to_double(), -0x1p53 * scale);
    if (doublings > 0) {
      EXPECT_EQ(value(odd, doublings, 1).to_double(), (0x1p53 + 2) * scale) << "a bit far below breaks the tie";
      EXPECT_EQ(value(odd, doublings, -1).to_double(), 0x1p53 * scale);
      EXPECT_EQ(value(odd + 2, doublings, -1).to_double(), (0x1p53 + 2) * scale);
    }
  }
  EXPECT_EQ(value((std::int64_t{1} << 54) - 1, 20, 0).to_double(), 0x1p74) << "rounding up may reach a power of two";
}

/// Quotients at ties, and as near to one as integers of these widths allow.
TEST(WideInt, RatiosNearTiesAgreeWithGmp) {
  Random random(17);
  for (int i = 0; i < rounds; ++i) {
    const auto denominator = random.integer<384>();
    if (denominator.sign() == 0) continue;
    const auto halfway = static_cast<std::int64_t>(random.word() >> 10 | (std::uint64_t{1} << 53) | 1);
    const WideInt<448> tie = multiply(WideInt<64>(halfway), denominator);
    for (const int off : {-1, 0, 1}) {
      const WideInt<448> numerator = tie + WideInt<448>(off);
      mpq_class ratio(to_gmp(numerator), to_gmp(denominator));
      ratio.canonicalize();
      ASSERT_EQ(ratio_to_double(numerator, denominator), nearest_double(ratio)) << ratio;
    }
  }
}

/// The first guess at the digit is too large by up to two for dividends like these, which random ones hardly are.
TEST(WideInt, GuessesOfDigitsAreCorrected) {
  constexpr std::uint64_t ones = ~std::uint64_t{0}, top = std::uint64_t{1} << 63;
  int corrected[3] = {};
  const std::uint64_t words[] = {0, 1, top - 1, top, top + 1, ones - 1, ones};
  const auto gmp = [](const auto& w) {
    mpz_class result;
    mpz_import(result.get_mpz_t(), w.size(), -1, sizeof(std::uint64_t), 0, 0, w.data());
    return result;
  };
  for (const std::uint64_t b1 : {top, top + 1, ones}) {
    for (const std::uint64_t b0 : words) {
      for (const std::uint64_t a2 : {std::uint64_t{0}, std::uint64_t{1}, top - 2, top - 1}) {
        for (const std::uint64_t a1 : words) {
          for (const std::uint64_t a0 : words) {
            std::array<std::uint64_t, 3> a{a0, a1, a2};
            const std::array<std::uint64_t, 2> b{b0, b1};
            const mpz_class x = gmp(a), y = gmp(b), guess = (x >> 64) / mpz_class(y >> 64);
            const mpz_class digit = gmp(std::array{wide::divide_one_digit(a, b)});
            ASSERT_EQ(digit, x / y) << x << " / " << y;
            ASSERT_EQ(gmp(a), x % y) << x << " % " << y;
            ++corrected[mpz_class(guess - digit).get_si()];
          }
        }
      }
    }
  }
  EXPECT_GT(corrected[0], 0);
  EXPECT_GT(corrected[1], 0);
  EXPECT_GT(corrected[2], 0);
}

TEST(WideInt, ZeroHasNoSign) {
  EXPECT_FALSE(std::signbit(ratio_to_double(WideInt<128>(0), WideInt<128>(-5))));
  EXPECT_FALSE(std::signbit(WideInt<128>(0).to_double()));
}

}  // namespace
}  // namespace aresta
