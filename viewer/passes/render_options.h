// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/mesh.h"

namespace sinew::viewer {

/// What the picture shows: the lit scene, or one of the buffers that the passes work with.
enum class Show : std::uint8_t {
  color,
  ao,       ///< ambient access in grey, 1 = open
  normals,  ///< view space, n * 0.5 + 0.5
  depth     ///< distance in grey between DepthRange, near = bright
};

/// Screen-space ambient occlusion. All lengths are metres in view space; they must follow the scene's size, so start
/// from `ambient_occlusion_for`.
struct AmbientOcclusion {
  bool on = true;
  float radius_m = 0.5f;            ///< how far a blocker can be
  float surface_epsilon_m = 0.01f;  ///< blockers nearer than this in depth are the surface itself
  float fade_start_m = 0.2f;        ///< depth distance up to which a blocker counts fully
  float fade_end_m = 1.0f;          ///< and from which on not at all
  float power = 2.0f;               ///< contrast: access = (1 - average occlusion)^power
  bool blur = true;

  /// Not switched off, nor of strength 0, which is the same (P17).
  bool has_effect() const noexcept { return on && power > 0.0f && radius_m > 0.0f; }
};

/// eq   radius = 0.1 * r, epsilon = 0.02 * radius, fade from 0.4 to 2 times the radius; r = half the box's diagonal
AmbientOcclusion ambient_occlusion_for(const Aabb& bounds);

/// Light used when the scene brings none of its own, and the ambient term always. Linear colours.
struct Lighting {
  glm::vec3 to_key{0.45f, 0.8f, 0.4f};  ///< towards the key light, world space unless it follows the camera
  bool key_follows_camera = false;
  glm::vec3 key{1.75f, 1.68f, 1.58f};     ///< irradiance on a surface that faces the light
  glm::vec3 sky{0.46f, 0.50f, 0.57f};     ///< ambient radiance from above ...
  glm::vec3 ground{0.25f, 0.22f, 0.20f};  ///< ... and from below
  bool scene_lights = true;               ///< use KHR_lights_punctual instead of the key where the scene has any
  float exposure = 1.0f;

  bool ambient() const noexcept { return sky != glm::vec3(0.0f) || ground != glm::vec3(0.0f); }
};

struct DepthRange {
  float nearest_m = 0.0f, farthest_m = 10.0f;
};

struct RenderOptions {
  Show show = Show::color;
  AmbientOcclusion ao;
  Lighting lighting;
  DepthRange depth_range;                     ///< of Show::depth
  bool transparent_background = false;        ///< alpha 0 where nothing was drawn
  glm::vec3 background{0.13f, 0.14f, 0.16f};  ///< sRGB, as displayed
};

/// Options for a scene of this size seen from this far: ambient occlusion lengths and the depth range.
RenderOptions render_options_for(const Aabb& bounds, const glm::dvec3& eye);

}  // namespace sinew::viewer
