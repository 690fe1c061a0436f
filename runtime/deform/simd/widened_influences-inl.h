// SPDX-License-Identifier: MIT
// Converts joint indices and weights of a row of tiles from small integers to the types of the kernels.
#if defined(SINEW_WIDENED_INFLUENCES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_WIDENED_INFLUENCES_INL_H_
#undef SINEW_WIDENED_INFLUENCES_INL_H_
#else
#define SINEW_WIDENED_INFLUENCES_INL_H_
#endif

#include <algorithm>
#include <limits>
#include <type_traits>
#include <variant>

#include "runtime/deform/influence_streams.h"
#include "runtime/deform/simd/tile_memory-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// 1 / (2^bits - 1), split into 1 / 2^bits and the remainder.
template <class Number>
struct WeightStep {
  static constexpr double kMost = std::numeric_limits<Number>::max();
  static constexpr float kHigh = static_cast<float>(1.0 / (kMost + 1.0));
  static constexpr float kRest = static_cast<float>(1.0 / kMost - 1.0 / (kMost + 1.0));
};

/// eq   w = c / (2^bits - 1)   (glTF 2.0, 3.6.2.2), computed as c 2^-bits + c r with r = 1 / (2^bits - 1) - 2^-bits
///      The first product is exact, so for every 8-bit and 16-bit c the sum has the bits of the quotient. A division
///      would take longer than blending.
template <class Number>
HWY_INLINE void widen_weights(const Number* from, std::size_t count, float* to) {
  using Step = WeightStep<Number>;
  const TileTag d;
  const hn::Rebind<Number, TileTag> narrow;
  const hn::RebindToSigned<TileTag> whole;
  std::size_t i = 0;
  for (; i + kTileSize <= count; i += kTileSize) {
    const Wide c = hn::ConvertTo(d, hn::PromoteTo(whole, hn::LoadU(narrow, from + i)));
    hn::StoreU(hn::Add(hn::Mul(c, hn::Set(d, Step::kHigh)), hn::Mul(c, hn::Set(d, Step::kRest))), d, to + i);
  }
  for (; i < count; ++i) {
    const auto c = static_cast<float>(from[i]);
    to[i] = c * Step::kHigh + c * Step::kRest;
  }
}

/// Influences of consecutive vertices. Small integers are converted into a buffer; 16-bit joints and float weights are
/// used in place.
class WidenedInfluences {
 public:
  /// Number of tiles that are converted at once: as many as kernels process in one go, or as the buffer holds.
  static constexpr std::size_t tiles_at_once(std::size_t influence_count) {
    return std::min(kTiles, kTiles * kUsual / influence_count);
  }

  VertexJoints<0> of(const InfluenceStreams& all, std::size_t first, std::size_t vertex_count,
                     std::size_t influence_count) {
    const std::size_t count = vertex_count * influence_count;
    VertexJoints<0> out{joints_, weights_, influence_count};
    if (const auto* wide = std::get_if<std::span<const std::uint16_t>>(&all.joints))
      out.joints = wide->data() + first;
    else
      std::copy_n(std::get<std::span<const std::uint8_t>>(all.joints).data() + first, count, joints_);
    std::visit(
        [&](auto weights) {
          using Number = std::remove_const_t<typename decltype(weights)::element_type>;
          if constexpr (std::is_integral_v<Number>)
            widen_weights(weights.data() + first, count, weights_);
          else
            out.weights = weights.data() + first;
        },
        all.weights);
    return out;
  }

 private:
  static constexpr std::size_t kTiles = 8;
  static constexpr std::size_t kUsual = 8;  ///< most influences of a vertex of which kTiles tiles have room
  static constexpr std::size_t kRoom = kTileSize * kTiles * kUsual;
  static_assert(kTiles * kUsual >= InfluenceStreams::kMaxConverted);
  HWY_ALIGN std::uint16_t joints_[kRoom];
  HWY_ALIGN float weights_[kRoom];
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
