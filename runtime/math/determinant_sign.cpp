// SPDX-License-Identifier: MIT
#include "runtime/math/determinant_sign.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sinew {
namespace {

/// The exact result of one operation, as the rounded value and its rounding error.
struct TwoDoubles {
  double value, error;
};

/// eq   a + b = value + error   (Knuth)
TwoDoubles exact_sum(double a, double b) noexcept {
  const double sum = a + b, b_part = sum - a, a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

/// Splits a number into two parts with half the digits, whose products are exact (Dekker). std::fma would be slow on
/// processors without the instruction.
TwoDoubles halves(double a) noexcept {
  const double scaled = a * 134217729.0;  // 2^27 + 1
  const double high = scaled - (scaled - a);
  return {high, a - high};
}

/// eq   a * b = value + error
TwoDoubles exact_product(double a, double b) noexcept {
  const double product = a * b;
  const TwoDoubles x = halves(a), y = halves(b);
  const double error = ((x.value * y.value - product) + x.value * y.error + x.error * y.value) + x.error * y.error;
  return {product, error};
}

/// An exact sum, stored as parts of rising magnitude whose digits do not overlap.
class ExactSum {
 public:
  /// Adds a number without error (Shewchuk 1997, GROW-EXPANSION, without zeros).
  void add(double term) noexcept {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const TwoDoubles sum = exact_sum(term, parts_[i]);
      term = sum.value;
      if (sum.error != 0.0) parts_[kept++] = sum.error;
    }
    if (term != 0.0) parts_[kept++] = term;
    count_ = kept;
  }
  /// eq   += a * b * c
  void add_product(double a, double b, double c) noexcept {
    const TwoDoubles ab = exact_product(a, b), high = exact_product(ab.value, c), low = exact_product(ab.error, c);
    for (const double term : {low.error, low.value, high.error, high.value})
      if (term != 0.0) add(term);
  }
  int sign() const noexcept { return count_ == 0 ? 0 : parts_[count_ - 1] > 0.0 ? 1 : -1; }

 private:
  static constexpr std::size_t kTerms = 6 * 4;  // each term adds at most one part
  double parts_[kTerms] = {};
  std::size_t count_ = 0;
};

/// in   entries whose products of three neither overflow nor lose digits to underflow
int exact_sign(const Mat3<double>& m) noexcept {
  ExactSum sum;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum.add_product(m[0][i], m[1][j], m[2][k]);
    sum.add_product(-m[0][i], m[1][k], m[2][j]);
  }
  return sum.sign();
}

/// in   as exact_sign
int sign_in_range(const Mat3<double>& m) noexcept {
  double determinant = 0.0, magnitude = 0.0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double forward = m[1][j] * m[2][k], backward = m[1][k] * m[2][j];
    determinant += m[0][i] * (forward - backward);
    magnitude += std::abs(m[0][i]) * (std::abs(forward) + std::abs(backward));
  }
  // Each product of three is rounded at most five times on its way into the sum, and into `magnitude`. The error is
  // below (7 + 56 * 2^-53) * 2^-53 * magnitude (Shewchuk 1997, 4.3), which is less than half of this bound.
  constexpr double kBound = 0x1p-49;
  if (std::abs(determinant) > kBound * magnitude) return determinant > 0.0 ? 1 : -1;
  return exact_sign(m);
}

}  // namespace

int determinant_sign(const Mat3<float>& m) noexcept { return sign_in_range(Mat3<double>(m)); }

/// Divides the columns by powers of two, so that products stay in range. This changes no sign.
int determinant_sign(const Mat3<double>& m) noexcept {
  Mat3<double> scaled = m;
  for (int c = 0; c < 3; ++c) {
    const double largest = std::max({std::abs(m[c].x), std::abs(m[c].y), std::abs(m[c].z)});
    int exponent = 0;
    std::frexp(largest, &exponent);
    for (int r = 0; r < 3; ++r) scaled[c][r] = std::ldexp(m[c][r], -exponent);
  }
  return sign_in_range(scaled);
}

}  // namespace sinew
