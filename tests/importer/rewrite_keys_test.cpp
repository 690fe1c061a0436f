// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/importer/rewritten.h"
#include "tests/support/scene_equality.h"

namespace sinew::test {
namespace {

/// Node 0 is moved by channels 0 and 1, which share a sampler, and turned by channel 2; channel 3 names no node.
TinyGltf moving() {
  TinyGltf gltf;
  gltf.add_triangle();
  gltf.root["nodes"].push_back(Json::object());
  const std::size_t times = gltf.times({0, 1, 2});
  gltf.animate("translation", times, gltf.vec3({0, 0, 0, 1, 0, 0, 2, 0, 0}));
  Json& animation = gltf.root["animations"][0];
  animation["samplers"][0]["extras"] = "shared";
  animation["samplers"].push_back({{"input", times}, {"output", gltf.vec4({0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 1})}});
  const auto channel = [&](int sampler, const Json& target) {
    animation["channels"].push_back({{"sampler", sampler}, {"target", target}});
  };
  channel(0, {{"node", 1}, {"path", "translation"}});
  channel(1, {{"node", 0}, {"path", "rotation"}});
  channel(0, {{"path", "translation"}});
  return gltf;
}

struct Rewritten {
  ImportedFile before, after;
  Json json;
};

/// Rewrites with the animations that `edit` makes of the scene's.
template <class Edit>
Rewritten rewritten_keys(const TinyGltf& gltf, Edit edit) {
  auto before = gltf.import(carrying());
  if (!before) throw std::runtime_error(before.error().issue.detail);
  std::vector<Animation> animations = before->scene.animations;
  edit(animations);
  RewriteOptions options;
  options.animations = animations;
  const auto out = rewrite_gltf(*before, options);
  if (!out) throw std::runtime_error(out.error().issue.detail);
  auto after = import_gltf(out->file, "after.glb");
  if (!after) throw std::runtime_error(after.error().issue.detail);
  return {*std::move(before), *std::move(after), split_glb(out->file).json};
}

void keep_ends(Vec3Track& track) {
  track.times_s = {track.times_s.front(), track.times_s.back()};
  track.values = {track.values.front(), track.values.back()};
}

TEST(rewrite_keys, the_scenes_own_keys_change_no_byte) {
  const TinyGltf gltf = moving();
  const Rewritten same = rewritten_keys(gltf, [](auto&) {});
  EXPECT_EQ(same.json, rewritten(gltf).json);
  expect_equal(same.before.scene, same.after.scene);
}

TEST(rewrite_keys, replaced_channels_leave_the_sampler_that_others_share) {
  const Rewritten out =
      rewritten_keys(moving(), [](auto& animations) { keep_ends(animations[0].bones[0].translation); });
  const Animation& animation = out.after.scene.animations[0];
  ASSERT_EQ(animation.bones.size(), 2u);
  EXPECT_EQ(animation.bones[0].translation.times_s, (std::vector<float>{0, 2}));
  EXPECT_EQ(animation.bones[1].translation.times_s, (std::vector<float>{0, 1, 2}));
  EXPECT_EQ(animation.bones[0].rotation.times_s, (std::vector<float>{0, 1, 2}));
  EXPECT_EQ(out.json["animations"][0]["channels"].size(), 4u) << "an ignored channel is carried";
  EXPECT_EQ(out.json["animations"][0]["samplers"].size(), 3u);
  EXPECT_EQ(out.json["animations"][0]["samplers"][2]["extras"], "shared");
}

TEST(rewrite_keys, bytes_of_replaced_keys_go) {
  TinyGltf gltf;
  gltf.add_triangle();
  gltf.animate("translation", gltf.times({0, 1, 2}), gltf.vec3({0, 0, 0, 1, 0, 0, 2, 0, 0}));
  const Rewritten out = rewritten_keys(gltf, [](auto& animations) { keep_ends(animations[0].bones[0].translation); });
  EXPECT_EQ(out.json["buffers"][0]["byteLength"], 36 + 8 + 24) << "positions, two times, two keys";
  EXPECT_EQ(out.json["accessors"].size(), 3u);
  EXPECT_EQ(out.json["accessors"][1]["max"], Json::array({2.0}));
  EXPECT_EQ(out.after.scene.animations[0].bones[0].translation.values.back(), glm::vec3(2, 0, 0));
}

TEST(rewrite_keys, weights_of_a_node_and_single_ones_are_told_apart) {
  TinyGltf gltf;
  Json& primitive = gltf.add_triangle();
  const std::size_t delta = gltf.vec3({0, 0, 1, 0, 0, 0, 0, 0, 0});
  primitive["targets"] = {{{"POSITION", delta}}, {{"POSITION", delta}}};
  gltf.root["nodes"].push_back({{"mesh", 0}});
  gltf.animate("weights", gltf.times({0, 1}), gltf.scalars({0, 0, 1, 1}));
  Json& animation = gltf.root["animations"][0];
  animation["samplers"].push_back({{"input", gltf.times({0, 2})}, {"output", gltf.scalars({0, 0.5})}});
  animation["channels"].push_back(
      {{"sampler", 1},
       {"target",
        {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", "/nodes/1/weights/1"}}}}}}}});
  gltf.root["extensionsUsed"] = {"KHR_animation_pointer"};
  const Rewritten out = rewritten_keys(gltf, [](auto& animations) {
    ASSERT_EQ(animations[0].weights.size(), 2u);
    animations[0].weights[0].weights.values = {0.25f, 0.25f, 0.5f, 0.5f};
    animations[0].weights[1].weights.values = {0.75f, 1.0f};
  });
  const auto& weights = out.after.scene.animations[0].weights;
  ASSERT_EQ(weights.size(), 2u);
  EXPECT_EQ(weights[0].weights.values, (std::vector<float>{0.25f, 0.25f, 0.5f, 0.5f}));
  EXPECT_EQ(weights[1].weights.values, (std::vector<float>{0.75f, 1.0f}));
  EXPECT_EQ(weights[1].first_target, 1u);
}

}  // namespace
}  // namespace sinew::test
