// SPDX-License-Identifier: MIT
// Polar decompositions of 3x3 matrices in double precision, one matrix per lane. Included once per SIMD target, so
// without `#pragma once`. Lanes do not influence each other's bits.
#if defined(SINEW_POLAR_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_POLAR_LANES_INL_H
#undef SINEW_POLAR_LANES_INL_H
#else
#define SINEW_POLAR_LANES_INL_H
#endif

#include "runtime/pose/simd/matrix_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Unit rotation and stretch of each lane. Only lanes in `found` are valid.
struct PolarLanes {
  QuatLanes quat;
  SymmetricLanes stretch;
  DoubleMask found;
};

HWY_INLINE QuatLanes divided(const QuatLanes& q, DoubleLanes length) {
  const DoubleLanes scale = hn::Div(hn::Set(Doubles(), 1.0), length);
  return {hn::Mul(q.x, scale), hn::Mul(q.y, scale), hn::Mul(q.z, scale), hn::Mul(q.w, scale)};
}

/// For matrices A whose G = A^T A is within 2^-18 of the identity and that do not mirror. The error is of second order
/// in that distance.
/// eq   q = B b / |B b|, b the longest column of B;  S = (I + G) / 2.
///      |B b|^2 is 64 or more for rotations, and 16 for rotations that are mirrored.
HWY_INLINE PolarLanes polar_of_rigid(const MatrixLanes& a, const SymmetricLanes& g) {
  const Doubles d;
  const QuatForms forms(a);
  const QuatLanes q = forms.times(forms.longest());
  const DoubleLanes squared = square_of(q), half = hn::Set(d, 0.5);
  const auto mean = [&](DoubleLanes v) HWY_ATTR { return hn::Add(hn::Mul(v, half), half); };
  const SymmetricLanes stretch{mean(g.xx),          mean(g.yy),          mean(g.zz),
                               hn::Mul(g.xy, half), hn::Mul(g.xz, half), hn::Mul(g.yz, half)};
  return {divided(q, hn::Sqrt(squared)), stretch,
          hn::And(is_near_identity(g, 0x1p-18), hn::Gt(squared, hn::Set(d, 32.0)))};
}

/// The trace of the stretch of each lane.
struct TraceLanes {
  DoubleLanes trace;
  DoubleMask found;
};

/// eq   The largest root of (x^2 - tr G)^2 - 4 g - 8 x det A, where g is the second invariant of G: x = s1 + s2 + s3,
///      the sum of the singular values. Newton's method starts at x = sqrt(3 tr G), which is never less, and x falls to
///      the root. A lane keeps its x after a small step, so it does not depend on the other lanes.
HWY_INLINE TraceLanes trace_of_stretch(DoubleLanes trace_of_g, DoubleLanes second_of_g, DoubleLanes determinant) {
  const Doubles d;
  constexpr int kMostSteps = 12;
  constexpr double kSmallStep = 1e-9;  // convergence is quadratic: the next step would be about the square of this
  const DoubleLanes linear = hn::Mul(determinant, hn::Set(d, 8.0)), four = hn::Set(d, 4.0);
  const DoubleLanes constant = hn::Mul(second_of_g, four);
  DoubleLanes x = hn::Sqrt(hn::Mul(trace_of_g, hn::Set(d, 3.0)));
  const DoubleLanes small = hn::Mul(x, hn::Set(d, kSmallStep));
  DoubleMask found = hn::FirstN(d, 0);
  for (int i = 0; i < kMostSteps && !hn::AllTrue(d, found); ++i) {
    const DoubleLanes t = hn::Sub(hn::Mul(x, x), trace_of_g);
    const DoubleLanes value = hn::Sub(hn::Sub(hn::Mul(t, t), constant), hn::Mul(linear, x));
    const DoubleLanes slope = hn::Sub(hn::Mul(hn::Mul(x, t), four), linear), step = hn::Div(value, slope);
    x = hn::IfThenElse(found, x, hn::Sub(x, step));
    found = hn::Or(found, hn::Le(hn::Abs(step), small));
  }
  return {x, found};
}

