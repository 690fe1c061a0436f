// SPDX-License-Identifier: MIT
#pragma once
#include "importer/build/joint_order.h"
#include "importer/issue_log.h"
#include "runtime/assets/scene.h"

namespace sinew {

/// What hangs on nodes beside meshes, and which roots each scene shows: fills cameras, lights (KHR_lights_punctual),
/// scenes and default_scene (the file's, else the first; G56).
/// warning camera-values, light-values: those that make no sense take the default
void build_placements(const gltf::Document& document, const JointOrder& order, Scene& scene, IssueLog& log);

}  // namespace sinew
