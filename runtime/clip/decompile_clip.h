// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/base/result.h"
#include "runtime/clip/clip_rest.h"

namespace sinew {

/// The keys of a clip in authoring form, for what is derived from keys (root motion, bounds, LODs) where the truth that
/// the clip was compiled from is not at hand. compile_clip makes of it a clip that samples the bits of
/// `unpacked(clip)`. Keys that a budget removed stay removed; tracks that were constant have one key.
/// in    rest, first_weight, properties  of a scene of the clip's size
/// err   unsupported: a block moves a part of a property, or weights of two instances (compile_clip makes none)
/// cost  O(keys + joints), allocates decompiled_bytes(clip)
Result<Animation> decompile_clip(const Clip& clip, const ClipRest& rest, std::span<const std::uint32_t> first_weight,
                                 const PropertyTable& properties);

/// The keys of one joint, for what follows from them alone: the root motion of a clip that came without its source,
/// such as one of a library (playback/root_motion.h). What no track animates has one key, where the clip holds the
/// joint.
/// in    joint  of the clip
/// cost  O(blocks + keys of the joint), allocates them
BoneAnimation decompile_joint(const Clip& clip, std::uint32_t joint);

/// Bytes that the keys of decompile_clip take.      cost O(blocks)
std::uint64_t decompiled_bytes(const Clip& clip) noexcept;

}  // namespace sinew
