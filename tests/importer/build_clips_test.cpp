// SPDX-License-Identifier: MIT
#include "importer/build/build_clips.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "importer/read/rotations.h"
#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr const char* kSampler = "/animations/0/samplers/0/";

/// A file whose node 0 has a translation channel with these key times.
TinyGltf moving(const std::vector<float>& times, const char* interpolation = "LINEAR") {
  TinyGltf file;
  file.root["nodes"] = Json::array({Json::object()});
  const std::size_t per_key = std::string_view(interpolation) == "CUBICSPLINE" ? 9 : 3;
  const std::size_t input = file.times(times);
  file.animate("translation", input, file.vec3(std::vector<float>(times.size() * per_key, 1.0f)), interpolation);
  return file;
}

TEST(build_clips, keys_are_kept_as_the_file_has_them) {
  TinyGltf file;
  file.root["nodes"] = Json::array({Json::object()});
  const std::size_t input = file.times({0.25f, 1.5f});
  file.animate("translation", input, file.vec3({1, 2, 3, 4, 5, 6}));
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  ASSERT_THAT(result->scene.animations, SizeIs(1));
  const Animation& animation = result->scene.animations[0];
  EXPECT_EQ(animation.duration_s, 1.5) << "G11: from 0 to the last key";
  ASSERT_THAT(animation.bones, SizeIs(1));
  EXPECT_THAT(animation.bones[0].translation.times_s, ElementsAre(0.25f, 1.5f));
  EXPECT_EQ(animation.bones[0].translation.values[1], glm::vec3(4, 5, 6));
  EXPECT_THAT(result->warnings, IsEmpty());
  EXPECT_THAT(result->scene.clips, SizeIs(1));
}

TEST(build_clips, G03_cubic_triplets_stay_in_order) {
  TinyGltf file;
  file.root["nodes"] = Json::array({Json::object()});
  std::vector<float> values(18);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
  const std::size_t input = file.times({0, 1});
  file.animate("scale", input, file.vec3(values), "CUBICSPLINE");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const auto& track = result->scene.animations[0].bones[0].scale;
  EXPECT_EQ(track.interpolation, Interpolation::cubic_spline);
  ASSERT_THAT(track.values, SizeIs(6));
  EXPECT_EQ(track.values[4], glm::vec3(12, 13, 14)) << "value of key 1";
}

TEST(build_clips, G05_cubic_rotations_are_left_as_stored) {
  TinyGltf file;
  file.root["nodes"] = Json::array({Json::object()});
  std::vector<float> values(24, 0.0f);
  values[7] = 2.0f;
  values[4] = 1.0f;
  values[19] = -1.0f;
  const std::size_t input = file.times({0, 1});
  file.animate("rotation", input, file.vec4(values), "CUBICSPLINE");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const auto& track = result->scene.animations[0].bones[0].rotation;
  EXPECT_EQ(track.values[1].w, 2.0f);
  EXPECT_EQ(track.values[4].w, -1.0f);
  EXPECT_TRUE(warns(result, "rotation-length", "/animations/0/channels/0/sampler"));
}

TEST(build_clips, G05_tangents_of_rotations_have_any_length) {
  TinyGltf file;
  file.root["nodes"] = Json::array({Json::object()});
  const std::size_t input = file.times({0, 1});
  file.animate("rotation", input, file.vec4({0, 0, 0, 0, 0, 0, 0, 1, 3, 0, 0, 4, 0, 5, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}),
               "CUBICSPLINE");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_THAT(result->warnings, IsEmpty());
}

TEST(build_clips, G52_cubic_rotations_without_a_length_that_float_can_square_become_unit) {
  TinyGltf file;
  file.root["nodes"] = Json::array({Json::object()});
  std::vector<float> values(24, 0.0f);
  values[19] = -1e30f;
  const std::size_t input = file.times({0, 1});
  file.animate("rotation", input, file.vec4(values), "CUBICSPLINE");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const auto& track = result->scene.animations[0].bones[0].rotation;
  EXPECT_EQ(track.values[1], glm::quat(1, 0, 0, 0));
  EXPECT_EQ(track.values[4], glm::quat(-1, 0, 0, 0));
  EXPECT_EQ(track.values[0], glm::quat(0, 0, 0, 0)) << "tangents stay";
  EXPECT_TRUE(warns(result, "rotation-zero", "/animations/0/channels/0/sampler"));
}

