// SPDX-License-Identifier: MIT
#include "runtime/clip/packed_rows.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numbers>

#include "runtime/clip/clip_layout.h"
#include "runtime/clip/slerp_series.h"
#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

constexpr std::size_t kKeys = 9;

QuatTrack turning(test::FixedRandom& random, double step_rad) {
  QuatTrack track{Interpolation::linear, {}, {}};
  Quat<double> q = random.rotation<double>();
  for (std::size_t k = 0; k < kKeys; ++k) {
    q = normalised(q * random.rotation_by<double>(random.in(0, step_rad)));
    track.times_s.push_back(static_cast<float>(k));
    track.values.push_back(quat_cast<float>(q));
  }
  return track;
}

/// Tracks that turn little or much, so that each of the four components is derived in some, and none in others.
std::vector<PackedTrack> rotations(std::size_t count) {
  test::FixedRandom random(4);
  std::vector<PackedTrack> tracks;
  for (std::size_t i = 0; i < count; ++i)
    tracks.push_back(*pack_keys(turning(random, i % 4 == 3 ? 3.0 : 0.1), std::pow(10.0, random.in(-4, -1))));
  return tracks;
}

void expect_same(const PackedTrack& found, const PackedTrack& expected) {
  EXPECT_EQ(found.components, expected.components);
  EXPECT_EQ(found.derived, expected.derived);
  EXPECT_EQ(found.width, expected.width);
  for (std::size_t key = 0; key < kKeys; ++key)
    for (std::size_t c = 0; c < expected.components; ++c) {
      if (c == expected.derived) continue;
      EXPECT_EQ(found.numbers[key * expected.components + c], expected.numbers[key * expected.components + c]);
      EXPECT_EQ(found.low[c], expected.low[c]);
      if (expected.width[c] > 0) {
        EXPECT_EQ(found.step[c], expected.step[c]);
      }
    }
}

TEST(packed_rows, every_lane_comes_back_as_it_was_packed) {
  for (const std::size_t count : {1u, 4u, 7u, 21u}) {
    const std::vector<PackedTrack> tracks = rotations(count);
    const PackedRows rows = packed_rows(tracks, kKeys);
    for (std::size_t lane = 0; lane < count; ++lane) expect_same(packed_lane(rows, count, lane, kKeys), tracks[lane]);
  }
}

TEST(packed_rows, the_order_of_lanes_has_the_components_of_each_lane_one_after_another) {
  const std::vector<PackedTrack> tracks = rotations(21);
  const PackedRows rows = packed_rows(tracks, kKeys);
  const std::vector<std::uint8_t> bits = in_lane_order(rows, tracks.size(), kKeys);
  const std::size_t row_bytes = packed_row_bytes(tracks);
  ASSERT_EQ(bits.size(), kKeys * row_bytes);
  for (std::size_t key = 0; key < kKeys; ++key) {
    std::size_t bit = key * row_bytes * 8;
    for (const PackedTrack& track : tracks)
      for (std::uint32_t c = 0; c < 4; ++c) {
        std::uint32_t number = 0;
        for (std::uint32_t i = 0; i < track.width[c]; ++i, ++bit)
          number |= static_cast<std::uint32_t>(bits[bit / 8] >> bit % 8 & 1) << i;
        EXPECT_EQ(number, track.numbers[key * 4 + c]);
      }
  }
  const PackedRows again = packed_rows(tracks, bits, kKeys);
  EXPECT_EQ(again.bits, rows.bits);
  EXPECT_EQ(again.power, rows.power);
}

/// Tracks with random widths, within what is allowed.
std::vector<PackedTrack> of_any_width(test::FixedRandom& random, std::uint32_t most_bits) {
  std::vector<PackedTrack> tracks = rotations(23);
  for (PackedTrack& track : tracks)
    for (std::uint32_t c = 0, left = PackedTrack::kMostKeyBits; c < 4; ++c) {
      if (c == track.derived) continue;
      track.width[c] = static_cast<std::uint8_t>(std::min(left, 1 + random.below(most_bits)));
      left -= track.width[c];
      track.step[c] = 0x1p-24f;
      for (std::size_t key = 0; key < kKeys; ++key) track.numbers[key * 4 + c] = random.below(1u << track.width[c]);
    }
  return tracks;
}

