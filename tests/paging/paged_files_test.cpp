// SPDX-License-Identifier: MIT
// .sinew files with paged clips.
#include <gtest/gtest.h>
#include <zstd.h>

#include <algorithm>
#include <cmath>

#include "runtime/animation/skeleton_signature.h"
#include "runtime/asset_file/read_assets.h"
#include "runtime/asset_file/read_pages.h"
#include "runtime/asset_file/write_asset_file.h"
#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/paging/paged_clip.h"
#include "tests/asset_file/full_scene.h"
#include "tests/asset_file/played_frames.h"
#include "tests/asset_file/signed_file.h"
#include "tests/paging/pages.h"
#include "tests/support/case_step.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

using Bytes = std::vector<std::byte>;

constexpr double kFilePage_s = 0.4;

Bytes paged_file(const Scene& scene, int zstd_level = 0) {
  return write_asset_file(scene, {.page_s = kFilePage_s, .zstd_level = zstd_level});
}

std::span<const std::byte> stored_page(const Bytes& file, const PageTable& table, std::size_t page) {
  return std::span(file).subspan(table.offsets[page], table.offsets[page + 1] - table.offsets[page]);
}

Bytes saved(const Clip& clip) {
  const Clip* const clips[] = {&clip};
  return save_clips(clips);
}

/// Rule and text of the first error when the whole file is read; empty if there is none.
std::string error_of(const Bytes& file) {
  const auto opened = AssetFile::open(file);
  if (!opened) return describe(opened.error());
  const auto scene = read_scene(*opened);
  return scene ? "" : describe(scene.error());
}

TEST(paged_files, readers_of_whole_clips_get_them_bit_for_bit) {
  for (const int level : {0, 3}) {
    const Scene scene = full_scene(1);
    const Bytes file = paged_file(scene, level);
    const auto opened = AssetFile::open(file);
    ASSERT_TRUE(opened);
    ASSERT_NE(opened->find(AssetKind::page_keys), nullptr);
    const auto read = read_scene(*opened);
    ASSERT_TRUE(read) << describe(read.error());
    ASSERT_EQ(read->clips.size(), scene.clips.size());
    for (std::size_t c = 0; c < scene.clips.size(); ++c) EXPECT_EQ(saved(read->clips[c]), saved(scene.clips[c]));
    EXPECT_EQ(hashes_of_frames(*read), hashes_of_frames(scene));
    EXPECT_TRUE(opened->check_sums());
  }
}

TEST(paged_files, an_engine_plays_the_pages_from_the_bytes_of_the_file) {
  for (const int level : {0, 5}) {
    const Scene scene = full_scene(2);
    const Bytes file = paged_file(scene, level);
    const AssetFile opened = *AssetFile::open(file);
    Bytes unpacked;
    const auto heads = read_clips(opened, skeleton_signature(scene.skeleton), LongClips::first_keys);
    ASSERT_TRUE(heads);
    const auto tables = read_page_tables(opened);
    ASSERT_TRUE(tables);
    ASSERT_EQ(tables->size(), heads->size());
    for (std::size_t c = 0; c < heads->size(); ++c) {
      const PageTable& table = (*tables)[c];
      ASSERT_GT(table.page_count(), 1u) << c;
      EXPECT_EQ(saved((*heads)[c]), saved(first_keys(scene.clips[c])));
      PagedClip paged((*heads)[c], table.page_s, table.page_count());
      for (double t = 0.0; t < scene.clips[c].duration_s(); t += 0.03) {
        paged.at(t);
        while (const auto page = paged.next_page()) {
          const auto bytes = unpack_page(stored_page(file, table, *page), unpacked);
          ASSERT_TRUE(bytes) << describe(bytes.error());
          const auto taken = paged.load_page(*page, *bytes);
          ASSERT_TRUE(taken) << taken.error().detail;
        }
        const PageSample at = paged.at(t);
        ASSERT_FALSE(at.is_missing);
        ASSERT_EQ(numbers_at(at.page, t), numbers_at(scene.clips[c], t)) << t;
      }
    }
  }
}

