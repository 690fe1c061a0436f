// SPDX-License-Identifier: MIT
#include "importer/read/image_codec.h"
#include "tests/fuzz/fuzz_targets.h"

namespace sinew::fuzz {

void decode_images(Bytes input) {
  constexpr std::uint64_t kMostPixels = 1 << 16;
  const auto size = probe_image(input);
  if (!size || size->pixels() > kMostPixels) return;
  if (const auto pixels = decode_image(input))
    require(pixels->size() == 4 * size->pixels(), "a decoded image has its size");
}

}  // namespace sinew::fuzz
