// SPDX-License-Identifier: MIT
#include "runtime/retarget/hold_feet.h"

#include <gtest/gtest.h>

#include "runtime/retarget/leg_pose.h"
#include "runtime/retarget/retarget_animation.h"
#include "tests/scenes/two_legs.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using namespace scenes;

/// Squats while the foot stays in place: by the cosine rule for the two leg bones, in the plane of the leg.
Animation squat(const Skeleton& skeleton, const Build& build, double floor = 0.0) {
  Animation animation{"squat", 0.0, {}, {}};
  for (int i = 0; i <= 60; ++i) {
    const double s = i / 60.0, drop = 0.15 - 0.1 * std::cos(6.0 * s), forward = 0.1 * std::sin(5.0 * s);
    const double a = build.thigh, b = build.shank, height = a + b - drop, d = std::hypot(height, forward);
    const double inner = std::acos((a * a + b * b - d * d) / (2 * a * b)),
                 at_hip = std::acos((a * a + d * d - b * b) / (2 * a * d));
    const double lean = std::atan2(-forward, height);  // of the line from hip to ankle, positive forward
    add_key(skeleton, s, Vec3d(0, floor - drop, forward), {at_hip + lean, 3.14159265358979 - inner}, animation);
  }
  return animation;
}

/// Rises onto the toes, which stay in place, and comes down again.
Animation tiptoe(const Skeleton& skeleton, const Build& build) {
  Animation animation{"tiptoe", 0.0, {}, {}};
  for (int i = 0; i <= 60; ++i) {
    const double s = i / 60.0, heel = 0.6 * std::sin(3.0 * s);
    const Vec3d sole(0, 0.02 - build.ankle, build.foot);  // ankle to toes
    add_key(skeleton, s, sole - rotate_vector(about_x(heel), sole), {0, 0, heel}, animation);
  }
  return animation;
}

Vec3d place_of(const Skeleton& skeleton, const Animation& animation, std::uint32_t joint, double time_s) {
  TruthPose pose;
  evaluate_truth(animation, skeleton, time_s, pose);
  return translation_of(pose.model[joint]);
}

TEST(hold_feet, a_foot_that_stands_still_on_the_source_stands_still_on_the_target) {
  Bodies b;
  ASSERT_EQ(b.feet.legs.size(), 2u);
  const Animation animation = squat(b.source, {});
  const Vec3d stands = place_of(b.source, animation, left_foot, 0.0);
  for (double t = 0.0; t < 1.0; t += 0.0123)
    ASSERT_TRUE(test::is_near(place_of(b.source, animation, left_foot, t), stands, 2e-4)) << "the source stands still";
  Animation retargeted = retarget_animation(animation, b.map, b.source, b.target);
  const FootSlide before = measure_foot_slide(b.feet, animation, b.source, retargeted, b.target);
  EXPECT_GT(before.largest, 0.02) << "the legs have other proportions";
  hold_feet(b.feet, animation, b.source, b.target, retargeted);
  const FootSlide after = measure_foot_slide(b.feet, animation, b.source, retargeted, b.target);
  EXPECT_LT(after.largest, 2e-4);
  EXPECT_EQ(after.contacts, before.contacts);
  const Vec3d still = place_of(b.target, retargeted, left_foot, 0.0);
  EXPECT_TRUE(test::is_near(still, Vec3d(kSmall.width, kSmall.ankle, 0), 2e-4)) << "where it stands at rest";
  for (double t = 0.0; t < 1.0; t += 0.0123)
    EXPECT_TRUE(test::is_near(place_of(b.target, retargeted, left_foot, t), still, 3e-4)) << t;
}

TEST(hold_feet, the_slide_is_measured_from_where_a_foot_comes_down) {
  Bodies b;
  const Animation animation = squat(b.source, {});
  const Animation retargeted = retarget_animation(animation, b.map, b.source, b.target);
  const FootSlide slide = measure_foot_slide(b.feet, animation, b.source, retargeted, b.target);
  double farthest = 0.0;
  const Vec3d first = place_of(b.target, retargeted, left_foot, 0.0);
  for (int i = 0; i <= 60; ++i)
    farthest = std::max(farthest, glm::length(place_of(b.target, retargeted, left_foot, i / 60.0) - first));
  EXPECT_NEAR(slide.largest, farthest, 1e-3);
  EXPECT_EQ(slide.contacts, 4u) << "both ankles, and the toes of both, from the first time to the last";
  EXPECT_GT(slide.mean, 0.5 * farthest) << "all stray about as far";
}

