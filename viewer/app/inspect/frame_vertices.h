// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

#include "runtime/model/scene.h"
#include "runtime/plan/frame_result.h"

namespace sinew::viewer {

/// The vertices of a primitive in a frame: deformed, or as they rest.
/// in   primitive  index into FrameResult::primitives;   rest  the same primitive of the scene
inline std::span<const glm::vec3> positions_of(const FrameResult& frame, std::size_t primitive, const Primitive& rest) {
  const std::span<const glm::vec3> deformed = frame.primitives[primitive].positions;
  return deformed.empty() ? std::span<const glm::vec3>(rest.positions) : deformed;
}

/// Calls `visit(index, primitive, instance)` for each primitive of each visible instance.
template <class Visit>
void for_each_primitive(const Scene& scene, const FrameResult& frame, const Visit& visit) {
  for (std::size_t i = 0; i < frame.instances.size(); ++i) {
    if (!frame.instances[i].visible) continue;
    const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p)
      visit(frame.instances[i].first_primitive + p, mesh.primitives[p], i);
  }
}

}  // namespace sinew::viewer