TEST(paged_files, pages_are_packed_where_they_get_smaller_by_it_each_by_itself) {
  const Scene scene = full_scene(2);
  const Bytes raw_file = paged_file(scene), file = paged_file(scene, 5);
  const auto raw = read_page_tables(*AssetFile::open(raw_file)), tables = read_page_tables(*AssetFile::open(file));
  ASSERT_TRUE(raw && tables);
  std::size_t smaller = 0;
  for (std::size_t c = 0; c < tables->size(); ++c)
    for (std::size_t p = 0; p < (*tables)[c].page_count(); ++p) {
      const auto was = stored_page(raw_file, (*raw)[c], p), is = stored_page(file, (*tables)[c], p);
      EXPECT_LE(is.size(), was.size());
      smaller += is.size() < was.size();
      Bytes unpacked;
      EXPECT_TRUE(same_bits<std::byte>(*unpack_page(is, unpacked), was));
      EXPECT_EQ(unpacked.empty(), is.size() == was.size()) << "what is not packed is not copied";
    }
  EXPECT_GT(smaller, 3u);
}

TEST(paged_files, a_packed_page_that_is_damaged_or_asks_for_much_memory_is_refused) {
  const Bytes zeros(100'000);
  const auto packed = [](const Bytes& bytes) {
    Bytes out(ZSTD_compressBound(bytes.size()));
    out.resize(ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 3));
    return out;
  };
  Bytes unpacked;
  const auto rule_of = [&](const Bytes& page) {
    const auto bytes = unpack_page(page, unpacked);
    return bytes ? std::string() : bytes.error().rule;
  };
  EXPECT_EQ(rule_of(packed(zeros)), "asset-memory") << "thousands of times its bytes";
  EXPECT_TRUE(unpacked.empty());
  Bytes page = packed(pages_of(full_scene(2).clips[0], kFilePage_s)[0]);
  EXPECT_EQ(rule_of(page), "");
  page.pop_back();
  EXPECT_EQ(rule_of(page), "asset-size");
  EXPECT_EQ(rule_of({}), "") << "no packed bytes: load_page says what is wrong with them";
}

TEST(paged_files, clips_no_longer_than_a_page_stay_whole) {
  Scene scene = full_scene(3);
  const double longest = std::max(scene.clips[0].duration_s(), scene.clips[1].duration_s());
  const Bytes file = write_asset_file(scene, {.page_s = longest});
  EXPECT_EQ(AssetFile::open(file)->find(AssetKind::pages), nullptr);
  EXPECT_EQ(file, write_asset_file(scene));
  EXPECT_TRUE(read_page_tables(*AssetFile::open(file))->empty());
}

TEST(paged_files, scenes_of_first_keys_are_valid_and_have_the_durations_of_their_clips) {
  const Scene scene = full_scene(4);
  const Bytes file = paged_file(scene);
  const auto heads = read_scene(*AssetFile::open(file), LongClips::first_keys);
  ASSERT_TRUE(heads) << describe(heads.error());
  EXPECT_EQ(check(*heads), ErrorCode::ok);
  for (std::size_t c = 0; c < scene.clips.size(); ++c) {
    EXPECT_EQ(heads->clips[c].duration_s(), scene.clips[c].duration_s());
    EXPECT_EQ(heads->animations[c].duration_s, scene.clips[c].duration_s());
  }
}

TEST(paged_files, tables_are_read_without_looking_at_keys) {
  const Scene scene = full_scene(5);
  Bytes file = paged_file(scene);
  const AssetBlock keys = *AssetFile::open(file)->find(AssetKind::page_keys);
  for (std::uint64_t i = 0; i < keys.stored_bytes; ++i) file[keys.offset + i] ^= std::byte{0x5a};
  const AssetFile opened = *AssetFile::open(file);
  EXPECT_TRUE(read_page_tables(opened));
  EXPECT_TRUE(read_clips(opened, skeleton_signature(scene.skeleton), LongClips::first_keys));
  EXPECT_EQ(error_of(file).substr(0, 30), "clip-magic in block page_keys,");
  EXPECT_EQ(opened.check_sums().error().block, "page_keys");
}

TEST(paged_files, every_byte_of_pages_and_their_table_may_be_anything) {
  const Scene scene = full_scene(6);
  const Bytes file = paged_file(scene);
  FixedRandom random(1);
  std::size_t refused = 0, read = 0;
  for (const AssetKind kind : {AssetKind::pages, AssetKind::page_keys}) {
    const AssetBlock block = *AssetFile::open(file)->find(kind);
    for (std::uint64_t i = 0; i < block.stored_bytes; i += kCaseStep + random.below(3)) {
      Bytes changed = file;
      changed[block.offset + i] ^= std::byte{static_cast<std::uint8_t>(1 + random.below(255))};
      sign_assets(changed);
      const auto clips = read_clips(*AssetFile::open(changed), skeleton_signature(scene.skeleton));
      if (clips) {
        ++read;
        EXPECT_EQ(kind, AssetKind::pages) << "each page has a checksum of its own";
        for (std::size_t c = 0; c < clips->size(); ++c) EXPECT_EQ(saved((*clips)[c]), saved(scene.clips[c])) << i;
      } else {
        ++refused;
        EXPECT_NE(describe(clips.error()).find("in block page"), std::string::npos) << describe(clips.error());
      }
    }
  }
  EXPECT_GT(refused, 100 / kCaseStep);
  EXPECT_LT(read, 10u) << "pages that are a little longer or shorter, and as many: whole clips are the same";
}

