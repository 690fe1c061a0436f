// SPDX-License-Identifier: MIT
#include "importer/geometry_cache/fit_block.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <vector>

#include "runtime/geometry_cache/geometry_format.h"
#include "tests/reference/block_motion.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

constexpr double kReach = 0.8660254037844387;  // half the diagonal of a cube

struct Frame {
  BlockState state{};
  std::array<std::int32_t, 3> point(std::size_t i) const {
    return {state[i], state[kBlockPoints + i], state[2 * kBlockPoints + i]};
  }
  void set(std::size_t i, std::int32_t x, std::int32_t y, std::int32_t z) {
    state[i] = x;
    state[kBlockPoints + i] = y;
    state[2 * kBlockPoints + i] = z;
  }
};

/// Random points in a cube.
Frame cloud(std::uint64_t seed, double size) {
  FixedRandom random(seed);
  Frame out;
  for (auto& x : out.state) x = static_cast<std::int32_t>(random.in(-size, size));
  return out;
}

using Mapping = std::function<std::array<double, 3>(double x, double y, double z)>;

/// The points of a frame after a mapping.
BlockValues mapped(const Frame& from, const Mapping& mapping) {
  BlockValues out{};
  for (std::size_t i = 0; i < kBlockPoints; ++i) {
    const auto p = from.point(i);
    const std::array<double, 3> to = mapping(p[0], p[1], p[2]);
    for (std::size_t a = 0; a < 3; ++a) out[a * kBlockPoints + i] = to[a];
  }
  return out;
}

std::vector<std::uint8_t> no_corners() { return std::vector<std::uint8_t>(kBlockNumbers, kNoCorner); }

/// Rows of eight: each inner point completes a parallelogram, points of the border follow a neighbour.
std::vector<std::uint8_t> grid_corners() {
  std::vector<std::uint8_t> out = no_corners();
  for (std::uint8_t i = 1; i < kBlockPoints; ++i) {
    const bool left = i % 8 == 0, top = i < 8;
    out[3 * std::size_t{i}] = static_cast<std::uint8_t>(left ? i - 8 : i - 1);
    if (left || top) continue;
    out[3 * std::size_t{i} + 1] = static_cast<std::uint8_t>(i - 8);
    out[3 * std::size_t{i} + 2] = static_cast<std::uint8_t>(i - 9);
  }
  return out;
}

/// Residuals packed bit by bit, in the format of the encoder.
std::vector<std::uint8_t> packed(const FittedBlock& block) {
  std::vector<std::uint8_t> out;
  for (std::size_t a = 0; a < 3; ++a) {
    const unsigned width = block.motion.width[a];
    const std::size_t begin = out.size();
    out.resize(begin + std::size_t{8} * width);
    for (std::size_t i = 0; i < kBlockPoints; ++i)
      for (unsigned bit = 0; bit < width; ++bit)
        if ((zigzag(block.residuals[a * kBlockPoints + i]) >> bit & 1u) != 0)
          out[begin + (i * width + bit) / 8] |= static_cast<std::uint8_t>(1u << (i * width + bit) % 8);
  }
  return out;
}

/// Invariants of every fitted block. Its residuals decode to its state, and points are within reach. No width is larger
/// than its residuals need, and padding points leave no residual.
void expect_sound(const FittedBlock& block, const BlockValues& values, std::size_t count,
                  const std::vector<std::uint8_t>& corners, const BlockState& x1, const BlockState& x2, double reach) {
  BlockState decoded = x2;
  reference::move_block(block.motion, packed(block), corners, x1, x2, decoded);
  EXPECT_EQ(decoded, block.state);
  for (std::size_t i = 0; i < count; ++i) {
    double distance = 0.0, farthest = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double off = block.state[a * kBlockPoints + i] - values[a * kBlockPoints + i];
      distance += off * off;
      farthest = std::max(farthest, std::abs(off));
    }
    EXPECT_TRUE(std::sqrt(distance) <= reach || farthest <= 0.5) << "point " << i;
  }
  for (std::size_t a = 0; a < 3; ++a) {
    std::uint32_t largest = 0;
    for (std::size_t i = 0; i < kBlockPoints; ++i) {
      largest = std::max(largest, zigzag(block.residuals[a * kBlockPoints + i]));
      if (i >= count) {
        EXPECT_EQ(block.residuals[a * kBlockPoints + i], 0);
      }
    }
    const unsigned width = block.motion.width[a];
    EXPECT_TRUE(width == 32 || largest < 1u << width);
    EXPECT_TRUE(width == 0 || largest >= 1u << (width - 1));
  }
}