TEST(hold_feet, a_foot_that_rolls_over_its_toes_rolls_over_its_toes) {
  Bodies b;
  const Animation animation = tiptoe(b.source, {});
  Animation retargeted = retarget_animation(animation, b.map, b.source, b.target);
  hold_feet(b.feet, animation, b.source, b.target, retargeted);
  const Vec3d rest_toes(kSmall.width, 0.02, kSmall.foot);
  for (const double t : {0.4, 0.5, 0.6})
    EXPECT_TRUE(test::is_near(place_of(b.target, retargeted, left_toes, t), rest_toes, 1e-4)) << t;
  EXPECT_GT(place_of(b.target, retargeted, left_foot, 0.5).y, kSmall.ankle + 0.03) << "the heel is up";
}

TEST(hold_feet, hips_come_down_where_a_leg_is_too_short_and_feet_in_the_air_stay_where_they_are) {
  Bodies b;
  Animation animation;
  add_key(b.source, 0.0, Vec3d(0, -0.04, 0.05), {0.5, 0.1, 0.0}, animation);  // both legs far ahead
  const Quatd lifted = about_x(1.2);                                          // the right knee
  animation.bones[right_shank].rotation.values[0] =
      quat_cast<float>(local_of(b.source, right_shank, about_x(-0.5), lifted));
  TruthPose pose;
  evaluate_truth(animation, b.source, 0.0, pose);
  std::vector<Transformd> plain(b.target.joint_count());
  retarget_pose(b.map, b.source, b.target, pose.local, plain);
  std::vector<Transformd> held = plain;
  const double ground = translation_of(pose.model[left_foot]).y - 0.1;
  hold_feet(b.feet, ground, pose.local, held);
  EXPECT_LT(held[hips].translation.y, plain[hips].translation.y - 0.002);
  std::vector<Affined> before(plain.size()), after(plain.size());
  model_from_local(b.target, plain, before);
  model_from_local(b.target, held, after);
  const Vec3d goal = Vec3d(kSmall.width, kSmall.ankle, 0) +
                     (translation_of(pose.model[left_foot]) - Vec3d(0.1, 0.1, 0)) * b.feet.ratio;
  EXPECT_TRUE(test::is_near(translation_of(after[left_foot]), goal, 1e-6));
  EXPECT_GT(glm::length(translation_of(before[left_foot]) - goal), 0.01);
  EXPECT_TRUE(test::is_near(translation_of(after[right_foot]), translation_of(before[right_foot]), 1e-9));
}

TEST(hold_feet, hips_come_down_by_a_fourth_of_the_targets_leg_at_most) {
  for (const Build& build : {kSmall, Build{0.8, 0.9, 0.2, 0.1, 0.1}}) {
    const Skeleton source = body({}, 1), target = body(build, 2);
    Bodies b{source, target};
    Animation animation;
    add_key(source, 0.0, Vec3d(0), {}, animation);
    TruthPose pose;
    evaluate_truth(animation, source, 0.0, pose);
    std::vector<Transformd> held(target.joint_count());
    retarget_pose(b.map, source, target, pose.local, held);
    const double before = held[hips].translation.y;
    FeetMap feet = b.feet;
    for (LegPair& leg : feet.legs) leg.target_foot.y -= 10.0;  // out of reach
    hold_feet(feet, 0.0, pose.local, held);
    EXPECT_NEAR(before - held[hips].translation.y, 0.25 * (build.thigh + build.shank), 1e-6);
  }
}

TEST(hold_feet, hips_that_come_down_once_in_between_get_keys_for_all_of_it) {
  Bodies b;
  const auto stand = [&](double time_s, double forward, const LegAngles& angles, Animation& animation) {
    Animation one;
    add_key(b.source, 0.0, Vec3d(0), angles, one);
    const double height = place_of(b.source, one, left_foot, 0.0).y - Build{}.ankle;
    add_key(b.source, time_s, Vec3d(0, -height, forward), angles, animation);
  };
  Animation animation;
  stand(0.0, 0.0, {0.3, 0.6, 0.0}, animation);
  stand(0.5, 0.05, {0.5, 0.1, 0.0}, animation);  // both legs far ahead
  stand(1.0, 0.0, {0.3, 0.6, 0.0}, animation);
  const Animation plain = retarget_animation(animation, b.map, b.source, b.target);
  Animation held = plain;
  hold_feet(b.feet, animation, b.source, b.target, held);
  const auto height = [&](const Animation& of, double time_s) { return place_of(b.target, of, hips, time_s).y; };
  EXPECT_NEAR(height(held, 1.0), height(plain, 1.0), 1e-6);
  EXPECT_LT(height(held, 0.5), height(plain, 0.5) - 0.002);
}

