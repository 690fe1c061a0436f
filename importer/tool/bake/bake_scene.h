// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "importer/geometry_cache/geometry_take.h"
#include "importer/tool/bake/take_source.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

/// So that a typing error in --fps does not fill the memory.
inline constexpr std::size_t kMostBakedFrames = 1'000'000;

struct BakedScene {
  GeometryTake take;
  std::vector<std::string> left_out;  ///< what of the scene is not in the take, a sentence each
};

/// Every triangle mesh of a scene while a clip plays, in world space, as a frame shows it. Also between frames, to
/// measure what interpolation costs. Normals and colours where budgets ask for them and a mesh has them.
/// in   clip         kNone = the rest pose, one frame
///      most_frames  the first ones; kMostBakedFrames: all, or an error
/// err  a sentence
tl::expected<BakedScene, std::string> bake_scene(const Scene& scene, std::uint32_t clip, double fps,
                                                 const TakeBudgets& budgets,
                                                 std::size_t most_frames = kMostBakedFrames);

}  // namespace sinew::tool
