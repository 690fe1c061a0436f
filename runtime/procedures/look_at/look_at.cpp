// SPDX-License-Identifier: MIT
#include "runtime/procedures/look_at/look_at.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "runtime/base/bit_hash.h"
#include "runtime/math/axis_angle.h"
#include "runtime/math/decompose.h"
#include "runtime/math/inverse.h"
#include "runtime/math/matrix_rotation.h"
#include "runtime/procedures/joint_frames.h"

namespace sinew {
namespace {

constexpr double kClosest = 1e-3;  ///< in the space of the head; closer targets turn eyes less and less

/// Model rotation of a joint in the rest pose; the identity for kNone.
Quat<double> rest_rotation(const Skeleton& skeleton, std::uint32_t joint) noexcept {
  Quat<double> rotation = quat_identity<double>();
  for (; joint != kNone; joint = skeleton.parents[joint]) {
    const std::uint32_t fixed = skeleton.fixed_matrix_of[joint];
    rotation =
        (fixed == kNone ? quat_cast<double>(skeleton.rest[joint].rotation)
                        : decompose_polar(linear_part(affine_cast<double>(skeleton.fixed_matrices[fixed]))).quat) *
        rotation;
  }
  return normalised(rotation);
}

double ranged(const GazeRange& range, double angle) noexcept {
  const double most = static_cast<double>(range.most_rad), output = static_cast<double>(range.output);
  if (angle <= 0.0) return 0.0;
  return angle < most ? output * (angle / most) : output;
}

/// 0 at 0, 1 from `width` on, without a corner.
double rise(double angle, double width) noexcept {
  if (angle >= width) return 1.0;
  const double t = std::max(angle, 0.0) / width;
  return t * t * (3.0 - 2.0 * t);
}

/// Place of the target in axes of the face, seen from between the eyes. 0 for a head of scale 0.
Vec3<double> seen_from_face(const LookAtJob& job) noexcept {
  const EyesSetup& setup = job.eyes->setup;
  const auto back = inverse_of(model_matrix(*job.skeleton, job.local, setup.head));
  if (!back) return Vec3<double>(0.0);
  return rotate_vector(job.eyes->face_from_head,
                       transform_point(*back, job.target) - Vec3<double>(setup.between_eyes_m));
}

/// Local rotation of an eye.
/// in   left, right  ranges of the eye
Quat<double> turned(const EyesSetup& setup, const Eyes::Eye& eye, double yaw, double pitch, const GazeRange& left,
                    const GazeRange& right) noexcept {
  const double across = ranged(left, yaw) - ranged(right, -yaw);
  const double down = ranged(setup.down, pitch) - ranged(setup.upward, -pitch);
  const Quat<double> turn = quat_from_axis_angle(Vec3<double>(0.0, 1.0, 0.0), across) *
                            quat_from_axis_angle(Vec3<double>(1.0, 0.0, 0.0), down);
  return eye.from_face * turn * quat_conjugate(eye.from_face) * eye.rest;
}

void turn_eye(const LookAtJob& job, const Eyes::Eye& eye, const Quat<double>& wanted) noexcept {
  if (eye.joint == kNone) return;
  const Quat<double> now = normalised(quat_cast<double>(job.local.get(eye.joint).rotation));
  write_rotation(job.local, eye.joint, part_of_turn(now, wanted, static_cast<double>(job.weight)));
}

bool all_are_finite(const EyesSetup& setup) noexcept {
  double sum = static_cast<double>(setup.fade_rad);
  for (const GazeRange& range : {setup.inner, setup.outer, setup.down, setup.upward})
    sum += static_cast<double>(range.most_rad) + static_cast<double>(range.output);
  for (const Vec3<float>& v : {setup.between_eyes_m, setup.forward, setup.up})
    for (int i = 0; i < 3; ++i) sum += static_cast<double>(v[i]);
  return std::isfinite(sum);
}

void look_at_target(void* context, const ProcedurePose& pose) {
  LookAt& look = *static_cast<LookAt*>(context);
  look.error = run(LookAtJob{.skeleton = &pose.skeleton,
                             .local = pose.local,
                             .eyes = look.eyes,
                             .target = look.target,
                             .weight = look.weight * pose.share,
                             .gaze = &look.gaze});
}

}  // namespace

tl::expected<Eyes, ErrorCode> prepare_eyes(const Skeleton& skeleton, const EyesSetup& setup) {
  const auto joints = static_cast<std::uint32_t>(skeleton.joint_count());
  if (setup.head >= joints) return tl::unexpected(ErrorCode::index_out_of_range);
  for (const std::uint32_t eye : {setup.left, setup.right}) {
    if (eye == kNone) continue;
    if (eye >= joints) return tl::unexpected(ErrorCode::index_out_of_range);
    if (!can_turn(skeleton, eye)) return tl::unexpected(ErrorCode::unsupported);
  }
  if (!all_are_finite(setup)) return tl::unexpected(ErrorCode::not_finite);
  for (const GazeRange& range : {setup.inner, setup.outer, setup.down, setup.upward})
    if (range.most_rad < 0.0f) return tl::unexpected(ErrorCode::negative_weight);
  if (setup.fade_rad < 0.0f) return tl::unexpected(ErrorCode::negative_weight);
  const Vec3<double> z = normalised_or(Vec3<double>(setup.forward), Vec3<double>(0.0));
  const Vec3<double> x = glm::cross(normalised_or(Vec3<double>(setup.up), Vec3<double>(0.0)), z);
  if (!(safe_length(x) > 1e-6)) return tl::unexpected(ErrorCode::unsupported);
  const Vec3<double> left = normalised_or(x, Vec3<double>(1.0, 0.0, 0.0));
  const Quat<double> face = quat_from_matrix(Mat3<double>(left, glm::cross(z, left), z));
  const auto prepared = [&](std::uint32_t eye) {
    if (eye == kNone) return Eyes::Eye{};
    return Eyes::Eye{eye, normalised(quat_conjugate(rest_rotation(skeleton, skeleton.parents[eye])) * face),
                     normalised(quat_cast<double>(skeleton.rest[eye].rotation))};
  };
  return Eyes{setup, normalised(quat_conjugate(face) * rest_rotation(skeleton, setup.head)), prepared(setup.left),
              prepared(setup.right), joints};
}

EyeTurns look_along(const Eyes& eyes, double yaw_rad, double pitch_rad) noexcept {
  const EyesSetup& setup = eyes.setup;
  EyeTurns out;
  Gaze& gaze = out.gaze;
  gaze.yaw_rad = static_cast<float>(yaw_rad);
  gaze.pitch_rad = static_cast<float>(pitch_rad);
  const float most = std::min(setup.outer.most_rad, setup.inner.most_rad);
  gaze.is_limited = std::abs(yaw_rad) > static_cast<double>(most) ||
                    std::abs(pitch_rad) > static_cast<double>((pitch_rad > 0.0 ? setup.down : setup.upward).most_rad);
  const double fade = static_cast<double>(setup.fade_rad), upright = std::numbers::pi / 2.0 - std::abs(pitch_rad);
  const double share = rise(std::numbers::pi - std::abs(yaw_rad), fade) * rise(upright, fade);
  // The angle itself fades, so a range that ends before it still goes back to the middle.
  const double widest = static_cast<double>(std::max(setup.outer.most_rad, setup.inner.most_rad));
  const double yaw = share < 1.0 ? std::clamp(yaw_rad, -widest, widest) * share : yaw_rad;
  if (setup.kind == EyeKind::joints) {
    out.left = turned(setup, eyes.left, yaw, pitch_rad, setup.outer, setup.inner);
    out.right = turned(setup, eyes.right, yaw, pitch_rad, setup.inner, setup.outer);
  } else {
    gaze.left = static_cast<float>(ranged(setup.outer, yaw));
    gaze.right = static_cast<float>(ranged(setup.outer, -yaw));
    gaze.down = static_cast<float>(ranged(setup.down, pitch_rad));
    gaze.up = static_cast<float>(ranged(setup.upward, -pitch_rad));
  }
  return out;
}

ErrorCode check(const LookAtJob& job) noexcept {
  if (job.skeleton == nullptr || job.eyes == nullptr) return ErrorCode::size_mismatch;
  const std::size_t joints = job.skeleton->joint_count();
  if (job.eyes->joint_count != joints || !is_pose_of(job.local, joints)) return ErrorCode::size_mismatch;
  if (!std::isfinite(job.target.x) || !std::isfinite(job.target.y) || !std::isfinite(job.target.z))
    return ErrorCode::not_finite;
  return job.weight >= 0.0f && job.weight <= 1.0f ? ErrorCode::ok : ErrorCode::not_a_fraction;
}

void run_unchecked(const LookAtJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  if (job.gaze != nullptr) *job.gaze = {};
  if (job.weight == 0.0f) return;
  const Vec3<double> v = seen_from_face(job);
  const double near = rise(safe_length(v), kClosest);  // the direction of a target between the eyes is rounding
  const double yaw = std::atan2(v.x, v.z) * near, pitch = std::atan2(-v.y, std::hypot(v.x, v.z)) * near;
  EyeTurns eyes = look_along(*job.eyes, yaw, pitch);
  if (job.eyes->setup.kind == EyeKind::joints) {
    turn_eye(job, job.eyes->left, eyes.left);
    turn_eye(job, job.eyes->right, eyes.right);
  }
  if (job.gaze == nullptr) return;
  for (float* weight : {&eyes.gaze.left, &eyes.gaze.right, &eyes.gaze.up, &eyes.gaze.down}) *weight *= job.weight;
  *job.gaze = eyes.gaze;
}

PoseProcedure as_procedure(LookAt& look) noexcept {
  BitHash hash;
  const double numbers[] = {look.target.x, look.target.y, look.target.z, static_cast<double>(look.weight)};
  hash.add(std::span(numbers));
  const auto eyes = reinterpret_cast<std::uintptr_t>(look.eyes);
  hash.add(std::span(&eyes, 1));
  return {&look_at_target, &look, hash.value() | 1};
}

}  // namespace sinew
