// SPDX-License-Identifier: MIT
#include "runtime/asset_file/read_assets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "runtime/animation/skeleton_signature.h"
#include "runtime/asset_file/write_asset_file.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/clip/unpack_clip.h"
#include "tests/asset_file/full_scene.h"
#include "tests/asset_file/played_frames.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/scene_equality.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {

using Bytes = std::vector<std::byte>;

/// The scene of a file; empty on error.
Scene scene_of(const Bytes& file) {
  const auto opened = AssetFile::open(file);
  EXPECT_TRUE(opened) << describe(opened.error());
  if (!opened) return {};
  auto scene = read_scene(*opened);
  EXPECT_TRUE(scene) << describe(scene.error());
  return scene ? *std::move(scene) : Scene{};
}

AssetFile opened(const Bytes& file) { return *AssetFile::open(file); }

/// Compares the fields that expect_equal leaves out and that a glTF file cannot store.
void expect_equal_beyond_gltf(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.skeleton.node_of_joint, b.skeleton.node_of_joint);
  EXPECT_EQ(a.skeleton.joint_of_node, b.skeleton.joint_of_node);
  EXPECT_EQ(a.first_weight, b.first_weight);
  EXPECT_EQ(a.properties.rest, b.properties.rest);
  ASSERT_EQ(a.properties.entries.size(), b.properties.entries.size());
  ASSERT_EQ(a.correctives.size(), b.correctives.size());
  for (std::size_t c = 0; c < a.correctives.size(); ++c) {
    EXPECT_EQ(a.correctives[c].coefficients, b.correctives[c].coefficients);
    EXPECT_EQ(a.correctives[c].samples.values, b.correctives[c].samples.values);
    EXPECT_TRUE(a.correctives[c].samples.rotations == b.correctives[c].samples.rotations);
  }
  for (std::size_t m = 0; m < a.meshes.size(); ++m)
    for (std::size_t p = 0; p < a.meshes[m].primitives.size(); ++p) {
      EXPECT_EQ(a.meshes[m].primitives[p].source_vertex, b.meshes[m].primitives[p].source_vertex);
      EXPECT_TRUE(a.meshes[m].primitives[p].centers_of_rotation == b.meshes[m].primitives[p].centers_of_rotation);
    }
  ASSERT_EQ(a.images.size(), b.images.size());
  for (std::size_t i = 0; i < a.images.size(); ++i) {
    EXPECT_EQ(a.images[i].encoded, b.images[i].encoded);
    EXPECT_EQ(a.images[i].missing_reason, b.images[i].missing_reason);
  }
  ASSERT_EQ(a.scenes.size(), b.scenes.size());
  for (std::size_t s = 0; s < a.scenes.size(); ++s) EXPECT_EQ(a.scenes[s].joints, b.scenes[s].joints);
}

TEST(read_assets, every_field_comes_back_and_plays_the_same_frames) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Scene scene = full_scene(seed);
    ASSERT_EQ(check(scene), ErrorCode::ok);
    ASSERT_FALSE(hashes_of_frames(scene).empty());
    for (const int level : {0, 3}) {
      const AssetFileOptions options{.truth = true, .zstd_level = level};
      const Bytes file = write_asset_file(scene, options);
      const Scene read = scene_of(file);
      expect_equal(scene, read);
      expect_equal_beyond_gltf(scene, read);
      EXPECT_EQ(hashes_of_frames(read), hashes_of_frames(scene));
      EXPECT_TRUE(write_asset_file(read, options) == file);
    }
  }
}

TEST(read_assets, without_the_truth_animations_are_the_keys_of_the_clips) {
  const Scene scene = full_scene(4);
  const Scene read = scene_of(write_asset_file(scene));
  EXPECT_EQ(hashes_of_frames(read), hashes_of_frames(scene));
  ASSERT_EQ(read.animations.size(), scene.animations.size());
  Scene again = read;
  finish_scene(again);
  EXPECT_EQ(hashes_of_frames(again), hashes_of_frames(scene)) << "compiled from what was read";
}

TEST(read_assets, packed_blocks_are_smaller_and_say_so) {
  const Scene scene = full_scene(5);
  const Bytes plain = write_asset_file(scene), packed = write_asset_file(scene, {.zstd_level = 9});
  EXPECT_LT(packed.size(), plain.size());
  EXPECT_FALSE(opened(plain).find(AssetKind::model)->is_packed);
  EXPECT_TRUE(opened(packed).find(AssetKind::model)->is_packed);
  EXPECT_EQ(opened(packed).find(AssetKind::model)->bytes, opened(plain).find(AssetKind::model)->bytes);
}

