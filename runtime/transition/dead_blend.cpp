// SPDX-License-Identifier: MIT
#include "runtime/transition/dead_blend.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/transition/dead_blend.cpp"
#include <hwy/foreach_target.h>

#include "runtime/math/negligible.h"
#include "runtime/transition/check_transition.h"
#include "runtime/transition/turn_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

/// Weight `w` of the target's pose, and how far the source has moved: `way` durations at its first velocity.
struct Fade {
  float w, way;
};

/// Mixes numbers of the extrapolated source with numbers of the target.
HWY_INLINE Lanes faded(Lanes source, Lanes velocity, Lanes target, const Fade& fade) {
  const Floats d;
  const Lanes went_on = hn::Add(source, hn::Mul(velocity, hn::Set(d, fade.way)));
  return hn::Add(hn::Mul(went_on, hn::Set(d, 1.0f - fade.w)), hn::Mul(target, hn::Set(d, fade.w)));
}

HWY_INLINE Rotations faded_rotation(const Rotations& source, const Rotations& turn, const Rotations& target,
                                    const Fade& fade) {
  const Floats d;
  const Lanes way = hn::Set(d, 0.25f * fade.way);
  const Rotations from =
      product(rotation_by_quarter(hn::Mul(turn.x, way), hn::Mul(turn.y, way), hn::Mul(turn.z, way)), source);
  const Lanes w = hn::Set(d, fade.w);
  const Lanes side = hn::IfThenElse(hn::Lt(dot4(from, target), hn::Zero(d)), hn::Neg(w), w);
  const Rotations a = scaled(from, hn::Set(d, 1.0f - fade.w)), b = scaled(target, side);
  return normalised({hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z), hn::Add(a.w, b.w)});
}

HWY_INLINE void fade_lanes(const TransitionNumbers& numbers, const PoseSpan& pose, const Fade& fade, std::size_t j) {
  const Floats d;
  const std::size_t stride = numbers.stride();
  const auto kept = [&](std::size_t p) HWY_ATTR { return hn::LoadU(d, numbers.planes + p * stride + j); };
  TransformLanes t = load(pose, j);
  const Rotations q = faded_rotation({kept(6), kept(7), kept(8), kept(9)}, {kept(10), kept(11), kept(12), kept(12)},
                                     {t.rx, t.ry, t.rz, t.rw}, fade);
  t = {faded(kept(0), kept(3), t.tx, fade),
       faded(kept(1), kept(4), t.ty, fade),
       faded(kept(2), kept(5), t.tz, fade),
       q.x,
       q.y,
       q.z,
       q.w,
       faded(kept(13), kept(16), t.sx, fade),
       faded(kept(14), kept(17), t.sy, fade),
       faded(kept(15), kept(18), t.sz, fade)};
  store(t, pose, j);
}

void fade_all(const TransitionNumbers& numbers, const PoseSpan& pose, float w, float way) {
  for (std::size_t j = 0; j < numbers.joint_count; j += hn::Lanes(Floats())) fade_lanes(numbers, pose, {w, way}, j);
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {

HWY_EXPORT(fade_all);

/// e^-x by its Taylor series. It uses only basic operations, so the bits do not depend on the C library.
/// in   x  [0, ln 2];   acc  1e-15
double exp_minus(double x) noexcept {
  double sum = 1.0;
  for (int n = 16; n > 0; --n) sum = 1.0 - sum * x / n;
  return sum;
}

/// eq   (1 - 2^(-4 u)) / (4 ln 2)
double way_of(double progress) noexcept {
  constexpr double kLn2 = 0.69314718055994530942;
  const double half = exp_minus(kLn2 * progress);
  return (1.0 - half * half * half * half) / (4.0 * kLn2);
}

void fade_numbers(std::span<const float> kept, float w, float way, std::span<float> numbers) noexcept {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = flushed((kept[3 * i] + kept[3 * i + 1] * way) * (1.0f - w) + numbers[i] * w);
}

}  // namespace

ErrorCode check(const DeadBlendJob& job) noexcept { return check_transition(job.numbers, job.progress, job.pose); }

void run_unchecked(const DeadBlendJob& job) noexcept {
  if (job.progress >= 1.0f) return;
  const double u = job.progress;
  const auto w = static_cast<float>(u * u * (3.0 - 2.0 * u)), way = static_cast<float>(way_of(u));
  HWY_DYNAMIC_DISPATCH(fade_all)(job.numbers, job.pose.pose, w, way);
  fade_numbers(job.numbers.weights, w, way, job.pose.weights);
  fade_numbers(job.numbers.properties, w, way, job.pose.properties);
}

}  // namespace sinew
#endif
