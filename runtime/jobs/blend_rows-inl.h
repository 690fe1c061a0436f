// SPDX-License-Identifier: MIT
// The blended 3x4 matrix of a vertex in registers: one of sixteen lanes where there are such, else three of four.
#if defined(SINEW_BLEND_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_BLEND_ROWS_INL_H_
#undef SINEW_BLEND_ROWS_INL_H_
#else
#define SINEW_BLEND_ROWS_INL_H_
#endif

#include "runtime/jobs/influence_dispatch.h"
#include "runtime/jobs/lanes-inl.h"
#include "runtime/math/affine.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

#if HWY_MAX_BYTES >= 64

using D16 = hn::FixedTag<float, 16>;

/// Row r of the matrix is block r; the fourth block is 0.
struct Rows {
  hn::Vec<D16> all;
};

HWY_INLINE Rows load_rows(const Affine& m) {
  const D16 d;
  return {hn::MaskedLoad(hn::FirstN(d, 12), d, &m.row[0].x)};
}
HWY_INLINE Rows times(const Rows& m, float w) { return {hn::Mul(m.all, hn::Set(D16(), w))}; }
HWY_INLINE Rows times_plus(const Rows& m, float w, const Rows& sum) { return {hn::MulAdd(m.all, hn::Set(D16(), w), sum.all)}; }

/// (v.x, v.y, v.z, fourth) against each row, not yet summed. Reads one float past v.
HWY_INLINE Rows against(const Rows& m, const float* v, bool is_point) {
  const D16 d;
  alignas(64) static constexpr float kPoint[16] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const auto point = hn::Load(d, kPoint);
  const auto three = hn::LoadDup128(d, v);
  return {hn::Mul(m.all, is_point ? hn::IfThenElse(hn::Ne(point, hn::Zero(d)), point, three) : three)};
}

/// Rows of the cofactor matrix: r1 x r2, r2 x r0, r0 x r1; the fourth column is 0.
HWY_INLINE Rows cofactor_rows(const Rows& m) {
  const D16 d;
  alignas(64) static constexpr std::int32_t kNextYzx[16] = {5, 6, 4, 15, 9, 10, 8, 15, 1, 2, 0, 15, 15, 15, 15, 15};
  alignas(64) static constexpr std::int32_t kNextZxy[16] = {6, 4, 5, 15, 10, 8, 9, 15, 2, 0, 1, 15, 15, 15, 15, 15};
  alignas(64) static constexpr std::int32_t kLastYzx[16] = {9, 10, 8, 15, 1, 2, 0, 15, 5, 6, 4, 15, 15, 15, 15, 15};
  alignas(64) static constexpr std::int32_t kLastZxy[16] = {10, 8, 9, 15, 2, 0, 1, 15, 6, 4, 5, 15, 15, 15, 15, 15};
  const auto pick = [&](const std::int32_t* lanes) HWY_ATTR { return hn::TableLookupLanes(m.all, hn::SetTableIndices(d, lanes)); };
  return {hn::NegMulAdd(pick(kNextZxy), pick(kLastYzx), hn::Mul(pick(kNextYzx), pick(kLastZxy)))};
}

/// Sums each row's products in the order x, y, z, fourth: one vertex per lane.
HWY_INLINE Lanes3 sum_rows(const Rows (&p)[4], bool is_point) {
  const D16 d;
  const auto ac_low = hn::InterleaveLower(d, p[0].all, p[2].all), ac_high = hn::InterleaveUpper(d, p[0].all, p[2].all);
  const auto be_low = hn::InterleaveLower(d, p[1].all, p[3].all), be_high = hn::InterleaveUpper(d, p[1].all, p[3].all);
  auto sum = hn::Add(hn::InterleaveLower(d, ac_low, be_low), hn::InterleaveUpper(d, ac_low, be_low));
  sum = hn::Add(sum, hn::InterleaveLower(d, ac_high, be_high));
  if (is_point) sum = hn::Add(sum, hn::InterleaveUpper(d, ac_high, be_high));
  const hn::FixedTag<float, 8> d8;
  const D4 d4;
  const auto low = hn::LowerHalf(d8, sum);
  return {hn::LowerHalf(d4, low), hn::UpperHalf(d4, low), hn::LowerHalf(d4, hn::UpperHalf(d8, sum))};
}

#else

struct Rows {
  V4 row[3];
};

HWY_INLINE Rows load_rows(const Affine& m) {
  const D4 d;
  return {{hn::LoadU(d, &m.row[0].x), hn::LoadU(d, &m.row[1].x), hn::LoadU(d, &m.row[2].x)}};
}
HWY_INLINE Rows times(const Rows& m, float w) {
  const V4 s = hn::Set(D4(), w);
  return {{hn::Mul(m.row[0], s), hn::Mul(m.row[1], s), hn::Mul(m.row[2], s)}};
}
HWY_INLINE Rows times_plus(const Rows& m, float w, const Rows& sum) {
  const V4 s = hn::Set(D4(), w);
  return {{hn::MulAdd(m.row[0], s, sum.row[0]), hn::MulAdd(m.row[1], s, sum.row[1]), hn::MulAdd(m.row[2], s, sum.row[2])}};
}
HWY_INLINE Rows against(const Rows& m, const float* v, bool is_point) {
  const D4 d;
  alignas(16) static constexpr float kPoint[4] = {0, 0, 0, 1};
  const V4 point = hn::Load(d, kPoint), three = hn::LoadU(d, v);
  const V4 q = is_point ? hn::IfThenElse(hn::Ne(point, hn::Zero(d)), point, three) : three;
  return {{hn::Mul(m.row[0], q), hn::Mul(m.row[1], q), hn::Mul(m.row[2], q)}};
}
HWY_INLINE Rows cofactor_rows(const Rows& m) {
  const D4 d;
  alignas(16) static constexpr std::int32_t kYzx[4] = {1, 2, 0, 3}, kZxy[4] = {2, 0, 1, 3};
  const auto yzx = hn::SetTableIndices(d, kYzx), zxy = hn::SetTableIndices(d, kZxy);
  const auto product = [&](V4 a, V4 b) HWY_ATTR {
    return hn::NegMulAdd(hn::TableLookupLanes(a, zxy), hn::TableLookupLanes(b, yzx),
                         hn::Mul(hn::TableLookupLanes(a, yzx), hn::TableLookupLanes(b, zxy)));
  };
  return {{product(m.row[1], m.row[2]), product(m.row[2], m.row[0]), product(m.row[0], m.row[1])}};
}
HWY_INLINE Lanes3 sum_rows(const Rows (&p)[4], bool is_point) {
  const auto row_sum = [&](int r) HWY_ATTR {
    const Lanes4 t = transpose(p[0].row[r], p[1].row[r], p[2].row[r], p[3].row[r]);
    const V4 three = hn::Add(hn::Add(t.x, t.y), t.z);
    return is_point ? hn::Add(three, t.w) : three;
  };
  return {row_sum(0), row_sum(1), row_sum(2)};
}

#endif

/// eq   M = sum(w_i * palette[joint_i]); a vertex with one influence takes the joint's matrix as it is.
template <int kCount>
HWY_INLINE Rows blend_rows(const Affine* palette, const VertexJoints<kCount>& vertex) {
  const Rows first = load_rows(palette[vertex.joints[0]]);
  if constexpr (kCount == 1) return first;
  Rows sum = times(first, vertex.weights[0]);
  for (std::size_t i = 1; i < vertex.count(); ++i) sum = times_plus(load_rows(palette[vertex.joints[i]]), vertex.weights[i], sum);
  return sum;
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET
#endif
