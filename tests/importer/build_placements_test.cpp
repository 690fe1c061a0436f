// SPDX-License-Identifier: MIT
#include "importer/build/build_placements.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "importer/export_glb.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/support/scene_equality.h"

namespace sinew::test {
namespace {

using Details = std::vector<std::string>;

struct ReadCamera {
  Camera camera;
  Details details;  ///< details of the warnings, which all concern camera 0
};

/// Imports a file with one camera, whose usual properties `change` overrides.
ReadCamera read_camera(const char* type, const Json& change) {
  TinyGltf file;
  Json lens = std::string(type) == "perspective" ? Json{{"yfov", 0.5}, {"znear", 0.25}}
                                                 : Json{{"xmag", 2}, {"ymag", 3}, {"znear", 0.25}, {"zfar", 8}};
  lens.update(change);
  file.root["cameras"] = Json::array({{{"type", type}, {type, lens}}});
  file.root["nodes"] = Json::array({{{"camera", 0}}});
  const auto result = file.import();
  EXPECT_EQ(outcome(result), "ok") << change;
  ReadCamera out{result->scene.cameras.at(0), {}};
  for (const ImportIssue& warning : result->warnings) {
    EXPECT_EQ(warning.rule, "camera-values") << change;
    EXPECT_EQ(warning.json_pointer, "/cameras/0") << change;
    out.details.push_back(warning.detail);
  }
  return out;
}

TEST(build_cameras, right_values_are_read_without_a_word) {
  const auto [wide, said] = read_camera("perspective", {{"aspectRatio", 1.5}, {"zfar", 4}});
  EXPECT_EQ(said, Details{});
  EXPECT_TRUE(wide.perspective);
  EXPECT_EQ(wide.fov_y_rad, 0.5f);
  EXPECT_EQ(wide.aspect, 1.5f);
  EXPECT_EQ(wide.near_m, 0.25f);
  EXPECT_EQ(wide.far_m, 4.0f);
  EXPECT_EQ(read_camera("perspective", Json::object()).camera.far_m, 0.0f) << "infinite";
  const auto [flat, nothing] = read_camera("orthographic", {{"znear", 0}, {"xmag", -2}, {"ymag", -5}});
  EXPECT_EQ(nothing, Details{});
  EXPECT_FALSE(flat.perspective);
  EXPECT_EQ(flat.half_width, 2.0f) << "a negative one mirrors nothing here";
  EXPECT_EQ(flat.half_height, 5.0f);
  EXPECT_EQ(flat.near_m, 0.0f);
  EXPECT_EQ(flat.far_m, 8.0f);
}

TEST(build_cameras, each_number_that_makes_no_picture_is_named_and_replaced) {
  const Camera usual;
  const auto replaced = [](const char* name, float value) {
    return Details{std::string(name) + " is not above 0; " + std::to_string(value) + " is used"};
  };
  for (const double wrong : {0.0, -1.0}) {
    const ReadCamera fov = read_camera("perspective", {{"yfov", wrong}});
    EXPECT_EQ(fov.details, replaced("yfov", usual.fov_y_rad));
    EXPECT_EQ(fov.camera.fov_y_rad, usual.fov_y_rad);
    const ReadCamera near = read_camera("perspective", {{"znear", wrong}});
    EXPECT_EQ(near.details, replaced("znear", usual.near_m));
    EXPECT_EQ(near.camera.near_m, usual.near_m);
    EXPECT_EQ(read_camera("perspective", {{"aspectRatio", wrong}}).camera.aspect, 0.0f) << "that of the window";
  }
  const ReadCamera width = read_camera("orthographic", {{"xmag", 0}}),
                   height = read_camera("orthographic", {{"ymag", 0}});
  EXPECT_EQ(width.details, replaced("xmag", usual.half_width));
  EXPECT_EQ(width.camera.half_width, usual.half_width);
  EXPECT_EQ(height.details, replaced("ymag", usual.half_height));
  EXPECT_EQ(height.camera.half_height, usual.half_height);
}

TEST(build_cameras, a_far_plane_that_is_not_behind_the_near_one_is_none) {
  const Details infinite{"zfar is not above znear; infinite is used"};
  for (const char* type : {"perspective", "orthographic"}) {
    for (const double far : {0.25, 0.125, -1.0}) {
      const ReadCamera read = read_camera(type, {{"zfar", far}});
      EXPECT_EQ(read.details, infinite) << type << far;
      EXPECT_EQ(read.camera.far_m, 0.0f) << type << far;
      EXPECT_EQ(read.camera.near_m, 0.25f) << type << far;
    }
  }
}

/// Nodes in the chain 2 - 0 - 1, so that no node has the number of its joint. Each node has a camera, a light and a
/// mesh, and is the root of a scene. Node 1 is hidden until a clip shows it.
TinyGltf turned_chain() {
  TinyGltf file;
  file.add_triangle();
  Json& root = file.root;
  root["nodes"] = Json::parse(R"([{"children": [1]}, {}, {"children": [0]}])");
  for (int n = 0; n < 3; ++n) {
    const std::string name = std::to_string(n);
    Json& node = root["nodes"][static_cast<std::size_t>(n)];
    node["camera"] = n;
    node["mesh"] = 0;
    node["extensions"]["KHR_lights_punctual"]["light"] = n;
    root["cameras"].push_back({{"name", name}, {"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}});
    root["extensions"]["KHR_lights_punctual"]["lights"].push_back({{"name", name}, {"type", "point"}});
    root["scenes"].push_back({{"nodes", {n}}});
  }
  root["nodes"][1]["extensions"]["KHR_node_visibility"]["visible"] = false;
  const std::size_t shown = file.add(std::vector<std::uint8_t>{0, 1}, "SCALAR", 5121, 1);
  file.animate("pointer", file.times({0, 1}), shown, "STEP");
  const Json pointer{{"pointer", "/nodes/1/extensions/KHR_node_visibility/visible"}};
  root["animations"][0]["channels"][0]["target"]["extensions"]["KHR_animation_pointer"] = pointer;
  return file;
}

TEST(build_placements, what_a_node_carries_hangs_on_its_joint_and_comes_back_from_a_file) {
  const auto result = turned_chain().import();
  ASSERT_EQ(outcome(result), "ok");
  const Scene& scene = result->scene;
  const std::vector<std::uint32_t> joints{1, 2, 0};
  ASSERT_EQ(scene.skeleton.joint_of_node, joints);
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_EQ(scene.cameras.at(n).joint, joints[n]);
    EXPECT_EQ(scene.cameras[n].name, std::to_string(n));
    EXPECT_EQ(scene.lights.at(n).joint, joints[n]);
    EXPECT_EQ(scene.lights[n].name, std::to_string(n));
    EXPECT_EQ(scene.instances.at(n).joint, joints[n]);
    EXPECT_EQ(scene.scenes.at(n).joints, std::vector{joints[n]});
  }
  EXPECT_EQ(scene.hidden_joints, std::vector{joints[1]});
  EXPECT_EQ(scene.animations.at(0).properties.at(0).target.index, joints[1]);
  const auto bytes = export_glb(scene);
  ASSERT_TRUE(bytes);
  const auto again = import_gltf(*bytes, "again.glb");
  ASSERT_EQ(outcome(again), "ok");
  expect_equal(scene, again->scene);
}

}  // namespace
}  // namespace sinew::test
