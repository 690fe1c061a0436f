// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/plan/evaluate/frame_step.h"
#include "runtime/plan/evaluate/visibility.h"

namespace sinew {

/// Inputs of all mesh instances, apart from their palettes.
struct EvaluatedPose {
  std::span<const Affine> model;   ///< [joints of poses]; empty if no stage computes model matrices
  std::span<const float> weights;  ///< [W] morph weights, after correctives
  const Affine& root;
  const Visibility& visibility;
  std::span<const GeometryInput> geometry;  ///< [cached instances] or empty; FrameTables::shown has their vertices
};

/// Runs the stages winding, morph, skin, geometry_cache, flat normals and bounds for all mesh instances. Vertices that
/// are still valid from an earlier frame are kept.
/// in   step  its palettes are already computed for this frame
/// out  step.tables  instances and primitives
/// cost the sum over visible instances, no allocation. Internal to plan/
void show_instances(const CompiledPlan& plan, const EvaluatedPose& pose, const FrameStep& step,
                    FrameWork& work) noexcept;

/// Writes the results of all mesh instances of a sleeping character: nothing is visible.
void hide_instances(const CompiledPlan& plan, const FrameTables& tables) noexcept;

}  // namespace sinew
