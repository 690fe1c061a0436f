// SPDX-License-Identifier: MIT
#include "runtime/procedures/joint_limit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/animation/track.h"
#include "runtime/base/all_finite.h"
#include "runtime/math/axis_angle.h"

namespace sinew {
namespace {

constexpr double kPi = std::numbers::pi;

/// Swings between these angles fade towards the center.
constexpr double kFadeFrom_rad = 2.84, kFadeTo_rad = kPi;

struct Swing {
  double y = 0.0, z = 0.0;
};

/// The nearest point of the ellipse (y / a)^2 + (z / b)^2 <= 1 to a point outside of it.
/// eq   y' = a^2 y / (t + a^2), z' = b^2 z / (t + b^2), with the root t >= 0 of (y' / a)^2 + (z' / b)^2 = 1   (Eberly).
///      The left side decreases with t and is convex, so Newton's steps from the left never pass the root.
Swing nearest_on_ellipse(double y, double z, double a, double b) noexcept {
  if (b == 0.0) return {std::clamp(y, -a, a), 0.0};
  if (a == 0.0) return {0.0, std::clamp(z, -b, b)};
  const double u = a * std::abs(y), v = b * std::abs(z), aa = a * a, bb = b * b;
  double t = std::max({0.0, u - aa, v - bb});
  for (int i = 0; i < 64; ++i) {
    const double p = u / (t + aa), q = v / (t + bb);
    const double over = p * p + q * q - 1.0, slope = -2.0 * (p * p / (t + aa) + q * q / (t + bb));
    const double next = t - over / slope;
    if (!(next > t)) break;
    t = next;
  }
  return {aa * y / (t + aa), bb * z / (t + bb)};
}

/// The nearest allowed twist to a twist outside the interval. In the middle half of the gap it moves from the upper to
/// the lower end.
double nearest_twist(double twist, double least, double most) noexcept {
  const double gap = 2.0 * kPi - (most - least);
  double beyond = twist - most;  // angle into the gap, from the interval's upper end
  while (beyond < 0.0) beyond += 2.0 * kPi;
  while (beyond >= 2.0 * kPi) beyond -= 2.0 * kPi;
  if (beyond > gap) return twist;  // rounding put it just above the lower end, where it is allowed
  const double share = std::clamp(2.0 * beyond / gap - 0.5, 0.0, 1.0);
  return most + (least - most) * share;
}

}  // namespace

JointLimiter::JointLimiter(const JointLimit& limit) noexcept
    : axes_(normalised(quat_cast<double>(limit.axes))),
      axes_back_(quat_conjugate(axes_)),
      swing_y_(static_cast<double>(limit.swing_y_rad)),
      swing_z_(static_cast<double>(limit.swing_z_rad)),
      least_(static_cast<double>(limit.least_twist_rad)),
      most_(static_cast<double>(limit.most_twist_rad)),
      limits_swing_(limit.limits_swing),
      limits_twist_(limit.limits_twist) {
  to_ = normalised(quat_cast<double>(limit.center)) * axes_;
  from_ = quat_conjugate(to_);
}

LimitedRotation JointLimiter::operator()(const glm::dquat& rotation) const noexcept {
  glm::dquat q = from_ * rotation * axes_;
  if (q.w < 0.0) q = -q;
  // swing = (0, y, z, w) and twist = (x, 0, 0, w): q = swing twist gives tan(twist / 2) = x / w.
  const double cosine = std::sqrt(q.x * q.x + q.w * q.w), sine = std::sqrt(q.y * q.y + q.z * q.z);
  const double swing = 2.0 * std::atan2(sine, cosine);
  const double twist = cosine > 0.0 ? 2.0 * std::atan2(q.x, q.w) : 0.0;
  // The axis of the swing, after the twist is undone.
  const double c = cosine > 0.0 ? q.w / cosine : 1.0, s = cosine > 0.0 ? q.x / cosine : 0.0;
  const double y = q.y * c - q.z * s, z = q.y * s + q.z * c;
  const double scale = sine > 0.0 ? swing / sine : 0.0;
  Swing allowed{y * scale, z * scale};
  double allowed_twist = twist;
  bool is_limited = false;
  // Tests (y b)^2 + (z a)^2 <= (a b)^2 and each axis on its own, so that an ellipse with a = 0 or b = 0 needs no
  // division.
  const double by = allowed.y * swing_z_, bz = allowed.z * swing_y_, whole = swing_y_ * swing_z_;
  const bool is_outside =
      by * by + bz * bz > whole * whole || std::abs(allowed.y) > swing_y_ || std::abs(allowed.z) > swing_z_;
  if (limits_twist_ && (twist < least_ || twist > most_)) {
    allowed_twist = nearest_twist(twist, least_, most_);
    is_limited = is_limited || allowed_twist != twist;
  }
  if (limits_swing_ && is_outside) {
    allowed = nearest_on_ellipse(allowed.y, allowed.z, swing_y_, swing_z_);
    const double fade = std::clamp((kFadeTo_rad - swing) / (kFadeTo_rad - kFadeFrom_rad), 0.0, 1.0);
    const double middle = limits_twist_ ? std::clamp(0.0, least_, most_) : 0.0;
    allowed = {allowed.y * fade, allowed.z * fade};
    allowed_twist = middle + (allowed_twist - middle) * fade;
    is_limited = true;
  }
  if (!is_limited) return {rotation, false};
  const double angle = std::sqrt(allowed.y * allowed.y + allowed.z * allowed.z);
  const glm::dquat swung = quat_from_axis_angle(glm::dvec3(0.0, allowed.y, allowed.z), angle);
  const glm::dquat twisted = quat_xyzw(std::sin(allowed_twist / 2.0), 0.0, 0.0, std::cos(allowed_twist / 2.0));
  return {normalised(to_ * swung * twisted * axes_back_), true};
}

ErrorCode check(const JointLimit& limit) noexcept {
  const float numbers[] = {limit.center.x,    limit.center.y,    limit.center.z,        limit.center.w,
                           limit.axes.x,      limit.axes.y,      limit.axes.z,          limit.axes.w,
                           limit.swing_y_rad, limit.swing_z_rad, limit.least_twist_rad, limit.most_twist_rad};
  if (!all_finite(std::span<const float>(numbers))) return ErrorCode::not_finite;
  if (!is_unit(limit.center) || !is_unit(limit.axes)) return ErrorCode::not_normalised;
  const auto is_swing = [](float angle) { return angle >= 0.0f && angle <= kMostSwing_rad; };
  if (limit.limits_swing && !(is_swing(limit.swing_y_rad) && is_swing(limit.swing_z_rad))) return ErrorCode::too_large;
  const float range = limit.most_twist_rad - limit.least_twist_rad;
  const bool is_interval = range >= 0.0f && range <= kMostTwistRange_rad &&
                           std::max(-limit.least_twist_rad, limit.most_twist_rad) <= std::numbers::pi_v<float>;
  return !limit.limits_twist || is_interval ? ErrorCode::ok : ErrorCode::too_large;
}

}  // namespace sinew
