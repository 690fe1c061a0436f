// SPDX-License-Identifier: MIT
#include "importer/read/lights.h"

#include <gtest/gtest.h>

#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {

constexpr const char* kExtension = "KHR_lights_punctual";

/// A file with one node for each light.
TinyGltf lit_by(const Json& lights) {
  TinyGltf file;
  file.root["extensionsUsed"] = {kExtension};
  file.root["extensions"][kExtension]["lights"] = lights;
  for (std::size_t i = 0; i < lights.size(); ++i)
    file.root["nodes"].push_back({{"extensions", {{kExtension, {{"light", i}}}}}});
  return file;
}

TEST(read_lights, wrong_values_are_reported_and_take_the_default) {
  const auto one = [](const char* json, const char* field) {
    const auto result = lit_by(Json::array({Json::parse(json)})).import();
    EXPECT_EQ(outcome(result), "ok") << json;
    EXPECT_TRUE(warns(result, "light-values", std::string("/extensions/KHR_lights_punctual/lights/0") + field)) << json;
    EXPECT_EQ(result->warnings.size(), 1u) << json;
    EXPECT_EQ(result->scene.lights.size(), 1u) << json;
    const Light usual, light = result->scene.lights.at(0);
    EXPECT_EQ(light.intensity, usual.intensity) << json;
    EXPECT_EQ(light.color, usual.color) << json;
    EXPECT_EQ(light.range_m, usual.range_m) << json;
    EXPECT_EQ(light.inner_cone_rad, usual.inner_cone_rad) << json;
    EXPECT_EQ(light.outer_cone_rad, usual.outer_cone_rad) << json;
  };
  one(R"({"type": "point", "intensity": -1})", "/intensity");
  one(R"({"type": "point", "intensity": "bright"})", "/intensity");
  one(R"({"type": "point", "intensity": 1e300})", "/intensity");
  one(R"({"type": "point", "color": [1, 1]})", "/color");
  one(R"({"type": "point", "color": [1, -1, 1]})", "/color");
  one(R"({"type": "point", "color": "red"})", "/color");
  one(R"({"type": "point", "range": -2})", "/range");
  one(R"({"type": "spot"})", "");
  one(R"({"type": "spot", "spot": 3})", "/spot");
  one(R"({"type": "spot", "spot": {"innerConeAngle": 0.5, "outerConeAngle": 0.5}})", "/spot");
  one(R"({"type": "spot", "spot": {"outerConeAngle": 2}})", "/spot/outerConeAngle");
}

TEST(read_lights, a_light_of_no_known_type_is_left_out_and_the_others_stay) {
  const auto result = lit_by(Json::parse(R"([{"type": "area"}, {"type": 5}, {}, 7, {"type": "point"}])")).import();
  ASSERT_EQ(outcome(result), "ok");
  const std::string lights = "/extensions/KHR_lights_punctual/lights/";
  EXPECT_TRUE(warns(result, "light-values", lights + "0/type"));
  EXPECT_TRUE(warns(result, "light-values", lights + "1/type"));
  EXPECT_TRUE(warns(result, "light-values", lights + "2"));
  EXPECT_TRUE(warns(result, "light-values", lights + "3"));
  ASSERT_EQ(result->scene.lights.size(), 1u);
  EXPECT_EQ(result->scene.lights[0].kind, Light::Kind::point);
  EXPECT_EQ(result->scene.skeleton.node_of_joint[result->scene.lights[0].joint], 4u);
}

TEST(read_lights, weak_light_and_short_ranges_are_as_the_file_has_them) {
  const auto result = lit_by(Json::parse(R"([{"type": "point", "intensity": 0.25, "range": 0.125},
    {"type": "point", "intensity": 0}])"))
                          .import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_TRUE(result->warnings.empty());
  EXPECT_EQ(result->scene.lights[0].intensity, 0.25f);
  EXPECT_EQ(result->scene.lights[0].range_m, 0.125f);
  EXPECT_EQ(result->scene.lights[1].intensity, 0.0f);
}

TEST(read_lights, right_values_are_read_without_a_word) {
  const auto result =
      lit_by(Json::parse(R"([{"type": "spot", "name": "a", "color": [1, 0.5, 0], "intensity": 9, "range": 3,
    "spot": {"innerConeAngle": 0.25, "outerConeAngle": 0.5}}, {"type": "directional"}])"))
          .import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_TRUE(result->warnings.empty());
  const Light light = result->scene.lights.at(0);
  EXPECT_EQ(light.name, "a");
  EXPECT_EQ(light.color, glm::vec3(1, 0.5f, 0));
  EXPECT_EQ(light.intensity, 9.0f);
  EXPECT_EQ(light.inner_cone_rad, 0.25f);
}

}  // namespace
}  // namespace sinew::test
