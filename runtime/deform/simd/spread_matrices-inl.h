// SPDX-License-Identifier: MIT
// Blends the matrices of a run (vertices with the same set of joints, vertex_tiles.h), with one vertex per lane.
#if defined(SINEW_SPREAD_MATRICES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_SPREAD_MATRICES_INL_H_
#undef SINEW_SPREAD_MATRICES_INL_H_
#else
#define SINEW_SPREAD_MATRICES_INL_H_
#endif

#include "runtime/deform/simd/lane_matrix-inl.h"
#include "runtime/deform/simd/spread_numbers-inl.h"
#include "runtime/deform/vertex_tiles.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Up to `kRoom` joint matrices: a base, and the differences of the other matrices from it.
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

  HWY_INLINE Lanes3 column(std::size_t i, std::size_t c) const {
    return {entries_.of(i, 4 * c), entries_.of(i, 4 * c + 1), entries_.of(i, 4 * c + 2)};
  }

 private:
  HWY_INLINE void keep(std::size_t i, const JointMatrix& m) {
    for (std::size_t c = 0; c < 4; ++c)
      for (std::size_t r = 0; r < 3; ++r) entries_.keep(i, 4 * c + r, (&m.column[c].x)[r]);
  }

  SpreadNumbers<kRoom, 16> entries_;  // columns of four, as in JointMatrix
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

  /// The blends of one vector of vertices.
  class Blend {
   public:
    HWY_INLINE Blend(const SpreadMatrices& all, const TilePlane* weights, std::size_t lane)
        : kept_(all.kept_), weights_(weights), lane_(lane) {}
    /// Blends column `c` when it is asked for, so that a caller with few registers can use it up first.
    HWY_INLINE Lanes3 column(std::size_t c) const {
      Lanes3 sum = kept_.column(0, c);
      for (std::size_t i = 1; i < kCount; ++i)
        sum = plus_product(sum, kept_.column(i, c), hn::Load(TileTag(), weights_[i - 1].lane.data() + lane_));
      return sum;
    }

   private:
    const KeptMatrices<kCount>& kept_;
    const TilePlane* weights_;
    std::size_t lane_;
  };

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

  /// Blends two columns in one loop: four would not fit into sixteen registers, and one alone loops twice as often.
  class Blend {
   public:
    HWY_INLINE Blend(const SpreadMatrices& all, const TilePlane* weights, std::size_t lane)
        : all_(all), weights_(weights), lane_(lane) {}
    /// Column 3 or 2 comes with column 0 or 1, which is asked for first.
    HWY_INLINE Lanes3 column(std::size_t c) {
      if (c < 2) all_.blend_pair(c, 3 - c, weights_, lane_, first_, second_);
      return c < 2 ? first_ : second_;
    }

   private:
    const SpreadMatrices& all_;
    const TilePlane* weights_;
    std::size_t lane_;
    Lanes3 first_, second_;
  };

 private:
  static constexpr std::size_t kRoom = 8;

  HWY_INLINE void blend_pair(std::size_t a, std::size_t b, const TilePlane* weights, std::size_t lane, Lanes3& sum_a,
                             Lanes3& sum_b) const {
    const auto weight = [&](std::size_t i) HWY_ATTR { return hn::Load(TileTag(), weights[i].lane.data() + lane); };
    if (HWY_LIKELY(count_ <= kRoom)) {
      sum_a = kept_.column(0, a);
      sum_b = kept_.column(0, b);
      for (std::size_t i = 1; i < count_; ++i) {
        const Wide w = weight(i - 1);
        sum_a = plus_product(sum_a, kept_.column(i, a), w);
        sum_b = plus_product(sum_b, kept_.column(i, b), w);
      }
      return;
    }
    const auto column = [&](std::size_t i, std::size_t c) HWY_ATTR {
      const glm::vec4& of = palette_[joints_[i]].column[c];
      return Lanes3{hn::Set(TileTag(), of.x), hn::Set(TileTag(), of.y), hn::Set(TileTag(), of.z)};
    };
    const Lanes3 base_a = column(count_ - 1, a), base_b = column(count_ - 1, b);
    sum_a = base_a;
    sum_b = base_b;
    for (std::size_t i = 0; i + 1 < count_; ++i) {
      sum_a = plus_product(sum_a, minus(column(i, a), base_a), weight(i));
      sum_b = plus_product(sum_b, minus(column(i, b), base_b), weight(i));
    }
  }

  const JointMatrix* palette_;
  const std::uint16_t* joints_;
  std::size_t count_;
  KeptMatrices<kRoom> kept_;
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
