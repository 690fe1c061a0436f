// SPDX-License-Identifier: MIT
#include "viewer/app/clip_extent.h"

#include <glm/geometric.hpp>

#include "runtime/model/scene.h"
#include "viewer/app/skeleton_lines.h"

namespace sinew::viewer {
namespace {

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

ClipExtent clip_extent(const Scene& scene, std::uint32_t clip, const CacheOnScene* cache, const MovedBy* moved) {
  ClipExtent bounds;
  const std::vector<bool> joints = joints_of_skeleton(scene);
  for_each_pose(
      scene, clip, cache, pose_times(scene, clip, cache, moved),
      [&](const FrameResult& pose) {
        Aabb box = bounds_of(scene, pose);
        bounds.outline.add(scene, pose, box);
        if (box.empty())
          for (const glm::vec3& place : places_of(joints, pose.model)) {
            box.add(place);
            bounds.outline.add(place);
          }
        if (box.empty()) return;
        if (diagonal(box) > diagonal(bounds.largest)) bounds.largest = box;
        bounds.reached.add(box.lower);
        bounds.reached.add(box.upper);
      },
      moved);
  if (diagonal(bounds.largest) <= 0.0f) bounds.largest = bounds.reached;  // every pose is a single point, but it moves
  if (diagonal(bounds.reached) == 0.0f) {
    give_extent(bounds.reached);
    const glm::vec3 &low = bounds.reached.lower, &high = bounds.reached.upper;
    for (const float x : {low.x, high.x})
      for (const float y : {low.y, high.y})
        for (const float z : {low.z, high.z}) bounds.outline.add({x, y, z});
  }
  give_extent(bounds.largest);
  return bounds;
}

}  // namespace sinew::viewer
