// SPDX-License-Identifier: MIT
#include "runtime/asset_file/asset_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "runtime/asset_file/read_assets.h"
#include "runtime/asset_file/write_asset_file.h"
#include "runtime/clip/clip_file.h"
#include "tests/asset_file/signed_file.h"
#include "tests/scenes/hand_scenes.h"

namespace sinew::test {
namespace {

using Bytes = std::vector<std::byte>;

constexpr std::size_t entry(std::size_t block) { return kAssetHead + block * kAssetEntry; }

/// The rule that a file breaks in any of its parts; empty = none.
std::string broken_rule(const Bytes& file) {
  const auto opened = AssetFile::open(file);
  if (!opened) return opened.error().rule;
  if (const auto scene = read_scene(*opened); !scene) return scene.error().rule;
  const auto sums = opened->check_sums();
  return sums ? "" : sums.error().rule;
}

/// Same, after changing a number of the table and signing the file again.
template <class T>
std::string broken_by(Bytes file, std::size_t at, T number) {
  put_number(std::span(file), at, number);
  sign_assets(file);
  return broken_rule(file);
}

TEST(asset_file, the_table_says_what_is_inside_and_where) {
  const Bytes file = write_asset_file(arm_scene(), {.truth = true});
  const auto opened = AssetFile::open(file);
  ASSERT_TRUE(opened);
  ASSERT_EQ(opened->blocks().size(), 4u);
  const char* names[] = {"skeleton", "model", "clips", "animations"};
  for (std::size_t i = 0; i < 4; ++i) {
    const AssetBlock& block = opened->blocks()[i];
    EXPECT_EQ(name_of(block.kind), names[i]);
    EXPECT_EQ(block.version, kAssetBlockVersion);
    EXPECT_EQ(block.offset % kAssetAlignment, 0u);
    EXPECT_EQ(block.skeleton_signature, opened->blocks()[0].skeleton_signature);
    EXPECT_TRUE(block.is_known);
  }
  std::vector<std::byte> unpacked;
  const auto bytes = opened->bytes_of(AssetKind::clips, unpacked);
  ASSERT_TRUE(bytes);
  EXPECT_EQ(bytes->data(), file.data() + opened->blocks()[2].offset) << "a view of the file";
  EXPECT_TRUE(looks_like_clips(*bytes));
}

TEST(asset_file, a_changed_block_is_refused_when_it_is_asked_for_and_others_are_read) {
  Bytes file = write_asset_file(arm_scene());
  file[AssetFile::open(file)->find(AssetKind::model)->offset + 40] ^= std::byte{1};
  const AssetFile opened = *AssetFile::open(file);
  std::vector<std::byte> unpacked;
  EXPECT_EQ(opened.bytes_of(AssetKind::model, unpacked).error().rule, "asset-checksum");
  EXPECT_EQ(opened.check_sums().error().block, "model");
  EXPECT_TRUE(read_skeleton(opened));
}

TEST(asset_file, every_changed_byte_is_noticed) {
  for (const int level : {0, 1}) {
    const Bytes file = write_asset_file(arm_scene(), {.zstd_level = level});
    ASSERT_EQ(broken_rule(file), "");
    for (std::size_t i = 0; i < file.size(); ++i) {
      Bytes changed = file;
      changed[i] ^= std::byte{0x10};
      ASSERT_NE(broken_rule(changed), "") << i;
    }
  }
}

TEST(asset_file, every_cut_is_refused_also_when_the_sizes_are_mended) {
  const Bytes file = write_asset_file(arm_scene());
  for (std::size_t size = 0; size < file.size(); ++size) {
    Bytes cut(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
    ASSERT_EQ(broken_rule(cut), size < 8 ? "asset-magic" : "asset-size") << size;
    sign_assets(cut);
    ASSERT_NE(broken_rule(cut), "") << size;
  }
  Bytes longer = file;
  longer.push_back(std::byte{0});
  EXPECT_EQ(broken_rule(longer), "asset-size");
  sign_assets(longer);
  EXPECT_EQ(broken_rule(longer), "asset-size");
}

TEST(asset_file, other_versions_of_the_file_and_of_blocks_are_refused_by_name) {
  const Bytes file = write_asset_file(arm_scene());
  EXPECT_EQ(broken_by(file, 8, kAssetFileVersion + 1), "asset-version");
  Bytes newer = file;
  put_number(std::span(newer), entry(1) + kEntryVersion, kAssetBlockVersion + 1);
  sign_assets(newer);
  const auto opened = AssetFile::open(newer);
  ASSERT_TRUE(opened) << "the rest of the file can be read";
  EXPECT_TRUE(read_skeleton(*opened));
  const auto scene = read_scene(*opened);
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().rule, "asset-version");
  EXPECT_EQ(scene.error().block, "model");
  EXPECT_THAT(describe(scene.error()),
              testing::HasSubstr("version " + std::to_string(kAssetBlockVersion + 1) + ", this library reads version " +
                                 std::to_string(kAssetBlockVersion)));
}

TEST(asset_file, blocks_of_unknown_kinds_are_left_alone) {
  Bytes file = write_asset_file(arm_scene(), {.truth = true});
  put_number(std::span(file), entry(3) + kEntryKind, std::uint32_t{4711});
  put_number(std::span(file), entry(3) + kEntryStorage, std::uint32_t{9});
  put_number(std::span(file), entry(3) + kEntryBytes, ~std::uint64_t{0});
  sign_assets(file);
  EXPECT_EQ(broken_rule(file), "");
  file.back() ^= std::byte{1};
  EXPECT_EQ(broken_rule(file), "asset-checksum");
}

TEST(asset_file, every_number_of_the_table_is_checked) {
  const Bytes file = write_asset_file(arm_scene());
  EXPECT_EQ(broken_by(file, 12, std::uint32_t{65}), "asset-value");
  EXPECT_EQ(broken_by(file, 12, std::uint32_t{64}), "asset-size");
  EXPECT_EQ(broken_by(file, entry(1) + kEntryKind, std::uint32_t{1}), "asset-value");
  EXPECT_EQ(broken_by(file, entry(1) + kEntryStorage, std::uint32_t{2}), "asset-value");
  EXPECT_EQ(broken_by(file, entry(1) + kEntryStorage + 4, std::uint32_t{1}), "asset-value") << "reserved";
  EXPECT_EQ(broken_by(file, entry(1) + kEntrySignature + 8, std::uint64_t{1}), "asset-value") << "reserved";
  EXPECT_EQ(broken_by(file, entry(1) + kEntryStorage, std::uint32_t{1}), "asset-size") << "no zstd";
  EXPECT_EQ(broken_by(file, entry(1) + 12, std::uint32_t{1}), "asset-value");
  EXPECT_EQ(broken_by(file, entry(1) + 56, std::uint64_t{1}), "asset-value");
  const auto offset = number_at<std::uint64_t>(file, entry(1) + kEntryOffset),
             size = number_at<std::uint64_t>(file, entry(1) + kEntryStored);
  EXPECT_EQ(broken_by(file, entry(1) + kEntryOffset, offset + 1), "asset-value");
  EXPECT_EQ(broken_by(file, entry(1) + kEntryOffset, offset + 64), "asset-value");
  EXPECT_EQ(broken_by(file, entry(1) + kEntryOffset, offset - 64), "asset-value");
  EXPECT_EQ(broken_by(file, entry(1) + kEntryStored, size + 1), "asset-value");
  EXPECT_EQ(broken_by(file, entry(2) + kEntryBytes, size + 1), "asset-value");
  EXPECT_EQ(broken_by(file, entry(0) + kEntrySignature, std::uint64_t{5}), "asset-signature");
  EXPECT_EQ(broken_by(file, entry(1) + kEntrySignature, std::uint64_t{5}), "asset-signature");
  EXPECT_EQ(broken_by(file, entry(2) + kEntrySignature, std::uint64_t{5}), "asset-signature");
}

TEST(asset_file, a_packed_block_that_unpacks_to_far_more_or_to_another_size_is_refused) {
  const Bytes file = write_asset_file(arm_scene(), {.zstd_level = 1});
  ASSERT_TRUE(AssetFile::open(file)->find(AssetKind::model)->is_packed);
  const auto bytes = number_at<std::uint64_t>(file, entry(1) + kEntryBytes);
  EXPECT_EQ(broken_by(file, entry(1) + kEntryBytes, bytes + 1), "asset-size");
  EXPECT_EQ(broken_by(file, entry(1) + kEntryBytes, bytes - 1), "asset-size");
  EXPECT_EQ(broken_by(file, entry(1) + kEntryBytes, std::uint64_t{1} << 40), "asset-memory");
}

TEST(asset_file, what_packs_so_well_that_it_looks_like_an_attack_is_left_as_it_is) {
  Scene scene = arm_scene();
  scene.images.resize(1);
  scene.images[0].width = scene.images[0].height = 3000;
  scene.images[0].rgba.resize(std::size_t{4} * 3000 * 3000);
  const Bytes file = write_asset_file(scene, {.zstd_level = 1});
  ASSERT_EQ(broken_rule(file), "");
  EXPECT_FALSE(AssetFile::open(file)->find(AssetKind::model)->is_packed);
}

TEST(asset_file, bytes_behind_the_last_field_of_a_block_are_refused) {
  Bytes file = write_asset_file(arm_scene(), {.model = false, .clips = false});
  file.push_back(std::byte{0});
  for (const std::size_t at : {kEntryStored, kEntryBytes})
    put_number(std::span(file), entry(0) + at, number_at<std::uint64_t>(file, entry(0) + at) + 1);
  sign_assets(file);
  const auto read = read_skeleton(*AssetFile::open(file));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().detail, "bytes follow the last field of the block");
}

TEST(asset_file, bytes_between_blocks_are_zero) {
  Bytes file = write_asset_file(arm_scene());
  const auto end =
      number_at<std::uint64_t>(file, entry(0) + kEntryOffset) + number_at<std::uint64_t>(file, entry(0) + kEntryStored);
  ASSERT_LT(end, number_at<std::uint64_t>(file, entry(1) + kEntryOffset)) << "the skeleton is followed by padding";
  EXPECT_EQ(broken_by(file, end, std::uint8_t{1}), "asset-value");
}

TEST(asset_file, compiled_clips_of_before_are_refused_with_the_way_on) {
  const Scene scene = arm_scene();
  const Clip* clips[] = {&scene.clips[0]};
  const auto opened = AssetFile::open(save_clips(clips));
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().rule, "asset-magic");
  EXPECT_THAT(describe(opened.error()), testing::HasSubstr("compile the model again, or read them with load_clips"));
}

}  // namespace
}  // namespace sinew::test
