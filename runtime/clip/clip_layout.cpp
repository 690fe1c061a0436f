// SPDX-License-Identifier: MIT
#include "runtime/clip/clip_layout.h"

namespace sinew {
namespace {

std::uint32_t rotation_planes(Interpolation interpolation) noexcept {
  switch (interpolation) {
    case Interpolation::step: return 4;
    case Interpolation::linear: return 5;
    case Interpolation::cubic_spline: return 12;
    case Interpolation::squad: break;
  }
  return 13;
}

}  // namespace

BasePose::BasePose(const std::vector<Transform>& rest) : stride(stride_for(rest.size())), planes(10 * stride, 0.0f) {
  for (std::size_t j = 0; j < stride; ++j) {
    const Transform t = j < rest.size() ? rest[j] : Transform{};
    set(0, j, {t.translation.x, t.translation.y, t.translation.z});
    set_rotation(j, t.rotation);
    set(7, j, {t.scale.x, t.scale.y, t.scale.z});
  }
}

JointPlaces::JointPlaces(std::span<const std::uint32_t> joints)
    : first_joint(static_cast<std::uint32_t>(joints.front() / kStep * kStep)),
      lane_of((joints.back() - first_joint) / kStep * kStep + kStep, -1),
      lanes_before(lane_of.size() / kPart + 1, 0) {
  for (std::size_t lane = 0; lane < joints.size(); ++lane) {
    lane_of[joints[lane] - first_joint] = static_cast<std::int32_t>(lane);
    ++lanes_before[(joints[lane] - first_joint) / kPart + 1];
  }
  for (std::size_t i = 1; i < lanes_before.size(); ++i) lanes_before[i] += lanes_before[i - 1];
}

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
