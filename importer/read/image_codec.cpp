// SPDX-License-Identifier: MIT
#include "importer/read/image_codec.h"

#include <limits>
#include <memory>
#include <optional>

#include "importer/ktx2/decode_ktx2.h"
#include "importer/read/image_avif.h"
#include "importer/read/image_jpeg.h"
#include "importer/read/image_webp.h"
#include "importer/read/undecoded_images.h"

// A private copy of stb_image, used for PNG only: its JPEG decoder writes out of bounds for files with wrong lengths.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_MAX_DIMENSIONS 65536
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace sinew {
namespace {

using Bytes = std::span<const std::byte>;

constexpr const char* kLeftOut = "it was made without the option SINEW_IMAGE_CODECS";
constexpr const char* kUnknown = "is no undamaged PNG, JPEG, WebP, AVIF or KTX2 file";

const unsigned char* data_of(Bytes bytes) noexcept { return reinterpret_cast<const unsigned char*>(bytes.data()); }

std::optional<ImageHeader> png_size(Bytes encoded) {
  if (encoded.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return std::nullopt;
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_memory(data_of(encoded), static_cast<int>(encoded.size()), &width, &height, &channels) == 0)
    return std::nullopt;
  return ImageHeader{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), "image/png"};
}

std::optional<ImageHeader> probe_ktx2(Bytes encoded) {
  const auto size = find_ktx2_size(encoded);
  if (!size) return std::nullopt;
  return ImageHeader{size->width, size->height, "image/ktx2"};
}

/// False if a chunk declares more bytes than the file has left. stb_image would allocate them before it checks.
bool png_chunks_fit(Bytes encoded) noexcept {
  constexpr std::size_t kSignature = 8, kBeforeData = 8, kChecksum = 4;  // kBeforeData: length and type
  for (std::size_t at = kSignature; at + kBeforeData <= encoded.size();) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8 | std::to_integer<std::size_t>(encoded[at + i]);
    if (length > encoded.size() - at - kBeforeData) return false;
    at += kBeforeData + length + kChecksum;
  }
  return true;
}

}  // namespace

tl::expected<ImageHeader, std::string> probe_image(Bytes encoded) {
  auto size = png_size(encoded);
  if (!size) size = probe_jpeg(encoded);
  if (!size) size = probe_webp(encoded);
  if (!size) size = probe_avif(encoded);
  if (!size) size = probe_ktx2(encoded);
  if (!size) size = probe_undecoded_image(encoded);
  if (!size) return tl::make_unexpected(kUnknown);
  if (size->left_out)
    return tl::make_unexpected(std::string("is ") + size->mime_type +
                               ", which this build of sinew cannot read: " + kLeftOut);
  if (size->pixels() == 0) return tl::make_unexpected("has no pixels");
  return *size;
}

tl::expected<std::vector<std::uint8_t>, std::string> decode_image(Bytes encoded) {
  if (const auto size = probe_webp(encoded)) return decode_webp(encoded, *size);
  if (const auto size = probe_jpeg(encoded)) return decode_jpeg(encoded, *size);
  if (const auto size = probe_avif(encoded)) return decode_avif(encoded, *size);
  if (probe_ktx2(encoded)) return decode_ktx2(encoded);
  const auto size = png_size(encoded);
  if (!size) return tl::make_unexpected(kUnknown);
  if (!png_chunks_fit(encoded)) return tl::make_unexpected("cannot be decoded: a chunk of the PNG leaves the file");
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(data_of(encoded), static_cast<int>(encoded.size()), &width, &height, &channels, 4),
      stbi_image_free);
  if (!pixels) return tl::make_unexpected(std::string("cannot be decoded: ") + stbi_failure_reason());
  return std::vector<std::uint8_t>(pixels.get(), pixels.get() + 4 * size->pixels());
}

}  // namespace sinew
