// SPDX-License-Identifier: MIT
#include "runtime/retarget/map_scenes.h"

#include <gtest/gtest.h>

#include "runtime/model/bind_pose.h"
#include "runtime/retarget/retarget_animation.h"
#include "runtime/retarget/retarget_pose.h"
#include "tests/scenes/bound_body.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using scenes::RightSide;

/// Vertices of a scene's first skin, each bound to one joint, some way off it.
std::vector<Vec3<double>> vertices_at(const Scene& scene, const Animation& animation, double time_s,
                                      const std::vector<Transform>& bind) {
  TruthPose pose;
  evaluate_truth(animation, scene.skeleton, time_s, pose);
  const std::vector<Affined> bound = scenes::model_matrices(scene.skeleton, bind);
  const Skin& skin = scene.skins[0];
  std::vector<Vec3<double>> vertices;
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    const Affined palette = pose.model[skin.joints[i]] * affine_cast<double>(skin.inverse_bind[i]);
    for (const Vec3<double>& off : {Vec3<double>(0.1, 0.0, 0.0), Vec3<double>(0.0, 0.1, 0.1)})
      vertices.push_back(transform_point(palette, translation_of(bound[skin.joints[i]]) + off));
  }
  return vertices;
}

double farthest(const std::vector<Vec3<double>>& a, const std::vector<Vec3<double>>& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, test::distance(a[i], b[i]));
  return worst;
}

TEST(map_scenes, a_body_that_rests_in_mid_motion_gets_its_vertices_back_from_its_own_clip) {
  const Scene upright = scenes::bound_body(RightSide::any_axes);
  const std::vector<Transform> bind = upright.skeleton.rest;
  Scene striding = upright, sitting = upright;
  striding.skeleton.rest = scenes::mid_motion(bind);
  sitting.skeleton.rest = scenes::mid_motion(bind, 8);
  const Scene* scenes_of[] = {&upright, &striding, &sitting};
  for (const Scene* from : scenes_of)
    for (const Scene* to : scenes_of) {
      const SkeletonMap map = make_skeleton_map(*from, *to);
      EXPECT_LT(map.bone_angle_rad, 1e-5);
      const Animation walk = scenes::walk_of(from->skeleton, 0),
                      found = retarget_animation(walk, map, from->skeleton, to->skeleton);
      for (const double time_s : {0.0, 0.35, 1.0})
        EXPECT_LT(farthest(vertices_at(*from, walk, time_s, bind), vertices_at(*to, found, time_s, bind)), 1e-5);
      EXPECT_LT(measure_retarget(found, walk, map, from->skeleton, to->skeleton).angle_rad, 2e-6);
    }
}

TEST(map_scenes, the_job_on_poses_gives_what_the_truth_gives) {
  Scene from = scenes::bound_body(RightSide::any_axes), to = scenes::bound_body(RightSide::another_posture, 2);
  from.skeleton.rest = scenes::mid_motion(from.skeleton.rest);
  to.skeleton.rest = scenes::mid_motion(to.skeleton.rest, 8);
  const BindPose from_bind = bind_pose(from), to_bind = bind_pose(to);
  SkeletonMapOptions options;
  options.source_reference = from_bind.local;
  options.target_reference = to_bind.local;
  options.translations = TranslationRule::by_length;
  for (std::uint32_t j = 0; j < 9; ++j) options.pairs.push_back({j, j});
  const SkeletonMap map = make_skeleton_map(from.skeleton, to.skeleton, options);
  const RetargetTables tables = make_retarget_tables(map, from.skeleton, to.skeleton);
  const std::vector<Transform> local = scenes::moved_from_rest(from.skeleton, 4);
  test::PoseBuffer pose(local.size()), scratch(local.size()), found(local.size());
  std::vector<Transformd> exact, expected(local.size());
  for (std::uint32_t j = 0; j < local.size(); ++j) {
    pose.span().set(j, local[j]);
    exact.push_back(in_double(local[j]));
  }
  retarget_pose(map, from.skeleton, to.skeleton, exact, expected);
  ASSERT_EQ(run(RetargetPoseJob{&tables, pose.span(), scratch.span(), found.span()}), ErrorCode::ok);
  for (std::uint32_t j = 0; j < local.size(); ++j) {
    const Transform got = found.span().get(j);
    EXPECT_LT(test::distance(Vec3<double>(got.translation), expected[j].translation), 2e-6) << j;
    EXPECT_LT(test::angle_between(got.rotation, expected[j].rotation), 2e-6) << j;
  }
  EXPECT_EQ(found.span().get(12), to_bind.local[12]) << "joints that none follows stand in the reference pose";
}

TEST(map_scenes, joints_that_nothing_moves_stand_in_the_reference_pose) {
  const Scene upright = scenes::bound_body(RightSide::any_axes);
  Scene striding = upright;
  striding.skeleton.rest = scenes::mid_motion(upright.skeleton.rest);
  SkeletonMapOptions options;
  for (const std::uint32_t j : {0u, 1u, 2u, 3u, 7u, 8u}) options.pairs.push_back({j, j});
  const SkeletonMap map = make_skeleton_map(upright, striding, options);
  ASSERT_EQ(map.target_reference, PoseReference::bind);
  const Animation found = retarget_animation({"still", 1.0, {}, {}}, map, upright.skeleton, striding.skeleton);
  TruthPose pose;
  evaluate_truth(found, striding.skeleton, 0.5, pose);
  for (std::size_t j = 0; j < pose.local.size(); ++j) {
    EXPECT_LT(test::angle_between(pose.local[j].rotation, upright.skeleton.rest[j].rotation), 1e-5) << j;
    EXPECT_LT(test::distance(pose.local[j].translation, Vec3<double>(upright.skeleton.rest[j].translation)), 1e-5) << j;
  }
}

TEST(map_scenes, the_rest_poses_stay_unless_others_are_clearly_more_alike) {
  const Scene upright = scenes::bound_body(RightSide::any_axes);
  const SkeletonMap same = make_skeleton_map(upright, upright);
  EXPECT_EQ(same.source_reference, PoseReference::rest);
  EXPECT_TRUE(same.source_pose.empty());
  Scene both = upright;  // Two files that rest in the same frame are alike at rest already.
  both.skeleton.rest = scenes::mid_motion(upright.skeleton.rest);
  const SkeletonMap at_rest = make_skeleton_map(both, both);
  EXPECT_EQ(at_rest.source_reference, PoseReference::rest);
  EXPECT_EQ(at_rest.target_reference, PoseReference::rest);
  const SkeletonMap one = make_skeleton_map(both, upright);
  EXPECT_EQ(one.source_reference, PoseReference::bind);
  EXPECT_EQ(one.target_reference, PoseReference::rest);
  SkeletonMapOptions options;
  options.source_reference = both.skeleton.rest;
  const SkeletonMap given = make_skeleton_map(both, upright, options);
  EXPECT_EQ(given.source_reference, PoseReference::rest) << "the rest pose, since the caller gave that";
  EXPECT_GT(given.bone_angle_rad, 0.1);
  Scene nearly = upright;
  for (Transform& t : nearly.skeleton.rest) t.rotation = normalised(quat_xyzw(0.0f, 0.001f, 0.0f, 1.0f) * t.rotation);
  EXPECT_EQ(make_skeleton_map(nearly, upright).source_reference, PoseReference::rest) << "less than half a degree";
}

}  // namespace
}  // namespace sinew
