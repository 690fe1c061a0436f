// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/model/scene.h"

namespace sinew::tool {

/// All clips of a scene with left and right exchanged.
struct MirroredClips {
  std::vector<Animation> animations;       ///< parallel to Scene::animations
  std::vector<std::uint32_t> channels_to;  ///< RewriteOptions::channels_to
  std::string summary;  ///< plane, how many joints have partners, and the names of those that lack one
};

MirroredClips mirror_clips(const Scene& scene);

}  // namespace sinew::tool
