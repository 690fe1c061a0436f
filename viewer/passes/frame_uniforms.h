// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include <vulkan/vulkan.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "runtime/model/scene.h"
#include "viewer/passes/render_options.h"
#include "viewer/passes/shadow_view.h"
#include "viewer/passes/ssao_kernel.h"
#include "viewer/passes/view.h"

namespace sinew::viewer {

inline constexpr std::size_t kMaxLights = 16;  ///< per scene; further lights are ignored

/// Mirrors shaders/frame_uniforms.glsl, std140.
struct LightUniforms {
  glm::vec3 position{0.0f};  ///< view space
  std::uint32_t kind = 0;    ///< 0 directional, 1 point, 2 spot
  glm::vec3 to_light{0.0f};  ///< directional and spot: unit vector towards the light
  float range_m = 0.0f;      ///< 0 = unlimited
  glm::vec3 color{0.0f};     ///< linear, times intensity
  float cos_outer = 0.0f;    ///< spot: cosine of the outer cone angle
  float inverse_cone_width = 0.0f;
  std::array<float, 3> padding{};
};

struct ShadowMapUniforms {
  std::array<glm::vec4, 4> from_view{};  ///< rows of ShadowView::map_from(), for view space
  float texel_m = 0.0f;
  std::array<float, 3> padding{};
};

struct FrameUniforms {
  glm::vec4 projection{0.0f};  ///< clip x, y = xy * view x, y;   clip z = z + w * view z
  float near_m = 0.0f;
  float pixels_per_metre = 0.0f;  ///< perspective: at distance 1
  float exposure = 1.0f;
  float occlusion_power = 0.0f;
  float occlusion_radius_m = 0.0f, surface_epsilon_m = 0.0f, fade_start_m = 0.0f, fade_end_m = 0.0f;
  float nearest_shown_m = 0.0f, farthest_shown_m = 0.0f;  ///< distance range of Show::depth
  float environment_intensity = 0.0f;
  float backdrop_intensity = 0.0f;                   ///< of the environment behind the scene
  std::array<glm::vec4, 3> environment_from_view{};  ///< columns of a rotation matrix
  std::array<glm::vec4, 9> diffuse_light{};          ///< Environment::diffuse times its intensity
  std::array<ShadowMapUniforms, kMostShadows> shadow_maps{};
  glm::vec3 ground_middle{0.0f};  ///< view space
  float ground_radius_m = 0.0f;
  glm::vec3 ground_x{0.0f};  ///< x and z of the world in view space
  float ground_grid_step_m = 0.0f;
  glm::vec3 ground_z{0.0f};
  float padding = 0.0f;
  glm::vec2 ground_grid_offset{0.0f};  ///< metres from a grid line crossing to the center of the ground
  glm::vec2 weighted_range{0.0f};      ///< nearest distance of weighted surfaces, and 1 / (farthest - nearest)
  glm::vec4 ground_reach{0.0f};        ///< drawn rectangle: min x, min z, max x, max z, relative to the center
  glm::vec4 ground_contact{0.0f};      ///< the part of it that ambient occlusion may reach
  glm::vec4 background{0.0f};          ///< linear
  std::array<glm::vec4, kMostOcclusionSamples> offsets{};
  std::array<glm::vec4, 16> noise{};
  std::array<LightUniforms, kMaxLights> lights{};
};
static_assert(sizeof(FrameUniforms) == 16 * (23 + 5 * kMostShadows + kMostOcclusionSamples + 16 + 4 * kMaxLights));

/// A light of the scene with this frame's animated values, and the world matrix of its joint.
struct PlacedLight {
  const Light* light = nullptr;
  Affine world_from_light;
};

/// A light that casts shadows, with its index in the uniforms. World space.
struct ShadowLight {
  std::uint32_t index = kNone;
  glm::dvec3 to_light{0.0};  ///< unit vector towards the light
  bool spot = false;
  glm::dvec3 position{0.0};  ///< spot
  double cone_rad = 0.0;     ///< spot: half angle of the outer cone
};

/// The lights that cast shadows, in the order of the uniforms. Light i of this list uses shadow map i.
class ShadowLights {
 public:
  void add(const ShadowLight& light) noexcept { lights_[count_++] = light; }
  void sort() noexcept;

  const ShadowLight* begin() const noexcept { return lights_.data(); }
  const ShadowLight* end() const noexcept { return lights_.data() + count_; }
  std::uint32_t count() const noexcept { return count_; }
  bool full() const noexcept { return count_ == kMostShadows; }
  /// Bit i is set if light i of the uniforms casts shadows.
  std::uint32_t mask() const noexcept;

 private:
  std::array<ShadowLight, kMostShadows> lights_{};
  std::uint32_t count_ = 0;
};

/// Chooses up to kMostShadows lights: directional lights first, then spot lights; the key light if the scene has no
/// lights. None if shadows are off or have no bounds.
ShadowLights shadow_lights(const View& view, const RenderOptions& options, std::span<const PlacedLight> lights);

/// The projection of a light's shadow map.
/// in   bounds  of all casters and receivers, world space
ShadowView shadow_view_of(const ShadowLight& light, const Aabb& bounds);

/// True if the ground is on and the eye is above it. An orthographic view must look down on it.
bool ground_is_seen(const View& view, const Ground& ground) noexcept;

/// in   lights  of all shown scenes; the key light of `options` is used if there are none or scene_lights is off
///      shadows  their maps are fitted to options.shadows.bounds
///      occlusion  true = fill in the sample offsets of ambient occlusion
FrameUniforms make_frame_uniforms(const View& view, VkExtent2D extent, const RenderOptions& options, bool occlusion,
                                  std::span<const PlacedLight> lights, const ShadowLights& shadows,
                                  const SsaoKernel& kernel);

/// Number of lights in the uniforms; at least 1, the key light.
std::uint32_t light_count(const RenderOptions& options, std::span<const PlacedLight> lights) noexcept;

/// eq   IEC 61966-2-1
float linear_from_srgb(float encoded) noexcept;

}  // namespace sinew::viewer
