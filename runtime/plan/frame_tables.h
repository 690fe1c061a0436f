// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_memory.h"
#include "runtime/plan/frame_result.h"
#include "runtime/plan/frame_work.h"
#include "runtime/pose/blend_poses.h"

namespace sinew {

/// Which layers gave the pose of Plan::ends that a frame buffer has.
struct UpdateEnd {
  std::size_t layer_count = 0;
  bool is_there = false;
};

/// What a frame buffer keeps in its block beside the numbers that stages write: results, and since which frame they
/// hold. A stamp names the first frame of an unbroken row of frames that gave the same bits; 0 = not there.
struct FrameTables {
  FrameTables(const Plan& plan, FrameMemory memory) noexcept
      : instances(memory.array<InstanceResult>(plan.tables.instances_at, plan.scene->instances.size())),
        primitives(memory.array<DeformedPrimitive>(plan.tables.primitives_at, plan.primitives.size())),
        blend_layers(memory.array<BlendLayer>(plan.tables.blend_layers_at, plan.needs.max_layers)),
        palettes(memory.array<SkinPalette>(plan.tables.palettes_at, plan.palette.size())),
        weights_since(memory.array<std::uint64_t>(plan.tables.weights_since_at, plan.scene->instances.size())),
        winding_since(memory.array<std::uint64_t>(plan.tables.winding_since_at, plan.scene->instances.size())),
        last_weights(memory.array<float>(plan.tables.last_weights_at, plan.rest_weights.size())),
        input_layers(memory.array<ClipLayer>(plan.tables.input_layers_at, plan.tables.input_layer_count)),
        input_weights(memory.array<float>(plan.tables.input_weights_at, plan.rest_weights.size())),
        input_out_of_view(memory.array<std::uint8_t>(plan.tables.input_out_of_view_at, plan.scene->instances.size())),
        input_ahead(
            memory.array<ClipLayer>(plan.tables.input_ahead_at, plan.interpolate ? plan.tables.input_layer_count : 0)),
        ends(memory.array<UpdateEnd>(plan.tables.ends_at, plan.interpolate ? 2 : 0)),
        stage_ns(memory.array<std::uint64_t>(plan.tables.stage_ns_at, plan.needs.stage_times ? kStageCount : 0)) {}

  std::span<InstanceResult> instances;
  std::span<DeformedPrimitive> primitives;
  std::span<BlendLayer> blend_layers;      // of the blend stage while it runs
  std::span<SkinPalette> palettes;         // [skins]
  std::span<std::uint64_t> weights_since;  // [instances]
  std::span<std::uint64_t> winding_since;  // [instances] InstanceResult::mirrored
  std::span<float> last_weights;           // [W] FrameResult::weights
  std::span<ClipLayer> input_layers;       // the input that the results belong to
  std::span<float> input_weights;
  std::span<std::uint8_t> input_out_of_view;  // 0 or 1, all 0 where the input leaves it empty
  std::span<ClipLayer> input_ahead;
  std::span<UpdateEnd> ends;          // [2] of Plan::ends
  std::span<std::uint64_t> stage_ns;  // FrameResult::stage_ns
};

/// Which joints are, in the memory that a frame runs into, where this frame has them as well (P01).
enum class StandingJoints : std::uint8_t {
  none,
  unmoved,  ///< those that no clip moves
  all
};

/// The entry of a primitive that goes through no stage.
inline DeformedPrimitive nothing_deformed(const PrimitivePlan& planned) noexcept {
  DeformedPrimitive shape;
  shape.instance = planned.instance, shape.primitive = planned.primitive;
  return shape;
}

}  // namespace sinew
