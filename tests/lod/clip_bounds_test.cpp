// SPDX-License-Identifier: MIT
#include "runtime/lod/clip_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/deform/grow_bounds.h"
#include "runtime/plan/run_plan.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"

namespace sinew::test {
namespace {

bool holds(const Aabb& outer, const Aabb& inner) {
  return glm::all(glm::lessThanEqual(outer.lower, inner.lower)) &&
         glm::all(glm::greaterThanEqual(outer.upper, inner.upper));
}

float diagonal(const Aabb& box) { return glm::length(box.upper - box.lower); }

Needs boxes_for(Skinning skinning) {
  Needs needs;
  needs.out.bounds = true;
  needs.skin.kind = skinning;
  return needs;
}

/// Checks the bounds against the vertices of frames, at `times` times over the clip and past its end. Returns the union
/// of the frames' boxes.
std::vector<Aabb> expect_holds(const Scene& scene, const Needs& needs, std::uint32_t clip, int times) {
  const std::vector<Aabb> reach = clip_bounds(scene, needs, clip);
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer frame(plan);
  std::vector<Aabb> all(scene.instances.size());
  for (int n = 0; n <= times; ++n) {
    const ClipLayer layer{clip, clip == kNone ? 0.0 : 1.05 * scene.animations[clip].duration_s * n / times};
    FrameInput input;
    if (clip != kNone) input.layers = {&layer, 1};
    EXPECT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Aabb& box = frame.result().instances[i].bounds;
      EXPECT_FALSE(reach[i].empty()) << i;
      EXPECT_TRUE(holds(reach[i], box)) << "instance " << i << " at " << layer.time_s << " s of clip " << clip;
      all[i].add(box.lower);
      all[i].add(box.upper);
    }
  }
  return all;
}

TEST(clip_bounds, G54_holds_every_vertex_at_every_time) {
  for (std::uint32_t seed = 0; seed < 24; ++seed) {
    RandomSceneOptions options;
    options.skins = seed % 3;
    options.targets = seed % 2 * 3;
    options.mirrored_joints = seed % 4 == 0;
    const Scene scene = random_scene(seed, options);
    for (const std::uint32_t clip : {0u, 1u, kNone})
      expect_holds(scene, boxes_for(Skinning::linear), clip, clip == kNone ? 1 : 300);
  }
}

TEST(clip_bounds, G54_holds_vertices_that_follow_joints_in_other_ways) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    RandomSceneOptions options;
    options.centers = true;
    const Scene scene = random_scene(seed, options);
    for (const Skinning skinning : {Skinning::dual_quaternion, Skinning::center_of_rotation})
      expect_holds(scene, boxes_for(skinning), 0, 200);
  }
}

void expect_same_boxes(const std::vector<Aabb>& a, const std::vector<Aabb>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].lower, b[i].lower) << i;
    EXPECT_EQ(a[i].upper, b[i].upper) << i;
  }
}

TEST(clip_bounds, boxes_that_were_stored_give_the_bits_of_the_keys) {
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    RandomSceneOptions options;
    options.targets = seed % 2 * 3;
    options.correctives = seed == 5 ? 1 : 0;  // they need targets
    const Scene scene = random_scene(seed, options);
    Scene stored = scene;
    for (Animation& animation : stored.animations) animation.bones.clear();  // no keys to compute them from
    for (const std::uint32_t clip : {0u, 1u}) {
      const std::vector<Aabb> boxes = clip_boxes(scene, clip);
      for (const Skinning skinning : {Skinning::linear, Skinning::dual_quaternion})
        expect_same_boxes(clip_bounds(stored, boxes_for(skinning), clip, boxes),
                          clip_bounds(scene, boxes_for(skinning), clip));
    }
  }
}

TEST(clip_bounds, boxes_that_were_stored_are_of_all_joints) {
  const Scene scene = arm_scene();
  Needs needs;
  needs.out.skeleton_lod.kept.assign(scene.skeleton.joint_count(), false);
  const std::vector<Aabb> with_lod = clip_bounds(scene, needs, 0);
  EXPECT_NE(with_lod[0].upper, clip_bounds(scene, {}, 0)[0].upper);
  expect_same_boxes(clip_bounds(scene, needs, 0, clip_boxes(scene, 0)), with_lod);
}

TEST(clip_bounds, is_not_much_more_than_what_is_reached) {
  const Scene arm = arm_scene(), face = face_scene();
  const std::vector<Aabb> of_arm = expect_holds(arm, boxes_for(Skinning::linear), 0, 1000);
  EXPECT_LT(diagonal(clip_bounds(arm, {}, 0)[0]), 1.35f * diagonal(of_arm[0]));
  const std::vector<Aabb> of_face = expect_holds(face, boxes_for(Skinning::linear), 0, 1000);
  EXPECT_LT(diagonal(clip_bounds(face, {}, 0)[0]), 3.0f * diagonal(of_face[0])) << "targets may all point the same way";
  EXPECT_LT(diagonal(clip_bounds(arm, {}, kNone)[0]), 1.001f * std::sqrt(4.25f));
}

TEST(clip_bounds, a_jump_takes_no_more_than_both_its_sides) {
  Scene scene = prop_scene();
  BoneAnimation jump;
  jump.translation = {.interpolation = Interpolation::step,
                      .times_s = {0.0f, 1.0f, 2.0f},
                      .values = {glm::vec3(0), glm::vec3(100, 0, 0), glm::vec3(0)}};
  scene.animations.push_back({"jump", 2.0, {jump}, {}});
  finish_scene(scene);
  expect_holds(scene, boxes_for(Skinning::linear), 0, 100);
  const Aabb reach = clip_bounds(scene, {}, 0)[0];
  EXPECT_NEAR(reach.lower.x, 0.0f, 0.01f);
  EXPECT_NEAR(reach.upper.x, 101.0f, 0.01f);
}

