// SPDX-License-Identifier: MIT
// Faulty vertex weights in files: sums other than 1, repeated joints, vertices without any weight.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;
using testing::FloatEq;
using testing::IsEmpty;

constexpr const char* kAttributes = "/meshes/0/primitives/0/attributes";

const Primitive& only(const ImportResult<ImportedFile>& result) { return result->scene.meshes.at(0).primitives.at(0); }

TEST(merge_influences, G38_weights_are_divided_by_their_sum_and_the_deviation_is_named) {
  TinyGltf file;
  file.add_skinned_triangle({0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {.25f, .5f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  const auto result = file.import();
  EXPECT_TRUE(warns(result, "weights-sum", kAttributes));
  EXPECT_NE(result->warnings[0].detail.find("0.25"), std::string::npos) << result->warnings[0].detail;
  EXPECT_THAT(only(result).influences.weights, ElementsAre(1, 1, FloatEq(2.0f / 3), FloatEq(1.0f / 3)));
}

TEST(merge_influences, G38_of_several_vertices_the_worst_sum_and_the_mean_are_named) {
  TinyGltf file;
  file.add_skinned_triangle({0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0}, {.25f, .5f, 0, 0, 1, 0, 0, 0, .5f, .375f, 0, 0});
  const auto result = file.import();
  ASSERT_TRUE(warns(result, "weights-sum", kAttributes));
  EXPECT_THAT(result->warnings[0].detail, testing::HasSubstr("worst is off by 0.250000"));
  EXPECT_THAT(result->warnings[0].detail, testing::HasSubstr("on average they are by 0.187500"));
}

TEST(merge_influences, G38_weights_that_sum_to_1_within_rounding_keep_their_bits) {
  const float a = 0.70000005f, b = 0.20000003f, c = 0.10000002f;
  ASSERT_NE(static_cast<float>(a / (double{a} + double{b} + double{c})), a) << "a division would change it";
  TinyGltf file;
  file.add_skinned_triangle({0, 1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {a, b, c, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  file.root["skins"][0]["joints"] = {0, 1, 2};
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_THAT(only(result).influences.weights, ElementsAre(1, 1, a, b, c));
}

TEST(merge_influences, G38_a_weight_one_rounding_below_1_keeps_its_bits_and_one_two_below_does_not) {
  const float one_below = 1.0f - 0x1p-24f, two_below = 1.0f - 0x1p-23f;
  TinyGltf file;
  file.add_skinned_triangle({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {one_below, 0, 0, 0, two_below, 0, 0, 0, 1, 0, 0, 0});
  EXPECT_THAT(only(file.import()).influences.weights, testing::UnorderedElementsAre(one_below, 1, 1));
}

TEST(merge_influences, G39_vertices_without_weight_follow_joint_slot_0) {
  TinyGltf file;
  file.add_skinned_triangle({1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}, {0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  const auto result = file.import();
  EXPECT_TRUE(warns(result, "weights-zero", kAttributes));
  EXPECT_THAT(only(result).influences.joints, ElementsAre(0, 1, 1));
}

TEST(merge_influences, G41_repeated_joints_are_added_up_and_negative_weights_are_zero) {
  TinyGltf file;
  file.add_skinned_triangle({1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {.5f, .25f, .25f, -.5f, 1, 0, 0, 0, 1, 0, 0, 0});
  const auto result = file.import();
  EXPECT_TRUE(warns(result, "joint-repeated", kAttributes));
  EXPECT_TRUE(warns(result, "weights-negative", kAttributes));
  EXPECT_THAT(only(result).influences.weights, ElementsAre(1, 1, .75f, .25f));
}

TEST(merge_influences, G41_a_vertex_with_only_negative_weights_hangs_on_the_first_joint_of_the_skin) {
  TinyGltf file;
  file.add_skinned_triangle({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {-1, -.5f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  const auto result = file.import();
  EXPECT_TRUE(warns(result, "weights-negative", kAttributes));
  EXPECT_TRUE(warns(result, "weights-zero", kAttributes));
  EXPECT_THAT(only(result).influences.joints, ElementsAre(0, 0, 0));
  EXPECT_THAT(only(result).influences.weights, ElementsAre(1, 1, 1));
}

TEST(merge_influences, G40_all_joint_sets_count) {
  TinyGltf file;
  Json& primitive =
      file.add_skinned_triangle({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {.5f, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  primitive["attributes"]["JOINTS_1"] =
      file.add(std::vector<std::uint16_t>{1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4", 5123, 4);
  primitive["attributes"]["WEIGHTS_1"] = file.vec4({.5f, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_THAT(result->warnings, IsEmpty());
  EXPECT_THAT(only(result).influences.joints, ElementsAre(0, 0, 0, 1));
  primitive["attributes"].erase("WEIGHTS_1");
  EXPECT_TRUE(warns(file.import(), "mesh-joint-sets", kAttributes));
}

TEST(merge_influences, G36_a_joint_past_the_end_is_named_by_the_set_that_has_it) {
  for (const std::string set : {"0", "1", "2"}) {
    TinyGltf file;
    Json& attributes = file.add_skinned_triangle(std::vector<std::uint8_t>(12), std::vector<float>(12))["attributes"];
    attributes.erase("WEIGHTS_0");
    attributes["JOINTS_" + set] = file.add(std::vector<std::uint8_t>(12, 7), "VEC4", 5121, 4);
    attributes["WEIGHTS_" + set] = file.vec4(std::vector<float>(12, 0.25f));
    EXPECT_EQ(outcome(file.import()), std::string("joint-index at ") + kAttributes + "/JOINTS_" + set);
  }
}

TEST(merge_influences, G40_G41_joints_that_repeat_over_many_sets_are_added_up) {
  for (const int sets : {2, 8, 9}) {
    const float weight = 1.0f / static_cast<float>(4 * sets);
    TinyGltf file;
    Json& attributes =
        file.add_skinned_triangle({0, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1}, std::vector<float>(12, weight))["attributes"];
    for (int set = 1; set < sets; ++set)
      for (const std::string name : {"JOINTS_", "WEIGHTS_"})
        attributes[name + std::to_string(set)] = attributes[name + "0"];
    const auto result = file.import();
    ASSERT_EQ(outcome(result), "ok");
    EXPECT_THAT(only(result).influences.joints, ElementsAre(1, 0, 1, 0, 1, 0)) << sets;
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(only(result).influences.weights.at(i), i % 2 == 0 ? 0.75f : 0.25f, 1e-6f) << sets;
  }
}

}  // namespace
}  // namespace sinew::test