TEST(build_clips, G08_one_key_is_a_constant_in_every_mode) {
  for (const char* mode : {"LINEAR", "STEP"}) {
    const auto result = moving({0.5f}, mode).import();
    ASSERT_THAT(result->scene.animations[0].bones, SizeIs(1)) << mode;
    EXPECT_THAT(result->warnings, IsEmpty()) << mode;
  }
  TinyGltf file;
  file.root["nodes"] = Json::array({Json::object()});
  const std::size_t input = file.times({0.5f});
  file.animate("translation", input, file.vec3({9, 9, 9, 1, 2, 3, 7, 7, 7}), "CUBICSPLINE");
  const auto cubic = file.import();
  EXPECT_TRUE(warns(cubic, "animation-cubic-keys", std::string(kSampler) + "input"));
  ASSERT_THAT(cubic->scene.animations[0].bones, SizeIs(1));
  const auto& track = cubic->scene.animations[0].bones[0].translation;
  EXPECT_EQ(track.interpolation, Interpolation::step);
  EXPECT_THAT(track.values, ElementsAre(glm::vec3(1, 2, 3)));
  EXPECT_EQ(cubic->scene.animations[0].duration_s, 0.5);
}

TEST(build_clips, G08_a_single_cubic_key_of_weights_keeps_all_of_its_values) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  const std::size_t moved = file.vec3({1, 0, 0, 0, 0, 0, 0, 0, 0});
  primitive["targets"] = Json::array({{{"POSITION", moved}}, {{"POSITION", moved}}});
  const std::size_t input = file.times({0});
  file.animate("weights", input, file.scalars({9, 9, 0.25f, 0.5f, 7, 7}), "CUBICSPLINE");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  ASSERT_THAT(result->scene.animations[0].weights, SizeIs(1));
  EXPECT_THAT(result->scene.animations[0].weights[0].weights.values, ElementsAre(0.25f, 0.5f));
}

TEST(build_clips, G09_a_sampler_without_keys_leaves_the_rest) {
  TinyGltf file;
  file.root["nodes"] = Json::array({Json::object()});
  const std::size_t none = file.times({}), no_values = file.vec3({});
  const std::size_t input = file.times({0, 1}), output = file.vec3({0, 0, 0, 1, 1, 1});
  file.animate("translation", none, no_values);
  file.root["animations"][0]["samplers"].push_back({{"input", input}, {"output", output}});
  file.root["animations"][0]["channels"].push_back({{"sampler", 1}, {"target", {{"node", 0}, {"path", "scale"}}}});
  const auto result = file.import();
  EXPECT_TRUE(warns(result, "animation-no-keys", std::string(kSampler) + "input"));
  ASSERT_THAT(result->scene.animations[0].bones, SizeIs(1));
  EXPECT_TRUE(result->scene.animations[0].bones[0].translation.empty());
  EXPECT_EQ(result->scene.animations[0].bones[0].scale.key_count(), 2u);
}

TEST(build_clips, G13_two_keys_at_one_time_are_a_jump) {
  const auto result = moving({0, 1, 1, 2}).import();
  EXPECT_TRUE(warns(result, "animation-time-repeated", std::string(kSampler) + "input"));
  EXPECT_EQ(result->scene.animations[0].bones[0].translation.key_count(), 4u);
}

TEST(build_clips, G14_bad_times_and_values_leave_the_channel_out) {
  for (const auto& times :
       {std::vector<float>{0, 2, 1}, {-1, -2, 1}, {0, kNan, 1}, {0, 1, std::numeric_limits<float>::infinity()}}) {
    TinyGltf file = moving({0, 1, 2});
    file.root["animations"][0]["samplers"][0]["input"] = file.scalars(times);
    const auto result = file.import();
    ASSERT_EQ(survived(result), "animation-times at " + std::string(kSampler) + "input");
    EXPECT_THAT(result->scene.animations[0].bones, IsEmpty());
  }
  TinyGltf file = moving({0, 1});
  file.root["animations"][0]["samplers"][0]["output"] = file.vec3({0, 0, 0, 0, kNan, 0});
  EXPECT_EQ(survived(file.import()), "animation-values at " + std::string(kSampler) + "output");
}

TEST(build_clips, G15_duration_is_from_the_data_not_from_min_and_max) {
  TinyGltf file = moving({0, 1, 2});
  file.root["accessors"][0]["max"] = {99};
  EXPECT_EQ(file.import()->scene.animations[0].duration_s, 2.0);
  file.root["accessors"][0].erase("max");
  EXPECT_TRUE(warns(file.import(), "animation-bounds", "/animations/0/samplers/0/input"));
}

