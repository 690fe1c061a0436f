// SPDX-License-Identifier: MIT
#include "runtime/retarget/skeleton_map.h"

#include <gtest/gtest.h>

#include "runtime/retarget/retarget_animation.h"
#include "tests/reference/mirror.h"
#include "tests/scenes/two_legs.h"
#include "tests/scenes/two_sided.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using scenes::RightSide;
using scenes::TwoSided;
using Vec3d = Vec3<double>;

constexpr std::uint32_t kArm = 5, kForearm = 9, kHand = 11;  // of the left side

/// The same body with the names of an Unreal rig.
Skeleton renamed(Skeleton skeleton) {
  skeleton.names = {"pelvis", "spine_01", "thigh_l",    "thigh_r",    "head",   "upperarm_l", "upperarm_r",
                    "foot_l", "foot_r",   "lowerarm_l", "lowerarm_r", "hand_l", "hand_r",     "prop"};
  return skeleton;
}

/// The body with names that identify humanoid bones.
Skeleton named(Skeleton skeleton) {
  skeleton.names[2] = "upperleg.l";
  skeleton.names[3] = "upperleg.r";
  return skeleton;
}

std::vector<Transformd> in_doubles(const std::vector<Transform>& local) {
  std::vector<Transformd> all;
  for (const Transform& t : local) {
    all.push_back(in_double(t));
    all.back().rotation = normalised(all.back().rotation);
  }
  return all;
}

std::vector<Transformd> retargeted(const SkeletonMap& map, const Skeleton& from, const Skeleton& to,
                                   const std::vector<Transform>& pose) {
  std::vector<Transformd> out(to.joint_count());
  retarget_pose(map, from, to, in_doubles(pose), out);
  return out;
}

std::vector<Transform> in_floats(const std::vector<Transformd>& local) {
  std::vector<Transform> all;
  for (const Transformd& t : local)
    all.push_back({glm::vec3(t.translation), quat_cast<float>(t.rotation), glm::vec3(t.scale)});
  return all;
}

Vec3d direction(const Skeleton& skeleton, const std::vector<Transformd>& local, std::uint32_t from, std::uint32_t to) {
  std::vector<Affined> model(local.size());
  model_from_local(skeleton, local, model);
  return glm::normalize(translation_of(model[to]) - translation_of(model[from]));
}

/// The definition of the map: in model space, each joint is turned from its rest pose like the joint that it follows.
void expect_same_turns(const Skeleton& from, const std::vector<Transform>& pose, const Skeleton& to,
                       const std::vector<Transformd>& found, const SkeletonMap& map) {
  const auto rest = reference::model_rotations(from, from.rest), posed = reference::model_rotations(from, pose);
  const auto own_rest = reference::model_rotations(to, to.rest), own = reference::model_rotations(to, in_floats(found));
  for (const MappedJoint& joint : map.joints) {
    const Mat3<double> turn = posed[joint.source] * glm::transpose(rest[joint.source]),
                       own_turn = own[joint.target] * glm::transpose(own_rest[joint.target]);
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(test::is_near(own_turn[c], turn[c], 2e-6)) << joint.target;
  }
}

TEST(skeleton_map, joints_turn_in_model_space_as_those_they_follow_whatever_their_axes) {
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    const Skeleton from = scenes::two_sided(RightSide::any_axes, seed).skeleton,
                   to = scenes::two_sided(RightSide::another_posture, seed + 20).skeleton;
    const SkeletonMap map = make_skeleton_map(from, to);
    ASSERT_EQ(map.joints.size(), 14u);
    const std::vector<Transform> pose = scenes::moved_from_rest(from, seed);
    expect_same_turns(from, pose, to, retargeted(map, from, to, pose), map);
  }
}

TEST(skeleton_map, the_rest_pose_becomes_the_rest_pose) {
  const Skeleton from = named(scenes::two_sided(RightSide::any_axes, 1).skeleton),
                 to = renamed(scenes::two_sided(RightSide::another_posture, 2).skeleton);
  const SkeletonMap map = make_skeleton_map(from, to, {.limbs = LimbDirections::of_rest});
  EXPECT_EQ(map.unmapped_target, (std::vector<std::uint32_t>{13})) << "nothing is like the prop";
  const std::vector<Transformd> found = retargeted(map, from, to, from.rest);
  for (std::uint32_t j = 0; j < found.size(); ++j) {
    EXPECT_LT(test::angle_between(found[j].rotation, to.rest[j].rotation), 1e-6) << j;
    EXPECT_TRUE(test::is_near(found[j].translation, Vec3d(to.rest[j].translation), 1e-6)) << j;
  }
}

