// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>

#include "runtime/animation/skeleton.h"
#include "runtime/c/glue/convert.h"
#include "runtime/c/glue/pose_span.h"
#include "runtime/c/pose_program.h"
#include "runtime/c/procedures/ik.h"
#include "runtime/pose/pose.h"
#include "runtime/procedures/ik_result.h"

// Shared by the procedures of the C interface: conversions, and how a handle runs on a pose.

namespace sinew::c {

template <>
inline constexpr bool kSameBytes<sinew_point, Vec3<double>> = true;
template <>
inline constexpr bool kSameBytes<sinew_affine_double, Affined> = true;
template <>
inline constexpr bool kSameBytes<sinew_vec4, glm::quat> = true;
template <>
inline constexpr auto kEnum<IkStatus> = enum_values<IkStatus, sinew_ik_status>({{IkStatus::idle, SINEW_IK_IDLE},
                                                                                {IkStatus::reached, SINEW_IK_REACHED},
                                                                                {IkStatus::limited, SINEW_IK_LIMITED},
                                                                                {IkStatus::unreachable,
                                                                                 SINEW_IK_UNREACHABLE}});

/// The type of a handle, from a function void(Handle&, const PoseSpan& local, float share) that runs it.
template <class Function>
struct HandleOf;
template <class Handle>
struct HandleOf<void (*)(Handle&, const PoseSpan&, float) noexcept> {
  using Type = Handle;
};

/// sinew_pose_procedure::run for a handle.
template <auto Run>
void run_procedure(void* context, const sinew_procedure_pose* pose) {
  PoseSpan local;
  if (from_c(pose->local, local) == SINEW_OK)
    Run(*static_cast<typename HandleOf<decltype(Run)>::Type*>(context), local, pose->share);
}

/// Runs a handle on a pose of the caller, with a share of 1.
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH
template <auto Run>
sinew_error run_at_once(typename HandleOf<decltype(Run)>::Type& handle, const Skeleton& skeleton,
                        const sinew_pose* local) noexcept {
  PoseSpan pose;
  if (const sinew_error error = read_poses({{local, pose}})) return error;
  if (!is_pose_of(pose, skeleton.joint_count())) return SINEW_SIZE_MISMATCH;
  Run(handle, pose, 1.0f);
  return SINEW_OK;
}

/// Checks the root and the length of a frame.
/// err  SINEW_NOT_FINITE, SINEW_TIMES_NOT_INCREASING (dt_s below 0)
inline sinew_error check_step(const Affined& root, double dt_s) noexcept {
  for (const auto& row : root.row)
    for (int i = 0; i < 4; ++i)
      if (!std::isfinite(row[i])) return SINEW_NOT_FINITE;
  if (!std::isfinite(dt_s)) return SINEW_NOT_FINITE;
  return dt_s < 0.0 ? SINEW_TIMES_NOT_INCREASING : SINEW_OK;
}

/// Copies the state of a procedure to memory of the caller, or back.
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH (`size` is not the size of the state)
inline sinew_error copy_state(std::span<const std::byte> from, void* to, std::size_t size) noexcept {
  if (to == nullptr) return SINEW_NULL_ARGUMENT;
  if (size != from.size()) return SINEW_SIZE_MISMATCH;
  std::memcpy(to, from.data(), size);
  return SINEW_OK;
}

}  // namespace sinew::c
