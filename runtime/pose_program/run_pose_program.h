// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/clip/clip.h"
#include "runtime/pose/mirror_pose.h"
#include "runtime/pose/pose.h"
#include "runtime/pose_program/pose_program.h"

namespace sinew {

/// A pose of the caller. Weights and properties may be empty: then the rest values stand in.
struct ExternalPose {
  PoseSpan pose;                      ///< of the skeleton's joint count
  std::span<const float> weights;     ///< [W] or empty
  std::span<const float> properties;  ///< [P] or empty
};

/// Space of an overriding transform. World is model space above FrameInput::root: the caller takes the root out.
enum class OverrideSpace : std::uint8_t { local, model };

/// A joint that the caller places.
struct JointOverride {
  std::uint32_t joint = 0;
  Transform transform;
  OverrideSpace space = OverrideSpace::local;
};

/// The tables that programs of one skeleton read. All its characters share them. Immutable while frames run.
struct PoseProgramAssets {
  const Skeleton* skeleton = nullptr;
  std::span<const Clip> clips;
  PoseSpan rest;                                               ///< the skeleton's rest pose
  std::span<const float> rest_weights;                         ///< [W]
  std::span<const float> rest_properties;                      ///< [P]
  std::span<const std::span<const float>> masks;               ///< [any][J] joint weights, finite and >= 0
  const MirrorTables* mirror = nullptr;                        ///< null: nothing is mirrored
  std::span<const std::uint32_t> mirrored_weight_source = {};  ///< [W] MirrorMap::weight_source; empty = weights stay
};

/// Work of one run. An operation that the program does not contain counts zero.
struct PoseProgramWork {
  std::uint32_t clips_sampled = 0, poses_mirrored = 0, poses_blended = 0, poses_overlaid = 0, poses_added = 0,
                joints_overridden = 0;
};

/// Bytes that run(PoseProgramJob) needs as memory, a multiple of 64.
/// in   slots  pose_slots of the largest program
SINEW_API std::size_t pose_program_bytes(const PoseProgramAssets& assets, std::size_t slots) noexcept;

/// Runs a program: one pose remains, with its morph weights and properties.
/// eq   mean      t = (sum w t + r rest) / (sum w + r), r = max(0, threshold - sum w), per joint by its masks; rotations
///                and scales as in BlendPosesJob
///      overlay   x = mean of (1 - w) below and w above, w = min(1, weight * mask): at w = 1 the bits of the upper pose
///      overlay_model   rotations: G = slerp(G_below, G_above, w) along the short arc, where G are rotations in model
///                space; then q = conj(G_parent) G with the parent's new G. Translations and scales as overlay.
///      add       AddPoseJob;   override_joints   mix of the pose's local transform and the given one, brought to the
///                parent's space
///      Morph weights and properties follow the same rules without masks; additions leave properties as they are.
/// in   memory     64-byte aligned, pose_program_bytes;   pages  [ops] or empty: the part of the op's clip that has the keys
///      of its time (paging/paged_clip.h), null = the clip itself
/// out  pose, weights[W], properties[P]    must not overlap the inputs
/// err  of find_fault; size_mismatch (memory, poses, tables), not_finite (an override's transform)
/// cost of the operations; no allocation. The same program and input give the same bits.
struct PoseProgramJob {
  PoseProgramSpan program;
  const PoseProgramAssets* assets = nullptr;
  std::span<const ExternalPose> externals = {};
  std::span<const std::span<const JointOverride>> overrides = {};
  std::span<const Clip* const> pages = {};
  std::span<std::byte> memory;
  PoseSpan pose;
  std::span<float> weights = {};
  std::span<float> properties = {};
  PoseProgramWork* work = nullptr;  ///< added to, where the caller counts
};

SINEW_API ErrorCode check(const PoseProgramJob& job) noexcept;
SINEW_API void run_unchecked(const PoseProgramJob& job) noexcept;

}  // namespace sinew