TEST(build_clips, G16_the_shape_of_the_output_is_checked) {
  const auto rule = [](const char* path, auto add_output) {
    TinyGltf file;
    file.root["nodes"] = Json::array({Json::object()});
    const std::size_t input = file.times({0, 1});
    file.animate(path, input, add_output(file));
    return survived(file.import());
  };
  const std::string expected = "animation-output at /animations/0/samplers/0/output";
  EXPECT_EQ(rule("translation", [](TinyGltf& f) { return f.scalars({1, 2}); }), expected);
  EXPECT_EQ(rule("rotation", [](TinyGltf& f) { return f.vec3({1, 2, 3, 4, 5, 6}); }), expected);
  EXPECT_EQ(rule("translation", [](TinyGltf& f) { return f.vec3({1, 2, 3}); }), expected) << "too few";
  EXPECT_EQ(rule("translation",
                 [](TinyGltf& f) {
                   return f.vec3({1, 2, 3, 1, 2, 3, 1, 2, 3});
                 }),
            expected)
      << "too many";
  EXPECT_EQ(rule("scale", [](TinyGltf& f) { return f.add(std::vector<std::int8_t>(6), "VEC3", 5120, 3, true); }),
            expected)
      << "integers";
  TinyGltf input = moving({0, 1});
  input.root["animations"][0]["samplers"][0]["input"] = input.vec3({0, 0, 0, 1, 1, 1});
  EXPECT_EQ(survived(input.import()), "animation-input at /animations/0/samplers/0/input");
}

TEST(build_clips, G17_G18_normalised_integer_rotations_become_unit_floats) {
  TinyGltf file;
  file.root["nodes"] = Json::array({Json::object()});
  const std::size_t input = file.times({0, 1});
  file.animate("rotation", input,
               file.add(std::vector<std::int16_t>{0, 0, 0, 32767, 23170, 0, 0, 23170}, "VEC4", 5122, 4, true));
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const auto& keys = result->scene.animations[0].bones[0].rotation.values;
  EXPECT_EQ(keys[0].w, 1.0f);
  const double length =
      std::sqrt(static_cast<double>(keys[1].x) * keys[1].x + static_cast<double>(keys[1].w) * keys[1].w);
  EXPECT_NEAR(length, 1.0, 1e-7);
  EXPECT_THAT(result->warnings, IsEmpty());
}

TEST(build_clips, G52_long_and_zero_rotation_keys_are_repaired_and_named) {
  TinyGltf file;
  file.root["nodes"] = Json::array({Json::object()});
  const std::size_t input = file.times({0, 1});
  file.animate("rotation", input, file.vec4({0, 0, 0, 2, 0, 0, 0, 0}));
  const auto result = file.import();
  EXPECT_TRUE(warns(result, "rotation-length", "/animations/0/channels/0/sampler"));
  EXPECT_TRUE(warns(result, "rotation-zero", "/animations/0/channels/0/sampler"));
  for (const auto& q : result->scene.animations[0].bones[0].rotation.values) EXPECT_EQ(q.w, 1.0f);
}

TEST(build_clips, G06_rotations_within_float_rounding_stay_bit_exact) {
  TinyGltf file;
  file.root["nodes"] = Json::array({Json::object()});
  const std::size_t input = file.times({0});
  file.animate("rotation", input, file.vec4({0.6f, 0.0f, 0.0f, 0.8f}));
  const auto result = file.import();
  EXPECT_EQ(result->scene.animations[0].bones[0].rotation.values[0].x, 0.6f);
  EXPECT_EQ(result->scene.animations[0].bones[0].rotation.values[0].w, 0.8f);
}

TEST(build_clips, G20_of_two_channels_with_one_target_the_first_counts) {
  TinyGltf file = moving({0, 1});
  file.root["animations"][0]["samplers"].push_back({{"input", 0}, {"output", file.vec3({9, 9, 9, 9, 9, 9})}});
  file.root["animations"][0]["channels"].push_back(
      {{"sampler", 1}, {"target", {{"node", 0}, {"path", "translation"}}}});
  const auto result = file.import();
  EXPECT_TRUE(warns(result, "animation-duplicate", "/animations/0/channels/1/target"));
  EXPECT_EQ(result->scene.animations[0].bones[0].translation.values[0], glm::vec3(1.0f));
}

TEST(build_clips, G21_T2_channels_without_a_node_are_ignored_and_shift_nothing) {
  TinyGltf file = moving({0, 1});
  auto& channels = file.root["animations"][0]["channels"];
  channels.insert(channels.begin(), Json({{"sampler", 0}, {"target", {{"path", "scale"}}}}));
  channels[1]["target"]["path"] = "sideways";
  channels.push_back({{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}});
  const auto result = file.import();
  EXPECT_TRUE(warns(result, "animation-no-target", "/animations/0/channels/0/target"));
  EXPECT_TRUE(warns(result, "animation-path", "/animations/0/channels/1/target/path"));
  EXPECT_THAT(result->scene.animations[0].bones, SizeIs(1));
}

