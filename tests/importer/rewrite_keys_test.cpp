// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/importer/rewritten.h"
#include "tests/support/scene_equality.h"

namespace sinew::test {
namespace {

/// Channels 0 and 1 move node 0 and share a sampler. Channel 2 rotates it. Channel 3 names no node.
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

/// Rewrites the file with `edit` applied to the scene's animations.
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

TEST(rewrite_keys, samplers_go_with_their_last_channel_alone) {
  TinyGltf gltf = moving();
  Json spare = gltf.root["animations"][0]["samplers"][1];
  spare["extras"] = "of no channel";
  gltf.root["animations"][0]["samplers"].push_back(spare);
  const Json samplers = rewritten_keys(gltf, [](auto& animations) {
                          keep_ends(animations[0].bones[0].translation);
                        }).json["animations"][0]["samplers"];
  ASSERT_EQ(samplers.size(), 4u) << "the shared one stays for the channel that keeps its keys";
  EXPECT_EQ(samplers[2]["extras"], "of no channel");
}

TEST(rewrite_keys, the_scenes_own_keys_change_no_byte) {
  TinyGltf gltf = moving();
  Json second = gltf.root["animations"][0];
  second["samplers"][0]["output"] = gltf.vec3({5, 0, 0, 6, 0, 0, 7, 0, 0});
  gltf.root["animations"].push_back(second);
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

TEST(rewrite_keys, channels_without_keys_go_with_their_bytes_and_what_says_more_stays) {
  const auto leave_out = [](auto& animations) { animations[0].bones[0].rotation = {}; };
  TinyGltf gltf = moving();
  const Rewritten out = rewritten_keys(gltf, leave_out);
  EXPECT_TRUE(out.after.scene.animations[0].bones[0].rotation.empty());
  EXPECT_EQ(out.after.scene.animations[0].bones[0].translation.times_s, (std::vector<float>{0, 1, 2}));
  EXPECT_EQ(out.json["animations"][0]["channels"].size(), 3u);
  EXPECT_EQ(out.json["animations"][0]["samplers"].size(), 1u);
  const auto bytes = [](const Rewritten& file) { return file.json["buffers"][0]["byteLength"].get<int>(); };
  EXPECT_EQ(bytes(out), bytes(rewritten_keys(gltf, [](auto&) {})) - 48);

  for (const char* place : {"/channels/2", "/channels/2/target", "/samplers/1"}) {
    TinyGltf with_more = moving();
    with_more.root["animations"][0][Json::json_pointer(place)]["extras"] = "of the author";
    const Rewritten kept = rewritten_keys(with_more, leave_out);
    EXPECT_EQ(kept.json["animations"][0]["channels"].size(), 4u) << place;
    EXPECT_EQ(kept.after.scene.animations[0].bones[0].rotation.key_count(), 3u) << place;
  }
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

TEST(rewrite_keys, accessors_that_nothing_named_before_stay_as_they_are) {
  TinyGltf gltf;
  gltf.add_triangle();
  const std::size_t spare = gltf.vec3({7, 8, 9});
  gltf.root["accessors"][spare]["name"] = "of the author";
  gltf.animate("translation", gltf.times({0, 1, 2}), gltf.vec3({0, 0, 0, 1, 0, 0, 2, 0, 0}));
  const Json accessors =
      rewritten_keys(gltf, [](auto& animations) { keep_ends(animations[0].bones[0].translation); }).json["accessors"];
  ASSERT_EQ(accessors.size(), 4u) << "positions, the author's, two times, two keys";
  EXPECT_EQ(accessors[1]["name"], "of the author");
  EXPECT_EQ(accessors[1]["count"], 1);
}

/// Everything that refers to an accessor or a view must use its new number.
TEST(rewrite_keys, references_are_renumbered_when_entries_are_removed) {
  TinyGltf gltf;
  gltf.animate("translation", gltf.times({0, 1, 2}), gltf.vec3({0, 0, 0, 1, 0, 0, 2, 0, 0}));
  Json& primitive = gltf.add_skinned_triangle(std::vector<std::uint8_t>(12), {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  primitive["indices"] = gltf.add(std::vector<std::uint16_t>{2, 1, 0}, "SCALAR", 5123, 1);
  const Json places{{"bufferView", gltf.add_view(std::vector<std::uint16_t>{2})}, {"componentType", 5123}},
      values{{"bufferView", gltf.add_view<float>({7, 8, 9})}};
  const Json sparse{{"count", 1}, {"indices", places}, {"values", values}};
  gltf.root["accessors"].push_back({{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}, {"sparse", sparse}});
  primitive["targets"] = {{{"POSITION", gltf.root["accessors"].size() - 1}}};
  std::vector<float> binds(32, 0.0f);
  for (const std::size_t i : {0u, 5u, 10u, 15u, 16u, 21u, 26u, 31u}) binds[i] = 1.0f;
  binds[12] = 3.0f;
  gltf.root["skins"][0]["inverseBindMatrices"] = gltf.add(binds, "MAT4", 5126, 16);
  const Json copies{{"attributes", {{"TRANSLATION", gltf.vec3({1, 2, 3, 4, 5, 6})}}}};
  gltf.root["nodes"].push_back({{"mesh", 0}, {"extensions", {{"EXT_mesh_gpu_instancing", copies}}}});
  gltf.root["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  Rewritten out = rewritten_keys(gltf, [](auto& animations) { keep_ends(animations[0].bones[0].translation); });
  ASSERT_EQ(out.after.scene.instances[1].copies.size(), 2u);
  out.after.scene.animations = out.before.scene.animations;
  out.after.scene.clips = out.before.scene.clips;
  expect_equal(out.before.scene, out.after.scene);
}

TEST(rewrite_keys, of_two_channels_with_one_target_the_ignored_one_keeps_its_keys) {
  TinyGltf gltf;
  gltf.add_triangle();
  const std::size_t keys = gltf.vec3({0, 0, 0, 1, 0, 0, 2, 0, 0});
  gltf.animate("translation", gltf.times({0, 1, 2}), keys);
  Json& animation = gltf.root["animations"][0];
  animation["channels"].push_back(animation["channels"][0]);
  const Json json = rewritten_keys(gltf, [](auto& animations) { keep_ends(animations[0].bones[0].translation); }).json;
  const auto key_count = [&](std::size_t channel) {
    const Json& written = json["animations"][0];
    const Json& sampler = written["samplers"][written["channels"][channel]["sampler"].get<std::size_t>()];
    return json["accessors"][sampler["output"].get<std::size_t>()]["count"].get<std::size_t>();
  };
  EXPECT_EQ(key_count(0), 2u);
  EXPECT_EQ(key_count(1), 3u);
}

TEST(rewrite_keys, added_weights_move_the_node_that_shows_their_mesh) {
  TinyGltf gltf;
  gltf.add_triangle()["targets"] = {{{"POSITION", gltf.vec3({0, 0, 1, 0, 0, 0, 0, 0, 0})}}};
  gltf.root["nodes"] = Json::array({Json::object(), {{"mesh", 0}}, {{"mesh", 0}}});
  const Animation smile{"smile", 1.0, {}, {{1, {Interpolation::linear, {0, 1}, {0.25f, 0.5f}, 1}}}};
  RewriteOptions options;
  const Animation added[] = {smile};
  options.added_animations = added;
  const auto out = rewrite(gltf, options);
  ASSERT_TRUE(out) << out.error().issue.detail;
  const auto after = import_gltf(out->file, "after.glb");
  ASSERT_TRUE(after && after->scene.animations.at(0).weights.size() == 1);
  EXPECT_EQ(after->scene.animations[0].weights[0].instance, 1u);
  EXPECT_EQ(after->scene.animations[0].weights[0].weights.values, smile.weights[0].weights.values);
}

TEST(rewrite_keys, bytes_of_replaced_keys_go_where_they_are_sparse_too) {
  TinyGltf gltf;
  gltf.add_triangle();
  const std::size_t times = gltf.times({0, 1, 2}), keys = gltf.root["accessors"].size();
  const std::size_t indices = gltf.add_view(std::vector<std::uint16_t>{2}), values = gltf.add_view<float>({2, 0, 0});
  gltf.root["accessors"].push_back({{"componentType", 5126},
                                    {"count", 3},
                                    {"type", "VEC3"},
                                    {"sparse",
                                     {{"count", 1},
                                      {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                      {"values", {{"bufferView", values}}}}}});
  gltf.animate("translation", times, keys);
  const Rewritten out = rewritten_keys(gltf, [](auto& animations) { keep_ends(animations[0].bones[0].translation); });
  EXPECT_EQ(out.json["buffers"][0]["byteLength"], 36 + 8 + 24) << "positions, two times, two keys";
  EXPECT_EQ(out.after.scene.animations[0].bones[0].translation.values.back(), glm::vec3(2, 0, 0));
}

TEST(rewrite_keys, channels_of_weights_that_nothing_has_keep_their_keys) {
  TinyGltf gltf = moving();
  Json& animation = gltf.root["animations"][0];
  const std::size_t output = gltf.scalars({0, 1, 2});
  animation["samplers"].push_back({{"input", animation["samplers"][0]["input"]}, {"output", output}});
  animation["channels"].push_back({{"sampler", 2}, {"target", {{"node", 1}, {"path", "weights"}}}});
  const Rewritten out = rewritten_keys(gltf, [](auto& animations) { keep_ends(animations[0].bones[0].translation); });
  const Json& written = out.json["animations"][0];
  ASSERT_EQ(written["channels"][4]["target"], (Json{{"node", 1}, {"path", "weights"}}));
  const std::size_t sampler = written["channels"][4]["sampler"];
  EXPECT_EQ(out.json["accessors"][written["samplers"][sampler]["output"].get<std::size_t>()]["count"], 3);
}

TEST(rewrite_keys, weights_of_a_node_and_single_ones_are_told_apart) {
  TinyGltf gltf;
  Json& primitive = gltf.add_triangle();
  const std::size_t delta = gltf.vec3({0, 0, 1, 0, 0, 0, 0, 0, 0});
  primitive["targets"] = {{{"POSITION", delta}}, {{"POSITION", delta}}};
  gltf.root["nodes"].push_back({{"mesh", 0}});
  gltf.animate("weights", gltf.times({0, 1}), gltf.scalars({0, 0, 1, 1}));
  Json& animation = gltf.root["animations"][0];
  const std::size_t times = gltf.times({0, 2});
  for (const std::string target : {"0", "1"}) {
    const Json pointer{{"pointer", "/nodes/1/weights/" + target}};
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size()},
         {"target", {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", pointer}}}}}});
    animation["samplers"].push_back({{"input", times}, {"output", gltf.scalars({0, 0.5})}});
  }
  gltf.root["extensionsUsed"] = {"KHR_animation_pointer"};
  const std::vector<float> values[] = {{0.25f, 0.25f, 0.5f, 0.5f}, {0.125f, 0.375f}, {0.75f, 1.0f}};
  const Rewritten out = rewritten_keys(gltf, [&](auto& animations) {
    ASSERT_EQ(animations[0].weights.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) animations[0].weights[i].weights.values = values[i];
  });
  const auto& weights = out.after.scene.animations[0].weights;
  ASSERT_EQ(weights.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(weights[i].weights.values, values[i]);
    EXPECT_EQ(weights[i].first_target, i == 2 ? 1u : 0u);
  }
}

TEST(rewrite_keys, weights_of_two_nodes_that_show_one_mesh_stay_apart) {
  TinyGltf gltf;
  Json& primitive = gltf.add_triangle();
  primitive["targets"] = {{{"POSITION", gltf.vec3({0, 0, 1, 0, 0, 0, 0, 0, 0})}}};
  gltf.root["nodes"].push_back({{"mesh", 0}});
  const std::size_t times = gltf.times({0, 1});
  gltf.animate("weights", times, gltf.scalars({0, 1}));
  Json& animation = gltf.root["animations"][0];
  animation["samplers"].push_back({{"input", times}, {"output", gltf.scalars({0.5, 0.25})}});
  animation["channels"].push_back({{"sampler", 1}, {"target", {{"node", 1}, {"path", "weights"}}}});
  const Rewritten out = rewritten_keys(gltf, [](auto& animations) {
    ASSERT_EQ(animations[0].weights.size(), 2u);
    animations[0].weights[1].weights.values = {0.75f, 0.125f};
  });
  const auto& weights = out.after.scene.animations[0].weights;
  ASSERT_EQ(weights.size(), 2u);
  EXPECT_EQ(weights[0].weights.values, (std::vector<float>{0, 1}));
  EXPECT_EQ(weights[1].weights.values, (std::vector<float>{0.75f, 0.125f}));
}

/// Rewrites the file with additional animations.
ImportResult<RewrittenFile> with_added(const TinyGltf& gltf, const std::vector<Animation>& added) {
  RewriteOptions options;
  options.added_animations = added;
  return rewrite(gltf, options);
}

/// Joint 0 moves up and rotates; both tracks have the same key times.
Animation up_and_round() {
  BoneAnimation bone;
  bone.translation = {Interpolation::step, {0, 1}, {{0, 0, 0}, {0, 2, 0}}};
  bone.rotation = {Interpolation::cubic_spline, {0, 1}, std::vector<glm::quat>(6, glm::quat(1, 0, 0, 0))};
  bone.scale = {Interpolation::linear, {0.5f}, {{1, 2, 3}}};
  return {"up", 1.0, {bone}, {}};
}

TEST(rewrite_keys, added_animations_come_behind_the_files_and_all_else_stays) {
  TinyGltf gltf = moving();
  gltf.root["nodes"][1]["extras"] = {{"mine", 7}};
  gltf.root["extensionsUsed"] = {"ACME_thing"};
  gltf.root["nodes"][0]["extensions"] = {{"ACME_thing", {{"level", 3}}}};
  const auto out = with_added(gltf, {up_and_round(), {"nothing", 0.0, {}, {}}});
  ASSERT_TRUE(out) << out.error().issue.detail;
  const auto after = import_gltf(out->file, "after.glb");
  ASSERT_TRUE(after);
  EXPECT_TRUE(after->warnings.empty() || after->warnings[0].rule != "json-schema");
  ASSERT_EQ(after->scene.animations.size(), 3u);
  const Animation& up = after->scene.animations[1];
  EXPECT_EQ(up.name, "up");
  EXPECT_EQ(after->scene.animations[2].name, "nothing");
  ASSERT_EQ(up.bones.size(), 1u);
  const BoneAnimation &found = up.bones[0], made = up_and_round().bones[0];
  EXPECT_EQ(found.joint, 0u);
  EXPECT_EQ(found.translation.values, made.translation.values);
  EXPECT_EQ(found.translation.interpolation, Interpolation::step);
  EXPECT_EQ(found.rotation.values, made.rotation.values);
  EXPECT_EQ(found.rotation.interpolation, Interpolation::cubic_spline);
  EXPECT_EQ(found.scale.values, made.scale.values);

  Json plain = rewritten(gltf).json, json = split_glb(out->file).json;
  EXPECT_EQ(json["animations"][0], plain["animations"][0]);
  EXPECT_EQ(json["animations"][2]["channels"].size(), 1u) << "glTF demands one";
  const Json& samplers = json["animations"][1]["samplers"];
  EXPECT_EQ(samplers[0]["input"], samplers[1]["input"]) << "shared times are written once";
  EXPECT_NE(samplers[0]["input"], samplers[2]["input"]);
  for (Json* document : {&plain, &json})
    for (const char* grown : {"animations", "accessors", "bufferViews", "buffers"}) document->erase(grown);
  EXPECT_EQ(json, plain) << "extras and extensions that nobody here knows stay";
}

TEST(rewrite_keys, a_matrix_that_is_animated_now_is_taken_apart_or_is_a_loss) {
  TinyGltf gltf;
  gltf.add_triangle();
  gltf.root["nodes"][0]["matrix"] = {0, 0, -2, 0, 0, 3, 0, 0, 4, 0, 0, 0, 5, 6, 7, 1};
  const auto out = with_added(gltf, {up_and_round()});
  ASSERT_TRUE(out) << out.error().issue.detail;
  const Json node = split_glb(out->file).json["nodes"][0];
  EXPECT_FALSE(node.contains("matrix"));
  EXPECT_EQ(node["translation"], Json::array({5, 6, 7}));
  EXPECT_NEAR(node["scale"][0].get<double>(), 2.0, 1e-6);
  EXPECT_NEAR(std::abs(node["rotation"][1].get<double>()), std::sqrt(0.5), 1e-6);

  gltf.root["nodes"][0]["matrix"] = {1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const auto sheared = with_added(gltf, {up_and_round()});
  ASSERT_FALSE(sheared);
  EXPECT_EQ(sheared.error().issue.json_pointer, "/nodes/0/matrix");
  EXPECT_THAT(sheared.error().issue.detail, testing::HasSubstr("node-matrix-animated"));
  EXPECT_TRUE(split_glb(rewrite(gltf)->file).json["nodes"][0].contains("matrix")) << "without animation it stays";
}

TEST(rewrite_keys, a_matrix_that_two_animations_move_is_one_loss) {
  TinyGltf gltf;
  gltf.add_triangle();
  gltf.root["nodes"][0]["matrix"] = {1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  RewriteOptions options;
  const Animation added[] = {up_and_round(), up_and_round()};
  options.added_animations = added;
  options.drop = {"all"};
  const auto out = rewrite(gltf, options);
  ASSERT_TRUE(out) << out.error().issue.detail;
  EXPECT_EQ(out->drops.size(), 1u);
}

TEST(rewrite_keys, a_matrix_is_taken_apart_at_the_node_of_its_joint) {
  TinyGltf gltf;
  gltf.add_triangle();
  gltf.root["nodes"][0]["matrix"] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 5, 6, 7, 1};
  gltf.root["nodes"].push_back({{"children", {0}}, {"matrix", {3, 0, 0, 0, 0, 3, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1}}});
  Animation up = up_and_round();
  up.bones[0].joint = 1;  // the joint of node 0
  const auto out = with_added(gltf, {up});
  ASSERT_TRUE(out) << out.error().issue.detail;
  const Json nodes = split_glb(out->file).json["nodes"];
  EXPECT_EQ(nodes[0].value("translation", Json()), Json::array({5, 6, 7}));
  EXPECT_FALSE(nodes[0].contains("matrix"));
  EXPECT_TRUE(nodes[1].contains("matrix"));
}

TEST(rewrite_keys, added_properties_are_named_by_pointers_and_keep_their_numbers) {
  TinyGltf gltf = moving();
  gltf.root["materials"] = Json::array({Json::object()});
  gltf.root["nodes"][1]["extensions"]["KHR_node_visibility"]["visible"] = true;
  gltf.root["extensionsUsed"] = {"KHR_node_visibility"};
  const PropertyTrack shown{{PropertyKind::node_visible, 1}, {Interpolation::step, {0, 1}, {1, 0}, 1}},
      bright{{PropertyKind::emissive, 0}, {Interpolation::linear, {0, 1}, {0, .5f, 1, 1, .25f, 0}, 3}};
  const auto out = with_added(gltf, {{"glow", 1.0, {}, {}, {shown, bright}}});
  ASSERT_TRUE(out) << out.error().issue.detail;
  EXPECT_EQ(split_glb(out->file).json["extensionsUsed"], (Json{"KHR_node_visibility", "KHR_animation_pointer"}));
  const auto after = import_gltf(out->file, "after.glb");
  ASSERT_EQ(outcome(after), "ok");
  const auto& properties = after->scene.animations.back().properties;
  ASSERT_EQ(properties.size(), 2u);
  for (const std::size_t i : {0u, 1u}) {
    const PropertyTrack& made = i == 0 ? shown : bright;
    EXPECT_EQ(properties[i].target, made.target);
    EXPECT_EQ(properties[i].values.values, made.values.values);
    EXPECT_EQ(properties[i].values.interpolation, made.values.interpolation);
  }
}

TEST(rewrite_keys, a_matrix_that_shears_a_little_is_a_loss_and_one_that_is_rounded_is_none) {
  TinyGltf gltf;
  gltf.add_triangle();
  for (const double size : {0.01, 1.0, 100.0})
    for (const double shear : {1e-6, 1e-3, 5e-3, 2e-2, 0.5}) {
      const double skewed = shear * size;
      gltf.root["nodes"][0]["matrix"] = {size, 0, 0, 0, skewed, size, 0, 0, 0, 0, size, 0, 100, 0, 0, 1};
      EXPECT_EQ(with_added(gltf, {up_and_round()}).has_value(), shear < 1e-5) << shear << " of " << size;
    }
  gltf.root["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 100, 0, 0, 1e-3, 0, 1, 0, 0, 0, 0, 1};
  EXPECT_FALSE(with_added(gltf, {up_and_round()})) << "beside a long column";
  gltf.root["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  EXPECT_TRUE(with_added(gltf, {up_and_round()})) << "flat";
}

}  // namespace
}  // namespace sinew::test
