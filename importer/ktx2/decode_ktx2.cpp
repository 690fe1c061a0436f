// SPDX-License-Identifier: MIT
#include "importer/ktx2/decode_ktx2.h"

#include <zstd.h>

#include <algorithm>
#include <array>

#include "importer/ktx2/etc1s.h"
#include "importer/ktx2/ktx2_container.h"
#include "importer/ktx2/uastc.h"

namespace sinew {
namespace {

using Bytes = std::span<const std::byte>;
using Pixels = std::vector<std::uint8_t>;
using Decoded = tl::expected<Pixels, std::string>;

constexpr std::uint8_t kIdentifier[] = {0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb, '\r', '\n', 0x1a, '\n'};

constexpr std::uint8_t kUastcRedAlpha = 5;              // RRRG: the second channel is in alpha
constexpr std::uint8_t kEtc1sRed = 3, kEtc1sGreen = 4;  // RRR and GGG: a slice for each channel
constexpr std::uint32_t kPredictedFrame = 2;            // flag of an image that changes the one before

tl::unexpected<std::string> damaged(const char* part) {
  return tl::make_unexpected(std::string("is a damaged KTX2 file: ") + part);
}

tl::unexpected<std::string> not_decoded(const std::string& what) {
  return tl::make_unexpected("is a KTX2 file of " + what + ", which is not decoded");
}

struct BlockGrid {
  std::uint32_t width, height;
  std::uint32_t columns() const noexcept { return width / 4 + (width % 4 != 0); }
  std::uint32_t rows() const noexcept { return height / 4 + (height % 4 != 0); }
  std::uint64_t blocks() const noexcept { return std::uint64_t{columns()} * rows(); }
};

/// Copies the texels of one block that the picture has.
void place_block(const std::array<std::uint8_t, 64>& block, const BlockGrid& grid, std::uint32_t column,
                 std::uint32_t row, Pixels& rgba) {
  const std::uint32_t wide = std::min(4u, grid.width - 4 * column), high = std::min(4u, grid.height - 4 * row);
  for (std::uint32_t y = 0; y < high; ++y) {
    const std::size_t at = 4 * (std::size_t{4 * row + y} * grid.width + 4 * column);
    std::copy_n(block.data() + 16 * y, 4 * wide, rgba.data() + at);
  }
}

/// The base level without zstd.
tl::expected<std::vector<std::byte>, std::string> unpack_zstd(Bytes level, std::uint64_t size) {
  std::vector<std::byte> out(static_cast<std::size_t>(size));
  if (ZSTD_decompress(out.data(), out.size(), level.data(), level.size()) != out.size())
    return damaged("its zstd data are not those of a level of this size");
  return out;
}

Decoded decode_uastc(const Ktx2Texture& texture, Bytes blocks) {
  const BlockGrid grid{texture.width, texture.height};
  if (blocks.size() < kUastcBlockBytes * grid.blocks()) return damaged("its level has too few blocks");
  const bool red_green = texture.channels[0] == kUastcRedAlpha;
  Pixels rgba(std::size_t{4} * texture.width * texture.height);
  std::array<std::uint8_t, 64> texels{};
  for (std::uint32_t row = 0; row < grid.rows(); ++row)
    for (std::uint32_t column = 0; column < grid.columns(); ++column) {
      const auto block = blocks.subspan(kUastcBlockBytes * (std::size_t{row} * grid.columns() + column));
      if (!decode_uastc_block(block.first<kUastcBlockBytes>(), texels))
        return damaged("a UASTC block has no such mode");
      for (std::size_t t = 0; red_green && t < 64; t += 4) {
        texels[t + 1] = texels[t + 3];
        texels[t + 2] = 0;
        texels[t + 3] = 255;
      }
      place_block(texels, grid, column, row, rgba);
    }
  return rgba;
}

/// Header of BasisLZ global data: counts, byte lengths, then an entry for each image.
struct BasisGlobal {
  Etc1sCodebook codebook;
  Bytes slices[2];  ///< of the base level: color, and alpha or green if there is one
};

tl::expected<BasisGlobal, std::string> read_basis_global(const Ktx2Texture& texture) {
  constexpr std::size_t kListHeader = 20, kImageEntry = 20;
  const Bytes data = texture.global_data;
  const std::size_t lists = kListHeader + kImageEntry * texture.level_count;
  if (data.size() < lists) return damaged("its BasisLZ data are cut off");
  const auto word = [&](std::size_t at) { return read_little<std::uint32_t>(data, at); };
  Bytes parts[3];
  std::uint64_t at = lists;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t length = word(4 + 4 * i);
    if (length > data.size() - at) return damaged("its BasisLZ data are cut off");
    parts[i] = data.subspan(static_cast<std::size_t>(at), length);
    at += length;
  }
  if ((word(kListHeader) & kPredictedFrame) != 0) return not_decoded("a frame of a video");
  auto codebook = read_etc1s_codebook(read_little<std::uint16_t>(data, 0), read_little<std::uint16_t>(data, 2),
                                      parts[0], parts[1], parts[2]);
  if (!codebook) return damaged("its BasisLZ codebook");
  BasisGlobal out{std::move(*codebook), {}};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::uint64_t offset = word(kListHeader + 4 + 8 * i), length = word(kListHeader + 8 + 8 * i);
    if (offset > texture.base_level.size() || length > texture.base_level.size() - offset)
      return damaged("a slice leaves its level");
    out.slices[i] = texture.base_level.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
  }
  return out;
}

