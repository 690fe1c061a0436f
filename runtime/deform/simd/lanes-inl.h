// SPDX-License-Identifier: MIT
// Attributes of a tile as structure of arrays: lane i is vertex `vertex_of_lane(i)` of the tile.
#if defined(SINEW_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_LANES_INL_H_
#undef SINEW_LANES_INL_H_
#else
#define SINEW_LANES_INL_H_
#endif

#include "runtime/deform/simd/quarter_lanes-inl.h"
#include "runtime/pose/simd/transpose-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

struct Lanes3 {
  Wide x, y, z;
};

using Lanes4 = FourVectors<Wide>;

/// eq   a.x b.x + a.y b.y + a.z b.z, summed in that order
HWY_INLINE Wide dot(const Lanes3& a, const Lanes3& b) {
  return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}

HWY_INLINE Wide dot(const Lanes4& a, const Lanes4& b) {
  return hn::MulAdd(a.w, b.w, hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x))));
}

HWY_INLINE Lanes3 cross(const Lanes3& a, const Lanes3& b) {
  return {hn::NegMulAdd(a.z, b.y, hn::Mul(a.y, b.z)), hn::NegMulAdd(a.x, b.z, hn::Mul(a.z, b.x)),
          hn::NegMulAdd(a.y, b.x, hn::Mul(a.x, b.y))};
}

HWY_INLINE Lanes3 plus(const Lanes3& a, const Lanes3& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Lanes3 minus(const Lanes3& a, const Lanes3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Lanes3 times(const Lanes3& a, Wide s) { return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)}; }
HWY_INLINE Lanes4 times(const Lanes4& a, Wide s) {
  return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s), hn::Mul(a.w, s)};
}

#if HWY_TARGET == HWY_SCALAR

constexpr std::size_t vertex_of_lane(std::size_t lane) { return lane; }

HWY_INLINE Lanes3 load3(const glm::vec3* tile) {
  return {hn::LoadU(TileTag(), &tile->x), hn::LoadU(TileTag(), &tile->y), hn::LoadU(TileTag(), &tile->z)};
}
HWY_INLINE void store3(const Lanes3& v, glm::vec3* tile) { hn::StoreInterleaved3(v.x, v.y, v.z, TileTag(), &tile->x); }
HWY_INLINE Lanes4 load4(const glm::vec4* tile) {
  Lanes4 out;
  hn::LoadInterleaved4(TileTag(), &tile->x, out.x, out.y, out.z, out.w);
  return out;
}
HWY_INLINE void store4(const Lanes4& v, glm::vec4* tile) {
  hn::StoreInterleaved4(v.x, v.y, v.z, v.w, TileTag(), &tile->x);
}

#else

/// Quarters of a tile to lanes of its vertices (vertex_of_lane), and back.
HWY_INLINE Lanes4 transpose(Wide a, Wide b, Wide c, Wide e) { return transpose_blocks(TileTag(), a, b, c, e); }

HWY_INLINE Lanes3 load3(const glm::vec3* tile) {
  const Lanes4 all =
      transpose(load_quarter<0>(tile), load_quarter<1>(tile), load_quarter<2>(tile), load_quarter<3>(tile));
  return {all.x, all.y, all.z};
}

HWY_INLINE void store3(const Lanes3& v, glm::vec3* tile) {
  const Lanes4 all = transpose(v.x, v.y, v.z, v.z);
  const Wide quarters[4] = {all.x, all.y, all.z, all.w};
  store_packed(quarters, tile);
}

HWY_INLINE Lanes4 load4(const glm::vec4* tile) {
  const auto quarter = [&](std::size_t q) HWY_ATTR { return hn::LoadU(TileTag(), &tile[q * kBlocks].x); };
  return transpose(quarter(0), quarter(1), quarter(2), quarter(3));
}

HWY_INLINE void store4(const Lanes4& v, glm::vec4* tile) {
  const Lanes4 all = transpose(v.x, v.y, v.z, v.w);
  const auto store = [&](Wide quarter, std::size_t q)
                         HWY_ATTR { hn::StoreU(quarter, TileTag(), &tile[q * kBlocks].x); };
  store(all.x, 0);
  store(all.y, 1);
  store(all.z, 2);
  store(all.w, 3);
}

#endif  // HWY_TARGET

/// Makes vectors unit, by an exact square root and division. Returns the lanes whose squared length is in the range
/// in which float keeps its digits; the others are for the scalar path.
HWY_INLINE hn::Mask<TileTag> normalise(Lanes3& v) {
  const TileTag d;
  const Wide squared = dot(v, v);
  v = times(v, hn::Div(hn::Set(d, 1.0f), hn::Sqrt(squared)));
  return keeps_digits(squared);
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