TEST(read_assets, a_file_may_hold_any_of_skeleton_model_and_clips) {
  const Scene scene = arm_scene();
  const Bytes skeleton = write_asset_file(scene, {.model = false, .clips = false}),
              model = write_asset_file(scene, {.clips = false}),
              clips = write_asset_file(scene, {.skeleton = false, .model = false});
  EXPECT_EQ(read_skeleton(opened(skeleton))->names, scene.skeleton.names);
  EXPECT_EQ(scene_of(skeleton).meshes.size(), 0u);
  EXPECT_EQ(read_scene(opened(clips)).error().rule, "asset-missing");
  EXPECT_EQ(read_clips(opened(skeleton), 0).error().rule, "asset-missing");
  Scene character = scene_of(model);
  ASSERT_EQ(character.clips.size(), 0u);
  for (int twice = 0; twice < 2; ++twice) ASSERT_TRUE(add_clips(opened(clips), character));
  ASSERT_EQ(character.clips.size(), 2u);
  EXPECT_EQ(check(character), ErrorCode::ok);
  EXPECT_EQ(hashes_of_frames(character).front(), hashes_of_frames(scene).front());
}

TEST(read_assets, boxes_of_clips_come_with_model_and_clips_or_not_at_all) {
  const Scene scene = full_scene(6);
  ClipBoxes boxes(scene.clips.size());
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    boxes[1].push_back({glm::vec3(-1.0f, 0.25f, static_cast<float>(i)), glm::vec3(2.0f, 1.5f, 77.0f)});
  for (const int level : {0, 3}) {
    const Bytes file = write_asset_file(scene, {.clip_boxes = boxes, .zstd_level = level});
    Scene read = scene_of(file);
    ASSERT_TRUE(add_clips(opened(file), read)) << "boxes go on to be those of the file's own clips";
    const auto again = read_clip_boxes(opened(file), read);
    ASSERT_TRUE(again);
    ASSERT_EQ(again->size(), 2u);
    EXPECT_TRUE(again->at(0).empty());
    ASSERT_EQ(again->at(1).size(), boxes[1].size());
    for (std::size_t i = 0; i < boxes[1].size(); ++i) {
      EXPECT_EQ(again->at(1)[i].lower, boxes[1][i].lower);
      EXPECT_EQ(again->at(1)[i].upper, boxes[1][i].upper);
    }
  }
  for (const AssetFileOptions& part :
       {AssetFileOptions{.model = false, .clip_boxes = boxes}, AssetFileOptions{.clips = false, .clip_boxes = boxes}})
    EXPECT_EQ(AssetFile::open(write_asset_file(scene, part))->find(AssetKind::bounds), nullptr);
  const Bytes plain = write_asset_file(scene);
  EXPECT_TRUE(read_clip_boxes(opened(plain), scene)->empty()) << "files of before are read";
  Scene other = scene;
  other.skeleton.names[1] = "renamed";
  const Bytes file = write_asset_file(scene, {.clip_boxes = boxes});
  EXPECT_EQ(read_clip_boxes(opened(file), other).error().rule, "asset-signature");
}

TEST(read_assets, skeleton_lods_come_back_and_are_refused_for_another_skeleton) {
  const Scene scene = full_scene(7);
  const auto joints = static_cast<std::uint32_t>(scene.skeleton.joint_count());
  CompiledSkeletonLod level{{std::vector<bool>(joints, true), scene.skeleton.rest}, 0.002, 1, 0.0015, joints - 1};
  level.detail.kept.back() = false;
  const std::vector<CompiledSkeletonLod> lods = {level, {}};
  for (const int zstd_level : {0, 3}) {
    const Bytes file = write_asset_file(scene, {.skeleton_lods = lods, .zstd_level = zstd_level});
    const auto again = read_skeleton_lods(opened(file), scene.skeleton);
    ASSERT_TRUE(again) << describe(again.error());
    ASSERT_EQ(again->size(), 2u);
    const CompiledSkeletonLod& read = again->front();
    EXPECT_EQ(read.detail.kept, level.detail.kept);
    EXPECT_TRUE(same_bits<Transform>(read.detail.held, level.detail.held));
    EXPECT_EQ(read.tolerance_m, 0.002);
    EXPECT_EQ(read.left_out, 1u);
    EXPECT_EQ(read.measured_m, 0.0015);
    EXPECT_EQ(read.worst_joint, joints - 1);
    EXPECT_TRUE((*again)[1].detail.kept.empty());
    EXPECT_EQ((*again)[1].worst_joint, kNone);
  }
  EXPECT_TRUE(read_skeleton_lods(opened(write_asset_file(scene)), scene.skeleton)->empty());
  Skeleton other = scene.skeleton;
  other.names.back() += "x";
  const Bytes file = write_asset_file(scene, {.model = false, .clips = false, .skeleton_lods = lods});
  EXPECT_EQ(read_skeleton_lods(opened(file), other).error().rule, "asset-signature");
}

