// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>

#include <glm/vec3.hpp>

#include "runtime/model/scene.h"
#include "runtime/plan/frame_result.h"

namespace sinew::viewer {

/// Casts rays against the opaque triangles of a frame: the reference for screen-space occlusion. As in pictures, rays
/// pass through back faces unless the material is double-sided.
class RayCaster {
 public:
  /// err  std::runtime_error when Embree has no memory
  RayCaster(const Scene& scene, const FrameResult& frame);
  ~RayCaster();

  struct Seen {
    glm::dvec3 point{0.0}, normal{0.0};  ///< world space; unit, interpolated between vertices, on the viewer's side
    glm::dvec3 geometric{0.0};           ///< unit normal of the triangle, on the viewer's side
  };

  /// The nearest surface that a ray hits.
  std::optional<Seen> seen(const glm::dvec3& from, const glm::dvec3& direction) const;

  /// Ambient access of a point: the fraction of ambient light that arrives when only geometry nearer than `radius_m`
  /// blocks it.
  /// eq   fraction of `ray_count` rays without a hit; directions have density cos / pi about the normal (Hammersley
  ///      points)
  double open_share(const Seen& at, double radius_m, int ray_count) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew::viewer
