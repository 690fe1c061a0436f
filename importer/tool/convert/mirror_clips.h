// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/model/scene.h"

namespace sinew::tool {

/// All clips of a scene with left and right exchanged.
struct MirroredClips {
  std::vector<Animation> animations;       ///< parallel to Scene::animations
  std::vector<std::uint32_t> channels_to;  ///< RewriteOptions::channels_to
  std::string summary;  ///< plane, how many joints have partners, the names of those that lack one, reference pose
};

/// Mirrors all clips of a scene.
/// in   reference  rest, bind or CLIP@SECONDS (reference_choice.h); nullopt = chosen
/// err  a sentence for the user about `reference`
tl::expected<MirroredClips, std::string> mirror_clips(const Scene& scene, const std::optional<std::string>& reference);

}  // namespace sinew::tool
