// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/math/affine.h"
#include "runtime/math/joint_matrix.h"
#include "runtime/model/aabb.h"
#include "runtime/pose/pose.h"
#include "runtime/pose_program/pose_work.h"

namespace sinew {

/// Deformed vertices of one primitive of one mesh instance, in the primitive's vertex order. An empty span means that
/// the attribute is not deformed or not in the needs: use the primitive's own. A morphed primitive whose weights are
/// all zero gives views of the primitive's own arrays.
struct DeformedPrimitive {
  std::uint32_t instance = 0;
  std::uint32_t primitive = 0;
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> normals;
  std::span<const glm::vec4> tangents;
  std::span<const glm::vec4> colors;  ///< only when a target morphs COLOR_0
  /// Vertices are bit-identical since this FrameResult::frame; skip the upload if yours is as new. 0 = nothing to
  /// upload.
  std::uint64_t since_frame = 0;
};

/// One mesh instance in this frame.
struct InstanceResult {
  Affine world_from_mesh;             ///< identity for skinned meshes: their vertices are in world space already.
                                      ///< MeshInstance::copies are relative to it (model/scene.h)
  std::uint32_t first_primitive = 0;  ///< index into FrameResult::primitives: one entry per primitive of its mesh
  bool mirrored = false;  ///< front faces wind clockwise, since the determinant of world_from_mesh is negative. For a
                          ///< skinned mesh it is that of the first joint's skinning matrix
  bool visible = true;  ///< false if the mesh is on a hidden joint, or out of view by FrameInput. Then its box is empty
                        ///< and nothing is deformed, except hidden meshes under Needs::out.hidden_meshes
  bool from_cache = false;  ///< some or all of the vertices come from a source (FrameInput::geometry). At weight 1,
                            ///< world_from_mesh places the space of the source. At smaller weights, vertices are in
                            ///< world space, except those of unskinned meshes whose source is in mesh space
  bool late = false;        ///< the source had not loaded this frame yet, so an older frame (or the pose) is shown
  Aabb bounds;  ///< world space; empty unless Needs::out.bounds. Deformed meshes: the box of their vertices. Rigid
                ///< meshes: the box of their moved rest box, which contains the vertices. At weight 1 of a source: the
                ///< box of the source's moved box
};

/// Skinning matrices of one skin; empty when no mesh instance of this frame uses it.
struct SkinPalette {
  std::span<const JointMatrix> matrices;  ///< [joints of the skin] one matrix per joint
  std::uint64_t since_frame = 0;          ///< as in DeformedPrimitive
};

/// Work done by one frame of one character. A stage that the plan leaves out counts exactly zero.
struct WorkCounters : PoseProgramWork {
  std::uint64_t poses_interpolated = 0;  ///< mixed from two updates (FrameInput::interpolation_factor)
  std::uint64_t poses_compared = 0;      ///< comparisons with the sample poses of correctives
  std::uint64_t joints_composed = 0;
  std::uint64_t palette_entries = 0;
  std::uint64_t palette_entries_split = 0;
  std::uint64_t combinations_blended = 0;
  std::uint64_t morph_deltas = 0;
  std::uint64_t vertices_morphed = 0;
  std::uint64_t vertices_skinned_linear = 0;
  std::uint64_t vertices_skinned_in_tiles = 0;  ///< linearly skinned vertices that VertexTiles hold
  std::uint64_t normals_by_cofactors = 0;       ///< linearly skinned vertices whose normals use the cofactor matrix
  std::uint64_t vertices_skinned_dual_quaternion = 0;
  std::uint64_t vertices_skinned_center_of_rotation = 0;
  std::uint64_t windings_tested = 0;  ///< mesh instances whose determinant was computed, since its sign can change
  std::uint64_t cache_frames_decoded = 0;
  std::uint64_t vertices_from_cache = 0;
  std::uint64_t vertices_blended = 0;  ///< vertices from a cache that were blended with the pose
  std::uint64_t smooth_triangles = 0;  ///< triangles that gave normals or tangents, since the cache has none
  std::uint64_t flat_triangles = 0;
  std::uint64_t bounds_vertices = 0;

  friend bool operator==(const WorkCounters&, const WorkCounters&) = default;
};

/// The result of one frame of one character. Its views point into the frame buffer, and are valid until that buffer
/// runs again.
struct FrameResult {
  std::uint64_t frame = 0;            ///< counts up by one per run of the character
  std::uint64_t since_frame = 0;      ///< all frames from this number on had the same input, and so the same result
  PoseSpan local;                     ///< [K] local transforms that `model` is composed of; not to be written; empty
                                      ///< unless Needs::out.local_pose
  std::span<const Affine> model;      ///< [J] world matrix of every joint, or [K] of those that the plan keeps
                                      ///< (Needs::out.skeleton_lod; world_of in compile_plan.h)
  std::span<const float> weights;     ///< [W] morph weights of all mesh instances (Scene::first_weight), with what
                                      ///< correctives add where the plan runs them
  std::span<const float> properties;  ///< [P] as in Scene::properties; empty when not asked for (scene_look.h)
  std::span<const bool> hidden;       ///< [J] joints not shown; empty when nothing of the scene is ever hidden
  std::span<const SkinPalette> palettes;  ///< [skins]; empty unless Needs::out.palettes
  std::span<const InstanceResult> instances;
  std::span<const DeformedPrimitive> primitives;
  std::span<const std::uint64_t> stage_ns;  ///< [kStageCount] nanoseconds of each Stage, 0 for one that did not run;
                                            ///< empty unless Needs::out.stage_times
  WorkCounters work;
};

}  // namespace sinew
