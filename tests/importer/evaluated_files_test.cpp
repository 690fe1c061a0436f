// SPDX-License-Identifier: MIT
// glTF rules that need several parts of the importer: small files go from bytes to the vertices of a frame.
#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/plan/run_plan.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/support/near.h"

namespace sinew::test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

/// One evaluated frame of an imported file; `clip` kNone = the rest pose.
struct Shown {
  ImportResult<ImportedFile> file;
  Plan plan;
  FrameBuffer frame;
  ErrorCode error = ErrorCode::ok;

  explicit Shown(const TinyGltf& gltf, std::uint32_t clip = kNone, double time_s = 0.0,
                 NormalRule rule = NormalRule::linear)
      : file(gltf.import()), plan(compile_plan(lend(scene()), needs(rule))), frame(plan) {
    const ClipLayer layer{clip, time_s, 1.0f};
    error = run_plan(plan, {clip == kNone ? std::span<const ClipLayer>{} : std::span(&layer, 1), {}, {}}, frame);
    EXPECT_EQ(error, ErrorCode::ok);
  }

  const Scene& scene() const {
    if (!file) throw std::runtime_error(outcome(file));
    return file->scene;
  }
  const Affine& world_of_node(std::uint32_t node) const {
    return frame.result().model[scene().skeleton.joint_of_node[node]];
  }
  const DeformedPrimitive& primitive(std::size_t i = 0) const { return frame.result().primitives[i]; }

 private:
  static Needs needs(NormalRule rule) {
    Needs out;
    out.skin.normal_rule = rule;
    return out;
  }
};

