// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>

#include <glm/vec3.hpp>

#include "runtime/model/scene.h"
#include "runtime/plan/frame_result.h"

namespace sinew::viewer {

/// The opaque triangles of a frame as rays meet them: what screen-space occlusion only guesses at. Back faces are met
/// where the material has two sides, and nowhere else, as in pictures.
class RayCaster {
 public:
  /// err  std::runtime_error when Embree has no memory
  RayCaster(const Scene& scene, const FrameResult& frame);
  ~RayCaster();

  struct Seen {
    glm::dvec3 point{0.0}, normal{0.0};  ///< world space; unit, interpolated between vertices, on the viewer's side
    glm::dvec3 geometric{0.0};           ///< unit normal of the triangle, on the viewer's side
  };

  /// The nearest surface along a ray.
  std::optional<Seen> seen(const glm::dvec3& from, const glm::dvec3& direction) const;

  /// Share of light that comes in when every direction is equally bright and blockers are nearer than `radius_m`.
  /// eq   share of `ray_count` directions, with density cos / pi about the normal (Hammersley points), that meet
  /// nothing
  double open_share(const Seen& at, double radius_m, int ray_count) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew::viewer
