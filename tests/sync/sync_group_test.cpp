// SPDX-License-Identifier: MIT
#include "runtime/sync/sync_group.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "runtime/sync/common_beats.h"
#include "tests/reference/sync.h"
#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

using test::FixedRandom;

enum Foot : std::uint32_t { left, right };
enum Hoof : std::uint32_t { hind_left, fore_left, hind_right, fore_right };

constexpr SyncBeat kWalk[] = {{0.1, left}, {0.55, right}}, kRun[] = {{0.0, right}, {0.5, left}};
constexpr SyncBeat kThree[] = {{0.0, 5}, {0.3, 6}, {0.7, 7}};

double beats_of(const BeatPlace& place) { return static_cast<double>(place.beat) + place.share; }

TEST(sync_group, members_of_two_and_three_beats_meet_after_six) {
  const SyncMember group[] = {{{kWalk, 1.0}}, {{kThree, 0.6}}};
  EXPECT_EQ(common_segments(group), 6u);
  EXPECT_DOUBLE_EQ(common_length_s(group), 0.5 * (3 * 1.0 + 2 * 0.6));
  EXPECT_EQ(cycle_place(group[0], {6, 0.0}), (CyclePlace{3, 0.1}));
  EXPECT_EQ(cycle_place(group[1], {6, 0.0}), (CyclePlace{2, 0.0}));
}

TEST(sync_group, the_length_is_the_weighted_mean_of_the_scaled_lengths) {
  const SyncMember group[] = {{{kWalk, 1.0}, 0.25}, {{kRun, 0.6}, 0.75}};
  EXPECT_DOUBLE_EQ(common_length_s(group), 0.25 * 1.0 + 0.75 * 0.6);
  const SyncMember unweighted[] = {{{kWalk, 1.0}, 0.0}, {{kRun, 0.6}, 0.0}};
  EXPECT_DOUBLE_EQ(common_length_s(unweighted), 0.8);
  EXPECT_EQ(common_length_s({}), 0.0);
  EXPECT_EQ(advance({}, {3, 0.5}, 1.0), (BeatPlace{3, 0.5}));
}

TEST(sync_group, time_leads_where_the_sum_of_all_segments_says) {
  FixedRandom random(2);
  for (int i = 0; i < 500; ++i) {
    std::vector<std::vector<SyncBeat>> beats(1 + random.below(3));
    std::vector<SyncMember> group;
    for (auto& of : beats) {
      const std::uint32_t count = random.below(5);
      for (std::uint32_t b = 0; b < count; ++b) of.push_back({(b + random.in(0.05, 0.95)) / count, b});
      const double length_s = random.in(0.2, 2.0), weight = random.in(0.1, 1.0);
      group.push_back({{of, length_s}, weight, count == 0 ? 0 : random.below(count)});
    }
    ASSERT_EQ(check(group), ErrorCode::ok);
    const double time_s = random.in(-20.0, 20.0);
    EXPECT_NEAR(beats_of(advance(group, {}, time_s)), reference::beats_after(group, time_s), 1e-11) << i;
  }
}

TEST(sync_group, it_does_not_matter_how_time_is_cut) {
  const SyncMember group[] = {{{kWalk, 1.1}, 0.3}, {{kThree, 0.7}, 0.7}};
  for (const double total_s : {1.0, 10.0, -10.0}) {
    BeatPlace place{2, 0.25};
    for (int i = 0; i < 1000; ++i) place = advance(group, place, total_s / 1000);
    EXPECT_NEAR(beats_of(place), beats_of(advance(group, {2, 0.25}, total_s)), 1e-10) << total_s;
  }
  EXPECT_EQ(advance(group, {2, 0.25}, 0.0), (BeatPlace{2, 0.25}));
}

TEST(sync_group, feet_of_the_same_name_meet_also_mirrored) {
  SyncMember group[] = {{{kWalk, 1.0}}, {{kRun, 0.6}}};
  align_names(group);
  EXPECT_EQ(group[1].first_beat, 1u) << "the run begins with the other foot";
  EXPECT_EQ(cycle_place(group[1], {0, 0.0}), (CyclePlace{0, 0.5}));
  const std::uint32_t exchanged[] = {right, left};
  group[1].track.mirrored_names = exchanged;
  align_names(group);
  EXPECT_EQ(group[1].first_beat, 0u);
}

