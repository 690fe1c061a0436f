// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/plan/frame_changes.h"
#include "runtime/plan/frame_work.h"
#include "runtime/plan/visibility.h"

namespace sinew {

/// What mesh instances follow.
struct EvaluatedPose {
  std::span<const Affine> model;   ///< [joints of poses]; empty where no stage makes it
  std::span<const float> weights;  ///< [W] with correctives
  const Affine& root;
  const Visibility& visibility;
  std::span<const GeometryInput> geometry;  ///< [cached instances] or empty; `shown` of the tables is theirs
};

/// Stages winding, morph, skin, geometry_cache, flat normals and bounds: the results of all mesh instances, with the
/// frames since which they hold. Vertices that are in the memory already stay.
/// in   step  its palettes are those of this frame
/// out  step  tables of instances and primitives
/// cost the sum of the instances that are seen, no allocation. Internal to plan/
void show_instances(const CompiledPlan& plan, const EvaluatedPose& pose, const FrameStep& step,
                    FrameWork& work) noexcept;

/// Leaves the primitives of an instance undeformed: nobody sees it.
void deform_nothing(const CompiledPlan& plan, std::size_t instance, const FrameTables& tables) noexcept;

/// Numbers of frames since which results of instances hold, for a frame whose results are in the memory already.
/// in   step   the palettes of its tables have theirs
void number_kept_instances(const CompiledPlan& plan, const FrameStep& step) noexcept;

}  // namespace sinew
