// SPDX-License-Identifier: MIT
#include "runtime/clip/clip_layout.h"

namespace sinew {
namespace {

std::uint32_t rotation_planes(Interpolation interpolation) noexcept {
  switch (interpolation) {
    case Interpolation::step: return 4;
    case Interpolation::linear: return 5;
    case Interpolation::cubic_spline: return 12;
    case Interpolation::squad: return 13;
  }
  return 0;
}

}  // namespace

TrackBlock block_of(Property property, Interpolation interpolation, std::size_t lane_count) {
  const bool vector = property == Property::translation || property == Property::scale;
  const std::uint32_t components = vector ? 3 : property == Property::rotation ? 4 : 1;
  const bool cubic = interpolation == Interpolation::cubic_spline;
  TrackBlock block;
  block.property = property;
  block.interpolation = interpolation;
  block.lane_count = static_cast<std::uint32_t>(lane_count);
  block.value_plane = cubic ? components : 0;
  block.plane_count = property == Property::rotation ? rotation_planes(interpolation)
                      : cubic                        ? 3 * components
                                                     : components;
  return block;
}

void count_tracks(const TrackBlock& block, Clip::Counts& counts) noexcept {
  switch (block.property) {
    case Property::translation: counts.translations += block.lane_count; break;
    case Property::rotation: counts.rotations += block.lane_count; break;
    case Property::scale: counts.scales += block.lane_count; break;
    case Property::weight: counts.weights += block.lane_count; break;
    case Property::number: counts.properties += block.lane_count; break;
  }
}

}  // namespace sinew
