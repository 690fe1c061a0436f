// SPDX-License-Identifier: MIT
#include "runtime/compress/moving_joints.h"

#include <algorithm>

#include "runtime/animation/track_sample.h"

namespace sinew {
namespace {

/// Number of poses in which the reach of each joint is measured, and the most points of all these poses.
constexpr std::size_t kMostPoses = 12, kMostPoints = 1'000'000;

void add_corners(const Affined& to_space, const Aabb& box, Aabb& sum) {
  const BoxCorners corners = corners_in_model(to_space, box);
  for (std::size_t i = 0; i < 8; ++i) sum.add(glm::vec3(Vec3<double>(corners[0][i], corners[1][i], corners[2][i])));
}

/// For each joint the tracks that count: of two tracks for one property the last one, as in evaluate_truth.
std::vector<std::array<std::uint32_t, 3>> tracks_of(const Animation& animation, const Skeleton& skeleton) {
  std::vector<std::array<std::uint32_t, 3>> bone_of(skeleton.joint_count(), {kNone, kNone, kNone});
  for (std::uint32_t b = 0; b < animation.bones.size(); ++b) {
    const BoneAnimation& bone = animation.bones[b];
    if (skeleton.fixed_matrix_of[bone.joint] != kNone) continue;
    if (!bone.translation.empty()) bone_of[bone.joint][0] = b;
    if (!bone.scale.empty()) bone_of[bone.joint][1] = b;
    if (!bone.rotation.empty()) bone_of[bone.joint][2] = b;
  }
  return bone_of;
}

/// Adds the places of the virtual vertices below each joint, in several poses.
void add_below(const Animation& animation, const Skeleton& skeleton, std::vector<MovingJoint>& joints) {
  std::size_t points = 1;
  std::vector<std::size_t> depth(joints.size(), 1);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].parent != kNone) depth[i] = depth[joints[i].parent] + 1;
    points += depth[i];
  }
  const std::size_t poses = std::clamp<std::size_t>(kMostPoints / points, 2, kMostPoses);
  std::vector<Affined> to_parent(joints.size());
  for (std::size_t pose = 0; pose < poses; ++pose) {
    const double time_s = animation.duration_s * static_cast<double>(pose) / static_cast<double>(poses - 1);
    for (std::size_t i = 0; i < joints.size(); ++i)
      to_parent[i] = joints[i].from_parent * affine_from_transform(local_at(joints[i], animation, skeleton, time_s));
    for (std::size_t i = 0; i < joints.size(); ++i) {
      Affined to_space;
      for (std::size_t at = i; joints[at].parent != kNone; at = joints[at].parent) {
        to_space = to_parent[at] * to_space;
        add_corners(to_space, joints[i].own, joints[joints[at].parent].below);
      }
    }
  }
}

}  // namespace

std::vector<MovingJoint> moving_joints(const Animation& animation, const Skeleton& skeleton,
                                       const VirtualVertices& vertices) {
  const std::vector<std::array<std::uint32_t, 3>> tracks = tracks_of(animation, skeleton);
  std::vector<MovingJoint> joints;
  // [J] index of the moving joint that each joint belongs to
  std::vector<std::uint32_t> owner(skeleton.joint_count(), kNone);
  // [J] constant: to the space of the owner, or to model space
  std::vector<Affined> to_owner(skeleton.joint_count());
  for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j) {
    const std::uint32_t parent = skeleton.parents[j];
    const Affined from_parent = parent == kNone ? Affined{} : to_owner[parent];
    const std::uint32_t above = parent == kNone ? kNone : owner[parent];
    if (tracks[j] != std::array<std::uint32_t, 3>{kNone, kNone, kNone}) {
      owner[j] = static_cast<std::uint32_t>(joints.size());
      joints.push_back({j, above, from_parent, {}, {}, tracks[j]});
    } else {
      const std::uint32_t fixed = skeleton.fixed_matrix_of[j];
      owner[j] = above;
      to_owner[j] = from_parent * (fixed == kNone ? affine_from_transform(in_double(skeleton.rest[j]))
                                                  : affine_cast<double>(skeleton.fixed_matrices[fixed]));
    }
    if (owner[j] != kNone) add_corners(to_owner[j], vertices.boxes[j], joints[owner[j]].own);
  }
  for (MovingJoint& joint : joints) joint.below = joint.own;
  add_below(animation, skeleton, joints);
  return joints;
}

Transformd local_at(const MovingJoint& joint, const Animation& animation, const Skeleton& skeleton, double time_s) {
  Transformd local = in_double(skeleton.rest[joint.joint]);
  const auto [translation, scale, rotation] = joint.bone_of;
  if (translation != kNone) local.translation = sample_track<double>(animation.bones[translation].translation, time_s);
  if (scale != kNone) local.scale = sample_track<double>(animation.bones[scale].scale, time_s);
  if (rotation != kNone) local.rotation = sample_track<double>(animation.bones[rotation].rotation, time_s);
  return local;
}

double longest_squared(const Affined& difference, const Aabb& box) noexcept {
  const BoxCorners corners = corners_in_model(difference, box);
  std::array<double, 8> squares;
  for (std::size_t i = 0; i < 8; ++i)
    squares[i] = corners[0][i] * corners[0][i] + corners[1][i] * corners[1][i] + corners[2][i] * corners[2][i];
  double largest = 0.0;
  for (const double square : squares) largest = largest < square ? square : largest;
  return largest;
}

}  // namespace sinew