constexpr SyncBeat kPace[] = {{0.0, hind_left}, {0.25, fore_left}, {0.5, hind_right}, {0.75, fore_right}};
constexpr SyncBeat kGallop[] = {{0.1, fore_right}, {0.4, hind_left}, {0.5, hind_right}, {0.9, fore_left}};
constexpr SyncBeat kTrot[] = {{0.2, hind_right}, {0.7, hind_left}};  // pairs across, named by their hind feet

TEST(sync_group, gaits_of_four_beats_meet_in_as_many_feet_as_their_orders_allow) {
  SyncMember group[] = {{{kPace, 1.2}}, {{kGallop, 0.5}}};
  align_names(group);
  EXPECT_EQ(group[1].first_beat, 1u) << "hind left and fore right meet, the other two cannot";
  EXPECT_EQ(name_of_beat(group[1].track, 3 + group[1].first_beat), fore_right);
  EXPECT_EQ(common_segments(group), 4u);
  EXPECT_DOUBLE_EQ(common_length_s(group), (1.2 + 0.5) / 2);
  for (int k = 0; k < 4; ++k) {
    const CyclePlace at = cycle_place(group[0], advance(group, {k, 0.0}, common_length_s(group)));
    EXPECT_NEAR(static_cast<double>(at.round) + at.phase, 1.0 + 0.25 * k, 1e-12);
  }
}

TEST(sync_group, gaits_of_other_orders_and_numbers_of_feet_are_reduced_to_what_all_have) {
  std::uint32_t kept[2];
  const SyncTrack walk_and_gallop[] = {{kPace}, {kGallop}};
  EXPECT_EQ(find_common_beats(walk_and_gallop, kept), 3u);
  EXPECT_EQ(kept[0], 0b1011u) << "hind left, fore left, fore right";
  EXPECT_EQ(kept[1], 0b1011u);
  const SyncTrack walk_and_trot[] = {{kPace}, {kTrot}};
  EXPECT_EQ(find_common_beats(walk_and_trot, kept), 2u) << "or a walk would last as long as two trots";
  EXPECT_EQ(kept[0], 0b0101u);
  EXPECT_EQ(kept[1], 0b11u);
  const SyncTrack strangers[] = {{kTrot}, {kThree}};
  EXPECT_EQ(find_common_beats(strangers, kept), 0u);
  EXPECT_EQ(find_common_beats({}, {}), 0u);
}

TEST(sync_group, a_motion_that_begins_starts_by_phase_beat_or_time_left) {
  const SyncTrack walk{kWalk, 1.0}, run{kRun, 0.6};
  const CyclePlace place{7, 0.325};  // half of the beat of the left foot
  EXPECT_EQ(start_place(walk, place, run, SyncStart::phase), (CyclePlace{0, 0.325}));
  EXPECT_NEAR(start_place(walk, place, run, SyncStart::beat).phase, 0.75, 1e-15) << "half of the run's left foot";
  EXPECT_NEAR(start_place(walk, {7, 0.7}, run, SyncStart::time_left).phase, 0.5, 1e-15) << "0.3 s are left";
  EXPECT_EQ(start_place(walk, {7, 0.1}, run, SyncStart::time_left), (CyclePlace{0, 0.0})) << "0.9 s are too many";
  EXPECT_NEAR(start_place(walk, place, SyncTrack{kThree}, SyncStart::beat).phase, 0.15, 1e-15) << "by index";
  EXPECT_NEAR(start_place(walk, {0, 0.0}, {}, SyncStart::beat).phase, 0.45 / 0.55, 1e-15);
}

TEST(sync_group, bad_groups_are_refused) {
  SyncMember member{{kWalk, 1.0}};
  const auto code = [&] { return check(SyncGroup(&member, 1)); };
  EXPECT_EQ(code(), ErrorCode::ok);
  member.first_beat = 2;
  EXPECT_EQ(code(), ErrorCode::index_out_of_range);
  member = {{kWalk, 1.0}, -1.0};
  EXPECT_EQ(code(), ErrorCode::negative_weight);
  member.weight = INFINITY;
  EXPECT_EQ(code(), ErrorCode::not_finite);
  member = {{kWalk, -1.0}};
  EXPECT_EQ(code(), ErrorCode::not_a_fraction);
  std::vector<SyncBeat> a, b;
  for (int i = 0; i < 97; ++i) a.push_back({i / 97.0, 0});
  for (int i = 0; i < 89; ++i) b.push_back({i / 89.0, 0});
  const SyncMember primes[] = {{{a}}, {{b}}};
  EXPECT_EQ(common_segments(primes), 0u);
  EXPECT_EQ(check(SyncGroup(primes)), ErrorCode::too_large);
}

}  // namespace
}  // namespace sinew
