// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/math/affine.h"
#include "runtime/math/joint_matrix.h"
#include "runtime/model/mesh.h"
#include "runtime/plan/work_counters.h"

namespace sinew {

/// Deformed vertices of one primitive of one mesh instance, in the primitive's vertex order. Empty spans: the attribute
/// is not deformed or not asked for, use the primitive's own. A morphed primitive whose weights are all zero gives
/// views of the primitive's own arrays.
struct DeformedPrimitive {
  std::uint32_t instance = 0;
  std::uint32_t primitive = 0;
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> normals;
  std::span<const glm::vec4> tangents;
  std::span<const glm::vec4> colors;  ///< only when a target morphs COLOR_0
  std::uint64_t since_frame =
      0;  ///< first FrameResult::frame of the unbroken row of frames with exactly these
          ///< vertices: who has those of any of them need not upload (P19). 0 = nothing to upload
};

/// One mesh instance in this frame.
struct InstanceResult {
  Affine world_from_mesh;             ///< identity for skinned meshes: their vertices are in world space already (G29);
                                      ///< MeshInstance::copies are relative to it (mesh_copies.h)
  std::uint32_t first_primitive = 0;  ///< into FrameResult::primitives: one entry per primitive of its mesh
  bool mirrored = false;              ///< front faces wind clockwise (G48): the determinant of world_from_mesh is
                                      ///< negative, for a skinned mesh that of the first joint's skinning matrix
  bool visible = true;  ///< false: on a hidden joint, or out of view by FrameInput; then its box is empty and,
                        ///< but for hidden meshes that are asked for, nothing is deformed
  Aabb bounds;          ///< world space; empty unless Needs::bounds. Deformed meshes: the box of their
                        ///< vertices; rigid ones: the box of their moved rest box, which holds it (G54)
};

/// Skinning matrices of one skin; empty when no mesh instance of this frame uses it.
struct SkinPalette {
  std::span<const JointMatrix> matrices;  ///< [joints of the skin]
  std::uint64_t since_frame = 0;          ///< as in DeformedPrimitive
};

/// What one frame of one character gives: views into memory that belongs to the buffer it was run into. Valid until
/// that buffer runs again.
struct FrameResult {
  std::uint64_t frame = 0;  ///< counts up by one per run of the instance
  std::uint64_t since_frame =
      0;  ///< first frame of an unbroken row with this very input, and so with this result (P19)
  std::span<const Affine>
      model;  ///< [J] world matrix of every joint, or [K] of those kept (Plan::rig; world_of in rig.h)
  std::span<const float> weights;         ///< [W] morph weights of all mesh instances (Scene::first_weight), with
                                          ///< what correctives add where the plan runs them
  std::span<const float> properties;      ///< [P] as in Scene::properties; empty when not asked for (scene_look.h)
  std::span<const bool> hidden;           ///< [J] joints not shown; empty when nothing of the scene is ever hidden
  std::span<const SkinPalette> palettes;  ///< [skins]; empty unless Needs::palettes
  std::span<const InstanceResult> instances;
  std::span<const DeformedPrimitive> primitives;
  std::span<const std::uint64_t> stage_ns;  ///< [stages] nanoseconds that each of Plan::stages took, 0 for one that did
                                            ///< not run; empty unless Needs::stage_times
  WorkCounters work;
};

}  // namespace sinew
