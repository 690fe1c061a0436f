// SPDX-License-Identifier: MIT
#include "runtime/clip/keep_joints.h"

#include <algorithm>
#include <map>
#include <utility>

#include "runtime/base/contract.h"
#include "runtime/clip/move_lanes.h"

namespace sinew {
namespace {

/// The new index of each joint; kNone for joints that are not kept.
std::vector<std::uint32_t> new_numbers(std::size_t joint_count, std::span<const std::uint32_t> joints) {
  std::vector<std::uint32_t> numbers(joint_count, kNone);
  for (std::size_t k = 0; k < joints.size(); ++k) numbers[joints[k]] = static_cast<std::uint32_t>(k);
  return numbers;
}

/// Makes base poses of the kept joints. Clips that shared rest values share the new ones.
class KeptPoses {
 public:
  KeptPoses(std::span<const std::uint32_t> joints, std::span<const std::uint32_t> numbers)
      : joints_(joints), numbers_(numbers), stride_(BasePose::stride_for(joints.size())) {}

  BaseNumbers of(const BaseNumbers& base) {
    const std::size_t whole = BasePose::stride_for(numbers_.size());
    std::vector<BaseNumbers::Override> overrides;
    for (const BaseNumbers::Override& number : base.overrides())
      if (const std::uint32_t joint = numbers_[number.at % whole]; joint != kNone)
        overrides.push_back({static_cast<std::uint32_t>(number.at / whole * stride_ + joint), number.value});
    RestNumbers& rest = known_[base.rest()];
    if (rest == nullptr) rest = rest_numbers(kept(base.rest(), whole));
    return BaseNumbers(rest, std::move(overrides));
  }

 private:
  std::vector<float> kept(const RestNumbers& rest, std::size_t whole) const {
    BasePose pose(std::vector<Transform>(joints_.size()));
    if (whole == 0) return pose.planes;
    for (std::size_t k = 0; k < joints_.size(); ++k)
      for (std::size_t plane = 0; plane * whole < rest->size(); ++plane)
        pose.set(plane, k, {(*rest)[plane * whole + joints_[k]]});
    return pose.planes;
  }

  std::span<const std::uint32_t> joints_, numbers_;
  std::size_t stride_;
  std::map<RestNumbers, RestNumbers> known_;  ///< key: rest values of all joints; value: those of the kept joints
};

Clip keep_tracks(const ClipLayout& whole, std::span<const std::uint32_t> numbers, std::size_t joint_count,
                 KeptPoses& poses) {
  ClipLayout kept;
  kept.name = whole.name;
  kept.duration_s = whole.duration_s;
  kept.certificate = whole.certificate;
  kept.annotations = whole.annotations;
  kept.joint_count = joint_count;
  kept.base_pose = poses.of(whole.base_pose);
  kept.base_weights = whole.base_weights;
  kept.base_properties = whole.base_properties;
  kept.counts.folded = whole.counts.folded;
  for (const TimeGroup& group : whole.groups) {
    TimeGroup left{group.times, {}};
    for (const TrackBlock& block : group.blocks) {
      if (is_of_joints(block))
        add_moved_lanes(block, numbers, group.times.key_count(), left.blocks);
      else
        left.blocks.push_back(block);
    }
    for (const TrackBlock& block : left.blocks) count_tracks(block, kept.counts);
    if (!left.blocks.empty()) kept.groups.push_back(std::move(left));
  }
  kept.counts.time_groups = static_cast<std::uint32_t>(kept.groups.size());
  return clip_of(std::move(kept));
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

std::vector<Clip> keep_joints(std::span<const Clip> clips, std::span<const std::uint32_t> joints) {
  std::vector<Clip> kept;
  if (clips.empty()) return kept;
  const std::size_t joint_count = clips.front().joint_count();
  const std::vector<std::uint32_t> numbers = new_numbers(joint_count, joints);
  KeptPoses poses(joints, numbers);
  for (const Clip& clip : clips) {
    CONTRACT(clip.joint_count() == joint_count);
    kept.push_back(keep_tracks(clip.layout(), numbers, joints.size(), poses));
  }
  return kept;
}

Clip keep_joints(const Clip& clip, std::span<const std::uint32_t> joints) {
  return keep_joints(std::span(&clip, 1), joints).front();
}

}  // namespace sinew
