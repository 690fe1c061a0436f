// SPDX-License-Identifier: MIT
// Runs inputs that fuzzing once found (found/TARGET/*), so that they stay harmless. It also runs the seeds: a target
// that does nothing is noticed here instead of after hours of fuzzing.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "importer/import_gltf.h"
#include "runtime/geometry_cache/geometry_decoder.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/geometry_mutator.h"
#include "tests/fuzz/import_target.h"
#include "tests/fuzz/json_mutator.h"
#include "tests/fuzz/seeds.h"
#include "tests/support/file_text.h"

namespace sinew::fuzz {
namespace {

namespace fs = std::filesystem;

const Target* target_named(const std::string& name) {
  const auto found = std::find_if(targets().begin(), targets().end(), [&](const Target& t) { return t.name == name; });
  return found == targets().end() ? nullptr : &*found;
}

TEST(found_inputs, stay_harmless) {
  for (const auto& entry : fs::recursive_directory_iterator(SINEW_FOUND_INPUTS)) {
    if (!entry.is_regular_file() || entry.path().extension() == ".md") continue;
    const Target* target = target_named(entry.path().parent_path().filename().string());
    ASSERT_NE(target, nullptr) << entry.path();
    const std::string input = test::text_of_file(entry.path());
    EXPECT_NO_THROW(target->run(std::as_bytes(std::span(input)))) << entry.path();
  }
}

TEST(found_inputs, every_target_takes_its_seeds) {
  std::map<std::string, int> count;
  for (const Seed& seed : own_seeds()) {
    const Target* target = target_named(seed.target);
    ASSERT_NE(target, nullptr) << seed.target;
    EXPECT_NO_THROW(target->run(seed.bytes)) << seed.target;
    ++count[seed.target];
  }
  EXPECT_EQ(count.size(), targets().size());
}

TEST(found_inputs, valid_accessors_reach_meshes_skins_and_clips) {
  int files = 0;
  for (const Seed& seed : own_seeds())
    if (seed.target == "accessors") {
      const auto file = import_gltf(accessor_file(seed.bytes), "seed");
      ASSERT_TRUE(file) << describe("seed", file.error().issue);
      const Primitive& primitive = file->scene.meshes.at(0).primitives.at(0);
      EXPECT_FALSE(primitive.influences.empty());
      EXPECT_FALSE(primitive.morphs.targets.at(0).positions.vertices.empty());
      EXPECT_EQ(file->scene.animations.at(0).bones.size(), 1u);
      ++files;
    }
  EXPECT_EQ(files, 1);
}

TEST(json_mutator, changes_a_document_and_keeps_it_json) {
  const std::string text = R"({"asset":{"version":"2.0"},"nodes":[{"scale":[1,2,3]},{"name":"b"}]})";
  const auto no_bytes = [](std::uint8_t*, std::size_t size, std::size_t) { return size; };
  int changed = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const std::string mutated = mutate_json(text, seed, no_bytes);
    EXPECT_EQ(mutated, mutate_json(text, seed, no_bytes));
    changed += mutated != text;
    EXPECT_NE(mutate_json(mutated, seed, no_bytes), "");
  }
  EXPECT_GT(changed, 150);
  EXPECT_EQ(mutate_json("{no", 1, no_bytes), "{no");
}

TEST(geometry_mutator, most_changed_caches_open_and_no_checksum_stops_their_frames) {
  const auto flip = [](std::uint8_t* data, std::size_t size, std::size_t) {
    if (size > 0) data[size / 2] ^= 1;
    return size;
  };
  int opened = 0, changed = 0, frames = 0, played = 0;
  for (const Seed& seed : own_seeds())
    if (seed.target == "geometry")
      for (std::uint64_t number = 0; number < 50; ++number) {
        const std::vector<std::byte> file = mutate_geometry(seed.bytes, number, flip);
        ++changed;
        EXPECT_EQ(file, mutate_geometry(seed.bytes, number, flip));
        const auto cache = GeometryCache::open(file);
        if (!cache) continue;
        ++opened;
        GeometryDecoder decoder(*cache);
        MappedFrames source{*cache, file};
        for (std::uint32_t f = 0; f < cache->frame_count(); ++f, ++frames)
          played += decoder.decode(f, source) == GeometryStatus::ok;
      }
  EXPECT_GT(opened, changed * 3 / 4);
  EXPECT_GT(played, frames / 2);
}

}  // namespace
}  // namespace sinew::fuzz
