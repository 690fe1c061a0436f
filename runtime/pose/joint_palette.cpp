// SPDX-License-Identifier: MIT
#include "runtime/pose/joint_palette.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/pose/joint_palette.cpp"
#include <hwy/foreach_target.h>

#include "runtime/base/same_bits.h"
#include "runtime/math/decompose.h"
#include "runtime/pose/simd/affine_lanes-inl.h"
#include "runtime/pose/simd/dispatch.h"
#include "runtime/pose/simd/polar_lanes-inl.h"
#include "runtime/pose/simd/transpose-inl.h"

#ifndef SINEW_JOINT_PALETTE_ONCE
#define SINEW_JOINT_PALETTE_ONCE
namespace sinew {
namespace {

/// Splits a matrix that may have any degenerate case. Returns whether it stretches.
bool split_any_matrix(const JointMatrix& matrix, RigidStretch& out) noexcept;

/// A stretch this close to the identity is rounding, not scale.
constexpr double kStretchTolerance = 1e-5;

}  // namespace
}  // namespace sinew
#endif

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
#if HWY_MAX_BYTES >= 32
  const auto columns = transpose_blocks(d, hn::LowerHalf(m.rows01), hn::UpperHalf(d, m.rows01), m.row2, last);
#else
  const auto columns = transpose_blocks(d, m.row0, m.row1, m.row2, last);
#endif
  hn::Store(columns.x, d, &out.column[0].x);
  hn::Store(columns.y, d, &out.column[1].x);
  hn::Store(columns.z, d, &out.column[2].x);
  hn::Store(columns.w, d, &out.column[3].x);
#endif
}

#if HWY_MAX_BYTES == 32 && HWY_TARGET != HWY_SCALAR

/// Two skinning matrices at once, one a block.
HWY_INLINE void store_two_products(const Affine& model0, const Affine& bind0, const Affine& model1, const Affine& bind1,
                                   JointMatrix* out) {
  const TwoRowsTag d;
  const RowTag half;
  alignas(32) static constexpr float kLastRows[8] = {0, 0, 0, 1, 0, 0, 0, 1};
  const auto both = [&](const glm::vec4& first, const glm::vec4& second)
                        HWY_ATTR { return hn::Combine(d, hn::LoadU(half, &second.x), hn::LoadU(half, &first.x)); };
  const RightRows<hn::Vec<TwoRowsTag>> bind{both(bind0.row[0], bind1.row[0]), both(bind0.row[1], bind1.row[1]),
                                            both(bind0.row[2], bind1.row[2])};
  const auto row = [&](int r) HWY_ATTR { return product_rows(d, both(model0.row[r], model1.row[r]), bind); };
  const auto columns = transpose_blocks(d, row(0), row(1), row(2), hn::Load(d, kLastRows));
  hn::Store(hn::ConcatLowerLower(d, columns.y, columns.x), d, &out[0].column[0].x);
  hn::Store(hn::ConcatLowerLower(d, columns.w, columns.z), d, &out[0].column[2].x);
  hn::Store(hn::ConcatUpperUpper(d, columns.y, columns.x), d, &out[1].column[0].x);
  hn::Store(hn::ConcatUpperUpper(d, columns.w, columns.z), d, &out[1].column[2].x);
}

#endif

/// Returns whether all are as before.
bool skinning_matrices(const JointPaletteJob& job) {
  const std::span<const std::uint32_t> joints = job.skin->joints;
  const auto matrix = [&](std::size_t i)
                          HWY_ATTR { return product(job.model[joints[i]], rows_at(job.skin->inverse_bind[i])); };
  bool unchanged = !job.before.empty();
  std::size_t i = 0;
  for (; i < joints.size() && unchanged; ++i) {
    JointMatrix made;
    store_columns(matrix(i), made);
    unchanged = same_bits(made, job.before[i]);
    job.palette[i] = made;
  }
#if HWY_MAX_BYTES == 32 && HWY_TARGET != HWY_SCALAR
  const std::span<const Affine> bind = job.skin->inverse_bind;
  for (; i + 2 <= joints.size(); i += 2)
    store_two_products(job.model[joints[i]], bind[i], job.model[joints[i + 1]], bind[i + 1], &job.palette[i]);
#endif
  for (; i < joints.size(); ++i) store_columns(matrix(i), job.palette[i]);
  return unchanged;
}

