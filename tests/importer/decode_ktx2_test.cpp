// SPDX-License-Identifier: MIT
#include "importer/ktx2/decode_ktx2.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "importer/ktx2/basis_bits.h"
#include "importer/ktx2/uastc.h"
#include "importer/read/image_codec.h"
#include "tests/importer/ktx2_samples.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using File = std::vector<std::byte>;

constexpr std::uint8_t kUastc = 166, kRgb = 0;
constexpr std::uint32_t kZlib = 3;

/// Sizes and places in the header of a KTX2 file.
constexpr std::size_t kVkFormat = 12, kDepth = 28, kLayers = 32, kFaces = 36, kLevels = 40, kCompression = 44;
constexpr std::size_t kDescriptorLength = 52, kGlobalOffset = 64, kLevelOffset = 80, kLevelBytes = 96;

void set_word(File& file, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) file[at + i] = static_cast<std::byte>(value >> 8 * i);
}

std::string outcome(const File& file) {
  const auto decoded = decode_image(file);
  return decoded ? "decoded" : decoded.error();
}

std::array<std::byte, 16> block_of(const std::vector<std::byte>& bytes) {
  std::array<std::byte, 16> block{};
  std::copy_n(bytes.begin(), block.size(), block.begin());
  return block;
}

TEST(decode_uastc_block, has_the_texels_of_basis_universal_in_every_mode) {
  unsigned mode = 0;
  for (const auto& sample : test::uastc_samples()) {
    EXPECT_EQ(sample.mode, mode++);
    std::array<std::uint8_t, 64> texels{};
    ASSERT_TRUE(decode_uastc_block(block_of(sample.block), texels)) << sample.mode;
    EXPECT_TRUE(std::equal(texels.begin(), texels.end(), sample.rgba.begin(), sample.rgba.end())) << sample.mode;
  }
  EXPECT_EQ(mode, 19u);
}

/// FNV-1a of 64 bits.
std::uint64_t hash_of(std::span<const std::uint8_t> bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3u;
  return hash;
}

TEST(decode_uastc_block, has_the_subsets_of_basis_universal_in_every_pattern) {
  const auto& sample = test::uastc_pattern_blocks();
  std::vector<std::uint8_t> texels(4 * sample.data.size());
  for (std::size_t i = 0; i < sample.data.size() / 16; ++i)
    ASSERT_TRUE(decode_uastc_block(std::span(sample.data).subspan(16 * i).first<16>(),
                                   std::span(texels).subspan(64 * i).first<64>()));
  EXPECT_EQ(texels.size(), 64u * (30 + 11 + 19));
  EXPECT_EQ(hash_of(texels), sample.texel_hash);
}

TEST(decode_uastc_block, refuses_the_reserved_mode_and_patterns_that_do_not_exist) {
  std::array<std::uint8_t, 64> texels{};
  texels.fill(7);
  std::array<std::byte, 16> block{};
  block[0] = std::byte{0x45};
  EXPECT_FALSE(decode_uastc_block(block, texels));
  struct {
    std::uint8_t code;
    std::uint32_t pattern_at, patterns;
  } const kModes[] = {{0x1d, 20, 30}, {0x03, 20, 11}, {0x07, 20, 19}};
  for (const auto& mode : kModes)
    for (const std::uint32_t pattern : {mode.patterns - 1, mode.patterns}) {
      const std::uint32_t bits = mode.code | pattern << mode.pattern_at;
      for (std::size_t i = 0; i < 4; ++i) block[i] = static_cast<std::byte>(bits >> 8 * i);
      texels.fill(7);
      EXPECT_EQ(decode_uastc_block(block, texels), pattern < mode.patterns) << pattern;
      EXPECT_EQ(texels[0] == 7, pattern == mode.patterns) << "a refused block writes nothing";
    }
}

TEST(HuffmanCode, refuses_more_codes_than_there_are_and_reads_shorter_ones_first) {
  const std::uint8_t kTooMany[] = {1, 1, 1}, kLone[] = {0, 0, 1}, kThree[] = {2, 1, 2};
  EXPECT_FALSE(HuffmanCode::make(kTooMany));
  const File zeros(1), ones(1, std::byte{0xff}), mixed(1, std::byte{0b00011010});
  BasisBits first(zeros), second(ones), third(mixed);
  EXPECT_EQ(HuffmanCode::make(kLone)->next(first), 2u);
  EXPECT_EQ(HuffmanCode::make(kLone)->next(second), HuffmanCode::kNone) << "the other half is no code";
  const auto code = *HuffmanCode::make(kThree);  // 1: 0, 0: 10, 2: 11
  EXPECT_EQ(code.next(third), 1u);
  EXPECT_EQ(code.next(third), 0u);
  EXPECT_EQ(code.next(third), 2u);
  EXPECT_FALSE(third.overrun());
  third.take(4);
  EXPECT_TRUE(third.overrun());
}

