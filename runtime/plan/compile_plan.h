// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/assets/scene.h"
#include "runtime/plan/needs.h"

namespace sinew {

/// One stage of the evaluation, run or left out, with the reason in words a person understands.
struct PlanStage {
  std::string stage;        ///< "sample", "blend", "local_to_model", "palette", "split_palette", "morph", "skin_linear", ...
  bool runs = false;
  std::string reason;
  std::uint64_t count = 0;  ///< what the stage touches per frame: tracks, joints, entries, vertices
  std::uint64_t bytes = 0;  ///< of frame memory that it writes
};

/// What a primitive of a mesh instance goes through.
struct PrimitivePlan {
  std::uint32_t instance = 0, primitive = 0;
  bool morph = false, skin = false;
  bool normals = false, tangents = false;        ///< deformed as well
  std::size_t positions_at = 0, normals_at = 0, tangents_at = 0, colors_at = 0;   ///< byte offsets into the frame memory
  std::size_t morphed_positions_at = 0, morphed_normals_at = 0, morphed_tangents_at = 0;  ///< between morph and skin
};

/// The evaluation of one scene for given needs: which stages run, and where in one block of frame memory each of them
/// writes. Immutable; shared by all characters that show the scene. Keeps a pointer to the scene, which must outlive it.
struct Plan {
  const Scene* scene = nullptr;
  Needs needs;
  std::vector<PlanStage> stages;
  std::vector<PrimitivePlan> primitives;       ///< one per primitive of each mesh instance
  std::vector<std::uint32_t> first_primitive;  ///< [instances + 1] into `primitives`
  bool sample = false, local_to_model = false;
  std::vector<bool> skin_used;                 ///< [skins]
  std::size_t pose_at = 0, layer_pose_at = 0, weights_at = 0, layer_weights_at = 0, model_at = 0, scratch_at = 0;
  std::vector<std::size_t> palette_at, split_at;   ///< [skins]
  std::size_t frame_bytes = 0;                 ///< size of the block, 64-byte aligned
};

/// cost O(size of the scene), allocates the plan
Plan compile_plan(const Scene& scene, const Needs& needs);

}  // namespace sinew