/// The face with a cubic weight of "lift". Both keys are 0; the curve leaves or reaches them with a slope.
Scene lifted_face(float out_slope, float in_slope) {
  Scene scene = face_scene();
  scene.instances[0].rest_weights = {0.0f, 0.0f};
  scene.animations[0].weights[0].weights = {
      Interpolation::cubic_spline, {0, 1}, {0, 0, 0, 0, out_slope, 0, in_slope, 0, 0, 0, 0, 0}, 2};
  scene.clips.clear();
  finish_scene(scene);
  return scene;
}

TEST(clip_bounds, G03_cubic_weights_lead_out_of_what_their_keys_reach) {
  for (const auto& [out_slope, in_slope] : {std::pair{9.0f, 0.0f}, {0.0f, -9.0f}, {-9.0f, 0.0f}, {0.0f, 9.0f}}) {
    const std::vector<Aabb> reached =
        expect_holds(lifted_face(out_slope, in_slope), boxes_for(Skinning::linear), 0, 300);
    EXPECT_GT(std::max(reached[0].upper.z, -reached[0].lower.z), 1.2f) << "9 * 4 / 27 at a third of the way";
    const Aabb reach = clip_bounds(lifted_face(out_slope, in_slope), boxes_for(Skinning::linear), 0)[0];
    EXPECT_LT(std::max(reach.upper.z, -reach.lower.z), 3.01f) << "the curve stays among its control points";
  }
}

TEST(clip_bounds, G54_holds_every_copy_of_a_mesh_that_morphs) {
  Scene scene = face_scene();
  scene.instances[0].copies = {{{3, 0, 0}, glm::quat(1, 0, 0, 0), {2, 1, 4}},
                               {{-4, 1, 0}, glm::quat(0.8f, 0.6f, 0, 0), {1, -3, 1}}};
  const std::vector<Aabb> reached = expect_holds(scene, boxes_for(Skinning::linear), 0, 100);
  EXPECT_GT(reached[0].upper.z, 3.9f) << "lifted by a metre that is scaled by four";
  EXPECT_LT(diagonal(clip_bounds(scene, {}, 0)[0]), 4.0f * diagonal(reached[0]));
}

TEST(clip_bounds, G54_holds_what_morphs_below_inverse_bind_matrices_that_scale) {
  Scene scene = arm_scene();
  Primitive& arm = scene.meshes[0].primitives[0];
  arm.morphs.targets = {{.positions = {{1}, {{0.5f, 1, 2}}}}};  // the tip
  scene.meshes[0].default_weights = scene.instances[0].rest_weights = {1.0f};
  for (Affine& bind : scene.skins[0].inverse_bind)
    bind = affine_from_transform(Transform{{0, 0, 0}, glm::quat(1, 0, 0, 0), glm::vec3(40.0f)}) * bind;
  scene.clips.clear();
  finish_scene(scene);
  ASSERT_EQ(check(scene), ErrorCode::ok);
  expect_holds(scene, boxes_for(Skinning::linear), 0, 20);
}

TEST(clip_bounds, have_room_for_the_error_that_a_clip_is_known_to_have) {
  Scene scene = arm_scene();
  const Aabb exact = clip_bounds(scene, {}, 0)[0];
  ClipCertificate certificate;
  certificate.measured_m = 0.5;
  scene.clips[0] = with_certificate(scene.clips[0], certificate);
  const Aabb room = clip_bounds(scene, {}, 0)[0];
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(room.lower[axis], exact.lower[axis] - 0.5f, 1e-5f);
    EXPECT_NEAR(room.upper[axis], exact.upper[axis] + 0.5f, 1e-5f);
  }
}

TEST(clip_bounds, turning_between_far_keys_reaches_out_of_both_poses) {
  Scene scene = arm_scene();
  const float h = std::sqrt(0.5f);
  scene.animations[0].bones[0].rotation = {
      Interpolation::linear, {0, 1}, {glm::quat(h, 0, 0, -h), glm::quat(h, 0, 0, h)}};
  scene.clips.clear();
  finish_scene(scene);
  const std::vector<Aabb> reached = expect_holds(scene, boxes_for(Skinning::linear), 0, 1000);
  EXPECT_NEAR(reached[0].upper.y, 2.0f, 1e-4f);  // at both keys the tip is at one metre
}

TEST(clip_bounds, dual_quaternions_bulge_out_of_the_boxes_of_the_joints) {
  Scene scene = arm_scene();
  const double half = 85.0 * 3.14159265358979 / 180.0;  // the lower arm is held at a twist of 170 degrees
  scene.animations[0].bones[0].rotation = {
      Interpolation::step,
      {0},
      {glm::quat(static_cast<float>(std::cos(half)), 0, static_cast<float>(std::sin(half)), 0)}};
  scene.clips.clear();
  finish_scene(scene);
  EXPECT_LT(clip_bounds(scene, boxes_for(Skinning::linear), 0)[0].upper.z, 0.05f);
  const std::vector<Aabb> reached = expect_holds(scene, boxes_for(Skinning::dual_quaternion), 0, 10);
  EXPECT_GT(reached[0].upper.z, 0.2f);
}

TEST(clip_bounds, does_not_guess_where_correctives_lead) {
  RandomSceneOptions options;
  options.correctives = 1;
  const Scene scene = random_scene(3, options);
  for (const Aabb& box : clip_bounds(scene, {}, 0)) EXPECT_TRUE(box.empty());
}

}  // namespace
}  // namespace sinew::test