const std::vector<std::uint8_t> kAllOnSlot0{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
const std::vector<float> kFull{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
constexpr double kTight = 1e-6;

TEST(evaluated_file, N26_displacements_and_skin_weights_too_small_to_show_are_dropped_at_import) {
  TinyGltf file;
  Json& primitive = file.add_skinned_triangle({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0},
                                              {1, 1e-38f, 0, 0, 1, 1e-42f, 0, 0, 1, 1e-21f, 0, 0});
  primitive["targets"] = Json::array({{{"POSITION", file.vec3({1e-39f, -1e-21f, 0, 0, 1e-42f, 3, 0, 0, -1e-19f})}}});
  const Shown shown(file);
  const Primitive& imported = shown.scene().meshes[0].primitives[0];
  EXPECT_EQ(imported.influences.joints.size(), 3u) << "one joint a vertex";
  const auto& deltas = imported.morphs.targets[0].positions;
  EXPECT_EQ(deltas.vertices, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(deltas.deltas, (std::vector<glm::vec3>{{0, 0, 3}, {0, 0, -1e-19f}}));
}

TEST(evaluated_file, G18_neighbours_on_other_hemispheres_turn_the_short_way_after_decoding) {
  // 80 and 100 degrees about z as 8-bit integers, with the largest component positive. It is w in the first key and z
  // in the second, so the second is stored as -q.
  TinyGltf file;
  file.root["nodes"] = Json::array({Json::object()});
  const auto byte = [](double v) { return static_cast<std::int8_t>(std::lround(127 * v)); };
  const double a = 40 * M_PI / 180, b = 50 * M_PI / 180;
  const std::size_t output = file.add(std::vector<std::int8_t>{0, 0, byte(-std::sin(a)), byte(std::cos(a)),  //
                                                               0, 0, byte(std::sin(b)), byte(-std::cos(b))},
                                      "VEC4", 5120, 4, true);
  file.animate("rotation", file.times({0, 1}), output);
  for (int i = 0; i <= 16; ++i) {
    const Shown shown(file, 0, i / 16.0);
    const Affine& m = shown.world_of_node(0);
    EXPECT_NEAR(std::hypot(m.row[0].x, m.row[1].x), 1.0, kTight) << "decoded bytes are not unit, the rotation must be";
    const double turned = std::atan2(static_cast<double>(m.row[1].x), static_cast<double>(m.row[0].x)) * 180 / M_PI;
    EXPECT_NEAR(turned, -80.0 - 20.0 * i / 16.0, 0.5) << i;  // half a byte step is 0.45 degrees
  }
}

TEST(evaluated_file, G23_keys_of_any_rate_are_kept_as_they_are) {
  // 24 frames a second, then a cut of a millisecond and a pause of a minute: no common sample rate fits all of them.
  const std::vector<float> times{0.0f, 1 / 24.0f, 2 / 24.0f, 0.5f, 0.501f, 60.5f};
  TinyGltf file;
  file.root["nodes"] = Json::array({Json::object()});
  const std::vector<float> values{0, 0, 0, 0.1f, 3, 0, 0.7f, 3, 0, 0.7f, 3, 1, -5, 3, 1, -5, 4, 1};
  file.animate("translation", file.times(times), file.vec3(values), "STEP");
  const Shown shown(file);
  const Vec3Track& track = shown.scene().animations[0].bones[0].translation;
  EXPECT_EQ(track.times_s, times);
  EXPECT_EQ(track.interpolation, Interpolation::step);
  ASSERT_THAT(track.values, SizeIs(times.size()));
  for (std::size_t k = 0; k < times.size(); ++k) {
    const glm::vec3 value(values[3 * k], values[3 * k + 1], values[3 * k + 2]);
    EXPECT_EQ(track.values[k], value);
    const double t = static_cast<double>(times[k]);
    EXPECT_EQ(translation_of(Shown(file, 0, t).world_of_node(0)), value) << t;
    if (k == 0) continue;
    EXPECT_EQ(translation_of(Shown(file, 0, std::nextafter(t, 0.0)).world_of_node(0)), track.values[k - 1]) << t;
  }
}

TEST(evaluated_file, G30_skin_skeleton_changes_no_bit) {
  TinyGltf file;
  file.add_skinned_triangle({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, {.5f, .5f, 0, 0, .25f, .75f, 0, 0, .5f, .5f, 0, 0});
  file.root["nodes"] = Json::parse(
      R"([{"mesh":0,"skin":0},{"children":[2],"translation":[3,0,0]},{"rotation":[0,0,0.6,0.8]},{"children":[1],"scale":[2,2,2]}])");
  const Shown without(file);
  for (const int skeleton : {1, 2, 3, 0}) {
    file.root["skins"][0]["skeleton"] = skeleton;  // a joint, the child joint, a common root, and an unrelated node
    const Shown with(file);
    EXPECT_TRUE(std::ranges::equal(with.primitive().positions, without.primitive().positions)) << skeleton;
  }
}

TEST(evaluated_file, G32_joints_outside_the_scene_are_evaluated_with_all_their_ancestors) {
  TinyGltf file;
  file.add_skinned_triangle(kAllOnSlot0, kFull);
  file.root["nodes"] = Json::parse(R"([{"mesh":0,"skin":0},{},{"children":[1],"translation":[0,7,0]}])");
  file.root["skins"][0]["joints"] = {1};
  file.root["scenes"] = Json::parse(R"([{"nodes":[0]}])");
  file.root["scene"] = 0;
  file.animate("translation", file.times({0, 1}), file.vec3({0, 0, 0, 4, 0, 0}));
  file.root["animations"][0]["channels"][0]["target"]["node"] = 2;  // above the joint
  EXPECT_TRUE(is_near(Shown(file).primitive().positions[1], glm::vec3(1, 7, 0), kTight));
  EXPECT_TRUE(is_near(Shown(file, 0, 0.5).primitive().positions[1], glm::vec3(3, 0, 0), kTight));
}

TEST(evaluated_file, G33_nodes_between_joints_count_and_joints_may_come_leaf_first) {
  TinyGltf file;
  file.add_skinned_triangle({0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0}, kFull);
  // Joint 4 <- plain node 3 <- joint 2 <- plain node 1, and joint 5 has a root of its own.
  file.root["nodes"] = Json::parse(
      R"([{"mesh":0,"skin":0},{"children":[2],"translation":[1,0,0]},{"children":[3],"translation":[0,1,0]},
          {"children":[4],"scale":[3,3,3]},{"translation":[0,0,1]},{"translation":[0,0,-5]}])");
  file.root["skins"][0]["joints"] = {4, 5, 2};
  const Shown shown(file);
  EXPECT_TRUE(is_near(shown.primitive().positions[0], glm::vec3(1, 1, 3), kTight));
  EXPECT_TRUE(is_near(shown.primitive().positions[1], glm::vec3(1, 0, -5), kTight));
  EXPECT_TRUE(is_near(shown.primitive().positions[2], glm::vec3(1, 2, 0), kTight));
}

TEST(evaluated_file, G34_one_mesh_with_two_skins_over_the_same_joints_has_two_palettes) {
  TinyGltf file;
  file.add_skinned_triangle(kAllOnSlot0, kFull);
  const std::size_t other = file.add(std::vector<float>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 9, 1,
                                                        1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                                     "MAT4", 5126, 16);
  file.root["nodes"] = Json::parse(
      R"([{"mesh":0,"skin":0},{"children":[2],"translation":[2,0,0]},{},{"mesh":0,"skin":1},{"mesh":0,"skin":2}])");
  file.root["skins"] = Json::array({{{"joints", {1, 2}}},
                                    {{"joints", {1, 2}}, {"inverseBindMatrices", other}},
                                    {{"joints", {2, 1}}, {"inverseBindMatrices", other}}});
  file.animate("translation", file.times({0, 1}), file.vec3({0, 1, 0, 0, 1, 0}));
  file.root["animations"][0]["channels"][0]["target"]["node"] = 2;
  const Shown shown(file, 0, 0.5);
  ASSERT_THAT(shown.frame.result().primitives, SizeIs(3));
  EXPECT_TRUE(is_near(shown.primitive(0).positions[0], glm::vec3(2, 0, 0), kTight));
  EXPECT_TRUE(is_near(shown.primitive(1).positions[0], glm::vec3(2, 0, 9), kTight));
  EXPECT_TRUE(is_near(shown.primitive(2).positions[0], glm::vec3(2, 1, 9), kTight));
}

TEST(evaluated_file, G37_joint_values_of_8_and_16_bits_mean_the_same_beyond_256_joints_too) {
  const auto file_with = [](bool wide, std::uint16_t joint) {
    TinyGltf file;
    Json& primitive = file.add_skinned_triangle(kAllOnSlot0, kFull);
    std::vector<std::uint16_t> joints(12, 0);
    for (std::size_t v = 0; v < 3; ++v) joints[4 * v] = joint;
    if (wide)
      primitive["attributes"]["JOINTS_0"] = file.add(joints, "VEC4", 5123, 4);
    else
      primitive["attributes"]["JOINTS_0"] =
          file.add(std::vector<std::uint8_t>(joints.begin(), joints.end()), "VEC4", 5121, 4);
    file.root["nodes"] = Json::array({{{"mesh", 0}, {"skin", 0}}});
    file.root["skins"] = Json::array({{{"joints", Json::array()}}});
    for (int j = 0; j < 600; ++j) {
      file.root["nodes"].push_back({{"translation", {j, 0, 0}}});
      file.root["skins"][0]["joints"].push_back(j + 1);
    }
    return file;
  };
  for (const std::uint16_t joint : std::initializer_list<std::uint16_t>{0, 1, 127, 128, 255}) {
    EXPECT_EQ(Shown(file_with(false, joint)).primitive().positions[0].x, static_cast<float>(joint));
    EXPECT_EQ(Shown(file_with(true, joint)).primitive().positions[0].x, static_cast<float>(joint));
  }
  for (const std::uint16_t joint : std::initializer_list<std::uint16_t>{256, 257, 511, 599})
    EXPECT_EQ(Shown(file_with(true, joint)).primitive().positions[0].x, static_cast<float>(joint));
}

TEST(evaluated_file, G40_a_vertex_with_six_influences_in_two_sets_uses_all_of_them) {
  TinyGltf file;
  Json& primitive =
      file.add_skinned_triangle({0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3},
                                {.25f, .25f, .125f, .125f, .25f, .25f, .125f, .125f, .25f, .25f, .125f, .125f});
  primitive["attributes"]["JOINTS_1"] =
      file.add(std::vector<std::uint8_t>{4, 5, 0, 0, 4, 5, 0, 0, 4, 5, 0, 0}, "VEC4", 5121, 4);
  primitive["attributes"]["WEIGHTS_1"] = file.vec4({.125f, .125f, 0, 0, .125f, .125f, 0, 0, .125f, .125f, 0, 0});
  file.root["nodes"] = Json::array({{{"mesh", 0}, {"skin", 0}}});
  file.root["skins"][0]["joints"] = Json::array();
  for (int j = 0; j < 6; ++j) {
    file.root["nodes"].push_back({{"translation", {0, 0, 1 << j}}});
    file.root["skins"][0]["joints"].push_back(j + 1);
  }
  EXPECT_EQ(Shown(file).primitive().positions[0].z, .25f * 1 + .25f * 2 + .125f * (4 + 8 + 16 + 32));
}

TEST(evaluated_file, G42_displacements_are_turned_with_the_joint) {
  TinyGltf file;
  Json& primitive = file.add_skinned_triangle(kAllOnSlot0, kFull);
  primitive["targets"] = Json::array({{{"POSITION", file.vec3({0, 2, 0, 0, 2, 0, 0, 2, 0})}}});
  file.root["meshes"][0]["weights"] = {0.5};
  file.root["nodes"][1]["rotation"] = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};  // 90 degrees about z: +y becomes -x
  file.root["nodes"][1]["scale"] = {3, 3, 3};
  EXPECT_TRUE(is_near(Shown(file).primitive().positions[0], glm::vec3(-3, 0, 0), kTight))
      << "0.5 * 2 upwards, turned and scaled";
}

TEST(evaluated_file, G44_hundreds_of_targets_all_count) {
  constexpr int kTargets = 300;
  TinyGltf file;
  Json& primitive = file.add_triangle();
  Json weights = Json::array();
  double expected = 0;
  for (int i = 0; i < kTargets; ++i) {
    const float dx = static_cast<float>(i + 1) / 64;  // exactly representable, and so are the products below
    const float w = static_cast<float>(i % 5 - 2) / 4;
    primitive["targets"].push_back({{"POSITION", file.vec3({dx, 0, 0, 0, dx, 0, 0, 0, dx})}});
    weights.push_back(w);
    expected += static_cast<double>(w) * static_cast<double>(dx);
  }
  file.root["nodes"][0]["weights"] = weights;
  const Shown shown(file);
  EXPECT_THAT(shown.file->warnings, IsEmpty());
  EXPECT_THAT(shown.frame.result().weights, SizeIs(kTargets));
  EXPECT_NEAR(static_cast<double>(shown.primitive().positions[0].x), expected, 1e-5);
  EXPECT_NEAR(static_cast<double>(shown.primitive().positions[2].z), expected, 1e-5);
}

TEST(evaluated_file, G51_joints_may_shrink_to_nothing_and_come_back) {
  TinyGltf file;
  Json& primitive =
      file.add_skinned_triangle({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, {.5f, .5f, 0, 0, .5f, .5f, 0, 0, .5f, .5f, 0, 0});
  primitive["attributes"]["NORMAL"] = file.vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
  primitive["attributes"]["TANGENT"] = file.vec4({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
  file.animate("scale", file.times({0, 1, 2, 3, 4}), file.vec3({1, 1, 1, 0, 0, 0, 1, 0, 1, 0, 0, 2, 1, 1, 1}));
  file.root["animations"][0]["channels"][0]["target"]["node"] =
      1;  // joint 1 is the parent of the other joint, so the whole skin collapses
  for (const NormalRule rule : {NormalRule::linear, NormalRule::cofactor})
    for (const double t : {0.0, 0.999999, 1.0, 1.000001, 1.5, 2.0, 2.5, 3.0, 4.0}) {
      const Shown shown(file, 0, t, rule);
      for (std::size_t v = 0; v < 3; ++v) {
        EXPECT_TRUE(glm::all(glm::lessThanEqual(glm::abs(shown.primitive().positions[v]), glm::vec3(2)))) << t;
        EXPECT_NEAR(safe_length(shown.primitive().normals[v]), 1.0f, 1e-6f) << t;
        EXPECT_NEAR(safe_length(glm::vec3(shown.primitive().tangents[v])), 1.0f, 1e-6f) << t;
      }
    }
  EXPECT_EQ(Shown(file, 0, 1.0).primitive().positions[1], glm::vec3(0));
  EXPECT_EQ(Shown(file, 0, 4.0).primitive().positions[1], glm::vec3(1, 0, 0));
}

TEST(evaluated_file, G11_a_clip_whose_first_key_is_late_starts_at_zero_and_lasts_until_the_last_key_of_all) {
  TinyGltf file;
  file.root["nodes"] = Json::array({Json::object(), Json::object()});
  file.animate("translation", file.times({3, 7}), file.vec3({1, 0, 0, 5, 0, 0}));
  Json& animation = file.root["animations"][0];
  animation["samplers"].push_back({{"input", file.times({1, 5})}, {"output", file.vec3({0, 2, 0, 0, 4, 0})}});
  animation["channels"].push_back({{"sampler", 1}, {"target", {{"node", 1}, {"path", "translation"}}}});
  EXPECT_EQ(Shown(file).scene().clips[0].duration_s(), 7.0);
  for (const double t : {0.0, 0.5, 3.0, 5.0, 7.0}) {
    const Shown shown(file, 0, t);
    const auto x = static_cast<float>(std::max(t, 3.0) - 2.0);
    const auto y = static_cast<float>(2.0 + std::clamp(t - 1.0, 0.0, 4.0) / 2.0);
    EXPECT_EQ(translation_of(shown.world_of_node(0)), glm::vec3(x, 0, 0)) << t;
    EXPECT_EQ(translation_of(shown.world_of_node(1)), glm::vec3(0, y, 0)) << t;
  }
}

TEST(evaluated_file, G29_neither_the_node_of_a_skinned_mesh_nor_its_parents_move_it) {
  TinyGltf file;
  file.add_skinned_triangle(kAllOnSlot0, kFull);
  for (const char* node : {R"({"mesh":0,"skin":0})", R"({"mesh":0,"skin":0,"translation":[50,1,2]})",
                           R"({"mesh":0,"skin":0,"scale":[0,0,0]})", R"({"mesh":0,"skin":0,"scale":[-1,1,1]})"}) {
    file.root["nodes"] =
        Json::array({Json::parse(node), Json::parse(R"({"translation":[0,7,0]})"), Json::object(),
                     Json::parse(R"({"children":[0],"rotation":[0,0,0.6,0.8],"translation":[9,9,9]})")});
    const Shown shown(file);
    EXPECT_TRUE(is_near(shown.primitive().positions[1], glm::vec3(1, 7, 0), kTight)) << node;
    EXPECT_TRUE(is_near(shown.primitive().positions[2], glm::vec3(0, 8, 0), kTight)) << node;
  }
}

TEST(evaluated_file, G31_without_inverse_bind_matrices_vertices_are_those_of_the_joint) {
  TinyGltf file;
  file.add_skinned_triangle({1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}, kFull);
  file.root["nodes"] = Json::parse(R"([{"mesh":0,"skin":0},{"children":[2],"translation":[0,0,3]},{"scale":[2,2,2]}])");
  const Shown shown(file);
  EXPECT_TRUE(is_near(shown.primitive().positions[0], glm::vec3(0, 0, 3), kTight));
  EXPECT_TRUE(is_near(shown.primitive().positions[1], glm::vec3(1, 0, 3), kTight));
  EXPECT_TRUE(is_near(shown.primitive().positions[2], glm::vec3(0, 2, 3), kTight));
}

TEST(evaluated_file, G35_a_joint_above_its_own_mesh_moves_the_vertices_once) {
  TinyGltf file;
  file.add_skinned_triangle(kAllOnSlot0, kFull);
  file.root["nodes"] = Json::parse(R"([{"mesh":0,"skin":0},{"children":[0],"translation":[0,7,0]},{}])");
  EXPECT_TRUE(is_near(Shown(file).primitive().positions[1], glm::vec3(1, 7, 0), kTight));
}

TEST(evaluated_file, G53_channels_find_their_nodes_by_index_whatever_the_names_are) {
  for (const char* nodes : {R"([{"name":"arm"},{"name":"arm"},{"name":"arm"}])", R"([{},{},{}])",
                            R"([{"name":"2"},{"name":"0"},{"name":"1"}])"}) {
    TinyGltf file;
    file.root["nodes"] = Json::parse(nodes);
    file.animate("translation", file.times({0, 1}), file.vec3({1, 0, 0, 5, 0, 0}));
    file.root["animations"][0]["channels"][0]["target"]["node"] = 1;
    const Shown shown(file, 0, 1.0);
    EXPECT_EQ(translation_of(shown.world_of_node(0)), glm::vec3(0)) << nodes;
    EXPECT_EQ(translation_of(shown.world_of_node(1)), glm::vec3(5, 0, 0)) << nodes;
    EXPECT_EQ(translation_of(shown.world_of_node(2)), glm::vec3(0)) << nodes;
  }
}

/// A skinned triangle whose positions are 16-bit fractions of 100 m. The bind matrices of its two joints, which move
/// together, undo that scale.
TinyGltf quantised_triangle() {
  TinyGltf file;
  Json& primitive =
      file.add_skinned_triangle({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, {.5f, .5f, 0, 0, .5f, .5f, 0, 0, .5f, .5f, 0, 0});
  primitive["attributes"]["POSITION"] =
      file.add(std::vector<std::int16_t>{32767, 0, 0, 0, 0, -32767, 0, 0, 0, 16384, 0, 0}, "VEC3", 5122, 4, true);
  Json& view = file.root["bufferViews"].back();
  view["byteStride"] = 8;
  file.root["accessors"].back()["count"] = 3;
  primitive["targets"] =
      Json::array({{{"POSITION", file.add(std::vector<std::int8_t>{0, 127, 0, 0, 0, 0, 0, 0, 0, 0, -127, 0}, "VEC3",
                                          5120, 4, true)}}});
  file.root["bufferViews"].back()["byteStride"] = 4;
  file.root["accessors"].back()["count"] = 3;
  file.root["meshes"][0]["weights"] = {0.5};
  file.root["skins"][0]["inverseBindMatrices"] =
      file.add(std::vector<float>{100, 0, 0, 0, 0, 100, 0, 0, 0, 0, 100, 0, 0, 0, 0, 1,
                                  100, 0, 0, 0, 0, 100, 0, 0, 0, 0, 100, 0, 0, 0, 0, 1},
               "MAT4", 5126, 16);
  file.root["nodes"] =
      Json::parse(R"([{"mesh":0,"skin":0},{"children":[2],"rotation":[0,0,0.70710678,0.70710678]},{}])");
  file.root["extensionsUsed"] = file.root["extensionsRequired"] = {"KHR_mesh_quantization"};
  return file;
}

TEST(evaluated_file,
     G59_quantised_positions_and_displacements_are_scaled_by_the_bind_matrix_in_every_kind_of_skinning) {
  auto file = quantised_triangle().import();
  ASSERT_EQ(outcome(file), "ok");
  file->scene.meshes[0].primitives[0].centers_of_rotation = {{0.5f, 0, 0}, {0, 0.2f, 0.1f}, {0, 0, 0.25f}};
  for (const Skinning skinning : {Skinning::linear, Skinning::dual_quaternion, Skinning::center_of_rotation}) {
    SCOPED_TRACE(static_cast<int>(skinning));
    Needs needs;
    needs.skin.kind = skinning;
    needs.out.bounds = true;
    const Plan plan = compile_plan(lend(file->scene), needs);
    FrameBuffer frame(plan);
    ASSERT_EQ(run_plan(plan, {}, frame), ErrorCode::ok);
    EXPECT_EQ(frame.result().work.vertices_skinned_center_of_rotation,
              skinning == Skinning::center_of_rotation ? 3u : 0u);
    const auto positions = frame.result().primitives[0].positions;
    const double half = 100.0 * 16384.0 / 32767.0;
    EXPECT_TRUE(is_near(Vec3<double>(positions[0]), Vec3<double>(-50, 100, 0), 1e-4));
    EXPECT_TRUE(is_near(Vec3<double>(positions[1]), Vec3<double>(100, 0, 0), 1e-4));
    EXPECT_TRUE(is_near(Vec3<double>(positions[2]), Vec3<double>(-half, 0, -50), 1e-4));
    const Aabb box = frame.result().instances[0].bounds;
    EXPECT_TRUE(is_near(Vec3<double>(box.lower), Vec3<double>(-half, 0, -50), 1e-4));
    EXPECT_TRUE(is_near(Vec3<double>(box.upper), Vec3<double>(100, 100, 0), 1e-4));
  }
}

TEST(evaluated_file, G59_quantised_positions_of_an_unskinned_mesh_are_scaled_by_its_node_in_vertices_and_box) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["attributes"]["POSITION"] =
      file.add(std::vector<std::int16_t>{32767, 0, 0, 0, 0, -32767, 0, 0, 0, 0, 16384, 0}, "VEC3", 5122, 4, true);
  file.root["bufferViews"].back()["byteStride"] = 8;
  file.root["accessors"].back()["count"] = 3;
  file.root["nodes"] = Json::parse(
      R"([{"mesh":0,"scale":[100,100,50],"translation":[1000,0,0],"rotation":[0,0,0.70710678,0.70710678]}])");
  file.root["extensionsUsed"] = file.root["extensionsRequired"] = {"KHR_mesh_quantization"};
  const auto read = file.import();
  ASSERT_EQ(outcome(read), "ok");
  Needs needs;
  needs.out.bounds = true;
  const Plan plan = compile_plan(lend(read->scene), needs);
  FrameBuffer frame(plan);
  ASSERT_EQ(run_plan(plan, {}, frame), ErrorCode::ok);
  const double half = 50.0 * 16384.0 / 32767.0;
  const Vec3<double> expected[] = {{1000, 100, 0}, {1100, 0, 0}, {1000, 0, half}};
  const InstanceResult& instance = frame.result().instances[0];
  const auto& stored = read->scene.meshes[0].primitives[0].positions;
  for (std::size_t v = 0; v < 3; ++v)
    EXPECT_TRUE(is_near(Vec3<double>(transform_point(instance.world_from_mesh, stored[v])), expected[v], 1e-4)) << v;
  EXPECT_TRUE(is_near(Vec3<double>(instance.bounds.lower), Vec3<double>(1000, 0, 0), 1e-4));
  EXPECT_TRUE(is_near(Vec3<double>(instance.bounds.upper), Vec3<double>(1100, 100, half), 1e-4));
}

TEST(evaluated_file, N23_weights_that_sum_to_less_than_one_do_not_pull_a_vertex_towards_the_origin) {
  TinyGltf file;
  Json& primitive = file.add_skinned_triangle({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, kFull);
  primitive["attributes"]["POSITION"] = file.vec3({24, 0, 0, 0, 24, 0, 0, 0, 24});
  primitive["attributes"]["WEIGHTS_0"] =
      file.add(std::vector<std::uint8_t>{127, 127, 0, 0, 200, 54, 0, 0, 85, 85, 0, 0}, "VEC4", 5121, 4, true);
  const Shown shown(file);
  EXPECT_TRUE(warns(shown.file, "weights-sum", "/meshes/0/primitives/0/attributes"));
  EXPECT_TRUE(is_near(shown.primitive().positions[0], glm::vec3(24, 0, 0), 4e-6)) << "2 of 255 are 19 cm here";
  EXPECT_TRUE(is_near(shown.primitive().positions[1], glm::vec3(0, 24, 0), 4e-6));
  EXPECT_TRUE(is_near(shown.primitive().positions[2], glm::vec3(0, 0, 24), 4e-6));
}

}  // namespace
}  // namespace sinew::test
