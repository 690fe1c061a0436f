// SPDX-License-Identifier: MIT
#include "runtime/pose/joint_palette.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/pose/joint_palette.cpp"
#include <hwy/foreach_target.h>

#include "runtime/math/decompose.h"
#include "runtime/pose/simd/affine_lanes-inl.h"
#include "runtime/pose/simd/dispatch.h"
#include "runtime/pose/simd/transpose-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

/// The columns of a product of affine matrices, and its last row.
HWY_INLINE void store_columns(const Rows& m, JointMatrix& out) {
#if HWY_TARGET == HWY_SCALAR
  out = joint_matrix_from(m);
#elif HWY_MAX_BYTES >= 64
  const RowsTag d;
  alignas(64) static constexpr float kLastRow[16] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  alignas(64) static constexpr std::int32_t kColumns[16] = {0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15};
  const Rows whole = hn::IfThenElse(hn::FirstN(d, 12), m, hn::Load(d, kLastRow));
  hn::Store(hn::TableLookupLanes(whole, hn::SetTableIndices(d, kColumns)), d, &out.column[0].x);
#else
  const RowTag d;
  alignas(16) static constexpr float kLastRow[4] = {0, 0, 0, 1};
  const auto last = hn::Load(d, kLastRow);
  const auto columns = transpose_blocks(d, m.row[0], m.row[1], m.row[2], last);
  hn::Store(columns.x, d, &out.column[0].x);
  hn::Store(columns.y, d, &out.column[1].x);
  hn::Store(columns.z, d, &out.column[2].x);
  hn::Store(columns.w, d, &out.column[3].x);
#endif
}

void skinning_matrices(const JointPaletteJob& job) {
  const std::span<const std::uint32_t> joints = job.skin->joints;
  for (std::size_t i = 0; i < joints.size(); ++i)
    store_columns(product(job.model[joints[i]], rows_at(job.skin->inverse_bind[i])), job.palette[i]);
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
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

SINEW_DISPATCH_RUN(JointPaletteJob, skinning_matrices)

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
#endif  // HWY_ONCE
