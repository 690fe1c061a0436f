// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_memory.h"
#include "runtime/plan/frame_result.h"
#include "runtime/pose_program/standing_operands.h"

namespace sinew {

/// The layers whose pose lies in one of FrameLayout::updates.
struct KeptUpdate {
  std::size_t layer_count = 0;
  bool is_there = false;
};

/// How a mesh instance shows its vertex source. Equal values and an equal pose give equal vertices.
struct PlayedGeometry {
  float weight = 0.0f;  ///< 0: the instance shows its pose
  VertexSpace space = VertexSpace::scene;
  bool turned = false;                        ///< triangles wind clockwise in the source's space
  std::uint64_t content = 0;                  ///< VertexSource::content
  std::uint64_t moment = 0;                   ///< ShownVertices::moment
  Affine world_from_source, world_from_pose;  ///< where source and pose are blended in world space

  bool in_full() const noexcept { return weight == 1.0f; }
  bool in_part() const noexcept { return weight > 0.0f && weight < 1.0f; }
};

/// Small arrays that a frame keeps in its memory: results, the frame numbers since which they are the same, and the
/// input that gave them. A number "since" is the first frame of an unbroken row of frames with equal bits; 0 means that
/// there is no result. Internal to plan/.
struct FrameTables {
  FrameTables(const CompiledPlan& plan, FrameMemory memory) noexcept : FrameTables(plan, plan.layout.tables, memory) {}

  std::span<InstanceResult> instances;
  std::span<DeformedPrimitive> primitives;
  std::span<SkinPalette> palettes;         ///< [skins]
  std::span<std::uint64_t> weights_since;  ///< [instances]
  std::span<std::uint64_t> winding_since;  ///< [instances] of InstanceResult::mirrored
  std::span<float> last_weights;           ///< [W] FrameResult::weights
  std::span<ClipLayer> input_layers;       ///< of the input that gave the results
  std::span<float> input_weights;
  std::span<std::uint8_t> input_out_of_view;  ///< 0 or 1; all 0 where FrameInput::out_of_view is empty
  std::span<ClipLayer> input_next_layers;
  std::span<const std::uint32_t> cached_instances;  ///< of the needs, where any may play
  std::span<ShownVertices> shown;                   ///< [cached instances] what their sources answered in this frame
  std::span<PlayedGeometry> played;                 ///< [cached instances]
  std::span<std::uint64_t> geometry_since;          ///< [cached instances] of `played`
  std::span<GeometryInput> input_geometry;  ///< [cached instances] no source where nothing plays or nobody sees it
  std::span<PoseOp> input_program;
  std::span<ContentVersion> input_versions;  ///< of all program inputs, list by list
  std::span<KeptOperands> kept;              ///< of operations of input_program
  std::span<KeptUpdate> updates;             ///< [2] of FrameLayout::updates
  std::span<std::uint64_t> stage_ns;         ///< FrameResult::stage_ns

 private:
  FrameTables(const CompiledPlan& plan, const TableLayout& at, FrameMemory memory) noexcept
      : instances(memory.of(at.instances)),
        primitives(memory.of(at.primitives)),
        palettes(memory.of(at.palettes)),
        weights_since(memory.of(at.weights_since)),
        winding_since(memory.of(at.winding_since)),
        last_weights(memory.of(at.last_weights)),
        input_layers(memory.of(at.input_layers)),
        input_weights(memory.of(at.input_weights)),
        input_out_of_view(memory.of(at.input_out_of_view)),
        input_next_layers(memory.of(at.input_next_layers)),
        cached_instances(std::span(plan.needs.in.cached_instances).first(at.shown.count)),
        shown(memory.of(at.shown)),
        played(memory.of(at.played)),
        geometry_since(memory.of(at.geometry_since)),
        input_geometry(memory.of(at.input_geometry)),
        input_program(memory.of(at.input_program)),
        input_versions(memory.of(at.input_versions)),
        kept(memory.of(at.kept)),
        updates(memory.of(at.updates)),
        stage_ns(memory.of(at.stage_ns)) {}
};

/// The entry of a primitive that goes through no stage.
inline DeformedPrimitive nothing_deformed(const PrimitivePlan& planned) noexcept {
  DeformedPrimitive shape;
  shape.instance = planned.instance;
  shape.primitive = planned.primitive;
  return shape;
}

}  // namespace sinew
