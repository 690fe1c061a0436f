// SPDX-License-Identifier: MIT
#include "viewer/app/clip_extent.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

#include "runtime/model/mesh_copies.h"
#include "runtime/plan/run_plan.h"
#include "viewer/app/cache/cache_playback.h"
#include "viewer/app/skeleton_lines.h"

namespace sinew::viewer {
namespace {

constexpr int kPoses = 17;

float diagonal(const Aabb& box) { return box.empty() ? -1.0f : glm::length(box.upper - box.lower); }

// Replaces a point by a cube around it, so that lengths derived from the box are never zero.
void give_extent(Aabb& box) {
  if (box.empty() || diagonal(box) > 0.0f) return;
  const float half = glm::length(box.lower) > 0.0f ? 0.01f * glm::length(box.lower) : 0.5f;
  box.lower -= half;
  box.upper += half;
}

}  // namespace

Aabb bounds_of(const Scene& scene, const FrameResult& frame) {
  Aabb box;
  for (std::size_t i = 0; i < frame.instances.size(); ++i) {
    const InstanceResult& instance = frame.instances[i];
    if (!instance.visible) continue;
    const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const DeformedPrimitive& deformed = frame.primitives[instance.first_primitive + p];
      const Primitive& primitive = mesh.primitives[p];
      const std::span<const glm::vec3> positions =
          deformed.positions.empty() ? primitive.positions : deformed.positions;
      for_each_copy(scene.instances[i], instance.world_from_mesh, [&](const Affine& world_from_copy) {
        for (const std::uint32_t v : primitive.indices) box.add(transform_point(world_from_copy, positions[v]));
      });
    }
  }
  return box;
}

ClipExtent clip_extent(const Scene& scene, std::uint32_t clip, const CacheOnScene* cache) {
  Needs needs;
  needs.normals = needs.tangents = false;
  std::optional<CachePlayback> played;
  if (cache) {
    needs.cached_instances = cache->instances();
    played.emplace(*cache, scene, CacheReader::Reads::at_once);
  }
  const Plan plan = compile_plan(scene, needs);
  FrameBuffer frame(plan);
  const double duration = std::max(clip < scene.animations.size() ? scene.animations[clip].duration_s : 0.0,
                                   cache ? cache->duration_s() : 0.0);
  const int poses = duration > 0.0 ? kPoses : 1;
  ClipExtent bounds;
  for (int i = 0; i < poses; ++i) {
    const double time_s = poses > 1 ? duration * i / (poses - 1) : 0.0;
    const ClipLayer layer{clip, time_s, 1.0f};
    FrameInput input;
    if (played) input.geometry = played->at(time_s, 1.0f);
    if (clip < scene.animations.size()) input.layers = {&layer, 1};
    if (run_plan(plan, input, frame) != ErrorCode::ok) continue;
    const FrameResult& pose = frame.result();
    Aabb box = bounds_of(scene, pose);
    bounds.outline.add(scene, pose, box);
    if (box.empty()) {
      box = bounds_of_joints(pose.model);
      for (const auto& m : pose.model) bounds.outline.add(translation_of(m));
    }
    if (box.empty()) continue;
    if (diagonal(box) > diagonal(bounds.largest)) bounds.largest = box;
    bounds.reached.add(box.lower);
    bounds.reached.add(box.upper);
  }
  if (diagonal(bounds.largest) <= 0.0f) bounds.largest = bounds.reached;  // a point that moves
  give_extent(bounds.reached);
  give_extent(bounds.largest);
  return bounds;
}

}  // namespace sinew::viewer
