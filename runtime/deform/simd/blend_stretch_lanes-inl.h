// SPDX-License-Identifier: MIT
// Blended stretches of a tile. They are blended vertex by vertex and then transposed into lanes.
#if defined(SINEW_BLEND_STRETCH_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_BLEND_STRETCH_LANES_INL_H_
#undef SINEW_BLEND_STRETCH_LANES_INL_H_
#else
#define SINEW_BLEND_STRETCH_LANES_INL_H_
#endif

#include "runtime/deform/simd/float8_lanes-inl.h"
#include "runtime/deform/simd/lane_memory-inl.h"
#include "runtime/deform/simd/vertex_tiles-inl.h"
#include "runtime/pose/joint_palette.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Symmetric matrices of a tile, one vertex per lane.
struct StretchLanes {
  Wide xx, yy, zz, xy, xz, yz;
};

/// Blended stretch of one vertex. A vertex with one influence takes the joint's stretch as it is.
/// eq   S = sum(w S_i)
template <int kCount>
HWY_INLINE Float8 blend_stretch_float8(const RigidStretch* split, const TileInfluences<kCount>& tile, std::size_t k) {
  const Float8Tag d;
  const VertexJoints<kCount> vertex = tile.at(k);
  Float8 sum = load_float8(tile.entry(split, k, 0)->stretch);
  if (vertex.count() == 1) return sum;
  sum = times(sum, hn::Set(d, vertex.weights[0]));
  for (std::size_t i = 1; i < vertex.count(); ++i)
    sum = times_plus(tile.entry(split, k, i)->stretch, hn::Set(d, vertex.weights[i]), sum);
  return sum;
}

HWY_INLINE StretchLanes stretch_lanes(const Lanes8& s) {
  return {s.low.x, s.low.y, s.low.z, s.low.w, s.high.x, s.high.y};
}

HWY_INLINE Lanes3 apply(const StretchLanes& s, const Lanes3& v) {
  return {dot(Lanes3{s.xx, s.xy, s.xz}, v), dot(Lanes3{s.xy, s.yy, s.yz}, v), dot(Lanes3{s.xz, s.yz, s.zz}, v)};
}

/// The cofactor matrix of a symmetric matrix, which is symmetric too.
HWY_INLINE StretchLanes cofactor(const StretchLanes& s) {
  const auto minor = [](Wide a, Wide b, Wide c, Wide e)
                         HWY_ATTR { return hn::NegMulAdd(c, e, hn::Mul(a, b)); };  // a b - c e
  return {minor(s.yy, s.zz, s.yz, s.yz), minor(s.xx, s.zz, s.xz, s.xz), minor(s.xx, s.yy, s.xy, s.xy),
          minor(s.yz, s.xz, s.xy, s.zz), minor(s.xy, s.yz, s.yy, s.xz), minor(s.xy, s.xz, s.xx, s.yz)};
}

/// Moved normals, not normalised. Clears the lanes of `sound` where float cannot tell the side of the normal
/// (OutwardSide).
/// eq   n' = sign(det S) cof(S) n   (conventions.h)
HWY_INLINE Lanes3 apply_to_normal(const StretchLanes& s, const Lanes3& n, hn::Mask<TileTag>& sound) {
  const StretchLanes cof = cofactor(s);
  const Wide determinant = dot(Lanes3{s.xx, s.xy, s.xz}, Lanes3{cof.xx, cof.xy, cof.xz});
  const Wide off_diagonal = dot(Lanes3{s.xy, s.xz, s.yz}, Lanes3{s.xy, s.xz, s.yz});
  const Wide squares =
      hn::Add(dot(Lanes3{s.xx, s.yy, s.zz}, Lanes3{s.xx, s.yy, s.zz}), hn::Add(off_diagonal, off_diagonal));
  const OutwardSide outward(determinant, squares);
  sound = hn::And(sound, outward.certain());
  const Lanes3 moved = apply(cof, n);
  return {outward.turned(moved.x), outward.turned(moved.y), outward.turned(moved.z)};
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