/// Matrices and their parts as planes: one float of each joint in a row.
struct SplitPlanes {
  static constexpr std::size_t kJoints = 16;
  HWY_ALIGN float linear[9][kJoints];  ///< columns of the matrices
  HWY_ALIGN float translation[3][kJoints];
  HWY_ALIGN float real[4][kJoints], stretch[6][kJoints];
};

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE void load_planes(const JointMatrix* const (&from)[4], std::size_t j, SplitPlanes& to) {
  for (std::size_t i = 0; i < 4; ++i)
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) to.linear[3 * c + r][j + i] = from[i]->column[c][r];
      to.translation[r][j + i] = from[i]->column[3][r];
    }
}

HWY_INLINE void store_planes(const SplitPlanes& from, std::size_t j, RigidStretch* const (&to)[4]) {
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [x, y, z, w] = from.real;
    const auto& [tx, ty, tz] = from.translation;
    to[i]->rigid = dual_quat_from(quat_xyzw(x[j + i], y[j + i], z[j + i], w[j + i]), {tx[j + i], ty[j + i], tz[j + i]});
    for (std::size_t s = 0; s < 6; ++s) to[i]->stretch[s] = from.stretch[s][j + i];
  }
}

#else

using FourTag = hn::FixedTag<float, 4>;
using Four = hn::Vec<FourTag>;

HWY_INLINE void load_planes(const JointMatrix* const (&from)[4], std::size_t j, SplitPlanes& to) {
  const FourTag d;
  const auto column = [&](std::size_t c) HWY_ATTR {
    const auto of = [&](std::size_t i) HWY_ATTR { return hn::Load(d, &from[i]->column[c].x); };
    return transpose_blocks(d, of(0), of(1), of(2), of(3));
  };
  for (std::size_t c = 0; c < 3; ++c) {
    const FourVectors<Four> v = column(c);
    hn::Store(v.x, d, to.linear[3 * c] + j);
    hn::Store(v.y, d, to.linear[3 * c + 1] + j);
    hn::Store(v.z, d, to.linear[3 * c + 2] + j);
  }
  const FourVectors<Four> t = column(3);
  hn::Store(t.x, d, to.translation[0] + j);
  hn::Store(t.y, d, to.translation[1] + j);
  hn::Store(t.z, d, to.translation[2] + j);
}

/// Dual parts, by the operations of dual_quat_from in their order.
/// eq   (t, 0) q / 2
HWY_INLINE FourVectors<Four> dual_parts(const FourVectors<Four>& q, Four tx, Four ty, Four tz) {
  const FourTag d;
  const Four half = hn::Set(d, 0.5f), zero = hn::Zero(d);
  const auto part = [&](Four none, Four p, Four q1, Four r)
                        HWY_ATTR { return hn::Mul(hn::Sub(hn::Add(hn::Add(none, p), q1), r), half); };
  const auto with_zero = [&](Four component) HWY_ATTR { return hn::Mul(zero, component); };
  const Four w = hn::Sub(hn::Sub(hn::Sub(with_zero(q.w), hn::Mul(tx, q.x)), hn::Mul(ty, q.y)), hn::Mul(tz, q.z));
  return {part(with_zero(q.x), hn::Mul(tx, q.w), hn::Mul(ty, q.z), hn::Mul(tz, q.y)),
          part(with_zero(q.y), hn::Mul(ty, q.w), hn::Mul(tz, q.x), hn::Mul(tx, q.z)),
          part(with_zero(q.z), hn::Mul(tz, q.w), hn::Mul(tx, q.y), hn::Mul(ty, q.x)), hn::Mul(w, half)};
}

