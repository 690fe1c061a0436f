// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/model/scene.h"
#include "viewer/app/inspect/inspected.h"

namespace sinew::viewer {

/// The colour of a share of the whole: linear, clamped to 0 and 1. Neighbouring shares differ in brightness, too.
glm::vec3 share_color(double share) noexcept;

/// The scene with white, rough materials and a colour for each vertex. Animated properties are left out, because they
/// would hide these colours.
/// in   shares[meshes][primitives][V]
Scene painted_by_shares(const Scene& scene, const std::vector<std::vector<std::vector<float>>>& shares);

/// The scene as Inspected::paint shows it. A mesh that several instances show gets the largest weight of each vertex.
/// in   joint  for Paint::weights; kNone = no weight anywhere
Scene painted(const Scene& scene, Paint paint, std::uint32_t joint);

}  // namespace sinew::viewer
