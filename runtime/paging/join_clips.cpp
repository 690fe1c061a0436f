// SPDX-License-Identifier: MIT
#include "runtime/paging/join_clips.h"

#include <algorithm>
#include <utility>

#include "runtime/base/same_bits.h"
#include "runtime/clip/move_lanes.h"

namespace sinew {
namespace {

/// True if equal bits of a row mean equal values.
bool are_packed_alike(const PackedRows& a, const PackedRows& b) noexcept {
  return a.row_bytes == b.row_bytes && a.mask == b.mask && a.step == b.step && same_bits<float>(a.low, b.low) &&
         a.derived == b.derived;
}

bool are_alike(const TrackBlock& a, const TrackBlock& b) noexcept {
  return a.property == b.property && a.interpolation == b.interpolation && a.targets == b.targets &&
         are_packed_alike(a.packed, b.packed);
}

bool are_alike(const TimeGroup& a, const TimeGroup& b) noexcept {
  return std::equal(a.blocks.begin(), a.blocks.end(), b.blocks.begin(), b.blocks.end(),
                    [](const TrackBlock& p, const TrackBlock& q) { return are_alike(p, q); });
}

/// The base pose, with 0 for animated values. These values are unused, and differ between a loaded and a compiled clip.
std::vector<float> resting_pose(const ClipLayout& clip) {
  std::vector<float> pose = clip.base_pose.all();
  const std::size_t stride = BasePose::stride_for(clip.joint_count);
  for (const TimeGroup& group : clip.groups)
    for (const TrackBlock& block : group.blocks) {
      if (!is_of_joints(block)) continue;
      const std::size_t first = first_plane(block.property), count = block.property == Property::rotation ? 4 : 3;
      for (const std::uint32_t joint : block.targets)
        for (std::size_t plane = first; plane < first + count; ++plane) pose[plane * stride + joint] = 0.0f;
    }
  return pose;
}

bool are_alike(const BaseNumbers& a, const BaseNumbers& b) { return same_bits<float>(a.all(), b.all()); }

/// The number of keys, 0 to 2, that the next part repeats. Parts that meet on a key share it; parts that meet between
/// two keys share both.
std::size_t shared_keys(std::span<const float> before, std::span<const float> after) noexcept {
  for (std::size_t count = std::min({before.size(), after.size(), std::size_t{2}}); count > 0; --count)
    if (same_bits<float>(before.last(count), after.first(count))) return count;
  return 0;
}

}  // namespace

bool moves_alike(const Clip& a, const Clip& b) {
  const ClipLayout &x = a.layout(), &y = b.layout();
  return x.joint_count == y.joint_count &&
         std::equal(x.groups.begin(), x.groups.end(), y.groups.begin(), y.groups.end(),
                    [](const TimeGroup& p, const TimeGroup& q) { return are_alike(p, q); }) &&
         same_bits<float>(resting_pose(x), resting_pose(y)) && are_alike(x.base_weights, y.base_weights) &&
         are_alike(x.base_properties, y.base_properties);
}

ClipJoiner::ClipJoiner(const Clip& head) : head_(head), times_s_(head.layout().groups.size()) {
  for (const TimeGroup& group : head.layout().groups) keys_.emplace_back(group.blocks.size());
}

bool ClipJoiner::add(const Clip& part) {
  if (!moves_alike(head_, part)) return false;
  for (std::size_t g = 0; g < keys_.size(); ++g) {
    const TimeGroup& group = part.layout().groups[g];
    const std::span<const float> added = group.times.times_s();
    const std::size_t shared = shared_keys(times_s_[g], added);
    if (shared == 0 && !times_s_[g].empty()) return false;
    times_s_[g].resize(times_s_[g].size() - shared);
    add_slice(added, 0, added.size(), times_s_[g]);
    for (std::size_t b = 0; b < keys_[g].size(); ++b) {
      keys_[g][b].drop_last(group.blocks[b], shared);  // the last key of a part lacks the arc to the next key
      keys_[g][b].add(group.blocks[b], {0, added.size()});
    }
  }
  return true;
}

Clip ClipJoiner::clip() {
  ClipLayout joined = head_.layout();
  for (std::size_t g = 0; g < keys_.size(); ++g) {
    TimeGroup& group = joined.groups[g];
    for (std::size_t b = 0; b < group.blocks.size(); ++b) keys_[g][b].move_to(group.blocks[b]);
    group.times = KeyTimes(std::move(times_s_[g]));
  }
  return clip_of(std::move(joined));
}

}  // namespace sinew