TEST(build_clips, T2_unknown_interpolation_is_linear) {
  const auto result = moving({0, 1}, "SMOOTH").import();
  EXPECT_TRUE(warns(result, "animation-interpolation", std::string(kSampler) + "interpolation"));
  EXPECT_EQ(result->scene.animations[0].bones[0].translation.interpolation, Interpolation::linear);
}

TEST(build_clips, G19_weights_are_frame_major_for_all_targets) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  const std::size_t delta = file.vec3(std::vector<float>(9, 1.0f));
  primitive["targets"] = Json::array({{{"POSITION", delta}}, {{"POSITION", delta}}});
  const std::size_t input = file.times({0, 1});
  file.animate("weights", input, file.scalars({0, 1, 2, 3}));
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  ASSERT_THAT(result->scene.animations[0].weights, SizeIs(1));
  EXPECT_EQ(result->scene.animations[0].weights[0].weights.target_count, 2u);
  EXPECT_THAT(result->scene.animations[0].weights[0].weights.values, ElementsAre(0, 1, 2, 3));
  file.animate("weights", input, file.scalars({0, 1}));
  EXPECT_EQ(survived(file.import()), "animation-output at /animations/0/samplers/0/output");
  primitive.erase("targets");
  EXPECT_TRUE(warns(file.import(), "animation-no-morphs", "/animations/0/channels/0/target"));
}

TEST(build_clips, G58_pointers_to_node_properties_are_plain_channels) {
  const auto with_pointer = [](const char* text) {
    TinyGltf file = moving({0, 1});
    file.root["animations"][0]["channels"][0]["target"] = {
        {"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", text}}}}}};
    return file.import();
  };
  ASSERT_EQ(outcome(with_pointer("/nodes/0/scale")), "ok");
  EXPECT_EQ(with_pointer("/nodes/0/scale")->scene.animations[0].bones[0].scale.key_count(), 2u);
  EXPECT_EQ(survived(with_pointer("/nodes/7/scale")), "reference at /animations/0/channels/0/target");
  for (const char* other : {"/materials/0/doubleSided", "/nodes/0/matrix", "/nodes/x/scale", "/nodes/0",
                            "nodes/0/scale", "", "/nodes/-1/scale"})
    EXPECT_TRUE(warns(with_pointer(other), "animation-pointer", "/animations/0/channels/0/target")) << other;
}

TEST(build_clips, interleaved_samplers_are_read_with_their_stride) {
  TinyGltf file = moving({0, 1});
  const std::size_t view = file.add_view(std::vector<float>{0, 1, 2, 3, 1, 4, 5, 6});
  file.root["bufferViews"][view]["byteStride"] = 16;
  file.root["accessors"][0]["bufferView"] = view;
  file.root["accessors"][1]["bufferView"] = view;
  file.root["accessors"][1]["byteOffset"] = 4;
  const auto result = file.import();
  EXPECT_TRUE(warns(result, "animation-stride", std::string(kSampler) + "input"));
  EXPECT_EQ(result->scene.animations[0].bones[0].translation.values[1], glm::vec3(4, 5, 6));
}

TEST(rotations, G06_unit_quaternions_keep_their_bits) {
  const float x = std::nextafter(0.6f, 1.0f), w = std::nextafter(0.8f, 1.0f);
  const double length = std::hypot(double{x}, double{w});
  ASSERT_NE(static_cast<float>(w / length), w) << "a division would change it";
  const UnitRotation unit = unit_rotation(x, 0.0, 0.0, w);
  EXPECT_EQ(unit.rotation, glm::quat(w, x, 0, 0));
  EXPECT_EQ(unit_rotation(1.2, 0.0, 0.0, 1.6).rotation, glm::quat(0.8f, 0.6f, 0, 0));
}

TEST(rotations, G18_lengths_beyond_the_rounding_of_bytes_are_told) {
  for (const auto& [length, is_told] : {std::pair{1.007, false}, {1.009, true}, {0.993, false}, {0.991, true}}) {
    IssueLog log;
    RotationTally tally;
    tally.add(1.0);
    tally.add(length);
    tally.report("/nodes/0/rotation", "the rotation", "rotations", log);
    EXPECT_EQ(!log.take_warnings().empty(), is_told) << length;
  }
}

}  // namespace
}  // namespace sinew::test
