// SPDX-License-Identifier: MIT
// Numbers that all vertices of a run follow, ready to be multiplied with one weight a lane.
#if defined(SINEW_SPREAD_NUMBERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_SPREAD_NUMBERS_INL_H_
#undef SINEW_SPREAD_NUMBERS_INL_H_
#else
#define SINEW_SPREAD_NUMBERS_INL_H_
#endif

#include "runtime/deform/simd/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// `kNumbers` numbers of each of `kJoints` joints. On x86 below AVX-512 each is broadcast to memory once per run,
/// because a multiplication can read an operand from memory. AVX-512 broadcasts as it reads.
template <std::size_t kJoints, std::size_t kNumbers>
class SpreadNumbers {
 public:
  HWY_INLINE void keep(std::size_t joint, std::size_t number, float value) {
    if constexpr (kSpread)
      hn::Store(hn::Set(TileTag(), value), TileTag(), spread_[joint][number]);
    else
      numbers_[joint][number] = value;
  }
  HWY_INLINE Wide of(std::size_t joint, std::size_t number) const {
    if constexpr (kSpread)
      return hn::Load(TileTag(), spread_[joint][number]);
    else
      return hn::Set(TileTag(), numbers_[joint][number]);
  }

 private:
  static constexpr bool kSpread = HWY_ARCH_X86 && kTileSize > 1 && kTileSize < 16;

  float numbers_[kSpread ? 1 : kJoints][kNumbers];
  HWY_ALIGN float spread_[kSpread ? kJoints : 1][kNumbers][kTileSize];
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
