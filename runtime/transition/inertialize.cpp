// SPDX-License-Identifier: MIT
#include "runtime/transition/inertialize.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/transition/inertialize.cpp"
#include <hwy/foreach_target.h>

#include "runtime/math/negligible.h"
#include "runtime/pose/simd/dispatch.h"
#include "runtime/transition/check_transition.h"
#include "runtime/transition/turn_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

struct Offsets {
  Lanes x, y, z;
};

/// What all joints share at one progress.
struct Moment {
  Lanes u, across;
};

/// Offsets of the joints from `j` on, whose seven planes begin with `plane`.
HWY_INLINE Offsets decayed(const TransitionNumbers& numbers, std::size_t plane, const Moment& moment, std::size_t j) {
  const Floats d;
  const Lanes one = hn::Set(d, 1.0f), five = hn::Set(d, -5.0f);
  const std::size_t stride = numbers.stride();
  const float* at = numbers.plane(plane) + j;
  const auto load_plane = [&](std::size_t p) HWY_ATTR { return hn::LoadU(d, at + p * stride); };
  const Lanes k = load_plane(3);
  const Lanes s = hn::Min(hn::Mul(hn::Max(hn::Mul(k, hn::Set(d, -0.2f)), one), moment.u), one);
  const Lanes left = hn::Sub(one, s), left2 = hn::Mul(left, left);
  const Lanes slope = hn::Add(hn::Max(k, five), hn::Set(d, 4.0f));
  const Lanes p = hn::Mul(hn::Mul(left2, left2), hn::Add(one, hn::Mul(slope, s)));
  const auto offset = [&](std::size_t c) HWY_ATTR {
    return hn::Add(hn::Mul(load_plane(c), p), hn::Mul(load_plane(4 + c), moment.across));
  };
  return {offset(0), offset(1), offset(2)};
}

HWY_INLINE void offset_lanes(const InertializeJob& job, const Moment& moment, std::size_t j) {
  TransformLanes pose = load(job.pose.pose, j);
  const Offsets t = decayed(job.numbers, 0, moment, j), r = decayed(job.numbers, 7, moment, j),
                s = decayed(job.numbers, 14, moment, j);
  const Rotations q = normalised(product(rotation_by(r.x, r.y, r.z), {pose.rx, pose.ry, pose.rz, pose.rw}));
  pose = {hn::Add(pose.tx, t.x), hn::Add(pose.ty, t.y), hn::Add(pose.tz, t.z), q.x, q.y, q.z, q.w,
          hn::Add(pose.sx, s.x), hn::Add(pose.sy, s.y), hn::Add(pose.sz, s.z)};
  store(pose, job.pose.pose, j);
}

void offset_all(const InertializeJob& job) {
  const Floats d;
  const float left = 1.0f - job.progress, across = job.progress * ((left * left) * (left * left));
  const Moment moment{hn::Set(d, job.progress), hn::Set(d, across)};
  for (std::size_t j = 0; j < job.numbers.joint_count; j += hn::Lanes(d)) offset_lanes(job, moment, j);
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {

/// As the lanes, number by number.
void offset_numbers(std::span<const float> offsets, float u, std::span<float> numbers) noexcept {
  const float gone = 1.0f - u, across = u * ((gone * gone) * (gone * gone));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const float x = offsets[3 * i], k = offsets[3 * i + 1], r = offsets[3 * i + 2];
    const float s = std::min(std::max(k * -0.2f, 1.0f) * u, 1.0f), left = 1.0f - s;
    const float p = (left * left) * (left * left) * (1.0f + (std::max(k, -5.0f) + 4.0f) * s);
    numbers[i] = flushed(numbers[i] + (x * p + r * across));
  }
}

HWY_EXPORT(offset_all);

}  // namespace

ErrorCode check(const InertializeJob& job) noexcept { return check_transition(job.numbers, job.progress, job.pose); }

void run_unchecked(const InertializeJob& job) noexcept {
  if (job.progress >= 1.0f) return;
  HWY_DYNAMIC_DISPATCH(offset_all)(job);
  offset_numbers(job.numbers.weights, job.progress, job.pose.weights);
  offset_numbers(job.numbers.properties, job.progress, job.pose.properties);
}

}  // namespace sinew
#endif
