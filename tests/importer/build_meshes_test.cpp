// SPDX-License-Identifier: MIT
#include "importer/build/build_meshes.h"
#include "importer/build/group_vertices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "importer/read/primitive_indices.h"
#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {

using gltf::PrimitiveMode;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* kAttributes = "/meshes/0/primitives/0/attributes";

const Primitive& only(const ImportResult<ImportedFile>& result) { return result->scene.meshes.at(0).primitives.at(0); }

TEST(primitive_indices, strips_fans_and_loops_become_lists) {
  const std::vector<std::uint32_t> five{0, 1, 2, 3, 4};
  EXPECT_THAT(unroll(PrimitiveMode::triangle_strip, five), ElementsAre(0, 1, 2, 1, 3, 2, 2, 3, 4));
  EXPECT_THAT(unroll(PrimitiveMode::triangle_fan, five), ElementsAre(1, 2, 0, 2, 3, 0, 3, 4, 0));
  EXPECT_THAT(unroll(PrimitiveMode::line_strip, {0, 1, 2}), ElementsAre(0, 1, 1, 2));
  EXPECT_THAT(unroll(PrimitiveMode::line_loop, {0, 1, 2}), ElementsAre(0, 1, 1, 2, 2, 0));
  EXPECT_THAT(unroll(PrimitiveMode::triangles, five), ElementsAre(0, 1, 2));
  EXPECT_THAT(unroll(PrimitiveMode::lines, five), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(unroll(PrimitiveMode::points, five), SizeIs(5));
  EXPECT_THAT(unroll(PrimitiveMode::triangle_strip, {0, 1}), IsEmpty());
  EXPECT_THAT(unroll(PrimitiveMode::line_loop, {0}), IsEmpty());
  EXPECT_THAT(unroll(PrimitiveMode::triangle_fan, {}), IsEmpty());
}

TEST(build_meshes, a_triangle_without_indices_has_them_made_and_gets_flat_normals) {
  TinyGltf file;
  file.add_triangle();
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_THAT(only(result).indices, ElementsAre(0, 1, 2));
  EXPECT_THAT(only(result).normals, testing::Each(glm::vec3(0, 0, 1)));
  EXPECT_TRUE(only(result).flat_normals);
  EXPECT_EQ(only(result).bounds.upper, glm::vec3(1, 1, 0));
  ImportOptions options;
  options.make_normals = false;
  EXPECT_THAT(only(file.import(options)).normals, IsEmpty());
}

TEST(build_meshes, G36_the_smallest_skin_of_a_mesh_limits_its_joints_wherever_it_stands) {
  for (const bool smaller_first : {false, true}) {
    TinyGltf file;
    file.add_skinned_triangle({0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    EXPECT_EQ(outcome(file.import()), "ok");
    file.root["skins"].push_back({{"joints", {1}}});
    file.root["nodes"].push_back({{"mesh", 0}, {"skin", smaller_first ? 0 : 1}});
    if (smaller_first) file.root["nodes"][0]["skin"] = 1;
    EXPECT_EQ(outcome(file.import()), "joint-index at /meshes/0/primitives/0/attributes/JOINTS_0") << smaller_first;
  }
}

TEST(build_meshes, G36_indices_and_joints_past_the_end_are_errors) {
  TinyGltf file;
  file.add_triangle()["indices"] = file.add(std::vector<std::uint16_t>{0, 1, 3}, "SCALAR", 5123, 1);
  EXPECT_EQ(outcome(file.import()), "mesh-index at /meshes/0/primitives/0/indices");
  TinyGltf skinned;
  skinned.add_skinned_triangle({0, 1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {.5f, .4f, .1f, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  EXPECT_EQ(outcome(skinned.import()), std::string("joint-index at ") + kAttributes + "/JOINTS_0");
  TinyGltf unused;
  unused.add_skinned_triangle({0, 1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {.5f, .5f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  EXPECT_TRUE(warns(unused.import(), "joint-index-unused", kAttributes));
}

TEST(build_meshes, vertices_are_grouped_by_influence_count_with_the_way_back) {
  TinyGltf file;
  Json& primitive =
      file.add_skinned_triangle({0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, {.25f, .75f, 0, 0, 1, 0, 0, 0, .5f, .5f, 0, 0});
  primitive["targets"] = Json::array({{{"POSITION", file.vec3({0, 0, 5, 0, 0, 0, 0, 0, 7})}}});
  ImportOptions options;
  options.make_normals = false;
  const auto result = file.import(options);
  ASSERT_EQ(outcome(result), "ok");
  const Primitive& p = only(result);
  ASSERT_THAT(p.influences.groups, SizeIs(2));
  EXPECT_EQ(p.influences.groups[0].influence_count, 1u);
  EXPECT_EQ(p.influences.groups[1].first_vertex, 1u);
  EXPECT_EQ(p.influences.groups[1].vertex_count, 2u);
  EXPECT_EQ(p.influences.groups[1].first_influence, 1u);
  EXPECT_THAT(p.source_vertex, ElementsAre(1, 0, 2));
  EXPECT_THAT(p.indices, ElementsAre(1, 0, 2));
  EXPECT_EQ(p.positions[0], glm::vec3(1, 0, 0));
  EXPECT_THAT(p.influences.joints, ElementsAre(1, 1, 0, 0, 1)) << "falling weight, then rising joint";
  EXPECT_THAT(p.influences.weights, ElementsAre(1.0f, .75f, .25f, .5f, .5f));
  EXPECT_THAT(p.morphs.targets[0].positions.vertices, ElementsAre(1, 2))
      << "follow their vertices, zero deltas are gone";
  EXPECT_EQ(p.morphs.targets[0].positions.deltas[1], glm::vec3(0, 0, 7));
}

/// A triangle list whose vertices have these joints and weights.
Primitive grouped(std::vector<std::vector<std::pair<std::uint16_t, float>>> influences) {
  MergedInfluences merged;
  for (const auto& of_vertex : influences) {
    merged.first.push_back(static_cast<std::uint32_t>(merged.joints.size()));
    for (const auto& [joint, weight] : of_vertex) {
      merged.joints.push_back(joint);
      merged.weights.push_back(weight);
    }
  }
  merged.first.push_back(static_cast<std::uint32_t>(merged.joints.size()));
  Primitive primitive;
  primitive.positions.resize(influences.size());
  group_vertices(primitive, std::move(merged));
  return primitive;
}

TEST(build_meshes, vertices_of_the_same_joints_and_then_of_the_same_weights_come_together) {
  const Primitive p = grouped({{{3, 1.0f}},
                               {{1, .75f}, {2, .25f}},
                               {{0, 1.0f}},
                               {{2, .75f}, {1, .25f}},
                               {{3, 1.0f}},
                               {{1, .5f}, {2, .5f}},
                               {{0, 1.0f}},
                               {{1, .75f}, {2, .25f}},
                               {{3, 1.0f}}});
  EXPECT_THAT(p.source_vertex, ElementsAre(0, 4, 8, 2, 6, 1, 7, 5, 3));
  EXPECT_THAT(p.influences.joints, ElementsAre(3, 3, 3, 0, 0, 1, 2, 1, 2, 1, 2, 2, 1));
  EXPECT_THAT(p.influences.weights, ElementsAre(1, 1, 1, 1, 1, .75f, .25f, .75f, .25f, .5f, .5f, .75f, .25f));
  ASSERT_THAT(p.influences.groups, SizeIs(2));
  EXPECT_EQ(p.influences.groups[1].first_vertex, 5u);
}

/// Vertices of four joint pairs, interleaved: 3 of joints (0, 1), 5 of (1, 0), 13 of (1, 2), 39 of (2, 3), each with
/// its own weights.
std::vector<std::vector<std::pair<std::uint16_t, float>>> runs_in_turns() {
  std::vector<std::vector<std::pair<std::uint16_t, float>>> influences;
  const auto add = [&](std::uint16_t a, std::uint16_t b, float w) { influences.push_back({{a, 1 - w}, {b, w}}); };
  for (int v = 0; v < 39; ++v) {
    const float w = 0.01f * static_cast<float>(v + 1);
    if (v < 3) add(0, 1, w);
    if (v < 5) add(1, 0, w);
    if (v < 13) add(1, 2, w);
    add(2, 3, w);
  }
  return influences;
}

TEST(build_meshes, whole_vectors_of_vertices_of_the_same_joints_begin_where_vectors_do) {
  const Primitive p = grouped(runs_in_turns());
  std::vector<std::pair<std::uint16_t, int>> runs;  // (the heavier joint, length of the run)
  for (std::size_t v = 0; v < p.vertex_count(); ++v) {
    const std::uint16_t joint = p.influences.joints[2 * v];
    if (runs.empty() || runs.back().first != joint || p.influences.joints[2 * v + 1] != p.influences.joints[2 * v - 1])
      runs.emplace_back(joint, 0);
    ++runs.back().second;
  }
  using Runs = std::vector<std::pair<std::uint16_t, int>>;
  // Runs of vector lengths come first, then the remainders: 32 | 8 | 4 4 4 | 3 1 1 3
  EXPECT_EQ(runs, (Runs{{2, 32}, {1, 8}, {2, 4}, {1, 4}, {1, 4}, {2, 3}, {1, 1}, {1, 1}, {0, 3}}));
  std::vector<std::uint32_t> of_long_run;
  for (std::size_t v = 0; v < 32; ++v) of_long_run.push_back(p.source_vertex[v]);
  EXPECT_TRUE(std::is_sorted(of_long_run.begin(), of_long_run.end()));
}

TEST(build_meshes, vertices_in_the_order_of_groups_keep_it) {
  const auto influences = runs_in_turns();
  const Primitive once = grouped(influences);
  std::vector<std::vector<std::pair<std::uint16_t, float>>> ordered;
  for (const std::uint32_t v : once.source_vertex) ordered.push_back(influences[v]);
  EXPECT_TRUE(grouped(ordered).source_vertex.empty());
}

TEST(build_meshes, vertices_that_are_together_already_keep_the_order_of_the_file) {
  const Primitive p = grouped({{{3, 1.0f}}, {{3, 1.0f}}, {{0, 1.0f}}, {{1, .5f}, {2, .5f}}, {{1, .25f}, {2, .75f}}});
  EXPECT_TRUE(p.source_vertex.empty());
}

TEST(build_meshes, influences_that_differ_are_never_taken_for_the_same) {
  std::vector<std::vector<std::pair<std::uint16_t, float>>> influences;
  for (std::uint16_t v = 0; v < 300; ++v) influences.push_back({{v, .5f}, {static_cast<std::uint16_t>(v + 1), .5f}});
  influences.push_back(influences[0]);
  const Primitive p = grouped(influences);
  EXPECT_EQ(p.source_vertex[1], 300u);
  for (std::uint32_t v = 2; v < 301; ++v) EXPECT_EQ(p.source_vertex[v], v - 1);
}

TEST(build_meshes, every_attribute_follows_its_vertex_into_the_groups) {
  TinyGltf file;
  Json& attributes = file.add_skinned_triangle({0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0},
                                               {.5f, .5f, 0, 0, 1, 0, 0, 0, .5f, .5f, 0, 0})["attributes"];
  attributes["NORMAL"] = file.vec3({1, 0, 0, 0, 1, 0, 0, 0, 1});
  attributes["TANGENT"] = file.vec4({0, 1, 0, 1, 0, 0, 1, -1, 1, 0, 0, 1});
  attributes["TEXCOORD_0"] = file.add(std::vector<float>{0, 0.5f, 1, 1.5f, 2, 2.5f}, "VEC2", 5126, 2);
  attributes["COLOR_0"] = file.vec4({1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const Primitive& p = only(result);
  ASSERT_THAT(p.source_vertex, ElementsAre(1, 0, 2)) << "the vertex of one influence comes first";
  EXPECT_THAT(p.normals, ElementsAre(glm::vec3(0, 1, 0), glm::vec3(1, 0, 0), glm::vec3(0, 0, 1)));
  EXPECT_THAT(p.tangents, ElementsAre(glm::vec4(0, 0, 1, -1), glm::vec4(0, 1, 0, 1), glm::vec4(1, 0, 0, 1)));
  EXPECT_THAT(p.texcoords[0], ElementsAre(glm::vec2(1, 1.5f), glm::vec2(0, 0.5f), glm::vec2(2, 2.5f)));
  EXPECT_THAT(p.colors, ElementsAre(glm::vec4(0, 1, 0, 1), glm::vec4(1, 0, 0, 1), glm::vec4(0, 0, 1, 1)));
}

TEST(build_meshes, tangents_without_normals_are_not_those_of_the_file) {
  TinyGltf file;
  Json& attributes = file.add_triangle()["attributes"];
  attributes["TANGENT"] = file.vec4({0, 1, 0, 1, 0, 0, 1, -1, 1, 0, 0, 1});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_TRUE(warns(result, "mesh-tangent-without-normal", std::string(kAttributes) + "/TANGENT"));
  EXPECT_THAT(only(result).tangents, IsEmpty());
}

TEST(build_meshes, P13_tangents_are_made_only_for_a_normal_map_that_has_its_coordinates) {
  const auto tangents = [](const char* material, bool allowed = true) {
    TinyGltf file;
    Json& primitive = file.add_triangle();
    primitive["attributes"]["NORMAL"] = file.vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
    primitive["attributes"]["TEXCOORD_0"] = file.add(std::vector<float>{0, 0, 1, 0, 0, 1}, "VEC2", 5126, 2);
    file.root["images"] = Json::parse(R"([{"uri":"data:image/png;base64,AAAA"}])");
    file.root["textures"] = Json::parse(R"([{"source":0}])");
    if (material != nullptr) {
      primitive["material"] = 0;
      file.root["materials"] = Json::array({Json::parse(material)});
    }
    ImportOptions options;
    options.make_tangents = allowed;
    const auto result = file.import(options);
    return only(result).tangents.size();
  };
  EXPECT_EQ(tangents(nullptr), 0u);
  EXPECT_EQ(tangents(R"({})"), 0u);
  EXPECT_EQ(tangents(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}},"occlusionTexture":{"index":0},)"
                     R"("emissiveTexture":{"index":0}})"),
            0u);
  EXPECT_EQ(tangents(R"({"normalTexture":{"index":0,"texCoord":1}})"), 0u) << "which the mesh does not have";
  EXPECT_EQ(tangents(R"({"normalTexture":{"index":0}})"), 3u);
  const std::string moved = R"("extensions":{"KHR_texture_transform":{"texCoord":)";
  EXPECT_EQ(tangents((R"({"normalTexture":{"index":0,"texCoord":1,)" + moved + "0}}}}").c_str()), 3u);
  EXPECT_EQ(tangents((R"({"normalTexture":{"index":0,)" + moved + "1}}}}").c_str()), 0u);
  EXPECT_EQ(tangents(R"({"normalTexture":{"index":0}})", false), 0u);
}

TEST(build_meshes, tangents_of_the_file_stay_where_there_is_a_normal_map) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["attributes"]["NORMAL"] = file.vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
  primitive["attributes"]["TANGENT"] = file.vec4({0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1});
  primitive["attributes"]["TEXCOORD_0"] = file.add(std::vector<float>{0, 0, 1, 0, 0, 1}, "VEC2", 5126, 2);
  primitive["material"] = 0;
  file.root["images"] = Json::parse(R"([{"uri":"data:image/png;base64,AAAA"}])");
  file.root["textures"] = Json::parse(R"([{"source":0}])");
  file.root["materials"] = Json::parse(R"([{"normalTexture":{"index":0}}])");
  EXPECT_THAT(only(file.import()).tangents, testing::Each(glm::vec4(0, 1, 0, 1))) << "those of the map point along x";
}

TEST(build_meshes, attribute_formats_and_counts_are_checked) {
  const auto rule = [](const char* name, auto add) {
    TinyGltf file;
    Json& primitive = file.add_triangle();
    primitive["attributes"][name] = add(file);
    return outcome(file.import());
  };
  const auto place = [](const char* r, const char* name) { return std::string(r) + " at " + kAttributes + "/" + name; };
  EXPECT_EQ(rule("NORMAL", [](TinyGltf& f) { return f.vec4(std::vector<float>(12)); }),
            place("mesh-attribute-format", "NORMAL"));
  EXPECT_EQ(rule("POSITION", [](TinyGltf& f) { return f.add(std::vector<std::uint32_t>(9), "VEC3", 5125, 3); }),
            place("mesh-attribute-format", "POSITION"));
  EXPECT_EQ(rule("JOINTS_0", [](TinyGltf& f) { return f.vec4(std::vector<float>(12)); }),
            place("mesh-attribute-format", "JOINTS_0"));
  EXPECT_EQ(rule("WEIGHTS_0", [](TinyGltf& f) { return f.add(std::vector<std::uint8_t>(12), "VEC4", 5121, 4); }),
            place("mesh-attribute-format", "WEIGHTS_0"));
  EXPECT_EQ(rule("TEXCOORD_0", [](TinyGltf& f) { return f.add(std::vector<float>(4), "VEC2", 5126, 2); }),
            place("mesh-attribute-count", "TEXCOORD_0"));
  EXPECT_EQ(rule("NORMAL",
                 [](TinyGltf& f) {
                   return f.vec3({0, 0, std::numeric_limits<float>::quiet_NaN(), 0, 0, 1, 0, 0, 1});
                 }),
            place("not-finite", "NORMAL"));
  const auto infinite = [](TinyGltf& f) { return f.vec3({0, 0, 0, 0, INFINITY, 0, 0, 0, 0}); };
  EXPECT_EQ(rule("COLOR_0", infinite), place("not-finite", "COLOR_0"));
  EXPECT_EQ(rule("COLOR_1", infinite), place("not-finite", "COLOR_1")) << "which nothing shows";
}

TEST(build_meshes, sets_of_joints_or_weights_alone_are_named_and_ignored) {
  for (const std::string name : {"JOINTS_", "WEIGHTS_"}) {
    TinyGltf file;
    Json& attributes =
        file.add_skinned_triangle(std::vector<std::uint8_t>(12), std::vector<float>(12, .25f))["attributes"];
    attributes[name + "1"] = attributes[name + "0"];
    EXPECT_TRUE(warns(file.import(), "mesh-joint-sets", kAttributes)) << name;
  }
}

TEST(build_meshes, G59_quantised_attributes_are_read_and_need_their_extension) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["attributes"]["POSITION"] =
      file.add(std::vector<std::uint16_t>{0, 0, 0, 100, 0, 0, 0, 65535, 0}, "VEC3", 5123, 3);
  EXPECT_TRUE(warns(file.import(), "mesh-quantization", std::string(kAttributes) + "/POSITION"));
  file.root["extensionsUsed"] = {"KHR_mesh_quantization"};
  const auto result = file.import();
  EXPECT_THAT(result->warnings, IsEmpty());
  EXPECT_EQ(only(result).bounds.upper, glm::vec3(100, 65535, 0));
}

TEST(build_meshes, handedness_is_plus_or_minus_one_with_the_sign_of_the_file) {
  for (const auto& [given, kept] :
       {std::pair(glm::vec3(.5f, -1, 1), glm::vec3(1, -1, 1)), std::pair(glm::vec3(1, -3, -1), glm::vec3(1, -1, -1))}) {
    TinyGltf file;
    Json& primitive = file.add_triangle();
    primitive["attributes"]["NORMAL"] = file.vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
    primitive["attributes"]["TANGENT"] = file.vec4({1, 0, 0, given.x, 1, 0, 0, given.y, 1, 0, 0, given.z});
    const auto result = file.import();
    for (int v = 0; v < 3; ++v) EXPECT_EQ(only(result).tangents[static_cast<std::size_t>(v)].w, kept[v]);
    ASSERT_THAT(result->warnings, SizeIs(1));
    EXPECT_TRUE(result->warnings[0].detail.starts_with("1 handedness")) << result->warnings[0].detail;
  }
}

TEST(build_meshes, odd_normals_tangents_and_texcoords_are_repaired_and_named) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["attributes"]["NORMAL"] = file.vec3({0, 0, 2, 0, 0, 0, 0, 0, 1});
  primitive["attributes"]["TANGENT"] = file.vec4({1, 0, 0, .5f, 1, 0, 0, -3, 1, 0, 0, 1});
  primitive["attributes"]["TEXCOORD_1"] = file.add(std::vector<float>(6), "VEC2", 5126, 2);
  primitive["attributes"]["COLOR_0"] = file.vec3({1, 0, 0, 0, 1, 0, 0, 0, 1});
  primitive["attributes"]["NORMALS"] = 0;
  const auto result = file.import();
  EXPECT_TRUE(warns(result, "mesh-normal-length", std::string(kAttributes) + "/NORMAL"));
  EXPECT_TRUE(warns(result, "mesh-tangent-sign", std::string(kAttributes) + "/TANGENT"));
  EXPECT_TRUE(warns(result, "mesh-texcoord-gap", kAttributes));
  EXPECT_TRUE(warns(result, "mesh-attribute-name", std::string(kAttributes) + "/NORMALS"));
  EXPECT_THAT(only(result).normals, testing::Each(glm::vec3(0, 0, 1)));
  EXPECT_EQ(only(result).tangents[1].w, -1.0f);
  EXPECT_EQ(only(result).colors[1], glm::vec4(0, 1, 0, 1)) << "three components: opaque";
}

TEST(build_meshes, G47_targets_may_omit_attributes_but_not_invent_them) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  const std::size_t delta = file.vec3(std::vector<float>(9, .5f));
  primitive["targets"] = Json::array(
      {Json::object(), {{"NORMAL", delta}, {"JOINTS_0", delta}, {"WEIGHTS_0", delta}}, {{"POSITION", delta}}});
  const auto result = file.import();
  for (const std::string name : {"NORMAL", "JOINTS_0", "WEIGHTS_0"})
    EXPECT_TRUE(warns(result, "morph-no-base", "/meshes/0/primitives/0/targets/1/" + name)) << name;
  ASSERT_THAT(only(result).morphs.targets, SizeIs(3));
  EXPECT_TRUE(only(result).morphs.targets[0].positions.empty());
  EXPECT_EQ(only(result).morphs.targets[2].positions.vertices.size(), 3u);
  EXPECT_THAT(result->scene.instances[0].rest_weights, ElementsAre(0, 0, 0));
}

TEST(build_meshes, G47_displaced_texture_coordinates_are_kept_and_reported_as_unused) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["attributes"]["TEXCOORD_0"] = file.add(std::vector<float>(6), "VEC2", 5126, 2);
  primitive["targets"] =
      Json::array({{{"TEXCOORD_0", file.add(std::vector<float>{0, 0, .5f, 0, 0, 0}, "VEC2", 5126, 2)}}});
  const auto result = file.import();
  EXPECT_TRUE(warns(result, "morph-texcoord", "/meshes/0/primitives/0/targets/0/TEXCOORD_0"));
  ASSERT_THAT(only(result).morphs.targets[0].texcoords, SizeIs(1));
  EXPECT_THAT(only(result).morphs.targets[0].texcoords[0].vertices, ElementsAre(1));
}

TEST(build_meshes, displaced_colors_of_three_components_leave_opacity_alone) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["attributes"]["COLOR_0"] = file.vec4(std::vector<float>(12, 0.5f));
  primitive["targets"] = Json::array({{{"COLOR_0", file.vec3({0, 0, 0, .5f, -.25f, .125f, 0, 0, 0})}}});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_THAT(only(result).morphs.targets[0].colors.vertices, ElementsAre(1));
  EXPECT_THAT(only(result).morphs.targets[0].colors.deltas, ElementsAre(glm::vec4(.5f, -.25f, .125f, 0)));
}

TEST(build_meshes, N26_weights_and_displacements_too_small_to_show_are_zero_from_the_start) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["targets"] =
      Json::array({{{"POSITION", file.vec3({1e-30f, -1e-41f, 0, 1e-21f, 2, 1e-38f, 1e-20f, 0, 0})}}});
  file.root["meshes"][0]["weights"] = {1e-39};
  file.root["nodes"].push_back({{"mesh", 0}, {"weights", {1e-39}}});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const auto& moved = only(result).morphs.targets[0].positions;
  EXPECT_THAT(moved.vertices, ElementsAre(1, 2));
  EXPECT_THAT(moved.deltas, ElementsAre(glm::vec3(0, 2, 0), glm::vec3(1e-20f, 0, 0)));
  EXPECT_EQ(result->scene.meshes[0].default_weights[0], 0.0f);
  for (const MeshInstance& instance : result->scene.instances) EXPECT_EQ(instance.rest_weights[0], 0.0f);
}

TEST(build_meshes, primitives_with_fewer_targets_are_filled_up) {
  TinyGltf file;
  file.add_triangle()["targets"] = Json::array({{{"POSITION", file.vec3(std::vector<float>(9, .5f))}}});
  file.root["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}});
  const auto result = file.import();
  ASSERT_TRUE(warns(result, "mesh-target-count", "/meshes/0/primitives/1/targets"));
  EXPECT_THAT(result->warnings[0].detail, testing::StartsWith("0 targets, the first primitive has 1;"));
  EXPECT_THAT(result->scene.meshes[0].primitives[1].morphs.targets, SizeIs(1));
}

TEST(build_meshes, G43_node_weights_come_before_mesh_weights) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  const std::size_t delta = file.vec3(std::vector<float>(9, .5f));
  primitive["targets"] = Json::array({{{"POSITION", delta}}, {{"POSITION", delta}}});
  file.root["meshes"][0]["weights"] = {.5, .25};
  file.root["nodes"] =
      Json::array({{{"mesh", 0}}, {{"mesh", 0}, {"weights", {1, 0}}}, {{"mesh", 0}, {"weights", {1}}}});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_THAT(result->scene.instances[0].rest_weights, ElementsAre(.5f, .25f));
  EXPECT_THAT(result->scene.instances[1].rest_weights, ElementsAre(1, 0));
  EXPECT_TRUE(warns(result, "node-weights-count", "/nodes/2/weights"));
  EXPECT_THAT(result->scene.first_weight, ElementsAre(0, 2, 4, 6));
}

TEST(build_meshes, a_primitive_without_positions_keeps_its_place) {
  TinyGltf file;
  file.add_triangle();
  auto& primitives = file.root["meshes"][0]["primitives"];
  primitives.insert(primitives.begin(), Json({{"attributes", Json::object()}}));
  const auto result = file.import();
  EXPECT_TRUE(warns(result, "mesh-no-position", kAttributes));
  ASSERT_THAT(result->scene.meshes[0].primitives, SizeIs(2));
  EXPECT_EQ(result->scene.meshes[0].primitives[1].vertex_count(), 3u);
}

TEST(build_meshes, counts_that_make_no_whole_elements_are_a_warning) {
  TinyGltf file;
  file.add_triangle()["indices"] = file.add(std::vector<std::uint8_t>{0, 1, 2, 0}, "SCALAR", 5121, 1);
  const auto result = file.import();
  EXPECT_TRUE(warns(result, "mesh-mode", "/meshes/0/primitives/0/mode"));
  EXPECT_THAT(only(result).indices, SizeIs(3));
  TinyGltf floats;
  floats.add_triangle()["indices"] = floats.scalars({0, 1, 2});
  EXPECT_EQ(outcome(floats.import()), "mesh-indices at /meshes/0/primitives/0/indices");
}

}  // namespace
}  // namespace sinew::test
