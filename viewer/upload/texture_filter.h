// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

#include "runtime/model/material.h"

namespace sinew::viewer {

enum class FilterKind : std::uint8_t {
  file,         ///< use the samplers of the file
  nearest,      ///< one texel of level 0
  bilinear,     ///< four texels of level 0
  trilinear,    ///< four texels in each of two mip levels
  anisotropic,  ///< several trilinear samples along the longer side of the pixel's footprint
  rip_map       ///< four texels in each of four levels that match the footprint's width and height (rip_map.h)
};

/// A texture filter that overrides the file's samplers. Wrap modes stay as in the file.
struct TextureFilter {
  FilterKind kind = FilterKind::file;
  std::uint32_t anisotropy = 1;  ///< for FilterKind::anisotropic: largest number of samples, at least 1

  friend bool operator==(const TextureFilter&, const TextureFilter&) = default;
};

/// Applies the filter to a glTF sampler. Rip maps get a nearest-texel sampler, because shaders fetch and filter their
/// texels themselves.
Sampler filtered(const Sampler& sampler, const TextureFilter& filter) noexcept;

/// Largest anisotropy to use: that of the filter, limited by the device. For FilterKind::file it is 8, but 1 on
/// software drivers, where anisotropic sampling takes 9 times as long.
/// in   device_most  limit of the device; 1 = no anisotropic filter
///      software     the driver renders on the CPU
float anisotropy_of(const TextureFilter& filter, float device_most, bool software) noexcept;

/// One sentence if the device cannot do the requested filter, with the replacement; empty if it can.
std::string describe_missing_filter(const TextureFilter& filter, float device_most);

}  // namespace sinew::viewer
