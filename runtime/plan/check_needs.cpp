// SPDX-License-Identifier: MIT
#include "runtime/plan/check_needs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace sinew {
namespace {

constexpr std::uint32_t kMostEntries = std::numeric_limits<std::uint16_t>::max();  // that PoseOp::index can count

bool is_usable(const PoseProgramRoom& room) noexcept {
  return room.ops <= kMostPoseOps && room.slots <= room.ops && room.kept <= room.ops && room.masks <= PoseOp::kNoMask &&
         room.externals <= kMostEntries && room.overrides <= kMostEntries && room.procedures <= kMostEntries;
}

Refusal check_masks(std::span<const std::vector<float>> masks, std::size_t joint_count) noexcept {
  if (masks.size() > PoseOp::kNoMask)
    return {.error = ErrorCode::unsupported, .field = "in.masks", .rule = "more masks than layers can name"};
  for (const std::vector<float>& mask : masks) {
    if (mask.size() != joint_count)
      return {.error = ErrorCode::size_mismatch, .field = "in.masks", .rule = "not one weight for each joint"};
    if (!std::all_of(mask.begin(), mask.end(), [](float w) { return std::isfinite(w) && w >= 0.0f; }))
      return {.error = ErrorCode::not_finite, .field = "in.masks", .rule = "a weight is not finite, or below 0"};
  }
  return {};
}

/// Rising, so each is named once.
bool are_instances(std::span<const std::uint32_t> named, std::size_t count) noexcept {
  for (std::size_t i = 0; i < named.size(); ++i)
    if (named[i] >= count || (i > 0 && named[i] <= named[i - 1])) return false;
  return true;
}

bool fits(const MirrorMap& map, const Scene& scene) noexcept {
  return map.joints.size() == scene.skeleton.joint_count() &&
         (map.weight_source.empty() || map.weight_source.size() == scene.weight_count());
}

bool fits(const SkeletonLod& lod, std::size_t joint_count) noexcept {
  return (lod.kept.empty() || lod.kept.size() == joint_count) && (lod.held.empty() || lod.held.size() == joint_count);
}

}  // namespace

Refusal find_fault(const Needs& needs, const Scene& scene) noexcept {
  const std::size_t joints = scene.skeleton.joint_count(), instances = scene.instances.size();
  if (needs.in.max_layers == 0)
    return {.error = ErrorCode::unsupported, .field = "in.max_layers", .rule = "frames have at least one layer"};
  if (!is_usable(needs.in.program))
    return {.error = ErrorCode::unsupported, .field = "in.program", .rule = "more room than programs can use"};
  if (const Refusal refusal = check_masks(needs.in.masks, joints); refusal.error != ErrorCode::ok) return refusal;
  if (!are_instances(needs.in.cached_instances, instances))
    return {.error = ErrorCode::index_out_of_range,
            .field = "in.cached_instances",
            .rule = "not rising indices of mesh instances"};
  if (needs.in.mirror != nullptr && !fits(*needs.in.mirror, scene))
    return {.error = ErrorCode::size_mismatch, .field = "in.mirror", .rule = "it is of another scene"};
  if (!fits(needs.out.skeleton_lod, joints))
    return {.error = ErrorCode::size_mismatch, .field = "out.skeleton_lod", .rule = "it is of another scene"};
  if (!needs.skin.per_instance.empty() && needs.skin.per_instance.size() != instances)
    return {.error = ErrorCode::size_mismatch, .field = "skin.per_instance", .rule = "not one for each mesh instance"};
  return {};
}

bool fits(const Clip& clip, const Scene& scene) noexcept {
  return clip.joint_count() == scene.skeleton.joint_count() && clip.weight_count() == scene.weight_count() &&
         clip.property_count() == scene.properties.rest.size();
}

}  // namespace sinew
