// SPDX-License-Identifier: MIT
#include "importer/read/image_codec.h"

#include <turbojpeg.h>
#include <webp/decode.h>

#include <limits>
#include <memory>
#include <optional>

#include "importer/read/image_avif.h"
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

constexpr const char* kUnknown = "is no undamaged PNG, JPEG, WebP or AVIF file";

const unsigned char* data_of(Bytes bytes) noexcept { return reinterpret_cast<const unsigned char*>(bytes.data()); }

std::optional<ImageHeader> webp_size(Bytes encoded) {
  int width = 0, height = 0;
  if (WebPGetInfo(data_of(encoded), encoded.size(), &width, &height) == 0) return std::nullopt;
  return ImageHeader{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), "image/webp"};
}

std::optional<ImageHeader> png_size(Bytes encoded) {
  if (encoded.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return std::nullopt;
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_memory(data_of(encoded), static_cast<int>(encoded.size()), &width, &height, &channels) == 0)
    return std::nullopt;
  return ImageHeader{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), "image/png"};
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

/// Owns a libjpeg-turbo decompressor.
class Jpeg {
 public:
  explicit Jpeg(Bytes encoded) : encoded_(encoded), handle_(tjInitDecompress(), &tjDestroy) {}

  std::optional<ImageHeader> size() const {
    int width = 0, height = 0, subsampling = 0, colors = 0;
    if (!handle_ || encoded_.size() < 2 || data_of(encoded_)[0] != 0xff || data_of(encoded_)[1] != 0xd8)
      return std::nullopt;
    if (tjDecompressHeader3(handle_.get(), data_of(encoded_), encoded_.size(), &width, &height, &subsampling,
                            &colors) != 0)
      return std::nullopt;
    return ImageHeader{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), "image/jpeg"};
  }

  /// Refuses files with an excessive number of progressive scans. A truncated file gives the available pixels.
  tl::expected<std::vector<std::uint8_t>, std::string> pixels(const ImageHeader& size) const {
    std::vector<std::uint8_t> rgba(4 * size.pixels());
    const int failed =
        tjDecompress2(handle_.get(), data_of(encoded_), encoded_.size(), rgba.data(), static_cast<int>(size.width), 0,
                      static_cast<int>(size.height), TJPF_RGBA, TJFLAG_LIMITSCANS);
    if (failed != 0 && tjGetErrorCode(handle_.get()) == TJERR_FATAL)
      return tl::make_unexpected(std::string("cannot be decoded: ") + tjGetErrorStr2(handle_.get()));
    return rgba;
  }

 private:
  Bytes encoded_;
  std::unique_ptr<void, int (*)(tjhandle)> handle_;
};

}  // namespace

tl::expected<ImageHeader, std::string> probe_image(Bytes encoded) {
  auto size = png_size(encoded);
  if (!size) size = Jpeg(encoded).size();
  if (!size) size = webp_size(encoded);
  if (!size) size = probe_avif(encoded);
  if (!size) size = probe_undecoded_image(encoded);
  if (!size) return tl::make_unexpected(kUnknown);
  if (size->pixels() == 0) return tl::make_unexpected("has no pixels");
  return *size;
}

tl::expected<std::vector<std::uint8_t>, std::string> decode_image(Bytes encoded) {
  if (const auto size = webp_size(encoded)) {
    std::vector<std::uint8_t> rgba(4 * size->pixels());
    if (WebPDecodeRGBAInto(data_of(encoded), encoded.size(), rgba.data(), rgba.size(),
                           static_cast<int>(4 * size->width)) == nullptr)
      return tl::make_unexpected("its WebP data is damaged");
    return rgba;
  }
  const Jpeg jpeg(encoded);
  if (const auto size = jpeg.size()) return jpeg.pixels(*size);
  if (const auto size = probe_avif(encoded)) return decode_avif(encoded, *size);
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
