// SPDX-License-Identifier: MIT
// Products of affine matrices, with one row of four floats per 128-bit block. Included once per SIMD target, so without
// `#pragma once`. Multiplications and additions are never fused, and each row is summed in the order x, y, z,
// translation as in affine.h. All targets therefore give the same bits.
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
HWY_INLINE void store_rows(const Rows& m, Affine& to) { to = m; }

#else

/// Component i of every row, copied to all four places of the row.
template <int i, class D, class V = hn::Vec<D> >
HWY_INLINE V spread(D d, V rows) {
#if HWY_TARGET == HWY_SSE4
  // The integer shuffle is one instruction; the float shuffle overwrites its argument and needs a copy.
  const hn::RebindToSigned<D> whole;
  return hn::BitCast(d, hn::Broadcast<i>(hn::BitCast(whole, rows)));
#else
  (void)d;
  return hn::Broadcast<i>(rows);
#endif
}

/// The three rows of a right factor. Each block may have its own matrix.
template <class V>
struct RightRows {
  V x, y, z;
};

/// Rows of products, given the rows of the left factors; one row per block.
template <class D, class V = hn::Vec<D> >
HWY_INLINE V product_rows(D d, V a, const RightRows<V>& b) {
  alignas(64) static constexpr float kTranslations[16] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const V x = hn::Mul(spread<0>(d, a), b.x);
  const V y = hn::Mul(spread<1>(d, a), b.y);
  const V z = hn::Mul(spread<2>(d, a), b.z);
  const V linear = hn::Add(hn::Add(x, y), z);
  return hn::IfThenElse(hn::Ne(hn::Load(d, kTranslations), hn::Zero(d)), hn::Add(linear, a), linear);
}

/// Rows of a product, given the same rows of the left factor; one row per block.
template <class D, class V = hn::Vec<D> >
HWY_INLINE V product_rows(D d, V a, const RowsAt& b) {
  return product_rows(d, a, RightRows<V>{hn::LoadDup128(d, b.x), hn::LoadDup128(d, b.y), hn::LoadDup128(d, b.z)});
}

#if HWY_MAX_BYTES >= 64

/// A matrix in one vector: block r is row r, and the fourth block is unused.
using RowsTag = hn::CappedTag<float, 16>;
using Rows = hn::Vec<RowsTag>;

/// Mask of the three blocks that hold rows. Loaded from memory, because compilers rebuild a constant mask at each use.
HWY_INLINE hn::Mask<RowsTag> within_rows() {
  const RowsTag d;
  alignas(64) static constexpr float kRows[16] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0};
  return hn::Ne(hn::Load(d, kRows), hn::Zero(d));
}

HWY_INLINE Rows load_rows(const Affine& m) { return hn::MaskedLoad(within_rows(), RowsTag(), &m.row[0].x); }
HWY_INLINE void store_rows(const Rows& m, Affine& to) { hn::BlendedStore(m, within_rows(), RowsTag(), &to.row[0].x); }
HWY_INLINE Rows product(Rows a, const RowsAt& b) { return product_rows(RowsTag(), a, b); }

#elif HWY_MAX_BYTES >= 32

/// A matrix in two vectors: rows 0 and 1, and row 2.
using RowTag = hn::FixedTag<float, 4>;
using TwoRowsTag = hn::FixedTag<float, 8>;
struct Rows {
  hn::Vec<TwoRowsTag> rows01;
  hn::Vec<RowTag> row2;
};

HWY_INLINE Rows load_rows(const Affine& m) {
  return {hn::LoadU(TwoRowsTag(), &m.row[0].x), hn::LoadU(RowTag(), &m.row[2].x)};
}
HWY_INLINE void store_rows(const Rows& m, Affine& to) {
  hn::StoreU(m.rows01, TwoRowsTag(), &to.row[0].x);
  hn::StoreU(m.row2, RowTag(), &to.row[2].x);
}
HWY_INLINE Rows product(const Rows& a, const RowsAt& b) {
  return {product_rows(TwoRowsTag(), a.rows01, b), product_rows(RowTag(), a.row2, b)};
}

#else

/// A matrix in three vectors.
using RowTag = hn::FixedTag<float, 4>;
struct Rows {
  hn::Vec<RowTag> row0, row1, row2;
};

HWY_INLINE Rows load_rows(const Affine& m) {
  const RowTag d;
  return {hn::LoadU(d, &m.row[0].x), hn::LoadU(d, &m.row[1].x), hn::LoadU(d, &m.row[2].x)};
}
HWY_INLINE void store_rows(const Rows& m, Affine& to) {
  const RowTag d;
  hn::StoreU(m.row0, d, &to.row[0].x);
  hn::StoreU(m.row1, d, &to.row[1].x);
  hn::StoreU(m.row2, d, &to.row[2].x);
}
HWY_INLINE Rows product(const Rows& a, const RowsAt& b) {
  const RowTag d;
  return {product_rows(d, a.row0, b), product_rows(d, a.row1, b), product_rows(d, a.row2, b)};
}

#endif

HWY_INLINE Rows product(const Affine& a, const RowsAt& b) { return product(load_rows(a), b); }

#endif

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
