// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <tl/expected.hpp>

namespace sinew {

/// Compression of a whole mip level (KTX 2.0, table "Supercompression Schemes").
enum class Ktx2Compression : std::uint32_t { none = 0, basis_lz = 1, zstd = 2, zlib = 3 };

/// Color models of the Khronos Data Format Specification that KHR_texture_basisu uses.
constexpr std::uint8_t kModelEtc1s = 163, kModelUastc = 166;

/// The parts of a KTX 2.0 file that its largest image needs. Spans point into the file.
struct Ktx2Texture {
  std::uint32_t width = 0, height = 0;
  std::uint32_t vk_format = 0;  ///< 0 = the color model says the format
  Ktx2Compression compression = Ktx2Compression::none;
  std::uint8_t color_model = 0;
  std::uint8_t channels[2]{};       ///< channel of the first and second sample (KDF_CHANNEL)
  std::uint32_t sample_count = 0;   ///< samples of the data format descriptor, at least 1
  std::uint32_t level_count = 1;    ///< mip levels in the file
  std::uint64_t decoded_bytes = 0;  ///< bytes of the base level without its compression
  std::span<const std::byte> base_level, global_data;
};

/// Reads the header, the index of levels and the data format descriptor of a 2D texture.
/// source   KTX File Format Specification 2.0, "File Structure"; Khronos Data Format Specification 1.4, "Basic"
/// in       encoded   starts with the identifier of KTX 2.0
/// err      a message for users: what leaves the file, or which kind of texture it is (cube map, array, 3D)
/// cost     O(1)
tl::expected<Ktx2Texture, std::string> read_ktx2(std::span<const std::byte> encoded);

/// Reads a little-endian number.   in   at + sizeof(Number) <= bytes.size()
template <class Number>
Number read_little(std::span<const std::byte> bytes, std::size_t at) noexcept {
  Number value = 0;
  for (std::size_t i = sizeof(Number); i-- > 0;)
    value = static_cast<Number>(static_cast<std::uint64_t>(value) << 8 | std::to_integer<std::uint64_t>(bytes[at + i]));
  return value;
}

}  // namespace sinew
