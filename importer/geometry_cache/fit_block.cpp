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

/// Residuals of an axis are coded for the size that they have on average (residual_code.h).
/// eq   p(r) = (1 - q) / (1 + q) q^|r|, with q such that |r| is `mean` on average
struct ResidualCost {
  double zero = 0.0;  ///< bits of a residual of 0
  double unit = 0.0;  ///< bits more for each step of its size

  ResidualCost() : ResidualCost(1.0) {}
  explicit ResidualCost(double mean) {
    const double m = std::max(mean, kLeastMean), q = (std::sqrt(1.0 + m * m) - 1.0) / m;
    zero = std::log2((1.0 + q) / (1.0 - q));
    unit = -std::log2(q);
  }

 private:
  static constexpr double kLeastMean = 0.01;
};
using AxisCosts = std::array<ResidualCost, 3>;

double size_of(std::int32_t residual) { return std::abs(static_cast<double>(residual)); }

/// Estimated bits of a number in a block's header.
double head_bits(std::int32_t number) { return 5.0 + 0.8 * std::log2(1.0 + std::abs(static_cast<double>(number))); }

/// The residual that leads from a prediction to a point of the grid (BlockMotion).
Vec3i residual_of(const Vec3i& point, const Vec3i& predicted, bool is_centred) {
  Vec3i out;
  for (std::size_t a = 0; a < 3; ++a) out[a] = wrapped(bits(point[a]) - bits(predicted[a]));
  for (std::size_t a = 1; a < 3 && is_centred; ++a) {
    const std::uint32_t up = (bits(predicted[a]) ^ bits(point[0])) & 1u;
    out[a] = wrapped(bits(out[a]) - up) / 2;
  }
  return out;
}

/// The point of a centred grid that a prediction without a residual leads to.
Vec3i centred(Vec3i predicted) {
  for (std::size_t a = 1; a < 3; ++a)
    predicted[a] = wrapped(bits(predicted[a]) + ((bits(predicted[a]) ^ bits(predicted[0])) & 1u));
  return predicted;
}

