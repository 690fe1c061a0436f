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

/// Factors of this moment that are the same for all joints.
struct Moment {
  Lanes u, across;
};

/// Offsets of the joints from `j` on, whose eight planes begin with `plane`.
HWY_INLINE Offsets decayed(const TransitionNumbers& numbers, std::size_t plane, const Moment& moment, std::size_t j) {
  const Floats d;
  const Lanes one = hn::Set(d, 1.0f);
  const std::size_t stride = numbers.stride();
  const float* at = numbers.plane(plane) + j;
  const auto load_plane = [&](std::size_t p) HWY_ATTR { return hn::LoadU(d, at + p * stride); };
  const Lanes s = hn::Min(hn::Mul(load_plane(3), moment.u), one);
  const Lanes left = hn::Sub(one, s), left2 = hn::Mul(left, left);
  const Lanes p = hn::Mul(hn::Mul(left2, left2), hn::Add(one, hn::Mul(load_plane(4), s)));
  const auto offset = [&](std::size_t c) HWY_ATTR {
    return hn::Add(hn::Mul(load_plane(c), p), hn::Mul(load_plane(5 + c), moment.across));
  };
  return {offset(0), offset(1), offset(2)};
}

/// Adds offsets to three planes of the pose.
HWY_INLINE void offset_vectors(const InertializeJob& job, std::size_t plane, PoseSpan::Plane to, const Moment& moment,
                               std::size_t j) {
  const Floats d;
  const Offsets by = decayed(job.numbers, plane, moment, j);
  const std::size_t stride = job.pose.pose.stride;
  float* const x = job.pose.pose.plane(to) + j;
  hn::StoreU(hn::Add(hn::LoadU(d, x), by.x), d, x);
  hn::StoreU(hn::Add(hn::LoadU(d, x + stride), by.y), d, x + stride);
  hn::StoreU(hn::Add(hn::LoadU(d, x + 2 * stride), by.z), d, x + 2 * stride);
}

HWY_INLINE void offset_rotations(const InertializeJob& job, const Moment& moment, std::size_t j) {
  const PoseSpan& pose = job.pose.pose;
  const Offsets by = decayed(job.numbers, 8, moment, j);
  const Rotations q = load_rotations(pose.planes, pose.stride, j);
  store(product(rotation_by_quarter(by.x, by.y, by.z), q), pose.planes, pose.stride, j);  // both are unit
}

void offset_all(const InertializeJob& job) {
  const Floats d;
  constexpr std::size_t kBlock = TransitionNumbers::kBlock, kFlags = 24;
  const float left = 1.0f - job.progress, across = job.progress * ((left * left) * (left * left));
  const Moment moment{hn::Set(d, job.progress), hn::Set(d, across)};
  for (std::size_t block = 0; block < job.numbers.joint_count; block += kBlock) {
    const float* const moves = job.numbers.plane(kFlags) + block;
    const std::size_t end = std::min(block + kBlock, job.numbers.joint_count);
    if (moves[0] != 0.0f)
      for (std::size_t j = block; j < end; j += hn::Lanes(d)) offset_vectors(job, 0, PoseSpan::tx, moment, j);
    if (moves[1] != 0.0f)
      for (std::size_t j = block; j < end; j += hn::Lanes(d)) offset_rotations(job, moment, j);
    if (moves[2] != 0.0f)
      for (std::size_t j = block; j < end; j += hn::Lanes(d)) offset_vectors(job, 16, PoseSpan::sx, moment, j);
  }
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {

/// Adds the decayed offsets to morph weights or properties, with the formula of the SIMD code.
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