FittedBlock fitted(const BlockValues& values, const Frame& x1, const Frame& x2, bool steady = true,
                   const std::vector<std::uint8_t>& corners = no_corners(), std::size_t count = kBlockPoints,
                   double reach = kReach) {
  const FittedBlock out = fit_in_time(values, count, corners, x1.state, x2.state, steady, reach);
  expect_sound(out, values, count, corners, x1.state, x2.state, reach);
  return out;
}

bool is_without_residuals(const FittedBlock& block) {
  return std::all_of(block.residuals.begin(), block.residuals.end(), [](std::int32_t r) { return r == 0; });
}

TEST(fit_block, a_shift_is_an_offset_and_nothing_else) {
  const Frame x1 = cloud(1, 500), x2 = cloud(2, 500);
  const FittedBlock block = fitted(mapped(x1,
                                          [](double x, double y, double z) {
                                            return std::array{x + 40, y - 7, z + 3000};
                                          }),
                                   x1, x2);
  EXPECT_EQ(block.motion.base, BlockBase::last);
  EXPECT_EQ(block.motion.offset, (std::array<std::int32_t, 3>{40, -7, 3000}));
  EXPECT_FALSE(block.motion.turns);
  EXPECT_FALSE(block.motion.spreads);
  EXPECT_TRUE(is_without_residuals(block));
}

TEST(fit_block, an_offset_is_the_median_so_that_few_points_that_go_elsewhere_do_not_pull_it) {
  const Frame x1 = cloud(1, 500), x2 = cloud(2, 500);
  BlockValues values = mapped(x1, [](double x, double y, double z) { return std::array{x + 40, y - 7, z + 30}; });
  for (const std::size_t i : {3u, 17u, 40u, 61u}) values[i] += 90.0 + static_cast<double>(i);
  const FittedBlock block = fitted(values, x1, x2);
  EXPECT_EQ(block.motion.offset, (std::array<std::int32_t, 3>{40, -7, 30}));
  EXPECT_FALSE(block.motion.turns);
  EXPECT_EQ(std::count(block.residuals.begin(), block.residuals.end(), 0), 192 - 4);
}

/// Two frames, x2 and x1; each point moves differently between them.
struct TwoFrames {
  Frame x1, x2;
};
TwoFrames own_ways() {
  TwoFrames out{cloud(1, 500), cloud(1, 500)};
  FixedRandom random(4);
  for (auto& x : out.x1.state) x += static_cast<std::int32_t>(random.below(401)) - 200;
  return out;
}

TEST(fit_block, points_that_go_on_are_linear_and_those_that_slow_down_are_slower) {
  const auto [x1, x2] = own_ways();
  BlockValues on{}, half{};
  for (std::size_t n = 0; n < kBlockNumbers; ++n) {
    const std::int32_t moved = x1.state[n] - x2.state[n];
    on[n] = x1.state[n] + moved;
    half[n] = x1.state[n] + (moved >> 1);
  }
  for (const bool goes_on : {true, false}) {
    const FittedBlock block = fitted(goes_on ? on : half, x1, x2);
    EXPECT_EQ(block.motion.base, goes_on ? BlockBase::linear : BlockBase::slower);
    EXPECT_EQ(block.motion.offset, (std::array<std::int32_t, 3>{}));
    EXPECT_TRUE(is_without_residuals(block));
    const FittedBlock second = fitted(goes_on ? on : half, x1, x2, false);
    EXPECT_EQ(second.motion.base, BlockBase::last) << "the frame two before is of no use";
  }
}

