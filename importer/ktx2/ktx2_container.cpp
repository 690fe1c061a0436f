// SPDX-License-Identifier: MIT
#include "importer/ktx2/ktx2_container.h"

#include <algorithm>
#include <optional>

namespace sinew {
namespace {

using Bytes = std::span<const std::byte>;

constexpr std::size_t kHeaderBytes = 80, kLevelEntry = 24;
constexpr std::size_t kDescriptorHeader = 28, kSample = 16;  // sizes within the data format descriptor
constexpr std::uint32_t kMostLevels = 32;

tl::unexpected<std::string> damaged_file(const std::string& what) {
  return tl::make_unexpected("is a damaged KTX2 file: " + what);
}

/// The bytes [offset, offset + length); empty if they leave the file.
std::optional<Bytes> part(Bytes file, std::uint64_t offset, std::uint64_t length) {
  if (offset > file.size() || length > file.size() - offset) return std::nullopt;
  return file.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
}

/// Reads color model and channels from the first block of the descriptor.   out   false if it is too short
bool read_descriptor(Bytes descriptor, Ktx2Texture& out) {
  if (descriptor.size() < kDescriptorHeader) return false;
  const auto vendor_and_type = read_little<std::uint32_t>(descriptor, 4);
  const std::size_t block_size = read_little<std::uint16_t>(descriptor, 10);
  if (vendor_and_type != 0 || block_size + 4 > descriptor.size() || block_size + 4 < kDescriptorHeader) return false;
  out.color_model = std::to_integer<std::uint8_t>(descriptor[12]);
  out.sample_count = static_cast<std::uint32_t>((block_size + 4 - kDescriptorHeader) / kSample);
  for (std::uint32_t i = 0; i < std::min(out.sample_count, 2u); ++i)
    out.channels[i] = std::to_integer<std::uint8_t>(descriptor[kDescriptorHeader + i * kSample + 3]) & 0x0f;
  return out.sample_count > 0;
}

}  // namespace

tl::expected<Ktx2Texture, std::string> read_ktx2(Bytes encoded) {
  if (encoded.size() < kHeaderBytes + kLevelEntry) return damaged_file("its header is cut off");
  const auto word = [&](std::size_t at) { return read_little<std::uint32_t>(encoded, at); };
  const auto wide = [&](std::size_t at) { return read_little<std::uint64_t>(encoded, at); };
  Ktx2Texture out;
  out.vk_format = word(12);
  out.width = word(20);
  out.height = word(24);
  if (out.width == 0 || out.height == 0 || word(28) > 1 || word(32) > 1 || word(36) != 1)
    return tl::make_unexpected(std::string("is a KTX2 file of a 1D, 3D, array or cube texture, not of a 2D texture"));
  out.level_count = std::max(word(40), 1u);
  if (out.level_count > kMostLevels) return damaged_file("it has " + std::to_string(out.level_count) + " levels");
  out.compression = static_cast<Ktx2Compression>(word(44));
  if (encoded.size() < kHeaderBytes + kLevelEntry * out.level_count)
    return damaged_file("its index of levels is cut off");
  const auto descriptor = part(encoded, word(48), word(52));
  if (!descriptor || !read_descriptor(*descriptor, out)) return damaged_file("its data format descriptor is wrong");
  const auto global = part(encoded, wide(64), wide(72));
  const auto level = part(encoded, wide(kHeaderBytes), wide(kHeaderBytes + 8));
  if (!global || !level) return damaged_file("its data leave the file");
  out.global_data = *global;
  out.base_level = *level;
  out.decoded_bytes = wide(kHeaderBytes + 16);
  return out;
}

}  // namespace sinew
