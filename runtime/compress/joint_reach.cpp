// SPDX-License-Identifier: MIT
#include "runtime/compress/joint_reach.h"

#include <algorithm>
#include <cmath>

#include "runtime/animation/truth_pose.h"
#include "runtime/math/affine.h"
#include "runtime/math/quaternion.h"

namespace sinew {
namespace {

constexpr int kReachPoses = 16;

double distance_between(const Vec3<double>& a, const Vec3<double>& b) noexcept { return safe_length(a - b); }

/// Raises the reach of every joint to its reach in one pose.
void raise(const Skeleton& skeleton, const VirtualVertices& vertices, const TruthPose& pose,
           std::vector<JointReach>& reach) {
  const std::size_t joints = skeleton.joint_count();
  std::vector<double> radius(joints, 0.0);
  for (std::size_t j = joints; j-- > 0;) {
    const Vec3<double> origin = translation_of(pose.model[j]);
    for (const Vec3<double>& corner : corners_of(vertices.boxes[j]))
      radius[j] = std::max(radius[j], distance_between(transform_point(pose.model[j], corner), origin));
    const std::uint32_t parent = skeleton.parents[j];
    const double stretch = parent == kNone ? 1.0 : largest_stretch(pose.model[parent]);
    if (parent != kNone)
      radius[parent] =
          std::max(radius[parent], distance_between(origin, translation_of(pose.model[parent])) + radius[j]);
    const Vec3<double> s = glm::abs(pose.local[j].scale);
    const double smallest = std::min({s.x, s.y, s.z});
    reach[j].translation = std::max(reach[j].translation, stretch);
    reach[j].rotation = std::max(reach[j].rotation, radius[j]);
    if (smallest > 0.0) reach[j].scale = std::max(reach[j].scale, radius[j] / smallest);
  }
}

}  // namespace

std::vector<JointReach> joint_reach(const Animation& animation, const Skeleton& skeleton,
                                    const VirtualVertices& vertices) {
  std::vector<JointReach> reach(skeleton.joint_count());
  TruthPose pose;
  for (int i = 0; i < kReachPoses; ++i) {
    evaluate_truth(animation, skeleton, animation.duration_s * i / (kReachPoses - 1), pose);
    raise(skeleton, vertices, pose, reach);
  }
  return reach;
}

}  // namespace sinew
