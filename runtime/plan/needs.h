// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/deform/skin_linear.h"
#include "runtime/plan/skeleton_lod.h"

namespace sinew {

/// How skinned vertices follow their joints. `center_of_rotation` needs Primitive::centers_of_rotation; a primitive
/// that has none is skinned linearly, which is what a vertex without a center gets too (N21).
enum class Skinning : std::uint8_t { linear, dual_quaternion, center_of_rotation };

/// What the consumer of frames asks for. A stage that neither the needs nor the scene call for is left out of the plan.
struct Needs {
  bool joints = true;     ///< model matrices of the joints that `skeleton_lod` keeps
  bool positions = true;  ///< deformed vertex positions
  bool normals = true;
  bool tangents = true;
  bool weights = true;           ///< morph weights with the correctives, for consumers that morph vertices themselves
  bool palettes = false;         ///< skinning matrices of the skins in use, for consumers that skin vertices themselves
  bool bounds = false;           ///< boxes of the mesh instances (P14)
  bool properties = true;        ///< animated numbers of materials, lights and cameras (P15)
  bool hidden_meshes = false;    ///< deform meshes on hidden joints as well
  bool stage_times = false;      ///< what each stage takes, for people who look; reads the clock a few times per frame
  std::uint32_t max_layers = 4;  ///< most clip layers in one frame; 1 = no blending stage and no memory for it (P06)
                                 ///< Layers that add do not count
  bool additive = false;         ///< some layers add to the pose
  std::uint32_t max_additive_layers = 8;  ///< most of those in one frame, where `additive`
  bool between_updates = false;           ///< some frames lie between two poses (FrameInput::interpolation_factor)
  std::vector<std::vector<float>> masks;  ///< [any][J] joint weights >= 0 that layers may name
  SkeletonLod skeleton_lod;               ///< joints that poses can do without
  Skinning skinning = Skinning::linear;
  std::vector<Skinning> instance_skinning;  ///< [instances] overrides `skinning` per mesh instance; empty = no override
  NormalRule normal_rule = NormalRule::linear;  ///< of linear blending; the other kinds turn normals exactly

  Skinning skinning_of(std::size_t instance) const noexcept {
    return instance < instance_skinning.size() ? instance_skinning[instance] : skinning;
  }
  /// Most layers of one frame, of both kinds; frames keep room for so many.
  std::size_t layer_room() const noexcept {
    return std::size_t{max_layers} + (additive ? std::size_t{max_additive_layers} : 0);
  }
  /// Something about the meshes themselves, not just joints and weights.
  bool vertices() const noexcept { return positions || normals || tangents || bounds; }
};

}  // namespace sinew
