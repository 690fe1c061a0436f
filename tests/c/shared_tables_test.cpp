// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <utility>

#include "runtime/c/handles.h"
#include "runtime/plan/compiled_plan.h"
#include "tests/scenes/random_scene.h"
#include "tests/scenes/stretches.h"

namespace sinew::test {
namespace {

TEST(c_interface, plans_of_a_scene_share_the_tables_of_its_meshes) {
  Scene made = random_scene(3, {.targets = 0, .triangles = 200});
  share_joints_in_stretches(made, 32);
  const sinew_scene scene{std::move(made)};
  sinew_needs fewer = sinew_default_needs();
  fewer.flags &= ~static_cast<std::uint32_t>(SINEW_NEED_TANGENTS);
  sinew_plan *near_plan = nullptr, *far_plan = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene, nullptr, &near_plan), SINEW_OK);
  ASSERT_EQ(sinew_plan_create(&scene, &fewer, &far_plan), SINEW_OK);
  const auto& of_near = near_plan->plan.compiled()->primitive_skinning;
  const auto& of_far = far_plan->plan.compiled()->primitive_skinning;
  std::size_t shared = 0;
  for (std::size_t p = 0; p < of_near.size(); ++p) {
    EXPECT_EQ(of_near[p].tiles, of_far[p].tiles);
    shared += of_near[p].tiles != nullptr;
  }
  EXPECT_GT(shared, 0u);
  sinew_plan_destroy(near_plan);
  sinew_plan_destroy(far_plan);
}

}  // namespace
}  // namespace sinew::test