/// One rests with its arms out, the other with its arms down: turns alone would let the arms hang by as much.
TEST(skeleton_map, arms_point_where_those_of_the_source_do_from_a_pose_to_t_pose) {
  const Skeleton from = named(scenes::two_sided(RightSide::mirrored_axes, 1).skeleton);
  Skeleton to = renamed(scenes::two_sided(RightSide::any_axes, 2).skeleton);
  to.rest[kArm].rotation = to.rest[kArm].rotation * test::FixedRandom(3).rotation_by(0.8);
  const std::vector<Transform> pose = scenes::moved_from_rest(from, 4);
  std::vector<Transform> turned = from.rest;
  for (std::size_t j = 0; j < turned.size(); ++j) turned[j].rotation = pose[j].rotation;
  const std::vector<Transformd> aligned = retargeted(make_skeleton_map(from, to), from, to, turned),
                                kept = retargeted(make_skeleton_map(from, to, {.limbs = LimbDirections::of_rest}), from,
                                                  to, turned);
  for (const auto& [a, b] : {std::pair{kArm, kForearm}, {kForearm, kHand}}) {
    const Vec3d expected = direction(from, in_doubles(turned), a, b);
    EXPECT_TRUE(test::is_near(direction(to, aligned, a, b), expected, 2e-6)) << a;
    EXPECT_FALSE(test::is_near(direction(to, kept, a, b), expected, 0.05)) << a;
  }
  for (const std::uint32_t joint : {0u, 1u, 2u, 3u, 4u, 7u, 8u})  // hips, spine, head, legs and feet
    EXPECT_LT(test::angle_between(aligned[joint].rotation, kept[joint].rotation), 1e-12) << joint;
}

TEST(skeleton_map, joints_that_one_side_alone_has_do_not_matter) {
  TwoSided body = scenes::two_sided(RightSide::any_axes, 1);
  const Skeleton from = body.skeleton;
  Skeleton to = scenes::two_sided(RightSide::any_axes, 2).skeleton;
  to.names[kForearm] = "something";  // no counterpart: it stays at rest, but its hand is mapped
  const SkeletonMap map = make_skeleton_map(from, to);
  EXPECT_EQ(map.unmapped_target, (std::vector<std::uint32_t>{kForearm}));
  EXPECT_EQ(map.unmapped_source, (std::vector<std::uint32_t>{kForearm}));
  const std::vector<Transform> pose = scenes::moved_from_rest(from, 6);
  const std::vector<Transformd> found = retargeted(map, from, to, pose);
  expect_same_turns(from, pose, to, found, map);
  EXPECT_LT(test::angle_between(found[kForearm].rotation, to.rest[kForearm].rotation), 1e-12);
}

TEST(skeleton_map, a_pair_that_does_not_hang_below_the_pair_above_it_is_left_out) {
  const Skeleton skeleton = scenes::two_sided(RightSide::any_axes).skeleton;
  SkeletonMapOptions options;
  options.pairs = {{kForearm, kArm}, {kArm, kForearm}};
  const SkeletonMap map = make_skeleton_map(skeleton, skeleton, options);
  ASSERT_EQ(map.joints.size(), 1u);
  EXPECT_EQ(map.joints[0].target, kArm);
}

TEST(skeleton_map, hips_move_by_the_ratio_of_heights_under_a_root_of_scale_100) {
  const Skeleton from = named(scenes::two_sided(RightSide::any_axes, 1).skeleton);
  Skeleton inner = renamed(scenes::two_sided(RightSide::any_axes, 2).skeleton);
  for (Transform& rest : inner.rest) rest.translation *= 2.0f;  // twice as tall, and the file uses centimetres
  std::vector<std::uint32_t> parents = {kNone};
  for (const std::uint32_t parent : inner.parents) parents.push_back(parent == kNone ? 0 : parent + 1);
  Skeleton to = scenes::breadth_first(parents, std::vector<glm::vec3>(parents.size()));
  to.rest[0] = {glm::vec3(0), quat_xyzw(-std::sqrt(0.5f), 0.0f, 0.0f, std::sqrt(0.5f)), glm::vec3(100.0f)};
  to.names[0] = "Armature";
  for (std::uint32_t j = 0; j < inner.joint_count(); ++j) {
    to.names[j + 1] = inner.names[j];
    to.rest[j + 1] = inner.rest[j];
    to.rest[j + 1].translation /= 100.0f;
  }
  to.rest[1].rotation = quat_conjugate(to.rest[0].rotation) * inner.rest[0].rotation;
  to.rest[1].translation = rotate_vector(quat_conjugate(to.rest[0].rotation), inner.rest[0].translation) / 100.0f;
  const SkeletonMap map = make_skeleton_map(from, to);
  EXPECT_NEAR(map.height_ratio, 2.0, 1e-5);
  std::vector<Transform> pose = from.rest;
  pose[0].translation += glm::vec3(0.1f, -0.2f, 0.3f);
  const std::vector<Transformd> found = retargeted(map, from, to, pose);
  std::vector<Affined> model(found.size());
  model_from_local(to, found, model);
  EXPECT_TRUE(
      test::is_near(translation_of(model[1]), Vec3d(inner.rest[0].translation) + 2.0 * Vec3d(0.1, -0.2, 0.3), 1e-5));
}

