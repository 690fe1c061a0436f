// SPDX-License-Identifier: MIT
// Loads and stores of the lanes of a block of tracks. Included once per SIMD target, so without `#pragma once`.
#if defined(SINEW_TRACK_PLACES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_TRACK_PLACES_INL_H
#undef SINEW_TRACK_PLACES_INL_H
#else
#define SINEW_TRACK_PLACES_INL_H
#endif

#include <hwy/highway.h>

#include "runtime/pose/track_output.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kLanePadding>;
using Lanes = hn::Vec<Floats>;

/// The planes of one key. Members are copies, because compilers reload fields of the block after every store.
class KeyRow {
 public:
  HWY_INLINE KeyRow(const TrackBlock& block, std::size_t key)
      : first_plane_(block.plane(key, 0)), lane_count_(block.lane_count) {}

  HWY_INLINE Lanes load(std::size_t plane, std::size_t lane) const {
    return hn::LoadU(Floats(), first_plane_ + plane * lane_count_ + lane);
  }

 private:
  const float* first_plane_;
  std::size_t lane_count_;
};

/// A vector of weights or numbers, starting at `lane`. Their targets are consecutive.
class NumberPlace {
 public:
  static constexpr std::size_t kComponents = 1;

  HWY_INLINE NumberPlace(const TrackBlock& block, const TrackOutput& out, std::size_t lane)
      : to_(out.first_plane + block.targets[lane]), lane_(lane), count_(block.lane_count - lane) {}

  HWY_INLINE std::size_t lane() const { return lane_; }
  HWY_INLINE void store(std::size_t, Lanes values) const {
    const Floats d;
    if (count_ >= hn::Lanes(d)) return hn::StoreU(values, d, to_);
    HWY_ALIGN float buffer[kLanePadding];
    hn::Store(values, d, buffer);
    for (std::size_t i = 0; i < count_; ++i) to_[i] = buffer[i];
  }

 private:
  float* to_;
  std::size_t lane_, count_;
};

/// A vector of tracks from `lane` on, for consecutive joints from `joint` on.
class FullPlace {
 public:
  static constexpr std::size_t kComponents = 3;  // of translations and scales

  HWY_INLINE FullPlace(const TrackOutput& out, std::size_t lane, std::size_t joint)
      : to_(out.first_plane + joint), plane_stride_(out.plane_stride), lane_(lane) {}

  HWY_INLINE std::size_t lane() const { return lane_; }
  HWY_INLINE Lanes tracks(Lanes v) const { return v; }
  HWY_INLINE void store(std::size_t component, Lanes values) const {
    hn::StoreU(values, Floats(), to_ + component * plane_stride_);
  }

 private:
  float* to_;
  std::size_t plane_stride_, lane_;
};

/// A vector of tracks from `lane` on, for joints with gaps. `lane_of` permutes them into the vector of joints from
/// `joint` on; some of these joints have no track.
class JointPlace {
 public:
  static constexpr std::size_t kComponents = 3;  // of translations and scales

  HWY_INLINE JointPlace(const TrackOutput& out, std::size_t lane, std::size_t count, std::size_t joint,
                        const std::int32_t* lane_of)
      : to_(out.first_plane + joint),
        plane_stride_(out.plane_stride),
        lane_(lane),
        count_(count - lane),
        lanes_(hn::LoadU(Whole(), lane_of)) {}

  HWY_INLINE std::size_t lane() const { return lane_; }
  /// Sets lanes past the last track to zero.
  HWY_INLINE Lanes tracks(Lanes v) const { return hn::IfThenElseZero(hn::FirstN(Floats(), count_), v); }
  HWY_INLINE void store(std::size_t component, Lanes values) const {
    const Floats d;
    float* to = to_ + component * plane_stride_;
    const auto here = hn::Max(hn::Sub(lanes_, hn::Set(Whole(), static_cast<std::int32_t>(lane_))), hn::Zero(Whole()));
    const auto placed = hn::TableLookupLanes(values, hn::IndicesFromVec(d, here));
    hn::StoreU(hn::IfThenElse(hn::RebindMask(d, hn::Gt(lanes_, hn::Set(Whole(), -1))), placed, hn::LoadU(d, to)), d,
               to);
  }

 private:
  using Whole = hn::RebindToSigned<Floats>;

  float* to_;
  std::size_t plane_stride_, lane_, count_;
  hn::Vec<Whole> lanes_;
};

/// Calls `body(place)` for every vector of joints for which the block has tracks.
template <class Body>
HWY_INLINE void for_each_joint_place(const TrackBlock& block, const TrackOutput& out, const Body& body) {
  constexpr std::size_t kLanes = hn::MaxLanes(Floats()), kPart = JointPlaces::kPart;
  [[maybe_unused]] const std::size_t count = block.lane_count;
  const std::size_t first_joint = block.places.first_joint;
  const std::size_t joints = block.places.lane_of.size();
  const std::int32_t* lane_of = block.places.lane_of.data();
  [[maybe_unused]] const std::uint32_t* lanes_before = block.places.lanes_before.data();
  for (std::size_t joint = 0; joint < joints; joint += kLanes) {
    if constexpr (kLanes < kPart) {
      if (lane_of[joint] >= 0) body(FullPlace(out, static_cast<std::size_t>(lane_of[joint]), first_joint + joint));
    } else {
      const std::size_t lane = lanes_before[joint / kPart], tracks = lanes_before[(joint + kLanes) / kPart] - lane;
      if (tracks == kLanes)
        body(FullPlace(out, lane, first_joint + joint));
      else if (tracks > 0)
        body(JointPlace(out, lane, count, first_joint + joint, lane_of + joint));
    }
  }
}

/// Same, for blocks of any property.
template <class Body>
HWY_INLINE void for_each_place(const TrackBlock& block, const TrackOutput& out, const Body& body) {
  if (moves_joints(block.property)) return for_each_joint_place(block, out, body);
  for (std::size_t lane = 0, count = block.lane_count; lane < count; lane += hn::Lanes(Floats()))
    body(NumberPlace(block, out, lane));
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
