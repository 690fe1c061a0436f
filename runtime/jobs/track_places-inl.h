// SPDX-License-Identifier: MIT
// Where the lanes of a block of tracks come from and go to; included once per SIMD target, so without `#pragma once`.
#if defined(SINEW_TRACK_PLACES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_TRACK_PLACES_INL_H
#undef SINEW_TRACK_PLACES_INL_H
#else
#define SINEW_TRACK_PLACES_INL_H
#endif

#include <hwy/highway.h>

#include "runtime/jobs/track_output.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kLanePadding>;
using Lanes = hn::Vec<Floats>;

HWY_INLINE Lanes load(const TrackBlock& block, std::size_t key, std::size_t plane, std::size_t lane) {
  return hn::LoadU(Floats(), block.plane(key, plane) + lane);
}

/// Lanes from `lane` on, and where they go: weights and numbers to their neighbours, joints to the vector of joints from `joint` on.
class Place {
 public:
  HWY_INLINE Place(const TrackBlock& block, const TrackOutput& out, std::size_t lane) : out_(out), lane_(lane), weights_(block.lane_count - lane) {
    target_ = block.targets[lane];
  }
  HWY_INLINE Place(const TrackBlock& block, const TrackOutput& out, std::size_t lane, std::size_t joint)
      : out_(out), lane_(lane), target_(block.places.first_joint + joint), lane_of_(&block.places.lane_of[joint]) {}

  std::size_t lane() const { return lane_; }

  HWY_INLINE void store(std::size_t component, Lanes values) const {
    const Floats d;
    float* to = out_.plane(component) + target_;
    if (lane_of_ == nullptr) {
      if (weights_ >= hn::Lanes(d)) return hn::StoreU(values, d, to);
      HWY_ALIGN float buffer[kLanePadding];
      hn::Store(values, d, buffer);
      for (std::size_t i = 0; i < weights_; ++i) to[i] = buffer[i];
      return;
    }
    const hn::RebindToSigned<Floats> di;
    const auto lanes = hn::LoadU(di, lane_of_);
    const auto here = hn::Max(hn::Sub(lanes, hn::Set(di, static_cast<std::int32_t>(lane_))), hn::Zero(di));
    const auto placed = hn::TableLookupLanes(values, hn::IndicesFromVec(d, here));
    hn::StoreU(hn::IfThenElse(hn::RebindMask(d, hn::Gt(lanes, hn::Set(di, -1))), placed, hn::LoadU(d, to)), d, to);
  }

 private:
  const TrackOutput& out_;
  std::size_t lane_, target_ = 0, weights_ = 0;
  const std::int32_t* lane_of_ = nullptr;
};

/// Calls `body(place)` until all lanes have been placed.
template <class Body>
HWY_INLINE void for_each_place(const TrackBlock& block, const TrackOutput& out, const Body& body) {
  const std::size_t lanes = hn::Lanes(Floats());
  if (!moves_joints(block.property)) {
    for (std::size_t lane = 0; lane < block.lane_count; lane += lanes) body(Place(block, out, lane));
    return;
  }
  const JointPlaces& places = block.places;
  for (std::size_t joint = 0; joint < places.lane_of.size(); joint += lanes) {
    std::size_t lane = places.lanes_before[joint / JointPlaces::kPart];
    if (lanes < JointPlaces::kPart) {
      if (places.lane_of[joint] < 0) continue;
      lane = static_cast<std::size_t>(places.lane_of[joint]);
    } else if (lane == places.lanes_before[(joint + lanes) / JointPlaces::kPart]) {
      continue;
    }
    body(Place(block, out, lane, joint));
  }
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