TEST(hold_feet, the_slide_is_the_mean_over_contacts_each_measured_by_itself) {
  Bodies b;
  Animation animation, slides;
  for (int i = 0; i <= 40; ++i) {  // down, up and down again; the target slides during the first contact
    const double up = i > 14 && i < 26 ? 0.5 : 0.0;
    add_key(b.source, 0.025 * i, Vec3d(0, up, 0), {}, animation);
    add_key(b.target, 0.025 * i, Vec3d(0.01 * std::min(i, 14), b.feet.ratio * up, 0), {}, slides);
  }
  const FootSlide slide = measure_foot_slide(b.feet, animation, b.source, slides, b.target);
  EXPECT_EQ(slide.contacts, 8u);
  EXPECT_NEAR(slide.largest, 0.14, 1e-6);
  EXPECT_NEAR(slide.mean, 0.07, 1e-6) << "the second time it stands still";
}

TEST(hold_feet, toes_count_where_both_bodies_have_them) {
  Bodies b;
  for (const std::uint32_t without : {0u, 1u}) {
    SkeletonMap map = b.map;
    std::vector<LegJoints> legs = {{left_thigh, left_shank, left_foot, left_toes}};
    if (without == 0) std::erase_if(map.joints, [](const MappedJoint& joint) { return joint.target == left_toes; });
    if (without == 1) legs[0].toes = kNone;
    const FeetMap feet = make_feet_map(map, b.source, b.target, legs);
    ASSERT_EQ(feet.legs.size(), 1u);
    EXPECT_EQ(feet.legs[0].source.toes, 0u);
    EXPECT_EQ(feet.legs[0].target.toes, 0u);
  }
}

TEST(hold_feet, hips_below_a_root_that_turns_and_scales_come_down_as_far) {
  Bodies b;
  const Skeleton below = below_a_root(b.target);
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::uint32_t j = 0; j < 9; ++j) pairs.push_back({j, j + 1});
  const SkeletonMap map = make_skeleton_map(b.source, below, {.pairs = pairs});
  const FeetMap feet = make_feet_map(map, b.source, below);
  ASSERT_EQ(feet.legs.size(), 2u);
  Animation animation;
  add_key(b.source, 0.0, Vec3d(0, -0.04, 0.05), {0.5, 0.1, 0.0}, animation);
  TruthPose pose;
  evaluate_truth(animation, b.source, 0.0, pose);
  std::vector<Transformd> plain(b.target.joint_count()), other(below.joint_count());
  retarget_pose(b.map, b.source, b.target, pose.local, plain);
  retarget_pose(map, b.source, below, pose.local, other);
  const double before = plain[hips].translation.y;
  const double ground = translation_of(pose.model[left_foot]).y - 0.1;
  hold_feet(b.feet, ground, pose.local, plain);
  hold_feet(feet, ground, pose.local, other);
  EXPECT_LT(plain[hips].translation.y, before - 0.002) << "they do come down";
  std::vector<Affined> model(plain.size()), model_below(other.size());
  model_from_local(b.target, plain, model);
  model_from_local(below, other, model_below);
  for (std::size_t j = 0; j < model.size(); ++j)
    EXPECT_TRUE(test::is_near(translation_of(model_below[j + 1]), translation_of(model[j]), 1e-6)) << j;
}

TEST(hold_feet, below_a_root_that_flattens_space_poses_stay_finite) {
  Bodies b;
  Skeleton flat = below_a_root(b.target);
  flat.rest[0].scale.y = 0.0f;
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::uint32_t j = 0; j < 9; ++j) pairs.push_back({j, j + 1});
  const SkeletonMap map = make_skeleton_map(b.source, flat, {.pairs = pairs});
  const FeetMap feet = make_feet_map(map, b.source, flat);
  const LiftedFoot foot(b, 0.0);
  std::vector<Transformd> held(flat.joint_count());
  retarget_pose(map, b.source, flat, foot.pose, held);
  hold_feet(feet, 0.3, foot.pose, held);
  for (const Transformd& joint : held) {
    EXPECT_TRUE(std::isfinite(safe_length(joint.translation)));
    EXPECT_TRUE(std::isfinite(safe_length(joint.rotation)));
  }
}

