// SPDX-License-Identifier: MIT
#include "runtime/sync/sync_track.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

using test::FixedRandom;

std::vector<SyncBeat> random_beats(FixedRandom& random, std::uint32_t count) {
  std::vector<SyncBeat> beats;
  for (std::uint32_t b = 0; b < count; ++b) beats.push_back({(b + random.in(0.05, 0.95)) / count, random.below(4)});
  return beats;
}

TEST(sync_track, places_in_cycles_and_beats_are_each_others_inverse_over_any_number_of_rounds) {
  FixedRandom random(1);
  for (int i = 0; i < 2000; ++i) {
    const std::vector<SyncBeat> beats = random_beats(random, random.below(6));
    const SyncTrack track{beats, 0.8};
    const std::int64_t round = std::int64_t{random.below(1u << 30)} * 1024 - (std::int64_t{1} << 39);
    const CyclePlace place{round, random.unit()};
    const BeatPlace beat = beat_place(track, place);
    EXPECT_GE(beat.share, 0.0);
    EXPECT_LT(beat.share, 1.0);
    const CyclePlace again = cycle_place(track, beat);
    const double off = static_cast<double>(again.round - place.round) + (again.phase - place.phase);
    EXPECT_NEAR(off, 0.0, 4e-16);
  }
}

TEST(sync_track, a_beat_begins_at_its_phase_and_lasts_to_the_next_one) {
  const SyncBeat beats[] = {{0.25, 7}, {0.5, 8}};
  const SyncTrack track{beats};
  EXPECT_EQ(beat_place(track, {0, 0.25}), (BeatPlace{0, 0.0}));
  EXPECT_EQ(beat_place(track, {0, 0.375}), (BeatPlace{0, 0.5}));
  EXPECT_EQ(beat_place(track, {0, 0.5}), (BeatPlace{1, 0.0}));
  EXPECT_EQ(beat_place(track, {3, 0.5}), (BeatPlace{7, 0.0}));
  EXPECT_EQ(beat_place(track, {1, 0.0}), (BeatPlace{1, 0.5 / 0.75})) << "the last beat reaches into the next round";
  EXPECT_EQ(cycle_place(track, {-1, 0.0}), (CyclePlace{-1, 0.5}));
  EXPECT_EQ(beat_length(track, 0), 0.25);
  EXPECT_EQ(beat_length(track, -1), 0.75);
}

TEST(sync_track, without_beats_the_cycle_is_one) {
  EXPECT_EQ(beat_count({}), 1u);
  EXPECT_EQ(beat_place({}, {5, 0.25}), (BeatPlace{5, 0.25}));
  EXPECT_EQ(cycle_place(SyncTrack{}, {-2, 0.75}), (CyclePlace{-2, 0.75}));
}

TEST(sync_track, names_of_a_mirrored_motion_are_exchanged) {
  const SyncBeat beats[] = {{0.0, 0}, {0.5, 1}};
  const std::uint32_t exchanged[] = {1, 0};
  const SyncTrack mirrored{beats, 1.0, exchanged};
  EXPECT_EQ(name_of_beat(mirrored, 0), 1u);
  EXPECT_EQ(name_of_beat(mirrored, -1), 0u);
}

TEST(sync_track, bad_numbers_are_refused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto code = [](std::vector<SyncBeat> beats, double length_s = 1.0) {
    return check(SyncTrack{beats, length_s});
  };
  EXPECT_EQ(code({{0.0, 0}, {0.5, 1}}), ErrorCode::ok);
  EXPECT_EQ(code({{0.5, 0}, {0.5, 1}}), ErrorCode::times_not_increasing);
  EXPECT_EQ(code({{1.0, 0}}), ErrorCode::times_not_increasing);
  EXPECT_EQ(code({{-0.1, 0}}), ErrorCode::times_not_increasing);
  EXPECT_EQ(code({{nan, 0}}), ErrorCode::not_finite);
  EXPECT_EQ(code({}, 0.0), ErrorCode::not_a_fraction);
  EXPECT_EQ(code({}, nan), ErrorCode::not_finite);
  const SyncBeat beats[] = {{0.0, 2}};
  const std::uint32_t names[] = {1, 0};
  EXPECT_EQ(check(SyncTrack{beats, 1.0, names}), ErrorCode::index_out_of_range);
}

}  // namespace
}  // namespace sinew
