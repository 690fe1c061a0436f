// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/scene.h"

namespace sinew::test {

/// Contents of a random scene: one switch for each optional feature of a plan.
struct RandomSceneOptions {
  std::uint32_t joints = 14;
  std::uint32_t clips = 2;
  std::uint32_t skins = 2;    ///< 0 = no mesh is skinned
  std::uint32_t targets = 3;  ///< morph targets of each mesh, 0 = none
  std::uint32_t meshes = 2;
  std::uint32_t instances = 4;   ///< every second one is skinned, if there are skins
  std::uint32_t triangles = 40;  ///< of each primitive
  std::uint32_t most_influences = 6;
  std::uint32_t combinations = 0;  ///< sets of joints and weights to share; 0 = none are shared
  bool normals = true, tangents = true, colors = true;
  bool flat_normals = false;  ///< on every second primitive
  bool centers = false;       ///< centers of rotation for skinned meshes
  bool mirrored_joints = false;
  std::uint32_t correctives = 0;  ///< needs targets
};

/// A valid, finished scene with every kind of track. The same seed gives the same scene on every machine. Rotations
/// stay within 60 degrees of the rest pose, so that a blend has only one shortest way.
Scene random_scene(std::uint64_t seed, const RandomSceneOptions& options = {});

/// Removes the tracks of two joints in three. In the first clip some of these joints are held away from their rest
/// pose.
void move_few_joints(Scene& scene);

}  // namespace sinew::test
