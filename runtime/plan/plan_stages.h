// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace sinew {

/// The stages of a frame, in the order in which they run. The order of Plan::stages and of FrameResult::stage_ns.
enum class Stage : std::uint8_t {
  sample,
  mirror,
  blend,
  add,
  pose_program,
  interpolate,
  correctives,
  properties,
  local_to_model,
  palette,
  split_palette,
  combinations,
  winding,
  morph,
  skin_linear,
  skin_dual_quaternion,
  skin_center_of_rotation,
  geometry_cache,
  flat_normals,
  bounds
};
inline constexpr std::size_t kStageCount = 20;

/// One stage in a plan: does it run, and why.
struct PlanStage {
  std::string stage;  ///< the name of the Stage: "sample", "blend", "local_to_model", ...
  bool runs = false;
  std::string reason;       ///< one sentence, also where the stage is left out
  std::uint64_t count = 0;  ///< items that the stage touches per frame: tracks, joints, entries or vertices
  std::uint64_t bytes = 0;  ///< bytes of frame memory that the stage writes
};

}  // namespace sinew
