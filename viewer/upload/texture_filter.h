// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

#include "runtime/model/material.h"

namespace sinew::viewer {

enum class FilterKind : std::uint8_t {
  file,         ///< as the samplers of the file say
  nearest,      ///< one texel of the full image
  bilinear,     ///< four texels of the full image
  trilinear,    ///< four texels in each of two mip levels
  anisotropic,  ///< trilinear in several places along the longer side of the pixel's footprint
  rip_map       ///< four texels in each of four levels, which are as wide and as high as the footprint (rip_map.h)
};

/// How textures are read, whatever the samplers of the file say. How textures wrap stays as the file has it.
struct TextureFilter {
  FilterKind kind = FilterKind::file;
  std::uint32_t anisotropy = 1;  ///< FilterKind::anisotropic: most places, at least 1

  friend bool operator==(const TextureFilter&, const TextureFilter&) = default;
};

/// The sampler that reads a texture of this sampler with the filter. Shaders fetch the texels of rip maps themselves.
Sampler filtered(const Sampler& sampler, const TextureFilter& filter) noexcept;

/// Most places along a footprint: of the files' samplers 8, and 1 where a software driver reads them (it takes 9 times
/// as long there, for any number of places), else what the filter says and the device can.
/// in   device_most  of the device, 1 = it has no anisotropic filter
///      software     the driver draws on the CPU
float anisotropy_of(const TextureFilter& filter, float device_most, bool software) noexcept;

/// What the device cannot do of the filter, and what is done instead, in one sentence; empty = it can.
std::string describe_missing_filter(const TextureFilter& filter, float device_most);

}  // namespace sinew::viewer
