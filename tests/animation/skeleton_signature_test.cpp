// SPDX-License-Identifier: MIT
#include "runtime/animation/skeleton_signature.h"

#include <gtest/gtest.h>

#include <span>
#include <utility>

#include "runtime/base/checksum.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

/// A hip with an arm and a leg; the arm has a hand.
Skeleton body() {
  Skeleton s = test::skeleton_of({kNone, 0, 0, 1});
  s.names = {"hip", "arm", "leg", "hand"};
  return s;
}

TEST(skeleton_signature, another_name_parent_or_order_changes_it) {
  const std::uint64_t signature = skeleton_signature(body());
  Skeleton renamed = body();
  renamed.names[3] = "Hand";
  EXPECT_NE(skeleton_signature(renamed), signature);

  Skeleton hung_elsewhere = body();
  hung_elsewhere.parents[3] = 2;
  EXPECT_NE(skeleton_signature(hung_elsewhere), signature);

  Skeleton reordered = body();  // the same tree, but clips name joints by index
  std::swap(reordered.names[1], reordered.names[2]);
  reordered.parents[3] = 2;
  EXPECT_NE(skeleton_signature(reordered), signature);

  Skeleton longer = test::skeleton_of({kNone, 0, 0, 1, 1});
  longer.names = {"hip", "arm", "leg", "hand", ""};
  EXPECT_NE(skeleton_signature(longer), signature);
}

TEST(skeleton_signature, letters_that_go_over_to_the_next_name_change_it) {
  Skeleton a = test::chain_skeleton(2), b = a;
  a.names = {"ab", "c"};
  b.names = {"a", "bc"};
  EXPECT_NE(skeleton_signature(a), skeleton_signature(b));
}

TEST(skeleton_signature, another_rest_pose_or_order_of_nodes_does_not_change_it) {
  Skeleton s = body();
  const std::uint64_t signature = skeleton_signature(s);
  s.rest[2].translation = {1, 2, 3};
  s.rest[3].scale = glm::vec3(2.0f);
  s.fixed_matrices.push_back(Affine{});
  s.fixed_matrix_of[1] = 0;
  std::swap(s.node_of_joint[0], s.node_of_joint[3]);
  std::swap(s.joint_of_node[0], s.joint_of_node[3]);
  EXPECT_EQ(skeleton_signature(s), signature);
}

TEST(skeleton_signature, it_is_the_checksum_of_the_bytes_that_the_header_names) {
  Skeleton s = test::chain_skeleton(2);
  s.names = {"hip", "\xc3\xa9"};
  constexpr unsigned char kBytes[] = {2,   0,   0,   0,                                // number of joints
                                      255, 255, 255, 255, 3, 0, 0, 0, 'h',  'i', 'p',  // a root
                                      0,   0,   0,   0,   2, 0, 0, 0, 0xc3, 0xa9};     // under joint 0
  EXPECT_EQ(skeleton_signature(s), checksum(std::as_bytes(std::span(kBytes))));
}

TEST(skeleton_signature, stored_values_stay_as_they_are) {
  EXPECT_EQ(skeleton_signature(Skeleton{}), 5238470482016868669u);
  EXPECT_EQ(skeleton_signature(body()), 13716791534118496493u);
}

TEST(skeleton_signature, a_skeleton_without_names_has_one_of_empty_names) {
  Skeleton unnamed = body();
  unnamed.names.assign(4, "");
  const std::uint64_t signature = skeleton_signature(unnamed);
  unnamed.names.clear();
  EXPECT_EQ(skeleton_signature(unnamed), signature);
}

}  // namespace
}  // namespace sinew
