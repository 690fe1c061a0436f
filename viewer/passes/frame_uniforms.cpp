// SPDX-License-Identifier: MIT
#include "viewer/passes/frame_uniforms.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "runtime/math/inverse.h"
#include "viewer/passes/ground_reach.h"
#include "viewer/passes/shadow_view.h"

namespace sinew::viewer {

namespace {

glm::vec3 safe_normalize(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0.0f ? v / length : otherwise;
}

glm::vec3 into_view(const View& view, const glm::vec3& world) {
  return glm::vec3(transform_vector(view.view_from_world, glm::dvec3(world)));
}

LightUniforms key_light(const View& view, const Lighting& lighting) {
  const glm::vec3 to_key = safe_normalize(lighting.to_key, {0.0f, 1.0f, 0.0f});
  LightUniforms key;
  key.to_light = lighting.key_follows_camera ? to_key : into_view(view, to_key);
  key.color = lighting.key;
  return key;
}

/// KHR_lights_punctual: a light shines along -z of its node; the scale of the node has no effect.
LightUniforms scene_light(const View& view, const PlacedLight& placed) {
  const Light& light = *placed.light;
  const Affined world = affine_cast<double>(placed.world_from_light);
  const glm::dvec3 position = transform_point(view.view_from_world, translation_of(world));
  const glm::vec3 back = into_view(view, glm::vec3(transform_vector(world, glm::dvec3(0.0, 0.0, 1.0))));
  const float outer = std::cos(light.outer_cone_rad);
  const float width = std::max(std::cos(light.inner_cone_rad) - outer, 1e-3f);
  LightUniforms uniforms;
  uniforms.position = glm::vec3(position);
  uniforms.kind = static_cast<std::uint32_t>(light.kind);
  uniforms.to_light = safe_normalize(back, {0.0f, 0.0f, 1.0f});
  uniforms.range_m = light.range_m;
  uniforms.color = light.color * light.intensity;
  uniforms.cos_outer = outer;
  uniforms.inverse_cone_width = 1.0f / width;
  return uniforms;
}

void write_environment(const View& view, const Lighting& lighting, FrameUniforms& u) {
  if (!lighting.ambient()) return;
  const float c = std::cos(lighting.environment_turn_rad), s = std::sin(lighting.environment_turn_rad);
  // Axes of the environment in world space: the inverse of its rotation.
  const std::array<glm::vec3, 3> axes = {glm::vec3(c, 0.0f, -s), {0.0f, 1.0f, 0.0f}, {s, 0.0f, c}};
  for (int row = 0; row < 3; ++row) {
    const glm::vec3 axis = into_view(view, axes[static_cast<std::size_t>(row)]);
    for (int column = 0; column < 3; ++column)
      u.environment_from_view[static_cast<std::size_t>(column)][row] = axis[column];
  }
  for (std::size_t i = 0; i < u.diffuse_light.size(); ++i)
    u.diffuse_light[i] = glm::vec4(lighting.environment->diffuse[i] * lighting.environment_intensity, 0.0f);
  u.environment_intensity = lighting.environment_intensity;
  u.backdrop_intensity = lighting.environment_intensity * lighting.environment->backdrop;
}

ShadowMapUniforms shadow_map(const View& view, const Aabb& bounds, const ShadowLight& light) {
  const ShadowView map = shadow_view_of(light, bounds);
  const auto map_from_view = map.map_from(inverse_rigid(view.view_from_world));
  ShadowMapUniforms u;
  for (std::size_t i = 0; i < 4; ++i) u.from_view[i] = glm::vec4(map_from_view[i]);
  u.texel_m = static_cast<float>(map.texel_m);
  return u;
}

void write_ground(const View& view, const RenderOptions& options, const ShadowLights& shadows, FrameUniforms& u) {
  const Ground& ground = options.ground;
  u.ground_middle = glm::vec3(transform_point(view.view_from_world, ground.middle));
  u.ground_radius_m = ground.radius_m;
  u.ground_x = into_view(view, {1.0f, 0.0f, 0.0f});
  u.ground_z = into_view(view, {0.0f, 0.0f, 1.0f});
  const double step = ground.grid_step_m;
  u.ground_grid_step_m = ground.grid_step_m;
  u.ground_grid_offset = {static_cast<float>(ground.middle.x - step * std::floor(ground.middle.x / step)),
                          static_cast<float>(ground.middle.z - step * std::floor(ground.middle.z / step))};
  const GroundReach reach =
      ground_reach(ground, ground.bounds, shadows, options.ao.in_screen_space() ? options.ao.radius_m : 0.0);
  u.ground_reach = reach.rectangle;
  u.ground_contact = reach.contact;
}

}  // namespace

float linear_from_srgb(float encoded) noexcept {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

std::uint32_t light_count(const RenderOptions& options, std::span<const PlacedLight> lights) noexcept {
  const std::size_t of_scene = options.lighting.scene_lights ? std::min(lights.size(), kMaxLights) : 0;
  return static_cast<std::uint32_t>(std::max<std::size_t>(of_scene, 1));
}

void ShadowLights::sort() noexcept {
  std::sort(lights_.begin(), lights_.begin() + count_,
            [](const ShadowLight& a, const ShadowLight& b) { return a.index < b.index; });
}

std::uint32_t ShadowLights::mask() const noexcept {
  std::uint32_t mask = 0;
  for (const ShadowLight& light : *this) mask |= 1u << light.index;
  return mask;
}

ShadowLights shadow_lights(const View& view, const RenderOptions& options, std::span<const PlacedLight> lights) {
  ShadowLights casting;
  if (!options.shadows.on || options.shadows.bounds.empty()) return casting;
  const Lighting& lighting = options.lighting;
  if (lights.empty() || !lighting.scene_lights) {
    if (lighting.key == glm::vec3(0.0f)) return casting;
    const glm::dvec3 to_key(safe_normalize(lighting.to_key, {0.0f, 1.0f, 0.0f}));
    const glm::dmat3 view_from_world = linear_part(view.view_from_world);
    casting.add({0, lighting.key_follows_camera ? glm::transpose(view_from_world) * to_key : to_key});
    return casting;  // the transpose of a rotation is its inverse
  }
  for (const Light::Kind kind : {Light::Kind::directional, Light::Kind::spot})
    for (std::uint32_t i = 0; i < std::min(lights.size(), kMaxLights) && !casting.full(); ++i) {
      const Light& light = *lights[i].light;
      if (light.kind != kind) continue;
      const Affined world = affine_cast<double>(lights[i].world_from_light);
      const glm::dvec3 back = transform_vector(world, glm::dvec3(0.0, 0.0, 1.0));
      casting.add({i, glm::length(back) > 0.0 ? glm::normalize(back) : glm::dvec3(0.0, 0.0, 1.0),
                   kind == Light::Kind::spot, translation_of(world), static_cast<double>(light.outer_cone_rad)});
    }
  casting.sort();
  return casting;
}

ShadowView shadow_view_of(const ShadowLight& light, const Aabb& bounds) {
  return light.spot ? spot_shadow_view(bounds, light.position, light.to_light, light.cone_rad)
                    : shadow_view(bounds, light.to_light);
}

bool ground_is_seen(const View& view, const Ground& ground) noexcept {
  if (ground.look == GroundLook::none) return false;
  if (view.parallel()) return view.view_from_world.row[2].y > 0.0;
  return eye_of(view).y > ground.middle.y;
}

FrameUniforms make_frame_uniforms(const View& view, VkExtent2D extent, const RenderOptions& options, bool occlusion,
                                  std::span<const PlacedLight> lights, const ShadowLights& shadows,
                                  const SsaoKernel& kernel) {
  FrameUniforms u;
  const double aspect = static_cast<double>(extent.width) / extent.height;
  const Mat4<double> clip = clip_from_view(view, aspect);
  u.projection = glm::vec4(glm::dvec4(clip[0][0], clip[1][1], clip[3][2], clip[2][2]));
  u.near_m = static_cast<float>(view.near_m);
  u.pixels_per_metre = static_cast<float>(0.5 * clip[1][1] * extent.height);
  u.exposure = options.lighting.exposure;
  const AmbientOcclusion& ao = options.ao;
  u.occlusion_power = ao.method == OcclusionMethod::ssao ? 2.0f * ao.power : ao.power;
  u.occlusion_radius_m = ao.radius_m;
  u.surface_epsilon_m = ao.surface_epsilon_m;
  u.fade_start_m = ao.fade_start_m;
  u.fade_end_m = std::max(ao.fade_end_m, ao.fade_start_m * 1.0001f);
  u.nearest_shown_m = options.depth_range.nearest_m;
  u.farthest_shown_m = std::max(options.depth_range.farthest_m, options.depth_range.nearest_m + 1e-6f);
  write_environment(view, options.lighting, u);
  for (std::size_t i = 0; i < shadows.count(); ++i)
    u.shadow_maps[i] = shadow_map(view, options.shadows.bounds, shadows.begin()[i]);
  if (ground_is_seen(view, options.ground)) write_ground(view, options, shadows, u);
  for (int i = 0; i < 3; ++i) u.background[i] = linear_from_srgb(options.background[i]);
  for (std::size_t i = 0; occlusion && i < kernel.offsets.size(); ++i)
    u.offsets[i] = glm::vec4(kernel.offsets[i], 0.0f);
  for (std::size_t i = 0; occlusion && i < kernel.noise.size(); ++i) u.noise[i] = glm::vec4(kernel.noise[i], 0.0f);

  if (lights.empty() || !options.lighting.scene_lights) {
    u.lights[0] = key_light(view, options.lighting);
    return u;
  }
  for (std::size_t i = 0; i < std::min(lights.size(), kMaxLights); ++i) u.lights[i] = scene_light(view, lights[i]);
  return u;
}

}  // namespace sinew::viewer
