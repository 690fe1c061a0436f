// SPDX-License-Identifier: MIT
#include "runtime/jobs/joint_palette.h"

#include <algorithm>
#include <cmath>

#include "runtime/math/decompose.h"

namespace sinew {
namespace {

/// A stretch this close to the identity is rounding, not scale: the split of a rigid float matrix leaves about 1e-7.
constexpr float kStretchTolerance = 1e-6f;

bool is_stretched(const float (&s)[6]) noexcept {
  const float diagonal = std::max({std::abs(s[0] - 1.0f), std::abs(s[1] - 1.0f), std::abs(s[2] - 1.0f)});
  const float rest = std::max({std::abs(s[3]), std::abs(s[4]), std::abs(s[5])});
  return !(std::max(diagonal, rest) <= kStretchTolerance);
}

}  // namespace

ErrorCode check(const JointPaletteJob& job) noexcept {
  if (!job.skin) return ErrorCode::size_mismatch;
  const std::size_t count = job.skin->joints.size();
  if (job.skin->inverse_bind.size() != count || job.palette.size() < count) return ErrorCode::size_mismatch;
  for (const std::uint32_t joint : job.skin->joints)
    if (joint >= job.model.size()) return ErrorCode::index_out_of_range;
  return ErrorCode::ok;
}

void run(const JointPaletteJob& job) noexcept {
  const std::size_t count = job.skin->joints.size();
  for (std::size_t i = 0; i < count; ++i)
    job.palette[i] = joint_matrix_from(job.model[job.skin->joints[i]] * job.skin->inverse_bind[i]);
}

ErrorCode check(const SplitPaletteJob& job) noexcept {
  const std::size_t count = job.palette.size();
  const auto outside = [count](const JointPair& pair) { return pair.first >= count || pair.second >= count; };
  if (std::any_of(job.follow.begin(), job.follow.end(), outside)) return ErrorCode::index_out_of_range;
  return job.split.size() < count ? ErrorCode::size_mismatch : ErrorCode::ok;
}

void run(const SplitPaletteJob& job) noexcept {
  bool any_stretch = false;
  for (std::size_t i = 0; i < job.palette.size(); ++i) {
    const Affine matrix = affine_from(job.palette[i]);
    const auto polar = decompose_polar(linear_part(matrix));
    RigidStretch& out = job.split[i];
    out.rigid = dual_quat_from(polar.quat, translation_of(matrix));
    std::copy(std::begin(polar.stretch), std::end(polar.stretch), out.stretch);
    any_stretch |= is_stretched(out.stretch);
  }
  for (const JointPair& pair : job.follow) {
    DualQuat& motion = job.split[pair.second].rigid;
    if (quat_dot(job.split[pair.first].rigid.real, motion.real) < 0.0f) motion = {-motion.real, -motion.dual};
  }
  if (job.any_stretch) *job.any_stretch = any_stretch;
}

}  // namespace sinew
