// SPDX-License-Identifier: MIT
#include "importer/tool/cost/true_pose.h"

#include <algorithm>
#include <cmath>

#include "runtime/math/quaternion.h"

namespace sinew::cost {

LocalPose rest_pose(const Skeleton& skeleton) {
  LocalPose pose;
  for (const Transform& rest : skeleton.rest)
    pose.push_back({Vec3<double>(rest.translation), quat_cast<double>(rest.rotation), Vec3<double>(rest.scale)});
  return pose;
}

LocalPose true_local_pose(const Skeleton& skeleton, const Animation& animation, double time_s) {
  LocalPose pose = rest_pose(skeleton);
  for (const BoneAnimation& bone : animation.bones)
    pose[bone.joint] = bone.interpolate<double>(time_s, pose[bone.joint]);
  return pose;
}

LocalPose crooked_pose(const Skeleton& skeleton) {
  constexpr double kHalfAngle = 0.26179938779914943;  // of 30 degrees
  LocalPose pose = rest_pose(skeleton);
  for (std::size_t j = 0; j < pose.size(); ++j) {
    if (skeleton.parents[j] == kNone) continue;
    Vec3<double> axis(0.0);
    axis[static_cast<glm::length_t>(j % 3)] = std::sin(kHalfAngle);
    pose[j].rotation = pose[j].rotation * quat_xyzw(axis.x, axis.y, axis.z, std::cos(kHalfAngle));
  }
  return pose;
}

ModelPose model_pose(const Skeleton& skeleton, std::span<const Transformd> local) {
  ModelPose model(local.size());
  for (std::size_t j = 0; j < local.size(); ++j) {
    const std::uint32_t fixed = skeleton.fixed_matrix_of[j], parent = skeleton.parents[j];
    const Affined own =
        fixed == kNone ? affine_from_transform(local[j]) : affine_cast<double>(skeleton.fixed_matrices[fixed]);
    model[j] = parent == kNone ? own : model[parent] * own;
  }
  return model;
}

std::vector<double> times_of_large_errors(const Animation& animation, std::size_t most_intervals) {
  std::vector<float> keys;
  for (const BoneAnimation& bone : animation.bones)
    for (const auto* times : {&bone.translation.times_s, &bone.rotation.times_s, &bone.scale.times_s})
      keys.insert(keys.end(), times->begin(), times->end());
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  if (keys.empty()) return {0.0};
  std::vector<double> moments;
  const std::size_t intervals = keys.size() - 1, looked_at = std::min(intervals, most_intervals);
  for (std::size_t i = 0; i < looked_at; ++i) {
    const std::size_t k = i * intervals / looked_at;
    const auto begin = static_cast<double>(keys[k]), length = static_cast<double>(keys[k + 1]) - begin;
    for (const double share : {0.0, 0.2113, 0.5, 0.7887}) moments.push_back(begin + share * length);
  }
  if (moments.empty()) moments.push_back(static_cast<double>(keys.front()));
  return moments;
}

std::vector<double> timed_moments(double duration_s) {
  constexpr std::size_t kMoments = 16;
  std::vector<double> moments;
  for (std::size_t i = 0; i < kMoments; ++i)
    moments.push_back(duration_s * (static_cast<double>(i * 7 % kMoments) + 0.37) / static_cast<double>(kMoments));
  return moments;
}

}  // namespace sinew::cost
