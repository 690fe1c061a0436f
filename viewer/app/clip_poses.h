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

/// 17 times spread evenly over the longer of the clip and its geometry cache, both ends included. Returns only 0 if the
/// duration is 0.
/// in   clip   kNone = the rest pose;   cache  null = none
std::vector<double> pose_times(const Scene& scene, std::uint32_t clip, const CacheOnScene* cache);

/// Calls `visit` with the pose at each time. The geometry cache has full weight; normals are not computed.
/// cost one evaluation for each time
void for_each_pose(const Scene& scene, std::uint32_t clip, const CacheOnScene* cache, std::span<const double> times_s,
                   const std::function<void(const FrameResult& pose)>& visit);

}  // namespace sinew::viewer
