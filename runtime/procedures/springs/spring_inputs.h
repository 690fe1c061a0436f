// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "runtime/math/affine.h"
#include "runtime/math/transform.h"
#include "runtime/procedures/springs/spring_frames.h"
#include "runtime/procedures/springs/spring_records.h"

namespace sinew::springs {

inline bool scales_evenly(const Transform& local) noexcept {
  return local.scale.x == local.scale.y && local.scale.x == local.scale.z;
}

/// The numbers of a local transform that ticks need.
inline JointInput joint_input(const SpringRecord& record, const Transform& local) noexcept {
  const Vec scale(local.scale), bone = record.tail * scale;
  const Rot goal = record.goal == SpringGoal::rest ? record.rest : normalised(quat_cast<double>(local.rotation));
  const Vec axis = scales_evenly(local) ? record.axis * (scale.x < 0.0 ? -1.0 : 1.0) : direction_of(bone, record.axis);
  return {Vec(local.translation), goal, scale, bone, axis, std::abs(scale.x) * record.length};
}

/// A joint that springs read, as it is kept and interpolated between frames. Rotation and shape are apart, because a
/// mean of two matrices would shrink.
/// eq   linear part = R(rotation) * shape
struct InputFrame {
  Vec at{0.0};
  Rot rotation = quat_identity<double>();
  Mat shape{1.0};

  friend bool operator==(const InputFrame&, const InputFrame&) = default;
};

/// eq   the rotation has the first axis of M, and the second as near as it can be; of -M where M mirrors
InputFrame input_frame_of(const Affined& world) noexcept;

/// Weights of three frames at a time between the last two, or behind them.
struct FrameWeights {
  double earlier = 0.0, before = 0.0, now = 1.0;
};

/// in   fraction   of the way from the frame before to this one; beyond 1 it is extrapolated
///      now_s, before_s   lengths of the last two frames; 0 = unknown
/// eq   the parabola through the three places (Newton). It is a line where the two lengths differ by a factor of 4 or
///      more, and for extrapolation, since noise would grow.
FrameWeights weights_at(double fraction, double now_s, double before_s) noexcept;

/// The sum of three frames with weights.
InputFrame interpolated(const InputFrame& earlier, const InputFrame& before, const InputFrame& now,
                        const FrameWeights& weights) noexcept;

/// True if the frame scales all directions alike, within a rounding of float.
bool is_uniform(const InputFrame& frame) noexcept;

inline void place(const InputFrame& from, UniformFrame& out) noexcept {
  out = {from.at, from.rotation, (from.shape[0].x + from.shape[1].y + from.shape[2].z) * (1.0 / 3.0)};
}
inline void place(const InputFrame& from, MatrixFrame& out) noexcept {
  out = {from.at, matrix_from_unit_quat(from.rotation) * from.shape};
}

}  // namespace sinew::springs
