// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "importer/build/joint_order.h"
#include "importer/issue_log.h"
#include "runtime/model/scene.h"

namespace sinew {

/// Maps cameras and lights of the file to those of the scene. A camera or light used by several nodes is copied for
/// each node.
struct Placements {
  std::vector<std::vector<std::uint32_t>> of_camera, of_light;

  /// Finds the scene counterparts of an animated property of the file.
  /// in    target   `target.index` is an index in the file
  /// out   indices in the scene; empty if the property is not used
  std::vector<std::uint32_t> indices_in_scene(const PropertyTarget& target, const JointOrder& order) const;
};

/// Fills in what is attached to nodes besides meshes: cameras, lights (KHR_lights_punctual), hidden_joints
/// (KHR_node_visibility), and the roots of each scene. default_scene is the file's, else the first one.
/// warning  camera-values, light-values (invalid values become the default), extension-value
Placements build_placements(const gltf::Document& document, const JointOrder& order, Scene& scene, IssueLog& log);

}  // namespace sinew
