// SPDX-License-Identifier: MIT
#include "runtime/clip/move_lanes.h"

#include <algorithm>
#include <utility>

namespace sinew {
namespace {

struct MovedLane {
  std::uint32_t target, lane;
};

/// The lanes with a new target, sorted by it.
std::vector<MovedLane> moved_lanes(const TrackBlock& block, std::span<const std::uint32_t> new_target) {
  std::vector<MovedLane> lanes;
  for (std::uint32_t lane = 0; lane < block.lane_count; ++lane)
    if (const std::uint32_t target = new_target[block.targets[lane]]; target != kNone) lanes.push_back({target, lane});
  std::sort(lanes.begin(), lanes.end(), [](const MovedLane& a, const MovedLane& b) { return a.target < b.target; });
  return lanes;
}

/// [key][plane][lane] rows of the given lanes.
std::vector<float> rows_of(const TrackBlock& block, std::span<const MovedLane> lanes) {
  const std::size_t row = block.lane_count, rows = (block.rows.size() - kLanePadding) / row;
  std::vector<float> kept;
  kept.reserve(rows * lanes.size() + kLanePadding);
  for (std::size_t r = 0; r < rows; ++r)
    for (const MovedLane& moved : lanes) kept.push_back(block.rows[r * row + moved.lane]);
  kept.resize(kept.size() + kLanePadding, 0.0f);
  return kept;
}

PackedRows packed_rows_of(const TrackBlock& block, std::span<const MovedLane> lanes, std::size_t key_count) {
  std::vector<PackedTrack> tracks;
  for (const MovedLane& moved : lanes)
    tracks.push_back(packed_lane(block.packed, block.lane_count, moved.lane, key_count));
  PackedRows rows = packed_rows(tracks, key_count);
  rows.power = block.packed.power;  // as in the whole block, so that poses keep their bits
  return rows;
}

bool are_all_in_order(const TrackBlock& block, std::span<const MovedLane> lanes) noexcept {
  for (std::size_t i = 0; i < lanes.size(); ++i)
    if (lanes[i].lane != i) return false;
  return lanes.size() == block.lane_count;
}

TrackBlock block_of_lanes(const TrackBlock& block, std::span<const MovedLane> lanes, std::size_t key_count) {
  TrackBlock moved = block_of(block.property, block.interpolation, lanes.size());
  for (const MovedLane& lane : lanes) moved.targets.push_back(lane.target);
  if (is_of_joints(block)) moved.places = JointPlaces(moved.targets);
  if (are_all_in_order(block, lanes)) {
    moved.rows = block.rows;
    moved.packed = block.packed;
  } else if (block.packed.empty()) {
    moved.rows = rows_of(block, lanes);
  } else {
    moved.packed = packed_rows_of(block, lanes, key_count);
  }
  return moved;
}

}  // namespace

void add_moved_lanes(const TrackBlock& block, std::span<const std::uint32_t> new_target, std::size_t key_count,
                     std::vector<TrackBlock>& out) {
  const std::vector<MovedLane> lanes = moved_lanes(block, new_target);
  const std::uint32_t widest_gap =
      is_of_joints(block) ? kWidestGap : 1;  // targets of weights and numbers are consecutive
  for (std::size_t first = 0, end = 0; first < lanes.size(); first = end) {
    for (end = first + 1; end < lanes.size(); ++end)
      if (lanes[end].target - lanes[end - 1].target > widest_gap) break;
    out.push_back(block_of_lanes(block, std::span(lanes).subspan(first, end - first), key_count));
  }
}

}  // namespace sinew