TEST(decode_ktx2, has_the_texels_of_basis_universal) {
  for (const auto* sample : {&test::etc1s_sample(), &test::etc1s_alpha_sample(), &test::uastc_zstd_sample()}) {
    const auto size = probe_image(sample->file);
    ASSERT_TRUE(size);
    EXPECT_EQ(size->width, sample->width);
    EXPECT_EQ(size->height, sample->height);
    EXPECT_STREQ(size->mime_type, "image/ktx2");
    const auto texels = decode_image(sample->file);
    ASSERT_TRUE(texels) << texels.error();
    EXPECT_EQ(*texels, sample->rgba);
  }
  const auto& large = test::etc1s_large_file();
  EXPECT_EQ(hash_of(decode_image(large.data).value()), large.texel_hash);
}

TEST(decode_ktx2, shows_the_second_channel_of_a_picture_of_two_as_green) {
  const auto& sample = test::uastc_samples()[11];  // RGBA with weights of its own for one channel
  const auto rgba = *decode_image(test::write_ktx2(4, 4, 0, kUastc, 3, sample.block));
  const auto red_green = *decode_image(test::write_ktx2(4, 4, 0, kUastc, 5, sample.block));
  EXPECT_EQ(rgba, sample.rgba);
  for (std::size_t i = 0; i < rgba.size(); i += 4)
    EXPECT_THAT(std::vector(&red_green[i], &red_green[i] + 4), ElementsAre(rgba[i], rgba[i + 3], 0, 255));

  auto two_slices = test::etc1s_alpha_sample();
  const std::size_t samples = std::to_integer<std::size_t>(two_slices.file[48]) + 28;
  two_slices.file[samples + 3] = std::byte{3};
  two_slices.file[samples + 19] = std::byte{4};
  const auto texels = *decode_image(two_slices.file);
  for (std::size_t i = 0; i < texels.size(); i += 4)
    EXPECT_THAT(std::vector(&texels[i], &texels[i] + 4),
                ElementsAre(two_slices.rgba[i], two_slices.rgba[i + 3], 0, 255));
}

TEST(decode_ktx2, reads_formats_of_8_bits_a_channel) {
  const File level{std::byte{1}, std::byte{2}, std::byte{3}, std::byte{4}};
  const auto texel = [&](std::uint32_t format, std::size_t channels) {
    return decode_image(test::write_ktx2(1, 1, format, 1, 0, std::span(level).first(channels))).value();
  };
  EXPECT_THAT(texel(9, 1), ElementsAre(1, 1, 1, 255)) << "R8_UNORM";
  EXPECT_THAT(texel(22, 2), ElementsAre(1, 2, 0, 255)) << "R8G8_SRGB";
  EXPECT_THAT(texel(23, 3), ElementsAre(1, 2, 3, 255)) << "R8G8B8_UNORM";
  EXPECT_THAT(texel(36, 3), ElementsAre(3, 2, 1, 255)) << "B8G8R8_SRGB";
  EXPECT_THAT(texel(37, 4), ElementsAre(1, 2, 3, 4)) << "R8G8B8A8_UNORM";
  EXPECT_THAT(texel(50, 4), ElementsAre(3, 2, 1, 4)) << "B8G8R8A8_SRGB";
  EXPECT_THAT(outcome(test::write_ktx2(2, 1, 37, 1, 0, level)), HasSubstr("too few texels"));
}

