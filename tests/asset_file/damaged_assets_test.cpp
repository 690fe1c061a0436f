// SPDX-License-Identifier: MIT
// Files with damaged bytes and correct checksums. Reading must refuse them, or the result must pass all checks and
// play.
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "runtime/asset_file/read_assets.h"
#include "runtime/asset_file/write_asset_file.h"
#include "tests/asset_file/full_scene.h"
#include "tests/asset_file/played_frames.h"
#include "tests/asset_file/signed_file.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/case_step.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

using Bytes = std::vector<std::byte>;

/// Signs the file and reads it.
tl::expected<Scene, AssetFileError> read_signed(Bytes& file) {
  sign_assets(file);
  const auto opened = AssetFile::open(file);
  if (!opened) return tl::unexpected(opened.error());
  auto scene = read_scene(*opened);
  if (!scene) return scene;
  if (const auto boxes = read_clip_boxes(*opened, *scene); !boxes) return tl::unexpected(boxes.error());
  if (const auto lods = read_skeleton_lods(*opened, scene->skeleton); !lods) return tl::unexpected(lods.error());
  if (const auto graphs = read_graphs(*opened); !graphs) return tl::unexpected(graphs.error());
  return scene;
}

/// Boxes of the scene's two clips. Boxes of one instance and of the second clip are unknown.
ClipBoxes boxes_of(const Scene& scene) {
  std::vector<Aabb> of_clip(scene.instances.size(), {glm::vec3(-1.0f, 0.25f, 3.0f), glm::vec3(2.0f, 1.5f, 77.0f)});
  of_clip.back() = Aabb();
  return {of_clip, {}};
}

/// One level, which leaves out the last joint.
std::vector<CompiledSkeletonLod> lods_of(const Scene& scene) {
  const auto joints = static_cast<std::uint32_t>(scene.skeleton.joint_count());
  CompiledSkeletonLod level{{std::vector<bool>(joints, true), scene.skeleton.rest}, 0.002, 1, 0.0015, joints - 1};
  level.detail.kept.back() = false;
  return {level};
}

constexpr std::size_t kBlocks = 7;  // blocks in full_file

Bytes full_file(std::uint64_t seed) {
  const Scene scene = full_scene(seed);
  const ClipBoxes boxes = boxes_of(scene);
  const auto lods = lods_of(scene);
  const std::vector<StoredGraph> graphs = {{"walk", Bytes(5, std::byte{7})}, {"climb", {}}};
  return write_asset_file(scene, {.truth = true, .clip_boxes = boxes, .skeleton_lods = lods, .graphs = graphs});
}

TEST(damaged_assets, every_byte_of_every_block_may_be_anything) {
  const Bytes file = full_file(1);
  FixedRandom random(2);
  std::size_t refused = 0, read = 0;
  for (std::size_t i = kAssetHead + kBlocks * kAssetEntry; i < file.size(); i += kCaseStep)
    for (const std::uint8_t with : {std::uint8_t{0xff}, static_cast<std::uint8_t>(1 + random.below(255))}) {
      Bytes changed = file;
      changed[i] ^= std::byte{with};
      const auto scene = read_signed(changed);
      ++(scene ? read : refused);
      if (!scene) {
        const bool is_between = scene.error().detail == "bytes between blocks are not 0";
        ASSERT_EQ(scene.error().block.empty(), is_between) << describe(scene.error());
        continue;
      }
      ASSERT_EQ(check(*scene), ErrorCode::ok) << i;
      if (i % 16 == 0) {
        ASSERT_FALSE(hashes_of_frames(*scene).empty()) << i;
      }
    }
  EXPECT_GT(refused, 1000 / kCaseStep);
  EXPECT_GT(read, 1000 / kCaseStep);
}