/// For any matrices. A lane is found if its smallest singular value is at least about a hundredth of the largest.
/// eq   R = (x cof(A) + A ((x^2 - k) I - G)) / (x k - det A), x = tr S, k = (x^2 - tr G) / 2 the second invariant of S;
///      S = R^T A   (from the Cayley-Hamilton equation of S, by Hoger and Carlson 1984). For mirroring A the equations
///      are applied to -A, and S is negative.
HWY_NOINLINE PolarLanes polar_of_stretched(const MatrixLanes& a, const SymmetricLanes& g) {
  const Doubles d;
  const ColumnLanes first = cross(a.column[1], a.column[2]);
  const DoubleLanes determinant = dot(a.column[0], first), mirrored = hn::And(determinant, hn::SignBit(d));
  const DoubleLanes trace_of_g = hn::Add(hn::Add(g.xx, g.yy), g.zz);
  const auto minor = [](DoubleLanes p, DoubleLanes q, DoubleLanes r)
                         HWY_ATTR { return hn::Sub(hn::Mul(p, q), hn::Mul(r, r)); };
  const DoubleLanes second_of_g =
      hn::Add(hn::Add(minor(g.xx, g.yy, g.xy), minor(g.xx, g.zz, g.xz)), minor(g.yy, g.zz, g.yz));
  const TraceLanes x = trace_of_stretch(trace_of_g, second_of_g, hn::Abs(determinant));
  const DoubleLanes squared = hn::Mul(x.trace, x.trace), k = hn::Mul(hn::Sub(squared, trace_of_g), hn::Set(d, 0.5));
  const DoubleLanes divisor = hn::Sub(hn::Mul(x.trace, k), hn::Abs(determinant)),
                    scale = hn::Div(hn::Set(d, 1.0), divisor);
  const DoubleLanes of_cofactor = hn::Mul(x.trace, scale), of_a = hn::Xor(scale, mirrored);
  const DoubleLanes diagonal = hn::Sub(squared, k);
  const DoubleLanes xx = hn::Sub(diagonal, g.xx), yy = hn::Sub(diagonal, g.yy), zz = hn::Sub(diagonal, g.zz);
  const DoubleLanes xy = hn::Neg(g.xy), xz = hn::Neg(g.xz), yz = hn::Neg(g.yz);
  const auto column = [&](const ColumnLanes& cofactor, DoubleLanes hx, DoubleLanes hy, DoubleLanes hz) HWY_ATTR {
    const ColumnLanes product = plus(plus(times(a.column[0], hx), times(a.column[1], hy)), times(a.column[2], hz));
    return plus(times(cofactor, of_cofactor), times(product, of_a));
  };
  const MatrixLanes rotation{{column(first, xx, xy, xz), column(cross(a.column[2], a.column[0]), xy, yy, yz),
                              column(cross(a.column[0], a.column[1]), xz, yz, zz)}};
  const QuatLanes q = QuatForms(rotation).longest();
  const DoubleLanes cube = hn::Mul(trace_of_g, hn::Sqrt(trace_of_g));
  const DoubleMask is_regular = hn::Gt(hn::Abs(determinant), hn::Mul(cube, hn::Set(d, 1e-5)));
  return {divided(q, hn::Sqrt(square_of(q))), symmetric_product(rotation, a),
          hn::And(hn::And(x.found, is_regular), hn::Le(trace_of_g, hn::Set(d, 1e74)))};
}

HWY_INLINE PolarLanes polar_of(const MatrixLanes& a) {
  const SymmetricLanes g = symmetric_product(a, a);
  const PolarLanes rigid = polar_of_rigid(a, g);
  if (HWY_LIKELY(hn::AllTrue(Doubles(), rigid.found))) return rigid;
  const PolarLanes other = polar_of_stretched(a, g);
  const auto chosen = [&](DoubleLanes r, DoubleLanes o) HWY_ATTR { return hn::IfThenElse(rigid.found, r, o); };
  const QuatLanes &q = rigid.quat, &p = other.quat;
  const SymmetricLanes &s = rigid.stretch, &t = other.stretch;
  return {{chosen(q.x, p.x), chosen(q.y, p.y), chosen(q.z, p.z), chosen(q.w, p.w)},
          {chosen(s.xx, t.xx), chosen(s.yy, t.yy), chosen(s.zz, t.zz), chosen(s.xy, t.xy), chosen(s.xz, t.xz),
           chosen(s.yz, t.yz)},
          hn::Or(rigid.found, other.found)};
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
