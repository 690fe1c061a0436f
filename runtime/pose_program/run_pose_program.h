// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/clip/clip.h"
#include "runtime/clip/clip_tracks.h"
#include "runtime/math/affine.h"
#include "runtime/pose/mirror_pose.h"
#include "runtime/pose/pose.h"
#include "runtime/pose_program/pose_program.h"
#include "runtime/pose_program/pose_work.h"
#include "runtime/pose_program/program_inputs.h"

namespace sinew {

/// The tables that programs of one skeleton read. All characters of this skeleton share them. Immutable while frames
/// run.
struct PoseProgramAssets {
  const Skeleton* skeleton = nullptr;
  std::span<const Clip> clips;
  PoseSpan rest;                                               ///< the skeleton's rest pose
  std::span<const float> rest_weights;                         ///< [W]
  std::span<const float> rest_properties;                      ///< [P]
  std::span<const std::span<const float>> masks;               ///< [any][J] joint weights, finite and >= 0
  const MirrorTables* mirror = nullptr;                        ///< null: nothing is mirrored
  std::span<const std::uint32_t> mirrored_weight_source = {};  ///< [W] MirrorMap::weight_source; empty = weights stay
  std::span<const ClipTracks> clip_tracks = {};                ///< [clips] or empty; only to count work
};

/// Kinds of work whose time is measured.
enum class PosePhase : std::uint8_t {
  sample,
  external,
  mirror,
  blend,
  overlay,
  add,
  override_joints,
  procedure,
  transition
};

/// Callback at the end of each piece of work. The receiver charges the time since its last call to `phase`.
struct PosePhaseClock {
  void (*ended)(void* context, PosePhase phase) noexcept = nullptr;
  void* context = nullptr;
};

/// Bytes of memory that PoseProgramJob needs, a multiple of 64.
/// in   room  of the largest program; only `slots`, `kept` and `overlays_in_model_space` are used
SINEW_API std::size_t pose_program_bytes(const PoseProgramAssets& assets, const PoseProgramRoom& room) noexcept;

/// Runs a program: one pose remains, with its morph weights and properties.
/// eq   mean      t = (sum w t + r rest) / (sum w + r), r = max(0, threshold - sum w), w with the joint's masks;
///                rotations and scales as in BlendPosesJob
///      overlay   (1 - w) below + w above, w = min(1, weight * mask). At w = 1 the bits of the upper pose
///      overlay_model   rotations: G = slerp(G_below, G_above, w) along the short arc, where G are rotations in model
///                space; then q = conj(G_parent) G with the parent's new G. Translations and scales as overlay.
///      add       AddPoseJob;   override_joints   mix of the pose's local transform and the given one, brought to the
///                parent's space
///      inertialize, dead_blend   InertializeJob, DeadBlendJob; a job evaluates their operands each time
///      Morph weights and properties follow the same rules, with the masks that are given for them; additions leave
///      properties as they are.
/// in   memory     64-byte aligned, pose_program_bytes
///      first, end  the operations to run in this call. With first > 0, memory and output hold the state after
///      operation first - 1. A caller may thus look at the pose between two calls, and change it.
///      holds_clip  the output already holds a sample of the clip that the first operation samples. Joints that the
///      clip does not animate are then not written again.
/// out  pose, weights[W], properties[P]    must not overlap the inputs; empty weights or properties are not wanted
/// err  of find_fault; size_mismatch (memory, poses, tables), not_finite (an override's transform, a mask),
///      negative_weight (in a mask)
/// cost the sum of the operations, no allocation. The same program and input give the same bits.
struct PoseProgramJob {
  PoseProgramSpan program;
  const PoseProgramAssets* assets = nullptr;
  PoseProgramInputs inputs = {};
  std::span<std::byte> memory;
  PoseSpan pose;
  std::span<float> weights = {};
  std::span<float> properties = {};
  PoseProgramWork* work = nullptr;  ///< null or counters, to which the run adds
  PosePhaseClock clock = {};
  std::size_t first = 0, end = kMostPoseOps;
  bool holds_clip = false;
  Affine root = {};  ///< world transform above all root joints, for OverrideSpace::world
};

SINEW_API ErrorCode check(const PoseProgramJob& job) noexcept;
SINEW_API void run_unchecked(const PoseProgramJob& job) noexcept;

/// The first rule that a program's inputs break, and the list entry that breaks it.
struct PoseInputFault {
  ErrorCode code = ErrorCode::ok;
  const char* list = "";    ///< name of a list of PoseProgramInputs
  std::uint32_t index = 0;  ///< into the list
  const char* rule = "";    ///< in words
};

/// Checks the rules for inputs that hold for every program: sizes, joint indices, finite numbers.
/// in   joint_count  of the poses;   weight_count, property_count  sizes of the rest tables
/// err  size_mismatch, index_out_of_range, not_finite, negative_weight, unsupported (a procedure without code)
/// cost O(joints of external poses, overrides and masks), no allocation
SINEW_API PoseInputFault find_fault(const PoseProgramInputs& inputs, std::size_t joint_count, std::size_t weight_count,
                                    std::size_t property_count) noexcept;

}  // namespace sinew
