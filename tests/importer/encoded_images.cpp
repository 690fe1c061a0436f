// SPDX-License-Identifier: MIT
#include "tests/importer/encoded_images.h"

#include <avif/avif.h>
#include <turbojpeg.h>
#include <webp/encode.h>

#include <memory>

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

std::vector<std::byte> encode_progressive_jpeg(int width, int height, const std::vector<std::uint8_t>& rgb) {
  const std::unique_ptr<void, int (*)(tjhandle)> handle(tjInitCompress(), &tjDestroy);
  unsigned char* encoded = nullptr;
  unsigned long size = 0;
  tjCompress2(handle.get(), rgb.data(), width, 0, height, TJPF_RGB, &encoded, &size, TJSAMP_444, 90,
              TJFLAG_PROGRESSIVE);
  std::vector<std::byte> out;
  append(&out, encoded, static_cast<int>(size));
  tjFree(encoded);
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

std::vector<std::byte> encode_avif(int width, int height, const std::vector<std::uint8_t>& rgba) {
  const std::unique_ptr<avifImage, void (*)(avifImage*)> image(
      avifImageCreate(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), 8,
                      AVIF_PIXEL_FORMAT_YUV444),
      avifImageDestroy);
  image->yuvRange = AVIF_RANGE_FULL;
  image->matrixCoefficients = AVIF_MATRIX_COEFFICIENTS_IDENTITY;
  avifRGBImage pixels;
  avifRGBImageSetDefaults(&pixels, image.get());
  std::vector<std::uint8_t> copy = rgba;
  pixels.pixels = copy.data();
  pixels.rowBytes = 4 * static_cast<std::uint32_t>(width);
  const std::unique_ptr<avifEncoder, void (*)(avifEncoder*)> encoder(avifEncoderCreate(), avifEncoderDestroy);
  encoder->minQuantizer = encoder->maxQuantizer = AVIF_QUANTIZER_LOSSLESS;
  encoder->minQuantizerAlpha = encoder->maxQuantizerAlpha = AVIF_QUANTIZER_LOSSLESS;
  encoder->speed = AVIF_SPEED_FASTEST;
  avifRWData encoded = AVIF_DATA_EMPTY;
  std::vector<std::byte> out;
  if (avifImageRGBToYUV(image.get(), &pixels) == AVIF_RESULT_OK &&
      avifEncoderWrite(encoder.get(), image.get(), &encoded) == AVIF_RESULT_OK)
    append(&out, encoded.data, static_cast<int>(encoded.size));
  avifRWDataFree(&encoded);
  return out;
}

}  // namespace sinew::test
