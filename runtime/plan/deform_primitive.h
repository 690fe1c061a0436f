// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/plan/frame_memory.h"
#include "runtime/plan/frame_result.h"
#include "runtime/plan/frame_work.h"

namespace sinew {

/// Stages morph, skin and flat normals for one primitive of one mesh instance.
/// in   p           index into CompiledPlan::primitives;   weights[T]  of the instance
///      mirrored    as in InstanceResult;   uneven_root  FrameInput::root scales unevenly
/// out  views of the frame's memory, or of the primitive's own arrays where a planned attribute rests in this frame;
///      positions are there whenever some stage needs them
/// cost O(V * influences + active deltas), no allocation. Internal to plan/
DeformedPrimitive deform_primitive(const CompiledPlan& plan, std::size_t p, std::span<const float> weights,
                                   bool mirrored, bool uneven_root, FrameMemory memory, FrameWork& work) noexcept;

}  // namespace sinew
