// SPDX-License-Identifier: MIT
#include "runtime/compress/remove_keys.h"

#include <gtest/gtest.h>

#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

std::vector<LooseTrack> loose(std::vector<Vec3Track>& tracks) {
  std::vector<LooseTrack> out;
  for (Vec3Track& track : tracks) out.push_back({&track, 1e-6});
  return out;
}

/// A straight line, or noise.
Vec3Track track_of(bool straight, std::size_t keys, test::FixedRandom& random) {
  Vec3Track track;
  for (std::size_t k = 0; k < keys; ++k) {
    track.times_s.push_back(static_cast<float>(k));
    track.values.push_back(straight ? glm::vec3(static_cast<float>(k)) : random.vec3());
  }
  return track;
}

TEST(time_groups, tracks_that_need_few_keys_part_from_those_that_need_all) {
  test::FixedRandom random(4);
  std::vector<Vec3Track> tracks;
  for (int i = 0; i < 16; ++i) tracks.push_back(track_of(i % 2 == 0, 200, random));
  const auto parts = split_into_time_groups(loose(tracks));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].size(), 8u);
  EXPECT_EQ(keys_needed(parts[1], 200).size(), 200u);
  EXPECT_LT(keys_needed(parts[0], 200).size(), 6u);
}

TEST(time_groups, a_group_is_not_cut_for_less_than_another_group_costs) {
  test::FixedRandom random(4);
  std::vector<Vec3Track> tracks;
  for (int i = 0; i < 4; ++i) tracks.push_back(track_of(i % 2 == 0, 12, random));
  EXPECT_EQ(split_into_time_groups(loose(tracks)).size(), 1u);
}

TEST(time_groups, every_track_is_in_one_part) {
  test::FixedRandom random(6);
  std::vector<Vec3Track> tracks;
  for (int i = 0; i < 37; ++i) tracks.push_back(track_of(random.below(3) == 0, 150, random));
  std::vector<int> seen(tracks.size(), 0);
  for (const auto& part : split_into_time_groups(loose(tracks)))
    for (const LooseTrack& track : part)
      ++seen[static_cast<std::size_t>(std::get<Vec3Track*>(track.track) - tracks.data())];
  for (const int times : seen) EXPECT_EQ(times, 1);
}

}  // namespace
}  // namespace sinew
