// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/animation/pose_reference.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

inline constexpr const char* kReferenceHelp =
    "rest: the transforms of the nodes; bind: the pose in which meshes were bound to their skins;\n"
    "CLIP@SECONDS: a frame of a clip, by index or name. ";

/// Reads `--reference rest|bind|CLIP@SECONDS`; without the option it is empty, and the map chooses.
/// out   [J] local transforms
/// err   a sentence for the user
tl::expected<std::vector<Transform>, std::string> read_reference(const Scene& scene,
                                                                 const std::optional<std::string>& wanted);

/// The name of a reference pose for messages, such as "bind pose"; `wanted` is the user's choice.
std::string reference_text(PoseReference reference, const std::optional<std::string>& wanted);

/// A warning about nodes that rest elsewhere than where their meshes were bound, by more than 1 % of the body; none for
/// other files.
std::optional<std::string> bind_pose_warning(const Scene& scene);

}  // namespace sinew::tool
