// SPDX-License-Identifier: MIT
#include "viewer/app/camera/framing.h"

#include <algorithm>

#include "runtime/math/interpolate.h"
#include "viewer/app/clip_poses.h"
#include "viewer/app/skeleton_lines.h"

namespace sinew::viewer {

glm::dvec3 Framed::offset_at(double time_s) const noexcept {
  const auto last = static_cast<double>(path.size() - 1);
  if (!(duration_s > 0.0) || !(time_s > 0.0)) return glm::dvec3(path.front());
  const double at = std::min(time_s / duration_s, 1.0) * last;
  const auto before = std::min(static_cast<std::size_t>(at), path.size() - 1);
  const glm::dvec3 from(path[before]), to(path[std::min(before + 1, path.size() - 1)]);
  return lerp(from, to, at - static_cast<double>(before));
}

Framed framed(Framing framing, const Scene& scene, std::uint32_t clip, double time_s, const CacheOnScene* cache,
              const MovedBy* moved) {
  Framed out;
  std::vector<double> times = pose_times(scene, clip, cache, moved);
  if (framing == Framing::pose) times = {time_s};
  const bool follow = framing == Framing::follow;
  const std::vector<bool> joints = joints_of_skeleton(scene);
  if (follow) {
    out.duration_s = times.back();
    out.path.clear();
  }
  for_each_pose(
      scene, clip, cache, times,
      [&](const FrameResult& pose) {
        const Aabb drawn = bounds_of(scene, pose);
        Aabb box = drawn;
        const std::vector<glm::vec3> places = drawn.empty() ? places_of(joints, pose.model) : std::vector<glm::vec3>();
        for (const glm::vec3& p : places) box.add(p);
        glm::vec3 place(0.0f);
        if (follow && !box.empty()) place = 0.5f * (box.lower + box.upper) * glm::vec3(1.0f, 0.0f, 1.0f);
        if (follow) out.path.push_back(place);
        out.outline.add(scene, pose, drawn, place);
        for (const glm::vec3& p : places) out.outline.add(p - place);
      },
      moved);
  if (out.path.empty()) out.path.emplace_back(0.0f);
  return out;
}

}  // namespace sinew::viewer
