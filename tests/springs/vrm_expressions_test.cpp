// SPDX-License-Identifier: MIT
#include "importer/vrm_expressions.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {

/// Two nodes that show a triangle with one morph target: each has a weight of its own.
TEST(vrm_expressions, become_morph_weights_with_their_overrides) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["targets"] = Json::array({{{"POSITION", file.vec3({1, 0, 0, 0, 0, 0, 0, 0, 0})}}});
  file.root["nodes"] = Json::parse(R"([{"mesh": 0}, {"mesh": 0}])");
  file.root["scenes"] = Json::parse(R"([{"nodes": [0, 1]}])");
  file.root["extensionsUsed"] = {"VRMC_vrm"};
  file.root["extensions"]["VRMC_vrm"] = Json::parse(R"({"specVersion": "1.0", "expressions": {
    "preset": {"blink": {"morphTargetBinds": [{"node": 1, "index": 0, "weight": 0.5}, {"node": 1, "index": 7}]},
               "happy": {"isBinary": true, "overrideBlink": "block", "overrideMouth": "blend",
                         "morphTargetBinds": [{"node": 0, "index": 0}]}},
    "custom": {"aa": {"morphTargetBinds": []}}}})");
  const auto imported = file.import();
  ASSERT_EQ(outcome(imported), "ok");
  const std::vector<Expression> expressions = expressions_of(*imported->vrm, imported->scene);
  ASSERT_EQ(expressions.size(), 3u);
  EXPECT_EQ(expressions[0].name, "blink");
  EXPECT_EQ(expressions[0].part, Expression::Part::blink);
  ASSERT_EQ(expressions[0].binds.size(), 1u) << "there is no target 7";
  EXPECT_EQ(expressions[1].blink, Expression::Override::block);
  EXPECT_EQ(expressions[1].mouth, Expression::Override::blend);
  EXPECT_EQ(expressions[1].look_at, Expression::Override::none);
  EXPECT_EQ(expressions[2].part, Expression::Part::other) << "a custom one, whatever its name";
  std::vector<float> weights(imported->scene.weight_count(), 0.0f);
  const std::vector<float> values{1.0f, 0.0f, 0.0f};
  ASSERT_EQ(run(ExpressionsJob{expressions, values, weights}), ErrorCode::ok);
  EXPECT_EQ(weights[expressions[0].binds[0].weight], 0.5f);
  EXPECT_EQ(weights[expressions[1].binds[0].weight], 0.0f);
}

}  // namespace
}  // namespace sinew::test
