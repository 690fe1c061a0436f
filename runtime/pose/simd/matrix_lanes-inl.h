// SPDX-License-Identifier: MIT
// 3x3 matrices and their quaternions in double precision, one matrix per lane. Included once per SIMD target, so
// without `#pragma once`. Multiplications and additions are never fused, so all targets give the same bits.
#if defined(SINEW_MATRIX_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_MATRIX_LANES_INL_H
#undef SINEW_MATRIX_LANES_INL_H
#else
#define SINEW_MATRIX_LANES_INL_H
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
using DoubleLanes = hn::Vec<Doubles>;
using DoubleMask = hn::Mask<Doubles>;

/// One column of a matrix in each lane.
struct ColumnLanes {
  DoubleLanes x, y, z;
};
struct MatrixLanes {
  ColumnLanes column[3];
};
struct SymmetricLanes {
  DoubleLanes xx, yy, zz, xy, xz, yz;
};
struct QuatLanes {
  DoubleLanes x, y, z, w;
};

HWY_INLINE DoubleLanes dot(const ColumnLanes& a, const ColumnLanes& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

HWY_INLINE ColumnLanes times(const ColumnLanes& a, DoubleLanes s) {
  return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}

HWY_INLINE ColumnLanes plus(const ColumnLanes& a, const ColumnLanes& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}

HWY_INLINE ColumnLanes cross(const ColumnLanes& a, const ColumnLanes& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

/// eq   A^T B, which must be symmetric: only one triangle is computed
HWY_INLINE SymmetricLanes symmetric_product(const MatrixLanes& a, const MatrixLanes& b) {
  return {dot(a.column[0], b.column[0]), dot(a.column[1], b.column[1]), dot(a.column[2], b.column[2]),
          dot(a.column[0], b.column[1]), dot(a.column[0], b.column[2]), dot(a.column[1], b.column[2])};
}

/// Lanes in which every entry is within `limit` of the identity; false for NaN.
HWY_INLINE DoubleMask is_near_identity(const SymmetricLanes& s, double limit) {
  const Doubles d;
  const DoubleLanes one = hn::Set(d, 1.0), most = hn::Set(d, limit);
  const auto is_near = [&](DoubleLanes v) HWY_ATTR { return hn::Le(hn::Abs(v), most); };
  const DoubleMask diagonal =
      hn::And(is_near(hn::Sub(s.xx, one)), hn::And(is_near(hn::Sub(s.yy, one)), is_near(hn::Sub(s.zz, one))));
  return hn::And(diagonal, hn::And(is_near(s.xy), hn::And(is_near(s.xz), is_near(s.yz))));
}

/// eq   a a + b b + c c + d d
HWY_INLINE DoubleLanes square_of(const QuatLanes& q) {
  return hn::Add(hn::Add(hn::Mul(q.x, q.x), hn::Mul(q.y, q.y)), hn::Add(hn::Mul(q.z, q.z), hn::Mul(q.w, q.w)));
}

/// The symmetric matrix whose columns are four multiples of the quaternion of a rotation matrix.
/// eq   B = 4 q q^T   (Real-Time Rendering, eqs. 4.47-4.51). For R S, R a rotation, the q of R is the eigenvector of B
///      with the largest eigenvalue, 1 + trace S; where S is near the identity the others are near 0
class QuatForms {
 public:
  HWY_INLINE explicit QuatForms(const MatrixLanes& m) {
    const auto& [a, b, c] = m.column;
    const DoubleLanes one = hn::Set(Doubles(), 1.0), rest = hn::Add(b.y, c.z), difference = hn::Sub(b.y, c.z);
    const DoubleLanes more = hn::Add(one, a.x), less = hn::Sub(one, a.x);
    ww_ = hn::Add(more, rest);
    xx_ = hn::Sub(more, rest);
    yy_ = hn::Add(less, difference);
    zz_ = hn::Sub(less, difference);
    wx_ = hn::Sub(b.z, c.y);
    wy_ = hn::Sub(c.x, a.z);
    wz_ = hn::Sub(a.y, b.x);
    xy_ = hn::Add(a.y, b.x);
    xz_ = hn::Add(a.z, c.x);
    yz_ = hn::Add(b.z, c.y);
  }

  /// The column with the largest diagonal entry. It is at least 1, so dividing by its length is safe.
  HWY_INLINE QuatLanes longest() const {
    const auto w_form = hn::And(hn::Ge(ww_, xx_), hn::And(hn::Ge(ww_, yy_), hn::Ge(ww_, zz_)));
    const auto x_form = hn::And(hn::Ge(xx_, yy_), hn::Ge(xx_, zz_)), y_form = hn::Ge(yy_, zz_);
    const auto chosen = [&](DoubleLanes w, DoubleLanes x, DoubleLanes y, DoubleLanes z) HWY_ATTR {
      return hn::IfThenElse(w_form, w, hn::IfThenElse(x_form, x, hn::IfThenElse(y_form, y, z)));
    };
    return {chosen(wx_, xx_, xy_, xz_), chosen(wy_, xy_, yy_, yz_), chosen(wz_, xz_, yz_, zz_),
            chosen(ww_, wx_, wy_, wz_)};
  }

  /// eq   B q, one step of the power iteration to the eigenvector
  HWY_INLINE QuatLanes times(const QuatLanes& q) const {
    const auto row = [&](DoubleLanes x, DoubleLanes y, DoubleLanes z, DoubleLanes w) HWY_ATTR {
      return hn::Add(hn::Add(hn::Mul(x, q.x), hn::Mul(y, q.y)), hn::Add(hn::Mul(z, q.z), hn::Mul(w, q.w)));
    };
    return {row(xx_, xy_, xz_, wx_), row(xy_, yy_, yz_, wy_), row(xz_, yz_, zz_, wz_), row(wx_, wy_, wz_, ww_)};
  }

 private:
  DoubleLanes xx_, yy_, zz_, ww_, xy_, xz_, yz_, wx_, wy_, wz_;
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
