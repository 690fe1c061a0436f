// SPDX-License-Identifier: MIT
#include "runtime/pose_program/mix_poses.h"

#include "runtime/base/index.h"
#include "runtime/math/interpolate.h"

namespace sinew {

Transform mixed(const Transform& below, const Transform& above, float w) noexcept {
  if (w <= 0.0f) return below;
  if (w >= 1.0f) return above;
  return {below.translation * (1.0f - w) + above.translation * w, nlerp_short_arc(below.rotation, above.rotation, w),
          below.scale * (1.0f - w) + above.scale * w};
}

void mix_numbers(std::span<const float> above, const MixShare& share, std::span<float> below) noexcept {
  for (std::size_t i = 0; i < below.size(); ++i) {
    const float w = share.of(i);
    below[i] = w < 1.0f ? flushed(below[i] * (1.0f - w) + above[i] * w) : above[i];
  }
}

void overlay_pose(const PoseSpan& above, const MixShare& share, const PoseSpan& below) noexcept {
  for (std::size_t j = 0; j < below.joint_count; ++j)
    if (const float w = share.of(j); w > 0.0f) below.set(j, mixed(below.get(j), above.get(j), w));
}

void overlay_pose_in_model_space(const Skeleton& skeleton, const PoseSpan& above, const MixShare& share,
                                 std::span<glm::quat> rotations, const PoseSpan& below) noexcept {
  const std::size_t joints = below.joint_count;
  const std::span<glm::quat> of_below = rotations.first(joints), of_above = rotations.subspan(joints, joints),
                             of_mix = rotations.subspan(2 * joints, joints);
  for (std::size_t j = 0; j < joints; ++j) {
    const std::uint32_t parent = skeleton.parents[j];
    const auto in_model_space = [&](std::span<const glm::quat> model, const glm::quat& local) {
      return parent == kNone ? local : normalised(model[parent] * local);
    };
    const Transform lower = below.get(j), upper = above.get(j);
    of_below[j] = in_model_space(of_below, lower.rotation);
    of_above[j] = in_model_space(of_above, upper.rotation);
    const float w = share.of(j);
    Transform local = mixed(lower, upper, w);
    if (w > 0.0f) {
      of_mix[j] = w < 1.0f ? normalised(slerp_short_arc(of_below[j], of_above[j], w)) : of_above[j];
      local.rotation = parent == kNone ? of_mix[j] : normalised(quat_conjugate(of_mix[parent]) * of_mix[j]);
    } else {
      of_mix[j] = in_model_space(of_mix, lower.rotation);
    }
    below.set(j, local);
  }
}

}  // namespace sinew
