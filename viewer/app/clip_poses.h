// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/plan/frame_result.h"
#include "viewer/app/cache/cache_on_scene.h"

namespace sinew::viewer {

/// Times spread evenly over a clip and its geometry cache, the first and the last included; one where nothing moves.
/// in   clip   kNone = the rest pose;   cache  null = none
std::vector<double> times_over(const Scene& scene, std::uint32_t clip, const CacheOnScene* cache);

/// Evaluates the pose at each time, with the geometry cache at full weight, and without normals.
/// cost one evaluation each
void for_each_pose(const Scene& scene, std::uint32_t clip, const CacheOnScene* cache, std::span<const double> times_s,
                   const std::function<void(const FrameResult& pose)>& visit);

}  // namespace sinew::viewer
