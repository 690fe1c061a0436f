// SPDX-License-Identifier: MIT
#include "runtime/assets/clip_file.h"

#include <gtest/gtest.h>

#include <cstring>

#include "tests/assets/clip_fields.h"
#include "tests/assets/varied_clip.h"

namespace sinew {
namespace {

using test::samples_of;
using test::sign;
using test::varied_clip;

std::vector<std::byte> saved(std::initializer_list<const Clip*> clips) { return save_clips(std::span(clips.begin(), clips.size())); }

TEST(clip_file, loaded_clips_sample_the_same_bits) {
  const Clip a = varied_clip(1), b = varied_clip(2);
  const auto loaded = load_clips(saved({&a, &b}));
  ASSERT_TRUE(loaded) << loaded.error().detail;
  ASSERT_EQ(loaded->size(), 2u);
  for (const auto& [before, after] : {std::pair(&a, &(*loaded)[0]), std::pair(&b, &(*loaded)[1])}) {
    const std::vector<float> expected = samples_of(*before), found = samples_of(*after);
    ASSERT_EQ(found.size(), expected.size());
    EXPECT_EQ(std::memcmp(found.data(), expected.data(), found.size() * sizeof(float)), 0);
    EXPECT_EQ(after->name(), "varied");
    EXPECT_EQ(after->duration_s(), 4.0);
    EXPECT_EQ(after->certificate(), before->certificate());
    EXPECT_EQ(after->counts().rotations, before->counts().rotations);
    EXPECT_EQ(after->counts().translations, before->counts().translations);
    EXPECT_EQ(after->counts().weights, before->counts().weights);
    EXPECT_EQ(after->counts().folded, before->counts().folded);
    EXPECT_EQ(after->counts().time_groups, before->counts().time_groups);
  }
  EXPECT_EQ(saved({&(*loaded)[0], &(*loaded)[1]}), saved({&a, &b}));
}

TEST(clip_file, a_block_may_lie_anywhere_and_be_empty) {
  const Clip a = varied_clip(3);
  const std::vector<std::byte> block = saved({&a});
  std::vector<std::byte> shifted(block.size() + 1);
  std::copy(block.begin(), block.end(), shifted.begin() + 1);
  EXPECT_TRUE(load_clips(std::span(shifted).subspan(1)));
  const auto none = load_clips(saved({}));
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->empty());
}

TEST(clip_file, every_changed_byte_is_noticed_and_every_cut_names_its_rule) {
  const Clip a = varied_clip(4);
  const std::vector<std::byte> block = saved({&a});
  for (std::size_t i = 0; i < block.size(); ++i) {
    std::vector<std::byte> changed = block;
    changed[i] ^= std::byte{0x10};
    const auto loaded = load_clips(changed);
    ASSERT_FALSE(loaded) << i;
    EXPECT_EQ(loaded.error().rule, i < 8 ? "clip-magic" : i < 12 ? "clip-version" : i < 16 ? "clip-value" : i < 24 ? "clip-size" : "clip-checksum") << i;
  }
  for (std::size_t size = 0; size < block.size(); ++size) {
    std::vector<std::byte> cut(block.begin(), block.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_EQ(load_clips(cut).error().rule, size < 8 ? "clip-magic" : "clip-size") << size;
    if (size < kClipFileHead) continue;
    sign(cut);
    const auto loaded = load_clips(cut);
    ASSERT_FALSE(loaded) << size;
    EXPECT_EQ(loaded.error().rule, "clip-size") << size;
    EXPECT_GE(loaded.error().offset, kClipFileHead);
    EXPECT_LE(loaded.error().offset, size);
  }
  std::vector<std::byte> longer = block;
  longer.push_back(std::byte{0});
  sign(longer);
  EXPECT_EQ(load_clips(longer).error().rule, "clip-size");
}

TEST(clip_file, blocks_with_a_right_checksum_and_wrong_bytes_are_refused_or_sampled_safely) {
  const Clip a = varied_clip(5);
  const std::vector<std::byte> block = saved({&a});
  test::FixedRandom random(6);
  std::size_t refused = 0, loaded_count = 0;
  for (std::size_t i = kClipFileHead; i < block.size(); ++i)
    for (const std::uint8_t with : {std::uint8_t{0xff}, std::uint8_t{0x80}, static_cast<std::uint8_t>(1 + random.below(255))}) {
      std::vector<std::byte> changed = block;
      changed[i] ^= std::byte{with};
      sign(changed);
      const auto loaded = load_clips(changed);
      ++(loaded ? loaded_count : refused);
      if (!loaded) {
        EXPECT_FALSE(loaded.error().rule.empty());
        continue;
      }
      for (const Clip& clip : *loaded) {
        ASSERT_LT(clip.joint_count(), 1'000'000u);
        test::PoseBuffer pose(clip.joint_count());
        for (const double t : {-1.0, 0.0, 0.7, 1e9}) run(SampleClipJob{.clip = &clip, .time_s = t, .pose = pose.span(), .weights = {}});
      }
    }
  EXPECT_GT(refused, 100u);
  EXPECT_GT(loaded_count, 100u);
}

}  // namespace
}  // namespace sinew
