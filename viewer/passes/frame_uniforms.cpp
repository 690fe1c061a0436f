// SPDX-License-Identifier: MIT
#include "viewer/passes/frame_uniforms.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

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
  return {glm::vec4(0.0f), glm::vec4(lighting.key_follows_camera ? to_key : into_view(view, to_key), 0.0f),
          glm::vec4(lighting.key, 0.0f), glm::vec4(0.0f)};
}

/// KHR_lights_punctual: a light shines along -z of its node; the scale of the node has no effect.
LightUniforms scene_light(const View& view, const PlacedLight& placed) {
  const Light& light = *placed.light;
  const Affined world = affine_cast<double>(placed.world_from_light);
  const glm::dvec3 position = transform_point(view.view_from_world, translation_of(world));
  const glm::vec3 back = into_view(view, glm::vec3(transform_vector(world, glm::dvec3(0.0, 0.0, 1.0))));
  const float outer = std::cos(light.outer_cone_rad);
  const float width = std::max(std::cos(light.inner_cone_rad) - outer, 1e-3f);
  return {glm::vec4(glm::vec3(position), static_cast<float>(light.kind)),
          glm::vec4(safe_normalize(back, {0.0f, 0.0f, 1.0f}), light.range_m),
          glm::vec4(light.color * light.intensity, 0.0f),
          {outer, 1.0f / width, 0.0f, 0.0f}};
}

}  // namespace

float linear_from_srgb(float encoded) noexcept {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

FrameUniforms make_frame_uniforms(const View& view, VkExtent2D extent, const RenderOptions& options, bool occlusion,
                                  std::span<const PlacedLight> lights, const SsaoKernel& kernel) {
  FrameUniforms u{};
  const double aspect = static_cast<double>(extent.width) / extent.height;
  const Mat4<double> clip = clip_from_view(view, aspect);
  u.projection = glm::vec4(glm::dvec4(clip[0][0], clip[1][1], clip[3][2], clip[2][2]));
  u.lens = glm::vec4(glm::dvec4(view.near_m, 0.5 * clip[1][1] * extent.height, view.parallel() ? 1.0 : 0.0, 0.0));
  const AmbientOcclusion& ao = options.ao;
  u.occlusion = {ao.radius_m, ao.surface_epsilon_m, ao.fade_start_m,
                 std::max(ao.fade_end_m, ao.fade_start_m * 1.0001f)};
  u.occlusion_use = {ao.power, occlusion ? 1.0f : 0.0f, 0.0f, 0.0f};
  u.sky = glm::vec4(options.lighting.sky, 0.0f);
  u.ground = glm::vec4(options.lighting.ground, 0.0f);
  u.up = glm::vec4(into_view(view, {0.0f, 1.0f, 0.0f}), 0.0f);
  for (int i = 0; i < 3; ++i) u.background[i] = linear_from_srgb(options.background[i]);
  u.background.w = options.transparent_background ? 1.0f : 0.0f;
  for (std::size_t i = 0; occlusion && i < kernel.offsets.size(); ++i)
    u.offsets[i] = glm::vec4(kernel.offsets[i], 0.0f);
  for (std::size_t i = 0; occlusion && i < kernel.noise.size(); ++i) u.noise[i] = glm::vec4(kernel.noise[i], 0.0f);

  std::size_t count = options.lighting.scene_lights ? std::min(lights.size(), kMaxLights) : 0;
  for (std::size_t i = 0; i < count; ++i) u.lights[i] = scene_light(view, lights[i]);
  if (count == 0) {
    u.lights[0] = key_light(view, options.lighting);
    count = 1;
  }
  const DepthRange& range = options.depth_range;
  u.output_range = {options.lighting.exposure, range.nearest_m, std::max(range.farthest_m, range.nearest_m + 1e-6f),
                    static_cast<float>(count)};
  return u;
}

}  // namespace sinew::viewer
