// SPDX-License-Identifier: MIT
#include "importer/geometry_cache/fit_block.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace sinew {
namespace {

using Vec3i = std::array<std::int32_t, 3>;
/// An affine map: three matrix columns and the offset, each with three axes.
using Affine4 = std::array<std::array<double, 3>, 4>;

std::int32_t wrapped(std::uint32_t number) { return static_cast<std::int32_t>(number); }
std::uint32_t bits(std::int32_t number) { return static_cast<std::uint32_t>(number); }

/// Estimated bits of a residual after packing and compression.
double residual_bits(std::int32_t residual) {
  static const std::vector<double> table = [] {
    std::vector<double> t{0.8};
    for (int i = 1; i < 1024; ++i) t.push_back(1.5 + 1.6 * std::log2(i + 1.0));
    return t;
  }();
  const std::uint32_t size = residual < 0 ? 0u - bits(residual) : bits(residual);
  return size < table.size() ? table[size] : 1.5 + 1.6 * std::log2(size + 1.0);
}

/// Estimated bits of a number in a block's header.
double head_bits(std::int32_t number) {
  return 0.6 * (1.0 + 2.0 * std::log2(1.0 + std::abs(static_cast<double>(number))));
}

/// The grid point within `reach` of the value whose residual needs the fewest bits. Any point within the error budget
/// (a ball) is acceptable, and the ball usually contains several grid points.
Vec3i choose_near(const std::array<double, 3>& value, const Vec3i& predicted, double reach) {
  Vec3i low, best{};
  for (std::size_t a = 0; a < 3; ++a) low[a] = static_cast<std::int32_t>(std::floor(value[a]));
  double fewest = std::numeric_limits<double>::infinity();
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    double distance = 0.0, cost = 0.0;
    Vec3i at;
    bool nearest = true;
    for (std::size_t a = 0; a < 3; ++a) {
      at[a] = low[a] + static_cast<std::int32_t>(corner >> a & 1u);
      const double off = at[a] - value[a];
      distance += off * off;
      nearest = nearest && std::abs(off) <= 0.5;
      cost += residual_bits(wrapped(bits(at[a]) - bits(predicted[a])));
    }
    if (distance > reach * reach && !nearest) continue;
    cost += distance;  // tie-break: the nearer point
    if (cost < fewest) {
      fewest = cost;
      best = at;
    }
  }
  return best;
}

void set_widths(FittedBlock& block) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::uint32_t all = 0;
    for (std::size_t i = 0; i < kBlockPoints; ++i) all |= zigzag(block.residuals[axis * kBlockPoints + i]);
    block.motion.width[axis] = static_cast<std::uint8_t>(std::bit_width(all));
  }
}

/// Bits that a block must save before residual prediction is enabled, because that costs decoding time.
constexpr double kSpreadBits = 32.0;

std::array<double, 3> point_of(const BlockValues& values, std::size_t i) {
  return {values[i], values[kBlockPoints + i], values[2 * kBlockPoints + i]};
}
Vec3i point_of(const BlockState& state, std::size_t i) {
  return {state[i], state[kBlockPoints + i], state[2 * kBlockPoints + i]};
}

/// Residual of a point predicted from its corner points: r[a] + r[b] - r[c].
Vec3i spread_from(std::span<const std::uint8_t> corners, const BlockState& r, std::size_t i) {
  Vec3i out{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint8_t corner = corners[3 * i + k];
    if (corner == kNoCorner) continue;
    for (std::size_t a = 0; a < 3; ++a) {
      const std::uint32_t from = bits(r[a * kBlockPoints + corner]);
      out[a] = wrapped(bits(out[a]) + (k < 2 ? from : 0u - from));
    }
  }
  return out;
}

/// Quantizes the points of a block one after another. Padding points beyond `count` take their predicted values.
template <class Predict>
void settle(const BlockValues& values, std::size_t count, std::span<const std::uint8_t> corners, double reach,
            const Predict& predict, FittedBlock& out) {
  const bool spreads = out.motion.spreads || out.motion.base == BlockBase::space;
  BlockState missed{};  // residuals of the motion alone
  for (std::size_t i = 0; i < kBlockPoints; ++i) {
    const Vec3i moved = predict(i);
    Vec3i predicted = moved;
    if (spreads) {
      const Vec3i from = spread_from(corners, missed, i);
      for (std::size_t a = 0; a < 3; ++a) predicted[a] = wrapped(bits(moved[a]) + bits(from[a]));
    }
    const Vec3i chosen = i < count ? choose_near(point_of(values, i), predicted, reach) : predicted;
    for (std::size_t a = 0; a < 3; ++a) {
      out.state[a * kBlockPoints + i] = chosen[a];
      out.residuals[a * kBlockPoints + i] = wrapped(bits(chosen[a]) - bits(predicted[a]));
      missed[a * kBlockPoints + i] = wrapped(bits(chosen[a]) - bits(moved[a]));
    }
  }
  set_widths(out);
}

