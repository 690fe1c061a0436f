// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/c/boundary.h"
#include "runtime/c/pose.h"
#include "runtime/pose/pose.h"

namespace sinew::c {

/// The caller's pose as jobs see it. Its number of joints is theirs to check.
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH (not aligned)
inline sinew_error read_pose(const sinew_pose* given, PoseSpan& pose) noexcept {
  if (given == nullptr || (given->planes == nullptr && given->joint_count > 0)) return SINEW_NULL_ARGUMENT;
  if (reinterpret_cast<std::uintptr_t>(given->planes) % SINEW_POSE_ALIGNMENT != 0) return SINEW_SIZE_MISMATCH;
  pose = {given->planes, given->joint_count, PoseSpan::stride_for(given->joint_count)};
  return SINEW_OK;
}

/// The same, of a scene.
inline sinew_error read_pose(const sinew_pose* given, std::size_t joint_count, PoseSpan& pose) noexcept {
  const sinew_error error = read_pose(given, pose);
  return error == SINEW_OK && pose.joint_count != joint_count ? SINEW_SIZE_MISMATCH : error;
}

/// Runs a job that accepts its buffers.
template <class Job>
sinew_error run_job(const Job& job) noexcept {
  return error_from(run(job));
}

}  // namespace sinew::c
