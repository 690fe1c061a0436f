// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/springs/spring_stage.h"

namespace sinew {
namespace {

using test::HangingChain;

struct Misuse {
  const char* text;
  ErrorCode code;
  std::function<void(HangingChain&, SpringSettings&)> change;
};

TEST(compile_springs, names_the_entry_and_the_rule) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Misuse cases[] = {
      {"joints[1]: the skeleton has no such joint", ErrorCode::index_out_of_range,
       [](auto& c, auto&) { c.setup.joints[1].joint = 99; }},
      {"joints[2]: another entry has the same joint", ErrorCode::index_out_of_range,
       [](auto& c, auto&) { c.setup.joints[2].joint = 1; }},
      {"joints[0]: there is no such group", ErrorCode::index_out_of_range,
       [](auto& c, auto&) { c.setup.joints[0].group = 1; }},
      {"joints[0]: its tail is no usable position", ErrorCode::not_finite,
       [&](auto& c, auto&) { c.setup.joints[0].tail_m.y = nan; }},
      {"joints[3]: its stiffness is no usable number", ErrorCode::too_large,
       [](auto& c, auto&) { c.setup.joints[3].stiffness = 1e30; }},
      {"joints[0]: its gravity is no usable vector", ErrorCode::not_finite,
       [&](auto& c, auto&) { c.setup.joints[0].gravity_m_s.x = nan; }},
      {"joints[0]: its hit radius is no length", ErrorCode::negative_weight,
       [](auto& c, auto&) { c.setup.joints[0].hit_radius_m = -1.0; }},
      {"joints[0]: its drag is not between 0 and 1", ErrorCode::not_a_fraction,
       [](auto& c, auto&) { c.setup.joints[0].drag = 1.5; }},
      {"joints[0]: its drag is not between 0 and 1", ErrorCode::not_a_fraction,
       [&](auto& c, auto&) { c.setup.joints[0].drag = nan; }},
      {"joints[0]: it has a fixed matrix, so its rotation cannot change", ErrorCode::unsupported,
       [](auto& c, auto&) {
         c.skeleton.fixed_matrices.resize(1);
         c.skeleton.fixed_matrix_of[1] = 0;
       }},
      {"groups[0]: the skeleton has no such centre", ErrorCode::index_out_of_range,
       [](auto& c, auto&) { c.setup.groups[0].center = 99; }},
      {"groups[0]: there is no such collider", ErrorCode::index_out_of_range,
       [](auto& c, auto&) { c.setup.groups[0].colliders = {0}; }},
      {"colliders[0]: the skeleton has no such joint", ErrorCode::index_out_of_range,
       [](auto& c, auto&) { c.setup.colliders.push_back({}); }},
      {"colliders[0]: its radius is no length", ErrorCode::negative_weight,
       [](auto& c, auto&) { c.setup.colliders.push_back({.joint = 0, .radius_m = -1.0}); }},
      {"settings: a tick takes a millionth of a second or more", ErrorCode::unsupported,
       [](auto&, auto& s) { s.tick_s = 0.0; }},
      {"settings: a frame may take one tick or more", ErrorCode::unsupported, [](auto&, auto& s) { s.max_ticks = 0; }},
  };
  for (const Misuse& misuse : cases) {
    HangingChain chain;
    SpringSettings settings;
    misuse.change(chain, settings);
    const auto made = compile_springs(chain.skeleton, chain.setup, settings);
    ASSERT_FALSE(made) << misuse.text;
    EXPECT_EQ(made.error().text, misuse.text);
    EXPECT_EQ(made.error().code, misuse.code) << misuse.text;
  }
}

TEST(compile_springs, joints_between_two_that_swing_are_carried) {
  HangingChain chain;
  chain.setup.joints.erase(chain.setup.joints.begin() + 1);
  const Springs springs = compile_springs(chain.skeleton, chain.setup).value();
  EXPECT_EQ(springs.joint_count(), 3u);
  ASSERT_EQ(springs.tables().records.size(), 4u);
  EXPECT_EQ(springs.tables().records[1].group, kNone);
  EXPECT_EQ(springs.tables().records[2].parent, 1u);
}

TEST(compile_springs, no_springs_are_no_work) {
  const HangingChain chain;
  test::SpringStage stage(chain.skeleton, {});
  stage.frame(0.1);
  EXPECT_EQ(stage.counts.joints, 0u);
}

TEST(add_chain_below, tails_are_first_children_and_ends_go_on) {
  Skeleton skeleton = test::skeleton_of({kNone, 0, 1, 1, 2});
  skeleton.rest[1].translation = {1, 0, 0};
  skeleton.rest[2].translation = {0, 2, 0};
  skeleton.rest[3].translation = {0, 0, 3};
  skeleton.rest[4].translation = {0, -4, 0};
  SpringSetup setup;
  setup.groups.resize(1);
  add_chain_below(skeleton, 1, {.stiffness = 2.0}, 0.07, setup);
  ASSERT_EQ(setup.joints.size(), 4u);
  const std::uint32_t joints[] = {1, 2, 4, 3};
  const Vec3<double> tails[] = {{0, 2, 0}, {0, -4, 0}, {0, -0.07, 0}, {0, 0, 0.07}};
  for (std::size_t j = 0; j < 4; ++j) {
    EXPECT_EQ(setup.joints[j].joint, joints[j]);
    EXPECT_EQ(setup.joints[j].stiffness, 2.0);
    EXPECT_TRUE(test::is_near(setup.joints[j].tail_m, tails[j], 1e-15)) << j;
  }
}

}  // namespace
}  // namespace sinew
