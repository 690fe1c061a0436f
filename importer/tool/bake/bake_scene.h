// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "importer/geometry_cache/geometry_take.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

struct BakedScene {
  GeometryTake take;
  std::vector<std::string> left_out;  ///< what of the scene is not in the take, a sentence each
};

/// Every triangle mesh of a scene while a clip plays, in world space, as a frame shows it. Also between frames, to
/// measure what interpolation costs.
/// in   clip  kNone = the rest pose, one frame
/// err  a sentence
tl::expected<BakedScene, std::string> bake_scene(const Scene& scene, std::uint32_t clip, double fps, double budget_m);

}  // namespace sinew::tool
