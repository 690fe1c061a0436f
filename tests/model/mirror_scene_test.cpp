// SPDX-License-Identifier: MIT
// Mirroring files that rest in mid-motion: the truth is the same motion on the same body that rests in its bind pose.
#include "runtime/model/mirror_scene.h"

#include <gtest/gtest.h>

#include "runtime/animation/mirror_animation.h"
#include "tests/scenes/bound_body.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using scenes::RightSide;

std::vector<Affined> model_at(const Animation& animation, const Skeleton& skeleton, double time_s) {
  TruthPose pose;
  evaluate_truth(animation, skeleton, time_s, pose);
  return pose.model;
}

/// Tracks that keep every joint without one where it rests, so that the motion does not depend on the rest pose.
Animation complete(Animation animation, const Skeleton& skeleton) {
  for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j) {
    BoneAnimation bone;
    bone.joint = j;
    const Transform& rest = skeleton.rest[j];
    bone.translation = {Interpolation::step, {0.0f}, {rest.translation}};
    bone.rotation = {Interpolation::step, {0.0f}, {rest.rotation}};
    for (const BoneAnimation& moved : animation.bones) {
      if (moved.joint != j) continue;
      if (!moved.translation.empty()) bone.translation = {};
      if (!moved.rotation.empty()) bone.rotation = {};
    }
    if (!bone.empty()) animation.bones.push_back(std::move(bone));
  }
  return animation;
}

TEST(mirror_scene, a_file_that_rests_in_mid_motion_mirrors_like_one_that_rests_in_its_bind_pose) {
  for (const RightSide right : {RightSide::mirrored_axes, RightSide::opposite_axes, RightSide::any_axes}) {
    const Scene upright = scenes::bound_body(right);
    Scene striding = upright;
    striding.skeleton.rest = scenes::mid_motion(upright.skeleton.rest);
    const MirrorMap truth = make_mirror_map(upright), map = make_mirror_map(striding);
    EXPECT_EQ(truth.reference, PoseReference::rest);
    EXPECT_EQ(map.reference, PoseReference::bind);
    const Animation walk = scenes::walk_of(striding.skeleton, 0),
                    expected = mirror_animation(complete(walk, striding.skeleton), truth, upright.skeleton),
                    found = mirror_animation(walk, map, striding.skeleton),
                    twice = mirror_animation(found, map, striding.skeleton);
    for (const double time_s : {0.0, 0.3, 0.8}) {
      const auto a = model_at(expected, upright.skeleton, time_s), b = model_at(found, striding.skeleton, time_s),
                 before = model_at(walk, striding.skeleton, time_s), after = model_at(twice, striding.skeleton, time_s);
      for (std::size_t j = 0; j < a.size(); ++j) {
        EXPECT_TRUE(test::is_near(a[j], b[j], 1e-5)) << j;
        EXPECT_TRUE(test::is_near(before[j], after[j], 1e-5)) << j << " twice";
      }
    }
  }
}

TEST(mirror_scene, a_body_in_centimetres_with_z_up_is_mirrored_across_the_plane_of_its_bind_pose) {
  const Skeleton body = scenes::two_sided(RightSide::mirrored_axes).skeleton;
  Scene scene;
  scene.skeleton = scenes::below_armature(body);
  scenes::add_skin(scene, scene.skeleton.rest, scenes::all_joints(scene.skeleton, 1), scenes::centimetres_z_up());
  const std::vector<Transform> rest = scenes::mid_motion({scene.skeleton.rest.begin() + 1, scene.skeleton.rest.end()});
  std::copy(rest.begin(), rest.end(), scene.skeleton.rest.begin() + 1);
  const MirrorMap map = make_mirror_map(scene);
  EXPECT_EQ(map.reference, PoseReference::bind);
  EXPECT_EQ(map.plane_normal, glm::vec3(1, 0, 0));
  EXPECT_NEAR(map.plane_offset, 0.0f, 1e-6f);
}

TEST(mirror_scene, partners_are_found_by_places_in_the_bind_pose) {
  Scene scene = scenes::bound_body(RightSide::any_axes);
  for (std::string& name : scene.skeleton.names) name.clear();
  scene.skeleton.rest = scenes::mid_motion(scene.skeleton.rest);
  const MirrorMap map = make_mirror_map(scene);
  EXPECT_EQ(map.reference, PoseReference::bind);
  EXPECT_EQ(paired_joints(map), 10u);
}

TEST(mirror_scene, the_rest_pose_stays_where_it_is_symmetric_or_the_bind_pose_is_no_better) {
  const Scene upright = scenes::bound_body(RightSide::mirrored_axes);
  const MirrorReference same = mirror_reference(upright);
  EXPECT_EQ(same.pose, PoseReference::rest);
  EXPECT_EQ(same.local, upright.skeleton.rest);

  Scene other;  // It rests in a symmetric pose, and was bound in a frame of a walk.
  other.skeleton = upright.skeleton;
  scenes::add_skin(other, scenes::mid_motion(other.skeleton.rest), scenes::all_joints(other.skeleton));
  const MirrorReference symmetric = mirror_reference(other);
  EXPECT_EQ(symmetric.pose, PoseReference::rest);
  EXPECT_LT(symmetric.rest_asymmetry, 1e-6);
  EXPECT_GT(symmetric.bind_asymmetry, 0.01);

  other.skeleton.rest = scenes::mid_motion(other.skeleton.rest, 7);
  const MirrorReference neither = mirror_reference(other);
  EXPECT_EQ(neither.pose, PoseReference::rest);
  EXPECT_GT(neither.rest_asymmetry, 0.01);
  EXPECT_GT(neither.bind_asymmetry, 0.5 * neither.rest_asymmetry);
}

TEST(mirror_scene, a_pose_of_the_caller_comes_before_the_chosen_one) {
  Scene scene = scenes::bound_body(RightSide::mirrored_axes);
  scene.skeleton.rest = scenes::mid_motion(scene.skeleton.rest);
  MirrorOptions options;
  options.reference = scene.skeleton.rest;
  EXPECT_EQ(make_mirror_map(scene, options).reference, PoseReference::rest);
  const std::vector<Transform> given = scenes::mid_motion(scene.skeleton.rest, 9);
  options.reference = given;
  EXPECT_EQ(make_mirror_map(scene, options).reference, PoseReference::given);
}

}  // namespace
}  // namespace sinew
