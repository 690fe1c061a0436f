// SPDX-License-Identifier: MIT
#include "tests/importer/encoded_images.h"

#include <webp/encode.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace sinew::test {
namespace {

void append(void* context, void* data, int size) {
  auto& out = *static_cast<std::vector<std::byte>*>(context);
  const auto* bytes = static_cast<const std::byte*>(data);
  out.insert(out.end(), bytes, bytes + size);
}

}  // namespace

std::vector<std::byte> encode_png(int width, int height, int channels, const std::vector<std::uint8_t>& pixels) {
  std::vector<std::byte> out;
  stbi_write_png_to_func(append, &out, width, height, channels, pixels.data(), width * channels);
  return out;
}

std::vector<std::byte> encode_jpeg(int width, int height, int channels, const std::vector<std::uint8_t>& pixels) {
  std::vector<std::byte> out;
  stbi_write_jpg_to_func(append, &out, width, height, channels, pixels.data(), 95);
  return out;
}

std::vector<std::byte> encode_webp(int width, int height, const std::vector<std::uint8_t>& rgba) {
  std::uint8_t* encoded = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(rgba.data(), width, height, 4 * width, &encoded);
  const auto* bytes = reinterpret_cast<const std::byte*>(encoded);
  std::vector<std::byte> out(bytes, bytes + size);
  WebPFree(encoded);
  return out;
}

}  // namespace sinew::test