/// The prediction of a motion for one point, before residuals: the equation of BlockMotion.
Vec3i predict(const BlockMotion& motion, const BlockState& x1, const BlockState& x2, std::size_t i) {
  const Vec3i last = point_of(x1, i), earlier = point_of(x2, i), first = point_of(x1, 0);
  Vec3i out;
  for (std::size_t a = 0; a < 3; ++a) {
    std::uint32_t sum = bits(last[a]) + bits(motion.offset[a]);
    const std::int32_t moved = wrapped(bits(last[a]) - bits(earlier[a]));
    if (motion.base == BlockBase::linear) sum += bits(moved);
    if (motion.base == BlockBase::slower) sum += bits(moved >> 1);
    if (motion.turns) {
      std::uint32_t turned = motion.shift > 0 ? 1u << (motion.shift - 1) : 0u;
      for (std::size_t k = 0; k < 3; ++k) turned += bits(motion.matrix[3 * k + a]) * (bits(last[k]) - bits(first[k]));
      sum += bits(wrapped(turned) >> motion.shift);
    }
    out[a] = wrapped(sum);
  }
  return out;
}

/// Solves the normal equations of four unknowns for three right-hand sides (Cholesky).
/// in   n  symmetric, positive definite;   out  in place of `sides`
void solve(std::array<std::array<double, 4>, 4> n, Affine4& sides) {
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t k = 0; k < j; ++k) n[j][j] -= n[j][k] * n[j][k];
    n[j][j] = std::sqrt(std::max(n[j][j], 1e-9));
    for (std::size_t i = j + 1; i < 4; ++i) {
      for (std::size_t k = 0; k < j; ++k) n[i][j] -= n[i][k] * n[j][k];
      n[i][j] /= n[j][j];
    }
  }
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < i; ++k) sides[i][a] -= n[i][k] * sides[k][a];
      sides[i][a] /= n[i][i];
    }
    for (std::size_t i = 4; i-- > 0;) {
      for (std::size_t k = i + 1; k < 4; ++k) sides[i][a] -= n[k][i] * sides[k][a];
      sides[i][a] /= n[i][i];
    }
  }
}

