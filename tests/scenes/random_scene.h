// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/scene.h"

namespace sinew::test {

/// Contents of a random scene: one switch for each feature that a plan can call for or leave out.
struct RandomSceneOptions {
  std::uint32_t joints = 14;
  std::uint32_t clips = 2;
  std::uint32_t skins = 2;    ///< 0 = no mesh is skinned
  std::uint32_t targets = 3;  ///< morph targets of each mesh, 0 = none
  std::uint32_t meshes = 2;
  std::uint32_t instances = 4;   ///< every other one is skinned, if there are skins
  std::uint32_t triangles = 40;  ///< of each primitive
  std::uint32_t most_influences = 6;
  std::uint32_t combinations = 0;  ///< of joints and weights that vertices share; 0 = each vertex has its own
  bool normals = true, tangents = true, colors = true;
  bool flat_normals = false;  ///< every second primitive
  bool centers = false;       ///< of rotation, for skinned meshes
  bool mirrored_joints = false;
  std::uint32_t correctives = 0;  ///< needs targets
};

/// A valid, finished scene with every kind of track, from random numbers that are the same on every machine.
/// Its rotations stay within 60 degrees of the rest pose, so that blends have one meaning.
Scene random_scene(std::uint64_t seed, const RandomSceneOptions& options = {});

/// Leaves tracks on every third joint. The first clip holds some of the others elsewhere than at rest.
void move_few_joints(Scene& scene);

}  // namespace sinew::test
