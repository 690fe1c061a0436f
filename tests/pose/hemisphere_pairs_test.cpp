// SPDX-License-Identifier: MIT
#include "runtime/pose/hemisphere_pairs.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/fixed_random.h"
#include "tests/support/skinned_vertices.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {

TEST(hemisphere_pairs, N17_joints_follow_their_nearest_ancestor_in_the_skin_ancestors_first) {
  const Skeleton skeleton = skeleton_of({kNone, 0, 0, 1, 2, 3, 4, 5});
  Skin skin;
  skin.joints = {7, 3, 2, 0, 6};  // 7 < 5 < 3 < 1 < 0;  6 < 4 < 2 < 0
  std::set<std::uint16_t> placed = {3};
  for (const JointPair& edge : hemisphere_edges(skeleton, skin)) {
    EXPECT_TRUE(placed.contains(edge.first)) << edge.first;
    placed.insert(edge.second);
    const std::uint32_t above = skin.joints[edge.first], joint = skin.joints[edge.second];
    EXPECT_EQ(above, joint == 7 ? 3u : joint == 6 ? 2u : 0u) << joint;
  }
  EXPECT_EQ(placed.size(), skin.joints.size());
}

TEST(hemisphere_pairs, a_joint_that_is_listed_twice_follows_itself) {
  const Skeleton skeleton = skeleton_of({kNone, 0});
  Skin skin;
  skin.joints = {1, 0, 1};
  const std::vector<JointPair> edges = hemisphere_edges(skeleton, skin);
  ASSERT_EQ(edges.size(), 2u);
  EXPECT_EQ(edges[0].first, 1);
  EXPECT_EQ(edges[0].second, 0);
  EXPECT_EQ(edges[1].first, 0);
  EXPECT_EQ(edges[1].second, 2);
}

TEST(hemisphere_pairs, sharing_pairs_are_those_of_the_vertices_each_once) {
  FixedRandom random(5);
  const std::uint32_t counts[] = {1, 2, 4, 6};
  const SkinnedVertices s = random_skinned_vertices(random, counts, 400, 12, false);
  std::set<std::pair<int, int>> expected, found;
  for (std::size_t v = 0; v < s.positions.size(); ++v)
    for (const std::uint16_t joint : s.joints_of(v).subspan(1)) expected.insert({s.joints_of(v)[0], joint});
  const std::vector<JointPair> pairs = joint_pairs_of_vertices(s.influences, 12);
  for (const JointPair& pair : pairs) found.insert({pair.first, pair.second});
  EXPECT_EQ(found, expected);
  EXPECT_EQ(found.size(), pairs.size());
}

TEST(hemisphere_pairs, more_pairs_than_vertices_are_not_worth_looking_at) {
  FixedRandom random(6);
  const std::uint32_t eight[] = {8};
  const SkinnedVertices s = random_skinned_vertices(random, eight, 5, 40, false);
  EXPECT_TRUE(joint_pairs_of_vertices(s.influences, 40).empty());
}

}  // namespace
}  // namespace sinew::test
