// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/plan/evaluate/frame_step.h"
#include "runtime/plan/evaluate/visibility.h"

namespace sinew {

/// All that mesh instances follow, beside their palettes.
struct EvaluatedPose {
  std::span<const Affine> model;   ///< [joints of poses]; empty where no stage makes it
  std::span<const float> weights;  ///< [W] with correctives
  const Affine& root;
  const Visibility& visibility;
  std::span<const GeometryInput> geometry;  ///< [cached instances] or empty; `shown` of the tables is theirs
};

/// Stages winding, morph, skin, geometry_cache, flat normals and bounds: the results of all mesh instances. Vertices
/// that stand are left as they are.
/// in   step  its palettes are those of this frame
/// out  step.tables  instances and primitives
/// cost the sum of the instances that are seen, no allocation. Internal to plan/
void show_instances(const CompiledPlan& plan, const EvaluatedPose& pose, const FrameStep& step,
                    FrameWork& work) noexcept;

/// The results of all mesh instances of a sleeping character: nothing is visible.
void hide_instances(const CompiledPlan& plan, const FrameTables& tables) noexcept;

}  // namespace sinew
