// SPDX-License-Identifier: MIT
#include "runtime/paging/cut_clip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/paging/join_clips.h"
#include "tests/clip/varied_clip.h"
#include "tests/paging/pages.h"

namespace sinew {
namespace {

using test::numbers_at;
using test::varied_clip;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool same_at(const Clip& a, const Clip& b, double time_s) {
  return same_bits<float>(numbers_at(a, time_s), numbers_at(b, time_s));
}

/// All key times of a clip, and times between, before and after them.
std::vector<double> times_around(const Clip& clip) {
  std::vector<double> times{-1.0, 0.0, clip.duration_s(), clip.duration_s() + 1.0};
  for (const TimeGroup& group : clip.layout().groups)
    for (const float t : group.times.times_s())
      for (const double side : {-kInfinity, 0.0, kInfinity})
        times.push_back(std::nextafter(static_cast<double>(t), static_cast<double>(t) + side));
  for (double t = 0.01; t < clip.duration_s(); t += 0.09) times.push_back(t);
  return times;
}

/// A clip with two keys at one time, where the value jumps, and with tracks that begin late and end early.
Clip jumping_clip() {
  test::FixedRandom random(3);
  const std::vector<float> jump{0.0f, 1.0f, 1.0f, 2.0f, 2.0f, 2.0f, 3.0f}, late{2.5f, 3.0f}, early{0.0f, 0.25f};
  return test::clip_of(
      test::animation_of({{.joint = 0, .translation = test::random_vectors(random, Interpolation::linear, jump)},
                          {.joint = 1, .rotation = test::random_rotations(random, Interpolation::linear, late)},
                          {.joint = 2, .scale = test::random_vectors(random, Interpolation::step, early)}}),
      test::chain_skeleton(3));
}

TEST(cut_clip, a_part_samples_the_bits_of_the_whole_at_all_of_its_times) {
  for (const Clip& whole : {varied_clip(1), varied_clip(2), varied_clip(3), jumping_clip()}) {
    const std::vector<double> times = times_around(whole);
    for (const double first_s : times)
      for (const double last_s : {first_s, first_s + 0.3, first_s + 2.0, kInfinity}) {
        const Clip part = cut_clip(whole, first_s, last_s);
        for (const double t : times) {
          if (t < first_s || t > last_s) continue;
          ASSERT_TRUE(same_at(part, whole, t))
              << whole.name() << " from " << first_s << " to " << last_s << " at " << t;
        }
      }
  }
}

TEST(cut_clip, a_part_has_the_keys_around_its_times_and_no_others) {
  const Clip whole = jumping_clip();
  const auto keys_of = [&](double first_s, double last_s) {
    std::vector<std::size_t> counts;
    const Clip part = cut_clip(whole, first_s, last_s);
    for (const TimeGroup& group : part.layout().groups) counts.push_back(group.times.key_count());
    return counts;  // key counts of joints 0, 1 and 2
  };
  using Counts = std::vector<std::size_t>;
  EXPECT_EQ(keys_of(0.0, 0.0), (Counts{1, 1, 1}));
  EXPECT_EQ(keys_of(0.0, 0.5), (Counts{2, 1, 2})) << "the first of two keys at 1 s is enough";
  EXPECT_EQ(keys_of(0.0, 1.0), (Counts{3, 1, 2})) << "at 1 s the last of them counts";
  EXPECT_EQ(keys_of(1.0, 1.5), (Counts{2, 1, 1}));
  EXPECT_EQ(keys_of(2.0, 2.75), (Counts{2, 2, 1}));
  EXPECT_EQ(keys_of(-kInfinity, kInfinity), (Counts{7, 2, 2}));
}

TEST(cut_clip, a_part_keeps_name_duration_and_certificate_and_shares_what_rests) {
  const Clip whole = varied_clip(4), part = cut_clip(whole, 1.0, 2.0);
  EXPECT_EQ(part.name(), whole.name());
  EXPECT_EQ(part.duration_s(), whole.duration_s());
  EXPECT_EQ(part.certificate(), whole.certificate());
  EXPECT_EQ(part.layout().base_pose.rest(), whole.layout().base_pose.rest());
  EXPECT_EQ(part.counts().rotations, whole.counts().rotations);
}

/// sample_clip reads vectors past the last lane of a key.
TEST(cut_clip, rows_of_a_part_end_with_the_room_that_lanes_read) {
  const Clip part = cut_clip(varied_clip(1), 1.0, 2.0);
  std::size_t packed = 0, full = 0;
  for (const TimeGroup& group : part.layout().groups)
    for (const TrackBlock& block : group.blocks) {
      const std::size_t keys = group.times.key_count();
      ++(block.packed.empty() ? full : packed);
      if (block.packed.empty()) {
        ASSERT_EQ(block.rows.size(), keys * block.plane_count * block.lane_count + kLanePadding);
        EXPECT_EQ(block.rows.back(), 0.0f);
      } else {
        ASSERT_EQ(block.packed.bits.size(), keys * block.packed.row_bytes + kReadAhead);
        EXPECT_EQ(block.packed.bits.back(), 0);
      }
    }
  EXPECT_GT(packed, 0u);
  EXPECT_GT(full, 0u);
}

TEST(cut_clip, first_keys_have_one_key_a_track_and_the_pose_at_the_start) {
  const Clip whole = varied_clip(5), head = first_keys(whole);
  for (const TimeGroup& group : head.layout().groups) EXPECT_EQ(group.times.key_count(), 1u);
  EXPECT_TRUE(same_at(head, whole, 0.0));
  EXPECT_TRUE(same_at(head, head, 3.0));
  EXPECT_EQ(head.duration_s(), whole.duration_s());
}

Clip joined(const Clip& whole, double page_s) {
  ClipJoiner joiner(first_keys(whole));
  for (const std::vector<std::byte>& page : test::pages_of(whole, page_s))
    EXPECT_TRUE(joiner.add(load_clips(page)->front()));
  return joiner.clip();
}

TEST(join_clips, pages_together_are_the_clip_that_was_cut_byte_for_byte) {
  for (const Clip& whole : {varied_clip(1), varied_clip(6), jumping_clip()})
    for (const double page_s : {0.1, 0.25, 0.5, 1.0, 1.7, 4.0, 100.0}) {
      const Clip again = joined(whole, page_s);
      const Clip *const before[] = {&whole}, *const after[] = {&again};
      EXPECT_EQ(save_clips(after), save_clips(before)) << page_s;
      for (const double t : times_around(whole)) ASSERT_TRUE(same_at(again, whole, t)) << page_s << " at " << t;
    }
}

/// The rotation turns far from key to key in only one part of the clip.
TEST(join_clips, wide_turns_of_packed_rotations_keep_their_bits_across_pages) {
  QuatTrack track{Interpolation::linear, {}, {}};
  for (int k = 0; k < 40; ++k) {
    track.times_s.push_back(0.1f * static_cast<float>(k));
    const double angle = k < 20 ? 0.01 * k : 1.4 * k;
    track.values.push_back(glm::angleAxis(static_cast<float>(angle), glm::vec3(0, 1, 0)));
  }
  Animation animation = test::animation_of({{.joint = 0, .rotation = track}});
  animation.duration_s = 3.9;
  KeyTolerances rounding;
  rounding.bones = {{.rotation = 1e-3}};
  const Clip whole = compile_clip(animation, test::chain_skeleton(1), {}, std::vector<std::uint32_t>{0}, {}, rounding);
  ASSERT_GT(whole.layout().groups[0].blocks[0].packed.power.size(), 1u);
  const Clip again = joined(whole, 0.5);
  for (double t = 0.0; t < 4.0; t += 0.013) ASSERT_TRUE(same_at(again, whole, t)) << t;
  for (std::size_t page = 0; page < page_count_of(3.9, 0.5); ++page) {
    const Clip cut = cut_page(whole, 0.5, page);
    const PageTimes times = times_of_page(page, 0.5, page_count_of(3.9, 0.5));
    for (double t = 0.0; t < 4.0; t += 0.013) {
      ASSERT_TRUE(times.nearest(t) != t || same_at(cut, whole, t)) << t;
    }
  }
}

TEST(join_clips, what_does_not_continue_the_clip_is_refused) {
  const Clip whole = varied_clip(7), other = varied_clip(8);
  const auto adds = [&](std::initializer_list<Clip> parts) {
    ClipJoiner joiner(first_keys(whole));
    bool all = true;
    for (const Clip& part : parts) all = all && joiner.add(part);
    return all;
  };
  EXPECT_TRUE(adds({cut_clip(whole, 0.0, 1.0), cut_clip(whole, 1.0, 4.0)}));
  EXPECT_FALSE(adds({cut_clip(whole, 0.0, 0.5), cut_clip(whole, 3.5, 4.0)})) << "a gap";
  EXPECT_FALSE(adds({cut_clip(other, 0.0, 4.0)})) << "other tracks";
  EXPECT_FALSE(moves_alike(whole, other));
  EXPECT_TRUE(moves_alike(whole, cut_clip(whole, 2.0, 2.5)));
}

/// A clip with one joint, whose only track has two keys.
Clip clip_with(Vec3Track BoneAnimation::*part, Interpolation interpolation, float second, double tolerance = 0.0) {
  BoneAnimation bone;
  (bone.*part) = {interpolation, {0.0f, 1.0f}, {glm::vec3(0.0f), glm::vec3(second)}};
  KeyTolerances rounding;
  rounding.bones = {{.translation = tolerance, .scale = tolerance}};
  return compile_clip(test::animation_of({bone}), test::chain_skeleton(1), {}, std::vector<std::uint32_t>{0}, {},
                      rounding);
}

TEST(join_clips, clips_move_alike_when_their_tracks_are_of_the_same_kinds_and_ranges) {
  const auto translation = &BoneAnimation::translation, scale = &BoneAnimation::scale;
  const Clip clip = clip_with(translation, Interpolation::linear, 1.0f);
  EXPECT_TRUE(moves_alike(clip, clip_with(translation, Interpolation::linear, 2.0f)));
  EXPECT_FALSE(moves_alike(clip, clip_with(translation, Interpolation::step, 1.0f)));
  EXPECT_FALSE(moves_alike(clip, clip_with(scale, Interpolation::linear, 1.0f)));
  EXPECT_FALSE(moves_alike(clip, clip_with(translation, Interpolation::linear, 1.0f, 0.01))) << "packed";
  const Clip packed = clip_with(translation, Interpolation::linear, 1.0f, 0.01);
  EXPECT_TRUE(moves_alike(packed, packed));
  EXPECT_FALSE(moves_alike(packed, clip_with(translation, Interpolation::linear, 2.0f, 0.02)))
      << "as wide, other steps";
  EXPECT_FALSE(moves_alike(packed, clip_with(translation, Interpolation::linear, 8.0f, 0.01))) << "wider";
  EXPECT_FALSE(moves_alike(clip, test::clip_of({}, test::chain_skeleton(1))));
}

TEST(join_clips, packed_rotations_that_leave_out_other_components_do_not_move_alike) {
  const auto clip = [](std::uint8_t derived) {
    PackedTrack track{.components = 4, .derived = derived};
    track.numbers.assign(8, 0);
    ClipLayout layout = test::clip_of({}, test::chain_skeleton(1)).layout();
    TrackBlock block = block_of(Property::rotation, Interpolation::linear, 1);
    block.targets = {0};
    block.places = JointPlaces(block.targets);
    block.packed = packed_rows({&track, 1}, 2);
    layout.groups.push_back({KeyTimes(std::vector<float>{0.0f, 1.0f}), {block}});
    return clip_of(layout);
  };
  for (std::uint8_t derived = 0; derived < 4; ++derived)
    for (std::uint8_t other = 0; other < 4; ++other)
      EXPECT_EQ(moves_alike(clip(derived), clip(other)), derived == other) << int{derived} << int{other};
}

TEST(join_clips, clips_that_rest_otherwise_do_not_move_alike) {
  Skeleton bent = test::chain_skeleton(3);
  const Clip straight = test::clip_of({}, bent);
  bent.rest[2].scale.y = 2.0f;
  EXPECT_FALSE(moves_alike(straight, test::clip_of({}, bent)));
  BoneAnimation turn{.joint = 2};
  turn.rotation = {Interpolation::linear, {0.0f, 1.0f}, {glm::quat(1, 0, 0, 0), glm::quat(0, 1, 0, 0)}};
  const Animation turning = test::animation_of({turn});
  for (const int axis : {0, 1, 2}) {
    Skeleton wide = test::chain_skeleton(3), moved = wide;
    wide.rest[2].scale[axis] = 2.0f;
    moved.rest[2].translation[axis] += 1.0f;
    for (const Skeleton& other : {wide, moved})
      EXPECT_FALSE(moves_alike(test::clip_of(turning, test::chain_skeleton(3)), test::clip_of(turning, other)))
          << "what a track of another property leaves to the rest";
  }
  const std::vector<std::uint32_t> first{0, 1};
  const auto with_weight = [&](float rest) {
    return compile_clip({}, test::chain_skeleton(3), std::vector<float>{rest}, first);
  };
  EXPECT_TRUE(moves_alike(with_weight(0.5f), with_weight(0.5f)));
  EXPECT_FALSE(moves_alike(with_weight(0.5f), with_weight(0.25f)));
  const auto with_property = [&](float rest) {
    const PropertyTable table{{{{PropertyKind::roughness, 0}, 0, 1}}, {rest}};
    return compile_clip({}, test::chain_skeleton(3), {}, {}, table);
  };
  EXPECT_TRUE(moves_alike(with_property(0.5f), with_property(0.5f)));
  EXPECT_FALSE(moves_alike(with_property(0.5f), with_property(0.25f)));
}

}  // namespace
}  // namespace sinew
