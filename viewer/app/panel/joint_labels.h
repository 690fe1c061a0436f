// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/model/scene.h"
#include "viewer/passes/view.h"

namespace sinew::viewer {

/// Writes the names of a scene's joints beside them, behind all panels, if the scene has no meshes. A name that would
/// cover an earlier one is left out. An ImGui frame must have begun.
/// in   model[J]  world matrices
/// cost O(J * names shown)
void lay_out_joint_labels(const Scene& scene, std::span<const Affine> model, const View& view);

}  // namespace sinew::viewer
