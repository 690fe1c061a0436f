// SPDX-License-Identifier: MIT
// Blends the rigid motions of a run (vertices with the same set of joints, vertex_tiles.h), with one vertex per lane.
#if defined(SINEW_SPREAD_MOTIONS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_SPREAD_MOTIONS_INL_H_
#undef SINEW_SPREAD_MOTIONS_INL_H_
#else
#define SINEW_SPREAD_MOTIONS_INL_H_
#endif

#include "runtime/deform/simd/blend_dual_quaternions-inl.h"
#include "runtime/deform/simd/spread_numbers-inl.h"
#include "runtime/deform/vertex_tiles.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Blended dual quaternions of the vertices of a run. All rotations that share a vertex are in one hemisphere.
/// eq   D = B + sum(w_i (D_i - B)), B the dual quaternion of the last joint
/// in   kCount  joints of the run; 0 = known at run time only. With more than kRoom joints, the differences are computed
///      again for each vector.
template <int kCount>
class SpreadMotions {
 public:
  HWY_INLINE SpreadMotions(const RigidStretch* split, const std::uint16_t* joints, std::size_t count)
      : split_(split), joints_(joints), count_(count) {
    if (kCount == 0 && count > kRoom) return;
    const Float8 base = load_float8(floats_of(this->count() - 1));
    keep(0, base);
    for (std::size_t i = 1; i < this->count(); ++i) keep(i, minus(load_float8(floats_of(i - 1)), base));
  }

  HWY_INLINE DualQuatLanes blend(const TilePlane* weights, std::size_t lane) const {
    if (kCount == 0 && HWY_UNLIKELY(count_ > kRoom)) return dual_quat_lanes(blend_many(weights, lane));
    Lanes8 sum = motion(0);
    for (std::size_t i = 1; i < count(); ++i)
      sum = plus_product(sum, motion(i), hn::Load(TileTag(), weights[i - 1].lane.data() + lane));
    return dual_quat_lanes(sum);
  }

 private:
  static constexpr std::size_t kFloats = 8, kRoom = kCount > 0 ? static_cast<std::size_t>(kCount) : 8;

  const float* floats_of(std::size_t i) const { return &split_[joints_[i]].rigid.real.x; }
  HWY_INLINE void keep(std::size_t i, const Float8& eight) {
    HWY_ALIGN float of[kFloats];
    store_float8(eight, of);
    for (std::size_t f = 0; f < kFloats; ++f) numbers_.keep(i, f, of[f]);
  }
  std::size_t count() const { return kCount > 0 ? static_cast<std::size_t>(kCount) : count_; }
  HWY_INLINE Lanes8 motion(std::size_t i) const {
    return {{numbers_.of(i, 0), numbers_.of(i, 1), numbers_.of(i, 2), numbers_.of(i, 3)},
            {numbers_.of(i, 4), numbers_.of(i, 5), numbers_.of(i, 6), numbers_.of(i, 7)}};
  }

  static HWY_INLINE Lanes4 plus_product(const Lanes4& sum, const Lanes4& v, Wide s) {
    return {hn::MulAdd(v.x, s, sum.x), hn::MulAdd(v.y, s, sum.y), hn::MulAdd(v.z, s, sum.z), hn::MulAdd(v.w, s, sum.w)};
  }
  static HWY_INLINE Lanes8 plus_product(const Lanes8& sum, const Lanes8& v, Wide s) {
    return {plus_product(sum.low, v.low, s), plus_product(sum.high, v.high, s)};
  }
  static HWY_INLINE Lanes4 spread(const float* floats, const float* base) {
    const auto number = [&](std::size_t f)
                            HWY_ATTR { return hn::Set(TileTag(), base ? floats[f] - base[f] : floats[f]); };
    return {number(0), number(1), number(2), number(3)};
  }

  HWY_NOINLINE Lanes8 blend_many(const TilePlane* weights, std::size_t lane) const {
    const float* base = floats_of(count_ - 1);
    Lanes8 sum{spread(base, nullptr), spread(base + 4, nullptr)};
    for (std::size_t i = 0; i + 1 < count_; ++i) {
      const float* floats = floats_of(i);
      sum = plus_product(sum, {spread(floats, base), spread(floats + 4, base + 4)},
                         hn::Load(TileTag(), weights[i].lane.data() + lane));
    }
    return sum;
  }

  const RigidStretch* split_;
  const std::uint16_t* joints_;
  std::size_t count_;
  SpreadNumbers<kRoom, kFloats> numbers_;
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
