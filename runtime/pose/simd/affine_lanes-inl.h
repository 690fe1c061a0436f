// SPDX-License-Identifier: MIT
// Products of affine matrices, a row of four floats a block; included once per SIMD target, so without `#pragma once`.
// Single multiplications and additions only, never fused, each row summed in the order x, y, z, translation as affine.h
// does: all targets give the same bits (N27, N28).
#if defined(SINEW_AFFINE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_AFFINE_LANES_INL_H
#undef SINEW_AFFINE_LANES_INL_H
#else
#define SINEW_AFFINE_LANES_INL_H
#endif

#include <hwy/highway.h>

#include "runtime/math/affine.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Addresses of the three rows of the right factor of a product.
struct RowsAt {
  const float *x, *y, *z;
};
HWY_INLINE RowsAt rows_at(const Affine& m) { return {&m.row[0].x, &m.row[1].x, &m.row[2].x}; }

#if HWY_TARGET == HWY_SCALAR

using Rows = Affine;

HWY_INLINE Rows product(const Affine& a, const RowsAt& b) {
  Affine right;
  const float* rows[] = {b.x, b.y, b.z};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) right.row[r][c] = rows[r][c];
  return a * right;
}

#elif HWY_MAX_BYTES >= 64

/// A matrix in one vector: row r is block r; the fourth block is unused.
using RowsTag = hn::CappedTag<float, 16>;
using Rows = hn::Vec<RowsTag>;

/// Mask of the three blocks that hold rows. It is loaded: compilers rebuild a constant mask at each use.
HWY_INLINE hn::Mask<RowsTag> within_rows() {
  const RowsTag d;
  alignas(64) static constexpr float kRows[16] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0};
  return hn::Ne(hn::Load(d, kRows), hn::Zero(d));
}

HWY_INLINE Rows load_rows(const Affine& m) { return hn::MaskedLoad(within_rows(), RowsTag(), &m.row[0].x); }

HWY_INLINE Rows product(Rows a, const RowsAt& b) {
  const RowsTag d;
  alignas(64) static constexpr float kTranslations[16] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const Rows x = hn::Mul(hn::Broadcast<0>(a), hn::LoadDup128(d, b.x));
  const Rows y = hn::Mul(hn::Broadcast<1>(a), hn::LoadDup128(d, b.y));
  const Rows z = hn::Mul(hn::Broadcast<2>(a), hn::LoadDup128(d, b.z));
  const Rows linear = hn::Add(hn::Add(x, y), z);
  return hn::IfThenElse(hn::Ne(hn::Load(d, kTranslations), hn::Zero(d)), hn::Add(linear, a), linear);
}
HWY_INLINE Rows product(const Affine& a, const RowsAt& b) { return product(load_rows(a), b); }

#else

using RowTag = hn::FixedTag<float, 4>;
struct Rows {
  hn::Vec<RowTag> row[3];
};

HWY_INLINE Rows product(const Affine& a, const RowsAt& b) {
  const RowTag d;
  const auto x = hn::LoadU(d, b.x), y = hn::LoadU(d, b.y), z = hn::LoadU(d, b.z);
  const auto row = [&](const glm::vec4& of_a) HWY_ATTR {
    const auto linear = hn::Add(hn::Add(hn::Mul(hn::Set(d, of_a.x), x), hn::Mul(hn::Set(d, of_a.y), y)),
                                hn::Mul(hn::Set(d, of_a.z), z));
    const auto moved = hn::Add(linear, hn::Set(d, of_a.w));
    return hn::ConcatUpperLower(d, hn::OddEven(moved, linear), linear);
  };
  return {row(a.row[0]), row(a.row[1]), row(a.row[2])};
}

#endif

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
