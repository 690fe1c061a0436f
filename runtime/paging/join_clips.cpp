// SPDX-License-Identifier: MIT
#include "runtime/paging/join_clips.h"

#include <algorithm>
#include <utility>

#include "runtime/base/same_bits.h"
#include "runtime/clip/move_lanes.h"

namespace sinew {
namespace {

/// The same numbers of a row stand for the same values.
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

/// Numbers that a sample starts from, without those that tracks write: a clip that was loaded has others there.
struct RestingNumbers {
  std::vector<float> pose, weights, properties;

  explicit RestingNumbers(const ClipLayout& clip)
      : pose(clip.base_pose.all()), weights(clip.base_weights.all()), properties(clip.base_properties.all()) {
    for (const TimeGroup& group : clip.groups)
      for (const TrackBlock& block : group.blocks) clear(block, clip.joint_count);
  }
  friend bool operator==(const RestingNumbers& a, const RestingNumbers& b) noexcept {
    return same_bits<float>(a.pose, b.pose) && same_bits<float>(a.weights, b.weights) &&
           same_bits<float>(a.properties, b.properties);
  }

 private:
  void clear(const TrackBlock& block, std::size_t joint_count) {
    const std::size_t stride = BasePose::stride_for(joint_count), planes = block.property == Property::rotation ? 4 : 3;
    for (const std::uint32_t target : block.targets) {
      if (block.property == Property::weight) weights[target] = 0.0f;
      if (block.property == Property::number) properties[target] = 0.0f;
      for (std::size_t p = 0; p < planes && is_of_joints(block); ++p)
        pose[(first_plane(block.property) + p) * stride + target] = 0.0f;
    }
  }
};

/// Parts meet on a key, or between two keys: both have them.
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
         RestingNumbers(x) == RestingNumbers(y);
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
      keys_[g][b].drop_last(group.blocks[b], shared);  // a last key does not know how far it is to the next one
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
