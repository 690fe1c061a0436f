// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/clip/clip_rest.h"

namespace sinew {

/// The keys of a clip in authoring form. Needed for data derived from keys (root motion, bounds, LODs) if the original
/// animation is not available. If these keys are compiled again, the clip samples the same bits as `unpacked(clip)`.
/// Keys that an error budget removed stay removed; constant tracks have one key.
/// in    rest, first_weight, properties  of a scene with the joint, weight and property counts of the clip
/// err   unsupported: a block of tracks moves only some components of a property, or weights of two instances;
///       compile_clip never makes such blocks
/// cost  O(keys + joints), allocates decompiled_bytes(clip)
SINEW_API Result<Animation> decompile_clip(const Clip& clip, const ClipRest& rest,
                                           std::span<const std::uint32_t> first_weight,
                                           const PropertyTable& properties);

/// The keys of one joint, for example for root motion (playback/root_motion.h) of a clip without its original
/// animation. A property that no track animates has one key, with its constant value in the clip.
/// in    joint  < clip.joint_count()
/// cost  O(blocks + keys of the joint), allocates them
SINEW_API BoneAnimation decompile_joint(const Clip& clip, std::uint32_t joint);

/// Bytes that the result of decompile_clip takes.      cost O(blocks)
SINEW_API std::uint64_t decompiled_bytes(const Clip& clip) noexcept;

}  // namespace sinew