TEST(damaged_assets, a_number_that_is_wrong_in_a_scene_is_refused_in_its_block) {
  const Scene scene = full_scene(3);
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  struct Case {
    const char* block;
    void (*spoil)(Scene& scene);
  };
  const auto cases = std::to_array<Case>({
      {"skeleton", [](Scene& s) { s.skeleton.rest[2].translation.x = kNan; }},
      {"skeleton", [](Scene& s) { s.skeleton.parents[1] = 7; }},
      {"skeleton", [](Scene& s) { s.skeleton.level_begin.pop_back(); }},
      {"model", [](Scene& s) { s.meshes[0].primitives[0].positions[1].y = kNan; }},
      {"model", [](Scene& s) { s.meshes[0].primitives[0].indices[0] = 100'000; }},
      {"model", [](Scene& s) { s.materials[0].roughness = kNan; }},
      {"model", [](Scene& s) { s.materials[0].alpha_mode = static_cast<AlphaMode>(3); }},
      {"model", [](Scene& s) { s.lights[0].kind = static_cast<Light::Kind>(3); }},
      {"model", [](Scene& s) { s.textures[0].image = 2; }},
      {"model", [](Scene& s) { s.images[0].width = 3; }},
      {"model", [](Scene& s) { s.lights[0].joint = 100; }},
      {"model", [](Scene& s) { s.first_weight.back() += 1; }},
      {"model", [](Scene& s) { s.correctives[0].coefficients.pop_back(); }},
      {"model", [](Scene& s) { s.properties.rest[0] = kNan; }},
      {"animations", [](Scene& s) { s.animations[0].bones[0].joint = 100; }},
      {"animations", [](Scene& s) { s.animations[0].duration_s = static_cast<double>(kNan); }},
      {"animations", [](Scene& s) { s.animations.pop_back(); }},
  });
  for (std::size_t i = 0; i < cases.size(); ++i) {
    Scene spoilt = scene;
    cases[i].spoil(spoilt);
    Bytes file = write_asset_file(spoilt, {.truth = true});
    const auto read = read_signed(file);
    ASSERT_FALSE(read) << i;
    EXPECT_EQ(read.error().block, cases[i].block) << i << ": " << describe(read.error());
    EXPECT_EQ(read.error().rule, "asset-value") << i;
  }
}

TEST(damaged_assets, boxes_that_do_not_fit_the_scene_are_refused) {
  const Scene scene = full_scene(3);
  void (*const spoil[])(ClipBoxes & boxes) = {
      [](ClipBoxes& boxes) { boxes[0][0].upper.y = std::numeric_limits<float>::quiet_NaN(); },
      [](ClipBoxes& boxes) { boxes[0][1].lower.x = -std::numeric_limits<float>::infinity(); },
      [](ClipBoxes& boxes) { boxes[0].pop_back(); },
      [](ClipBoxes& boxes) { boxes.resize(3); },
  };
  for (const auto& one : spoil) {
    ClipBoxes boxes = boxes_of(scene);
    Bytes good = write_asset_file(scene, {.clip_boxes = boxes});
    ASSERT_TRUE(read_signed(good));
    one(boxes);
    Bytes file = write_asset_file(scene, {.clip_boxes = boxes});
    const auto read = read_signed(file);
    ASSERT_FALSE(read) << &one - spoil;
    EXPECT_EQ(read.error().rule, "asset-value");
    EXPECT_EQ(read.error().block, "bounds");
  }
}

TEST(damaged_assets, skeleton_lods_that_do_not_fit_the_skeleton_are_refused) {
  const Scene scene = full_scene(3);
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  void (*const spoil[])(CompiledSkeletonLod & lod) = {
      [](CompiledSkeletonLod& lod) { lod.detail.kept.pop_back(); },
      [](CompiledSkeletonLod& lod) { lod.detail.held.push_back({}); },
      [](CompiledSkeletonLod& lod) { lod.detail.held[1].rotation.w = static_cast<float>(kNaN); },
      [](CompiledSkeletonLod& lod) { lod.detail.held[0].translation.z = std::numeric_limits<float>::infinity(); },
      [](CompiledSkeletonLod& lod) { lod.detail.held[0].scale.y = static_cast<float>(kNaN); },
      [](CompiledSkeletonLod& lod) { lod.left_out = static_cast<std::uint32_t>(lod.detail.kept.size()) + 1; },
      [](CompiledSkeletonLod& lod) { lod.tolerance_m = -1.0; },
      [](CompiledSkeletonLod& lod) { lod.measured_m = kNaN; },
      [](CompiledSkeletonLod& lod) { lod.worst_joint = static_cast<std::uint32_t>(lod.detail.kept.size()); },
  };
  for (const auto& one : spoil) {
    auto lods = lods_of(scene);
    one(lods[0]);
    Bytes file = write_asset_file(scene, {.skeleton_lods = lods});
    const auto read = read_signed(file);
    ASSERT_FALSE(read) << &one - spoil;
    EXPECT_EQ(read.error().rule, "asset-value");
    EXPECT_EQ(read.error().block, "skeleton_lods");
  }
}

TEST(damaged_assets, each_block_of_another_skeleton_is_refused) {
  const Bytes file = full_file(1);
  for (std::size_t block = 0; block < kBlocks; ++block) {
    if (AssetFile::open(file)->blocks()[block].kind == AssetKind::graphs) continue;  // they name clips, not joints
    Bytes changed = file;
    changed[kAssetHead + block * kAssetEntry + kEntrySignature] ^= std::byte{1};
    const auto read = read_signed(changed);
    ASSERT_FALSE(read) << block;
    EXPECT_EQ(read.error().rule, "asset-signature") << describe(read.error());
    EXPECT_EQ(read.error().block, name_of(AssetFile::open(changed)->blocks()[block].kind));
  }
}

TEST(damaged_assets, counts_that_no_bytes_stand_behind_take_no_memory) {
  const Bytes file = full_file(1);
  const std::size_t first = kAssetHead + kBlocks * kAssetEntry;
  for (std::size_t i = first; i + 8 <= file.size(); i += 4) {
    Bytes changed = file;
    put_number(std::span(changed), i, std::uint64_t{0x7fffffff});
    const PeakMemory peak;
    static_cast<void>(read_signed(changed));
    ASSERT_LT(peak.bytes(), (16u << 20) + 200 * file.size()) << i;
  }
}

}  // namespace
}  // namespace sinew::test