TEST(hold_feet, feet_keep_their_rotation) {
  Bodies b;
  const Animation animation = tiptoe(b.source, {}), plain = retarget_animation(animation, b.map, b.source, b.target);
  Animation held = plain;
  hold_feet(b.feet, animation, b.source, b.target, held);
  TruthPose before, after;
  for (const double t : {0.1, 0.5, 0.8}) {
    evaluate_truth(plain, b.target, t, before);
    evaluate_truth(held, b.target, t, after);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        EXPECT_NEAR(before.model[left_foot].row[row][column], after.model[left_foot].row[row][column], 1e-4);
  }
}

TEST(hold_feet, on_its_own_skeleton_an_animation_keeps_its_bits) {
  const Skeleton skeleton = body({}, 1);
  const SkeletonMap map = make_skeleton_map(skeleton, skeleton);
  const Animation animation = squat(skeleton, {});
  Animation held = animation;
  hold_feet(make_feet_map(map, skeleton, skeleton), animation, skeleton, skeleton, held);
  ASSERT_EQ(held.bones.size(), animation.bones.size());
  for (std::size_t i = 0; i < held.bones.size(); ++i)
    EXPECT_EQ(held.bones[i].rotation.values, animation.bones[i].rotation.values);
}

TEST(hold_feet, a_foot_in_the_air_is_as_it_was_and_comes_down_smoothly) {
  Bodies b;
  const LiftedFoot high(b, 0.5);
  std::vector<Transformd> held = high.held;
  hold_feet(b.feet, 0.0, high.pose, held);
  EXPECT_EQ(held, high.held);
  hold_feet(b.feet, 0.5, high.pose, held);
  EXPECT_NE(held, high.held) << "but not where the ground is as high";
  double last = 0.0;
  for (int i = 0; i <= 200; ++i) {
    const LiftedFoot foot(b, 0.15 - 0.001 * i);
    held = foot.held;
    hold_feet(b.feet, 0.0, foot.pose, held);
    const double turned = rotation_angle_between(held[left_thigh].rotation, foot.held[left_thigh].rotation);
    if (i > 0) {
      EXPECT_LT(std::abs(turned - last), 0.02) << i;
    }
    last = turned;
  }
  EXPECT_GT(last, 0.02);
}

TEST(hold_feet, a_foot_is_held_below_4_percent_of_the_leg_and_free_above_12) {
  Bodies b;
  const LegPair& leg = b.feet.legs[0];
  for (const auto& [height, held] : {std::pair{0.0, 1.0}, {0.04, 1.0}, {0.06, 0.84375}, {0.08, 0.5}, {0.12, 0.0}}) {
    LegPose<double> pose;
    pose.foot.place = leg.source_foot + Vec3d(0, 0.3 + height * 0.95, 0);
    pose.toes.place = leg.source_toes + Vec3d(0, 0.4 + height * 0.95, 0);
    EXPECT_NEAR(foot_contact(leg, pose, 0.3).held, held, 1e-6) << height;
  }
}

/// Direction of the straight left knee of a body, in model space at rest.
Vec3d bend_at_rest(const Build& build) {
  const Skeleton skeleton = body(build, 4);
  const FeetMap feet = make_feet_map(make_skeleton_map(skeleton, skeleton), skeleton, skeleton);
  Quatd thigh = quat_identity<double>();
  for (const std::uint32_t j : {hips, left_thigh}) thigh = thigh * quat_cast<double>(skeleton.rest[j].rotation);
  return rotate_vector(thigh, feet.legs.at(0).bend);
}

TEST(hold_feet, straight_knees_go_where_they_are_bent_at_rest_else_where_the_toes_point) {
  EXPECT_TRUE(test::is_near(bend_at_rest({}), normalised_or(Vec3d(0, -0.08, 0.15), Vec3d(0)), 1e-6));
  EXPECT_TRUE(test::is_near(bend_at_rest({.knee_back = 0.1}), Vec3d(0, 0, -1), 1e-6)) << "as birds have them";
}