TEST(decode_ktx2, names_what_it_does_not_decode) {
  const File block(16);
  const File file = test::write_ktx2(4, 4, 0, kUastc, kRgb, block);
  const auto with = [&](std::size_t at, std::uint32_t value) {
    File other = file;
    set_word(other, at, value);
    return outcome(other);
  };
  EXPECT_EQ(outcome(file), "decoded");
  for (const std::size_t at : {kDepth, kLayers}) EXPECT_THAT(with(at, 2), HasSubstr("cube texture")) << at;
  EXPECT_THAT(with(kFaces, 6), HasSubstr("cube texture"));
  EXPECT_THAT(with(kVkFormat, 145), HasSubstr("Vulkan format 145, which is not decoded"));
  EXPECT_THAT(with(kCompression, kZlib), HasSubstr("supercompression scheme 3, which is not decoded"));
  EXPECT_THAT(outcome(test::write_ktx2(4, 4, 0, 162, kRgb, block)), HasSubstr("color model 162"));
  EXPECT_THAT(outcome(test::write_ktx2(4, 4, 0, 163, kRgb, block)), HasSubstr("ETC1S blocks without BasisLZ"));
  File video = test::etc1s_sample().file;
  const auto global =
      std::to_integer<std::size_t>(video[kGlobalOffset]) + 256 * std::to_integer<std::size_t>(video[kGlobalOffset + 1]);
  video[global + 20] |= std::byte{2};
  EXPECT_THAT(outcome(video), HasSubstr("a frame of a video"));
}

TEST(decode_ktx2, names_damage) {
  const File file = test::write_ktx2(4, 4, 0, kUastc, kRgb, File(16));
  const auto with = [&](std::size_t at, std::uint32_t value) {
    File other = file;
    set_word(other, at, value);
    return outcome(other);
  };
  EXPECT_THAT(with(kLevels, 33), HasSubstr("33 levels"));
  EXPECT_THAT(with(kLevels, 5), HasSubstr("index of levels is cut off"));
  EXPECT_THAT(with(kDescriptorLength, 20), HasSubstr("data format descriptor"));
  EXPECT_THAT(with(kLevelOffset, 161), HasSubstr("its data leave the file"));
  EXPECT_THAT(with(kLevelOffset + 4, 0xffffffff), HasSubstr("its data leave the file"));
  EXPECT_THAT(with(160, 0x45), HasSubstr("a UASTC block has no such mode"));
  EXPECT_THAT(outcome(test::write_ktx2(5, 4, 0, kUastc, kRgb, File(16))), HasSubstr("too few blocks"));
  File zstd = test::uastc_zstd_sample().file;
  zstd[std::to_integer<std::size_t>(zstd[kLevelOffset])] ^= std::byte{0xff};
  EXPECT_THAT(outcome(zstd), HasSubstr("its zstd data are not those"));
  zstd = test::uastc_zstd_sample().file;
  set_word(zstd, kLevelBytes, 1u << 30);
  EXPECT_THAT(outcome(zstd), HasSubstr("another size than its pixels")) << "before so much memory is taken";
}

/// Files that are cut at each byte, and files of which some bits are turned over, end with a sentence or with texels.
TEST(decode_ktx2, survives_any_damage) {
  test::FixedRandom random(12);
  for (const auto* sample : {&test::etc1s_sample(), &test::etc1s_alpha_sample(), &test::uastc_zstd_sample()}) {
    std::size_t refused = 0;
    for (std::size_t size = 0; size < sample->file.size(); ++size) {
      const File cut(sample->file.begin(), sample->file.begin() + static_cast<std::ptrdiff_t>(size));
      refused += decode_image(cut).has_value() ? 0 : 1;
    }
    EXPECT_GE(refused + 1, sample->file.size()) << "only the last byte may be one that no code needs";
    for (int i = 0; i < 2000; ++i) {
      File other = sample->file;
      for (int bit = 0; bit < 3; ++bit)
        other[random.below(static_cast<std::uint32_t>(other.size()))] ^= static_cast<std::byte>(1u << random.below(8));
      const auto size = probe_image(other);
      if (!size || size->pixels() > 1u << 16) continue;
      const auto texels = decode_image(other);
      if (texels) {
        EXPECT_EQ(texels->size(), 4 * size->pixels());
      }
    }
  }
}

TEST(import_gltf, prefers_the_image_of_KHR_texture_basisu) {
  test::TinyGltf file;
  file.add_triangle()["material"] = 0;
  file.root["extensionsUsed"] = file.root["extensionsRequired"] = {"KHR_texture_basisu"};
  const auto& sample = test::etc1s_alpha_sample();
  file.root["images"] = {{{"bufferView", file.add_view(sample.file)}, {"mimeType", "image/ktx2"}},
                         {{"uri", "missing.png"}}};
  file.root["textures"] = {{{"source", 1}, {"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}}};
  file.root["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  const auto result = file.import();
  ASSERT_EQ(test::outcome(result), "ok");
  const Image& image = result->scene.images[result->scene.textures[0].image];
  EXPECT_EQ(image.mime_type, "image/ktx2");
  EXPECT_EQ(image.rgba, sample.rgba);
}

}  // namespace
}  // namespace sinew
