// SPDX-License-Identifier: MIT
#include "runtime/plan/joint_scales.h"

#include <gtest/gtest.h>

#include "runtime/base/same_bits.h"
#include "runtime/plan/frame_hash.h"
#include "runtime/plan/run_plan.h"
#include "tests/plan/changed_plan.h"
#include "tests/plan/plan_dump.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"

namespace sinew::test {
namespace {

/// The arm with a scale track on joint 0 or on joint 2 ("lower") below it.
Scene arm_scaled_by(std::uint32_t joint, Vec3Track scale) {
  Scene scene = arm_scene();
  BoneAnimation bone;
  bone.joint = joint;
  bone.scale = std::move(scale);
  if (joint == 2)
    scene.animations[0].bones[0].scale = bone.scale;
  else
    scene.animations[0].bones.push_back(bone);
  finish_scene(scene);
  return scene;
}

JointScale scale_of(const Scene& scene, std::uint32_t joint, bool additive = false) {
  return joint_scales(make_assets(scene, scene.clips, {}), additive)[joint];
}

void expect_scale(const JointScale& scale, ScaleKind kind, int sign, bool may_change) {
  EXPECT_EQ(scale.kind, kind);
  EXPECT_EQ(scale.sign, sign);
  EXPECT_EQ(scale.may_change, may_change);
}

TEST(joint_scales, P07_kinds_come_from_rest_constants_and_keys_and_reach_what_is_below) {
  expect_scale(scale_of(arm_scene(), 2), ScaleKind::none, 1, false);
  const Scene even = arm_scaled_by(0, {Interpolation::linear, {0, 1}, {glm::vec3(1), glm::vec3(2)}});
  expect_scale(scale_of(even, 0), ScaleKind::even, 1, false);
  expect_scale(scale_of(even, 2), ScaleKind::even, 1, false);
  expect_scale(scale_of(even, 1), ScaleKind::none, 1, false);  // not below it
  const Scene below = arm_scaled_by(2, {Interpolation::step, {0, 1}, {glm::vec3(1), glm::vec3(1, 1, 1.5f)}});
  expect_scale(scale_of(below, 2), ScaleKind::uneven, 1, false);
  expect_scale(scale_of(below, 0), ScaleKind::none, 1, false);
  expect_scale(scale_of(arm_scaled_by(0, {Interpolation::linear, {0, 1}, {glm::vec3(2), glm::vec3(2)}}), 2),
               ScaleKind::even, 1, false);  // the constant track became part of the rest pose
  Scene rest = arm_scene();
  rest.skeleton.rest[0].scale = glm::vec3(1, 2, 3);
  finish_scene(rest);
  expect_scale(scale_of(rest, 2), ScaleKind::uneven, 1, false);
  Scene fixed = arm_scene();
  fixed.skeleton.fixed_matrix_of[0] = 0;
  fixed.skeleton.fixed_matrices = {
      affine_from_transform(Transform{{1, 2, 3}, glm::quat(0.6f, 0.8f, 0, 0), glm::vec3(2)})};
  finish_scene(fixed);
  expect_scale(scale_of(fixed, 2), ScaleKind::even, 1, false);
  fixed.skeleton.fixed_matrices[0].row[0].y += 0.5f;
  expect_scale(scale_of(fixed, 2), ScaleKind::uneven, 1, false);
}

TEST(joint_scales, P09_signs_may_change_where_keys_have_several_or_tracks_may_leave_their_keys) {
  expect_scale(scale_of(arm_scaled_by(0, {Interpolation::linear, {0, 1}, {glm::vec3(1), glm::vec3(-1)}}), 2),
               ScaleKind::even, 1, true);
  EXPECT_TRUE(scale_of(arm_scaled_by(0, {Interpolation::linear, {0, 1}, {glm::vec3(1), glm::vec3(0)}}), 2).may_change);
  EXPECT_TRUE(scale_of(arm_scaled_by(0, {Interpolation::linear, {0, 1}, {glm::vec3(1, 1, -2), glm::vec3(1, -1, 2)}}), 2)
                  .may_change);  // through zero
  const Vec3Track cubic{Interpolation::cubic_spline,
                        {0, 1},
                        {glm::vec3(0), glm::vec3(1), glm::vec3(-9), glm::vec3(9), glm::vec3(1), glm::vec3(0)}};
  expect_scale(scale_of(arm_scaled_by(0, cubic), 2), ScaleKind::uneven, 1, true);
  Scene mirrored = arm_scene();
  mirrored.skeleton.rest[0].scale = glm::vec3(1, 1, -1);
  mirrored.skeleton.rest[2].scale = glm::vec3(-1);
  finish_scene(mirrored);
  expect_scale(scale_of(mirrored, 0), ScaleKind::uneven, -1, false);
  expect_scale(scale_of(mirrored, 2), ScaleKind::uneven, 1, false);
  const Scene growing = arm_scaled_by(0, {Interpolation::linear, {0, 1}, {glm::vec3(1), glm::vec3(2)}});
  EXPECT_TRUE(scale_of(growing, 2, true).may_change) << "adding may turn it";
  EXPECT_FALSE(scale_of(arm_scene(), 2, true).may_change);
}

/// (1, 1, 1) with another number on one axis.
glm::vec3 ones_but(int axis, float number) {
  glm::vec3 scale(1.0f);
  scale[axis] = number;
  return scale;
}

TEST(joint_scales, P07_P09_look_at_every_axis_of_rest_constants_and_keys) {
  for (int axis = 0; axis < 3; ++axis) {
    SCOPED_TRACE(axis);
    for (const auto& [number, sign] : {std::pair(2.0f, 1), {-1.0f, -1}, {0.0f, 0}}) {
      const glm::vec3 scale = ones_but(axis, number);
      Scene rest = arm_scene();
      rest.skeleton.rest[0].scale = scale;
      finish_scene(rest);
      expect_scale(scale_of(rest, 2), ScaleKind::uneven, sign, false);
      const Scene folded = arm_scaled_by(0, {Interpolation::linear, {0, 1}, {scale, scale}}),
                  keyed = arm_scaled_by(0, {Interpolation::linear, {0, 1}, {glm::vec3(1), scale}});
      expect_scale(scale_of(folded, 2), ScaleKind::uneven, 1, sign != 1);  // the sign of the rest pose differs
      expect_scale(scale_of(keyed, 2), ScaleKind::uneven, 1, sign != 1);
      const Scene first = arm_scaled_by(0, {Interpolation::linear, {0, 1}, {scale, glm::vec3(1)}});
      expect_scale(scale_of(first, 2), ScaleKind::uneven, 1, sign != 1);
    }
  }
}

/// Scale of the first of two joints that are each other's mirror partners, with these scales at rest.
JointScale mirrored_scale(const glm::vec3& own, const glm::vec3& of_partner, bool copies) {
  Scene scene = arm_scene();
  scene.skeleton.rest[0].scale = own;
  scene.skeleton.rest[1].scale = of_partner;
  scene.clips.clear();
  scene.animations.clear();
  auto map = std::make_shared<MirrorMap>();
  map->joints.resize(3);
  map->joints[0].source = 1;
  map->joints[1].source = 0;
  map->joints[2].source = 2;
  if (!copies) map->joints[0].scale[0] = {0.5, 0.5, 0.0};
  return joint_scales(make_assets(scene, scene.clips, {}, map), false)[0];
}

TEST(joint_scales, P07_mirrored_layers_bring_those_of_the_partner) {
  const glm::vec3 one(1), two(2), flipped(-2), uneven(1, 2, 1);
  expect_scale(mirrored_scale(one, one, true), ScaleKind::none, 1, false);
  expect_scale(mirrored_scale(one, two, true), ScaleKind::even, 1, false);
  expect_scale(mirrored_scale(two, one, true), ScaleKind::even, 1, false);
  expect_scale(mirrored_scale(two, flipped, true), ScaleKind::even, 1, true);
  expect_scale(mirrored_scale(one, uneven, true), ScaleKind::uneven, 1, true);
  expect_scale(mirrored_scale(uneven, one, true), ScaleKind::uneven, 1, true);
  expect_scale(mirrored_scale(one, one, false), ScaleKind::none, 1, false);  // 0.5 + 0.5 = 1
  expect_scale(mirrored_scale(one, two, false), ScaleKind::uneven, 1, true);
  expect_scale(mirrored_scale(two, two, false), ScaleKind::uneven, 1, true);
}

TEST(joint_scales, of_a_matrix_allow_for_rounding) {
  EXPECT_EQ(scale_kind(Affine{}), ScaleKind::none);
  const glm::quat turn = glm::normalize(glm::quat(0.3f, 0.5f, -0.7f, 0.2f));
  EXPECT_EQ(scale_kind(affine_from_transform(Transform{{9, 8, 7}, turn, glm::vec3(1)})), ScaleKind::none);
  EXPECT_EQ(scale_kind(affine_from_transform(Transform{{9, 8, 7}, turn, glm::vec3(0.01f)})), ScaleKind::even);
  EXPECT_EQ(scale_kind(affine_from_transform(Transform{{0, 0, 0}, turn, glm::vec3(-1)})), ScaleKind::even);
  EXPECT_EQ(scale_kind(affine_from_transform(Transform{{0, 0, 0}, turn, glm::vec3(1, 1, 1.001f)})), ScaleKind::uneven);
}

/// A root with or without mirroring.
Affine root_of(bool mirrored) {
  return affine_from_transform(
      Transform{{0.5f, 0, 0}, glm::quat(1, 0, 0, 0), glm::vec3(1, mirrored ? -1.0f : 1.0f, 1)});
}

/// Expects the windings that determinants give.
/// out  the number of mirrored instances; `known` += those whose winding no frame had to test
std::size_t expect_windings_of_determinants(const Scene& scene, const Needs& needs, std::size_t& known) {
  const Plan plan = compile_plan(lend(scene), needs);
  const std::vector<JointScale>& scales = plan.compiled()->instance_scales;
  const Plan tested = changed(plan, [](CompiledPlan& all_tested) {
    for (JointScale& scale : all_tested.instance_scales) scale.may_change = true;
  });
  FrameBuffer frame(plan), other(tested);
  std::size_t mirrored = 0;
  for (const double time_s : {0.0, 0.3, 1.0, 1.7})
    for (const bool turned : {false, true}) {
      const ClipLayer layers[] = {{0, time_s, 0.75f}, {1, 0.4, 0.5f}};
      const FrameInput input{.layers = layers, .weights = {}, .root = root_of(turned)};
      EXPECT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
      EXPECT_EQ(run_plan(tested, input, other), ErrorCode::ok);
      for (std::size_t i = 0; i < scales.size(); ++i) {
        EXPECT_EQ(frame.result().instances[i].mirrored, other.result().instances[i].mirrored) << i << " at " << time_s;
        mirrored += frame.result().instances[i].mirrored;
        known += !scales[i].may_change;
      }
      EXPECT_EQ(hash_vertices(frame.result()), hash_vertices(other.result()));
      EXPECT_EQ(frame.result().work.windings_tested, stage(plan, "winding").count);
      EXPECT_EQ(other.result().work.windings_tested, scales.size());
    }
  return mirrored;
}

TEST(windings, P09_known_beforehand_are_those_of_determinants) {
  std::size_t mirrored = 0, known = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    RandomSceneOptions options;
    options.mirrored_joints = true;
    options.flat_normals = seed % 2 == 0;
    options.instances = 6;
    Scene scene = random_scene(seed, options);
    if (seed % 3 != 0)  // every third scene keeps its tracks
      for (Animation& animation : scene.animations)
        for (BoneAnimation& bone : animation.bones) bone.scale = {};
    if (seed % 4 == 1)
      for (Skin& skin : scene.skins) skin.inverse_bind[0].row[0] = -skin.inverse_bind[0].row[0];
    finish_scene(scene);
    mirrored += expect_windings_of_determinants(scene, {}, known);
  }
  EXPECT_GT(mirrored, 20u);
  EXPECT_GT(known, 100u);
}

TEST(joint_pairs, are_those_that_share_vertices_where_dual_quaternions_are_asked_for) {
  const Scene scene = arm_scene();
  Needs needs;
  EXPECT_TRUE(compile_plan(lend(scene), needs).compiled()->primitive_skinning[0].pairs.empty());
  needs.skin.kind = Skinning::dual_quaternion;
  const Plan plan = compile_plan(lend(scene), needs);
  const auto& pairs = plan.compiled()->primitive_skinning[0].pairs;
  ASSERT_EQ(pairs.size(), 1u) << "two joints share two vertices";
  EXPECT_NE(pairs[0].first, pairs[0].second);
}

TEST(windings, P09_a_root_without_volume_mirrors_nothing) {
  const Scene scene = arm_scene();
  const Plan plan = compile_plan(lend(scene), {});
  FrameBuffer frame(plan);
  const ClipLayer layers[] = {{0, 0.3, 1.0f}};
  Affine flat;
  flat.row[1] = glm::vec4(0.0f);
  ASSERT_EQ(run_plan(plan, {.layers = layers, .weights = {}, .root = flat}, frame), ErrorCode::ok);
  for (const InstanceResult& instance : frame.result().instances) EXPECT_FALSE(instance.mirrored);
}

TEST(windings, P09_change_with_the_sign_of_a_scale_and_are_then_tested) {
  const Scene scene = arm_scaled_by(0, {Interpolation::linear, {0, 1}, {glm::vec3(1), glm::vec3(1, 1, -1)}});
  const Plan plan = compile_plan(lend(scene), {});
  EXPECT_TRUE(stage(plan, "winding").runs);
  FrameBuffer frame(plan);
  for (const double time_s : {0.0, 0.25, 0.75, 1.0}) {
    const ClipLayer layer{0, time_s};
    ASSERT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frame), ErrorCode::ok);
    EXPECT_EQ(frame.result().instances[0].mirrored, time_s > 0.5);
    EXPECT_EQ(frame.result().work.windings_tested, 1u);
  }
}

