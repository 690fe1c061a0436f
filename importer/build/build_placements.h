// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "importer/build/joint_order.h"
#include "importer/issue_log.h"
#include "runtime/model/scene.h"

namespace sinew {

/// Where the file's cameras and lights are in the scene: one that several nodes name is there several times.
struct Placements {
  std::vector<std::vector<std::uint32_t>> of_camera, of_light;

  /// What a property of the file is in the scene: `target.index` is the file's. Empty when nothing shows it.
  std::vector<std::uint32_t> indices_in_scene(const PropertyTarget& target, const JointOrder& order) const;
};

/// What hangs on nodes beside meshes, which nodes are not shown (KHR_node_visibility), and which roots each scene
/// shows: fills cameras, lights (KHR_lights_punctual), hidden_joints, scenes and default_scene (the file's, else the
/// first; G56). warning camera-values, light-values: those that make no sense take the default; extension-value
Placements build_placements(const gltf::Document& document, const JointOrder& order, Scene& scene, IssueLog& log);

}  // namespace sinew
