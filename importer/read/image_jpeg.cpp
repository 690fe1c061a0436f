// SPDX-License-Identifier: MIT
#include "importer/read/image_jpeg.h"

#include <turbojpeg.h>

#include <memory>

namespace sinew {
namespace {

using Bytes = std::span<const std::byte>;

const unsigned char* jpeg_data(Bytes bytes) noexcept { return reinterpret_cast<const unsigned char*>(bytes.data()); }

/// Owns a libjpeg-turbo decompressor.
class Jpeg {
 public:
  explicit Jpeg(Bytes encoded) : encoded_(encoded), handle_(tjInitDecompress(), &tjDestroy) {}

  std::optional<ImageHeader> size() const {
    int width = 0, height = 0, subsampling = 0, colors = 0;
    if (!handle_ || encoded_.size() < 2 || jpeg_data(encoded_)[0] != 0xff || jpeg_data(encoded_)[1] != 0xd8)
      return std::nullopt;
    if (tjDecompressHeader3(handle_.get(), jpeg_data(encoded_), encoded_.size(), &width, &height, &subsampling,
                            &colors) != 0)
      return std::nullopt;
    return ImageHeader{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), "image/jpeg"};
  }

  /// Refuses files with an excessive number of progressive scans. A truncated file gives the available pixels.
  tl::expected<std::vector<std::uint8_t>, std::string> pixels(const ImageHeader& size) const {
    std::vector<std::uint8_t> rgba(4 * size.pixels());
    const int failed =
        tjDecompress2(handle_.get(), jpeg_data(encoded_), encoded_.size(), rgba.data(), static_cast<int>(size.width), 0,
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

std::optional<ImageHeader> probe_jpeg(Bytes encoded) { return Jpeg(encoded).size(); }

tl::expected<std::vector<std::uint8_t>, std::string> decode_jpeg(Bytes encoded, const ImageHeader& size) {
  return Jpeg(encoded).pixels(size);
}

}  // namespace sinew
