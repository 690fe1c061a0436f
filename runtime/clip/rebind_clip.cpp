// SPDX-License-Identifier: MIT
#include "runtime/clip/rebind_clip.h"

#include <algorithm>
#include <span>
#include <utility>

#include "runtime/base/contract.h"
#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/clip/move_lanes.h"

namespace sinew {
namespace {

using Overrides = std::vector<BaseNumbers::Override>;

constexpr Property kJointProperties[] = {Property::translation, Property::rotation, Property::scale};

constexpr std::size_t component_count(Property property) noexcept { return property == Property::rotation ? 4 : 3; }

/// Calls `visit(joint, property)` where the base value differs from the rest value.
template <class Visit>
void each_constant(std::span<const float> base, std::span<const float> rest, std::size_t joint_count,
                   const Visit& visit) {
  const std::size_t stride = BasePose::stride_for(joint_count);
  for (const Property property : kJointProperties)
    for (std::uint32_t joint = 0; joint < joint_count; ++joint)
      for (std::size_t c = 0; c < component_count(property); ++c) {
        const std::size_t at = (first_plane(property) + c) * stride + joint;
        if (same_bits(base[at], rest[at])) continue;
        visit(joint, property);
        break;
      }
}

bool is_identity(std::span<const std::uint32_t> targets, std::size_t count) noexcept {
  if (targets.size() != count) return false;
  for (std::uint32_t i = 0; i < count; ++i)
    if (targets[i] != i) return false;
  return true;
}

bool is_same(const RestNumbers& a, const RestNumbers& b) { return a == b || same_bits<float>(*a, *b); }

std::span<const std::uint32_t> targets_of(Property property, const ClipTargets& targets) noexcept {
  if (property == Property::weight) return targets.weights;
  return property == Property::number ? targets.numbers : targets.joints;
}

BaseNumbers moved_pose(const Clip& clip, const ClipRest& from, std::span<const std::uint32_t> targets,
                       const ClipRest& to, std::uint32_t& folded) {
  const std::vector<float> base = clip.layout().base_pose.all();
  const std::size_t stride = BasePose::stride_for(from.joint_count), new_stride = BasePose::stride_for(to.joint_count);
  Overrides overrides;
  each_constant(base, *from.pose, from.joint_count, [&](std::uint32_t joint, Property property) {
    if (targets[joint] == kNone) return;
    const std::size_t first = first_plane(property);
    for (std::size_t plane = first; plane < first + component_count(property); ++plane)
      overrides.push_back(
          {static_cast<std::uint32_t>(plane * new_stride + targets[joint]), base[plane * stride + joint]});
    ++folded;
  });
  return BaseNumbers(to.pose, std::move(overrides));
}

BaseNumbers moved_numbers(const BaseNumbers& base, const RestNumbers& from, std::span<const std::uint32_t> targets,
                          const RestNumbers& to, std::uint32_t& folded) {
  const std::vector<float> numbers = base.all();
  Overrides overrides;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (targets[i] != kNone && !same_bits(numbers[i], (*from)[i])) overrides.push_back({targets[i], numbers[i]});
  folded += static_cast<std::uint32_t>(overrides.size());
  return BaseNumbers(to, std::move(overrides));
}

/// If no target changes, the block is copied with its tables.
void add_block(const TrackBlock& block, const ClipTargets& targets, std::size_t key_count,
               std::vector<TrackBlock>& out) {
  const std::span<const std::uint32_t> new_target = targets_of(block.property, targets);
  const bool stays = std::all_of(block.targets.begin(), block.targets.end(),
                                 [&](std::uint32_t target) { return new_target[target] == target; });
  if (stays)
    out.push_back(block);
  else
    add_moved_lanes(block, new_target, key_count, out);
}

void require_shape(const Clip& clip, const ClipRest& from, const ClipTargets& targets) {
  CONTRACT(clip.joint_count() == from.joint_count && targets.joints.size() == from.joint_count);
  CONTRACT(clip.weight_count() == from.weights->size() && targets.weights.size() == from.weights->size());
  CONTRACT(clip.property_count() == from.properties->size() && targets.numbers.size() == from.properties->size());
}

}  // namespace

ClipMotion motion_of(const Clip& clip, const ClipRest& rest) {
  const ClipLayout& layout = clip.layout();
  ClipMotion motion{std::vector<bool>(clip.joint_count()), std::vector<bool>(clip.weight_count()),
                    std::vector<bool>(clip.property_count())};
  each_constant(layout.base_pose.all(), *rest.pose, rest.joint_count,
                [&](std::uint32_t joint, Property) { motion.joints[joint] = true; });
  for (std::size_t i = 0; i < motion.weights.size(); ++i)
    motion.weights[i] = !same_bits(layout.base_weights[i], (*rest.weights)[i]);
  for (std::size_t i = 0; i < motion.numbers.size(); ++i)
    motion.numbers[i] = !same_bits(layout.base_properties[i], (*rest.properties)[i]);
  for (const TimeGroup& group : layout.groups)
    for (const TrackBlock& block : group.blocks) {
      std::vector<bool>& moved = is_of_joints(block)                  ? motion.joints
                                 : block.property == Property::weight ? motion.weights
                                                                      : motion.numbers;
      for (const std::uint32_t target : block.targets) moved[target] = true;
    }
  return motion;
}

Clip rebind_clip(const Clip& clip, const ClipRest& from, const ClipTargets& targets, const ClipRest& to) {
  require_shape(clip, from, targets);
  const ClipLayout& before = clip.layout();
  const bool same_pose = is_identity(targets.joints, to.joint_count) && is_same(from.pose, to.pose);
  if (same_pose && is_identity(targets.weights, to.weights->size()) && is_same(from.weights, to.weights) &&
      is_identity(targets.numbers, to.properties->size()) && is_same(from.properties, to.properties))
    return clip;

  ClipLayout layout;
  layout.name = before.name;
  layout.duration_s = before.duration_s;
  layout.annotations = before.annotations;
  layout.joint_count = to.joint_count;
  if (same_pose) layout.certificate = before.certificate;
  std::uint32_t& folded = layout.counts.folded;
  layout.base_pose = moved_pose(clip, from, targets.joints, to, folded);
  layout.base_weights = moved_numbers(before.base_weights, from.weights, targets.weights, to.weights, folded);
  layout.base_properties =
      moved_numbers(before.base_properties, from.properties, targets.numbers, to.properties, folded);
  for (const TimeGroup& group : before.groups) {
    TimeGroup moved{group.times, {}};
    for (const TrackBlock& block : group.blocks) add_block(block, targets, group.times.key_count(), moved.blocks);
    for (const TrackBlock& block : moved.blocks) count_tracks(block, layout.counts);
    if (!moved.blocks.empty()) layout.groups.push_back(std::move(moved));
  }
  layout.counts.time_groups = static_cast<std::uint32_t>(layout.groups.size());
  return clip_of(std::move(layout));
}

}  // namespace sinew