/// Bend direction of a leg with five joints, hips to toes, at these places relative to their parents.
Vec3d bend_of_leg(const glm::vec3& knee, const glm::vec3& ankle, const glm::vec3& toes, bool has_toes) {
  Skeleton skeleton = test::chain_skeleton(5);
  const glm::vec3 places[] = {{0, 1, 0}, {0.1f, 0, 0}, knee, ankle, toes};
  for (std::size_t j = 0; j < 5; ++j) skeleton.rest[j].translation = places[j];
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::uint32_t j = 0; j < 5; ++j) pairs.push_back({j, j});
  const SkeletonMap map = make_skeleton_map(skeleton, skeleton, {.pairs = pairs});
  return make_feet_map(map, skeleton, skeleton, {{1, 2, 3, has_toes ? 4 : kNone}}).legs.at(0).bend;
}

TEST(hold_feet, knees_of_legs_that_are_straight_and_have_no_toes_go_forward) {
  const glm::vec3 down(0, -0.5f, 0), right(0.25f, 0, 0);
  EXPECT_TRUE(test::is_near(bend_of_leg(down, down, right, false), Vec3d(0, 0, 1), 1e-9));
  EXPECT_TRUE(test::is_near(bend_of_leg(down, down, right, true), Vec3d(1, 0, 0), 1e-9)) << "where the toes point";
  const glm::vec3 to_side(-0.1f, -0.5f, 0), back(0.1f, -0.5f, 0);
  EXPECT_TRUE(test::is_near(bend_of_leg(to_side, back, right, true), Vec3d(-1, 0, 0), 1e-6)) << "as it is bent";
  EXPECT_TRUE(test::is_near(bend_of_leg(glm::vec3(0), glm::vec3(0), right, false), Vec3d(0, 0, 1), 1e-9))
      << "a leg without length";
}

TEST(hold_feet, the_ground_is_where_the_feet_of_a_clip_are_lowest) {
  Bodies b;
  const Animation animation = squat(b.source, {}, 0.7);
  EXPECT_NEAR(find_ground(b.feet, animation, b.source), 0.7, 1e-4);
  EXPECT_EQ(find_ground({}, animation, b.source), 0.0);
  Animation dips = animation;
  dips.bones[hips].translation.values[30].y -= 0.3f;
  EXPECT_NEAR(find_ground(b.feet, dips, b.source), 0.7, 1e-4) << "for a moment";
}

TEST(hold_feet, the_ground_is_that_of_the_foot_that_stands_whichever_is_lifted) {
  Bodies b;
  for (const std::uint32_t lifted : {left_shank, right_shank}) {
    Animation animation;
    add_key(b.source, 0.0, Vec3d(0.0), {}, animation);
    animation.bones[lifted].rotation.values[0] =
        quat_cast<float>(local_of(b.source, lifted, quat_identity<double>(), about_x(1.2)));
    EXPECT_NEAR(find_ground(b.feet, animation, b.source), 0.0, 1e-6) << lifted;
  }
}

TEST(hold_feet, a_foot_that_stands_and_leaves_the_ground_at_the_end_is_held_while_it_stands) {
  Bodies b;
  Animation animation = squat(b.source, {});
  add_key(b.source, 1.5, Vec3d(0, 1, 0), {}, animation);
  Animation retargeted = retarget_animation(animation, b.map, b.source, b.target);
  hold_feet(b.feet, animation, b.source, b.target, retargeted);
  const Vec3d stands(kSmall.width, kSmall.ankle, 0);
  for (const double t : {0.0, 0.5, 0.9})
    EXPECT_TRUE(test::is_near(place_of(b.target, retargeted, left_foot, t), stands, 5e-4)) << t;
}

TEST(hold_feet, of_a_joint_with_two_animations_the_last_is_held) {
  Bodies b;
  const Animation animation = squat(b.source, {});
  Animation once = retarget_animation(animation, b.map, b.source, b.target), twice = once;
  twice.bones.insert(twice.bones.end(), once.bones.begin(), once.bones.end());
  for (Animation* held : {&once, &twice}) hold_feet(b.feet, animation, b.source, b.target, *held);
  EXPECT_EQ(place_of(b.target, twice, left_foot, 0.5), place_of(b.target, once, left_foot, 0.5));
}

TEST(hold_feet, the_upper_joint_of_a_leg_is_not_the_hips) {
  Bodies b;
  SkeletonMap map = b.map;
  std::erase_if(map.joints, [](const MappedJoint& joint) { return joint.target == hips; });
  for (MappedJoint& joint : map.joints)
    if (joint.above_target == hips) joint.above_target = joint.above_source = kNone;
  EXPECT_EQ(make_feet_map(map, b.source, b.target, {{left_thigh, left_shank, left_foot}}).hips, kNone);
}

