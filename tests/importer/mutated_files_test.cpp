// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "importer/import_gltf.h"
#include "tests/importer/glb_seeds.h"
#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

using Bytes = std::vector<std::byte>;

ImportOptions small_limits() {
  ImportOptions options;
  options.max_image_pixels = 1 << 16;
  return options;
}

/// Makes one to four changes that often break parsers: changed bytes, changed numbers, cuts, repeats.
Bytes mutate(Bytes file, test::FixedRandom& random) {
  constexpr std::string_view kNumbers[] = {"0", "-1", "4294967295", "1e30", "2147483647", "255", "null", "[]"};
  for (std::uint32_t n = 1 + random.below(4); n > 0 && file.size() > 16; --n) {
    const std::size_t at = random.below(static_cast<std::uint32_t>(file.size()));
    const auto here = file.begin() + static_cast<std::ptrdiff_t>(at);
    switch (random.below(5)) {
      case 0: *here = static_cast<std::byte>(random.below(256)); break;
      case 1: *here ^= static_cast<std::byte>(1u << random.below(8)); break;
      case 2: {  // replaces one digit by another, so the text mostly stays JSON
        const auto digit =
            std::find_if(here, file.end(), [](std::byte b) { return b >= std::byte{'0'} && b <= std::byte{'9'}; });
        if (digit != file.end()) *digit = static_cast<std::byte>('0' + random.below(10));
        break;
      }
      case 3: {  // overwrites a number with an unusual one, keeping the file's length
        const auto colon = std::find(here, file.end(), std::byte{':'});
        const std::string_view number = kNumbers[random.below(std::size(kNumbers))];
        for (std::size_t i = 0; i < number.size() && colon + 1 + static_cast<std::ptrdiff_t>(i) < file.end(); ++i)
          *(colon + 1 + static_cast<std::ptrdiff_t>(i)) = static_cast<std::byte>(number[i]);
        break;
      }
      default: file.resize(at); break;
    }
  }
  return file;
}

TEST(mutated_files, seeds_are_valid) {
  for (const Bytes& seed : test::glb_seeds()) {
    const auto file = import_gltf(seed, "seed.glb");
    ASSERT_TRUE(file) << describe("seed.glb", file.error().issue);
    for (const auto& warning : file->warnings)
      EXPECT_TRUE(warning.rule == "animation-bounds" || warning.rule == "node-skin-unused")
          << describe("seed.glb", warning);
    EXPECT_FALSE(file->scene.meshes.empty());
  }
}

TEST(mutated_files, T7_an_image_past_its_buffer_is_an_error_and_not_read) {
  Bytes seed = test::glb_seeds()[0];
  const std::string_view text(reinterpret_cast<const char*>(seed.data()), seed.size());
  const std::string_view view = R"("bufferView":9,"mimeType")";
  const std::size_t at = text.find(view);
  ASSERT_NE(at, std::string_view::npos);
  seed[at + 13] = std::byte{'8'};  // a view without an image: everything else loads
  const auto other = import_gltf(seed, "seed.glb");
  ASSERT_TRUE(other);
  EXPECT_FALSE(other->scene.images.at(0).missing_reason.empty());
  EXPECT_FALSE(other->scene.animations.empty());

  const std::size_t length = text.rfind("\"byteLength\":", text.find("\"buffers\""));
  ASSERT_NE(length, std::string_view::npos);
  seed[length + 13] = std::byte{'9'};  // the last view, which holds the image, now ends outside its buffer
  const auto file = import_gltf(seed, "seed.glb");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().issue.rule, "buffer-view-range");
}

TEST(mutated_files, G68_never_crash_the_importer) {
  test::FixedRandom random(2026);
  int imported = 0, refused = 0;
  for (const Bytes& seed : test::glb_seeds())
    for (int i = 0; i < 1500; ++i) {
      ImportOptions options = small_limits();
      options.thorough = options.collect_all_errors = i % 2 == 1;  // as `sinew check` imports
      const auto file = import_gltf(mutate(seed, random), "mutated.glb", options);
      if (file) {
        ++imported;
        EXPECT_EQ(check(file->scene), ErrorCode::ok);
      } else {
        ++refused;
        EXPECT_FALSE(file.error().issue.rule.empty());
      }
    }
  EXPECT_GT(imported, 100);
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace sinew
