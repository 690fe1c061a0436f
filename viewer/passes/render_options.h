// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>

#include "runtime/model/mesh.h"
#include "viewer/light/environment.h"

namespace sinew::viewer {

/// What the picture shows: the lit scene, or one of the buffers between passes.
enum class Show : std::uint8_t {
  color,
  ao,       ///< ambient access in grey, white = nothing is occluded
  normals,  ///< view space, n * 0.5 + 0.5
  depth,    ///< distance in grey within depth_range, near = bright
  level     ///< mip or rip levels of the base colour: red 0.1 a level along u, green along v; blue = no texture
};

/// What the colours of surfaces say.
enum class Shading : std::uint8_t {
  physical,  ///< the light that they reflect
  gooch      ///< their shape: cool to warm tones with outlines, as in technical illustrations
};

/// How normals and tangent frames lie between the vertices of a triangle.
enum class NormalInterpolation : std::uint8_t {
  interpolated,  ///< linear, then of unit length again
  quaternion     ///< as quaternions (Hast 2005): of unit length without a square root
};

/// How surfaces whose alpha is coverage lie over each other.
enum class Transparency : std::uint8_t {
  sorted,   ///< primitives from far to near: exact where they do not intersect
  weighted  ///< in any order: a mean of their colours in which near ones weigh more (McGuire and Bavoil 2013)
};

/// How light of the scene becomes light of the display.
enum class ToneCurve : std::uint8_t {
  neutral,  ///< Khronos PBR Neutral: keeps base colours, compresses highlights
  aces,     ///< film-like: Hill's fit of ACES' reference and output transforms
  none      ///< clipped at 1
};

/// What is behind the scene.
enum class Backdrop : std::uint8_t {
  plain,    ///< RenderOptions::background
  blurred,  ///< the environment, out of focus
  sharp     ///< the environment
};

/// How ambient occlusion looks for what is in the way.
enum class OcclusionMethod : std::uint8_t {
  ssao,  ///< points around the surface, looked up in the depth image
  gtao,  ///< horizons along lines through the pixel
  rays   ///< nothing: it was baked at the vertices (VertexAccess)
};

/// Ambient occlusion in screen space or at vertices. Lengths are metres in view space. They must follow the size of the
/// scene: start from ambient_occlusion_for.
struct AmbientOcclusion {
  bool on = true;
  OcclusionMethod method = OcclusionMethod::gtao;
  float radius_m = 0.5f;            ///< distance up to which geometry occludes
  float surface_epsilon_m = 0.01f;  ///< smaller differences of depth are the surface itself
  float fade_start_m = 0.2f;        ///< ssao: difference of depth up to which an occluder counts fully
  float fade_end_m = 1.0f;          ///< ssao: difference of depth from which it does not count
  float power = 1.0f;               ///< contrast: access = open share^power; ssao: (1 - average occlusion)^(2 power)
  bool blur = true;

  /// It is on and not of strength 0.
  bool has_effect() const noexcept { return on && power > 0.0f && radius_m > 0.0f; }
  bool in_screen_space() const noexcept { return has_effect() && method != OcclusionMethod::rays; }
  bool at_vertices() const noexcept { return has_effect() && method == OcclusionMethod::rays; }
};

/// eq   radius = 0.1 * r, epsilon = 0.02 * radius, fade from 0.4 to 2 times the radius; r = half the box's diagonal
AmbientOcclusion ambient_occlusion_for(const Aabb& bounds);

/// Ambient light, and the key light that is used when the scene has no lights. Linear colours.
struct Lighting {
  glm::vec3 to_key{0.45f, 0.8f,
                   0.4f};  ///< direction to the key light: world space, or view space if it follows the camera
  bool key_follows_camera = false;
  glm::vec3 key{1.75f, 1.68f, 1.58f};  ///< irradiance on a surface that faces the light
  std::shared_ptr<const Environment> environment = plain_environment();  ///< ambient light; null = none
  float environment_intensity = 1.0f;
  float environment_turn_rad = 0.0f;  ///< turns the environment about +y, counter-clockwise from above
  bool scene_lights =
      true;  ///< use the lights of the scene (KHR_lights_punctual) instead of the key light, if it has any
  float exposure = 1.0f;
  bool auto_exposure = false;  ///< `exposure` is times what makes the log average of the picture middle grey
  ToneCurve tone_curve = ToneCurve::neutral;

  bool ambient() const noexcept { return environment && environment_intensity > 0.0f; }
};

/// Shadows of the directional and spot lights of the scene, four at most, or of the key light.
struct Shadows {
  bool on = false;
  Aabb bounds;  ///< world space: everything that casts or receives them; empty = none
};

enum class GroundLook : std::uint8_t {
  none,
  shadows,  ///< shadows and contact alone: what is behind is seen through the ground
  grid      ///< a grid besides
};

/// A level ground below the scene.
struct Ground {
  GroundLook look = GroundLook::none;
  Aabb bounds;               ///< world space: what casts shadows on it
  glm::dvec3 middle{0.0};    ///< world space
  float radius_m = 1.0f;     ///< it fades out from 0.6 of this distance to all of it
  float grid_step_m = 1.0f;  ///< lines are at multiples of this, in world space
};

/// Just below the bounds, so that feet do not touch it; as wide as shadows of a high light reach. Without a look.
/// eq   radius = 1.5 * diagonal; the step is the largest power of 10 that has at least 3 lines in the radius
Ground ground_for(const Aabb& bounds);

/// Distances from the plane of the eye.
struct DepthRange {
  float nearest_m = 0.0f, farthest_m = 10.0f;
};

struct RenderOptions {
  Show show = Show::color;
  Shading shading = Shading::physical;
  NormalInterpolation normals = NormalInterpolation::interpolated;
  Transparency transparency = Transparency::sorted;
  AmbientOcclusion ao;
  Lighting lighting;
  Shadows shadows;
  Ground ground;
  DepthRange depth_range;     ///< for Show::depth
  bool smooth_edges = false;  ///< coverage and depth of 4 samples a pixel; shading stays one a pixel
  Backdrop backdrop = Backdrop::plain;
  bool transparent_background = false;        ///< alpha 0 where nothing was drawn
  glm::vec3 background{0.13f, 0.14f, 0.16f};  ///< sRGB, as displayed
};

/// Options for a scene of these bounds seen from `eye`: lengths of ambient occlusion, ground, and depth range.
RenderOptions render_options_for(const Aabb& bounds, const glm::dvec3& eye);

}  // namespace sinew::viewer
