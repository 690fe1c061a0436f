// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "runtime/model/scene.h"
#include "viewer/upload/staging.h"

namespace sinew::viewer {

/// The images and samplers of a scene. An image that is used both as colour (sRGB) and as data is there twice.
class TextureSet {
 public:
  explicit TextureSet(Device& device);
  ~TextureSet();
  TextureSet(const TextureSet&) = delete;
  TextureSet& operator=(const TextureSet&) = delete;

  /// What to bind for a texture of the scene; the placeholder when its image is missing, plain white for kNone. Uploads
  /// the image at its first use.
  VkDescriptorImageInfo use(const Scene& scene, std::uint32_t texture, bool srgb, Staging& staging);

 private:
  const GpuImage& image(const Scene& scene, std::uint32_t image, bool srgb, Staging& staging);
  VkSampler sampler(const Sampler& wanted);

  Device& device_;
  std::map<std::pair<std::uint32_t, bool>, GpuImage> images_;  // by image index and whether it is sRGB
  std::map<std::uint32_t, VkSampler> samplers_;
};

/// Whether a texture's pixels can be uploaded. Missing colours become a visible placeholder; missing data (normals,
/// roughness, occlusion) is better left out, since a checkerboard of slopes would only look broken.
bool readable(const Scene& scene, const TextureUse& use) noexcept;

/// Trilinear by default, with the device's best anisotropy where all filters are linear.
VkSamplerCreateInfo sampler_info(const Sampler& sampler, float max_anisotropy) noexcept;

/// What stands in for an image that could not be read: a checkerboard of magenta and black, 8 x 8 fields.
MipLevel placeholder_image();

}  // namespace sinew::viewer
