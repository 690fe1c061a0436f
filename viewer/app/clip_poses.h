// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/plan/frame_result.h"
#include "viewer/app/cache/cache_on_scene.h"
#include "viewer/app/motion/motion_settings.h"

namespace sinew::viewer {

struct CharacterRig;

/// The motion of a character besides its clip: layers, root motion or a graph. Springs are left out, since they reach
/// little farther than the pose.
struct MovedBy {
  std::shared_ptr<const CharacterRig> rig;
  MotionSettings settings;
  double duration_s = 0.0;  ///< of a play beyond the end of the clip: by a graph, or with RootPlay::moving
};

/// 17 times spread evenly over the longer of the clip and its geometry cache, both ends included. Returns only 0 if the
/// duration is 0.
/// in   clip   kNone = the rest pose;   cache, moved  null = none
std::vector<double> pose_times(const Scene& scene, std::uint32_t clip, const CacheOnScene* cache,
                               const MovedBy* moved = nullptr);

/// Calls `visit` with the pose at each time. The geometry cache has full weight; normals are not computed.
/// cost one evaluation for each time
void for_each_pose(const Scene& scene, std::uint32_t clip, const CacheOnScene* cache, std::span<const double> times_s,
                   const std::function<void(const FrameResult& pose)>& visit, const MovedBy* moved = nullptr);

}  // namespace sinew::viewer
