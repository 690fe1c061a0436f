// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "importer/build/joint_order.h"
#include "importer/issue_log.h"
#include "runtime/model/scene.h"

namespace sinew {

/// Which cameras and lights of the scene come from each camera and light of the file. A camera or light that several
/// nodes use is in the scene once for each node.
struct Placements {
  std::vector<std::vector<std::uint32_t>> of_camera, of_light;

  /// Where an animated property of the file is in the scene.
  /// in    target   `target.index` counts in the file
  /// out   indices in the scene; empty when nothing shows the property
  std::vector<std::uint32_t> indices_in_scene(const PropertyTarget& target, const JointOrder& order) const;
};

/// Fills what hangs on nodes besides meshes: cameras, lights (KHR_lights_punctual), hidden_joints
/// (KHR_node_visibility), and the roots that each scene shows. default_scene is the file's, else the first one (G56).
/// warning  camera-values, light-values (senseless values take the default), extension-value
Placements build_placements(const gltf::Document& document, const JointOrder& order, Scene& scene, IssueLog& log);

}  // namespace sinew