/// The grid point within `reach` of the value whose residual needs the fewest bits; the nearest one if none is within.
Vec3i choose_near(const std::array<double, 3>& value, const Vec3i& predicted, const Grid& grid,
                  const AxisCosts& costs) {
  Vec3i low, best{};
  for (std::size_t a = 0; a < 3; ++a) low[a] = static_cast<std::int32_t>(std::floor(value[a])) - 1;
  double fewest = std::numeric_limits<double>::infinity(), nearest = fewest;
  for (std::uint32_t corner = 0; corner < 64; ++corner) {
    const Vec3i at{wrapped(bits(low[0]) + (corner & 3u)), wrapped(bits(low[1]) + (corner >> 2 & 3u)),
                   wrapped(bits(low[2]) + (corner >> 4))};
    if (grid.centred && (((at[0] ^ at[1]) | (at[0] ^ at[2])) & 1) != 0) continue;
    double distance = 0.0, cost = 0.0;
    const Vec3i residual = residual_of(at, predicted, grid.centred);
    for (std::size_t a = 0; a < 3; ++a) {
      distance += (at[a] - value[a]) * (at[a] - value[a]);
      cost += costs[a].unit * size_of(residual[a]);
    }
    cost += distance;  // tie-break: the nearer point
    const bool within = distance <= grid.reach * grid.reach;
    if (within ? cost >= fewest : (fewest < std::numeric_limits<double>::infinity() || distance >= nearest)) continue;
    if (within) fewest = cost;
    nearest = std::min(nearest, distance);
    best = at;
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

/// Residual of a point predicted from its corner points: r[a] + r[b] - r[c], or the mean of a and b.
Vec3i spread_from(std::span<const std::uint8_t> corners, const BlockState& r, std::size_t i, bool means) {
  Vec3i out{};
  if (means && corners[3 * i] != kNoCorner) {
    const std::uint8_t first = corners[3 * i], second = corners[3 * i + 1] == kNoCorner ? first : corners[3 * i + 1];
    for (std::size_t a = 0; a < 3; ++a)
      out[a] = wrapped(bits(r[a * kBlockPoints + first]) + bits(r[a * kBlockPoints + second])) >> 1;
    return out;
  }
  if (means) return out;
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
void settle(const BlockValues& values, std::size_t count, std::span<const std::uint8_t> corners, const Grid& grid,
            const AxisCosts& costs, const Predict& predict, FittedBlock& out) {
  const bool spreads = out.motion.spreads || out.motion.base == BlockBase::space;
  BlockState missed{};  // residuals of the motion alone
  for (std::size_t i = 0; i < kBlockPoints; ++i) {
    const Vec3i moved = predict(i);
    Vec3i predicted = moved;
    if (spreads) {
      const Vec3i from = spread_from(corners, missed, i, out.motion.means);
      for (std::size_t a = 0; a < 3; ++a) predicted[a] = wrapped(bits(moved[a]) + bits(from[a]));
    }
    const Vec3i chosen = i < count      ? choose_near(point_of(values, i), predicted, grid, costs)
                         : grid.centred ? centred(predicted)
                                        : predicted;
    const Vec3i residual = residual_of(chosen, predicted, grid.centred);
    for (std::size_t a = 0; a < 3; ++a) {
      out.state[a * kBlockPoints + i] = chosen[a];
      out.residuals[a * kBlockPoints + i] = residual[a];
      missed[a * kBlockPoints + i] = wrapped(bits(chosen[a]) - bits(moved[a]));
    }
  }
  set_widths(out);
}

AxisCosts costs_of(const FittedBlock& block) {
  AxisCosts out;
  for (std::size_t a = 0; a < 3; ++a) {
    double sum = 0.0;
    for (std::size_t i = 0; i < kBlockPoints; ++i) sum += size_of(block.residuals[a * kBlockPoints + i]);
    out[a] = ResidualCost(sum / kBlockPoints);
  }
  return out;
}

/// Quantizes twice: first for costs that are guessed, then for those of the residuals that this leaves.
template <class Predict>
void settle_twice(const BlockValues& values, std::size_t count, std::span<const std::uint8_t> corners, const Grid& grid,
                  const Predict& predict, FittedBlock& out) {
  settle(values, count, corners, grid, AxisCosts{}, predict, out);
  settle(values, count, corners, grid, costs_of(out), predict, out);
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
               const BlockState& x1, const BlockState& x2, bool centred)
      : values_(values), count_(count), corners_(corners), x1_(x1), x2_(x2), centred_(centred) {
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
    for (const int shift : {fine - 1, fine - 2}) try_motion(turned(still, fit, shift));
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
    double head = 0.0, offset = 0.0;
    for (const std::int32_t x : motion.offset) offset += head_bits(x);
    if (motion.turns)
      for (const std::int16_t x : motion.matrix) head += head_bits(x);
    BlockState missed{};
    std::array<std::array<double, 3>, 3> sizes{};  // of residuals alone, spreading, and spreading by means
    for (std::size_t i = 0; i < count_; ++i) {
      const Vec3i predicted = predict(motion, x1_, x2_, i);
      for (std::size_t a = 0; a < 3; ++a) {
        const auto value = static_cast<std::int32_t>(std::lround(values_[a * kBlockPoints + i]));
        missed[a * kBlockPoints + i] = wrapped(bits(value) - bits(predicted[a]));
      }
      const Vec3i missing = point_of(missed, i), spread = spread_from(corners_, missed, i, false),
                  mean = spread_from(corners_, missed, i, true);
      for (std::size_t a = 0; a < 3; ++a) {
        sizes[0][a] += size_of(missing[a]);
        if (i == 0) continue;
        sizes[1][a] += size_of(wrapped(bits(missing[a]) - bits(spread[a])));
        sizes[2][a] += size_of(wrapped(bits(missing[a]) - bits(mean[a])));
      }
    }
    double first = 0.0;  // where residuals spread, the offset leads to point 0
    for (std::size_t a = 0; a < 3; ++a)
      first += head_bits(wrapped(bits(motion.offset[a]) + bits(missed[a * kBlockPoints])));
    const double ways[3] = {offset + bits_of(sizes[0]), kSpreadBits + first + bits_of(sizes[1]),
                            kSpreadBits + first + bits_of(sizes[2])};
    const auto way = static_cast<std::size_t>(std::min_element(ways, ways + 3) - ways);
    if (head + ways[way] >= fewest_) return;
    fewest_ = head + ways[way];
    best_ = motion;
    best_.spreads = way > 0;
    best_.means = way == 2;
    for (std::size_t a = 0; a < 3 && best_.spreads; ++a)
      best_.offset[a] = wrapped(bits(motion.offset[a]) + bits(missed[a * kBlockPoints]));
  }

  /// Estimated bits of residuals whose sizes have these sums.
  double bits_of(const std::array<double, 3>& sizes) const {
    double sum = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double size = centred_ && a > 0 ? 0.5 * sizes[a] : sizes[a];  // residuals of y and z count steps of 2
      const ResidualCost cost(size / static_cast<double>(count_));
      sum += static_cast<double>(count_) * cost.zero + cost.unit * size;
    }
    return sum;
  }

  const BlockValues& values_;
  std::size_t count_;
  std::span<const std::uint8_t> corners_;
  const BlockState& x1_;
  const BlockState& x2_;
  bool centred_;
  std::array<std::array<double, 4>, 4> normal_{};
  double extent_ = 1.0, fewest_ = std::numeric_limits<double>::infinity();
  BlockMotion best_;
};

}  // namespace

FittedBlock fit_in_space(const BlockValues& values, std::size_t count, std::span<const std::uint8_t> corners,
                         const Grid& grid) {
  FittedBlock out;
  out.motion.base = BlockBase::space;
  for (std::size_t a = 0; a < 3; ++a)
    out.motion.offset[a] = static_cast<std::int32_t>(std::lround(values[a * kBlockPoints]));
  settle_twice(
      values, count, corners, grid, [&](std::size_t) { return out.motion.offset; }, out);
  return out;
}

FittedBlock fit_in_time(const BlockValues& values, std::size_t count, std::span<const std::uint8_t> corners,
                        const BlockState& x1, const BlockState& x2, bool steady, const Grid& grid) {
  MotionSearch search(values, count, corners, x1, x2, grid.centred);
  search.try_base(BlockBase::last);
  if (steady) {
    search.try_base(BlockBase::linear);
    search.try_base(BlockBase::slower);
  }
  FittedBlock out;
  out.motion = search.best();
  settle_twice(
      values, count, corners, grid, [&](std::size_t i) { return predict(out.motion, x1, x2, i); }, out);
  return out;
}

}  // namespace sinew