/// Finds the motion of one block.
class MotionSearch {
 public:
  MotionSearch(const BlockValues& values, std::size_t count, std::span<const std::uint8_t> corners,
               const BlockState& x1, const BlockState& x2)
      : values_(values), count_(count), corners_(corners), x1_(x1), x2_(x2) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::array<double, 4> p = local(i);
      for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c) normal_[r][c] += p[r] * p[c];
      for (std::size_t a = 0; a < 3; ++a) extent_ = std::max(extent_, std::abs(p[a]));
    }
    for (std::size_t a = 0; a < 3; ++a) normal_[a][a] += 1.0;  // regularises flat blocks, whose equations are singular
  }

  void try_base(BlockBase base) {
    const BlockMotion still{.base = base};
    std::vector<std::array<double, 3>> rest(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      const Vec3i predicted = predict(still, x1_, x2_, i);
      for (std::size_t a = 0; a < 3; ++a) rest[i][a] = values_[a * kBlockPoints + i] - predicted[a];
    }
    try_motion(still);
    try_motion(moved(still, rest));
    Affine4 fit{};
    for (std::size_t i = 0; i < count_; ++i) {
      const std::array<double, 4> p = local(i);
      for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t a = 0; a < 3; ++a) fit[r][a] += p[r] * rest[i][a];
    }
    solve(normal_, fit);
    const int fine = std::clamp(static_cast<int>(std::ceil(std::log2(extent_))), 1, 30);
    for (const int shift : {fine, fine - 1}) try_motion(turned(still, fit, shift));
  }

  const BlockMotion& best() const { return best_; }

 private:
  std::array<double, 4> local(std::size_t i) const {
    std::array<double, 4> p{0.0, 0.0, 0.0, 1.0};
    for (std::size_t a = 0; a < 3; ++a) p[a] = static_cast<double>(x1_[a * kBlockPoints + i]) - x1_[a * kBlockPoints];
    return p;
  }

  /// Sets the offset to the median of the remaining differences along each axis.
  BlockMotion moved(BlockMotion motion, const std::vector<std::array<double, 3>>& rest) const {
    std::vector<double> along(count_);
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t i = 0; i < count_; ++i) along[i] = rest[i][a];
      const auto middle = along.begin() + static_cast<std::ptrdiff_t>(count_ / 2);
      std::nth_element(along.begin(), middle, along.end());
      motion.offset[a] = static_cast<std::int32_t>(std::lround(*middle));
    }
    return motion;
  }

  /// Quantizes the matrix as finely as possible without integer overflow of its entries or of its products with the
  /// block's points.
  BlockMotion turned(BlockMotion motion, const Affine4& fit, int shift) const {
    double largest = 0.0, farthest = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
      double sum = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        largest = std::max(largest, std::abs(fit[k][a]));
        sum += std::abs(fit[k][a]);
      }
      farthest = std::max(farthest, sum * extent_);
    }
    while (shift > 0 && (std::ldexp(largest, shift) > 32767.0 || std::ldexp(farthest, shift) > 0x1p30)) --shift;
    motion.turns = true;
    motion.shift = static_cast<std::uint8_t>(std::max(shift, 0));
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t a = 0; a < 3; ++a)
        motion.matrix[3 * k + a] = static_cast<std::int16_t>(
            std::clamp(std::nearbyint(std::ldexp(fit[k][a], motion.shift)), -32767.0, 32767.0));
    for (std::size_t a = 0; a < 3; ++a)
      motion.offset[a] = static_cast<std::int32_t>(std::clamp(std::nearbyint(fit[3][a]), -1e9, 1e9));
    return motion;
  }

  /// Compares the cost of a motion with plain residuals and with predicted residuals (where the offset matches point 0
  /// exactly).
  void try_motion(const BlockMotion& motion) {
    double head = 0.0, alone = 0.0, spread = kSpreadBits;
    for (const std::int32_t x : motion.offset) alone += head_bits(x);
    if (motion.turns)
      for (const std::int16_t x : motion.matrix) head += head_bits(x);
    BlockState missed;
    for (std::size_t i = 0; i < count_ && head + std::min(alone, spread) < fewest_; ++i) {
      const Vec3i predicted = predict(motion, x1_, x2_, i), from = spread_from(corners_, missed, i);
      for (std::size_t a = 0; a < 3; ++a) {
        const auto value = static_cast<std::int32_t>(std::lround(values_[a * kBlockPoints + i]));
        const std::int32_t residual = wrapped(bits(value) - bits(predicted[a]));
        missed[a * kBlockPoints + i] = residual;
        alone += residual_bits(residual);
        spread += i > 0 ? residual_bits(wrapped(bits(residual) - bits(from[a])))
                        : head_bits(wrapped(bits(motion.offset[a]) + bits(residual)));
      }
    }
    if (head + std::min(alone, spread) >= fewest_) return;
    fewest_ = head + std::min(alone, spread);
    best_ = motion;
    best_.spreads = spread < alone;
    for (std::size_t a = 0; a < 3 && best_.spreads; ++a)
      best_.offset[a] = wrapped(bits(motion.offset[a]) + bits(missed[a * kBlockPoints]));
  }

  const BlockValues& values_;
  std::size_t count_;
  std::span<const std::uint8_t> corners_;
  const BlockState& x1_;
  const BlockState& x2_;
  std::array<std::array<double, 4>, 4> normal_{};
  double extent_ = 1.0, fewest_ = std::numeric_limits<double>::infinity();
  BlockMotion best_;
};

}  // namespace

FittedBlock fit_in_space(const BlockValues& values, std::size_t count, std::span<const std::uint8_t> corners,
                         double reach) {
  FittedBlock out;
  out.motion.base = BlockBase::space;
  for (std::size_t a = 0; a < 3; ++a)
    out.motion.offset[a] = static_cast<std::int32_t>(std::lround(values[a * kBlockPoints]));
  settle(
      values, count, corners, reach, [&](std::size_t) { return out.motion.offset; }, out);
  return out;
}

FittedBlock fit_in_time(const BlockValues& values, std::size_t count, std::span<const std::uint8_t> corners,
                        const BlockState& x1, const BlockState& x2, bool steady, double reach) {
  MotionSearch search(values, count, corners, x1, x2);
  search.try_base(BlockBase::last);
  if (steady) {
    search.try_base(BlockBase::linear);
    search.try_base(BlockBase::slower);
  }
  FittedBlock out;
  out.motion = search.best();
  settle(
      values, count, corners, reach, [&](std::size_t i) { return predict(out.motion, x1, x2, i); }, out);
  return out;
}

}  // namespace sinew