TEST(fit_block, a_turn_that_stretches_and_moves_is_a_matrix) {
  // Turned by 0.1 rad about z, stretched along it, and moved.
  const Mapping mapping = [](double x, double y, double z) {
    return std::array{0.995 * x - 0.0998 * y + 12, 0.0998 * x + 0.995 * y - 5, 1.01 * z + 0.02 * x};
  };
  for (const double size : {100.0, 3000.0, 200000.0}) {
    const Frame x1 = cloud(3, size), x2 = cloud(4, size);
    const FittedBlock block = fitted(mapped(x1, mapping), x1, x2);
    EXPECT_EQ(block.motion.base, BlockBase::last);
    EXPECT_TRUE(block.motion.turns);
    EXPECT_FALSE(block.motion.spreads);
    const double unit = std::ldexp(1.0, block.motion.shift);
    const double expected[] = {-0.005, 0.0998, 0.02, -0.0998, -0.005, 0, 0, 0, 0.01};
    for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(block.motion.matrix[k] / unit, expected[k], 1.0 / unit + 2e-3) << k;
    const auto largest = std::max_element(block.residuals.begin(), block.residuals.end(),
                                          [](auto a, auto b) { return std::abs(a) < std::abs(b); });
    EXPECT_LE(std::abs(*largest), size < 10000.0 ? 1 : 40) << size;
  }
}

TEST(fit_block, a_matrix_is_taken_after_the_velocity_as_well) {
  const auto [x1, x2] = own_ways();
  BlockValues values{};
  for (std::size_t i = 0; i < kBlockPoints; ++i) {
    const double bend = 0.3 * (x1.state[i] - x1.state[0]);  // along y, depending on x
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t n = a * kBlockPoints + i;
      values[n] = 2.0 * x1.state[n] - x2.state[n] + (a == 1 ? bend : 0.0);
    }
  }
  const FittedBlock block = fitted(values, x1, x2);
  EXPECT_EQ(block.motion.base, BlockBase::linear);
  ASSERT_TRUE(block.motion.turns);
  EXPECT_NEAR(std::ldexp(block.motion.matrix[1], -block.motion.shift), 0.3, 0.01);
}

TEST(fit_block, numbers_of_a_matrix_stay_within_16_bits_however_much_a_block_grows) {
  for (const double growth : {3.0, 400.0, 20000.0, 30000.0}) {
    const Frame x1 = cloud(5, 2000), x2 = cloud(6, 2000);
    const FittedBlock block = fitted(mapped(x1,
                                            [&](double x, double y, double z) {
                                              return std::array{growth * x, y + 1, z - 0.5 * growth * x};
                                            }),
                                     x1, x2);
    ASSERT_TRUE(block.motion.turns) << growth;
    EXPECT_NEAR(std::ldexp(block.motion.matrix[0], -block.motion.shift), growth - 1.0, 0.001 * growth) << growth;
    EXPECT_NEAR(std::ldexp(block.motion.matrix[2], -block.motion.shift), -0.5 * growth, 0.001 * growth) << growth;
    const int finest = std::bit_width(static_cast<unsigned>(growth));
    EXPECT_GE(block.motion.shift, std::min(15 - finest, 10)) << "as fine as 16 bits allow";
  }
}

TEST(fit_block, a_block_that_grows_more_than_a_matrix_can_say_takes_the_largest_one) {
  const Frame x1 = cloud(5, 2000), x2 = cloud(6, 2000);
  const FittedBlock block = fitted(mapped(x1,
                                          [](double x, double y, double z) {
                                            return std::array{40000.0 * x, -40000.0 * y, z};
                                          }),
                                   x1, x2);
  ASSERT_TRUE(block.motion.turns);
  EXPECT_EQ(block.motion.shift, 0);
  EXPECT_EQ(block.motion.matrix[0], 32767);
  EXPECT_EQ(block.motion.matrix[4], -32767);
}

TEST(fit_block, small_turns_of_wide_blocks_have_fine_matrices) {
  const Frame x1 = cloud(5, 200000), x2 = cloud(6, 200000);
  const FittedBlock block = fitted(mapped(x1,
                                          [](double x, double y, double z) {
                                            return std::array{x - 1e-3 * y, y + 1e-3 * x, z};
                                          }),
                                   x1, x2);
  ASSERT_TRUE(block.motion.turns);
  EXPECT_GE(block.motion.shift, 17);
  EXPECT_TRUE(std::all_of(block.residuals.begin(), block.residuals.end(), [](auto r) { return std::abs(r) <= 1; }));
}

