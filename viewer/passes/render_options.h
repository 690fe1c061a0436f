// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>

#include "runtime/model/mesh.h"
#include "viewer/light/environment.h"

namespace sinew::viewer {

/// Displayed content: the lit scene, or an intermediate buffer.
enum class Show : std::uint8_t {
  color,
  ao,       ///< ambient visibility in grey; white = not occluded
  normals,  ///< view space, n * 0.5 + 0.5
  depth,    ///< distance in grey within depth_range, near = bright
  level  ///< sampled mip or rip level of the base colour: red = 0.1 * level along u, green along v; blue = no texture
};

/// Shading model.
enum class Shading : std::uint8_t {
  physical,  ///< physically based lighting
  gooch      ///< Gooch shading: cool to warm tones with outlines, as in technical illustrations
};

/// Interpolation of normals and tangent frames between vertices.
enum class NormalInterpolation : std::uint8_t {
  interpolated,  ///< linear, then normalised
  quaternion     ///< as quaternions (Hast 2005), which gives unit length without a square root
};

/// Compositing of alpha-blended surfaces.
enum class Transparency : std::uint8_t {
  sorted,   ///< primitives sorted from far to near: exact if they do not intersect
  weighted  ///< order-independent: a weighted mean in which near surfaces weigh more (McGuire and Bavoil 2013)
};

/// Curve that maps scene light to display light.
enum class ToneCurve : std::uint8_t {
  neutral,  ///< Khronos PBR Neutral: preserves base colours, compresses highlights
  aces,     ///< filmic: Hill's fit of ACES' reference and output transforms
  none      ///< clipped at 1
};

/// Background of the scene.
enum class Backdrop : std::uint8_t {
  plain,    ///< RenderOptions::background
  blurred,  ///< the environment, out of focus
  sharp     ///< the environment
};

/// Algorithm of ambient occlusion.
enum class OcclusionMethod : std::uint8_t {
  ssao,  ///< random points around the surface, tested against the depth image
  gtao,  ///< horizons along lines through the pixel (ground-truth AO)
  rays   ///< no screen-space pass: baked per vertex by casting rays (VertexVisibility)
};

/// Ambient occlusion in screen space or at vertices. Lengths are metres in view space. They must scale with the scene:
/// start from ambient_occlusion_for.
struct AmbientOcclusion {
  bool on = true;
  OcclusionMethod method = OcclusionMethod::gtao;
  float radius_m = 0.5f;            ///< distance up to which geometry occludes
  float surface_epsilon_m = 0.01f;  ///< smaller differences of depth are the surface itself
  float fade_start_m = 0.2f;        ///< ssao: difference of depth up to which an occluder counts fully
  float fade_end_m = 1.0f;          ///< ssao: difference of depth from which it does not count
  float power = 1.0f;  ///< contrast: visibility = (1 - occlusion)^power; ssao: (1 - mean occlusion)^(2 power)
  bool blur = true;

  /// True if it is on and its strength is not 0.
  bool has_effect() const noexcept { return on && power > 0.0f && radius_m > 0.0f; }
  bool in_screen_space() const noexcept { return has_effect() && method != OcclusionMethod::rays; }
  bool at_vertices() const noexcept { return has_effect() && method == OcclusionMethod::rays; }
};

/// eq   radius = 0.1 * r, epsilon = 0.02 * radius, fade from 0.4 to 2 times the radius; r = half the box's diagonal
AmbientOcclusion ambient_occlusion_for(const Aabb& bounds);

/// Environment light, and the key light that is used if the scene has no lights. Colours are linear.
struct Lighting {
  glm::vec3 to_key{0.45f, 0.8f, 0.4f};  ///< direction to the key light, in view space if it follows the camera
  bool key_follows_camera = false;
  glm::vec3 key{1.75f, 1.68f, 1.58f};                                    ///< irradiance on a surface facing the light
  std::shared_ptr<const Environment> environment = plain_environment();  ///< environment light; null = none
  float environment_intensity = 1.0f;
  float environment_turn_rad = 0.0f;  ///< rotation of the environment about +y, counter-clockwise seen from above
  bool scene_lights = true;  ///< use the scene's lights (KHR_lights_punctual), if any, instead of the key light
  float exposure = 1.0f;
  bool auto_exposure = false;  ///< multiply `exposure` by the factor that maps the picture's log average to middle grey
  ToneCurve tone_curve = ToneCurve::neutral;

  /// Sets the environment, and the key light that belongs to it.
  void use(std::shared_ptr<const Environment> chosen);

  bool ambient() const noexcept { return environment && environment_intensity > 0.0f; }
};

/// Shadows of up to four directional and spot lights of the scene, or of the key light.
struct Shadows {
  bool on = false;
  Aabb bounds;  ///< bounds of all casters and receivers, world space; empty = no shadows
};

enum class GroundLook : std::uint8_t {
  none,
  shadows,  ///< transparent except for shadows and contact occlusion
  grid      ///< shadows and a grid
};

/// A horizontal ground plane below the scene.
struct Ground {
  GroundLook look = GroundLook::none;
  Aabb bounds;               ///< bounds of the shadow casters, world space
  glm::dvec3 middle{0.0};    ///< world space
  float radius_m = 1.0f;     ///< fades out from 0.6 of this distance to 1.0 of it
  float grid_step_m = 1.0f;  ///< grid lines are at multiples of this, in world space
};

/// A ground just below the bounds, so that feet do not touch it. Wide enough for the shadows of a high light. `look` is
/// not set.
/// eq   radius = 1.5 * diagonal; grid step = the largest power of 10 with at least 3 steps in the radius
Ground ground_for(const Aabb& bounds);

/// Range of distances from the eye plane.
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
  bool smooth_edges = false;  ///< 4x multisampling of coverage and depth; shading once per pixel
  Backdrop backdrop = Backdrop::plain;
  bool transparent_background = false;        ///< alpha is 0 where nothing is drawn
  glm::vec3 background{0.13f, 0.14f, 0.16f};  ///< sRGB, as displayed
};

/// Options for a scene of these bounds seen from `eye`. Sets the lengths of ambient occlusion, the ground and the depth
/// range.
RenderOptions render_options_for(const Aabb& bounds, const glm::dvec3& eye);

}  // namespace sinew::viewer
