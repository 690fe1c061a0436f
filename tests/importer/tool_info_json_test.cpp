// SPDX-License-Identifier: MIT
// Every entry of the document of `sinew info --json`, of a file that has something in each list.
#include <gtest/gtest.h>

#include "importer/tool/info/info_json.h"
#include "importer/tool/info/node_tree.h"
#include "runtime/memory/memory_of.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/importer/tool_json.h"

namespace sinew::test {
namespace {

/// A fan of three triangles with everything, lines without normals, and points; a quad without normals that morphs.
void add_meshes(TinyGltf& file) {
  const auto fan = file.vec3({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 2, 0, -1, 1, 0});
  const auto up = file.vec3({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  const auto along = file.vec4({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
  const auto uv = file.add(std::vector<float>(10, 0.5f), "VEC2", 5126, 2);
  const auto color = file.vec4(std::vector<float>(20, 1.0f));
  const auto joints =
      file.add(std::vector<std::uint8_t>{0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 5121, 4);
  const auto weights = file.vec4({1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 0.25f, 0.75f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  const auto corners = file.add(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3, 0, 3, 4}, "SCALAR", 5123, 1);
  const auto line = file.vec3({0, 0, -3, 0, 0, 4});
  const auto quad = file.vec3({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  const auto two_triangles = file.add(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, "SCALAR", 5123, 1);
  const auto smile = file.vec3({0, 0, 1, 0, 0, 0, 0, 0, 2, 0, 0, 0});
  const auto colors = file.vec4(std::vector<float>(16, 0.5f));
  const auto blush = file.vec4({0.1f, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  file.root["meshes"] = Json::array({{{"name", "body"},
                                      {"primitives",
                                       {{{"attributes",
                                          {{"POSITION", fan},
                                           {"NORMAL", up},
                                           {"TANGENT", along},
                                           {"TEXCOORD_0", uv},
                                           {"TEXCOORD_1", uv},
                                           {"COLOR_0", color},
                                           {"JOINTS_0", joints},
                                           {"WEIGHTS_0", weights}}},
                                         {"indices", corners},
                                         {"material", 1}},
                                        {{"mode", 1}, {"attributes", {{"POSITION", line}}}},
                                        {{"mode", 0}, {"attributes", {{"POSITION", fan}}}}}}},
                                     {{"name", "face"},
                                      {"weights", {0.25f, 0.0f}},
                                      {"extras", {{"targetNames", {"smile", "blush"}}}},
                                      {"primitives",
                                       {{{"attributes", {{"POSITION", quad}, {"COLOR_0", colors}}},
                                         {"indices", two_triangles},
                                         {"targets", {{{"POSITION", smile}}, {{"COLOR_0", blush}}}}}}}}});
}

/// Three channels with 2, 3 and 2 keys, one of them cubic and one constant; and a roughness with 2 in steps.
void add_animations(TinyGltf& file) {
  const auto second = file.times({0, 1}), three = file.times({0, 1, 2.5f});
  const auto turn = file.vec4({0, 0, 0, 1, 0, 0, 0.6f, 0.8f});
  const auto move =
      file.vec3(std::vector<float>{0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 0});
  const auto still = file.scalars({0.5f, 0, 0.5f, 0});
  const auto rough = file.scalars({0.25f, 0.75f});
  const auto channel = [](int sampler, int node, const char* path) {
    return Json{{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}};
  };
  file.root["animations"] = Json::array(
      {{{"name", "act"},
        {"samplers",
         {{{"input", second}, {"output", turn}},
          {{"input", three}, {"output", move}, {"interpolation", "CUBICSPLINE"}},
          {{"input", second}, {"output", still}},
          {{"input", second}, {"output", rough}, {"interpolation", "STEP"}}}},
        {"channels",
         {channel(0, 2, "rotation"),
          channel(1, 2, "translation"),
          channel(2, 3, "weights"),
          {{"sampler", 3},
           {"target",
            {{"path", "pointer"},
             {"extensions",
              {{"KHR_animation_pointer", {{"pointer", "/materials/1/pbrMetallicRoughness/roughnessFactor"}}}}}}}}}}}});
}

TinyGltf whole_file() {
  TinyGltf file;
  add_meshes(file);
  add_animations(file);
  file.root["asset"] = {{"version", "2.0"}, {"generator", "a program"}, {"copyright", "nobody"}};
  file.root["extensionsUsed"] = {"KHR_animation_pointer",  "KHR_lights_punctual", "KHR_materials_unlit",
                                 "KHR_materials_specular", "KHR_node_visibility", "ACME_fur"};
  file.root["extensionsRequired"] = {"KHR_lights_punctual"};
  const auto light = [](int index) { return Json{{"KHR_lights_punctual", {{"light", index}}}}; };
  file.root["nodes"] =
      Json::array({{{"name", "strip"}, {"mesh", 0}, {"skin", 0}},
                   {{"name", "hip"}, {"children", {2}}},
                   {{"name", "knee"}, {"translation", {0, 1, 0}}},
                   {{"name", "head"}, {"mesh", 1}, {"weights", {0.5f, 0.0f}}, {"translation", {5, 0, 0}}},
                   {{"name", "eye"}, {"camera", 0}, {"children", {5, 6, 7}}},
                   {{"name", "sun"}, {"extensions", light(0)}},
                   {{"extensions", light(1)}},
                   {{"name", "beam"}, {"extensions", light(2)}},
                   {{"camera", 1}, {"matrix", {1, 0, 0, 0, 0.5f, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}},
                   {{"name", "twin"}, {"mesh", 1}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}}});
  file.root["scenes"] = Json::array({{{"nodes", {0, 1, 3, 4, 8, 9}}}, {{"nodes", {1}}}});
  file.root["scene"] = 0;
  const auto binds = file.add(std::vector<float>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                                 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1},
                              "MAT4", 5126, 16);
  file.root["skins"] =
      Json::array({{{"name", "bones"}, {"joints", {1, 2}}, {"skeleton", 1}, {"inverseBindMatrices", binds}}});
  file.root["cameras"] = Json::array(
      {{{"name", "near"}, {"type", "perspective"}, {"perspective", {{"yfov", 0.5f}, {"znear", 0.125f}}}},
       {{"type", "orthographic"}, {"orthographic", {{"xmag", 3}, {"ymag", 2}, {"znear", 0.25f}, {"zfar", 50}}}}});
  file.root["extensions"] = {
      {"KHR_lights_punctual",
       {{"lights",
         {{{"name", "sun"}, {"type", "directional"}, {"intensity", 3}, {"color", {1, 0.5f, 0.25f}}},
          {{"type", "point"}, {"intensity", 40}, {"range", 8}},
          {{"name", "beam"}, {"type", "spot"}, {"spot", {{"outerConeAngle", 0.5f}}}}}}}}};
  file.root["images"] = Json::array({{{"name", "gone"}, {"uri", "gone.png"}}});
  file.root["textures"] = Json::array({{{"source", 0}}});
  file.root["materials"] = Json::array(
      {{{"name", "paper"},
        {"alphaMode", "BLEND"},
        {"extensions", {{"KHR_materials_unlit", Json::object()}}},
        {"pbrMetallicRoughness",
         {{"baseColorFactor", {0.5f, 0.25f, 0.125f, 0.75f}}, {"baseColorTexture", {{"index", 0}}}}}},
       {{"name", "tin"},
        {"doubleSided", true},
        {"pbrMetallicRoughness",
         {{"metallicFactor", 0.5f}, {"roughnessFactor", 0.25f}, {"metallicRoughnessTexture", {{"index", 0}}}}},
        {"normalTexture", {{"index", 0}}},
        {"occlusionTexture", {{"index", 0}}},
        {"emissiveTexture", {{"index", 0}}}},
       {{"alphaMode", "MASK"}}});
  return file;
}

class ToolInfoJson : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    ImportOptions options;
    options.decode_images = false;
    options.carry_document = true;
    auto file = whole_file().import(options);
    ASSERT_TRUE(file) << outcome(file);
    info_ = new Json(parsed(tool::info_json("a file.glb", *file)));
    nodes_ = new Json(parsed(tool::node_list_json(file->scene)));
    scene_ = new Scene(std::move(file->scene));
  }
  static void TearDownTestSuite() {
    delete info_;
    delete nodes_;
    delete scene_;
  }
  void SetUp() override { ASSERT_NE(info_, nullptr); }

  /// The entries of a document but for some.
  static Json without(Json object, const std::vector<const char*>& keys) {
    for (const char* key : keys) object.erase(key);
    return object;
  }

  static inline const Json *info_ = nullptr, *nodes_ = nullptr;
  static inline const Scene* scene_ = nullptr;
};

TEST_F(ToolInfoJson, head) {
  const Json& info = *info_;
  EXPECT_EQ(info["file"], "a file.glb");
  EXPECT_EQ(info["bytes"], whole_file().text().size());
  EXPECT_EQ(info["version"], "2.0");
  EXPECT_EQ(info["generator"], "a program");
  EXPECT_EQ(info["copyright"], "nobody");
  EXPECT_EQ(info["nodes"], (Json{{"count", 10}, {"roots", 6}, {"depth", 2}, {"given_as_matrix", 1}}));
  EXPECT_EQ(info["scenes"], 2);
  EXPECT_EQ(info["default_scene"], 0);
  EXPECT_EQ(info["hidden_nodes"], Json{9});
  const auto use = [](const char* name, bool required, const char* handling) {
    return Json{{"name", name}, {"required", required}, {"handling", handling}};
  };
  EXPECT_EQ(info["extensions"],
            (Json{use("KHR_animation_pointer", false, "read"), use("KHR_lights_punctual", true, "read"),
                  use("KHR_materials_unlit", false, "read"), use("KHR_materials_specular", false, "read"),
                  use("KHR_node_visibility", false, "read"), use("ACME_fur", false, "unknown")}));
}

TEST_F(ToolInfoJson, meshes) {
  const Json body = (*info_)["meshes"][0], face = (*info_)["meshes"][1];
  EXPECT_EQ(without(body, {"primitives"}), (Json{{"name", "body"},
                                                 {"vertices", 12},
                                                 {"triangles", 3},
                                                 {"bounds", {{"lower", {-1, 0, -3}}, {"upper", {1, 2, 4}}}}}));
  const auto primitive = [](const char* topology, int vertices, int elements, const char* normals) {
    return Json{{"topology", topology}, {"vertices", vertices}, {"vertices_after_splitting", vertices},
                {"elements", elements}, {"normals", normals},   {"tangents", false},
                {"texcoord_sets", 0},   {"colors", false},      {"material", nullptr}};
  };
  Json fan = primitive("triangles", 5, 3, "yes");
  fan["tangents"] = fan["colors"] = true;
  fan["texcoord_sets"] = 2;
  fan["material"] = 1;
  EXPECT_EQ(body["primitives"][0], fan);
  EXPECT_EQ(body["primitives"][1], primitive("lines", 2, 1, "none"));
  EXPECT_EQ(body["primitives"][2], primitive("points", 5, 5, "none"));
  Json quad = primitive("triangles", 4, 2, "made, flat");
  quad["colors"] = true;
  quad["vertices_after_splitting"] = scene_->meshes[1].primitives[0].vertex_count();
  EXPECT_GT(quad["vertices_after_splitting"], 4);
  EXPECT_EQ(face["primitives"], Json::array({quad}));
  EXPECT_EQ(face["morph_targets"][1], (Json{{"name", "blush"}, {"non_zero_deltas", 2}, {"default_weight", 0.0}}));
  EXPECT_EQ(face["morph_targets"][0]["name"], "smile");
  EXPECT_EQ(face["morph_targets"][0]["default_weight"], 0.25);
}

TEST_F(ToolInfoJson, instances_and_skins) {
  const auto instance = [](int node, const char* name, int mesh, Json skin, Json weights) {
    return Json{{"node", node}, {"node_name", name},       {"mesh", mesh},
                {"skin", skin}, {"rest_weights", weights}, {"copies", 1}};
  };
  EXPECT_EQ((*info_)["mesh_instances"],
            (Json{instance(0, "strip", 0, 0, Json::array()), instance(3, "head", 1, nullptr, {0.5, 0.0}),
                  instance(9, "twin", 1, nullptr, {0.25, 0.0})}));
  EXPECT_EQ((*info_)["skins"], (Json{{{"name", "bones"},
                                      {"joints", 2},
                                      {"joint_names", {"hip", "knee"}},
                                      {"joints_with_weight", 2},
                                      {"root", 1},
                                      {"vertices_by_influences", {{"1", 3}, {"2", 2}}}}}));
}

TEST_F(ToolInfoJson, clips) {
  const Json clip = (*info_)["clips"][0];
  EXPECT_EQ(
      without(clip, {"constant_tracks", "key_searches", "bytes_compiled", "events", "curves"}),
      (Json{{"name", "act"},
            {"duration_s", 2.5},
            {"animated_nodes", {2, 3}},
            {"channels", 4},
            {"channels_by_property", {{"translation", 1}, {"rotation", 1}, {"weights", 1}, {"roughnessFactor", 1}}},
            {"modes", {{"linear", 2}, {"cubic_spline", 1}, {"step", 1}}},
            {"keys", 9},
            {"most_keys_of_a_channel", 3},
            // Times and values: rotation 2 + 8, translation 3 + 3 * 9, weights 2 + 4, roughness 2 + 2 of four.
            {"bytes_of_keys",
             4 * (2 + 8 + 3 + 27 + 2 + 4 + 2) + 2 * static_cast<int>(sizeof(PropertyTrack{}.values.values[0]))}}));
  EXPECT_EQ(clip["constant_tracks"], scene_->clips[0].counts().folded);
  EXPECT_GT(clip["constant_tracks"], 0);
  EXPECT_EQ(clip["events"], Json::array());
  EXPECT_EQ(clip["curves"], Json::array());
  EXPECT_EQ(clip["key_searches"], scene_->clips[0].counts().time_groups);
  EXPECT_EQ(clip["bytes_compiled"], scene_->clips[0].byte_size());
}

TEST_F(ToolInfoJson, materials_and_images) {
  const auto textures = [](bool base, bool others) {
    return Json{{"base_color", base},
                {"metallic_roughness", others},
                {"normal", others},
                {"occlusion", others},
                {"emissive", others}};
  };
  const auto material = [](const char* name, const char* alpha, bool sides, bool unlit, Json color, double metallic,
                           double roughness) {
    return Json{{"name", name},        {"alpha", alpha},       {"double_sided", sides}, {"unlit", unlit},
                {"base_color", color}, {"metallic", metallic}, {"roughness", roughness}};
  };
  const Json& list = (*info_)["materials"];
  EXPECT_EQ(without(list[0], {"textures", "texture_images"}),
            material("paper", "blend", false, true, {0.5, 0.25, 0.125, 0.75}, 1, 1));
  EXPECT_EQ(without(list[1], {"textures", "texture_images"}),
            material("tin", "opaque", true, false, {1, 1, 1, 1}, 0.5, 0.25));
  EXPECT_EQ(without(list[2], {"textures", "texture_images"}), material("", "mask", false, false, {1, 1, 1, 1}, 1, 1));
  EXPECT_EQ(list[0]["textures"], textures(true, false));
  EXPECT_EQ(list[1]["textures"], textures(false, true));
  EXPECT_EQ(list[2]["textures"], textures(false, false));
  EXPECT_EQ(list[0]["texture_images"], (Json{{"base_color", 0}}));
  EXPECT_EQ(list[1]["texture_images"],
            (Json{{"metallic_roughness", 0}, {"normal", 0}, {"occlusion", 0}, {"emissive", 0}}));
  EXPECT_EQ((*info_)["images"][0]["name"], "gone");
}

TEST_F(ToolInfoJson, each_texture_of_a_material_names_its_own_image) {
  TinyGltf file;
  file.root["images"] = file.root["textures"] = Json::array();
  for (int i = 0; i < 5; ++i) {
    file.root["images"].push_back({{"uri", "none" + std::to_string(i) + ".png"}});
    file.root["textures"].push_back({{"source", 4 - i}});
  }
  const auto texture = [](int index) { return Json{{"index", index}}; };
  file.root["materials"] = Json::array(
      {{{"pbrMetallicRoughness", {{"baseColorTexture", texture(0)}, {"metallicRoughnessTexture", texture(1)}}},
        {"normalTexture", texture(2)},
        {"occlusionTexture", texture(3)},
        {"emissiveTexture", texture(4)}}});
  ImportOptions options;
  options.decode_images = false;
  options.carry_document = true;
  const auto read = file.import(options);
  ASSERT_EQ(outcome(read), "ok");
  EXPECT_EQ(Json(parsed(tool::info_json("a", *read)))["materials"][0]["texture_images"],
            (Json{{"base_color", 4}, {"metallic_roughness", 3}, {"normal", 2}, {"occlusion", 1}, {"emissive", 0}}));
}

TEST_F(ToolInfoJson, cameras_and_lights) {
  EXPECT_EQ((*info_)["cameras"], (Json{{{"name", "near"},
                                        {"node", 4},
                                        {"kind", "perspective"},
                                        {"fov_y_rad", 0.5},
                                        {"half_height", nullptr},
                                        {"near_m", 0.125},
                                        {"far_m", nullptr}},
                                       {{"name", ""},
                                        {"node", 8},
                                        {"kind", "orthographic"},
                                        {"fov_y_rad", nullptr},
                                        {"half_height", 2.0},
                                        {"near_m", 0.25},
                                        {"far_m", 50.0}}}));
  const auto light = [](const char* name, int node, const char* kind, Json color, double intensity, Json range) {
    return Json{{"name", name},   {"node", node},           {"kind", kind},
                {"color", color}, {"intensity", intensity}, {"range_m", range}};
  };
  EXPECT_EQ((*info_)["lights"],
            (Json{light("sun", 5, "directional", {1, 0.5, 0.25}, 3, nullptr), light("", 6, "point", {1, 1, 1}, 40, 8.0),
                  light("beam", 7, "spot", {1, 1, 1}, 1, nullptr)}));
}

TEST_F(ToolInfoJson, nodes) {
  const auto node = [](const char* name, Json parent, Json changes) {
    Json out{{"name", name},
             {"parent", parent},
             {"children", Json::array()},
             {"mesh", nullptr},
             {"skin", nullptr},
             {"cameras", Json::array()},
             {"lights", Json::array()},
             {"joint_of_skins", Json::array()},
             {"animated_by_clips", Json::array()},
             {"hidden", false}};
    out.update(changes);
    return out;
  };
  EXPECT_EQ(*nodes_,
            (Json{node("strip", nullptr, {{"mesh", 0}, {"skin", 0}}),
                  node("hip", nullptr, {{"children", {2}}, {"joint_of_skins", {0}}}),
                  node("knee", 1, {{"joint_of_skins", {0}}, {"animated_by_clips", {0}}}),
                  node("head", nullptr, {{"mesh", 1}, {"animated_by_clips", {0}}}),
                  node("eye", nullptr, {{"children", {5, 6, 7}}, {"cameras", {0}}}), node("sun", 4, {{"lights", {0}}}),
                  node("", 4, {{"lights", {1}}}), node("beam", 4, {{"lights", {2}}}),
                  node("", nullptr, {{"cameras", {1}}}), node("twin", nullptr, {{"mesh", 1}, {"hidden", true}})}));
  EXPECT_EQ(tool::node_tree_text(tool_json(*nodes_)), R"(  0 "strip": mesh 0, skin 0
  1 "hip": joint of skin 0
    2 "knee": joint of skin 0, animated by clip 0
  3 "head": mesh 1, animated by clip 0
  4 "eye": camera 0
    5 "sun": light 0
    6: light 1
    7 "beam": light 2
  8: camera 1
  9 "twin": mesh 1, hidden
)");
}

}  // namespace
}  // namespace sinew::test
