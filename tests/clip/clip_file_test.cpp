// SPDX-License-Identifier: MIT
#include "runtime/clip/clip_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/clip/clip_fields.h"
#include "tests/clip/varied_clip.h"

namespace sinew {
namespace {

using test::samples_of;
using test::sign;
using test::varied_clip;

std::vector<std::byte> saved(std::initializer_list<const Clip*> clips) {
  return save_clips(std::span(clips.begin(), clips.size()));
}

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
    EXPECT_EQ(after->annotations(), test::varied_annotations());
    EXPECT_EQ(after->counts().rotations, before->counts().rotations);
    EXPECT_EQ(after->counts().translations, before->counts().translations);
    EXPECT_EQ(after->counts().weights, before->counts().weights);
    EXPECT_EQ(after->counts().folded, before->counts().folded);
    EXPECT_EQ(after->counts().time_groups, before->counts().time_groups);
  }
  EXPECT_EQ(saved({&(*loaded)[0], &(*loaded)[1]}), saved({&a, &b}));
}

TEST(clip_file, rest_values_keep_every_bit_and_the_identity_takes_little_space) {
  Skeleton skeleton = test::chain_skeleton(40);
  const auto size_of = [](const Clip& clip) { return saved({&clip}).size(); };
  const std::size_t of_identities = size_of(test::clip_of({}, skeleton));
  skeleton.rest[7].translation.y = -0.0f;
  skeleton.rest[9].scale.x = std::nextafter(1.0f, 2.0f);
  skeleton.rest[11].scale.z = -1e30f;
  const Clip clip = test::clip_of({}, skeleton);
  EXPECT_LE(size_of(clip), of_identities + 2 * 3 * 40 + 8) << "a byte each, but for two numbers";
  const auto loaded = load_clips(saved({&clip}));
  ASSERT_TRUE(loaded) << loaded.error().detail;
  const std::vector<float> before = samples_of(clip), after = samples_of(loaded->front());
  EXPECT_EQ(std::memcmp(before.data(), after.data(), before.size() * sizeof(float)), 0);
}

TEST(clip_file, key_times_at_even_steps_take_a_byte_each) {
  std::vector<std::size_t> sizes;
  for (const std::size_t keys : {100u, 400u}) {
    test::FixedRandom random(1);
    std::vector<float> times_s;
    for (std::size_t k = 0; k < keys; ++k) times_s.push_back(static_cast<float>(k) / 24.0f);
    const Clip clip = test::clip_of(
        test::animation_of({{.joint = 0, .translation = test::random_vectors(random, Interpolation::step, times_s)}}),
        test::chain_skeleton(1));
    sizes.push_back(saved({&clip}).size());
  }
  EXPECT_LE(sizes[1] - sizes[0], 300u * (3 * sizeof(float) + 1) + 8);
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
    EXPECT_EQ(loaded.error().rule, i < 8    ? "clip-magic"
                                   : i < 12 ? "clip-version"
                                   : i < 16 ? "clip-value"
                                   : i < 24 ? "clip-size"
                                            : "clip-checksum")
        << i;
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

TEST(clip_file, clips_of_another_version_are_refused_in_words) {
  const Clip a = varied_clip(4);
  const std::vector<std::byte> block = saved({&a});
  for (const std::uint32_t version : {std::uint32_t{0}, kClipFileVersion - 1, kClipFileVersion + 1}) {
    std::vector<std::byte> other = block;
    std::memcpy(other.data() + 8, &version, sizeof version);
    sign(other);
    const auto loaded = load_clips(other);
    ASSERT_FALSE(loaded) << version;
    EXPECT_EQ(loaded.error().rule, "clip-version");
    EXPECT_EQ(loaded.error().offset, 8u);
    EXPECT_EQ(loaded.error().detail, version < kClipFileVersion
                                         ? "compiled by an older version of the library: compile the clips again"
                                         : "compiled by a newer version of the library: compile the clips again");
  }
}

TEST(clip_file, a_block_of_version_2_is_refused_for_its_version_not_its_checksum) {
  std::vector<std::byte> block = saved({});
  std::uint64_t sum = 0xcbf29ce484222325u;  // FNV-1a, the checksum of version 2
  for (std::size_t i = kClipFileHead; i < block.size(); ++i)
    sum = (sum ^ static_cast<std::uint64_t>(block[i])) * 0x100000001b3u;
  block[8] = std::byte{2};
  std::memcpy(block.data() + 24, &sum, sizeof sum);
  EXPECT_EQ(load_clips(block).error().rule, "clip-version");
}

TEST(clip_file, blocks_with_a_right_checksum_and_wrong_bytes_are_refused_or_sampled_safely) {
  const Clip a = varied_clip(5);
  const std::vector<std::byte> block = saved({&a});
  test::FixedRandom random(6);
  std::size_t refused = 0, loaded_count = 0;
  for (std::size_t i = kClipFileHead; i < block.size(); ++i)
    for (const std::uint8_t with :
         {std::uint8_t{0xff}, std::uint8_t{0x80}, static_cast<std::uint8_t>(1 + random.below(255))}) {
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
        for (const double t : {-1.0, 0.0, 0.7, 1e9})
          EXPECT_EQ(run(SampleClipJob{.clip = &clip, .time_s = t, .pose = pose.span(), .weights = {}}), ErrorCode::ok);
      }
    }
  EXPECT_GT(refused, 100u);
  EXPECT_GT(loaded_count, 100u);
}

}  // namespace
}  // namespace sinew