/// The body with a root joint on the ground, above the hips.
Skeleton with_root(const Skeleton& inner, const char* name) {
  std::vector<std::uint32_t> parents = {kNone};
  for (const std::uint32_t parent : inner.parents) parents.push_back(parent == kNone ? 0 : parent + 1);
  Skeleton made = scenes::breadth_first(parents, std::vector<glm::vec3>(parents.size()));
  made.names[0] = name;
  for (std::uint32_t j = 0; j < inner.joint_count(); ++j) {
    made.names[j + 1] = inner.names[j];
    made.rest[j + 1] = inner.rest[j];
  }
  return made;
}

Skeleton twice_as_tall(Skeleton skeleton) {
  for (Transform& rest : skeleton.rest) rest.translation *= 2.0f;
  return skeleton;
}

Vec3d place_of(const Skeleton& skeleton, const std::vector<Transformd>& local, std::uint32_t joint) {
  std::vector<Affined> model(local.size());
  model_from_local(skeleton, local, model);
  return translation_of(model[joint]);
}

/// Root motion: the root walks and turns, and the hips sway in it.
TEST(skeleton_map, a_root_joint_carries_the_character_by_the_ratio_of_the_hips_heights) {
  const Skeleton body = named(scenes::two_sided(RightSide::any_axes, 1).skeleton);
  const Skeleton tall = twice_as_tall(renamed(scenes::two_sided(RightSide::any_axes, 2).skeleton));
  const Skeleton from = with_root(body, "Root"), to = with_root(tall, "root"), bare = tall;
  std::vector<Transform> pose = from.rest;
  pose[0].translation = {1.0f, 0.0f, 3.0f};
  pose[0].rotation = quat_xyzw(0.0f, 0.6f, 0.0f, 0.8f);
  pose[1].translation += glm::vec3(0.1f, -0.2f, 0.3f);
  const SkeletonMap map = make_skeleton_map(from, to), to_bare = make_skeleton_map(from, bare),
                    back = make_skeleton_map(bare, from);
  for (const SkeletonMap* each : {&map, &to_bare}) EXPECT_NEAR(each->height_ratio, 2.0, 1e-5);
  EXPECT_NEAR(back.height_ratio, 0.5, 1e-5);
  ASSERT_EQ(map.joints[0].target, 0u);
  EXPECT_EQ(map.joints[0].source, 0u);
  const std::vector<Transformd> found = retargeted(map, from, to, pose),
                                whole_by_hips = retargeted(to_bare, from, bare, pose);
  EXPECT_TRUE(test::is_near(found[0].translation, Vec3d(2, 0, 6), 1e-5)) << "the root's own path";
  EXPECT_LT(test::angle_between(found[0].rotation, pose[0].rotation), 1e-6);
  const Vec3d hips = 2.0 * place_of(from, in_doubles(pose), 1);
  EXPECT_TRUE(test::is_near(place_of(to, found, 1), hips, 1e-5));
  EXPECT_TRUE(test::is_near(place_of(bare, whole_by_hips, 0), hips, 1e-5)) << "no root: the hips carry it all";
  std::vector<Transform> moved = bare.rest;
  moved[0].translation = {4.0f, 2.0f, 6.0f};
  const std::vector<Transformd> rooted = retargeted(back, bare, from, moved);
  EXPECT_EQ(rooted[0].translation, Vec3d(0.0)) << "a root that nothing moves rests";
  EXPECT_TRUE(test::is_near(place_of(from, rooted, 1), Vec3d(2, 1, 3), 1e-5));
}

