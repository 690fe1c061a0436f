// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include <vulkan/vulkan.h>
#include <glm/vec4.hpp>

#include "runtime/model/scene.h"
#include "viewer/passes/render_options.h"
#include "viewer/passes/ssao_kernel.h"
#include "viewer/passes/view.h"

namespace sinew::viewer {

inline constexpr std::size_t kMaxLights = 16;  ///< of a scene; further lights have no effect

/// Mirrors shaders/frame_uniforms.glsl, std140.
struct LightUniforms {
  glm::vec4 position_kind, to_light_range, color, cone;
};

struct FrameUniforms {
  glm::vec4 projection;     ///< clip x and y = these * view x and y; clip z = third + fourth * view z
  glm::vec4 lens;           ///< near, pixels per metre (of a perspective: at distance 1), 1 = parallel
  glm::vec4 occlusion;      ///< radius, surface epsilon, fade start, fade end
  glm::vec4 occlusion_use;  ///< power, 1 = on
  glm::vec4 sky, ground, up;
  glm::vec4 background;    ///< linear; w: 1 = transparent
  glm::vec4 output_range;  ///< exposure, depth range, light count
  std::array<glm::vec4, kMostOcclusionSamples> offsets;
  std::array<glm::vec4, 16> noise;
  std::array<LightUniforms, kMaxLights> lights;
};
static_assert(sizeof(FrameUniforms) == 16 * (9 + kMostOcclusionSamples + 16 + 4 * kMaxLights));

/// A light of the scene and the world matrix of its joint, as animated in this frame.
struct PlacedLight {
  const Light* light = nullptr;
  Affine world_from_light;
};

/// in   lights  of all scenes shown; the key light of `options` is used if there are none or scene_lights is off
FrameUniforms make_frame_uniforms(const View& view, VkExtent2D extent, const RenderOptions& options, bool occlusion,
                                  std::span<const PlacedLight> lights, const SsaoKernel& kernel);

/// eq   IEC 61966-2-1
float linear_from_srgb(float encoded) noexcept;

}  // namespace sinew::viewer
