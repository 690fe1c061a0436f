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

/// The images and samplers of a scene. An image is uploaded once for each use of its texels, as colour and as data. Rip
/// maps take the place of images with mip levels when the filter asks for them.
class TextureSet {
 public:
  explicit TextureSet(Device& device, const TextureFilter& filter = {});
  ~TextureSet();
  TextureSet(const TextureSet&) = delete;
  TextureSet& operator=(const TextureSet&) = delete;

  /// The image and sampler to bind for a texture: the placeholder if its image is missing, white for kNone. The image
  /// is uploaded at its first use.
  VkDescriptorImageInfo bind(const Scene& scene, std::uint32_t texture, const TexelUse& use, Staging& staging);

  /// Bytes of all texels of all levels.
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

/// The image of the texture can be uploaded. Missing colours become a visible placeholder; missing data (normals,
/// roughness, occlusion) is left out, because a placeholder would look like a broken surface.
bool readable(const Scene& scene, const TextureUse& use) noexcept;

/// Vulkan sampler of a glTF sampler. It is anisotropic if all filters are linear.
VkSamplerCreateInfo sampler_info(const Sampler& sampler, float max_anisotropy) noexcept;

/// Stands in for an image that could not be read: a checkerboard of magenta and black, 8 x 8 fields.
MipLevel placeholder_image();

}  // namespace sinew::viewer
