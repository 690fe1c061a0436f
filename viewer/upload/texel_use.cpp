// SPDX-License-Identifier: MIT
#include "viewer/upload/texel_use.h"

#include <cmath>

namespace sinew::viewer {

TexelUse base_color_use(const Material& material) noexcept {
  TexelUse use{.srgb = true, .alpha_covers = material.alpha_mode != AlphaMode::opaque};
  if (material.alpha_mode != AlphaMode::mask) return use;
  const float least = 255.0f * (material.alpha_cutoff - 1e-6f) / material.base_color.a;  // is_cut() in material.glsl
  if (least > 0.0f && least <= 255.0f) use.cutoff = static_cast<std::uint8_t>(std::ceil(least));
  return use;
}

}  // namespace sinew::viewer