HWY_INLINE void store_planes(const SplitPlanes& from, std::size_t j, RigidStretch* const (&to)[4]) {
  const FourTag d;
  const auto at = [&](const float* plane) HWY_ATTR { return hn::Load(d, plane + j); };
  const auto store = [&](const FourVectors<Four>& planes, std::size_t first) HWY_ATTR {
    const FourVectors<Four> v = transpose_blocks(d, planes.x, planes.y, planes.z, planes.w);
    hn::Store(v.x, d, &to[0]->rigid.real.x + first);
    hn::Store(v.y, d, &to[1]->rigid.real.x + first);
    hn::Store(v.z, d, &to[2]->rigid.real.x + first);
    hn::Store(v.w, d, &to[3]->rigid.real.x + first);
  };
  const FourVectors<Four> q{at(from.real[0]), at(from.real[1]), at(from.real[2]), at(from.real[3])};
  store(q, 0);
  store(dual_parts(q, at(from.translation[0]), at(from.translation[1]), at(from.translation[2])), 4);
  store({at(from.stretch[0]), at(from.stretch[1]), at(from.stretch[2]), at(from.stretch[3])}, 8);
  store({at(from.stretch[4]), at(from.stretch[5]), hn::Zero(d), hn::Zero(d)}, 12);
}

#endif

/// What is known of the joints of one vector.
struct SplitLanes {
  DoubleMask found, rigid;
};

/// Splits the joints of one vector, from plane to plane.
HWY_INLINE SplitLanes split_lanes(SplitPlanes& planes, std::size_t j) {
  const Doubles d;
  const hn::Rebind<float, Doubles> f;
  MatrixLanes a;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto entry = [&](std::size_t r)
                           HWY_ATTR { return hn::PromoteTo(d, hn::Load(f, planes.linear[3 * c + r] + j)); };
    a.column[c] = {entry(0), entry(1), entry(2)};
  }
  const PolarLanes polar = polar_of(a);
  const QuatLanes& q = polar.quat;
  const SymmetricLanes& s = polar.stretch;
  const auto store = [&](DoubleLanes v, float* plane) HWY_ATTR { hn::Store(hn::DemoteTo(f, v), f, plane + j); };
  store(q.x, planes.real[0]);
  store(q.y, planes.real[1]);
  store(q.z, planes.real[2]);
  store(q.w, planes.real[3]);
  store(s.xx, planes.stretch[0]);
  store(s.yy, planes.stretch[1]);
  store(s.zz, planes.stretch[2]);
  store(s.xy, planes.stretch[3]);
  store(s.xz, planes.stretch[4]);
  store(s.yz, planes.stretch[5]);
  return {polar.found, is_near_identity(s, kStretchTolerance)};
}

/// Bits of the lanes that are not in the mask.
HWY_INLINE std::uint32_t bits_not_in(DoubleMask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(Doubles(), hn::Not(mask), bits);
  return bits[0];
}

/// Splits up to SplitPlanes::kJoints joints, and repeats the last one in the lanes past it. Returns whether one
/// stretches.
HWY_INLINE bool split_block(const JointMatrix* palette, std::size_t count, RigidStretch* split) {
  constexpr std::size_t kLanes = hn::MaxLanes(Doubles()), kStep = std::max<std::size_t>(kLanes, 4);
  SplitPlanes planes;
  const std::size_t padded = (count + kStep - 1) / kStep * kStep;
  for (std::size_t j = 0; j < padded; j += 4) {
    const auto from = [&](std::size_t i) { return palette + std::min(j + i, count - 1); };
    load_planes({from(0), from(1), from(2), from(3)}, j, planes);
  }
  bool any_stretch = false;
  std::uint32_t left = 0;
  for (std::size_t j = 0; j < count; j += kLanes) {
    const SplitLanes lanes = split_lanes(planes, j);
    any_stretch |= !hn::AllFalse(Doubles(), hn::AndNot(lanes.rigid, lanes.found));
    left |= bits_not_in(lanes.found) << j;
  }
  RigidStretch past_the_last;
  for (std::size_t j = 0; j < count; j += 4) {
    const auto to = [&](std::size_t i) { return j + i < count ? split + j + i : &past_the_last; };
    store_planes(planes, j, {to(0), to(1), to(2), to(3)});
  }
  for (; left != 0; left &= left - 1) {
    const auto j = static_cast<std::size_t>(std::countr_zero(left));
    if (j < count) any_stretch |= split_any_matrix(palette[j], split[j]);
  }
  return any_stretch;
}

