// SPDX-License-Identifier: MIT
#include "importer/read/image_avif.h"

#include <avif/avif.h>

#include <algorithm>
#include <memory>

namespace sinew {
namespace {

using Decoder = std::unique_ptr<avifDecoder, void (*)(avifDecoder*)>;

/// Opens a decoder and reads the header; null on error.    in   most_pixels  limit for any image in the file
Decoder open(std::span<const std::byte> encoded, std::uint64_t most_pixels) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(encoded.data());
  const avifROData head{bytes, encoded.size()};
  if (encoded.empty() || avifPeekCompatibleFileType(&head) == AVIF_FALSE) return {nullptr, avifDecoderDestroy};
  Decoder decoder(avifDecoderCreate(), avifDecoderDestroy);
  if (!decoder) return decoder;
  decoder->maxThreads = 1;
  decoder->ignoreExif = decoder->ignoreXMP = AVIF_TRUE;
  decoder->strictFlags = AVIF_STRICT_DISABLED;  // accept files whose encoder omitted required boxes
  decoder->imageSizeLimit =
      static_cast<std::uint32_t>(std::min<std::uint64_t>(most_pixels, AVIF_DEFAULT_IMAGE_SIZE_LIMIT));
  const bool is_open = avifDecoderSetSource(decoder.get(), AVIF_DECODER_SOURCE_PRIMARY_ITEM) == AVIF_RESULT_OK &&
                       avifDecoderSetIOMemory(decoder.get(), bytes, encoded.size()) == AVIF_RESULT_OK &&
                       avifDecoderParse(decoder.get()) == AVIF_RESULT_OK;
  if (!is_open) decoder.reset();
  return decoder;
}

}  // namespace

std::optional<ImageHeader> probe_avif(std::span<const std::byte> encoded) {
  const Decoder decoder = open(encoded, AVIF_DEFAULT_IMAGE_SIZE_LIMIT);
  if (!decoder) return std::nullopt;
  return ImageHeader{decoder->image->width, decoder->image->height, "image/avif"};
}

tl::expected<std::vector<std::uint8_t>, std::string> decode_avif(std::span<const std::byte> encoded,
                                                                 const ImageHeader& size) {
  const auto damaged = tl::make_unexpected(std::string("its AVIF data are damaged"));
  const Decoder decoder = open(encoded, size.pixels());
  if (!decoder || avifDecoderNextImage(decoder.get()) != AVIF_RESULT_OK) return damaged;
  const avifImage& image = *decoder->image;
  if (image.width != size.width || image.height != size.height) return damaged;
  std::vector<std::uint8_t> rgba(4 * size.pixels());
  avifRGBImage out;
  avifRGBImageSetDefaults(&out, &image);
  out.format = AVIF_RGB_FORMAT_RGBA;
  out.depth = 8;
  out.pixels = rgba.data();
  out.rowBytes = 4 * size.width;
  if (avifImageYUVToRGB(&image, &out) != AVIF_RESULT_OK) return damaged;
  return rgba;
}

}  // namespace sinew