TEST(paged_files, a_table_that_leaves_pages_out_is_refused) {
  const Scene scene = full_scene(1);
  Bytes file = paged_file(scene);
  const AssetBlock table = *AssetFile::open(file)->find(AssetKind::pages);
  put_number(file, table.offset + 8,
             2 * kFilePage_s);  // after the number of tables: page_s of the first one
  sign_assets(file);
  EXPECT_NE(error_of(file).find("has more or fewer pages than its duration asks for"), std::string::npos)
      << error_of(file);
}

TEST(paged_files, tables_of_more_or_fewer_clips_than_the_file_has_are_refused) {
  const Scene scene = full_scene(1);
  const Bytes file = paged_file(scene);
  const AssetFile opened = *AssetFile::open(file);
  const auto heads = read_clips(opened, skeleton_signature(scene.skeleton), LongClips::first_keys);
  ASSERT_TRUE(heads);
  ASSERT_TRUE(join_pages(opened, *heads));
  std::vector<Clip> fewer = *heads, more = *heads;
  fewer.pop_back();
  more.push_back(more.front());
  for (const std::vector<Clip>& clips : {fewer, more}) {
    const auto joined = join_pages(opened, clips);
    ASSERT_FALSE(joined);
    EXPECT_EQ(describe(joined.error()),
              "asset-value in block pages, byte 0: there are tables of more or fewer clips than the file has");
  }
}

TEST(paged_files, short_clips_stay_whole_beside_long_ones) {
  Scene scene = full_scene(3);
  ASSERT_EQ(scene.clips.size(), 2u);
  ClipLayout shorter = scene.clips[0].layout();
  shorter.duration_s = 1.0;
  scene.clips[0] = clip_of(shorter);
  ASSERT_EQ(scene.clips[1].duration_s(), 2.0);
  const Bytes file = write_asset_file(scene, {.page_s = 1.5});
  const auto tables = read_page_tables(*AssetFile::open(file));
  ASSERT_TRUE(tables);
  EXPECT_EQ((*tables)[0].page_count(), 0u);
  EXPECT_EQ((*tables)[1].page_count(), 2u);
  const auto clips = read_clips(*AssetFile::open(file), skeleton_signature(scene.skeleton));
  ASSERT_TRUE(clips) << describe(clips.error());
  for (std::size_t c = 0; c < 2; ++c) EXPECT_EQ(saved((*clips)[c]), saved(scene.clips[c]));
}

std::span<std::byte> page_of(Bytes& file, std::size_t clip, std::size_t page) {
  const auto tables = read_page_tables(*AssetFile::open(file));
  const PageTable& table = tables.value()[clip];
  return std::span(file).subspan(table.offsets[page], table.offsets[page + 1] - table.offsets[page]);
}

TEST(paged_files, a_page_in_the_place_of_another_is_refused) {
  Scene scene = full_scene(1);
  for (const std::size_t c : {1, 0}) {  // both clips have the same keys, so their pages have equal sizes
    ClipLayout named = scene.clips[0].layout();
    named.name = c == 0 ? "a" : "b";
    scene.clips[c] = clip_of(named);
  }
  Bytes file = paged_file(scene);
  const auto one = page_of(file, 0, 1), other = page_of(file, 1, 1);
  ASSERT_EQ(one.size(), other.size());
  std::swap_ranges(one.begin(), one.end(), other.begin());
  sign_assets(file);
  const auto clips = read_clips(*AssetFile::open(file), skeleton_signature(scene.skeleton));
  ASSERT_FALSE(clips);
  EXPECT_EQ(clips.error().rule, "asset-value");
  EXPECT_EQ(clips.error().block, "page_keys");
  EXPECT_EQ(clips.error().detail, "here is no page \"a [1]\"");
}

