// SPDX-License-Identifier: MIT
#include "viewer/upload/texture_filter.h"

#include <algorithm>

namespace sinew::viewer {

Sampler filtered(const Sampler& sampler, const TextureFilter& filter) noexcept {
  if (filter.kind == FilterKind::file) return sampler;
  const bool one_texel = filter.kind == FilterKind::nearest || filter.kind == FilterKind::rip_map;
  Sampler out = sampler;
  out.magnify = out.minify = one_texel ? Filter::nearest : Filter::linear;
  out.mipmap = Filter::linear;
  out.use_mipmaps = filter.kind == FilterKind::trilinear || filter.kind == FilterKind::anisotropic;
  return out;
}

float anisotropy_of(const TextureFilter& filter, float device_most, bool software) noexcept {
  constexpr float kMostOfFiles = 8.0f;
  if (filter.kind == FilterKind::file) return software ? 1.0f : std::min(kMostOfFiles, device_most);
  return filter.kind == FilterKind::anisotropic ? std::min(static_cast<float>(filter.anisotropy), device_most) : 1.0f;
}

std::string describe_missing_filter(const TextureFilter& filter, float device_most) {
  if (filter.kind != FilterKind::anisotropic || static_cast<float>(filter.anisotropy) <= device_most) return {};
  if (device_most <= 1.0f)
    return "this device has no anisotropic filter; textures are filtered as by --filter trilinear";
  return "this device filters in at most " + std::to_string(static_cast<int>(device_most)) +
         " places along a footprint, not " + std::to_string(filter.anisotropy);
}

}  // namespace sinew::viewer
