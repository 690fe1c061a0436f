// SPDX-License-Identifier: MIT
#include "runtime/clip/unpack_clip.h"

#include <utility>

#include "runtime/clip/clip_layout.h"
#include "runtime/clip/track_rows.h"
#include "runtime/math/quaternion.h"

namespace sinew {
namespace {

void fill_rotations(TrackBlock& block, const PackedTrack& track, std::size_t lane, std::size_t key_count) {
  QuatTrack keys{block.interpolation, {}, {}};
  for (std::size_t k = 0; k < key_count; ++k) keys.values.push_back(unpack_rotation(track, k));
  fill_lane(block, keys, lane);
}

/// Writes the keys of a vector, weight or number: its components are the planes.
void fill_components(TrackBlock& block, const PackedTrack& track, std::size_t lane, std::size_t key_count) {
  float* const rows = block.rows.own();
  for (std::size_t k = 0; k < key_count; ++k) {
    const std::array<float, 4> v = unpack_key(track, k);
    for (std::size_t c = 0; c < track.components; ++c)
      rows[(k * block.plane_count + c) * block.lane_count + lane] = v[c];
  }
}

TrackBlock unpacked(const TrackBlock& block, std::size_t key_count) {
  TrackBlock out = block_of(block.property, block.interpolation, block.lane_count);
  out.targets = block.targets;
  out.places = block.places;
  make_room(out, key_count);
  for (std::size_t lane = 0; lane < block.lane_count; ++lane) {
    const PackedTrack track = packed_lane(block.packed, block.lane_count, lane, key_count);
    if (block.property == Property::rotation)
      fill_rotations(out, track, lane, key_count);
    else
      fill_components(out, track, lane, key_count);
  }
  return out;
}

}  // namespace

Clip unpacked(const Clip& clip) {
  ClipLayout layout = clip.layout();
  for (TimeGroup& group : layout.groups)
    for (TrackBlock& block : group.blocks)
      if (!block.packed.empty()) block = unpacked(block, group.times.key_count());
  return clip_of(std::move(layout));
}

}  // namespace sinew
