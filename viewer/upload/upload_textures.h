// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "runtime/model/scene.h"
#include "viewer/upload/staging.h"
#include "viewer/upload/texture_filter.h"

namespace sinew::viewer {

/// The images and samplers of a scene. An image is uploaded once for each TexelUse, such as colour or data. The rip map
/// filter replaces mip levels by rip maps.
class TextureSet {
 public:
  explicit TextureSet(Device& device, const TextureFilter& filter = {});
  ~TextureSet();
  TextureSet(const TextureSet&) = delete;
  TextureSet& operator=(const TextureSet&) = delete;

  /// The image and sampler to bind for a texture; uploads the image at its first use. A missing image gives the
  /// placeholder; kNone gives white.
  VkDescriptorImageInfo bind(const Scene& scene, std::uint32_t texture, const TexelUse& use, Staging& staging);

  /// Size of all textures in bytes, including all levels.
  std::uint64_t texel_bytes() const noexcept { return texel_bytes_; }

 private:
  std::vector<MipLevel> levels_of(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height,
                                  const TexelUse& use) const;
  const GpuImage& image(const Scene& scene, std::uint32_t image, const TexelUse& use, Staging& staging);
  VkSampler sampler(const Sampler& wanted);

  Device& device_;
  TextureFilter filter_;
  std::uint64_t texel_bytes_ = 0;
  std::map<std::pair<std::uint32_t, TexelUse>, GpuImage> images_;
  std::map<std::uint32_t, VkSampler> samplers_;
};

/// True if the texture has a decoded image. Missing colour images are shown as a placeholder; missing data images
/// (normals, roughness, occlusion) are ignored, because a placeholder would look like a broken surface.
bool readable(const Scene& scene, const TextureUse& use) noexcept;

/// The Vulkan sampler for a glTF sampler. It is anisotropic if all filters are linear.
VkSamplerCreateInfo sampler_info(const Sampler& sampler, float max_anisotropy) noexcept;

/// The placeholder of an unreadable image: a magenta and black checkerboard of 8 x 8 fields.
MipLevel placeholder_image();

}  // namespace sinew::viewer
