// SPDX-License-Identifier: MIT
#include "runtime/pose/blend_poses.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/pose/blend_poses.cpp"
#include <hwy/foreach_target.h>

#include "runtime/pose/simd/pose_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

/// Adds a weighted transform, its rotation on the side of the pivot; sign(0) = +1.
HWY_INLINE void add(TransformLanes& sum, const TransformLanes& t, Lanes weight, const TransformLanes& pivot) {
  const Floats d;
  const Lanes turned = hn::IfThenElse(hn::Lt(dot4(pivot, t), hn::Zero(d)), hn::Neg(weight), weight);
  sum.tx = add_product(sum.tx, t.tx, weight);
  sum.ty = add_product(sum.ty, t.ty, weight);
  sum.tz = add_product(sum.tz, t.tz, weight);
  sum.rx = add_product(sum.rx, t.rx, turned);
  sum.ry = add_product(sum.ry, t.ry, turned);
  sum.rz = add_product(sum.rz, t.rz, turned);
  sum.rw = add_product(sum.rw, t.rw, turned);
  sum.sx = add_product(sum.sx, t.sx, weight);
  sum.sy = add_product(sum.sy, t.sy, weight);
  sum.sz = add_product(sum.sz, t.sz, weight);
}

/// Means from sums: divided by the total weight, the rotation by its length. The aligned sum has at least the pivot's
/// share of the total as length, so there is always a direction.
HWY_INLINE TransformLanes mean(const TransformLanes& sum, Lanes total) {
  const Floats d;
  const Lanes one = hn::Set(d, 1.0f), by_total = hn::Div(one, total);
  TransformLanes m = sum;
  m.rx = hn::Mul(m.rx, by_total);
  m.ry = hn::Mul(m.ry, by_total);
  m.rz = hn::Mul(m.rz, by_total);
  m.rw = hn::Mul(m.rw, by_total);
  const Lanes by_length = hn::Div(one, hn::Sqrt(dot4(m, m)));
  m.rx = hn::Mul(m.rx, by_length);
  m.ry = hn::Mul(m.ry, by_length);
  m.rz = hn::Mul(m.rz, by_length);
  m.rw = hn::Mul(m.rw, by_length);
  m.tx = hn::Mul(m.tx, by_total);
  m.ty = hn::Mul(m.ty, by_total);
  m.tz = hn::Mul(m.tz, by_total);
  m.sx = hn::Mul(m.sx, by_total);
  m.sy = hn::Mul(m.sy, by_total);
  m.sz = hn::Mul(m.sz, by_total);
  return m;
}

/// Blends one vector of joints from `j` on.
HWY_INLINE void blend_lanes(const BlendPosesJob& job, std::size_t j) {
  const Floats d;
  const Lanes zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const TransformLanes rest = load(job.rest, j);
  Lanes weight_sum = zero, largest = zero, contributors = zero;
  TransformLanes heaviest = rest;
  for (const BlendLayer& layer : job.layers) {
    const Lanes w = weight_of(layer, j);
    heaviest = choose(hn::Gt(w, largest), load(layer.pose, j), heaviest);
    largest = hn::Max(largest, w);
    weight_sum = hn::Add(weight_sum, w);
    contributors = hn::Add(contributors, hn::IfThenElseZero(hn::Gt(w, zero), one));
  }
  const Lanes rest_weight = hn::Max(hn::Sub(one, weight_sum), zero);
  const TransformLanes pivot = choose(hn::Gt(rest_weight, largest), rest, heaviest);
  TransformLanes sum{zero, zero, zero, zero, zero, zero, zero, zero, zero, zero};
  for (const BlendLayer& layer : job.layers) add(sum, load(layer.pose, j), weight_of(layer, j), pivot);
  add(sum, rest, rest_weight, pivot);
  const TransformLanes blended = mean(sum, hn::Add(weight_sum, rest_weight));
  // Where nothing is to be blended, the one transform that counts comes out bit for bit; without any layer that is
  // rest.
  const auto alone = hn::Or(hn::Eq(contributors, zero),
                            hn::And(hn::Eq(contributors, one), hn::Lt(rest_weight, hn::Set(d, kNegligible))));
  store(choose(alone, heaviest, blended), job.pose, j);
}

/// What the lanes of blend_lanes work out joint by joint, for layers without masks: the same for all joints.
struct SameForAllJoints {
  const BlendLayer* heaviest = nullptr;  ///< nullptr = rest
  float total = 0.0f, rest_weight = 1.0f;
  std::size_t contributors = 0;

  explicit SameForAllJoints(std::span<const BlendLayer> layers) {
    float largest = 0.0f, sum = 0.0f;
    for (const BlendLayer& layer : layers) {
      if (layer.weight < kNegligible) continue;
      if (layer.weight > largest) {
        largest = layer.weight;
        heaviest = &layer;
      }
      sum += layer.weight;
      ++contributors;
    }
    rest_weight = std::max(1.0f - sum, 0.0f);
    total = sum + rest_weight;
    if (rest_weight > largest) heaviest = nullptr;
    if (contributors == 1 && rest_weight < kNegligible) contributors = 0;
  }
  /// Nothing is to be blended: the heaviest transform comes out bit for bit.
  bool alone() const { return contributors == 0; }
};

/// The same means as blend_lanes, reading each pose once.
void blend_without_masks(const BlendPosesJob& job) {
  const Floats d;
  const SameForAllJoints same(job.layers);
  const PoseSpan& pivot_pose = same.heaviest == nullptr ? job.rest : same.heaviest->pose;
  const Lanes total = hn::Set(d, same.total), zero = hn::Zero(d);
  for (std::size_t j = 0; j < job.pose.joint_count; j += hn::Lanes(d)) {
    const TransformLanes pivot = load(pivot_pose, j);
    if (same.alone()) {
      store(pivot, job.pose, j);
      continue;
    }
    TransformLanes sum{zero, zero, zero, zero, zero, zero, zero, zero, zero, zero};
    for (const BlendLayer& layer : job.layers)
      if (layer.weight >= kNegligible) add(sum, load(layer.pose, j), hn::Set(d, layer.weight), pivot);
    if (same.rest_weight > 0.0f) add(sum, load(job.rest, j), hn::Set(d, same.rest_weight), pivot);
    store(mean(sum, total), job.pose, j);
  }
}

void blend_all(const BlendPosesJob& job) {
  if (std::none_of(job.layers.begin(), job.layers.end(),
                   [](const BlendLayer& layer) { return !layer.joint_weights.empty(); }))
    return blend_without_masks(job);
  for (std::size_t j = 0; j < job.pose.joint_count; j += hn::Lanes(Floats())) blend_lanes(job, j);
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

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
