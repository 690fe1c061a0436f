// SPDX-License-Identifier: MIT
#pragma once
#include <compare>
#include <cstdint>

#include "runtime/model/material.h"

namespace sinew::viewer {

/// Meaning of an image's texels; it decides how mip levels are averaged.
struct TexelUse {
  bool srgb = false;          ///< true = colours are averaged in linear light; false = stored values are averaged
  bool alpha_covers = false;  ///< alpha is coverage: colours are weighted by it
  std::uint8_t cutoff =
      0;  ///< least alpha that passes the alpha test; all levels keep the same coverage. 0 = no alpha test

  auto operator<=>(const TexelUse&) const = default;
};

/// Weight of a colour in a coverage-weighted mean. Not 0 at alpha 0, so that fully transparent blocks still have a
/// colour.
inline float covered_weight(float alpha) noexcept { return alpha + 1e-6f; }

/// How a material uses its base colour texture. Opaque surfaces ignore alpha. The cutoff is divided by the alpha of the
/// base colour factor; vertex colours are ignored.
TexelUse base_color_use(const Material& material) noexcept;

}  // namespace sinew::viewer