TEST(hold_feet, hips_are_the_first_of_the_map_that_lie_above_all_legs) {
  Bodies b;
  EXPECT_EQ(b.feet.hips, static_cast<std::uint32_t>(hips));
  SkeletonMap map = b.map;
  map.joints.insert(map.joints.begin(), {left_toes, left_toes, kNone, kNone});
  map.joints.insert(map.joints.begin(), {left_foot, left_foot, hips, hips});
  EXPECT_EQ(make_feet_map(map, b.source, b.target).hips, static_cast<std::uint32_t>(hips));
  std::erase_if(map.joints, [](const MappedJoint& joint) { return joint.target == hips; });
  EXPECT_EQ(make_feet_map(map, b.source, b.target).hips, kNone) << "toes lie above no leg";
}

TEST(hold_feet, hips_with_a_fixed_matrix_do_not_come_down) {
  Bodies b;
  Skeleton target = b.target;
  target.fixed_matrices.emplace_back();
  target.fixed_matrix_of[hips] = 0;
  const FeetMap feet = make_feet_map(b.map, b.source, target);
  EXPECT_EQ(feet.legs.size(), 2u);
  EXPECT_EQ(feet.hips, kNone);
}

TEST(hold_feet, joints_with_a_fixed_matrix_stay_at_rest_whatever_tracks_they_have) {
  Bodies b;
  Skeleton target = b.target;
  target.fixed_matrices.emplace_back();
  target.fixed_matrix_of[hips] = 0;
  const FeetMap feet = make_feet_map(b.map, b.source, target);
  const Animation animation = squat(b.source, {});
  Animation held = retarget_animation(animation, b.map, b.source, target);
  std::erase_if(held.bones, [](const BoneAnimation& bone) { return bone.joint == hips; });
  Animation with_track = held;
  with_track.bones.push_back({.joint = hips, .translation = {Interpolation::step, {0.0f}, {glm::vec3(3, 4, 5)}}});
  hold_feet(feet, animation, b.source, target, held);
  hold_feet(feet, animation, b.source, target, with_track);
  ASSERT_EQ(with_track.bones.size(), held.bones.size() + 1);
  for (const BoneAnimation& bone : held.bones) {
    const auto same = std::find_if(with_track.bones.begin(), with_track.bones.end(),
                                   [&](const BoneAnimation& other) { return other.joint == bone.joint; });
    EXPECT_EQ(same->rotation.values, bone.rotation.values) << bone.joint;
  }
}

TEST(hold_feet, joints_below_another_of_the_map_are_not_the_hips) {
  const Bodies b;
  const Skeleton source = below_a_root(b.source);
  Skeleton target = below_a_root(b.target);
  target.fixed_matrices.emplace_back();
  target.fixed_matrix_of[0] = 0;
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::uint32_t j = 0; j < 10; ++j) pairs.push_back({j, j});
  const SkeletonMap map = make_skeleton_map(source, target, {.pairs = pairs});
  const FeetMap feet = make_feet_map(map, source, target);
  ASSERT_EQ(feet.legs.size(), 2u);
  EXPECT_EQ(feet.hips, kNone) << "the root is above them, and fixed";
}

TEST(hold_feet, legs_that_are_not_whole_are_left_out_and_others_may_be_named) {
  Bodies b;
  SkeletonMap map = b.map;
  map.target_bones.assign(kHumanoidBones.size(), kNone);
  EXPECT_TRUE(make_feet_map(map, b.source, b.target).legs.empty());
  const FeetMap named = make_feet_map(map, b.source, b.target, {{left_thigh, left_shank, left_foot}});
  ASSERT_EQ(named.legs.size(), 1u);
  EXPECT_EQ(named.legs[0].target.toes, 0u);
  EXPECT_TRUE(make_feet_map(map, b.source, b.target, {{left_thigh, right_shank, left_foot}}).legs.empty())
      << "not one below another";
  for (const LegJoints& part :
       {LegJoints{kNone, left_shank, left_foot}, {left_thigh, kNone, left_foot}, {left_thigh, left_shank, kNone}})
    EXPECT_TRUE(make_feet_map(map, b.source, b.target, {part}).legs.empty());
  EXPECT_EQ(
      make_feet_map(map, b.source, b.target, {{left_thigh, left_shank, left_foot, right_foot}}).legs[0].source.toes, 0u)
      << "toes of another foot are none";
}

}  // namespace
}  // namespace sinew
