// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

namespace sinew {

struct CompiledPlan;

/// Where the vertices of a primitive are that frames deform.
struct PrimitiveLayout {
  std::size_t positions_at = 0, normals_at = 0, tangents_at = 0, colors_at = 0;
};

/// Where a pose is, with its morph weights and properties.
struct PoseLayout {
  std::size_t pose_at = 0, weights_at = 0, properties_at = 0;
};

/// Where a frame buffer keeps results and what they came from (frame_tables.h).
struct TableLayout {
  std::size_t instance_count = 0, primitive_count = 0, skin_count = 0, weight_count = 0, blend_layer_count = 0;
  std::size_t instances_at = 0, primitives_at = 0, blend_layers_at = 0;
  std::size_t palettes_at = 0, weights_since_at = 0, winding_since_at = 0;
  std::size_t last_weights_at = 0, input_weights_at = 0, input_out_of_view_at = 0;
  std::size_t input_layers_at = 0, input_layer_count = 0, input_next_layers_at = 0;
  std::size_t slot_count = 0, shown_at = 0, played_at = 0, geometry_since_at = 0, input_geometry_at = 0;
  std::size_t updates_at = 0, update_layers_at[2] = {};
  std::size_t stage_ns_at = 0;
};

/// Where everything of a frame lies in its one block of memory: byte offsets, each at a cache line of its own. The rest
/// pose is written once, the rest by every frame. Internal to plan/.
struct FrameLayout {
  std::size_t rest_pose_at = 0, pose_at = 0, layer_poses_at = 0;  ///< layers after the first have a pose of their own
  std::size_t weights_at = 0, layer_weights_at = 0;
  std::size_t unmirrored_pose_at = 0, unmirrored_weights_at = 0;  ///< of the layer that is being mirrored
  std::size_t properties_at = 0, layer_properties_at = 0;
  std::size_t corrective_scratch_at = 0, corrective_scratch_count = 0;  ///< of doubles, for one corrective at a time
  std::size_t added_pose_at = 0, reference_pose_at = 0;                 ///< of the layer that is being added
  std::size_t added_weights_at = 0, reference_weights_at = 0;
  PoseLayout updates[2];                          ///< the poses that frames between updates lie between
  std::size_t hidden_at = 0;                      ///< bool[joints of the scene]
  std::size_t palette_wanted_at = 0;              ///< bool[skins]: an instance that is seen needs the skin
  std::size_t model_at = 0;                       ///< Affine[joints of poses]
  std::vector<std::size_t> palette_at, split_at;  ///< [skins]; combinations follow the joints of a palette
  std::size_t stretch_at = 0;                     ///< bool[skins]: the split found stretch
  std::vector<PrimitiveLayout> primitives;        ///< as CompiledPlan::primitives
  PrimitiveLayout morphed;                        ///< of the primitive at hand, between morph and skin
  std::size_t scratch_at = 0;                     ///< of the morph stage
  PrimitiveLayout cached;                         ///< of the primitive at hand, before it is blended with its pose
  std::size_t surface_sums_at = 0;                ///< of the geometry_cache stage
  TableLayout tables;
  std::size_t front_bytes = 0;  ///< from the start of the block on: what frames of one clip touch before vertices
  std::size_t frame_bytes = 0;  ///< size of the block, a multiple of 64
};

/// Fills `plan.layout` from all else in the plan.
void lay_out_frame(CompiledPlan& plan);

}  // namespace sinew