/// An arm in which each vertex follows one joint.
Scene rigid_arm(float last_scale) {
  Scene scene = arm_scaled_by(2, {Interpolation::linear, {0, 1}, {glm::vec3(1), glm::vec3(1.5f, 1.5f, last_scale)}});
  scene.meshes[0].primitives[0].influences = {{{0, 4, 1, 0}}, {0, 1, 0, 1}, {1, 1, 1, 1}};
  scene.meshes[0].primitives[0].normals = {{0, 0.6f, 0.8f}, {0.6f, 0, 0.8f}, {0, -0.6f, 0.8f}, {-0.6f, 0, 0.8f}};
  return scene;
}

std::uint64_t run_arm(const Plan& plan, const Affine& root, std::uint64_t& by_cofactors) {
  FrameBuffer frame(plan);
  const ClipLayer layer{0, 0.7};
  EXPECT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = root}, frame), ErrorCode::ok);
  by_cofactors = frame.result().work.normals_by_cofactors;
  return hash_vertices(frame.result());
}

TEST(normals_by_cofactors, P08_are_left_out_where_neither_scale_nor_blends_are_uneven) {
  Needs needs;
  std::uint64_t count = 0;
  const Scene even = rigid_arm(1.5f), uneven = rigid_arm(0.5f);
  const std::uint64_t linear = run_arm(compile_plan(lend(even), needs), {}, count),
                      linear_uneven = run_arm(compile_plan(lend(uneven), needs), {}, count);
  EXPECT_EQ(count, 0u);
  needs.skin.normal_rule = NormalRule::cofactor;
  EXPECT_EQ(run_arm(compile_plan(lend(even), needs), {}, count), linear);
  EXPECT_EQ(count, 0u);
  EXPECT_NE(stage(compile_plan(lend(even), needs), "skin_linear").reason.find("normals of 1 primitive without"),
            std::string::npos);
  EXPECT_NE(run_arm(compile_plan(lend(uneven), needs), {}, count), linear_uneven);
  EXPECT_EQ(count, 4u);
  EXPECT_NE(stage(compile_plan(lend(uneven), needs), "skin_linear").reason.find("normals of 1 primitive by cofactors"),
            std::string::npos);
  run_arm(compile_plan(arm_scene(), needs), {}, count);
  EXPECT_EQ(count, 4u) << "a blend of two turns is uneven itself";
}

