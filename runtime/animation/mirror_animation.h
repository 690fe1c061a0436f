// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/animation/bone_animation.h"
#include "runtime/animation/mirror_map.h"

namespace sinew {

/// The animation of the other side: tracks go to the partners of their joints, and each key is mirrored by itself.
/// Nothing is resampled, since every kind of interpolation commutes with the linear maps of a mirror (mirror_map.h):
/// the mirrored animation at any time is the mirrored pose of that time, but for rounding. Cubic tangents are mirrored
/// without the offset. Mirrored twice, keys of joints that copy and negate numbers come back bit for bit.
///
/// Morph weights go to the partners that `map.weight_source` names; a track of some targets whose partners are not
/// among them becomes one track a target. Properties stay. Where the reference pose is not the rest pose, joints
/// without a track get a constant where they would else rest on the wrong side. Events are the caller's: they keep
/// their times, and name_partners (side_names.h) says which event each one becomes. Root motion follows from the
/// mirrored tracks (playback/root_motion.h).
/// in   animation     checked;   map  of the same skeleton
///      first_weight  Scene::first_weight; empty = morph weights stay
/// cost O(keys + J), allocates
Animation mirror_animation(const Animation& animation, const MirrorMap& map, const Skeleton& skeleton,
                           std::span<const std::uint32_t> first_weight = {});

/// One local transform of joint `map.joints[joint].source`, mirrored to `joint`.
Transform mirrored_transform(const MirrorMap& map, std::uint32_t joint, const Transform& source) noexcept;

/// Whether the mirrored rest pose of a joint is another than its rest pose, beyond rounding: only where the reference
/// pose is not the rest pose.
bool is_moved_at_rest(const MirrorMap& map, const Skeleton& skeleton, std::uint32_t joint) noexcept;

}  // namespace sinew
