// SPDX-License-Identifier: MIT
// Eight floats per vertex (a dual quaternion or a stretch): loaded vertex by vertex, then transposed into lanes.
#if defined(SINEW_FLOAT8_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_FLOAT8_LANES_INL_H_
#undef SINEW_FLOAT8_LANES_INL_H_
#else
#define SINEW_FLOAT8_LANES_INL_H_
#endif

#include "runtime/deform/simd/lane_memory-inl.h"
#include "runtime/deform/simd/vertex_tiles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Eight floats of one vertex, in as many vectors as they need.
using Float8Tag = hn::CappedTag<float, 8>;
struct Float8 {
  static constexpr std::size_t kLanes = hn::MaxLanes(Float8Tag()), kCount = 8 / kLanes;
  hn::Vec<Float8Tag> part[kCount];
};

HWY_INLINE Float8 load_float8(const float* from) {
  Float8 out;
  for (std::size_t p = 0; p < Float8::kCount; ++p) out.part[p] = hn::Load(Float8Tag(), from + p * Float8::kLanes);
  return out;
}
HWY_INLINE void store_float8(const Float8& a, float* to) {
  for (std::size_t p = 0; p < Float8::kCount; ++p) hn::Store(a.part[p], Float8Tag(), to + p * Float8::kLanes);
}
HWY_INLINE Float8 minus(const Float8& a, const Float8& b) {
  Float8 out;
  for (std::size_t p = 0; p < Float8::kCount; ++p) out.part[p] = hn::Sub(a.part[p], b.part[p]);
  return out;
}
HWY_INLINE Float8 times(const Float8& a, hn::Vec<Float8Tag> w) {
  Float8 out;
  for (std::size_t p = 0; p < Float8::kCount; ++p) out.part[p] = hn::Mul(a.part[p], w);
  return out;
}
HWY_INLINE Float8 times_plus(const float* from, hn::Vec<Float8Tag> w, const Float8& sum) {
  Float8 out;
  for (std::size_t p = 0; p < Float8::kCount; ++p)
    out.part[p] = hn::MulAdd(hn::Load(Float8Tag(), from + p * Float8::kLanes), w, sum.part[p]);
  return out;
}

/// Eight floats of every vertex of a tile, one vertex per lane.
struct Lanes8 {
  Lanes4 low, high;
};

#if HWY_TARGET == HWY_SCALAR

/// A tile of one vertex needs no transposition.
HWY_INLINE Lanes8 lanes_of(const Float8 (&e)[kTileSize]) {
  const auto& p = e[0].part;
  return {{p[0], p[1], p[2], p[3]}, {p[4], p[5], p[6], p[7]}};
}

#else

/// Transposes a tile; the first four floats of each vertex go to `low`.
HWY_INLINE Lanes8 lanes_of(const Float8 (&e)[kTileSize]) {
#if HWY_MAX_BYTES >= 64
  const TileTag d;
  const auto pair = [&](std::size_t first) HWY_ATTR { return hn::Combine(d, e[first + 2].part[0], e[first].part[0]); };
  const Lanes4 a = transpose(pair(0), pair(4), pair(8), pair(12)), b = transpose(pair(1), pair(5), pair(9), pair(13));
  const auto even = [](Wide of_a, Wide of_b) HWY_ATTR { return hn::OddEvenBlocks(hn::SwapAdjacentBlocks(of_b), of_a); };
  const auto odd = [](Wide of_a, Wide of_b) HWY_ATTR { return hn::OddEvenBlocks(of_b, hn::SwapAdjacentBlocks(of_a)); };
  return {{even(a.x, b.x), even(a.y, b.y), even(a.z, b.z), even(a.w, b.w)},
          {odd(a.x, b.x), odd(a.y, b.y), odd(a.z, b.z), odd(a.w, b.w)}};
#elif HWY_MAX_BYTES >= 32
  const TileTag d;
  const Lanes4 a = transpose(e[0].part[0], e[1].part[0], e[2].part[0], e[3].part[0]);
  const Lanes4 b = transpose(e[4].part[0], e[5].part[0], e[6].part[0], e[7].part[0]);
  const auto low = [&](Wide of_a, Wide of_b) HWY_ATTR { return hn::ConcatLowerLower(d, of_b, of_a); };
  const auto high = [&](Wide of_a, Wide of_b) HWY_ATTR { return hn::ConcatUpperUpper(d, of_b, of_a); };
  return {{low(a.x, b.x), low(a.y, b.y), low(a.z, b.z), low(a.w, b.w)},
          {high(a.x, b.x), high(a.y, b.y), high(a.z, b.z), high(a.w, b.w)}};
#else
  return {transpose(e[0].part[0], e[1].part[0], e[2].part[0], e[3].part[0]),
          transpose(e[0].part[1], e[1].part[1], e[2].part[1], e[3].part[1])};
#endif
}

#endif  // HWY_TARGET

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
