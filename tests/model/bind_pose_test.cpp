// SPDX-License-Identifier: MIT
#include "runtime/model/bind_pose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scenes/bound_body.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using scenes::RightSide;
using testing::ElementsAre;
using testing::IsEmpty;

/// Largest difference of the model matrices of two poses.
double apart(const Skeleton& skeleton, const std::vector<Transform>& a, const std::vector<Transform>& b) {
  const auto one = scenes::model_matrices(skeleton, a), other = scenes::model_matrices(skeleton, b);
  double worst = 0.0;
  for (std::size_t j = 0; j < one.size(); ++j) worst = std::max(worst, test::distance(one[j], other[j]));
  return worst;
}

TEST(bind_pose, nodes_that_rest_in_mid_motion_do_not_hide_it) {
  for (const RightSide right : scenes::kRightSides) {
    Scene scene = scenes::bound_body(right);
    const std::vector<Transform> bind = scene.skeleton.rest;
    scene.skeleton.rest = scenes::mid_motion(bind);
    const BindPose found = bind_pose(scene);
    EXPECT_LT(apart(scene.skeleton, found.local, bind), 2e-6);
    EXPECT_EQ(found.differs.size(), bind.size());
    EXPECT_GT(found.distance, 0.1 * found.size);
    EXPECT_EQ(found.is_bound, std::vector<bool>(bind.size(), true));
  }
}

TEST(bind_pose, of_a_file_that_rests_in_it_has_the_bits_of_the_rest_pose) {
  Scene scene = scenes::bound_body(RightSide::any_axes);
  const BindPose found = bind_pose(scene);
  EXPECT_EQ(found.local, scene.skeleton.rest);
  EXPECT_THAT(found.differs, IsEmpty());
  EXPECT_THAT(found.other_skins, IsEmpty());
  scene.skeleton.rest[4].rotation = normalised(quat_xyzw(0.1f, 0.0f, 0.0f, 1.0f) * scene.skeleton.rest[4].rotation);
  EXPECT_THAT(bind_pose(scene).differs, ElementsAre(4u));
}

TEST(bind_pose, a_skeleton_in_centimetres_with_z_up_stands_below_its_armature) {
  const Skeleton body = scenes::two_sided(RightSide::any_axes).skeleton;
  Scene scene;
  scene.skeleton = scenes::below_armature(body);
  const std::vector<Transform> bind = scene.skeleton.rest;
  for (const bool mesh_is_below : {false, true}) {
    scene.skins.clear();
    scene.instances.clear();
    scene.skeleton.rest = bind;
    scenes::add_skin(scene, bind, scenes::all_joints(scene.skeleton, 1), scenes::centimetres_z_up(),
                     mesh_is_below ? 0u : 1u);
    std::vector<Transform> rest(bind.begin() + 1, bind.end());
    rest = scenes::mid_motion(rest);
    std::copy(rest.begin(), rest.end(), scene.skeleton.rest.begin() + 1);
    const BindPose found = bind_pose(scene);
    EXPECT_LT(apart(scene.skeleton, found.local, bind), 2e-6);
    EXPECT_EQ(found.local[0], bind[0]);
    EXPECT_FALSE(found.is_bound[0]);
  }
}

TEST(bind_pose, units_and_axes_that_no_node_has_are_found_by_the_rest_pose) {
  Scene scene;
  scene.skeleton = scenes::two_sided(RightSide::any_axes).skeleton;
  const std::vector<Transform> bind = scene.skeleton.rest;
  scenes::add_skin(scene, bind, scenes::all_joints(scene.skeleton), scenes::centimetres_z_up());
  scene.skeleton.rest = scenes::mid_motion(bind);
  EXPECT_LT(apart(scene.skeleton, bind_pose(scene).local, bind), 2e-6);
}

TEST(bind_pose, the_first_top_joint_keeps_its_place_where_no_space_fits) {
  Scene scene;
  scene.skeleton = scenes::two_sided(RightSide::any_axes).skeleton;
  const std::vector<Transform> bind = scene.skeleton.rest;
  const Affined far_off = affine_from_transform(
      Transformd{Vec3<double>(9.0, 0.0, 0.0), normalised(quat_xyzw(0.1, 0.2, 0.3, 1.0)), Vec3<double>(3.0)});
  scenes::add_skin(scene, bind, scenes::all_joints(scene.skeleton), far_off);
  scene.skeleton.rest = scenes::mid_motion(bind);
  const BindPose found = bind_pose(scene);
  EXPECT_EQ(found.local[0], scene.skeleton.rest[0]);
  for (std::size_t j = 1; j < bind.size(); ++j) {
    EXPECT_LT(test::distance(found.local[j].translation, bind[j].translation), 2e-6) << j;
    EXPECT_LT(test::angle_between(found.local[j].rotation, bind[j].rotation), 2e-6) << j;
  }
}

TEST(bind_pose, a_body_that_rests_as_it_was_bound_keeps_its_place_whatever_the_space_of_its_vertices) {
  Scene scene;
  scene.skeleton = scenes::two_sided(RightSide::any_axes).skeleton;
  const Affined of_integers = affine_from_transform(
      Transformd{Vec3<double>(-0.8, -0.1, -0.4), quat_identity<double>(), Vec3<double>(1.0 / 32767.0)});
  scenes::add_skin(scene, scene.skeleton.rest, scenes::all_joints(scene.skeleton), of_integers);
  EXPECT_EQ(bind_pose(scene).local, scene.skeleton.rest) << "quantised positions";
  scene.skins.clear();
  scene.instances.clear();
  scenes::add_skin(scene, scene.skeleton.rest, scenes::all_joints(scene.skeleton));
  scene.skeleton.rest[0].translation += glm::vec3(0.3f, 0.0f, 0.2f);
  EXPECT_EQ(bind_pose(scene).local, scene.skeleton.rest) << "the file puts it elsewhere";
}

