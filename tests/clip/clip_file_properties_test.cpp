// SPDX-License-Identifier: MIT
// Properties of saved clips with random content: nothing is lost, and damaged bytes do no harm.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>

#include "tests/clip/clip_fields.h"
#include "tests/clip/varied_clip.h"

namespace sinew {
namespace {

std::vector<std::byte> saved(const Clip& clip) {
  const Clip* const one = &clip;
  return save_clips({&one, 1});
}

RC_GTEST_PROP(clip_file_properties, what_was_saved_samples_the_same_bits, (std::uint64_t seed)) {
  const Clip clip = test::varied_clip(seed);
  const auto loaded = load_clips(saved(clip));
  RC_ASSERT(loaded.has_value());
  const std::vector<float> before = test::samples_of(clip), after = test::samples_of(loaded->front());
  RC_ASSERT(before.size() == after.size());
  RC_ASSERT(std::memcmp(before.data(), after.data(), before.size() * sizeof(float)) == 0);
  RC_ASSERT(saved(loaded->front()) == saved(clip));
}

RC_GTEST_PROP(clip_file_properties, damaged_bytes_are_refused_or_sample_safely, (std::uint64_t seed)) {
  test::FixedRandom random(seed);
  const std::vector<std::byte> sound = saved(test::varied_clip(seed % 16));
  std::vector<std::byte> block = sound;
  for (std::uint32_t left = 1 + random.below(6); left > 0; --left) {
    const std::size_t at = kClipFileHead + random.below(static_cast<std::uint32_t>(block.size() - kClipFileHead));
    const auto rest = block.begin() + static_cast<std::ptrdiff_t>(at);
    switch (random.below(4)) {
      case 0: *rest = static_cast<std::byte>(random.below(256)); break;
      case 1: *rest ^= static_cast<std::byte>(1u << random.below(8)); break;
      case 2: block.erase(rest, rest + std::min<std::ptrdiff_t>(block.end() - rest - 1, 1 + random.below(9))); break;
      case 3: block.insert(rest, 1 + random.below(9), static_cast<std::byte>(random.below(256))); break;
    }
  }
  RC_PRE(block != sound);  // the new byte may equal the old one
  const auto unsigned_block = load_clips(block);
  RC_ASSERT(!unsigned_block);
  RC_ASSERT(unsigned_block.error().rule == "clip-size" || unsigned_block.error().rule == "clip-checksum");
  test::sign(block);
  const auto loaded = load_clips(block);
  if (!loaded) {
    RC_ASSERT(!loaded.error().rule.empty() && !loaded.error().detail.empty());
    RC_ASSERT(loaded.error().offset >= kClipFileHead && loaded.error().offset <= block.size());
    return;
  }
  for (const Clip& clip : *loaded) {
    RC_ASSERT(clip.joint_count() < 1'000'000u);
    test::samples_of(clip);  // sanitizers find accesses outside of the clip
  }
}

}  // namespace
}  // namespace sinew