TEST(fit_block, large_moves_do_not_make_a_matrix_coarser) {
  // The offset of a million steps is stored separately, so the matrix keeps its precision.
  const Frame x1 = cloud(7, 1000), x2 = cloud(8, 1000);
  const auto turned_by = [&](double away) {
    return fitted(mapped(x1,
                         [&](double x, double y, double z) {
                           return std::array{x - 0.2 * y + away, y + 0.2 * x, z};
                         }),
                  x1, x2)
        .motion;
  };
  const BlockMotion near = turned_by(0.0), far = turned_by(1e6);
  ASSERT_TRUE(near.turns && far.turns);
  EXPECT_EQ(near.matrix, far.matrix);
  EXPECT_EQ(near.shift, far.shift);
  EXPECT_GE(far.shift, 9);
}

TEST(fit_block, what_is_missed_spreads_where_neighbours_miss_alike) {
  // A slope over the grid. No matrix can express it, because the places of the points are random.
  const Frame x1 = cloud(9, 3000), x2 = cloud(10, 3000);
  BlockValues values{};
  for (std::size_t i = 0; i < kBlockPoints; ++i)
    for (std::size_t a = 0; a < 3; ++a)
      values[a * kBlockPoints + i] =
          x1.state[a * kBlockPoints + i] + 25.0 + 31.0 * static_cast<double>(i % 8) - 47.0 * static_cast<double>(i / 8);
  const FittedBlock spread = fitted(values, x1, x2, true, grid_corners());
  EXPECT_TRUE(spread.motion.spreads);
  EXPECT_EQ(spread.motion.base, BlockBase::last);
  for (std::size_t i = 0; i < kBlockPoints; ++i)
    if (i >= 8 && i % 8 != 0) {
      EXPECT_EQ(spread.residuals[i], 0) << "point " << i << " completes a parallelogram of what is missed";
    }
  EXPECT_EQ(spread.residuals[0], 0) << "the offset meets point 0";
  EXPECT_EQ(spread.motion.offset, (std::array<std::int32_t, 3>{25, 25, 25}));
  EXPECT_FALSE(fitted(values, x1, x2, true, no_corners()).motion.spreads) << "without a surface nothing spreads";
}

TEST(fit_block, residuals_that_have_nothing_in_common_stand_alone) {
  const Frame x1 = cloud(11, 3000), x2 = cloud(12, 3000);
  FixedRandom random(13);
  BlockValues values{};
  for (std::size_t n = 0; n < kBlockNumbers; ++n) values[n] = x1.state[n] + random.in(-20, 20);
  const FittedBlock block = fitted(values, x1, x2, true, grid_corners());
  EXPECT_FALSE(block.motion.spreads);
  EXPECT_FALSE(block.motion.turns);
  EXPECT_EQ(block.motion.base, BlockBase::last);
}

TEST(fit_block, a_key_frame_spreads_over_the_surface_from_its_first_point) {
  BlockValues values{};
  for (std::size_t i = 0; i < kBlockPoints; ++i) {
    values[i] = 1000.0 + 30.0 * static_cast<double>(i % 8);
    values[kBlockPoints + i] = -2000.0 + 20.0 * static_cast<double>(i / 8);
    values[2 * kBlockPoints + i] = 7.0 * static_cast<double>(i % 8) - 9.0 * static_cast<double>(i / 8);
  }
  const FittedBlock block = fit_in_space(values, kBlockPoints, grid_corners(), kReach);
  expect_sound(block, values, kBlockPoints, grid_corners(), {}, {}, kReach);
  EXPECT_EQ(block.motion.base, BlockBase::space);
  EXPECT_EQ(block.motion.offset, (std::array<std::int32_t, 3>{1000, -2000, 0}));
  for (std::size_t i = 0; i < kBlockPoints; ++i) {
    const bool inside = i >= 8 && i % 8 != 0;
    EXPECT_EQ(block.residuals[i], inside || i == 0 || i % 8 == 0 ? 0 : 30) << i;
    EXPECT_EQ(block.residuals[kBlockPoints + i], i % 8 == 0 && i > 0 ? 20 : 0) << i;
  }
}