TEST(bind_pose, joints_outside_of_skins_keep_their_rest_transform) {
  Scene scene;
  scene.skeleton = scenes::two_sided(RightSide::any_axes).skeleton;
  const std::vector<Transform> bind = scene.skeleton.rest;
  std::vector<std::uint32_t> joints = scenes::all_joints(scene.skeleton);
  std::erase(joints, 5u);   // an arm, with a bound forearm below
  std::erase(joints, 13u);  // the sword
  scenes::add_skin(scene, bind, joints);
  scene.skeleton.rest = scenes::mid_motion(bind);
  const BindPose found = bind_pose(scene);
  EXPECT_EQ(found.local[5], scene.skeleton.rest[5]);
  EXPECT_EQ(found.local[13], scene.skeleton.rest[13]);
  const auto expected = scenes::model_matrices(scene.skeleton, bind),
             model = scenes::model_matrices(scene.skeleton, found.local);
  for (const std::uint32_t j : joints) EXPECT_TRUE(test::is_near(model[j], expected[j], 2e-6)) << j;
}

TEST(bind_pose, skins_in_spaces_of_their_own_make_one_pose) {
  Scene scene;
  scene.skeleton = scenes::two_sided(RightSide::any_axes).skeleton;
  const std::vector<Transform> bind = scene.skeleton.rest;
  const Affined moved = affine_from_transform(
      Transformd{Vec3<double>(0.3, 0.1, 0.0), normalised(quat_xyzw(0.0, 0.4, 0.0, 1.0)), Vec3<double>(1.0)});
  scenes::add_skin(scene, bind, {5, 9, 11}, moved);  // the arm is shared, the rest is of this skin alone
  scenes::add_skin(scene, bind, {0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 12});
  scene.skeleton.rest = scenes::mid_motion(bind);
  const BindPose found = bind_pose(scene);
  const auto expected = scenes::model_matrices(scene.skeleton, bind),
             model = scenes::model_matrices(scene.skeleton, found.local);
  for (std::uint32_t j = 0; j < 13; ++j) EXPECT_TRUE(test::is_near(model[j], expected[j], 2e-6)) << j;
  EXPECT_THAT(found.other_skins, IsEmpty());
}

TEST(bind_pose, of_skins_in_several_poses_the_one_with_most_joints_counts) {
  Scene scene;
  scene.skeleton = scenes::two_sided(RightSide::any_axes).skeleton;
  const std::vector<Transform> bind = scene.skeleton.rest;
  scenes::add_skin(scene, scenes::mid_motion(bind, 8), {1, 4, 5, 9});
  scenes::add_skin(scene, bind, scenes::all_joints(scene.skeleton));
  scenes::add_skin(scene, bind, {6, 10});
  scene.skeleton.rest = scenes::mid_motion(bind);
  const BindPose found = bind_pose(scene);
  EXPECT_LT(apart(scene.skeleton, found.local, bind), 2e-6);
  EXPECT_THAT(found.other_skins, ElementsAre(0u));
}

TEST(bind_pose, skins_that_tell_nothing_leave_the_rest_pose) {
  Scene scene = scenes::bound_body(RightSide::any_axes);
  const std::vector<Transform> rest = scene.skeleton.rest = scenes::mid_motion(scene.skeleton.rest);
  std::vector<Affine>& inverse_bind = scene.skins[0].inverse_bind;
  const std::vector<Affine> sound = inverse_bind;
  inverse_bind.assign(inverse_bind.size(), Affine{});
  EXPECT_EQ(bind_pose(scene).local, rest) << "a file without inverse bind matrices";
  inverse_bind = sound;
  inverse_bind[4] = affine_from(Mat3<float>(0.0f), glm::vec3(0.0f));
  const BindPose found = bind_pose(scene);
  EXPECT_FALSE(found.is_bound[4]);
  EXPECT_EQ(found.local[4], rest[4]);
  EXPECT_TRUE(found.is_bound[1]);
  EXPECT_EQ(bind_pose(Scene{}).joint, kNone);
}

TEST(bind_pose, negative_scales_and_fixed_matrices_are_those_of_the_rest_pose) {
  Scene scene;
  scene.skeleton = scenes::two_sided(RightSide::any_axes).skeleton;
  scene.skeleton.rest[6].scale = {1.0f, -1.0f, 1.0f};
  scene.skeleton.rest[3].scale = {-1.0f, 1.0f, -1.0f};
  const std::vector<Transform> bind = scene.skeleton.rest;
  scenes::add_skin(scene, bind, scenes::all_joints(scene.skeleton));
  scene.skeleton.rest = scenes::mid_motion(bind);
  const BindPose found = bind_pose(scene);
  EXPECT_LT(apart(scene.skeleton, found.local, bind), 2e-6);
  EXPECT_EQ(found.local[6].scale, bind[6].scale);
  EXPECT_EQ(found.local[3].scale, bind[3].scale);
  scene.skeleton.fixed_matrices = {affine_from_transform(scene.skeleton.rest[1])};
  scene.skeleton.fixed_matrix_of[1] = 0;
  const BindPose fixed = bind_pose(scene);
  EXPECT_EQ(fixed.local[1], scene.skeleton.rest[1]) << "nothing can move the joint";
}

}  // namespace
}  // namespace sinew
