// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/animation/skeleton.h"
#include "runtime/math/affine.h"

namespace sinew {

/// How a layer enters the pose: averaged with its like, or added on top of their mean (add_pose.h), as far as the clip
/// differs from the rest pose or from its own first instant.
enum class LayerKind : std::uint8_t { blend, add_to_rest, add_to_start };

/// One clip playing at one time, with a weight.
struct ClipLayer {
  std::uint32_t clip = 0;
  double time_s = 0.0;
  float weight = 1.0f;
  std::uint32_t mask =
      kNone;  ///< index into Needs::masks: joint weights that multiply `weight`. Morph weights have none
  LayerKind kind = LayerKind::blend;
};

/// What to evaluate. No layers = rest pose (also when the scene has no clips at all). Layers are averaged by weight,
/// where the weights sum to less than 1 the rest pose fills up; a layer of weight 0 is as good as absent. Layers that
/// add follow in their order.
struct FrameInput {
  std::span<const ClipLayer> layers;
  std::span<const float> weights;  ///< [W] replaces all morph weights; empty = from the clips, else rest.
                                   ///< Correctives add to either
  Affine root;                     ///< placed above all root joints
  std::span<const ClipLayer> next_layers =
      {};  ///< layers of a later time; not looked at while `interpolation_factor` is 0
  float interpolation_factor =
      0.0f;  ///< [0, 1] part of the way from the pose of `layers` to that of `next_layers`, each of which is evaluated
             ///< once as long as it stays: needs Needs::between_updates, else 0
  std::span<const std::uint8_t> out_of_view =
      {};               ///< [instances] 1: nobody sees the mesh, which is then neither morphed nor
                        ///< skinned nor bounded; joints and weights are as ever. Empty = all are in view
  bool asleep = false;  ///< nobody needs anything of the character: no stage runs and the result is empty. Clocks,
                        ///< events and root motion go on, they lie outside of frames
};

}  // namespace sinew
