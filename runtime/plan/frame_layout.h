// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/deform/vertex_tiles.h"
#include "runtime/math/joint_matrix.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_memory.h"
#include "runtime/plan/frame_result.h"
#include "runtime/pose/joint_palette.h"
#include "runtime/pose_program/pose_slots.h"

namespace sinew {

struct CompiledPlan;
struct KeptOperands;
struct KeptUpdate;
struct PlayedGeometry;

/// Deformed vertices of a primitive. An attribute that no stage writes has an empty block.
struct VertexBlocks {
  Block<glm::vec3> positions, normals;
  Block<glm::vec4> tangents, colors;
};

/// Morphed vertices in the order of tiles.
struct TiledBlocks {
  Block<TilePlane> positions, normals, tangents;
};

/// Where the tables of a frame lie (frame_tables.h says what they hold).
struct TableLayout {
  Block<InstanceResult> instances;
  Block<DeformedPrimitive> primitives;
  Block<SkinPalette> palettes;
  Block<std::uint64_t> weights_since, winding_since;
  Block<float> last_weights, input_weights;
  Block<std::uint8_t> input_out_of_view;
  Block<ClipLayer> input_layers, input_next_layers;
  Block<ShownVertices> shown;
  Block<PlayedGeometry> played;
  Block<std::uint64_t> geometry_since;
  Block<GeometryInput> input_geometry;
  Block<PoseOp> input_program;
  Block<ContentVersion> input_versions;
  Block<KeptOperands> kept;
  Block<KeptUpdate> updates;
  Block<ClipLayer> update_layers[2];
  Block<std::uint64_t> stage_ns;
};

/// Where everything of a frame lies in its memory. Each block starts on a cache line of its own. The rest pose is
/// written once, all else by every frame. Internal to plan/.
struct FrameLayout {
  PoseBlock rest_pose;
  PoseBlocks pose;                   ///< pose of the frame; it is the lowest pose of the stack of pose operations
  Block<std::byte> pose_program;     ///< the other poses of that stack, and scratch
  PoseSlotLayout pose_slots;         ///< layout of `pose_program`
  PoseBlocks updates[2];             ///< poses of `layers` and `next_layers` of frames between updates
  Block<double> corrective_scratch;  ///< scratch for one corrective at a time
  Block<bool> hidden;                ///< [joints of the scene] true = not shown
  Block<bool> palette_wanted;        ///< [skins] a visible instance needs the skin
  Block<Affine> model;               ///< [joints of poses] world matrices
  std::vector<Block<JointMatrix>> palettes;  ///< [skins] matrices of the joints, then of their combinations
  std::vector<Block<RigidStretch>> splits;   ///< [skins] palettes split for dual quaternions
  Block<bool> stretch;                       ///< [skins] the split found stretch
  std::vector<VertexBlocks> primitives;      ///< deformed vertices, parallel to CompiledPlan::primitives
  VertexBlocks morphed;                      ///< vertices of the current primitive, between morph and skin
  TiledBlocks morphed_tiles;                 ///< the same, where the primitive is skinned in tiles
  Block<glm::vec3> morph_scratch;
  VertexBlocks cached;            ///< vertices of the current primitive, before they are blended with its pose
  Block<glm::vec4> surface_sums;  ///< scratch of the geometry_cache stage
  TableLayout tables;
  std::size_t front_bytes = 0;  ///< the first bytes, which frames of one clip touch before vertices
  std::size_t frame_bytes = 0;  ///< all of it, a multiple of 64
};

/// Fills `plan.layout` from all else in the plan.
void lay_out_frame(CompiledPlan& plan);

}  // namespace sinew
