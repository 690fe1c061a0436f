// SPDX-License-Identifier: MIT
#include "runtime/jobs/blend_poses.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/jobs/blend_poses.cpp"
#include <hwy/foreach_target.h>

#include "runtime/jobs/blend_lanes-inl.h"

#if HWY_ONCE
namespace sinew {
namespace {

HWY_EXPORT(blend_all);

bool is_weight(float w) noexcept { return std::isfinite(w) && w >= 0.0f; }

}  // namespace

ErrorCode check(const BlendPosesJob& job) noexcept {
  const std::size_t joints = job.pose.joint_count;
  const auto fits = [&](const PoseSpan& p) {
    return p.joint_count == joints && p.stride == PoseSpan::stride_for(joints) && (joints == 0 || p.planes != nullptr);
  };
  if (!fits(job.pose) || !fits(job.rest)) return ErrorCode::size_mismatch;
  for (const BlendLayer& layer : job.layers) {
    if (!fits(layer.pose)) return ErrorCode::size_mismatch;
    if (!layer.joint_weights.empty() && layer.joint_weights.size() != joints) return ErrorCode::size_mismatch;
    if (!is_weight(layer.weight)) return ErrorCode::not_finite;
    if (!std::all_of(layer.joint_weights.begin(), layer.joint_weights.end(), is_weight)) return ErrorCode::not_finite;
  }
  return ErrorCode::ok;
}

void run(const BlendPosesJob& job) noexcept { HWY_DYNAMIC_DISPATCH(blend_all)(job); }

}  // namespace sinew
#endif  // HWY_ONCE
