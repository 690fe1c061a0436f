// SPDX-License-Identifier: MIT
#include "runtime/c/detail_map.h"

#include <gtest/gtest.h>

#include <vector>

#include "runtime/c/handles.h"
#include "runtime/retarget/detail_map.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {

/// A chain of five joints, one metre each, and two bodies at its ends.
struct Bodies {
  sinew_scene coarse, fine;
  sinew_detail_map* map = nullptr;
  PoseBuffer pose{5};
  std::vector<std::uint64_t> scratch;

  Bodies() {
    coarse.scene.skeleton = chain_skeleton(2);
    coarse.scene.skeleton.rest[1].translation.y = 4.0f;
    fine.scene.skeleton = chain_skeleton(5);
    for (std::size_t j = 1; j < 5; ++j) fine.scene.skeleton.rest[j].translation.y = 1.0f;
    for (std::size_t j = 0; j < 5; ++j) pose.span().set(j, fine.scene.skeleton.rest[j]);
    const sinew_joint_pair pairs[] = {{0, 0}, {1, 4}};
    EXPECT_EQ(sinew_detail_map_create(&coarse, &fine, pairs, 2, &map), SINEW_OK);
    scratch.resize(sinew_detail_map_scratch(map) / sizeof(std::uint64_t));
  }
  ~Bodies() { sinew_detail_map_destroy(map); }

  sinew_pose local() { return {pose.span().planes, 5}; }
  sinew_error move(const std::vector<sinew_affine>& bodies, int keep_lengths = 0) {
    const sinew_pose pose_of_c = local();
    return sinew_fine_from_coarse(map, bodies.data(), bodies.size(), &pose_of_c, scratch.data(),
                                  scratch.size() * sizeof(std::uint64_t), keep_lengths);
  }
};

sinew_affine at(float x, float y) { return {{{1, 0, 0, x}, {0, 1, 0, y}, {0, 0, 1, 0}}}; }

TEST(c_detail_map, moves_a_character_to_its_bodies_and_back) {
  Bodies ragdoll;
  ASSERT_EQ(ragdoll.move({at(1, 0), at(1, 5)}), SINEW_OK);
  EXPECT_EQ(ragdoll.pose.span().get(0).translation.x, 1.0f);
  EXPECT_EQ(ragdoll.pose.span().get(4).translation.y, 2.0f) << "the last bone stretches";
  std::vector<sinew_affine> model = {at(0, 0), at(0, 1), at(0, 2), at(0, 3), at(7, 4)}, bodies(2);
  ASSERT_EQ(sinew_coarse_from_fine(ragdoll.map, model.data(), 5, bodies.data(), 2), SINEW_OK);
  EXPECT_EQ(bodies[1].row[0][3], 7.0f);
  EXPECT_EQ(bodies[1].row[1][3], 4.0f);
}

TEST(c_detail_map, keeps_lengths_where_asked) {
  Bodies ragdoll;
  ASSERT_EQ(ragdoll.move({at(1, 0), at(1, 5)}, 1), SINEW_OK);
  EXPECT_EQ(ragdoll.pose.span().get(4).translation.y, 1.0f);
}

TEST(c_detail_map, refuses_nulls_sizes_and_wrong_pairs) {
  Bodies ragdoll;
  sinew_detail_map* map = nullptr;
  const sinew_joint_pair twice[] = {{0, 0}, {0, 1}}, beyond[] = {{0, 5}};
  EXPECT_EQ(sinew_detail_map_create(nullptr, &ragdoll.fine, nullptr, 0, &map), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_detail_map_create(&ragdoll.coarse, &ragdoll.fine, nullptr, 1, &map), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_detail_map_create(&ragdoll.coarse, &ragdoll.fine, twice, 2, &map), SINEW_UNSUPPORTED);
  EXPECT_EQ(sinew_detail_map_create(&ragdoll.coarse, &ragdoll.fine, beyond, 1, &map), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(map, nullptr);
  EXPECT_EQ(ragdoll.move({at(0, 0)}), SINEW_SIZE_MISMATCH);
  EXPECT_EQ(ragdoll.move({at(0, 0), at(NAN, 0)}), SINEW_NOT_FINITE);
  ragdoll.scratch.pop_back();
  EXPECT_EQ(ragdoll.move({at(0, 0), at(0, 4)}), SINEW_SIZE_MISMATCH);
  EXPECT_EQ(sinew_detail_map_scratch(nullptr), 0u);
  EXPECT_EQ(sinew_coarse_from_fine(nullptr, nullptr, 0, nullptr, 0), SINEW_NULL_ARGUMENT);
}

}  // namespace
}  // namespace sinew::test
