// SPDX-License-Identifier: MIT
#include "importer/build/build_skeleton.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<float> matrix(float last_row_x = 0.0f, float scale = 1.0f) {
  return {scale, 0, 0, last_row_x, 0, scale, 0, 0, 0, 0, scale, 0, 5, 6, 7, 1};
}

TEST(build_skeleton, joints_are_in_breadth_first_order_with_levels) {
  TinyGltf file;
  file.root["nodes"] = Json::parse(R"([{"children":[3]},{"children":[0,4]},{"name":"root b"},{},{"name":"four"}])");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const Skeleton& s = result->scene.skeleton;
  EXPECT_THAT(s.node_of_joint, ElementsAre(1, 2, 0, 4, 3));
  EXPECT_THAT(s.parents, ElementsAre(kNone, kNone, 0, 0, 2));
  EXPECT_THAT(s.level_begin, ElementsAre(0, 2, 4, 5));
  EXPECT_THAT(s.joint_of_node, ElementsAre(2, 0, 1, 4, 3));
  EXPECT_EQ(s.names[3], "four");
}

TEST(build_skeleton, G50_a_matrix_is_kept_verbatim_unless_it_is_animated) {
  TinyGltf file;
  file.root["nodes"] = Json::array({{{"matrix", matrix(0, 2)}}});
  const auto still = file.import();
  ASSERT_EQ(outcome(still), "ok");
  ASSERT_THAT(still->scene.skeleton.fixed_matrices, SizeIs(1));
  EXPECT_EQ(still->scene.skeleton.fixed_matrices[0].row[1], glm::vec4(0, 2, 0, 6));
  const std::size_t input = file.times({0, 1});
  file.animate("scale", input, file.vec3({1, 1, 1, 2, 2, 2}));
  const auto moved = file.import();
  EXPECT_TRUE(warns(moved, "node-matrix-animated", "/nodes/0/matrix"));
  EXPECT_THAT(moved->scene.skeleton.fixed_matrices, IsEmpty());
  EXPECT_EQ(moved->scene.skeleton.rest[0].translation, glm::vec3(5, 6, 7));
  EXPECT_EQ(moved->scene.skeleton.rest[0].scale, glm::vec3(2));
}

/// The chain of nodes is 2 - 0 - 1, so that no node has the number of its joint.
TEST(build_skeleton, G50_a_matrix_goes_where_any_animation_moves_its_own_node) {
  for (int moved = 0; moved < 3; ++moved)
    for (const bool second : {false, true}) {
      SCOPED_TRACE(testing::Message() << moved << second);
      TinyGltf file;
      file.root["nodes"] = Json::parse(R"([{"children": [1]}, {}, {"children": [0]}])");
      for (std::size_t n = 0; n < 3; ++n) file.root["nodes"][n]["matrix"] = matrix(0, 2.0f + static_cast<float>(n));
      file.animate("scale", file.times({0, 1}), file.vec3({1, 1, 1, 2, 2, 2}));
      Json& animations = file.root["animations"];
      animations[0]["channels"][0]["target"]["node"] = moved;
      if (second) animations.insert(animations.begin(), animations[0]);
      if (second) animations[0]["channels"][0]["target"].erase("node");
      const auto result = file.import();
      ASSERT_EQ(outcome(result), "ok");
      const Skeleton& s = result->scene.skeleton;
      for (int n = 0; n < 3; ++n) {
        const std::uint32_t joint = s.joint_of_node[static_cast<std::size_t>(n)], fixed = s.fixed_matrix_of[joint];
        ASSERT_EQ(fixed == kNone, n == moved) << n;
        const float scale = n == moved ? s.rest[joint].scale.x : s.fixed_matrices[fixed].row[0].x;
        EXPECT_EQ(scale, 2.0f + static_cast<float>(n));
      }
    }
}

TEST(build_skeleton, G50_T3_of_matrix_and_trs_the_matrix_counts) {
  TinyGltf file;
  file.root["nodes"] = Json::array({{{"matrix", matrix()}, {"translation", {1, 2, 3}}}});
  const auto result = file.import();
  EXPECT_TRUE(warns(result, "node-matrix-trs", "/nodes/0/matrix"));
  EXPECT_EQ(result->scene.skeleton.fixed_matrices[0].row[0].w, 5.0f);
  file.root["nodes"][0] = {{"matrix", matrix(0.5f)}};
  EXPECT_TRUE(warns(file.import(), "node-matrix-row", "/nodes/0/matrix"));
}