TEST(fit_block, of_all_grid_points_within_reach_the_one_nearest_to_the_prediction_is_taken) {
  // Points without neighbours are predicted at the offset, which is the first point, here the origin.
  FixedRandom random(14);
  for (int round = 0; round < 40; ++round) {
    const double reach = round % 2 == 0 ? kReach : 1.4;
    BlockValues values{};
    for (std::size_t i = 1; i < kBlockPoints; ++i)
      for (std::size_t a = 0; a < 3; ++a) values[a * kBlockPoints + i] = random.in(-3, 3);
    const FittedBlock block = fit_in_space(values, kBlockPoints, no_corners(), reach);
    expect_sound(block, values, kBlockPoints, no_corners(), {}, {}, reach);
    for (std::size_t i = 1; i < kBlockPoints; ++i) {
      // The eight corners of the cell: those in reach or nearest; the sum of their sizes in bits must be the least.
      const auto bits = [](std::int32_t x) { return x == 0 ? 0.8 : 1.5 + 1.6 * std::log2(std::abs(x) + 1.0); };
      double least = 1e9, taken = 0.0;
      for (unsigned corner = 0; corner < 8; ++corner) {
        double distance = 0.0, cost = 0.0;
        bool nearest = true, is_taken = true;
        for (std::size_t a = 0; a < 3; ++a) {
          const double value = values[a * kBlockPoints + i];
          const auto at = static_cast<std::int32_t>(std::floor(value)) + static_cast<std::int32_t>(corner >> a & 1u);
          distance += (at - value) * (at - value);
          nearest = nearest && std::abs(at - value) <= 0.5;
          is_taken = is_taken && at == block.state[a * kBlockPoints + i];
          cost += bits(at);
        }
        if (std::sqrt(distance) > reach && !nearest) continue;
        least = std::min(least, cost + distance);
        if (is_taken) taken = cost + distance;
      }
      EXPECT_NEAR(taken, least, 1e-9) << "point " << i;
    }
  }
}

TEST(fit_block, parts_of_a_block_are_fitted_by_their_own_points_only) {
  for (const std::size_t count : {1u, 2u, 33u, 63u}) {
    const Frame x1 = cloud(15, 500), x2 = cloud(16, 500);
    BlockValues values = mapped(x1, [](double x, double y, double z) { return std::array{x + 9, y + 8, z + 7}; });
    for (std::size_t i = count; i < kBlockPoints; ++i)
      for (std::size_t a = 0; a < 3; ++a) values[a * kBlockPoints + i] = 1e6;
    const FittedBlock block = fitted(values, x1, x2, true, grid_corners(), count);
    EXPECT_EQ(block.motion.offset, (std::array<std::int32_t, 3>{9, 8, 7})) << count;
    EXPECT_FALSE(block.motion.turns);
    EXPECT_TRUE(is_without_residuals(block));
    const FittedBlock key = fit_in_space(values, count, grid_corners(), kReach);
    expect_sound(key, values, count, grid_corners(), {}, {}, kReach);
  }
}

TEST(fit_block, blocks_of_any_numbers_are_sound) {
  FixedRandom random(17);
  for (int round = 0; round < 300; ++round) {
    const double size = std::pow(10.0, random.in(0, 8));
    const Frame x1 = cloud(random.bits(), size), x2 = cloud(random.bits(), size);
    BlockValues values{};
    for (auto& x : values) x = random.in(-size, size);
    const auto corners = round % 2 == 0 ? grid_corners() : no_corners();
    const std::size_t count = 1 + random.below(64);
    fitted(values, x1, x2, round % 3 != 0, corners, count);
    expect_sound(fit_in_space(values, count, corners, kReach), values, count, corners, {}, {}, kReach);
  }
}

}  // namespace
}  // namespace sinew::test
