// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string_view>

#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfRgbaFile.h>

#include "viewer/light/panorama.h"

// A private copy of stb_image, restricted to Radiance files.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_HDR
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 8192
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace sinew::viewer {
namespace {

using Bytes = std::span<const std::byte>;
using Decoded = tl::expected<Panorama, std::string>;

constexpr std::uint32_t kWidest = 8192;
constexpr std::array<unsigned char, 4> kExr = {0x76, 0x2f, 0x31, 0x01};

tl::unexpected<std::string> fails(std::string why) { return tl::unexpected(std::move(why)); }

bool starts_with(Bytes bytes, std::string_view text) noexcept {
  return bytes.size() >= text.size() && std::memcmp(bytes.data(), text.data(), text.size()) == 0;
}

/// Radiance is clamped to this, so that sums over all texels stay finite.
constexpr float kMostLight = 1e30f;

/// Replaces negative, infinite and NaN values by 0 and clamps to kMostLight.
glm::vec3 as_light(float r, float g, float b) noexcept {
  const auto channel = [](float v) { return std::isfinite(v) && v > 0.0f ? std::min(v, kMostLight) : 0.0f; };
  return {channel(r), channel(g), channel(b)};
}

std::string fault_of_size(std::int64_t width, std::int64_t height) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height);
  if (width < 2 || height < 1 || width != 2 * height) return size + ": a panorama is twice as wide as high";
  if (width > kWidest) return size + ": wider than " + std::to_string(kWidest);
  return {};
}

/// The pixel rows of a Radiance file: they follow the header fields, a blank line and the size line.
Bytes rows_of_radiance(Bytes bytes) noexcept {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::size_t fields = text.find("\n\n"), size = fields == text.npos ? fields : text.find('\n', fields + 2);
  return size == text.npos ? Bytes() : bytes.subspan(size + 1);
}

/// Checks the run lengths: false if the data ends too early or a run is 0, where stb_image would loop forever.
bool run_lengths_fit(Bytes rows, std::uint32_t width, std::uint32_t height) noexcept {
  std::size_t at = 0;
  const auto byte = [&](std::size_t i) { return std::to_integer<std::uint32_t>(rows[i]); };
  for (std::uint32_t y = 0; y < height; ++y) {
    if (rows.size() - at < 4) return false;
    if (byte(at) != 2 || byte(at + 1) != 2 || byte(at + 2) >= 128) return true;  // the rest is not run-length encoded
    at += 4;
    for (std::uint32_t channel = 0; channel < 4; ++channel)
      for (std::uint32_t x = 0; x < width;) {
        if (at == rows.size()) return false;
        const std::uint32_t code = byte(at), count = code > 128 ? code - 128 : code;
        const std::size_t stored = code > 128 ? 2 : 1 + count;
        if (count == 0 || rows.size() - at < stored) return false;
        at += stored;
        x += count;
      }
  }
  return true;
}

Decoded decode_radiance(Bytes bytes) {
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0)
    return fails(std::string("Radiance: ") + stbi_failure_reason());
  if (std::string fault = fault_of_size(width, height); !fault.empty()) return fails(std::move(fault));
  // Checked before allocation: even run-length encoding needs at least 4 bytes for each row.
  if (bytes.size() / 4 < static_cast<std::size_t>(height)) return fails("Radiance: the file ends too early");
  if (width >= 8 &&
      !run_lengths_fit(rows_of_radiance(bytes), static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)))
    return fails("Radiance: the run lengths of a row are damaged");
  const std::unique_ptr<float, void (*)(void*)> values(
      stbi_loadf_from_memory(data, size, &width, &height, &channels, 3), stbi_image_free);
  if (!values) return fails(std::string("Radiance: ") + stbi_failure_reason());
  Panorama panorama{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), {}};
  const std::size_t count = std::size_t{panorama.width} * panorama.height;
  panorama.texels.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    panorama.texels.push_back(as_light(values.get()[3 * i], values.get()[3 * i + 1], values.get()[3 * i + 2]));
  return panorama;
}

/// An OpenEXR input stream over bytes in memory.
class MemoryStream : public Imf::IStream {
 public:
  explicit MemoryStream(Bytes bytes) : Imf::IStream("panorama"), bytes_(bytes) {}
  bool read(char to[], int count) override {
    if (count < 0 || static_cast<std::size_t>(count) > bytes_.size() - at_) throw std::runtime_error("the file ends");
    std::memcpy(to, bytes_.data() + at_, static_cast<std::size_t>(count));
    at_ += static_cast<std::size_t>(count);
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t position) override { at_ = std::min<std::size_t>(position, bytes_.size()); }

 private:
  Bytes bytes_;
  std::size_t at_ = 0;
};

Decoded decode_exr(Bytes bytes) {
  MemoryStream stream(bytes);
  Imf::RgbaInputFile file(stream);
  const Imath::Box2i window = file.dataWindow();
  const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1,
                     height = std::int64_t{window.max.y} - window.min.y + 1;
  if (std::string fault = fault_of_size(width, height); !fault.empty()) return fails(std::move(fault));
  Panorama panorama{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), {}};
  panorama.texels.reserve(static_cast<std::size_t>(width * height));
  std::vector<Imf::Rgba> row(static_cast<std::size_t>(width));
  for (int y = window.min.y; y <= window.max.y; ++y) {
    file.setFrameBuffer(row.data() - window.min.x, 1, 0);
    file.readPixels(y);
    for (const Imf::Rgba& texel : row) panorama.texels.push_back(as_light(texel.r, texel.g, texel.b));
  }
  return panorama;
}

}  // namespace

tl::expected<Panorama, std::string> decode_panorama(std::span<const std::byte> bytes) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return fails("larger than 2 GiB");
  if (starts_with(bytes, "#?RADIANCE") || starts_with(bytes, "#?RGBE")) return decode_radiance(bytes);
  if (bytes.size() < kExr.size() || std::memcmp(bytes.data(), kExr.data(), kExr.size()) != 0)
    return fails("neither Radiance (.hdr) nor OpenEXR (.exr)");
  try {
    return decode_exr(bytes);
  } catch (const std::exception& error) {  // OpenEXR reports errors as exceptions
    return fails(std::string("OpenEXR: ") + error.what());
  }
}

}  // namespace sinew::viewer
