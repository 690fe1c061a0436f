// SPDX-License-Identifier: MIT
// Stores the lanes of blocks of packed tracks. Included once per SIMD target, so without `#pragma once`.
#if defined(SINEW_PACKED_PLACES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_PACKED_PLACES_INL_H
#undef SINEW_PACKED_PLACES_INL_H
#else
#define SINEW_PACKED_PLACES_INL_H
#endif

#include "runtime/pose/simd/track_places-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Vectors of few lanes, for small blocks and for the remainder of large ones.
using FewFloats = hn::CappedTag<float, 4>;

/// Calls `body(d, lane, to, stride)` for every vector of lanes; it writes component c to `to + c * stride`. If the
/// targets of the block are consecutive, `to` is the output itself. Otherwise it is a buffer from which vectors of
/// joints are put together: tracks without gaps need fewer vectors than joints with gaps.
template <std::size_t kComponents, class Body>
HWY_INLINE void for_each_lane(const TrackBlock& block, const TrackOutput& out, const Body& body) {
  const Floats d;
  const FewFloats few;
  constexpr std::size_t kLanes = hn::MaxLanes(Floats()), kFew = hn::MaxLanes(FewFloats());
  const std::size_t count = block.lane_count;
  const std::uint32_t* targets = block.targets.data();
  const bool neighbours = targets[count - 1] - targets[0] + 1 == count;
  const std::size_t stride = (count + kLanePadding - 1) / kLanePadding * kLanePadding;
  HWY_ALIGN float buffer[kComponents * kMostPackedLanes + kLanePadding];
  float* const first = neighbours ? out.first_plane + targets[0] : buffer;
  const std::size_t first_stride = neighbours ? out.plane_stride : stride;
  // If targets are consecutive, a full last vector would reach past the last target, so its lanes are stored one by
  // one.
  const std::size_t end = neighbours ? count : count + kLanePadding;
  std::size_t lane = 0, aside = neighbours ? count : 0;
  float* to = first;
  std::size_t to_stride = first_stride;
  const auto vector = [&](auto tag) HWY_ATTR {
    if (HWY_UNLIKELY(lane + hn::MaxLanes(tag) > end)) {
      aside = lane;
      to = buffer;
      to_stride = stride;
    }
    body(tag, lane, to + lane, to_stride);
  };
  for (; lane + kFew < count; lane += kLanes) vector(d);
  if (lane < count) vector(few);
  if (!neighbours && count > kFew) {
    for_each_joint_place(block, out, [&](const auto& place) HWY_ATTR {
      for (std::size_t c = 0; c < kComponents; ++c) place.store(c, hn::LoadU(d, buffer + c * stride + place.lane()));
    });
    return;
  }
  for (std::size_t i = aside; i < count; ++i)
    for (std::size_t c = 0; c < kComponents; ++c) out.plane(c)[targets[i]] = buffer[c * stride + i];
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
