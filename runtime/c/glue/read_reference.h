// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/animation/pose_reference.h"
#include "runtime/c/glue/pose_span.h"
#include "runtime/c/reference.h"
#include "runtime/model/bind_pose.h"

namespace sinew::c {

/// Reads a reference pose.
/// in   reference  sinew_reference;   given  read for SINEW_REFERENCE_GIVEN only
/// out  local      [J]; empty for SINEW_REFERENCE_CHOSEN
/// err  SINEW_UNSUPPORTED (reference), SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH (given)
inline sinew_error read_reference(std::uint32_t reference, const sinew_pose* given, const Scene& scene,
                                  std::vector<Transform>& local) {
  if (reference > SINEW_REFERENCE_GIVEN) return SINEW_UNSUPPORTED;
  if (reference == SINEW_REFERENCE_REST) local = scene.skeleton.rest;
  if (reference == SINEW_REFERENCE_BIND) local = bind_pose(scene).local;
  if (reference != SINEW_REFERENCE_GIVEN) return SINEW_OK;
  PoseSpan pose;
  if (const sinew_error error = read_poses({{given, pose}})) return error;
  if (pose.joint_count != scene.skeleton.joint_count()) return SINEW_SIZE_MISMATCH;
  for (std::uint32_t j = 0; j < pose.joint_count; ++j) local.push_back(pose.get(j));
  return SINEW_OK;
}

/// The sinew_reference that a map reports.
/// in   asked  the sinew_reference of its options
inline std::uint32_t told_reference(PoseReference reference, std::uint32_t asked) noexcept {
  static_assert(static_cast<int>(PoseReference::rest) + 1 == SINEW_REFERENCE_REST &&
                static_cast<int>(PoseReference::bind) + 1 == SINEW_REFERENCE_BIND &&
                static_cast<int>(PoseReference::given) + 1 == SINEW_REFERENCE_GIVEN);
  return asked != SINEW_REFERENCE_CHOSEN ? asked : static_cast<std::uint32_t>(reference) + 1;
}

}  // namespace sinew::c
