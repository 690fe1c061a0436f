// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/deform/vertex_streams.h"
#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/evaluate/frame_work.h"
#include "runtime/plan/frame_memory.h"
#include "runtime/plan/frame_result.h"

namespace sinew {

/// All that the vertices of a mesh instance follow, beside its palette.
struct InstancePose {
  std::span<const float> weights;  ///< [T]
  bool mirrored = false;           ///< as in InstanceResult
  bool uneven_root = false;        ///< FrameInput::root scales unevenly
  bool past_caches = false;        ///< no stage but those of deform_primitive reads its vertices
};

/// Stages morph, skin and flat normals for one primitive of one mesh instance.
/// in   p         index into CompiledPlan::primitives
///      flattens  false: flat normals are left out, since positions go on to change
/// out  views of the frame's memory, or of the primitive's own arrays where a planned attribute rests in this frame;
///      positions are there whenever some stage needs them
/// cost O(V * influences + active deltas), no allocation. Internal to plan/
DeformedPrimitive deform_primitive(const CompiledPlan& plan, std::size_t p, const InstancePose& pose, bool flattens,
                                   FrameMemory memory, FrameWork& work) noexcept;

/// Stage flat normals of a primitive that has them.
/// in   turned  faces wind around the inside
/// out  view of the frame's memory
std::span<const glm::vec3> flatten_primitive(const CompiledPlan& plan, std::size_t p,
                                             std::span<const glm::vec3> positions, bool turned, FrameMemory memory,
                                             FrameWork& work) noexcept;

/// The first `count` vertices of the blocks, of the attributes in `set`.
VertexOutput output_in(FrameMemory memory, const AttributeSet& set, const VertexBlocks& blocks,
                       std::size_t count) noexcept;

}  // namespace sinew
