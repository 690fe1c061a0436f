// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/animation/bone_animation.h"
#include "runtime/animation/mirror_map.h"
#include "runtime/base/api.h"

namespace sinew {

/// The mirrored animation: tracks move to the partners of their joints, and each key is mirrored by itself. Nothing is
/// resampled: mirroring is linear (mirror_map.h), and every kind of interpolation commutes with it. So the result at
/// any time is the mirrored pose of that time, within rounding. Cubic tangents are mirrored without the offset.
/// Mirroring twice restores the bits of joints whose map only copies and negates numbers.
///
/// Morph weights move to the partners in `map.weight_source`. A track of several targets is split into one track per
/// target if the partners are not all in that track. Properties do not change. If the reference pose is not the rest
/// pose, mirroring may move joints at rest. Joints without a track then get a constant track. Events and
/// curves take the names of their partners where those exist (name_partners, side_names.h): a step of the left foot
/// becomes one of the right foot. For root motion, use the mirrored tracks (playback/root_motion.h).
/// in   animation     passed check();   map  of the same skeleton
///      first_weight  Scene::first_weight; empty = morph weights do not change
/// cost O(keys + J), allocates
SINEW_API Animation mirror_animation(const Animation& animation, const MirrorMap& map, const Skeleton& skeleton,
                                     std::span<const std::uint32_t> first_weight = {});

/// Mirrors a local transform of joint `map.joints[joint].source`; the result is the local transform of `joint`.
SINEW_API Transform mirrored_transform(const MirrorMap& map, std::uint32_t joint, const Transform& source) noexcept;

/// True if the mirrored rest transform of a joint differs from its rest transform by more than rounding. This happens
/// only if the reference pose is not the rest pose.
SINEW_API bool is_moved_at_rest(const MirrorMap& map, const Skeleton& skeleton, std::uint32_t joint) noexcept;

}  // namespace sinew
