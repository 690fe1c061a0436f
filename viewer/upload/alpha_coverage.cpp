// SPDX-License-Identifier: MIT
#include "viewer/upload/alpha_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace sinew::viewer {

namespace {

using Kept = std::array<std::int64_t, 256>;

/// For each alpha value, the number of sample points whose interpolated alpha is at least that value.
Kept kept_by_cutoff(const MipLevel& level) {
  Kept count{};
  const std::size_t last_x = level.width - 1, last_y = level.height - 1;
  const auto alpha = [&](std::size_t x, std::size_t y) { return unsigned{level.rgba[4 * (y * level.width + x) + 3]}; };
  for (std::size_t y = 0; y <= last_y; ++y)
    for (std::size_t x = 0; x <= last_x; ++x)
      for (const std::size_t beside_y : {y > 0 ? y - 1 : 0, std::min(y + 1, last_y)})
        for (const std::size_t beside_x : {x > 0 ? x - 1 : 0, std::min(x + 1, last_x)})
          ++count[(9 * alpha(x, y) + 3 * alpha(beside_x, y) + 3 * alpha(x, beside_y) + alpha(beside_x, beside_y) + 8) /
                  16];
  for (std::size_t a = 255; a-- > 0;) count[a] += count[a + 1];
  return count;
}

/// The cutoff at which the level's coverage is closest to the image's coverage at `cutoff`.
int cutoff_of_level(const Kept& image, int cutoff, const Kept& level) noexcept {
  const auto off = [&](int c) {  // difference of the coverages, times both numbers of points
    return std::abs(level[static_cast<std::size_t>(c)] * image[0] - image[static_cast<std::size_t>(cutoff)] * level[0]);
  };
  int best = cutoff;
  for (int c = 1; c < 256; ++c)
    if (off(c) < off(best) || (off(c) == off(best) && std::abs(c - cutoff) < std::abs(best - cutoff))) best = c;
  return best;
}

}  // namespace

void keep_coverage(const MipLevel& image, std::uint8_t cutoff, MipLevel& level) {
  const int found = cutoff_of_level(kept_by_cutoff(image), cutoff, kept_by_cutoff(level));
  if (found == cutoff) return;
  // Scale so that `found` rounds to at least the cutoff and found - 1 to less: rounding changes at half steps.
  const double scale = (cutoff - 0.5) / (found - 0.5);
  for (std::size_t i = 3; i < level.rgba.size(); i += 4)
    level.rgba[i] = static_cast<std::uint8_t>(std::min(std::lround(level.rgba[i] * scale), 255L));
}

}  // namespace sinew::viewer
