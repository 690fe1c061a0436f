// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/deform/vertex_streams.h"
#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/evaluate/frame_work.h"
#include "runtime/plan/frame_memory.h"
#include "runtime/plan/frame_result.h"

namespace sinew {

/// Inputs of the vertices of a mesh instance, apart from its palette.
struct InstancePose {
  std::span<const float> weights;  ///< [T] morph weights
  bool mirrored = false;           ///< as in InstanceResult
  bool uneven_root = false;        ///< FrameInput::root scales unevenly
  bool past_caches = false;  ///< stores may bypass the caches: only the stages of deform_primitive read the vertices
};

/// Runs the stages morph, skin and flat normals for one primitive of one mesh instance.
/// in   p         index into CompiledPlan::primitives
///      flattens  false: flat normals are left out, since a later stage still changes the positions
/// out  views of the frame's memory, or of the primitive's own arrays where this frame does not move a planned
///      attribute; positions are set whenever some stage needs them
/// cost O(V * influences + active deltas), no allocation. Internal to plan/
DeformedPrimitive deform_primitive(const CompiledPlan& plan, std::size_t p, const InstancePose& pose, bool flattens,
                                   FrameMemory memory, FrameWork& work) noexcept;

/// Runs the stage flat normals for a primitive that has them.
/// in   turned  true: the winding of the triangles is reversed, so normals are negated
/// out  view of the frame's memory
std::span<const glm::vec3> flatten_primitive(const CompiledPlan& plan, std::size_t p,
                                             std::span<const glm::vec3> positions, bool turned, FrameMemory memory,
                                             FrameWork& work) noexcept;

/// Output views of the first `count` vertices in the frame's memory, for the attributes in `set`.
VertexOutput output_in(FrameMemory memory, const AttributeSet& set, const VertexBlocks& blocks,
                       std::size_t count) noexcept;

}  // namespace sinew
