// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "runtime/animation/mirror_map.h"
#include "runtime/deform/skin_linear.h"
#include "runtime/model/skeleton_lod.h"
#include "runtime/pose_program/pose_program.h"

namespace sinew {

/// How skinned vertices follow their joints. `center_of_rotation` needs Primitive::centers_of_rotation; a primitive
/// without them is skinned linearly, and so is a vertex without a center.
enum class Skinning : std::uint8_t { linear, dual_quaternion, center_of_rotation };

/// Parts of the result that a consumer wants from each frame.
struct Outputs {
  bool joints = true;      ///< world matrices of the joints that `skeleton_lod` keeps
  bool local_pose = true;  ///< local transforms of joints (FrameResult::local)
  bool positions = true;   ///< deformed vertex positions
  bool normals = true;
  bool tangents = true;          ///< tangents of primitives that have a normal map in some variant, or no material
  bool tangents_of_all = false;  ///< tangents of all primitives, for consumers with materials of their own
  bool weights = true;           ///< morph weights with the correctives, for consumers that morph vertices themselves
  bool palettes = false;         ///< skinning matrices of the skins in use, for consumers that skin vertices themselves
  bool bounds = false;           ///< boxes of the mesh instances
  bool properties = true;        ///< animated numbers of materials, lights and cameras
  bool hidden_meshes = false;    ///< deform meshes on hidden joints as well
  bool stage_times = false;      ///< the time that each stage takes; reads the clock a few times per frame
  SkeletonLod skeleton_lod = {};  ///< joints that poses leave out

  /// True if the needs ask for vertices, not just for joints and weights.
  bool vertices() const noexcept { return positions || normals || tangents || bounds; }
};

/// Features of FrameInput that frames may use. A frame buffer has memory for these and no more.
struct Inputs {
  std::uint32_t max_layers = 4;  ///< most blended clip layers in one frame; 1 = no blending stage and no memory for it.
                                 ///< Additive layers do not count
  bool additive = false;         ///< some layers add to the pose
  std::uint32_t max_additive_layers = 8;  ///< room to remember the additive layers of the last run. A frame with more
                                          ///< of them is allowed, but never recognised as unchanged
  bool between_updates = false;           ///< some frames lie between two poses (FrameInput::interpolation_factor)
  std::shared_ptr<const MirrorMap> mirror = {};  ///< how layers are mirrored (ClipLayer::mirrored); null = none ever is
  std::vector<std::vector<float>> masks = {};    ///< [at most 255][J] joint weights >= 0 that layers may name. Masks
                                                 ///< that change lie in the input; program.masks declares them
  /// Mesh instances whose vertices FrameInput::geometry may give, rising.
  std::vector<std::uint32_t> cached_instances = {};
  PoseProgramRoom program = {};  ///< limits of FrameInput::program: the largest count of each kind in any frame
                                 ///< (room_of gives that of one program). 0 operations = no programs. Its `masks`
                                 ///< counts the `masks` above and those of the input together, also those of layers
  bool cut = false;  ///< some frames run in two halves, between which the caller changes the pose (cut_frame.h)

  /// Room for layers in a frame, blended and additive ones.
  std::size_t layer_room() const noexcept {
    return std::size_t{max_layers} + (additive ? std::size_t{max_additive_layers} : 0);
  }
};

/// How the skinned vertices of each mesh instance follow their joints.
struct SkinningRules {
  Skinning kind = Skinning::linear;
  std::vector<Skinning> per_instance = {};  ///< [instances] overrides `kind` per mesh instance; empty = no override
  /// How normals are skinned linearly; other kinds of skinning transform normals exactly
  NormalRule normal_rule = NormalRule::linear;

  Skinning kind_of(std::size_t instance) const noexcept {
    return instance < per_instance.size() ? per_instance[instance] : kind;
  }
};

/// The consumer's demands on frames. A stage that neither the needs nor the scene call for is left out of the plan.
///
///     const Needs needs{.out = {.bounds = true}, .in = {.max_layers = 2}, .skin = {.kind = Skinning::linear}};
struct Needs {
  Outputs out = {};
  Inputs in = {};
  SkinningRules skin = {};
};

}  // namespace sinew
