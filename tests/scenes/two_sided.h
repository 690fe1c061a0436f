// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "runtime/animation/skeleton.h"
#include "tests/scenes/skeletons.h"
#include "tests/support/fixed_random.h"

/// A body that is symmetric about the plane x = 0. Its right joints' axes relate to the left ones as in common rigs.
namespace sinew::scenes {

enum class RightSide : std::uint8_t {
  mirrored_axes,   ///< axes are mirror images except that x is reversed, as in Blender
  opposite_axes,   ///< axes are mirror images with all three reversed, as in Unreal and Maya
  any_axes,        ///< axes are unrelated; positions are mirror images
  another_posture  ///< axes are unrelated, and bones have other lengths and directions
};

struct TwoSided {
  Skeleton skeleton;
  std::vector<std::uint32_t> partner;
};

/// 14 joints: hips, spine and head; on each side a leg, a foot, an arm, a forearm and a hand. `sword.l` is a child of
/// the left hand and its own partner.
inline TwoSided two_sided(RightSide right, std::uint64_t seed = 1) {
  test::FixedRandom random(seed);
  struct Bone {
    const char* name;
    std::uint32_t parent;
    Vec3<double> place;
  };
  const std::vector<Bone> bones = {
      {"hips", kNone, {0, 1, 0}},        {"spine", 0, {0, 1.2, 0.1}},        {"leg.l", 0, {0.1, 0.95, 0}},
      {"leg.r", 0, {-0.1, 0.95, 0}},     {"head", 1, {0, 1.7, 0}},           {"arm.l", 1, {0.2, 1.5, 0}},
      {"arm.r", 1, {-0.2, 1.5, 0}},      {"foot.l", 2, {0.12, 0.1, 0.05}},   {"foot.r", 3, {-0.12, 0.1, 0.05}},
      {"forearm.l", 5, {0.5, 1.4, 0.1}}, {"forearm.r", 6, {-0.5, 1.4, 0.1}}, {"hand.l", 9, {0.8, 1.3, 0.2}},
      {"hand.r", 10, {-0.8, 1.3, 0.2}},  {"sword.l", 11, {0.8, 1.6, 0.2}}};
  TwoSided made;
  std::vector<std::uint32_t> parents;
  for (const Bone& bone : bones) parents.push_back(bone.parent);
  made.skeleton = breadth_first(parents, std::vector<glm::vec3>(bones.size()));
  made.partner = {0, 1, 3, 2, 4, 6, 5, 8, 7, 10, 9, 12, 11, 13};
  std::vector<Quat<double>> axes;
  std::vector<Vec3<double>> places;
  for (std::uint32_t j = 0; j < bones.size(); ++j) {
    const std::uint32_t p = made.partner[j];
    // A center joint turns about x only. Its axes are then their own mirror image, except that x is reversed.
    Quat<double> own =
        p == j && j != 13 ? quat_xyzw(std::sin(0.1 * j), 0.0, 0.0, std::cos(0.1 * j)) : random.rotation<double>();
    if (p < j && right == RightSide::mirrored_axes) own = quat_xyzw(axes[p].x, -axes[p].y, -axes[p].z, axes[p].w);
    if (p < j && right == RightSide::opposite_axes) own = quat_xyzw(1.0, 0.0, 0.0, 0.0) * axes[p];
    axes.push_back(own);
    places.push_back(bones[j].place);
    if (p < j && right == RightSide::another_posture) places[j] += random.vec3<double>(-0.1, 0.1);
  }
  for (std::uint32_t j = 0; j < bones.size(); ++j) {
    const std::uint32_t parent = bones[j].parent;
    const Quat<double> above = parent == kNone ? quat_identity<double>() : quat_conjugate(axes[parent]);
    const Vec3<double> from = parent == kNone ? Vec3<double>(0.0) : places[parent];
    made.skeleton.rest[j] = {glm::vec3(rotate_vector(above, places[j] - from)), quat_cast<float>(above * axes[j]),
                             glm::vec3(1.0f)};
    made.skeleton.names[j] = bones[j].name;
  }
  return made;
}

/// Local transforms at a moderate random distance from the rest pose.
inline std::vector<Transform> moved_from_rest(const Skeleton& skeleton, std::uint64_t seed) {
  test::FixedRandom random(seed);
  std::vector<Transform> local;
  for (const Transform& rest : skeleton.rest) {
    const auto scale = static_cast<float>(random.in(0.8, 1.25));
    local.push_back({rest.translation + random.vec3(-0.1, 0.1), normalised(random.rotation_by(1.2) * rest.rotation),
                     rest.scale * scale});
  }
  return local;
}

inline constexpr RightSide kRightSides[] = {RightSide::mirrored_axes, RightSide::opposite_axes, RightSide::any_axes,
                                            RightSide::another_posture};

/// True if partners are mirror images of each other at rest. Mirroring then only copies and negates numbers.
inline constexpr bool is_symmetric(RightSide right) {
  return right == RightSide::mirrored_axes || right == RightSide::opposite_axes;
}

}  // namespace sinew::scenes
