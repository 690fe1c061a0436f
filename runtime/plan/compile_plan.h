// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/deform/combine_influences.h"
#include "runtime/model/scene.h"
#include "runtime/plan/joint_scales.h"
#include "runtime/plan/needs.h"
#include "runtime/plan/rig.h"
#include "runtime/pose/joint_palette.h"

namespace sinew {

/// One stage of the evaluation, run or left out, with the reason in words a person understands.
struct PlanStage {
  std::string stage;  ///< "sample", "blend", "local_to_model", "palette", ...: describe_stages has all
  bool runs = false;
  std::string reason;
  std::uint64_t count = 0;  ///< what the stage touches per frame: tracks, joints, entries, vertices
  std::uint64_t bytes = 0;  ///< of frame memory that it writes
};

/// Vertex attributes that a stage writes for one primitive.
struct AttributeSet {
  bool positions = false, normals = false, tangents = false;

  bool any() const noexcept { return positions || normals || tangents; }
};

/// What a primitive of a mesh instance goes through: morph, then skin, then flat normals, each only where called for.
struct PrimitivePlan {
  std::uint32_t instance = 0, primitive = 0;
  AttributeSet morph, skin;
  bool morph_colors = false;
  bool flat_normals = false;  ///< recomputed from the deformed triangles (G46)
  bool cofactors = false;  ///< normals follow cofactors, where the needs ask for them: scale or blends are uneven (P08)
  Skinning skinning = Skinning::linear;
  std::vector<JointPair> pairs;    ///< joints that share vertices, for dual quaternions (hemisphere_pairs.h)
  std::uint32_t combined = kNone;  ///< index into Plan::combined of its skin, where that is used
  bool lacks_centers = false;      ///< `skinning` is linear in place of center_of_rotation
  std::size_t positions_at = 0, normals_at = 0, tangents_at = 0, colors_at = 0;  ///< byte offsets into the frame memory

  bool deformed() const noexcept { return morph.any() || skin.any() || morph_colors || flat_normals; }
};

/// Tracks that one sample of a clip evaluates.
struct ClipTracks {
  std::uint32_t joints = 0, weights = 0, properties = 0;
  bool moves_joints = false;  ///< by such tracks, or by constants other than the rest pose
};

/// A pose with its morph weights and properties; byte offsets.
struct PosePlaces {
  std::size_t pose_at = 0, weights_at = 0, properties_at = 0;
};

/// Where a frame buffer keeps results and what they came from (frame_tables.h); byte offsets.
struct TablePlaces {
  std::size_t instances_at = 0, primitives_at = 0, blend_layers_at = 0;
  std::size_t palettes_at = 0, weights_since_at = 0, winding_since_at = 0;
  std::size_t last_weights_at = 0, input_weights_at = 0, input_out_of_view_at = 0;
  std::size_t input_layers_at = 0, input_layer_count = 0, input_ahead_at = 0;
  std::size_t ends_at = 0, end_layers_at[2] = {};
  std::size_t stage_ns_at = 0;
};

/// The evaluation of one scene for given needs: which stages run, and where in one block of frame memory each of them
/// writes. Immutable; shared by all characters that show the scene. Keeps a pointer to the scene: that must outlive it.
struct Plan {
  const Scene* scene = nullptr;
  Needs needs;
  Rig rig;  ///< what poses are made of
  std::vector<PlanStage> stages;
  std::vector<PrimitivePlan> primitives;       ///< one per primitive of each mesh instance
  std::vector<std::uint32_t> first_primitive;  ///< [instances + 1] into `primitives`
  std::vector<bool> instance_skinned;          ///< [instances] some primitive follows the instance's skin
  std::vector<ClipTracks> clip_tracks;         ///< [clips]
  std::vector<std::uint32_t> moved_joints;  ///< of the rig, by some clip, or below such joints: the others have their
                                            ///< rest pose in every frame (P01)
  std::vector<JointScale> joint_scales;     ///< [joints of the rig]
  std::vector<JointScale>
      instance_scales;                    ///< [instances] of what decides which way faces wind, but for the root (P09)
  std::vector<std::vector<float>> masks;  ///< [any][joints of the rig]
  std::vector<float> rest_weights;        ///< [W]
  bool sample = false, blend = false, add = false, interpolate = false, correctives = false, properties = false,
       local_to_model = false, bounds = false;
  bool hide = false, hide_per_frame = false;  ///< some joint may be hidden; clips decide it
  std::vector<bool> palette, split;           ///< [skins] the skin's matrices are made; they are split as well
  std::vector<std::vector<CombinedInfluences>> combined;  ///< [skins] of primitives that are skinned linearly (C06)
  std::vector<std::vector<JointPair>> hemisphere_edges;   ///< [skins] of those that are split (hemisphere_pairs.h)

  // Byte offsets into the frame memory. The rest pose is written once, the rest by every frame.
  std::size_t rest_pose_at = 0, pose_at = 0, layer_poses_at = 0;  ///< layers after the first have a pose of their own
  std::size_t weights_at = 0, layer_weights_at = 0;
  std::size_t corrective_scratch_at = 0, corrective_scratch_count = 0;  ///< of doubles, for one corrective at a time
  std::size_t added_pose_at = 0, reference_pose_at = 0;                 ///< of the layer that is being added
  std::size_t added_weights_at = 0, reference_weights_at = 0;
  std::size_t properties_at = 0, layer_properties_at = 0;
  PosePlaces ends[2];                 ///< the poses that frames lie between
  std::size_t hidden_at = 0;          ///< bool[joints]
  std::size_t palette_wanted_at = 0;  ///< bool[skins]: an instance that is seen needs the skin
  std::size_t model_at = 0;
  std::vector<std::size_t> palette_at, split_at;  ///< [skins]; combinations follow the joints of a palette
  std::size_t new_palette_at = 0;  ///< of the skin at hand, until it is known to differ from the frame before
  std::size_t stretch_at = 0;      ///< bool[skins]: the split found stretch
  std::size_t morphed_positions_at = 0, morphed_normals_at = 0, morphed_tangents_at = 0;  ///< between morph and skin
  std::size_t scratch_at = 0;
  TablePlaces tables;
  std::size_t front_bytes = 0;    ///< from the start of the block on: what frames of one clip touch before vertices
  std::size_t frame_bytes = 0;    ///< size of the block, a multiple of 64
  std::uint64_t fingerprint = 0;  ///< of the needs: tells frame buffers of plans of equal size apart
};

inline const Primitive& primitive_of(const Plan& plan, const PrimitivePlan& planned) noexcept {
  return plan.scene->meshes[plan.scene->instances[planned.instance].mesh].primitives[planned.primitive];
}

/// Matrices of a skin that a frame keeps: of its joints, then of combinations of them.
inline std::size_t matrix_count(const Plan& plan, std::size_t skin) noexcept {
  std::size_t count = plan.scene->skins[skin].joints.size();
  for (const CombinedInfluences& combined : plan.combined[skin])
    if (combined.used()) count += combined.combination_count;
  return count;
}

/// in   scene   must have passed check(Scene);   needs   max_layers >= 1, instance_skinning empty or one per instance,
/// masks of one
///                                                     finite weight >= 0 per joint, skeleton_lod empty or for all
///                                                     joints
/// cost O(size of the scene), allocates the plan; where joints are left out also what of skeleton, clips and skins is
/// kept
Plan compile_plan(const Scene& scene, const Needs& needs);

}  // namespace sinew
