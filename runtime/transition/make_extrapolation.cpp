// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "runtime/math/quat_log_exp.h"
#include "runtime/transition/dead_blend.h"

namespace sinew {
namespace {

using Vec = Vec3<double>;

constexpr std::size_t kUsedPlanes = 19;

/// Velocity of a joint's rotation per duration.
Vec turning(const Quat<double>& now, const Quat<double>& before, double steps) noexcept {
  const Quat<double> step = now * quat_conjugate(before);
  const Vec v = quat_log(step.w < 0.0 ? step * -1.0 : step) * (2.0 * steps);
  constexpr double kMostSpeed = 9.2;  // half a turn in all: pi 4 ln 2 / (1 - 1 / 16)
  const double speed = safe_length(v);
  if (speed < 1e-7) return Vec(0.0);  // as in make_offsets
  const auto seen = [](double x) { return std::abs(x) < 1e-9 ? 0.0 : x; };
  const Vec turn(seen(v.x), seen(v.y), seen(v.z));
  return speed > kMostSpeed ? turn * (kMostSpeed / speed) : turn;
}

void make_number_extrapolation(std::span<const float> now, std::span<const float> before, double steps,
                               std::span<float> out) noexcept {
  for (std::size_t i = 0; i < now.size(); ++i) {
    out[3 * i] = now[i];
    out[3 * i + 1] = static_cast<float>((double{now[i]} - double{before[i]}) * steps);
    out[3 * i + 2] = 0.0f;
  }
}

}  // namespace

void make_extrapolation(const DeadBlendStart& start, const TransitionNumbers& numbers) noexcept {
  const double steps = start.steps;
  for (std::size_t j = 0; j < numbers.joint_count; ++j) {
    const Transform now = start.source.pose.get(j), before = start.source_before.pose.get(j);
    const Vec moving = (Vec(now.translation) - Vec(before.translation)) * steps,
              growing = (Vec(now.scale) - Vec(before.scale)) * steps,
              turn = turning(quat_cast<double>(now.rotation), quat_cast<double>(before.rotation), steps);
    const glm::vec3 move(moving), spin(turn), growth(growing);
    const float values[kUsedPlanes] = {
        now.translation.x, now.translation.y, now.translation.z, move.x,   move.y,  move.z, now.rotation.x,
        now.rotation.y,    now.rotation.z,    now.rotation.w,    spin.x,   spin.y,  spin.z, now.scale.x,
        now.scale.y,       now.scale.z,       growth.x,          growth.y, growth.z};
    for (std::size_t p = 0; p < kUsedPlanes; ++p) numbers.plane(p)[j] = values[p];
  }
  for (std::size_t p = 0; p < kUsedPlanes; ++p)  // padding keeps unit rotations
    std::fill(numbers.plane(p) + numbers.joint_count, numbers.plane(p) + numbers.stride(), p == 9 ? 1.0f : 0.0f);
  make_number_extrapolation(start.source.weights, start.source_before.weights, steps, numbers.weights);
  make_number_extrapolation(start.source.properties, start.source_before.properties, steps, numbers.properties);
}

}  // namespace sinew