TEST(paged_files, a_page_that_does_not_begin_where_the_one_before_it_ends_is_refused) {
  int exchanged = 0;
  for (std::uint64_t seed = 2; seed < 60 && exchanged == 0; ++seed) {
    Bytes file = paged_file(full_scene(1)), other = paged_file(full_scene(seed));
    const auto here = page_of(file, 0, 1), there = page_of(other, 0, 1);
    if (here.size() != there.size()) continue;
    ++exchanged;
    std::copy(there.begin(), there.end(), here.begin());
    sign_assets(file);
    EXPECT_NE(error_of(file).find("does not continue the clip before it"), std::string::npos) << error_of(file);
  }
  EXPECT_EQ(exchanged, 1) << "no other scene has a page of that size";
}

TEST(paged_files, whole_clips_of_a_damaged_packed_page_are_refused_where_the_page_lies) {
  const Bytes good = paged_file(full_scene(2), 5);
  int packed = 0;
  for (std::size_t page = 0; page < 3; ++page) {
    Bytes file = good, unpacked;
    const auto stored = page_of(file, 0, page);
    if (unpack_page(stored, unpacked)->data() == stored.data()) continue;
    ++packed;
    stored.back() ^= std::byte{0xff};
    sign_assets(file);
    EXPECT_NE(error_of(file).find("in block page_keys"), std::string::npos) << error_of(file);
  }
  EXPECT_GT(packed, 0);
}

/// Page tables with invalid values.
TEST(paged_files, tables_that_make_no_sense_are_refused) {
  const Bytes file = paged_file(full_scene(1));
  const AssetBlock table = *AssetFile::open(file)->find(AssetKind::pages);
  const auto with = [&](std::uint64_t at, auto number) {
    Bytes changed = file;
    put_number(changed, table.offset + at, number);
    sign_assets(changed);
    return error_of(changed);
  };
  // number of tables | page_s of the first | number of its offsets | 8 bytes of padding | offsets
  for (const double page_s : {0.0, -1.0, std::nan(""), HUGE_VAL})
    EXPECT_NE(with(8, page_s).find("the length of pages is not a time"), std::string::npos) << page_s;
  EXPECT_NE(with(32, std::uint64_t{1} << 60).find("pages do not lie one after another"), std::string::npos);
}

TEST(paged_files, a_table_of_pages_that_has_none_is_refused) {
  Bytes file = paged_file(full_scene(1));
  const std::uint64_t table = AssetFile::open(file)->find(AssetKind::pages)->offset;
  ASSERT_EQ(number_at<std::uint64_t>(file, table + 16), 6u) << "offsets of the first table";
  const auto put = [&](std::uint64_t at, auto number) { put_number(file, table + at, number); };
  put(0, std::uint64_t{3});
  put(16, std::uint64_t{1});  // one offset only; the remaining ones are then read as another table
  put(40, 1.0);
  put(48, std::uint64_t{2});
  put(56, std::uint64_t{0});
  sign_assets(file);
  EXPECT_NE(error_of(file).find("a clip has pages, but none is there"), std::string::npos) << error_of(file);
}

TEST(paged_files, keys_that_are_packed_as_a_whole_are_refused) {
  Bytes file = paged_file(full_scene(1));
  const AssetFile opened = *AssetFile::open(file);
  const auto keys = static_cast<std::size_t>(opened.find(AssetKind::page_keys) - opened.blocks().data());
  put_number(file, kAssetHead + keys * kAssetEntry + kEntryStorage, std::uint32_t{1});
  sign_assets(file);
  EXPECT_EQ(error_of(file), "asset-value in block page_keys, byte 0: the block is packed");
  EXPECT_EQ(read_page_tables(*AssetFile::open(file)).error().detail, "the block is packed");
}

TEST(paged_files, pages_of_another_skeleton_are_refused) {
  Bytes file = paged_file(full_scene(1));
  for (std::size_t block = 0; block < AssetFile::open(file)->blocks().size(); ++block) {
    const std::size_t at = kAssetHead + block * kAssetEntry;
    const AssetKind kind{number_at<std::uint32_t>(file, at + kEntryKind)};
    if (kind != AssetKind::pages && kind != AssetKind::page_keys) continue;
    Bytes changed = file;
    changed[at + kEntrySignature] ^= std::byte{1};
    sign_assets(changed);
    EXPECT_EQ(error_of(changed).find("asset-signature in block " + std::string(name_of(kind)) + ","), 0u)
        << error_of(changed);
  }
}

}  // namespace
}  // namespace sinew::test
