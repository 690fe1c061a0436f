// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "runtime/animation/skeleton.h"
#include "runtime/math/affine.h"
#include "runtime/math/transform.h"
#include "runtime/procedures/springs/spring_frames.h"
#include "runtime/procedures/springs/spring_records.h"

namespace sinew::springs {

inline bool scales_evenly(const Transform& local) noexcept {
  return local.scale.x == local.scale.y && local.scale.x == local.scale.z;
}

/// Converts a local transform to the numbers that ticks need.
inline JointInput joint_input(const SpringRecord& record, const Transform& local) noexcept {
  const Vec scale(local.scale), bone = record.tail * scale;
  const Rot goal = record.goal == SpringGoal::rest ? record.rest : normalised(quat_cast<double>(local.rotation));
  const Vec axis = scales_evenly(local) ? record.axis * (scale.x < 0.0 ? -1.0 : 1.0) : direction_of(bone, record.axis);
  return {Vec(local.translation), goal, scale, bone, axis, std::abs(scale.x) * record.length};
}

/// World transform of a joint that springs read. It is kept to be interpolated between frames. Rotation and shape
/// (scale and shear) are separate, because the mean of two rotation matrices shrinks.
/// eq   linear part = R(rotation) * shape
struct InputFrame {
  Vec at{0.0};
  Rot rotation = quat_identity<double>();
  Mat shape{1.0};

  friend bool operator==(const InputFrame&, const InputFrame&) = default;
};

/// Splits a world matrix M.
/// eq   the first axis of the rotation is that of M, the second is as near as possible to that of M. If M mirrors, -M
///      is used
InputFrame input_frame_of(const Affined& world) noexcept;

/// Weights of three frames for a time between the last two frames, or after them.
struct FrameWeights {
  double earlier = 0.0, before = 0.0, now = 1.0;
};

/// in   fraction   of the way from the previous frame to this one; above 1 it extrapolates
///      now_s, before_s   seconds of the last two frames; 0 = unknown
/// eq   the parabola through the three places (Newton). A line is used if the two lengths differ by a factor of 4 or
///      more, and for extrapolation, because a parabola would amplify noise.
FrameWeights weights_at(double fraction, double now_s, double before_s) noexcept;

/// Weighted sum of three frames.
InputFrame interpolated(const InputFrame& earlier, const InputFrame& before, const InputFrame& now,
                        const FrameWeights& weights) noexcept;

/// True if the frame scales all directions equally, up to rounding of float.
bool is_uniform(const InputFrame& frame) noexcept;

/// Writes a frame to its slot: a rotation and a scale, or the columns of a matrix.
void place(const InputFrame& from, bool is_uniform, const Planes<double>& frames, std::size_t slot) noexcept;

inline MatrixFrame matrix_of(const InputFrame& from) noexcept {
  return {from.at, matrix_from_unit_quat(from.rotation) * from.shape};
}

/// Writes the numbers of a joint to its slot.
inline void place(const JointInput& from, double* planes, std::size_t stride, std::size_t slot) noexcept {
  const double all[input::count] = {
      from.translation.x, from.translation.y, from.translation.z, from.goal.x,  from.goal.y, from.goal.z,
      from.goal.w,        from.scale.x,       from.scale.y,       from.scale.z, from.bone.x, from.bone.y,
      from.bone.z,        from.axis.x,        from.axis.y,        from.axis.z,  from.length};
  for (std::size_t p = 0; p < input::count; ++p) planes[p * stride + slot] = all[p];
}

/// Numbers the joints of a definition by slots. Everything but SpringTables::slots is there.
void add_slots(const Skeleton& skeleton, SpringTables& tables);

}  // namespace sinew::springs