TEST(packed_rows, sixteen_bytes_of_a_row_hold_a_slot_of_four_lanes) {
  test::FixedRandom random(5);
  for (std::uint32_t round = 0; round < 200; ++round) {
    const std::vector<PackedTrack> tracks = of_any_width(random, 1 + round % PackedTrack::kMostBits);
    const PackedRows rows = packed_rows(tracks, kKeys);
    for (std::size_t lane = 0; lane < tracks.size(); ++lane) {
      expect_same(packed_lane(rows, tracks.size(), lane, kKeys), tracks[lane]);
      for (std::size_t slot = 0; slot < rows.slot_count; ++slot) {
        const std::size_t at = slot * tracks.size() + lane;
        EXPECT_LE(rows.byte[at] + 4u, 16u);
        EXPECT_LT(rows.mask[at], 0x80000000u);
        EXPECT_LE(rows.first_byte[slot * 6 + lane / 4] + 16u, rows.row_bytes + kReadAhead);
      }
    }
  }
}

TEST(packed_rows, N01_P04_each_key_knows_how_far_its_rotations_turn) {
  test::FixedRandom random(6);
  for (const double step_rad : {0.01, 0.5, 3.0}) {
    std::vector<PackedTrack> tracks;
    std::vector<QuatTrack> truth;
    for (int i = 0; i < 6; ++i) {
      truth.push_back(turning(random, step_rad));
      tracks.push_back(*pack_keys(truth.back(), 1e-3));
    }
    const PackedRows rows = packed_rows(tracks, kKeys);
    for (std::size_t key = 0; key + 1 < kKeys; ++key) {
      double largest = 0.0;
      for (const QuatTrack& t : truth)
        largest = std::max(largest, 1.0 - std::abs(quat_dot(normalised(quat_cast<double>(t.values[key])),
                                                            normalised(quat_cast<double>(t.values[key + 1])))));
      EXPECT_NEAR(static_cast<int>(rows.power_at(key)), slerp_power(largest), 1) << largest;
    }
  }
}

TEST(packed_rows, P04_the_terms_of_slerp_grow_with_the_arc_between_keys) {
  const auto terms = [](double turn_deg) { return slerp_power(1.0 - std::cos(turn_deg * std::numbers::pi / 360.0)); };
  EXPECT_EQ(terms(0.0), kUsualSlerpPower);
  EXPECT_EQ(terms(30.0), kUsualSlerpPower);
  EXPECT_EQ(terms(90.0), 7u);
  EXPECT_EQ(terms(180.0), kMostSlerpPower);
  for (int degrees = 1; degrees <= 180; ++degrees) EXPECT_GE(terms(degrees), terms(degrees - 1));
}

TEST(packed_rows, N01_P04_the_series_of_slerp_is_within_half_a_step_of_float) {
  for (int i = 0; i <= 1000; ++i) {
    const double x = std::pow(i / 1000.0, 3.0), a = std::acos(1.0 - x);
    const std::size_t power = slerp_power(x);
    ASSERT_LE(power, kMostSlerpPower);
    for (const float fraction : {0.0f, 0.1f, 0.37f, 0.5f, 0.58f, 0.9f, 1.0f}) {
      const SlerpCoefficients coefficients(1.0f - fraction, fraction, power);
      double sum = 0.0;
      for (std::size_t n = power + 1; n-- > 0;) sum = sum * x + static_cast<double>(coefficients.of_power[n].end);
      const double s = static_cast<double>(fraction), expected = a < 1e-6 ? s : std::sin(s * a) / std::sin(a);
      EXPECT_NEAR(sum, expected, 0x1p-25 + 0x1p-25 * expected * 2) << x << " " << fraction;
    }
  }
}

}  // namespace
}  // namespace sinew
