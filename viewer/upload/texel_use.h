// SPDX-License-Identifier: MIT
#pragma once
#include <compare>
#include <cstdint>

#include "runtime/model/material.h"

namespace sinew::viewer {

/// What the texels of an image stand for: smaller levels are averaged accordingly.
struct TexelUse {
  bool srgb = false;          ///< colours are averaged in linear light, else all is averaged as it is
  bool alpha_covers = false;  ///< alpha is how much of a texel its colour covers: colours count by it
  std::uint8_t cutoff =
      0;  ///< least alpha that an alpha test keeps, and as many texels pass it at every level; 0 = no test

  auto operator<=>(const TexelUse&) const = default;
};

/// Weight of a colour in a mean of colours that cover. Without alpha it counts where no other does.
inline float covered_weight(float alpha) noexcept { return alpha + 1e-6f; }

/// How a material reads its base colour. Opaque surfaces ignore alpha. Alpha tests see alpha times that of the
/// material's factor; of vertex colours nothing is known here.
TexelUse base_color_use(const Material& material) noexcept;

}  // namespace sinew::viewer
