// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "runtime/animation/truth_pose.h"
#include "runtime/retarget/feet_map.h"
#include "runtime/retarget/retarget_animation.h"
#include "tests/scenes/skeletons.h"
#include "tests/support/fixed_random.h"

// Bodies of hips and two legs in several proportions, and their motions.

namespace sinew::scenes {

using Vec3d = Vec3<double>;
using Quatd = Quat<double>;

/// Lengths of a body in metres: both leg bones, the foot from ankle to toes, and the height of the ankles.
struct Build {
  double thigh = 0.5, shank = 0.45, foot = 0.15, ankle = 0.1, width = 0.1, knee_back = 0.0;
};
inline constexpr Build kSmall{0.3, 0.4, 0.1, 0.08, 0.07};

enum Joint : std::uint32_t { hips, left_thigh, right_thigh, left_shank, right_shank, left_foot, right_foot, left_toes };

/// Hips and two straight legs. The joints' axes are random.
inline Skeleton body(const Build& build, std::uint64_t seed) {
  test::FixedRandom random(seed);
  const double knee = build.ankle + build.shank, hip = knee + build.thigh;
  const std::vector<std::uint32_t> parents = {kNone,      hips,        hips,      left_thigh, right_thigh,
                                              left_shank, right_shank, left_foot, right_foot};
  const Vec3d places[] = {{0, hip + 0.1, 0},
                          {build.width, hip, 0},
                          {-build.width, hip, 0},
                          {build.width, knee, -build.knee_back},
                          {-build.width, knee, -build.knee_back},
                          {build.width, build.ankle, 0},
                          {-build.width, build.ankle, 0},
                          {build.width, 0.02, build.foot},
                          {-build.width, 0.02, build.foot}};
  const char* names[] = {"Hips",     "LeftUpLeg", "RightUpLeg",  "LeftLeg",     "RightLeg",
                         "LeftFoot", "RightFoot", "LeftToeBase", "RightToeBase"};
  Skeleton skeleton = breadth_first(parents, std::vector<glm::vec3>(parents.size()));
  std::vector<Quatd> axes;
  for (std::uint32_t j = 0; j < parents.size(); ++j) {
    axes.push_back(random.rotation<double>());
    const bool is_root = parents[j] == kNone;
    const Quatd above = is_root ? quat_identity<double>() : quat_conjugate(axes[parents[j]]);
    skeleton.rest[j] = {glm::vec3(rotate_vector(above, is_root ? places[j] : places[j] - places[parents[j]])),
                        quat_cast<float>(above * axes[j]), glm::vec3(1.0f)};
    skeleton.names[j] = names[j];
  }
  return skeleton;
}

/// Local rotation with which a joint is turned by `turn` from rest in model space, when its parent is turned by
/// `above_turn`.
inline Quatd local_of(const Skeleton& skeleton, std::uint32_t joint, const Quatd& above_turn, const Quatd& turn) {
  Quatd rest = quat_identity<double>(), above = rest;
  for (std::uint32_t j = joint; j != kNone; j = skeleton.parents[j]) {
    rest = quat_cast<double>(skeleton.rest[j].rotation) * rest;
    if (j != joint) above = quat_cast<double>(skeleton.rest[j].rotation) * above;
  }
  return normalised(quat_conjugate(above_turn * above) * turn * rest);
}

inline Quatd about_x(double angle_rad) { return quat_xyzw(std::sin(angle_rad / 2), 0.0, 0.0, std::cos(angle_rad / 2)); }

/// Angles of both legs about x: thigh forward, bend of the knee, lift of the heel.
struct LegAngles {
  double thigh = 0.0, knee = 0.0, heel = 0.0;
};

/// Adds one key: the hips at rest plus `offset`, and both legs at `angles`.
inline void add_key(const Skeleton& skeleton, double time_s, const Vec3d& offset, const LegAngles& angles,
                    Animation& animation) {
  animation.bones.resize(7);
  animation.duration_s = time_s;
  const Quatd thigh = about_x(-angles.thigh), shank = about_x(angles.knee - angles.thigh), foot = about_x(angles.heel);
  const Quatd above[] = {quat_identity<double>(), thigh, shank}, turns[] = {thigh, shank, foot};
  for (std::uint32_t j = hips; j <= right_foot; ++j) {
    BoneAnimation& bone = animation.bones[j];
    bone.joint = j;
    if (j == hips) {
      bone.translation.times_s.push_back(static_cast<float>(time_s));
      bone.translation.values.push_back(skeleton.rest[hips].translation + glm::vec3(offset));
      continue;
    }
    const std::uint32_t part = (j - left_thigh) / 2;
    bone.rotation.times_s.push_back(static_cast<float>(time_s));
    bone.rotation.values.push_back(quat_cast<float>(local_of(skeleton, j, above[part], turns[part])));
  }
}

struct Bodies {
  Skeleton source = body({}, 1), target = body(kSmall, 2);
  SkeletonMap map = make_skeleton_map(
      source, target, {.pairs = {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {6, 6}, {7, 7}, {8, 8}}});
  FeetMap feet = make_feet_map(map, source, target);
};

/// A pose of the source whose left foot is `up` higher than at rest, and the retargeted pose of the target.
struct LiftedFoot {
  std::vector<Transformd> pose, held;

  LiftedFoot(const Bodies& b, double up) : held(b.target.joint_count()) {
    Animation animation;
    add_key(b.source, 0.0, Vec3d(0, up, 0), {0.3, 0.4, 0.1}, animation);
    TruthPose truth;
    evaluate_truth(animation, b.source, 0.0, truth);
    pose = truth.local;
    retarget_pose(b.map, b.source, b.target, pose, held);
  }
};

/// The same body below an extra root that rotates and scales by 0.01, as some exporters add.
inline Skeleton below_a_root(const Skeleton& skeleton) {
  constexpr float kScale = 0.01f;
  std::vector<std::uint32_t> parents = {kNone};
  for (const std::uint32_t parent : skeleton.parents) parents.push_back(parent == kNone ? 0 : parent + 1);
  Skeleton below = breadth_first(parents, std::vector<glm::vec3>(parents.size()));
  const glm::quat turn = quat_cast<float>(about_x(-1.5707963267948966));
  below.rest[0] = {glm::vec3(0.0f), turn, glm::vec3(kScale)};
  for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j) {
    Transform rest = skeleton.rest[j];
    if (j == hips) rest.translation = rotate_vector(quat_conjugate(turn), rest.translation);
    if (j == hips) rest.rotation = quat_conjugate(turn) * rest.rotation;
    rest.translation /= kScale;
    below.rest[j + 1] = rest;
    below.names[j + 1] = skeleton.names[j];
  }
  return below;
}

}  // namespace sinew::scenes
