// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/math/transform.h"
#include "runtime/pose/pose.h"

namespace sinew {

class Clip;
struct Skeleton;

/// Version of content that the caller owns. Equal versions of the same table entry promise equal content. 0 promises
/// nothing: the content may differ in each frame.
using ContentVersion = std::uint64_t;

/// A pose of the caller: a ragdoll, the network, another skeleton's motion. If weights or properties are empty, the
/// rest values are used.
struct ExternalPose {
  PoseSpan pose;                      ///< only read; has as many joints as the plan's poses
  std::span<const float> weights;     ///< [W] or empty
  std::span<const float> properties;  ///< [P] or empty
  ContentVersion version = 0;
};

/// Space of an overriding transform. `model` is the space above all root joints, below FrameInput::root; `world` is the
/// space above that root.
enum class OverrideSpace : std::uint8_t { local, model, world };

/// A joint that the caller places.
struct JointOverride {
  std::uint32_t joint = 0;  ///< index in the plan's poses
  Transform transform;
  OverrideSpace space = OverrideSpace::local;
};

/// Joints that one operation places, in this order: a parent before its children.
struct JointOverrides {
  std::span<const JointOverride> joints;
  ContentVersion version = 0;
};

/// Weights of the caller that multiply the weight of an operation, for each number of a pose. All are finite and >= 0.
/// An empty list stands for ones.
struct PoseMask {
  std::span<const float> joints;      ///< [joints of the plan's poses]
  std::span<const float> weights;     ///< [W] for the morph weights
  std::span<const float> properties;  ///< [P] for the animated properties
  ContentVersion version = 0;
};

/// The pose that a procedure may change. It lies in memory of the frame.
struct ProcedurePose {
  const Skeleton& skeleton;     ///< skeleton of the poses
  PoseSpan local;               ///< may be written
  std::span<float> weights;     ///< [W] may be written; empty if the frame's input gives all morph weights
  std::span<float> properties;  ///< [P] may be written; empty where they are not wanted
  float share = 1.0f;           ///< (0, 1] of the operation; the procedure decides how it applies
};

/// A function of the caller that changes the pose in the middle of a program. It must not throw. Equal versions promise
/// equal output for equal input poses.
struct PoseProcedure {
  void (*run)(void* context, const ProcedurePose& pose) = nullptr;
  void* context = nullptr;
  ContentVersion version = 0;
};

/// Lists of the caller that a program indexes, in addition to the tables that all characters share (PoseProgramAssets).
/// owns  nothing: views of the caller's memory, which stays unchanged while the program runs
struct PoseProgramInputs {
  std::span<const ExternalPose> externals = {};
  std::span<const JointOverrides> overrides = {};
  std::span<const PoseProcedure> procedures = {};
  std::span<const PoseMask> masks = {};  ///< indices continue after the shared masks

  /// [operations] or empty: the part of the operation's clip that holds the keys for its time (paging/paged_clip.h).
  /// Null = the clip itself holds them.
  std::span<const Clip* const> pages = {};
};

}  // namespace sinew
