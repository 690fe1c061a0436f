// SPDX-License-Identifier: MIT
#include "runtime/jobs/local_to_model.h"

namespace sinew {

ErrorCode check(const LocalToModelJob& job) noexcept {
  if (!job.skeleton) return ErrorCode::size_mismatch;
  const std::size_t count = job.skeleton->joint_count();
  if (job.local.joint_count < count || job.model.size() < count) return ErrorCode::size_mismatch;
  if (count > 0 && !job.local.planes) return ErrorCode::size_mismatch;
  const auto* pose_begin = reinterpret_cast<const std::byte*>(job.local.planes);
  const auto* pose_end = pose_begin + PoseSpan::plane_count * job.local.stride * sizeof(float);
  const auto out = std::as_bytes(job.model);
  if (out.data() < pose_end && pose_begin < out.data() + out.size()) return ErrorCode::overlapping_buffers;
  return ErrorCode::ok;
}

void run(const LocalToModelJob& job) noexcept {
  const Skeleton& skeleton = *job.skeleton;
  const std::size_t count = skeleton.joint_count();
  for (std::size_t j = 0; j < count; ++j) {
    const std::uint32_t fixed = skeleton.fixed_matrix_of[j];
    const Affine local = fixed == kNone ? affine_from_transform(job.local.get(j)) : skeleton.fixed_matrices[fixed];
    const std::uint32_t parent = skeleton.parents[j];
    job.model[j] = (parent == kNone ? job.root : job.model[parent]) * local;
  }
}

}  // namespace sinew