TEST(read_assets, graphs_come_back_by_name) {
  const Scene scene = full_scene(7);
  const std::vector<StoredGraph> graphs = {{"walk", Bytes(5, std::byte{7})}, {"climb", {}}};
  for (const int zstd_level : {0, 3}) {
    const Bytes file = write_asset_file(scene, {.graphs = graphs, .zstd_level = zstd_level});
    const auto again = read_graphs(opened(file));
    ASSERT_TRUE(again) << describe(again.error());
    ASSERT_EQ(again->size(), 2u);
    for (std::size_t g = 0; g < 2; ++g) {
      EXPECT_EQ((*again)[g].name, graphs[g].name);
      EXPECT_EQ((*again)[g].bytes, graphs[g].bytes);
    }
  }
  EXPECT_TRUE(read_graphs(opened(write_asset_file(scene)))->empty());
  const std::vector<StoredGraph> twice = {graphs[0], graphs[0]};
  const Bytes file = write_asset_file(scene, {.graphs = twice});
  EXPECT_EQ(read_graphs(opened(file)).error().rule, "asset-value");
}

TEST(read_assets, clips_of_another_skeleton_are_refused_and_both_are_named) {
  const Scene scene = arm_scene();
  const Bytes clips = write_asset_file(scene, {.skeleton = false, .model = false});
  Scene other = scene;
  other.skeleton.names[1] = "renamed";
  const Scene before = other;
  const auto added = add_clips(opened(clips), other);
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().rule, "asset-signature");
  EXPECT_EQ(added.error().offset, 0u) << "it is the whole block";
  EXPECT_EQ(added.error().block, "clips");
  const Skeleton* both[] = {&scene.skeleton, &other.skeleton};
  for (const Skeleton* skeleton : both) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(skeleton_signature(*skeleton)));
    EXPECT_THAT(added.error().detail, testing::HasSubstr(text));
  }
  EXPECT_EQ(other.clips.size(), before.clips.size());
  EXPECT_EQ(other.animations.size(), before.animations.size());
}

TEST(read_assets, clips_of_other_morph_weights_are_refused_by_their_number) {
  Scene face = face_scene(), plain = face;
  plain.instances.clear();
  plain.animations.clear();
  finish_scene(plain);
  const auto added = add_clips(opened(write_asset_file(face, {.skeleton = false, .model = false})), plain);
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().rule, "asset-binding");
  EXPECT_THAT(added.error().detail, testing::HasSubstr("\"smile\" was compiled for 2 morph weights, the scene has 0"));
  EXPECT_TRUE(plain.clips.empty());
}

TEST(read_assets, clips_whose_weights_lie_otherwise_in_the_instances_of_the_scene_are_refused) {
  const Scene face = face_scene();
  Scene two = face;  // equally many weights, but of two instances
  two.instances.push_back(two.instances[0]);
  two.first_weight = {0, 1, 2};
  two.clips.clear();
  two.animations.clear();
  const auto added = add_clips(opened(write_asset_file(face, {.skeleton = false, .model = false})), two);
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().rule, "asset-binding");
  EXPECT_THAT(added.error().detail, testing::HasSubstr("\"smile\" moves a part of a property, or weights of two"));
  EXPECT_TRUE(two.clips.empty());
}

/// Joints with many keys that take no bits when packed: small in a file, large as keys.
Scene scene_of_many_small_keys(std::uint32_t joints, std::uint32_t keys) {
  Scene scene;
  scene.skeleton = skeleton_of(std::vector<std::uint32_t>(joints, kNone));
  finish_scene(scene);
  std::vector<float> times_s;
  for (std::uint32_t k = 0; k < keys; ++k) times_s.push_back(static_cast<float>(k));
  TrackBlock block = block_of(Property::rotation, Interpolation::linear, joints);
  for (std::uint32_t j = 0; j < joints; ++j) block.targets.push_back(j);
  block.places = JointPlaces(block.targets);
  block.packed = packed_rows(std::vector<PackedTrack>(joints, {.components = 4, .derived = 3}), keys);
  ClipLayout layout = clip_of(Animation{.name = "much"}, scene.skeleton).layout();
  layout.duration_s = keys;
  layout.groups.push_back({KeyTimes(times_s), {block}});
  scene.clips = {clip_of(layout)};
  return scene;
}

TEST(read_assets, clips_that_take_far_more_memory_as_keys_than_in_the_file_are_refused) {
  for (const std::uint32_t keys : {2u, 2000u}) {
    const Bytes file = write_asset_file(scene_of_many_small_keys(1000, keys));
    const PeakMemory peak;
    const auto read = read_scene(opened(file));
    ASSERT_EQ(read.has_value(), keys == 2) << (read ? "" : describe(read.error()));
    if (read) continue;
    EXPECT_EQ(describe(read.error()),
              "asset-memory in block clips, byte 0: the keys of the clips take far more memory than their bytes");
    EXPECT_LT(peak.bytes(), 20 * file.size());
  }
}

TEST(read_assets, a_body_of_other_proportions_plays_the_clips_of_its_skeleton) {
  const Scene scene = arm_scene();
  Scene longer = scene;
  longer.skeleton.rest[1].translation.y += 0.5f;
  longer.clips.clear();
  longer.animations.clear();
  ASSERT_TRUE(add_clips(opened(write_asset_file(scene, {.skeleton = false, .model = false})), longer));
  EXPECT_EQ(longer.clips[0].name(), "bend");
}

}  // namespace
}  // namespace sinew::test