TEST(normals_by_cofactors, P08_come_with_an_uneven_inverse_bind_matrix) {
  Needs needs;
  needs.skin.normal_rule = NormalRule::cofactor;
  std::uint64_t count = 0;
  for (const std::size_t entry : {0u, 1u}) {
    Scene scene = rigid_arm(1.5f);
    scene.skins[0].inverse_bind[entry].row[1] *= 3.0f;
    run_arm(compile_plan(lend(scene), needs), {}, count);
    EXPECT_EQ(count, 4u) << entry;
  }
}

TEST(normals_by_cofactors, P08_come_with_an_uneven_root) {
  const Scene scene = rigid_arm(1.5f);
  Needs needs;
  needs.skin.normal_rule = NormalRule::cofactor;
  const Affine root = affine_from_transform(Transform{{0, 0, 0}, glm::quat(1, 0, 0, 0), glm::vec3(1, 2, 1)});
  const Plan plan = compile_plan(lend(scene), needs);
  std::uint64_t count = 0;
  const std::uint64_t found = run_arm(plan, root, count);
  EXPECT_EQ(count, 4u);
  const Plan all_cofactors = changed(plan, [](CompiledPlan& compiled) {
    for (PrimitivePlan& primitive : compiled.primitives) primitive.cofactors = true;
  });
  EXPECT_EQ(run_arm(all_cofactors, root, count), found);
}

}  // namespace
}  // namespace sinew::test
