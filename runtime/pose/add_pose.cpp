// SPDX-License-Identifier: MIT
#include "runtime/pose/add_pose.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/pose/add_pose.cpp"
#include <hwy/foreach_target.h>

#include "runtime/pose/simd/dispatch.h"
#include "runtime/pose/simd/pose_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

template <DeltaFrame kFrame>
HWY_INLINE void add_rotation(TransformLanes& pose, const TransformLanes& layer, const TransformLanes& reference,
                             Lanes weight) {
  const Floats d;
  const Lanes one = hn::Set(d, 1.0f);
  const Rotations to{layer.rx, layer.ry, layer.rz, layer.rw};
  const Rotations back{hn::Neg(reference.rx), hn::Neg(reference.ry), hn::Neg(reference.rz), reference.rw};
  const Rotations delta = kFrame == DeltaFrame::parent ? product(to, back) : product(back, to);
  const Lanes side = hn::IfThenElse(hn::Lt(delta.w, hn::Zero(d)), hn::Neg(weight), weight);
  const Rotations part{hn::Mul(side, delta.x), hn::Mul(side, delta.y), hn::Mul(side, delta.z),
                       hn::Add(hn::Sub(one, weight), hn::Mul(side, delta.w))};
  const Rotations before{pose.rx, pose.ry, pose.rz, pose.rw};
  const Rotations q = normalised(kFrame == DeltaFrame::parent ? product(part, before) : product(before, part));
  pose.rx = q.x;
  pose.ry = q.y;
  pose.rz = q.z;
  pose.rw = q.w;
}

HWY_INLINE Lanes added_scale(Lanes scale, Lanes layer, Lanes reference, Lanes weight) {
  const Floats d;
  const Lanes one = hn::Set(d, 1.0f);
  const Lanes ratio = hn::IfThenElse(hn::Eq(reference, hn::Zero(d)), one, hn::Div(layer, reference));
  return hn::Mul(scale, hn::Add(one, hn::Mul(weight, hn::Sub(ratio, one))));
}

HWY_INLINE auto same_rotation(const TransformLanes& a, const TransformLanes& b) {
  return hn::And(hn::And(hn::Eq(a.rx, b.rx), hn::Eq(a.ry, b.ry)), hn::And(hn::Eq(a.rz, b.rz), hn::Eq(a.rw, b.rw)));
}

/// Adds the layer for one vector of joints, starting at joint `j`.
template <DeltaFrame kFrame>
HWY_INLINE void add_lanes(const AddPoseJob& job, std::size_t j) {
  const Floats d;
  const TransformLanes pose = load(job.pose, j), layer = load(job.layer, j), reference = load(job.reference, j);
  const Lanes weight = weight_of(BlendLayer{job.layer, job.weight, job.joint_weights}, j);
  TransformLanes sum = pose;
  sum.tx = add_product(pose.tx, hn::Sub(layer.tx, reference.tx), weight);
  sum.ty = add_product(pose.ty, hn::Sub(layer.ty, reference.ty), weight);
  sum.tz = add_product(pose.tz, hn::Sub(layer.tz, reference.tz), weight);
  add_rotation<kFrame>(sum, layer, reference, weight);
  const auto still = same_rotation(layer, reference);
  sum.rx = hn::IfThenElse(still, pose.rx, sum.rx);
  sum.ry = hn::IfThenElse(still, pose.ry, sum.ry);
  sum.rz = hn::IfThenElse(still, pose.rz, sum.rz);
  sum.rw = hn::IfThenElse(still, pose.rw, sum.rw);
  sum.sx = added_scale(pose.sx, layer.sx, reference.sx, weight);
  sum.sy = added_scale(pose.sy, layer.sy, reference.sy, weight);
  sum.sz = added_scale(pose.sz, layer.sz, reference.sz, weight);
  store(choose(hn::Eq(weight, hn::Zero(d)), pose, sum), job.pose, j);
}

template <DeltaFrame kFrame>
void add_in_frame(const AddPoseJob& job) {
  for (std::size_t j = 0; j < job.pose.joint_count; j += hn::Lanes(Floats())) add_lanes<kFrame>(job, j);
}

void add_all(const AddPoseJob& job) {
  job.frame == DeltaFrame::parent ? add_in_frame<DeltaFrame::parent>(job) : add_in_frame<DeltaFrame::joint>(job);
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
ErrorCode check(const AddPoseJob& job) noexcept {
  const BlendLayer layers[] = {{job.layer, job.weight, job.joint_weights}, {job.reference, 0.0f, {}}};
  return check(BlendPosesJob{layers, job.pose, job.pose});
}

SINEW_DISPATCH_RUN(AddPoseJob, add_all)

}  // namespace sinew
#endif
