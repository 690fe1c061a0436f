// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/c/glue/convert.h"
#include "runtime/c/pose.h"
#include "runtime/pose/pose.h"

namespace sinew::c {

/// Converts the caller's pose to the view that jobs take. Jobs check its number of joints.
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH (not aligned)
template <>
struct Convert<sinew_pose, PoseSpan> {
  static sinew_error read(const sinew_pose& given, PoseSpan& pose) noexcept {
    if (given.planes == nullptr && given.joint_count > 0) return SINEW_NULL_ARGUMENT;
    if (reinterpret_cast<std::uintptr_t>(given.planes) % SINEW_POSE_ALIGNMENT != 0) return SINEW_SIZE_MISMATCH;
    pose = {given.planes, given.joint_count, PoseSpan::stride_for(given.joint_count)};
    return SINEW_OK;
  }
  static void write(const PoseSpan& pose, sinew_pose& out) noexcept { out = {pose.planes, pose.joint_count}; }
};

/// A pose of the caller and the span to read it into.
struct PoseArgument {
  const sinew_pose* given;
  PoseSpan& pose;
};

/// Reads poses that are arguments of a function, until one is refused.
/// err  those of the conversion, and SINEW_NULL_ARGUMENT if a pose is null
inline sinew_error read_poses(std::initializer_list<PoseArgument> arguments) noexcept {
  for (const auto& [given, pose] : arguments) {
    if (given == nullptr) return SINEW_NULL_ARGUMENT;
    if (const sinew_error error = from_c(*given, pose)) return error;
  }
  return SINEW_OK;
}

}  // namespace sinew::c
