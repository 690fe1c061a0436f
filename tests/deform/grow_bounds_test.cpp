// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "runtime/deform/grow_bounds.h"
#include "runtime/plan/run_plan.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

bool holds(const Aabb& box, const glm::vec3& p) {
  return box.lower.x <= p.x && p.x <= box.upper.x && box.lower.y <= p.y && p.y <= box.upper.y && box.lower.z <= p.z &&
         p.z <= box.upper.z;
}

TEST(grow_bounds, a_moved_box_holds_every_moved_point_to_the_last_bit) {
  FixedRandom random(5);
  for (int round = 0; round < 200; ++round) {
    const Affine world = affine_from_transform(random.transform(-2, 2));
    Aabb box, moved;
    std::vector<glm::vec3> points(50);
    for (auto& p : points) box.add(p = random.vec3(-3, 3));
    grow_bounds(moved, box, world);
    for (const auto& p : points) ASSERT_TRUE(holds(moved, transform_point(world, p)));
  }
}

TEST(grow_bounds, points_give_the_tight_box) {
  Aabb box;
  const std::vector<glm::vec3> points = {{1, 2, 3}, {-1, 5, 0}};
  grow_bounds(box, points, affine_from(glm::mat3(2.0f), glm::vec3(10, 0, 0)));
  EXPECT_EQ(box.lower, glm::vec3(8, 4, 0));
  EXPECT_EQ(box.upper, glm::vec3(12, 10, 6));
}

TEST(grow_bounds, an_empty_box_and_no_points_add_nothing) {
  Aabb box;
  grow_bounds(box, Aabb{}, Affine{});
  grow_bounds(box, std::span<const glm::vec3>{}, Affine{});
  EXPECT_TRUE(box.empty());
}

// Boxes must follow the deformation over the whole clip: the box of the rest pose does not contain the raised arm.
TEST(bounds, G54_boxes_hold_all_shown_vertices_in_every_frame) {
  for (const Skinning skinning : {Skinning::linear, Skinning::dual_quaternion}) {
    const Scene scene = random_scene(31);
    Needs needs;
    needs.out.bounds = true;
    needs.skin.kind = skinning;
    const Plan plan = compile_plan(lend(scene), needs);
    FrameBuffer frame(plan);
    for (double time_s = 0.0; time_s <= 2.0; time_s += 0.125) {
      const ClipLayer layer{0, time_s, 1.0f};
      ASSERT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frame), ErrorCode::ok);
      for (const DeformedPrimitive& shape : frame.result().primitives) {
        const InstanceResult& instance = frame.result().instances[shape.instance];
        for (const glm::vec3& p : shape.positions)
          ASSERT_TRUE(holds(instance.bounds, transform_point(instance.world_from_mesh, p)));
      }
    }
  }
}

TEST(bounds, G54_the_box_of_a_bent_arm_is_tight) {
  const Scene scene = arm_scene();
  Needs needs;
  needs.out.bounds = true;
  needs.out.positions = needs.out.normals = needs.out.tangents = false;
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer frame(plan);
  const ClipLayer layer{0, 1.0, 1.0f};
  ASSERT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frame), ErrorCode::ok);
  const Aabb& box = frame.result().instances[0].bounds;
  EXPECT_NEAR(box.lower.x, -1.0f, 1e-6f);
  EXPECT_NEAR(box.upper.x, 0.125f, 1e-6f);
  EXPECT_NEAR(box.upper.y, 1.125f, 1e-6f);
  EXPECT_TRUE(frame.result().primitives[0].positions.empty());  // computed for the box only, not part of the result
}

TEST(bounds, a_rigid_mesh_moves_its_rest_box_without_looking_at_vertices) {
  const Scene scene = prop_scene();
  Needs needs;
  needs.out.bounds = true;
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer frame(plan);
  ASSERT_EQ(
      run_plan(plan, {.layers = {}, .weights = {}, .root = affine_from(glm::mat3(2.0f), glm::vec3(0, 0, 7))}, frame),
      ErrorCode::ok);
  EXPECT_EQ(frame.result().instances[0].bounds.lower, glm::vec3(0, 0, 7));
  EXPECT_EQ(frame.result().instances[0].bounds.upper, glm::vec3(2, 2, 7));
  EXPECT_EQ(frame.result().work.bounds_vertices, 0u);
}

}  // namespace
}  // namespace sinew::test
