// SPDX-License-Identifier: MIT
#include "viewer/app/camera/frustum_culling.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "viewer/passes/render_options.h"

namespace sinew::viewer {

bool CulledInstances::culls_more_than(const CulledInstances& other) const noexcept {
  for (std::size_t i = 0; i < out_of_view.size(); ++i)
    if (out_of_view[i] > other.out_of_view[i]) return true;
  return false;
}

namespace {

/// Bounds of the box swept along a vector.
Aabb swept(const Aabb& box, const glm::vec3& way) {
  if (box.empty()) return box;
  Aabb all = box;
  all.add(box.lower + way);
  all.add(box.upper + way);
  return all;
}

}  // namespace

CulledInstances FrustumCulling::of(std::uint32_t clip, const View& view, double aspect,
                                   const std::optional<glm::vec3>& shadow) {
  if (!shadow) return all_in_view();
  const bool plays = clip < scene_->animations.size();
  auto& bounds = plays ? bounds_[clip] : bounds_.back();
  if (!bounds) {
    bounds = clip_bounds(*scene_, needs_, plays ? clip : kNone);
    for (std::size_t i = 0; i < reach_.size(); ++i) {
      if (reach_[i].empty()) continue;
      (*bounds)[i].add(reach_[i].lower);
      (*bounds)[i].add(reach_[i].upper);
    }
  }
  CulledInstances culled = all_in_view();
  for (std::size_t i = 0; i < bounds->size(); ++i)
    culled.out_of_view[i] = is_out_of_view(view, aspect, view.view_from_world, swept((*bounds)[i], *shadow));
  culled.every_instance = !bounds->empty() && std::find(culled.out_of_view.begin(), culled.out_of_view.end(), 0) ==
                                                  culled.out_of_view.end();
  return culled;
}

std::optional<glm::vec3> shadow_sweep(const Scene& scene, bool shadows, const Aabb& reached,
                                      const Environment* environment) {
  if (!shadows || reached.empty()) return glm::vec3(0.0f);
  if (std::any_of(scene.lights.begin(), scene.lights.end(),
                  [](const Light& light) { return light.kind != Light::Kind::point; }))
    return std::nullopt;
  if (!scene.lights.empty()) return glm::vec3(0.0f);
  const bool has_key = environment != nullptr && environment->key;
  if (has_key && environment->key->irradiance == glm::vec3(0.0f)) return glm::vec3(0.0f);
  const glm::vec3 to_key = glm::normalize(has_key ? environment->key->to_light : Lighting{}.to_key);
  return -to_key * glm::length(reached.upper - reached.lower) /
         to_key.y;  // long enough to reach the ground from the highest point
}

void apply_culling(const CulledInstances& culled, bool joints_needed, FrameInput& input) {
  input.out_of_view = culled.out_of_view;
  input.asleep = culled.every_instance && !joints_needed;
}

}  // namespace sinew::viewer
