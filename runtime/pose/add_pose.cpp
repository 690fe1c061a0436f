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

/// Turns the pose by the part `weight` of the delta, or back by it.
/// in   weight  >= 0
template <DeltaFrame kFrame, bool kSubtracts>
HWY_INLINE void add_rotation(TransformLanes& pose, const TransformLanes& layer, const TransformLanes& reference,
                             Lanes weight) {
  const Floats d;
  const Lanes one = hn::Set(d, 1.0f);
  const Rotations to{layer.rx, layer.ry, layer.rz, layer.rw};
  const Rotations back{hn::Neg(reference.rx), hn::Neg(reference.ry), hn::Neg(reference.rz), reference.rw};
  const Rotations delta = kFrame == DeltaFrame::parent ? product(to, back) : product(back, to);
  const Lanes side = hn::IfThenElse(hn::Lt(delta.w, hn::Zero(d)), hn::Neg(weight), weight);
  Rotations part{hn::Mul(side, delta.x), hn::Mul(side, delta.y), hn::Mul(side, delta.z),
                 hn::Add(hn::Sub(one, weight), hn::Mul(side, delta.w))};
  if (kSubtracts) part = {hn::Neg(part.x), hn::Neg(part.y), hn::Neg(part.z), part.w};
  const Rotations before{pose.rx, pose.ry, pose.rz, pose.rw};
  const Rotations q = normalised(kFrame == DeltaFrame::parent ? product(part, before) : product(before, part));
  pose.rx = q.x;
  pose.ry = q.y;
  pose.rz = q.z;
  pose.rw = q.w;
}

template <bool kSubtracts>
HWY_INLINE Lanes added_scale(Lanes scale, Lanes layer, Lanes reference, Lanes weight) {
  const Floats d;
  const Lanes one = hn::Set(d, 1.0f);
  const Lanes ratio = hn::IfThenElse(hn::Eq(reference, hn::Zero(d)), one, hn::Div(layer, reference));
  const Lanes factor = hn::Add(one, hn::Mul(weight, hn::Sub(ratio, one)));
  if (!kSubtracts) return hn::Mul(scale, factor);
  return hn::IfThenElse(hn::Eq(factor, hn::Zero(d)), scale, hn::Div(scale, factor));
}

HWY_INLINE auto same_rotation(const TransformLanes& a, const TransformLanes& b) {
  return hn::And(hn::And(hn::Eq(a.rx, b.rx), hn::Eq(a.ry, b.ry)), hn::And(hn::Eq(a.rz, b.rz), hn::Eq(a.rw, b.rw)));
}

/// Adds the layer for one vector of joints, starting at joint `j`.
template <DeltaFrame kFrame, bool kSubtracts>
HWY_INLINE void add_lanes(const AddPoseJob& job, std::size_t j) {
  const Floats d;
  const TransformLanes pose = load(job.pose, j), layer = load(job.layer, j), reference = load(job.reference, j);
  const Lanes size = weight_of(BlendLayer{job.layer, std::abs(job.weight), job.joint_weights}, j);
  const Lanes weight = kSubtracts ? hn::Neg(size) : size;
  TransformLanes sum = pose;
  sum.tx = add_product(pose.tx, hn::Sub(layer.tx, reference.tx), weight);
  sum.ty = add_product(pose.ty, hn::Sub(layer.ty, reference.ty), weight);
  sum.tz = add_product(pose.tz, hn::Sub(layer.tz, reference.tz), weight);
  add_rotation<kFrame, kSubtracts>(sum, layer, reference, size);
  const auto still = same_rotation(layer, reference);
  sum.rx = hn::IfThenElse(still, pose.rx, sum.rx);
  sum.ry = hn::IfThenElse(still, pose.ry, sum.ry);
  sum.rz = hn::IfThenElse(still, pose.rz, sum.rz);
  sum.rw = hn::IfThenElse(still, pose.rw, sum.rw);
  sum.sx = added_scale<kSubtracts>(pose.sx, layer.sx, reference.sx, size);
  sum.sy = added_scale<kSubtracts>(pose.sy, layer.sy, reference.sy, size);
  sum.sz = added_scale<kSubtracts>(pose.sz, layer.sz, reference.sz, size);
  store(choose(hn::Eq(size, hn::Zero(d)), pose, sum), job.pose, j);
}

template <DeltaFrame kFrame, bool kSubtracts>
void add_in_frame(const AddPoseJob& job) {
  for (std::size_t j = 0; j < job.pose.joint_count; j += hn::Lanes(Floats())) add_lanes<kFrame, kSubtracts>(job, j);
}

template <bool kSubtracts>
void add_joints(const AddPoseJob& job) {
  job.frame == DeltaFrame::parent ? add_in_frame<DeltaFrame::parent, kSubtracts>(job)
                                  : add_in_frame<DeltaFrame::joint, kSubtracts>(job);
}

void add_all(const AddPoseJob& job) { job.weight < 0.0f ? add_joints<true>(job) : add_joints<false>(job); }

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
ErrorCode check(const AddPoseJob& job) noexcept {
  const BlendLayer layers[] = {{job.layer, std::abs(job.weight), job.joint_weights}, {job.reference, 0.0f, {}}};
  return check(BlendPosesJob{layers, job.pose, job.pose});
}

SINEW_DISPATCH_RUN(AddPoseJob, add_all)

}  // namespace sinew
#endif
