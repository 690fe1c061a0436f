// SPDX-License-Identifier: MIT
#pragma once
#include <bitset>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/deform/combine_influences.h"
#include "runtime/deform/flat_faces.h"
#include "runtime/deform/surface_normals.h"
#include "runtime/deform/tiled_morphs.h"
#include "runtime/deform/vertex_tiles.h"
#include "runtime/plan/compile_plan.h"
#include "runtime/plan/frame_layout.h"
#include "runtime/plan/joint_scales.h"
#include "runtime/plan/plan_assets.h"
#include "runtime/pose/joint_palette.h"
#include "runtime/pose/mirror_pose.h"

namespace sinew {

/// How a primitive of a mesh instance is skinned, in addition to PrimitivePlan.
struct PrimitiveSkinning {
  std::vector<JointPair> pairs;               ///< joints that share vertices, for dual quaternions (hemisphere_pairs.h)
  std::uint32_t combined = kNone;             ///< index into CompiledPlan::combined of its skin; kNone = not used
  std::shared_ptr<const VertexTiles> tiles;   ///< of the influences, or of the combined ones; null = none
  std::shared_ptr<const TiledMorphs> morphs;  ///< morph targets in the order of `tiles`; null = nothing is morphed
};

/// The content of a Plan: everything that run_plan reads beside the input. Internal to plan/ and its tests.
struct CompiledPlan {
  std::shared_ptr<const Scene> scene;
  Needs needs;
  PlanAssets assets;  ///< skeleton, clips, skins and correctives that poses are made of
  FrameLayout layout;

  // The stages that frames run. For stages on skins and vertices, the tables below say for which of them.
  bool poses = false;  ///< clips or programs make poses: frames do not just show the rest pose
  bool sample = false, mirror = false, blend = false, add = false, interpolate = false, correctives = false,
       properties = false, local_to_model = false, bounds = false;
  bool hide = false, hide_per_frame = false;  ///< some joint may be hidden; clips decide which
  std::bitset<kStageCount> stages;            ///< all stages that run, for Plan::runs

  // Clips and poses.
  std::vector<ClipTracks> clip_tracks;        ///< [clips] tracks that a sample evaluates
  std::vector<std::uint32_t> moved_joints;    ///< joints of poses that some clip moves, and all below them. All other
                                              ///< joints have their rest pose in every frame
  std::vector<std::uint32_t> unmoved_joints;  ///< all other joints of poses
  std::vector<JointScale> joint_scales;       ///< [joints of poses] scales that can reach each joint
  MirrorTables mirror_tables;                 ///< for the joints of poses; used if `mirror`
  std::vector<std::vector<float>> mask_weights;  ///< [masks of the needs][joints of poses]
  std::vector<std::span<const float>> masks;     ///< views of `mask_weights`
  std::vector<float> rest_weights;               ///< [W] rest weights of all mesh instances
  PoseProgramAssets pose_assets;                 ///< views of the above; the rest pose is FrameLayout::rest_pose

  // Mesh instances and their primitives.
  std::vector<PrimitivePlan> primitives;                     ///< one per primitive of each mesh instance
  std::vector<PrimitiveSkinning> primitive_skinning;         ///< parallel to `primitives`
  std::vector<std::shared_ptr<const FlatFaces>> flat_faces;  ///< parallel to `primitives`; null without flat normals
  std::vector<std::shared_ptr<const SurfaceFaces>> surface_faces;  ///< parallel to `primitives`; null: no source
  std::vector<std::uint32_t> first_primitive;                      ///< [instances + 1] into `primitives`
  std::vector<std::uint32_t> geometry_slot;  ///< [instances] index into Needs::in.cached_instances, or kNone if no
                                             ///< source can play; empty if none can play anywhere
  std::vector<bool> instance_skinned;        ///< [instances] some primitive follows the instance's skin
  std::vector<JointScale> instance_scales;   ///< [instances] of the matrix whose determinant says which way faces
                                             ///< wind, without the root

  // Skins.
  std::vector<bool> palette, split;  ///< [skins] frames make the skin's matrices; they split them too
  /// [skins] combined matrices of primitives that are skinned linearly
  std::vector<std::vector<CombinedInfluences>> combined;
  /// [skins] pairs of joints of skins that are split (hemisphere_pairs.h)
  std::vector<std::vector<JointPair>> hemisphere_edges;
};

/// Index of an instance in the tables of Needs::in.cached_instances, or kNone.
inline std::uint32_t geometry_slot_of(const CompiledPlan& plan, std::size_t instance) noexcept {
  return plan.geometry_slot.empty() ? kNone : plan.geometry_slot[instance];
}

inline const Primitive& primitive_of(const CompiledPlan& plan, const PrimitivePlan& planned) noexcept {
  return plan.scene->meshes[plan.scene->instances[planned.instance].mesh].primitives[planned.primitive];
}

/// Matrices of a skin that a frame keeps: of its joints, then of combinations of them.
inline std::size_t matrix_count(const CompiledPlan& plan, std::size_t skin) noexcept {
  std::size_t count = plan.scene->skins[skin].joints.size();
  for (const CombinedInfluences& combined : plan.combined[skin])
    if (combined.used()) count += combined.combination_count;
  return count;
}

/// See Plan::stages.
std::vector<PlanStage> describe_stages(const CompiledPlan& plan);

}  // namespace sinew
