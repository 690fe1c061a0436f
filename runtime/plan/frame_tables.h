// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_memory.h"
#include "runtime/plan/frame_result.h"
#include "runtime/plan/frame_work.h"
#include "runtime/pose/blend_poses.h"

namespace sinew {

/// Which layers gave the pose that a frame buffer keeps in a place of FrameLayout::updates.
struct KeptUpdate {
  std::size_t layer_count = 0;
  bool is_there = false;
};

/// What an instance shows from its source: all that its vertices follow from, beside its pose.
struct PlayedGeometry {
  float weight = 0.0f;  ///< 0 = it shows its pose
  VertexSpace space = VertexSpace::scene;
  bool turned = false;        ///< triangles wind around the inside in the source's space
  std::uint64_t content = 0;  ///< VertexSource::content
  std::uint64_t moment = 0;
  Affine world_from_source, world_from_pose;  ///< where the two are blended in world space

  bool in_full() const noexcept { return weight == 1.0f; }
  bool in_part() const noexcept { return weight > 0.0f && weight < 1.0f; }
};

/// What a frame buffer keeps in its block beside the numbers that stages write: results, the frames since which they
/// hold, and the last input. "Since" is the first frame of an unbroken row of frames that gave the same bits; 0 = there
/// is no result. Internal to plan/.
struct FrameTables {
  FrameTables(const CompiledPlan& plan, FrameMemory memory) noexcept : FrameTables(plan, plan.layout.tables, memory) {}

  std::span<InstanceResult> instances;
  std::span<DeformedPrimitive> primitives;
  std::span<BlendLayer> blend_layers;      // of the blend stage while it runs
  std::span<SkinPalette> palettes;         // [skins]
  std::span<std::uint64_t> weights_since;  // [instances]
  std::span<std::uint64_t> winding_since;  // [instances] of InstanceResult::mirrored
  std::span<float> last_weights;           // [W] FrameResult::weights
  std::span<ClipLayer> input_layers;       // the last input, that of the results
  std::span<float> input_weights;
  std::span<std::uint8_t> input_out_of_view;  // 0 or 1, all 0 where the input leaves it empty
  std::span<ClipLayer> input_next_layers;
  std::span<const std::uint32_t> cached_instances;  // of the needs, where any may play
  std::span<ShownVertices> shown;           // [cached instances] what their sources answered; for the stages of a frame
  std::span<PlayedGeometry> played;         // [cached instances]
  std::span<std::uint64_t> geometry_since;  // [cached instances] of `played`
  std::span<GeometryInput> input_geometry;  // [cached instances] no source where nothing plays, or nobody sees it
  std::span<KeptUpdate> updates;            // [2] of FrameLayout::updates
  std::span<std::uint64_t> stage_ns;        // FrameResult::stage_ns

 private:
  FrameTables(const CompiledPlan& plan, const TableLayout& at, FrameMemory memory) noexcept
      : instances(memory.array<InstanceResult>(at.instances_at, at.instance_count)),
        primitives(memory.array<DeformedPrimitive>(at.primitives_at, at.primitive_count)),
        blend_layers(memory.array<BlendLayer>(at.blend_layers_at, at.blend_layer_count)),
        palettes(memory.array<SkinPalette>(at.palettes_at, at.skin_count)),
        weights_since(memory.array<std::uint64_t>(at.weights_since_at, at.instance_count)),
        winding_since(memory.array<std::uint64_t>(at.winding_since_at, at.instance_count)),
        last_weights(memory.array<float>(at.last_weights_at, at.weight_count)),
        input_layers(memory.array<ClipLayer>(at.input_layers_at, at.input_layer_count)),
        input_weights(memory.array<float>(at.input_weights_at, at.weight_count)),
        input_out_of_view(memory.array<std::uint8_t>(at.input_out_of_view_at, at.instance_count)),
        input_next_layers(
            memory.array<ClipLayer>(at.input_next_layers_at, plan.interpolate ? at.input_layer_count : 0)),
        cached_instances(std::span(plan.needs.cached_instances).first(at.slot_count)),
        shown(memory.array<ShownVertices>(at.shown_at, at.slot_count)),
        played(memory.array<PlayedGeometry>(at.played_at, at.slot_count)),
        geometry_since(memory.array<std::uint64_t>(at.geometry_since_at, at.slot_count)),
        input_geometry(memory.array<GeometryInput>(at.input_geometry_at, at.slot_count)),
        updates(memory.array<KeptUpdate>(at.updates_at, plan.interpolate ? 2 : 0)),
        stage_ns(memory.array<std::uint64_t>(at.stage_ns_at, plan.needs.stage_times ? kStageCount : 0)) {}
};

/// The entry of a primitive that goes through no stage.
inline DeformedPrimitive nothing_deformed(const PrimitivePlan& planned) noexcept {
  DeformedPrimitive shape;
  shape.instance = planned.instance;
  shape.primitive = planned.primitive;
  return shape;
}

}  // namespace sinew