TEST(skeleton_map, hips_move_by_the_height_ratio_for_any_root_scale) {
  const Skeleton body = named(scenes::two_sided(RightSide::any_axes, 1).skeleton),
                 tall = renamed(twice_as_tall(scenes::two_sided(RightSide::any_axes, 2).skeleton));
  const Vec3d step(0.1, -0.2, 0.3);
  for (const auto& [source_has_root, target_has_root, maps_root] :
       {std::array{0u, 0u, 0u}, {1u, 0u, 0u}, {0u, 1u, 0u}, {1u, 1u, 0u}, {1u, 1u, 1u}}) {
    const Skeleton from = source_has_root ? scenes::below_a_root(body) : body,
                   to = target_has_root ? scenes::below_a_root(tall) : tall;
    SkeletonMapOptions options;
    for (std::uint32_t j = 0; j < 13; ++j) options.pairs.push_back({j + source_has_root, j + target_has_root});
    if (maps_root) options.pairs.push_back({0, 0});
    const SkeletonMap map = make_skeleton_map(from, to, options);
    std::vector<Transform> pose = from.rest;
    const Transform root = source_has_root ? from.rest[0] : Transform{};
    pose[source_has_root].translation += rotate_vector(quat_conjugate(root.rotation), glm::vec3(step)) / root.scale;
    const Vec3d moved = place_of(to, retargeted(map, from, to, pose), target_has_root) -
                        place_of(to, in_doubles(to.rest), target_has_root);
    EXPECT_TRUE(test::is_near(moved, 2.0 * step, 2e-5)) << source_has_root << target_has_root << maps_root;
  }
}

TEST(skeleton_map, names_that_are_there_twice_on_either_side_are_not_followed) {
  const Skeleton skeleton = scenes::two_sided(RightSide::any_axes).skeleton;
  Skeleton twice = skeleton;
  twice.names[kHand + 1] = twice.names[kHand];
  const std::vector<std::uint32_t> both = {kHand, kHand + 1};
  EXPECT_EQ(make_skeleton_map(skeleton, twice).unmapped_target, both);
  EXPECT_EQ(make_skeleton_map(twice, skeleton).unmapped_source, both);
}

/// Hips, a left arm and all finger bones of its hand; joints have arbitrary axes.
Skeleton arm_with_fingers(std::uint64_t seed) {
  test::FixedRandom random(seed);
  std::vector<std::uint32_t> parents = {kNone, 0, 1, 2, 3, 3, 3, 3, 3};
  for (std::uint32_t finger = 4; finger < 14; ++finger) parents.push_back(finger);
  Skeleton skeleton = scenes::breadth_first(parents, std::vector<glm::vec3>(parents.size(), random.vec3(0.2, 0.4)));
  for (std::uint32_t j = 0; j < parents.size(); ++j) {
    skeleton.rest[j].rotation = quat_cast<float>(random.rotation<double>());
    skeleton.names[j] = std::to_string(seed) + "of" + std::to_string(j);
  }
  return skeleton;
}

TEST(skeleton_map, the_hand_and_every_bone_of_its_fingers_turn_with_the_lower_arm) {
  const Skeleton from = arm_with_fingers(1), to = arm_with_fingers(2);
  SkeletonMapOptions options;
  options.source_bones.assign(kHumanoidBones.size(), kNone);
  const char* arm[] = {"hips", "leftUpperArm", "leftLowerArm", "leftHand"};
  for (std::uint32_t j = 0; j < 4; ++j) options.source_bones[humanoid_bone(arm[j])] = j;
  for (std::uint32_t b = 0; b < 15; ++b)
    options.source_bones[humanoid_bone("leftThumbMetacarpal") + b] = 4 + b % 3 * 5 + b / 3;
  options.target_bones = options.source_bones;
  const SkeletonMap map = make_skeleton_map(from, to, options);
  ASSERT_EQ(map.joints.size(), 19u);
  const auto rest = reference::model_rotations(to, to.rest),
             own = reference::model_rotations(to, in_floats(retargeted(map, from, to, from.rest)));
  const auto turn = [&](std::uint32_t j) { return own[j] * glm::transpose(rest[j]); };
  EXPECT_FALSE(test::is_near(turn(2)[0], turn(1)[0], 0.1)) << "the lower arm turns by itself";
  for (std::uint32_t j = 3; j < 19; ++j)
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(test::is_near(turn(j)[c], turn(2)[c], 2e-6)) << j;
}