Decoded decode_etc1s(const Ktx2Texture& texture) {
  auto global = read_basis_global(texture);
  if (!global) return tl::make_unexpected(global.error());
  const Etc1sCodebook& codebook = global->codebook;
  const BlockGrid grid{texture.width, texture.height};
  const bool two_slices = !global->slices[1].empty();
  const auto color = decode_etc1s_slice(codebook, global->slices[0], grid.columns(), grid.rows());
  const auto second = two_slices ? decode_etc1s_slice(codebook, global->slices[1], grid.columns(), grid.rows()) : color;
  if (!color || !second) return damaged("an ETC1S slice");
  const bool red_green = two_slices && texture.channels[0] == kEtc1sRed && texture.channels[1] == kEtc1sGreen;
  Pixels rgba(std::size_t{4} * texture.width * texture.height);
  std::array<std::uint8_t, 64> texels{};
  for (std::uint32_t row = 0; row < grid.rows(); ++row)
    for (std::uint32_t column = 0; column < grid.columns(); ++column) {
      const std::size_t block = std::size_t{row} * grid.columns() + column;
      for (unsigned t = 0; t < 16; ++t) {
        std::uint8_t* texel = &texels[4 * t];
        std::uint8_t other[3]{};
        etc1s_texel(codebook, (*color)[block], t, texel);
        if (two_slices) etc1s_texel(codebook, (*second)[block], t, other);
        if (red_green) {
          texel[1] = other[1];
          texel[2] = 0;
        }
        texel[3] = two_slices && !red_green ? other[1] : std::uint8_t{255};
      }
      place_block(texels, grid, column, row, rgba);
    }
  return rgba;
}

/// Uncompressed Vulkan formats of 8 bits a channel.
struct PlainFormat {
  std::uint32_t unorm, srgb;  ///< VK_FORMAT_*
  std::uint8_t channels;
  bool blue_first;
};
constexpr PlainFormat kPlainFormats[] = {
    {9, 15, 1, false}, {16, 22, 2, false}, {23, 29, 3, false}, {30, 36, 3, true}, {37, 43, 4, false}, {44, 50, 4, true},
};

Decoded decode_plain(const Ktx2Texture& texture, const PlainFormat& format, Bytes texels) {
  const std::size_t count = std::size_t{texture.width} * texture.height;
  if (texels.size() / format.channels < count) return damaged("its level has too few texels");
  Pixels rgba(4 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto channel = [&](std::size_t c) { return std::to_integer<std::uint8_t>(texels[format.channels * i + c]); };
    std::uint8_t* out = &rgba[4 * i];
    out[0] = channel(format.blue_first ? 2 : 0);
    out[1] = format.channels == 1 ? out[0] : channel(1);
    out[2] = format.channels == 1   ? out[0]
             : format.channels == 2 ? std::uint8_t{0}
                                    : channel(format.blue_first ? 0 : 2);
    out[3] = format.channels == 4 ? channel(3) : std::uint8_t{255};
  }
  return rgba;
}

}  // namespace

std::optional<Ktx2Size> find_ktx2_size(Bytes encoded) noexcept {
  if (encoded.size() < 28) return std::nullopt;
  for (std::size_t i = 0; i < sizeof kIdentifier; ++i)
    if (std::to_integer<std::uint8_t>(encoded[i]) != kIdentifier[i]) return std::nullopt;
  return Ktx2Size{read_little<std::uint32_t>(encoded, 20), std::max(read_little<std::uint32_t>(encoded, 24), 1u)};
}

Decoded decode_ktx2(Bytes encoded) {
  const auto texture = read_ktx2(encoded);
  if (!texture) return tl::make_unexpected(texture.error());
  const auto plain = std::find_if(std::begin(kPlainFormats), std::end(kPlainFormats), [&](const PlainFormat& format) {
    return texture->vk_format == format.unorm || texture->vk_format == format.srgb;
  });
  const bool is_plain = plain != std::end(kPlainFormats);
  const bool is_basis =
      texture->vk_format == 0 && (texture->color_model == kModelUastc || texture->color_model == kModelEtc1s);
  if (!is_plain && !is_basis) {
    if (texture->vk_format != 0) return not_decoded("Vulkan format " + std::to_string(texture->vk_format));
    return not_decoded("color model " + std::to_string(texture->color_model));
  }
  if (texture->color_model == kModelEtc1s && is_basis) {
    if (texture->compression != Ktx2Compression::basis_lz) return not_decoded("ETC1S blocks without BasisLZ");
    return decode_etc1s(*texture);
  }
  Bytes level = texture->base_level;
  std::vector<std::byte> unpacked;
  if (texture->compression == Ktx2Compression::zstd) {
    const std::uint64_t bytes = is_plain ? std::uint64_t{texture->width} * texture->height * plain->channels
                                         : kUastcBlockBytes * BlockGrid{texture->width, texture->height}.blocks();
    if (texture->decoded_bytes != bytes) return damaged("its level has another size than its pixels");
    auto whole = unpack_zstd(level, bytes);
    if (!whole) return tl::make_unexpected(whole.error());
    unpacked = std::move(*whole);
    level = unpacked;
  } else if (texture->compression != Ktx2Compression::none) {
    return not_decoded("supercompression scheme " + std::to_string(static_cast<std::uint32_t>(texture->compression)));
  }
  return is_plain ? decode_plain(*texture, *plain, level) : decode_uastc(*texture, level);
}

}  // namespace sinew
