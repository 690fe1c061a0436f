// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/deform/skin_center_of_rotation.h"
#include "runtime/deform/skin_dual_quaternion.h"
#include "runtime/deform/skin_linear.h"
#include "runtime/deform/strided_vertices.h"

namespace sinew {

/// Skins vertices in interleaved buffers. `Job` is SkinLinearJob, SkinDualQuaternionJob or SkinCenterOfRotationJob: it
/// skins blocks of vertices in the first-level cache. The result has the same bits as that of the job.
/// in   skin      without vertices, output and tiles
/// out  out       An attribute is written if the input has it and it is not empty here. Must not overlap the input,
///      but for elements that lie between each other.
/// err  those of `skin`; size_mismatch also for strides below the size of an attribute; unsupported if skin has
///      vertices, output or tiles
/// cost that of `skin`, and a copy of each attribute that is not packed; no allocation
template <class Job>
struct StridedSkinJob {
  Job skin;
  StridedInput vertices;
  StridedOutput out;
};

SINEW_API ErrorCode check(const StridedSkinJob<SkinLinearJob>& job) noexcept;
SINEW_API ErrorCode check(const StridedSkinJob<SkinDualQuaternionJob>& job) noexcept;
SINEW_API ErrorCode check(const StridedSkinJob<SkinCenterOfRotationJob>& job) noexcept;
SINEW_API void run_unchecked(const StridedSkinJob<SkinLinearJob>& job) noexcept;
SINEW_API void run_unchecked(const StridedSkinJob<SkinDualQuaternionJob>& job) noexcept;
SINEW_API void run_unchecked(const StridedSkinJob<SkinCenterOfRotationJob>& job) noexcept;

}  // namespace sinew