TEST(build_skeleton, G52_rotations_become_unit_quaternions) {
  TinyGltf file;
  file.root["nodes"] =
      Json::array({{{"rotation", {0, 0, 3, 4}}}, {{"rotation", {0, 0, 0, 0}}}, {{"rotation", {0.6, 0, 0, 0.8}}}});
  const auto result = file.import();
  EXPECT_TRUE(warns(result, "rotation-length", "/nodes/0/rotation"));
  EXPECT_TRUE(warns(result, "rotation-zero", "/nodes/1/rotation"));
  EXPECT_THAT(result->warnings, SizeIs(2));
  EXPECT_EQ(result->scene.skeleton.rest[0].rotation.z, 0.6f);
  EXPECT_EQ(result->scene.skeleton.rest[1].rotation.w, 1.0f);
  EXPECT_EQ(result->scene.skeleton.rest[2].rotation.x, 0.6f) << "left as it is";
}

TinyGltf with_skin(const std::vector<float>& numbers, std::size_t joints) {
  TinyGltf file;
  file.root["nodes"] = Json::parse(R"([{"children":[1,2]},{},{},{}])");
  std::vector<std::size_t> list;
  for (std::size_t j = 0; j < joints; ++j) list.push_back(joints - j);
  file.root["skins"] = Json::array({{{"joints", list}, {"inverseBindMatrices", file.add(numbers, "MAT4", 5126, 16)}}});
  return file;
}

TEST(build_skins, G31_fewer_matrices_are_an_error_more_are_ignored_none_is_identity) {
  EXPECT_EQ(outcome(with_skin(matrix(), 2).import()), "skin-matrices at /skins/0/inverseBindMatrices");
  const auto one = with_skin(matrix(), 1).import();
  ASSERT_EQ(outcome(one), "ok");
  EXPECT_EQ(one->scene.skins[0].inverse_bind[0].row[2].w, 7.0f);
  std::vector<float> two = matrix();
  two.insert(two.end(), 16, 0.0f);
  const auto more = with_skin(two, 1).import();
  ASSERT_EQ(outcome(more), "ok");
  EXPECT_THAT(more->scene.skins[0].inverse_bind, SizeIs(1));
  TinyGltf none = with_skin(matrix(), 2);
  none.root["skins"][0].erase("inverseBindMatrices");
  const auto identity = none.import();
  EXPECT_THAT(identity->scene.skins[0].inverse_bind, testing::Each(Affine{}));
  EXPECT_THAT(identity->scene.skins[0].joints,
              ElementsAre(identity->scene.skeleton.joint_of_node[2], identity->scene.skeleton.joint_of_node[1]));
}

TEST(build_skins, G31_a_bad_fourth_row_is_taken_as_0_0_0_1) {
  EXPECT_TRUE(warns(with_skin(matrix(0.25f), 1).import(), "skin-matrix-row", "/skins/0/inverseBindMatrices"));
  TinyGltf file = with_skin(matrix(), 1);
  file.root["skins"][0]["inverseBindMatrices"] = file.vec4(std::vector<float>(4));
  EXPECT_EQ(outcome(file.import()), "skin-matrices at /skins/0/inverseBindMatrices");
}

TEST(build_skins, G31_no_number_of_a_matrix_may_be_nan_or_infinite) {
  for (std::size_t bad = 0; bad < 32; ++bad) {
    std::vector<float> two = matrix();
    two.insert(two.end(), two.begin(), two.begin() + 16);
    two[bad] = bad % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : std::numeric_limits<float>::infinity();
    const auto result = with_skin(two, 2).import();
    ASSERT_EQ(outcome(result), "not-finite at /skins/0/inverseBindMatrices") << bad;
    EXPECT_THAT(result.error().issue.detail, testing::StartsWith("matrix " + std::to_string(bad / 16) + " ")) << bad;
  }
}

TEST(build_skins, the_root_that_a_skin_names_is_a_joint_of_the_skeleton) {
  TinyGltf file = with_skin(matrix(), 1);
  const auto without = file.import();
  ASSERT_EQ(outcome(without), "ok");
  EXPECT_EQ(without->scene.skins[0].skeleton_root, kNone);
  for (std::uint32_t node = 0; node < 2; ++node) {
    file.root["skins"][0]["skeleton"] = node;
    const auto result = file.import();
    ASSERT_EQ(outcome(result), "ok");
    EXPECT_EQ(result->scene.skins[0].skeleton_root, result->scene.skeleton.joint_of_node[node]) << node;
  }
}

TEST(build_skins, G31_each_skin_has_a_name_and_matrices_of_its_own) {
  TinyGltf file = with_skin(matrix(0, 2), 1);
  const std::size_t others = file.add(matrix(0, 3), "MAT4", 5126, 16);
  file.root["skins"][0]["name"] = "first";
  file.root["skins"].push_back({{"name", "second"}, {"joints", {2}}, {"inverseBindMatrices", others}});
  file.root["skins"].push_back({{"name", "third"}, {"joints", {1}}});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const auto& skins = result->scene.skins;
  ASSERT_THAT(skins, SizeIs(3));
  const char* names[] = {"first", "second", "third"};
  const float scales[] = {2, 3, 1};
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_EQ(skins[s].name, names[s]);
    EXPECT_EQ(skins[s].inverse_bind.at(0).row[0].x, scales[s]) << s;
  }
}

