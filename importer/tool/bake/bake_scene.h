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

/// Most frames of one bake. The limit keeps a typing error in --fps from filling the memory.
inline constexpr std::size_t kMostBakedFrames = 1'000'000;

struct BakedScene {
  GeometryTake take;
  std::vector<std::string> left_out;  ///< a sentence for each part of the scene that is not in the take
};

/// Samples every triangle mesh of a scene while a clip plays, in world space, as frames show it. Also samples between
/// frames, to measure the error of interpolation. Samples normals and colours if budgets ask for them and a mesh has
/// them.
/// in   clip         kNone = the rest pose, one frame
///      most_frames  no more than the first frames are sampled; more than kMostBakedFrames in the clip are an error
/// err  a sentence for the user
tl::expected<BakedScene, std::string> bake_scene(const Scene& scene, std::uint32_t clip, double fps,
                                                 const TakeBudgets& budgets,
                                                 std::size_t most_frames = kMostBakedFrames);

}  // namespace sinew::tool
