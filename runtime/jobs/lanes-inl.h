// SPDX-License-Identifier: MIT
// Four vertices at a time, one per lane. Included once per SIMD target (Highway's foreach_target), hence the guard's form.
#if defined(SINEW_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_LANES_INL_H_
#undef SINEW_LANES_INL_H_
#else
#define SINEW_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include "runtime/math/conventions.h"
#include "runtime/math/normal_transform.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D4 = hn::FixedTag<float, 4>;
using V4 = hn::Vec<D4>;

/// Four vectors, one per lane.
struct Lanes3 {
  V4 x, y, z;
};

/// Rows to columns: lane i of the results comes from argument i.
struct Lanes4 {
  V4 x, y, z, w;
};

HWY_INLINE Lanes4 transpose(V4 a, V4 b, V4 c, V4 e) {
  const D4 d;
  const V4 ac_low = hn::InterleaveLower(d, a, c), ac_high = hn::InterleaveUpper(d, a, c);
  const V4 be_low = hn::InterleaveLower(d, b, e), be_high = hn::InterleaveUpper(d, b, e);
  return {hn::InterleaveLower(d, ac_low, be_low), hn::InterleaveUpper(d, ac_low, be_low),
          hn::InterleaveLower(d, ac_high, be_high), hn::InterleaveUpper(d, ac_high, be_high)};
}

/// eq   a.x b.x + a.y b.y + a.z b.z, summed in that order
HWY_INLINE V4 dot(const Lanes3& a, const Lanes3& b) {
  return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}

HWY_INLINE Lanes3 cross(const Lanes3& a, const Lanes3& b) {
  return {hn::NegMulAdd(a.z, b.y, hn::Mul(a.y, b.z)), hn::NegMulAdd(a.x, b.z, hn::Mul(a.z, b.x)),
          hn::NegMulAdd(a.y, b.x, hn::Mul(a.x, b.y))};
}

HWY_INLINE Lanes3 scaled(const Lanes3& a, V4 s) { return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)}; }

HWY_INLINE Lanes3 load3(const glm::vec3* four) {
  Lanes3 out;
  hn::LoadInterleaved3(D4(), &four->x, out.x, out.y, out.z);
  return out;
}

HWY_INLINE void store3(const Lanes3& v, glm::vec3* four) { hn::StoreInterleaved3(v.x, v.y, v.z, D4(), &four->x); }

/// Negates the cofactor normals of matrices that mirror, by their determinants and squared Frobenius norms: the same choice
/// as transform_normal_outward.
HWY_INLINE Lanes3 turned_outward(const Lanes3& n, V4 determinant, V4 squared_norm) {
  const D4 d;
  const V4 flat = hn::Mul(hn::Mul(squared_norm, hn::Sqrt(squared_norm)), hn::Set(d, -kFlatDeterminant<float>));
  const auto mirrors = hn::Lt(determinant, flat);
  const auto turned = [&](V4 v) HWY_ATTR { return hn::IfThenElse(mirrors, hn::Neg(v), v); };
  return {turned(n.x), turned(n.y), turned(n.z)};
}

/// Unit vectors, by an exact square root and division. Answers false when the square of some length leaves the range in
/// which float keeps its digits: then the caller takes the careful way, vertex by vertex.
HWY_INLINE bool normalise(Lanes3& v) {
  const D4 d;
  const V4 squared = dot(v, v);
  if (!hn::AllTrue(d, hn::And(hn::Gt(squared, hn::Set(d, 1e-30f)), hn::Lt(squared, hn::Set(d, 1e30f))))) return false;
  v = scaled(v, hn::Div(hn::Set(d, 1.0f), hn::Sqrt(squared)));
  return true;
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET
#endif
