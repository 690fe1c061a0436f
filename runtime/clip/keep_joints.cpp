// SPDX-License-Identifier: MIT
#include "runtime/clip/keep_joints.h"

#include <algorithm>
#include <utility>

#include "runtime/base/contract.h"
#include "runtime/clip/clip_layout.h"

namespace sinew {
namespace {

/// The new number of each old one, kNone for those that are not kept.
std::vector<std::uint32_t> new_numbers(std::size_t joint_count, std::span<const std::uint32_t> joints) {
  std::vector<std::uint32_t> numbers(joint_count, kNone);
  for (std::size_t k = 0; k < joints.size(); ++k) numbers[joints[k]] = static_cast<std::uint32_t>(k);
  return numbers;
}

bool is_of_joints(const TrackBlock& block) noexcept {
  return block.property != Property::weight && block.property != Property::number;
}

/// [key][plane][lane] of some lanes alone.
std::vector<float> keep_rows(const TrackBlock& block, std::span<const std::uint32_t> lanes) {
  const std::size_t row = block.lane_count, rows = (block.rows.size() - kLanePadding) / row;
  std::vector<float> kept;
  kept.reserve(rows * lanes.size() + kLanePadding);
  for (std::size_t r = 0; r < rows; ++r)
    for (const std::uint32_t lane : lanes) kept.push_back(block.rows[r * row + lane]);
  kept.resize(kept.size() + kLanePadding, 0.0f);
  return kept;
}

/// The block without the lanes of joints that have no new number; without lanes where none has.
TrackBlock keep_lanes(const TrackBlock& block, std::span<const std::uint32_t> numbers, std::size_t key_count) {
  std::vector<std::uint32_t> lanes, targets;
  for (std::uint32_t lane = 0; lane < block.lane_count; ++lane) {
    if (numbers[block.targets[lane]] == kNone) continue;
    lanes.push_back(lane);
    targets.push_back(numbers[block.targets[lane]]);
  }
  TrackBlock kept = block_of(block.property, block.interpolation, lanes.size());
  if (lanes.empty()) return kept;
  kept.places = JointPlaces(targets);
  kept.targets = std::move(targets);
  if (block.packed.empty()) {
    kept.rows = keep_rows(block, lanes);
    return kept;
  }
  std::vector<PackedTrack> tracks;
  for (const std::uint32_t lane : lanes) tracks.push_back(packed_lane(block.packed, block.lane_count, lane, key_count));
  kept.packed = packed_rows(tracks, key_count);
  kept.packed.power = block.packed.power;  // so that poses keep their bits
  return kept;
}

BasePose keep_pose(const BasePose& pose, std::span<const std::uint32_t> joints) {
  BasePose kept(std::vector<Transform>(joints.size()));
  for (std::size_t k = 0; k < joints.size(); ++k)
    for (std::size_t plane = 0; plane * pose.stride < pose.planes.size(); ++plane)
      kept.set(plane, k, {pose.planes[plane * pose.stride + joints[k]]});
  return kept;
}

}  // namespace

Skeleton keep_joints(const Skeleton& skeleton, std::span<const std::uint32_t> joints) {
  const std::vector<std::uint32_t> numbers = new_numbers(skeleton.joint_count(), joints);
  Skeleton kept;
  kept.fixed_matrices = skeleton.fixed_matrices;
  for (const std::uint32_t joint : joints) {
    const std::uint32_t parent = skeleton.parents[joint];
    CONTRACT(parent == kNone || numbers[parent] != kNone);
    kept.parents.push_back(parent == kNone ? kNone : numbers[parent]);
    kept.rest.push_back(skeleton.rest[joint]);
    kept.fixed_matrix_of.push_back(skeleton.fixed_matrix_of[joint]);
  }
  for (const std::uint32_t begin : skeleton.level_begin) {
    const auto at = static_cast<std::uint32_t>(std::lower_bound(joints.begin(), joints.end(), begin) - joints.begin());
    if (kept.level_begin.empty() || kept.level_begin.back() != at) kept.level_begin.push_back(at);
  }
  return kept;
}

Clip keep_joints(const Clip& clip, std::span<const std::uint32_t> joints) {
  const ClipLayout& whole = clip.layout();
  const std::vector<std::uint32_t> numbers = new_numbers(whole.joint_count, joints);
  ClipLayout kept;
  kept.name = whole.name;
  kept.duration_s = whole.duration_s;
  kept.certificate = whole.certificate;
  kept.joint_count = joints.size();
  kept.base_pose = keep_pose(whole.base_pose, joints);
  kept.base_weights = whole.base_weights;
  kept.base_properties = whole.base_properties;
  kept.counts.folded = whole.counts.folded;
  for (const TimeGroup& group : whole.groups) {
    TimeGroup left{group.times, {}};
    for (const TrackBlock& block : group.blocks) {
      TrackBlock lanes = is_of_joints(block) ? keep_lanes(block, numbers, group.times.key_count()) : block;
      if (lanes.lane_count == 0) continue;
      count_tracks(lanes, kept.counts);
      left.blocks.push_back(std::move(lanes));
    }
    if (!left.blocks.empty()) kept.groups.push_back(std::move(left));
  }
  kept.counts.time_groups = static_cast<std::uint32_t>(kept.groups.size());
  return clip_of(std::move(kept));
}

}  // namespace sinew
