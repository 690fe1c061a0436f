// SPDX-License-Identifier: MIT
#include "viewer/upload/upload_textures.h"

#include <algorithm>
#include <array>

#include "viewer/upload/rip_map.h"

namespace sinew::viewer {

namespace {

constexpr std::uint32_t kWhite = kNone - 1, kPlaceholder = kNone - 2;  // pseudo indices that no image of a scene has

VkSamplerAddressMode address_mode(Wrap wrap) noexcept {
  switch (wrap) {
    case Wrap::clamp_to_edge: return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    case Wrap::mirrored_repeat: return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
    default: return VK_SAMPLER_ADDRESS_MODE_REPEAT;
  }
}

VkFilter filter(Filter wanted) noexcept { return wanted == Filter::nearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR; }

std::uint32_t key_of(const Sampler& s) noexcept {
  return static_cast<std::uint32_t>(s.magnify) | static_cast<std::uint32_t>(s.minify) << 1 |
         static_cast<std::uint32_t>(s.mipmap) << 2 | static_cast<std::uint32_t>(s.use_mipmaps) << 3 |
         static_cast<std::uint32_t>(s.wrap_u) << 4 | static_cast<std::uint32_t>(s.wrap_v) << 6;
}

bool readable(const Image& image) noexcept {
  return image.missing_reason.empty() && image.width > 0 && image.height > 0 &&
         image.rgba.size() == std::size_t{4} * image.width * image.height;
}

/// True if all texels are opaque, so that alpha does not affect the averages.
bool covers_all(const Image& image) noexcept {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] != 255) return false;
  return true;
}

}  // namespace

bool readable(const Scene& scene, const TextureUse& use) noexcept {
  if (!use.used() || scene.textures[use.texture].image == kNone) return false;
  return readable(scene.images[scene.textures[use.texture].image]);
}

MipLevel placeholder_image() {
  constexpr std::uint32_t size = 64, field = size / 8;
  MipLevel level{size, size, std::vector<std::uint8_t>(4 * size * size, 0)};
  for (std::uint32_t y = 0; y < size; ++y)
    for (std::uint32_t x = 0; x < size; ++x) {
      std::uint8_t* texel = &level.rgba[4 * (y * size + x)];
      if ((x / field + y / field) % 2 == 0) texel[0] = texel[2] = 255;
      texel[3] = 255;
    }
  return level;
}

VkSamplerCreateInfo sampler_info(const Sampler& sampler, float max_anisotropy) noexcept {
  VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  info.magFilter = filter(sampler.magnify);
  info.minFilter = filter(sampler.minify);
  info.mipmapMode = sampler.mipmap == Filter::nearest ? VK_SAMPLER_MIPMAP_MODE_NEAREST : VK_SAMPLER_MIPMAP_MODE_LINEAR;
  info.addressModeU = address_mode(sampler.wrap_u);
  info.addressModeV = address_mode(sampler.wrap_v);
  info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  // Without mipmaps only level 0 is read. With maxLod = 0 Vulkan would always use the magnification filter; 0.25 keeps
  // both filters.
  info.maxLod = sampler.use_mipmaps ? VK_LOD_CLAMP_NONE : 0.25f;
  if (!sampler.use_mipmaps) info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST;
  const bool smooth =
      sampler.magnify == Filter::linear && sampler.minify == Filter::linear && sampler.mipmap == Filter::linear;
  info.anisotropyEnable = smooth && sampler.use_mipmaps && max_anisotropy > 1.0f;
  info.maxAnisotropy = info.anisotropyEnable ? max_anisotropy : 1.0f;
  return info;
}

TextureSet::TextureSet(Device& device, const TextureFilter& filter) : device_(device), filter_(filter) {}

TextureSet::~TextureSet() {
  for (const auto& [key, sampler] : samplers_) vkDestroySampler(device_.handle(), sampler, nullptr);
}

VkSampler TextureSet::sampler(const Sampler& wanted) {
  VkSampler& sampler = samplers_[key_of(wanted)];
  if (!sampler) {
    const VkSamplerCreateInfo info = sampler_info(
        filtered(wanted, filter_), anisotropy_of(filter_, device_.max_anisotropy(), device_.is_software()));
    must(vkCreateSampler(device_.handle(), &info, nullptr, &sampler), "vkCreateSampler");
  }
  return sampler;
}

std::vector<MipLevel> TextureSet::levels_of(std::span<const std::uint8_t> rgba, std::uint32_t width,
                                            std::uint32_t height, const TexelUse& use) const {
  if (filter_.kind == FilterKind::nearest || filter_.kind == FilterKind::bilinear)
    return {{width, height, {rgba.begin(), rgba.end()}}};
  std::vector<MipLevel> levels = mip_chain(rgba, width, height, use);
  if (filter_.kind != FilterKind::rip_map) return levels;
  const std::uint32_t limit = device_.limits().maxImageDimension2D;
  // If twice the image's size exceeds the device limit, the finest levels are dropped.
  const auto fits = std::find_if(levels.begin(), levels.end(), [limit](const MipLevel& level) {
    return std::max(level.width, level.height) <= limit / 2;
  });
  return {rip_map(fits->rgba, fits->width, fits->height, use)};
}

const GpuImage& TextureSet::image(const Scene& scene, std::uint32_t index, const TexelUse& given, Staging& staging) {
  const bool special = index == kWhite || index == kPlaceholder;
  const std::uint32_t limit = device_.limits().maxImageDimension2D;
  if (!special) {
    const Image& source = scene.images[index];
    if (!readable(source) || std::max(source.width, source.height) > limit)
      return image(scene, kPlaceholder, given, staging);
  }
  TexelUse use = given;
  if (given.alpha_covers && (special || covers_all(scene.images[index]))) use = {.srgb = given.srgb};
  GpuImage& gpu = images_[{index, use}];
  if (gpu) return gpu;
  std::vector<MipLevel> levels;
  if (index == kWhite) {
    constexpr std::array<std::uint8_t, 4> white = {255, 255, 255, 255};
    levels = levels_of(white, 1, 1, use);
  } else if (index == kPlaceholder) {
    const MipLevel board = placeholder_image();
    levels = levels_of(board.rgba, board.width, board.height, use);
  } else {
    const Image& source = scene.images[index];
    levels = levels_of(source.rgba, source.width, source.height, use);
  }
  gpu = GpuImage(device_, {use.srgb ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM,
                           {levels[0].width, levels[0].height},
                           static_cast<std::uint32_t>(levels.size()),
                           VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
  for (const MipLevel& level : levels) texel_bytes_ += level.rgba.size();
  staging.copy(gpu, levels);
  return gpu;
}

VkDescriptorImageInfo TextureSet::bind(const Scene& scene, std::uint32_t texture, const TexelUse& use,
                                       Staging& staging) {
  const bool none = texture == kNone;
  std::uint32_t index = none ? kWhite : scene.textures[texture].image;
  if (index == kNone) index = kPlaceholder;  // a texture without a source image
  const Sampler wanted = none ? Sampler{} : scene.textures[texture].sampler;
  return {sampler(wanted), image(scene, index, use, staging).view(), VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL};
}

}  // namespace sinew::viewer