bool split_palette(const SplitPaletteJob& job) {
  bool any_stretch = false;
  for (std::size_t first = 0; first < job.palette.size(); first += SplitPlanes::kJoints) {
    const std::size_t count = std::min(job.palette.size() - first, SplitPlanes::kJoints);
    any_stretch |= split_block(&job.palette[first], count, &job.split[first]);
  }
  return any_stretch;
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {

bool is_stretched(const float (&s)[6]) noexcept {
  const float diagonal = std::max({std::abs(s[0] - 1.0f), std::abs(s[1] - 1.0f), std::abs(s[2] - 1.0f)});
  const float rest = std::max({std::abs(s[3]), std::abs(s[4]), std::abs(s[5])});
  return !(static_cast<double>(std::max(diagonal, rest)) <= kStretchTolerance);
}

bool split_any_matrix(const JointMatrix& palette_entry, RigidStretch& out) noexcept {
  const Affine matrix = affine_from(palette_entry);
  const auto polar = decompose_polar(linear_part(matrix));
  out.rigid = dual_quat_from(polar.quat, translation_of(matrix));
  std::copy(std::begin(polar.stretch), std::end(polar.stretch), out.stretch);
  return is_stretched(out.stretch);
}

HWY_EXPORT(skinning_matrices);
HWY_EXPORT(split_palette);

}  // namespace

ErrorCode check(const JointPaletteJob& job) noexcept {
  if (!job.skin) return ErrorCode::size_mismatch;
  const std::size_t count = job.skin->joints.size();
  if (job.skin->inverse_bind.size() != count || job.palette.size() < count) return ErrorCode::size_mismatch;
  if (!job.before.empty() && job.before.size() < count) return ErrorCode::size_mismatch;
  if (!have_memory(job.model, job.palette, job.before)) return ErrorCode::size_mismatch;
  for (const std::uint32_t joint : job.skin->joints)
    if (joint >= job.model.size()) return ErrorCode::index_out_of_range;
  return ErrorCode::ok;
}

void run_unchecked(const JointPaletteJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  const bool unchanged = HWY_DYNAMIC_DISPATCH(skinning_matrices)(job);
  if (job.unchanged) *job.unchanged = unchanged;
}

ErrorCode check(const SplitPaletteJob& job) noexcept {
  if (!have_memory(job.palette, job.split, job.follow)) return ErrorCode::size_mismatch;
  const std::size_t count = job.palette.size();
  const auto outside = [count](const JointPair& pair) { return pair.first >= count || pair.second >= count; };
  if (std::any_of(job.follow.begin(), job.follow.end(), outside)) return ErrorCode::index_out_of_range;
  return job.split.size() < count ? ErrorCode::size_mismatch : ErrorCode::ok;
}

void run_unchecked(const SplitPaletteJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  const bool any_stretch = HWY_DYNAMIC_DISPATCH(split_palette)(job);
  for (const JointPair& pair : job.follow) {
    DualQuat& motion = job.split[pair.second].rigid;
    if (quat_dot(job.split[pair.first].rigid.real, motion.real) < 0.0f) motion = {-motion.real, -motion.dual};
  }
  if (job.any_stretch) *job.any_stretch = any_stretch;
}

}  // namespace sinew
#endif  // HWY_ONCE