TEST(build_skins, G32_joints_under_different_roots_are_a_warning) {
  TinyGltf file = with_skin(matrix(), 1);
  file.root["skins"][0] = {{"joints", {1, 3}}};
  EXPECT_TRUE(warns(file.import(), "skin-common-root", "/skins/0/joints/1"));
  file.root["skins"][0] = {{"joints", {1, 2}}};
  EXPECT_THAT(file.import()->warnings, IsEmpty());
}

TEST(build_skeleton, a_matrix_stays_where_only_weights_are_animated) {
  TinyGltf file;
  file.add_triangle()["targets"] = {{{"POSITION", 0}}};
  file.root["nodes"][0]["matrix"] = {1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};  // this matrix shears
  file.animate("weights", file.times({0, 1}), file.scalars({0, 1}));
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  ASSERT_EQ(result->scene.skeleton.fixed_matrix_of.at(0), 0u);
  EXPECT_EQ(result->scene.animations.at(0).weights.size(), 1u);
}

TEST(build_instances, G34_one_mesh_may_have_several_skins_and_a_skin_without_joints_in_the_mesh_is_dropped) {
  TinyGltf file;
  file.add_skinned_triangle({0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {.5f, .5f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  file.root["nodes"].push_back({{"mesh", 0}, {"skin", 1}});
  file.root["skins"].push_back({{"joints", {2, 1}}});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  ASSERT_THAT(result->scene.instances, SizeIs(2));
  EXPECT_EQ(result->scene.instances[0].skin, 0u);
  EXPECT_EQ(result->scene.instances[1].skin, 1u);
  file.root["skins"][1]["joints"] = {2};
  EXPECT_EQ(outcome(file.import()), "joint-index at /meshes/0/primitives/0/attributes/JOINTS_0")
      << "every skin must be large enough";
  TinyGltf plain;
  plain.add_triangle();
  plain.root["nodes"] = Json::array({{{"mesh", 0}, {"skin", 0}}, {{"skin", 0}}});
  plain.root["skins"] = Json::array({{{"joints", {1}}}});
  const auto dropped = plain.import();
  EXPECT_TRUE(warns(dropped, "node-skin-unused", "/nodes/0/skin"));
  EXPECT_TRUE(warns(dropped, "node-skin-without-mesh", "/nodes/1/skin"));
  EXPECT_EQ(dropped->scene.instances[0].skin, kNone);
}

TEST(build_instances, a_mesh_has_a_skin_where_any_of_its_primitives_has_joints) {
  for (const bool skinned_first : {false, true}) {
    TinyGltf file;
    file.add_skinned_triangle(std::vector<std::uint8_t>(12), {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    Json& primitives = file.root["meshes"][0]["primitives"];
    const Json plain{{"attributes", {{"POSITION", primitives[0]["attributes"]["POSITION"]}}}};
    primitives.insert(skinned_first ? primitives.end() : primitives.begin(), plain);
    const auto result = file.import();
    ASSERT_EQ(outcome(result), "ok");
    EXPECT_EQ(result->scene.instances[0].skin, 0u) << skinned_first;
    EXPECT_FALSE(warns(result, "node-skin-unused", "/nodes/0/skin")) << skinned_first;
  }
}

TEST(build_skins, G35_a_joint_may_be_above_its_own_mesh) {
  TinyGltf file;
  file.add_skinned_triangle({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  file.root["nodes"] = Json::parse(R"([{"mesh":0,"skin":0},{"children":[0]},{}])");
  EXPECT_EQ(outcome(file.import()), "ok");
}

TEST(build_placements, cameras_and_lights_hang_on_joints) {
  TinyGltf file;
  file.root["nodes"] = Json::parse(R"([{"camera":0},{"camera":0,"extensions":{"KHR_lights_punctual":{"light":0}}},
                                       {"extensions":{"KHR_lights_punctual":{"light":4}}}])");
  file.root["cameras"] = Json::parse(R"([{"type":"perspective","perspective":{"yfov":0.5,"znear":0.1,"zfar":9}}])");
  file.root["extensions"] = Json::parse(
      R"({"KHR_lights_punctual":{"lights":[{"type":"spot","intensity":3,"spot":{"outerConeAngle":0.4}}]}})");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  ASSERT_THAT(result->scene.cameras, SizeIs(2));
  EXPECT_EQ(result->scene.cameras[1].joint, 1u);
  EXPECT_EQ(result->scene.cameras[0].fov_y_rad, 0.5f);
  ASSERT_THAT(result->scene.lights, SizeIs(1));
  EXPECT_EQ(result->scene.lights[0].kind, Light::Kind::spot);
  EXPECT_EQ(result->scene.lights[0].outer_cone_rad, 0.4f);
  EXPECT_TRUE(warns(result, "light-values", "/nodes/2/extensions/KHR_lights_punctual/light"));
}

}  // namespace
}  // namespace sinew::test
