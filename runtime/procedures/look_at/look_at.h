// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <numbers>

#include <tl/expected.hpp>

#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/math/quaternion.h"
#include "runtime/pose/pose.h"
#include "runtime/pose_program/program_inputs.h"

namespace sinew {

/// How far eyes move for an angle between the face and the target.
/// eq   output min(angle, most_rad) / most_rad; the full output for any angle if most_rad is 0
struct GazeRange {
  float most_rad = std::numbers::pi_v<float> / 2;
  float output = 0.17f;  ///< radians for eyes that are joints; weight of an expression otherwise
};

/// How a face looks at things.
enum class EyeKind : std::uint8_t {
  joints,   ///< the eyes are joints, which turn
  weights,  ///< expressions move the eyes: Gaze has their weights, and the pose stays
};

/// Eyes of a character. Directions are those of model space in the rest pose.
struct EyesSetup {
  EyeKind kind = EyeKind::joints;
  std::uint32_t head = 0;
  std::uint32_t left = kNone, right = kNone;  ///< joints of the eyes; kNone = it has no such joint
  Vec3<float> between_eyes_m{0.0f};           ///< place in the space of the head
  Vec3<float> forward{0.0f, 0.0f, 1.0f}, up{0.0f, 1.0f, 0.0f};
  GazeRange inner, outer;  ///< of an eye towards the nose and away from it; weights use `outer`
  GazeRange down, upward;

  /// Angle from straight behind, and from straight above and below, within which eyes go back to the middle. So they do
  /// not snap to the other side when a target walks round the head. 0 = they snap, as VRM says.
  float fade_rad = 0.35f;
};

/// Eyes prepared for a skeleton. Immutable, shared by all characters on it.
struct Eyes {
  struct Eye {
    std::uint32_t joint = kNone;
    /// From axes of the face to those of the joint's parent, at rest.
    Quat<double> from_face = quat_identity<double>();
    Quat<double> rest = quat_identity<double>();  ///< local
  };
  EyesSetup setup;
  Quat<double> face_from_head = quat_identity<double>();  ///< axes of the face: x left, y up, z forward
  Eye left, right;
  std::uint32_t joint_count = 0;
};

/// err  index_out_of_range, not_finite, negative_weight (an angle below 0), unsupported (an eye with a fixed matrix,
///      `up` along `forward`)
/// cost O(depth)
SINEW_API tl::expected<Eyes, ErrorCode> prepare_eyes(const Skeleton& skeleton, const EyesSetup& setup);

/// Where a face looks. Angles are those of the target, seen from between the eyes.
struct Gaze {
  float yaw_rad = 0.0f;                                     ///< > 0: to the left of the face
  float pitch_rad = 0.0f;                                   ///< > 0: down
  float left = 0.0f, right = 0.0f, up = 0.0f, down = 0.0f;  ///< EyeKind::weights: of the expressions
  bool is_limited = false;                                  ///< an angle is beyond its range

  friend bool operator==(const Gaze&, const Gaze&) = default;
};

/// Eyes that look along a direction.
struct EyeTurns {
  Quat<double> left = quat_identity<double>(), right = quat_identity<double>();  ///< local, of EyeKind::joints
  Gaze gaze;
};

/// in   yaw_rad, pitch_rad  as in Gaze
/// cost O(1)
SINEW_API EyeTurns look_along(const Eyes& eyes, double yaw_rad, double pitch_rad) noexcept;

/// Turns eyes to a target (VRMC_vrm 1.0, lookAt). A face that has to turn, too, turns before it, by an AimJob.
/// eq   v = axes of the face of (head^-1 target - between_eyes);  yaw = atan2(v.x, v.z),  pitch = atan2(-v.y, |v.xz|)
///      turn = R_y(range(yaw)) R_x(range(pitch)), about the axes that the face has at rest
/// in   target  in model space, finite;   weight  [0, 1], 0 keeps every bit of the pose
/// io   local   rotations of the eyes
/// out  gaze    may be null. A target between the eyes, or a head of scale 0, leaves them straight
/// err  size_mismatch, not_finite, not_a_fraction     cost O(depth of the head), no allocation
struct LookAtJob {
  const Skeleton* skeleton = nullptr;
  PoseSpan local;
  const Eyes* eyes = nullptr;
  Vec3<double> target{0.0};
  float weight = 1.0f;
  Gaze* gaze = nullptr;
};

SINEW_API ErrorCode check(const LookAtJob& job) noexcept;
SINEW_API void run_unchecked(const LookAtJob& job) noexcept;

/// Eyes as a procedure of pose programs. The share of the operation multiplies the weight.
struct LookAt {
  const Eyes* eyes = nullptr;
  Vec3<double> target{0.0};
  float weight = 1.0f;
  Gaze gaze;                        ///< of the last run
  ErrorCode error = ErrorCode::ok;  ///< of the last run; if it is not ok, the pose is unchanged
};
/// out  version  hash of target, weight and address of the eyes, never 0
/// in   look  must stay in place until the frame is done
SINEW_API PoseProcedure as_procedure(LookAt& look) noexcept;

}  // namespace sinew
