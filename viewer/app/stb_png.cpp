// SPDX-License-Identifier: MIT
#include "viewer/app/stb_png.h"

#include <limits>

// The one file that contains stb's PNG encoder; static, so that other libraries may bring their own copy.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace sinew::viewer {

std::vector<unsigned char> encode_png(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height) {
  constexpr auto most = static_cast<std::uint32_t>(std::numeric_limits<std::int16_t>::max());
  if (width == 0 || height == 0 || width > most || height > most || rgba.size() != std::size_t{4} * width * height)
    return {};
  std::vector<unsigned char> bytes;
  const auto append = [](void* context, void* data, int size) {
    const auto* first = static_cast<const unsigned char*>(data);
    static_cast<std::vector<unsigned char>*>(context)->insert(static_cast<std::vector<unsigned char>*>(context)->end(),
                                                              first, first + size);
  };
  const int done = stbi_write_png_to_func(append, &bytes, static_cast<int>(width), static_cast<int>(height), 4,
                                          rgba.data(), static_cast<int>(4 * width));
  return done ? bytes : std::vector<unsigned char>{};
}

}  // namespace sinew::viewer