TEST(skeleton_map, translations_follow_the_rule_of_their_chain) {
  const Skeleton from = named(scenes::two_sided(RightSide::any_axes, 1).skeleton);
  const Skeleton to = renamed(twice_as_tall(scenes::two_sided(RightSide::any_axes, 2).skeleton));
  std::vector<Transform> pose = from.rest;
  for (Transform& local : pose) local.translation *= 1.5f;
  const auto found = [&](const SkeletonMapOptions& options) {
    return retargeted(make_skeleton_map(from, to, options), from, to, pose);
  };
  const auto stretch = [&](const std::vector<Transformd>& local, std::uint32_t joint) {
    return safe_length(local[joint].translation) / safe_length(Vec3d(to.rest[joint].translation));
  };
  const auto by_height = found({}), by_length = found({.translations = TranslationRule::by_length}),
             kept = found({.translations = TranslationRule::keep}),
             one_arm = found({.chains = {{kForearm, TranslationRule::by_length}, {kHand, TranslationRule::keep}}}),
             whole_arm = found({.chains = {{kForearm, TranslationRule::by_length}}});
  EXPECT_NEAR(stretch(by_height, 0), 1.5, 0.01) << "the hips move";
  EXPECT_NEAR(stretch(by_height, kForearm), 1.0, 1e-6);
  for (const std::uint32_t joint : {0u, kForearm, kHand}) {
    EXPECT_NEAR(stretch(by_length, joint), 1.5, 1e-5) << joint;
    EXPECT_NEAR(stretch(kept, joint), 1.0, 1e-6) << joint;
  }
  EXPECT_NEAR(stretch(one_arm, 0), 1.5, 0.01);
  EXPECT_NEAR(stretch(one_arm, kForearm), 1.5, 1e-5);
  EXPECT_NEAR(stretch(one_arm, kForearm + 1), 1.0, 1e-6) << "the other arm";
  EXPECT_NEAR(stretch(one_arm, kHand), 1.0, 1e-6);
  EXPECT_NEAR(stretch(whole_arm, kHand), 1.5, 1e-5) << "below the forearm";
}

TEST(skeleton_map, options_of_other_skeletons_are_refused) {
  const Skeleton skeleton = scenes::two_sided(RightSide::any_axes).skeleton;
  const auto joints = static_cast<std::uint32_t>(skeleton.joint_count());
  const auto code = [&](const SkeletonMapOptions& options) { return check(options, skeleton, skeleton); };
  EXPECT_EQ(code({.pairs = {{0, joints - 1}, {0, 1}}, .chains = {{1, TranslationRule::keep}, {0}}}), ErrorCode::ok);
  EXPECT_EQ(code({.pairs = {{joints, 0}}}), ErrorCode::index_out_of_range);
  EXPECT_EQ(code({.pairs = {{0, joints}}}), ErrorCode::index_out_of_range);
  EXPECT_EQ(code({.chains = {{joints}}}), ErrorCode::index_out_of_range);
  EXPECT_EQ(code({.pairs = {{0, 1}, {2, 1}}}), ErrorCode::unsupported);
  EXPECT_EQ(code({.chains = {{1}, {1}}}), ErrorCode::unsupported);
  EXPECT_EQ(code({.source_bones = {0}}), ErrorCode::size_mismatch);
  EXPECT_EQ(code({.target_bones = {0}}), ErrorCode::size_mismatch);
  EXPECT_DEATH(make_skeleton_map(skeleton, skeleton, {.pairs = {{joints, 0}}}), "contract broken: .*of its skeletons");
}

/// Bones that a file names take precedence over joint names. Bones that it does not name are not searched.
TEST(skeleton_map, bones_that_are_given_are_those_that_are_mapped) {
  const Skeleton source = named(scenes::two_sided(RightSide::mirrored_axes, 3).skeleton),
                 target = renamed(scenes::two_sided(RightSide::mirrored_axes, 4).skeleton);
  SkeletonMapOptions options;
  options.source_bones.assign(kHumanoidBones.size(), kNone);
  options.target_bones = options.source_bones;
  const auto say = [&](const char* bone, std::uint32_t from, std::uint32_t to) {
    options.source_bones[humanoid_bone(bone)] = from;
    options.target_bones[humanoid_bone(bone)] = to;
  };
  say("hips", 0, 0);
  say("leftHand", kForearm, kHand);
  const SkeletonMap map = make_skeleton_map(source, target, options);
  ASSERT_EQ(map.joints.size(), 2u);
  EXPECT_EQ(map.joints[1].source, kForearm);
  EXPECT_EQ(map.joints[1].target, kHand);
  EXPECT_EQ(map.target_bones, options.target_bones);
  EXPECT_GT(make_skeleton_map(source, target).joints.size(), 2u) << "by names";
  Skeleton leg = scenes::breadth_first({kNone, 0}, {{0, 1, 0}, {0.1f, 0, 0}});
  leg.names = {"hips", "leftUpperLeg"};
  options.source_bones = options.target_bones = find_humanoid_bones(leg);
  EXPECT_TRUE(make_skeleton_map(leg, leg, options).by_names) << "a skeleton onto itself";
}

}  // namespace
}  // namespace sinew
