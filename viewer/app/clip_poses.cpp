// SPDX-License-Identifier: MIT
#include "viewer/app/clip_poses.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "runtime/plan/run_plan.h"
#include "viewer/app/cache/cache_playback.h"
#include "viewer/app/motion/motion.h"

namespace sinew::viewer {

std::vector<double> pose_times(const Scene& scene, std::uint32_t clip, const CacheOnScene* cache,
                               const MovedBy* moved) {
  constexpr int kPoses = 17;
  const double duration = std::max(clip < scene.animations.size() ? scene.animations[clip].duration_s : 0.0,
                                   std::max(cache ? cache->duration_s() : 0.0, moved ? moved->duration_s : 0.0));
  if (!(duration > 0.0)) return {0.0};
  std::vector<double> times;
  for (int i = 0; i < kPoses; ++i) times.push_back(duration * i / (kPoses - 1));
  return times;
}

void for_each_pose(const Scene& scene, std::uint32_t clip, const CacheOnScene* cache, std::span<const double> times_s,
                   const std::function<void(const FrameResult& pose)>& visit, const MovedBy* moved) {
  Needs needs;
  needs.out.normals = needs.out.tangents = false;
  std::optional<CachePlayback> played;
  if (cache) {
    needs.in.cached_instances = cache->instances();
    played.emplace(*cache, scene, CacheReader::Reads::blocking);
  }
  std::optional<Motion> motion;
  if (moved) {
    MotionSettings settings = moved->settings;
    settings.springs = false;
    motion.emplace(scene, moved->rig, std::move(settings));
    add_motion_needs(motion->shape(), scene, moved->rig.get(), needs);
  }
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer frame(plan);
  for (const double time_s : times_s) {
    const ClipLayer layer{clip, time_s, 1.0f};
    FrameInput input;
    if (played) input.geometry = played->at(time_s, 1.0f);
    if (motion && motion->writes_program())
      motion->write(moment_at(scene, clip, time_s), input);
    else if (clip < scene.animations.size())
      input.layers = {&layer, 1};
    if (run_plan(plan, input, frame) == ErrorCode::ok) visit(frame.result());
  }
}

}  // namespace sinew::viewer
