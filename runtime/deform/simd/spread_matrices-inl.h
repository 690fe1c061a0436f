// SPDX-License-Identifier: MIT
// Blends the matrices of a run (vertices with the same set of joints, vertex_tiles.h), with one vertex per lane.
#if defined(SINEW_SPREAD_MATRICES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_SPREAD_MATRICES_INL_H_
#undef SINEW_SPREAD_MATRICES_INL_H_
#else
#define SINEW_SPREAD_MATRICES_INL_H_
#endif

#include "runtime/deform/simd/lane_matrix-inl.h"
#include "runtime/deform/vertex_tiles.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Up to `kRoom` joint matrices: a base, and the differences of the other matrices from it. On x86 below AVX-512 each
/// entry is broadcast to memory once per run, because a multiplication can read an operand from memory. AVX-512
/// broadcasts as it reads.
template <std::size_t kRoom>
class KeptMatrices {
 public:
  /// in   joints[count]  the matrix of the last joint is the base and becomes entry 0
  HWY_INLINE void fill(const JointMatrix* palette, const std::uint16_t* joints, std::size_t count) {
    const JointMatrix& base = palette[joints[count - 1]];
    keep(0, base);
    for (std::size_t i = 1; i < count; ++i) {
      const JointMatrix& joint = palette[joints[i - 1]];
      JointMatrix difference;
      const hn::CappedTag<float, 4> d;
      for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t r = 0; r < 4; r += hn::Lanes(d)) {
          const auto from = [&](const JointMatrix& m) HWY_ATTR { return hn::LoadU(d, &m.column[c].x + r); };
          hn::StoreU(hn::Sub(from(joint), from(base)), d, &difference.column[c].x + r);
        }
      keep(i, difference);
    }
  }

  /// Column `c` of the blend of every vertex.
  HWY_INLINE Lanes3 column(std::size_t c, const TilePlane* weights, std::size_t lane, std::size_t count) const {
    Lanes3 sum = column_of(0, c);
    for (std::size_t i = 1; i < count; ++i)
      sum = plus_product(sum, column_of(i, c), hn::Load(TileTag(), weights[i - 1].lane.data() + lane));
    return sum;
  }

 private:
  static constexpr bool kSpread = HWY_ARCH_X86 && kTileSize > 1 && kTileSize < 16;

  HWY_INLINE void keep(std::size_t i, const JointMatrix& m) {
    if constexpr (kSpread)
      for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t r = 0; r < 3; ++r)
          hn::Store(hn::Set(TileTag(), (&m.column[c].x)[r]), TileTag(), spread_[i][c][r]);
    else
      matrices_[i] = m;
  }
  HWY_INLINE Lanes3 column_of(std::size_t i, std::size_t c) const {
    const TileTag d;
    if constexpr (kSpread) {
      const auto& of = spread_[i][c];
      return {hn::Load(d, of[0]), hn::Load(d, of[1]), hn::Load(d, of[2])};
    } else {
      const glm::vec4& of = matrices_[i].column[c];
      return {hn::Set(d, of.x), hn::Set(d, of.y), hn::Set(d, of.z)};
    }
  }

  JointMatrix matrices_[kSpread ? 1 : kRoom];
  HWY_ALIGN float spread_[kSpread ? kRoom : 1][4][3][kTileSize];
};

/// Blended matrices of the vertices of a run, with a number of joints known at compile time.
/// eq   M = B + sum(w_i (M_i - B)), B the matrix of the last joint
/// in   kCount  joints of the run; 0 = known at run time only
template <int kCount>
class SpreadMatrices {
 public:
  HWY_INLINE SpreadMatrices(const JointMatrix* palette, const std::uint16_t* joints, std::size_t) {
    kept_.fill(palette, joints, kCount);
  }
  HWY_INLINE Lanes3 column(std::size_t c, const TilePlane* weights, std::size_t lane) const {
    return kept_.column(c, weights, lane, kCount);
  }

 private:
  KeptMatrices<kCount> kept_;
};

/// Same for any number of joints, with the same bits. With more than kRoom joints, the differences are computed again
/// for each vector.
template <>
class SpreadMatrices<0> {
 public:
  HWY_INLINE SpreadMatrices(const JointMatrix* palette, const std::uint16_t* joints, std::size_t count)
      : palette_(palette), joints_(joints), count_(count) {
    if (count <= kRoom) kept_.fill(palette, joints, count);
  }

  HWY_INLINE Lanes3 column(std::size_t c, const TilePlane* weights, std::size_t lane) const {
    if (HWY_LIKELY(count_ <= kRoom)) return kept_.column(c, weights, lane, count_);
    const TileTag d;
    const auto spread = [&](const glm::vec4& of) HWY_ATTR {
      return Lanes3{hn::Set(d, of.x), hn::Set(d, of.y), hn::Set(d, of.z)};
    };
    const Lanes3 base = spread(palette_[joints_[count_ - 1]].column[c]);
    Lanes3 sum = base;
    for (std::size_t i = 0; i + 1 < count_; ++i)
      sum = plus_product(sum, minus(spread(palette_[joints_[i]].column[c]), base),
                         hn::Load(d, weights[i].lane.data() + lane));
    return sum;
  }

 private:
  static constexpr std::size_t kRoom = 8;

  const JointMatrix* palette_;
  const std::uint16_t* joints_;
  std::size_t count_;
  KeptMatrices<kRoom> kept_;
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
