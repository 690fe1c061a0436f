// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace sinew {

/// Slerp without trigonometry: the weights of both keys are power series in x = 1 - cos(a), where a is the angle
/// between the unit quaternions on the short arc. The coefficients depend only on the fraction, which all tracks of a
/// block share.
/// eq   sin(s a) / sin(a) = sum over i of c_i x^i, c_0 = s, c_i = c_(i-1) (i^2 - s^2) / (i (2 i + 1))
///      (hypergeometric: Abramowitz and Stegun 15.1.16; as a recursion: Eberly 2011, A Fast and Accurate Algorithm for
///      Computing SLERP). The sum to the power n is within 2^-25 while x <= kSlerpReach[n - 1].
inline constexpr std::array<float, 20> kSlerpReach = {
    0.000793791f, 0.0114771f, 0.0429767f, 0.0941667f, 0.158163f, 0.228484f, 0.300596f, 0.371707f, 0.440253f, 0.505426f,
    0.566888f,    0.624574f,  0.678576f,  0.729070f,  0.776271f, 0.820409f, 0.861715f, 0.900408f, 0.936699f, 0.970779f};

/// Highest power that any arc needs: x is at most 1, which is a right angle.
inline constexpr std::size_t kMostSlerpPower = kSlerpReach.size() + 1;

/// The power that suffices for keys of most clips, and the least that is used. Using fewer terms where possible costs
/// more in branches than it saves.
inline constexpr std::size_t kUsualSlerpPower = 3;

/// The power needed for quaternions with this x, at least kUsualSlerpPower.
inline std::uint8_t slerp_power(double x) noexcept {
  const auto* found = std::lower_bound(kSlerpReach.begin() + kUsualSlerpPower - 1, kSlerpReach.end(), x,
                                       [](float reach, double wanted) { return static_cast<double>(reach) < wanted; });
  return static_cast<std::uint8_t>(found - kSlerpReach.begin() + 1);
}

/// Coefficients for both keys, up to `power`. A fraction of 0 or 1 gives weights of exactly 0 and 1 for every x.
struct SlerpCoefficients {
  struct Pair {
    float begin, end;
  };
  std::array<Pair, kMostSlerpPower + 1> of_power;

  /// in   r, s   the fractions of both keys; r + s = 1
  ///      power  at least kUsualSlerpPower
  SlerpCoefficients(float r, float s, std::size_t power) noexcept {
    double begin = static_cast<double>(r), end = static_cast<double>(s);
    const double begin_squared = begin * begin, end_squared = end * end;
    const auto next = [&](std::size_t i) {
      begin *= (kTerms[i].squared - begin_squared) * kTerms[i].divided;
      end *= (kTerms[i].squared - end_squared) * kTerms[i].divided;
      of_power[i] = {static_cast<float>(begin), static_cast<float>(end)};
    };
    of_power[0] = {r, s};
    for (std::size_t i = 1; i <= kUsualSlerpPower; ++i) next(i);
    for (std::size_t i = kUsualSlerpPower + 1; i <= power; ++i) next(i);
  }

 private:
  struct Term {
    double squared, divided;  ///< i^2, 1 / (i (2 i + 1))
  };
  static constexpr std::array<Term, kMostSlerpPower + 1> kTerms = [] {
    std::array<Term, kMostSlerpPower + 1> terms{};
    for (std::size_t i = 1; i < terms.size(); ++i)
      terms[i] = {static_cast<double>(i * i), 1.0 / static_cast<double>(i * (2 * i + 1))};
    return terms;
  }();
};

}  // namespace sinew
