// SPDX-License-Identifier: MIT
// Features of the glTF sample models: each test builds a file with one of them, imports and evaluates it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "runtime/plan/run_plan.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/support/near.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using Indices = std::vector<std::uint32_t>;

const Primitive& first_primitive(const ImportResult<ImportedFile>& file) {
  if (!file) throw std::runtime_error(outcome(file));
  return file->scene.meshes.at(0).primitives.at(0);
}

/// A sparse accessor that replaces zeros, or the elements of view `base`.
template <class Index>
std::size_t add_sparse(TinyGltf& file, const std::vector<Index>& at, int index_type, const std::vector<float>& values,
                       const char* type, std::size_t count, const std::optional<std::size_t>& base = {}) {
  const std::size_t indices = file.add_view(at), replaced = file.add_view(values);
  Json accessor{{"componentType", 5126},
                {"count", count},
                {"type", type},
                {"sparse",
                 {{"count", at.size()},
                  {"indices", {{"bufferView", indices}, {"componentType", index_type}}},
                  {"values", {{"bufferView", replaced}}}}}};
  if (base) accessor["bufferView"] = *base;
  file.root["accessors"].push_back(accessor);
  return file.root["accessors"].size() - 1;
}

TEST(sample_features, G24_key_times_and_values_may_be_sparse) {
  TinyGltf file;
  file.root["nodes"] = Json::array({Json::object()});
  const std::size_t times = add_sparse<std::uint8_t>(file, {1, 2}, 5121, {0.5f, 1.0f}, "SCALAR", 3);
  const std::size_t zeros = file.add_view(std::vector<float>(9, 4.0f));
  const std::size_t values = add_sparse<std::uint32_t>(file, {1}, 5125, {7, 8, 9}, "VEC3", 3, zeros);
  file.animate("translation", times, values);
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const Vec3Track& track = result->scene.animations[0].bones[0].translation;
  EXPECT_THAT(track.times_s, ElementsAre(0.0f, 0.5f, 1.0f));
  EXPECT_THAT(track.values, ElementsAre(glm::vec3(4), glm::vec3(7, 8, 9), glm::vec3(4)));
}

TEST(sample_features, G24_indices_may_be_sparse) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  const std::size_t base = file.add_view(std::vector<std::uint16_t>{0, 0, 0}),
                    at = file.add_view(std::vector<std::uint8_t>{1, 2}),
                    values = file.add_view(std::vector<std::uint16_t>{1, 2});
  file.root["accessors"].push_back({{"bufferView", base},
                                    {"componentType", 5123},
                                    {"count", 3},
                                    {"type", "SCALAR"},
                                    {"sparse",
                                     {{"count", 2},
                                      {"indices", {{"bufferView", at}, {"componentType", 5121}}},
                                      {"values", {{"bufferView", values}}}}}});
  primitive["indices"] = file.root["accessors"].size() - 1;
  EXPECT_EQ(first_primitive(file.import()).indices, (Indices{0, 1, 2}));
}

/// Sparse entries are out of order and repeated, and the importer reorders the vertices.
TEST(sample_features, G24_G47_sparse_displacements_follow_their_vertices) {
  TinyGltf file;
  Json& primitive = file.add_skinned_triangle({0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0},
                                              {0.5f, 0.5f, 0, 0, 1, 0, 0, 0, 0.25f, 0.75f, 0, 0});
  primitive["targets"] = Json::array(
      {{{"POSITION", add_sparse<std::uint16_t>(file, {2, 0, 2}, 5123, {9, 9, 9, 1, 0, 0, 3, 0, 0}, "VEC3", 3)}}});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const Primitive& read = first_primitive(result);
  ASSERT_EQ(read.source_vertex, (Indices{1, 0, 2})) << "one influence comes first";
  const auto& deltas = read.morphs.targets[0].positions;
  EXPECT_EQ(deltas.vertices, (Indices{1, 2}));
  EXPECT_THAT(deltas.deltas, ElementsAre(glm::vec3(1, 0, 0), glm::vec3(3, 0, 0)));
  EXPECT_TRUE(warns(result, "accessor-sparse-order", "/accessors/3/sparse"));
}

TEST(sample_features, sparse_displacements_must_be_finite_and_the_vertex_is_named) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  const float infinite = std::numeric_limits<float>::infinity();
  primitive["targets"] =
      Json::array({{{"POSITION", add_sparse<std::uint8_t>(file, {0, 2}, 5121, {0, 0, 0, 0, infinite, 0}, "VEC3", 3)}}});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "not-finite at /meshes/0/primitives/0/targets/0/POSITION");
  EXPECT_NE(result.error().issue.detail.find("element 2"), std::string::npos) << result.error().issue.detail;
}

TEST(sample_features, G17_rotation_keys_of_every_component_type_mean_the_same) {
  const auto turned = [](std::size_t (*add)(TinyGltf&)) {
    TinyGltf file;
    file.root["nodes"] = Json::array({Json::object()});
    const std::size_t times = file.times({0, 1});
    file.animate("rotation", times, add(file));
    const auto result = file.import();
    return result ? result->scene.animations[0].bones[0].rotation.values.at(1) : glm::quat(0, 0, 0, 0);
  };
  const glm::quat half_turn = quat_xyzw(0.0f, 1.0f, 0.0f, 0.0f);
  EXPECT_EQ(turned([](TinyGltf& f) { return f.vec4({0, 0, 0, 1, 0, 1, 0, 0}); }), half_turn);
  EXPECT_EQ(turned([](TinyGltf& f) {
              return f.add(std::vector<std::int8_t>{0, 0, 0, 127, 0, 127, 0, 0}, "VEC4", 5120, 4, true);
            }),
            half_turn);
  EXPECT_EQ(turned([](TinyGltf& f) {
              return f.add(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 32767, 0, 0}, "VEC4", 5122, 4, true);
            }),
            half_turn);
}

TEST(sample_features, G25_attributes_interleaved_in_one_view_are_taken_apart) {
  struct Vertex {
    float position[3], uv[2];
    std::uint8_t color[4];
  };
  TinyGltf file;
  Json& primitive = file.add_triangle();
  const std::size_t view = file.add_view(std::vector<Vertex>{{{1, 2, 3}, {0.25f, 0.5f}, {255, 0, 51, 255}},
                                                             {{4, 5, 6}, {0, 1}, {0, 0, 0, 0}},
                                                             {{7, 8, 9}, {1, 0}, {255, 255, 255, 255}}});
  file.root["bufferViews"][view]["byteStride"] = sizeof(Vertex);
  const auto attribute = [&](const char* name, std::size_t offset, int component, const char* type) {
    file.root["accessors"].push_back({{"bufferView", view},
                                      {"byteOffset", offset},
                                      {"componentType", component},
                                      {"count", 3},
                                      {"type", type},
                                      {"normalized", component == 5121}});
    primitive["attributes"][name] = file.root["accessors"].size() - 1;
  };
  attribute("POSITION", 0, 5126, "VEC3");
  attribute("TEXCOORD_0", 12, 5126, "VEC2");
  attribute("COLOR_0", 20, 5121, "VEC4");
  primitive["indices"] = file.add(std::vector<std::uint8_t>{0, 1, 2}, "SCALAR", 5121, 1);
  const auto result = file.import();
  const Primitive& read = first_primitive(result);
  EXPECT_THAT(read.positions, ElementsAre(glm::vec3(1, 2, 3), glm::vec3(4, 5, 6), glm::vec3(7, 8, 9)));
  EXPECT_THAT(read.texcoords[0], ElementsAre(glm::vec2(0.25f, 0.5f), glm::vec2(0, 1), glm::vec2(1, 0)));
  EXPECT_EQ(read.colors[0], glm::vec4(1.0f, 0.0f, 51.0f / 255.0f, 1.0f));
}

TEST(sample_features, every_mode_reads_with_indices_of_any_size_and_without) {
  struct Case {
    int mode;
    Topology topology;
    Indices of_four;  ///< expected indices for four vertices in order
  };
  const Case cases[] = {{0, Topology::points, {0, 1, 2, 3}},
                        {1, Topology::lines, {0, 1, 2, 3}},
                        {2, Topology::lines, {0, 1, 1, 2, 2, 3, 3, 0}},
                        {3, Topology::lines, {0, 1, 1, 2, 2, 3}},
                        {4, Topology::triangles, {0, 1, 2}},
                        {5, Topology::triangles, {0, 1, 2, 1, 3, 2}},
                        {6, Topology::triangles, {1, 2, 0, 2, 3, 0}}};
  for (const Case& c : cases)
    for (const int index_type : {0, 5121, 5123, 5125}) {
      SCOPED_TRACE(std::to_string(c.mode) + " " + std::to_string(index_type));
      TinyGltf file;
      Json& primitive = file.add_triangle();
      primitive["attributes"]["POSITION"] = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
      primitive["attributes"]["NORMAL"] = file.vec3({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
      primitive["mode"] = c.mode;
      if (index_type == 5121)
        primitive["indices"] = file.add(std::vector<std::uint8_t>{0, 1, 2, 3}, "SCALAR", index_type, 1);
      if (index_type == 5123)
        primitive["indices"] = file.add(std::vector<std::uint16_t>{0, 1, 2, 3}, "SCALAR", index_type, 1);
      if (index_type == 5125)
        primitive["indices"] = file.add(std::vector<std::uint32_t>{0, 1, 2, 3}, "SCALAR", index_type, 1);
      const auto result = file.import();
      const Primitive& read = first_primitive(result);
      EXPECT_EQ(read.topology, c.topology);
      EXPECT_EQ(read.indices, c.of_four);
    }
}

TEST(sample_features, G17_colors_and_texture_coordinates_of_every_type_mean_the_same) {
  for (const int components : {3, 4})
    for (const int type : {5126, 5121, 5123}) {
      SCOPED_TRACE(std::to_string(components) + " " + std::to_string(type));
      TinyGltf file;
      Json& primitive = file.add_triangle();
      const auto n = static_cast<std::size_t>(components);
      const char* name = components == 3 ? "VEC3" : "VEC4";
      std::vector<float> ones(3 * n, 1.0f);
      ones[1] = 0.0f;
      const auto whole = [&]<class T>(T most, const std::vector<float>& v) {
        std::vector<T> out;
        for (const float f : v) out.push_back(static_cast<T>(f * static_cast<float>(most)));
        return out;
      };
      const std::vector<float> uv{0, 1, 1, 0, 1, 1};
      primitive["attributes"]["COLOR_0"] = type == 5126 ? file.add(ones, name, type, n)
                                           : type == 5121
                                               ? file.add(whole(std::uint8_t{255}, ones), name, type, n, true)
                                               : file.add(whole(std::uint16_t{65535}, ones), name, type, n, true);
      primitive["attributes"]["TEXCOORD_0"] = type == 5126 ? file.add(uv, "VEC2", type, 2)
                                              : type == 5121
                                                  ? file.add(whole(std::uint8_t{255}, uv), "VEC2", type, 2, true)
                                                  : file.add(whole(std::uint16_t{65535}, uv), "VEC2", type, 2, true);
      // Elements of three one-byte components break the alignment rule of glTF, but the importer accepts them.
      const auto result = file.import();
      const Primitive& read = first_primitive(result);
      EXPECT_THAT(read.colors, ElementsAre(glm::vec4(1, 0, 1, 1), glm::vec4(1), glm::vec4(1)));
      EXPECT_THAT(read.texcoords[0], ElementsAre(glm::vec2(0, 1), glm::vec2(1, 0), glm::vec2(1, 1)));
    }
}

TEST(sample_features, everything_may_be_used_by_several) {
  TinyGltf file;
  file.add_skinned_triangle({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0},
                            {0.5f, 0.5f, 0, 0, 0.5f, 0.5f, 0, 0, 0.5f, 0.5f, 0, 0});
  file.root["nodes"].push_back({{"mesh", 0}, {"skin", 0}});
  file.root["nodes"].push_back({{"mesh", 0}});
  const std::size_t times = file.times({0, 1}), values = file.vec3({0, 0, 0, 1, 2, 3});
  file.animate("translation", times, values);
  Json& animation = file.root["animations"][0];
  animation["samplers"].push_back(animation["samplers"][0]);
  animation["channels"] = Json::array({{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}},
                                       {{"sampler", 0}, {"target", {{"node", 2}, {"path", "translation"}}}},
                                       {{"sampler", 1}, {"target", {{"node", 2}, {"path", "scale"}}}}});
  file.root["animations"].push_back(animation);
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_EQ(result->scene.instances.size(), 3u);
  EXPECT_EQ(result->scene.animations.size(), 2u);
  for (const Animation& clip : result->scene.animations) EXPECT_EQ(clip.bones.size(), 2u);
  EXPECT_EQ(result->scene.animations[1].bones[1].scale.values, result->scene.animations[0].bones[0].translation.values);
}

TEST(sample_features, G29_skinned_meshes_may_hang_on_their_own_joints) {
  TinyGltf file;
  file.add_skinned_triangle({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  file.root["nodes"] = Json::array({{{"mesh", 0}, {"skin", 0}, {"translation", {50, 0, 0}}},
                                    {{"children", {2}}, {"translation", {0, 7, 0}}},
                                    {{"children", {0}}, {"mesh", 0}, {"scale", {-1, 1, 1}}}});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const Plan plan = compile_plan(lend(result->scene), Needs{});
  FrameBuffer frame(plan);
  ASSERT_EQ(run_plan(plan, {{}, {}, {}}, frame), ErrorCode::ok);
  EXPECT_EQ(frame.result().primitives.size(), 2u);
  const auto& node = frame.result().model[result->scene.skeleton.joint_of_node[2]];
  EXPECT_EQ(node.row[0][0], -1.0f) << "a mirrored node keeps its sign";
  EXPECT_EQ(node.row[1][3], 7.0f);
}

TEST(sample_features, G60_each_texture_has_its_own_coordinates_and_the_transform_may_choose_others) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["attributes"]["TEXCOORD_0"] = file.add(std::vector<float>{0, 0, 1, 0, 0, 1}, "VEC2", 5126, 2);
  primitive["attributes"]["TEXCOORD_1"] = file.add(std::vector<float>{1, 0, 0, 0, 1, 1}, "VEC2", 5126, 2);
  primitive["material"] = 0;
  file.root["textures"] = Json::array({{{"sampler", 0}}});
  file.root["samplers"] = Json::array({{{"wrapS", 33071}, {"magFilter", 9728}}});
  file.root["extensionsUsed"] = {"KHR_texture_transform"};
  file.root["materials"] =
      Json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 1}}}}},
                    {"emissiveTexture",
                     {{"index", 0},
                      {"texCoord", 0},
                      {"extensions", {{"KHR_texture_transform", {{"texCoord", 1}, {"scale", {2, 3}}}}}}}},
                    {"occlusionTexture", {{"index", 0}}}}});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const Material& material = result->scene.materials[0];
  EXPECT_EQ(material.base_color_texture.texcoord, 1u);
  EXPECT_EQ(material.emissive_texture.texcoord, 1u);
  EXPECT_EQ(material.emissive_texture.scale, glm::vec2(2, 3));
  EXPECT_EQ(material.occlusion_texture.texcoord, 0u);
  EXPECT_EQ(result->scene.textures[0].sampler.wrap_u, Wrap::clamp_to_edge);
  EXPECT_EQ(first_primitive(result).texcoords.size(), 2u);
}

TEST(sample_features, a_primitive_without_positions_misses_no_coordinates) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["material"] = 0;
  file.root["textures"] = Json::array({Json::object()});
  file.root["materials"] = Json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}});
  EXPECT_TRUE(warns(file.import(), "mesh-texcoord-missing", "/meshes/0/primitives/0/material"));
  Json& same = file.root["meshes"][0]["primitives"][0];
  same["attributes"].erase("POSITION");
  same["attributes"]["_EXTRA"] = file.vec4(std::vector<float>(12));
  same.erase("indices");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_FALSE(warns(result, "mesh-texcoord-missing", "/meshes/0/primitives/0/material")) << "nothing is drawn";
}

TEST(sample_features, coordinates_that_only_a_variant_needs_are_missed_too) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["extensions"]["KHR_materials_variants"]["mappings"] = Json::array({{{"material", 0}, {"variants", {0}}}});
  file.root["extensionsUsed"] = {"KHR_materials_variants"};
  file.root["extensions"]["KHR_materials_variants"]["variants"] = Json::array({{{"name", "painted"}}});
  file.root["textures"] = Json::array({Json::object()});
  file.root["materials"] = Json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}});
  EXPECT_TRUE(warns(file.import(), "mesh-texcoord-missing", "/meshes/0/primitives/0/material"));
}

TEST(sample_features, G63_files_are_found_by_every_spelling_of_their_names) {
  const fs::path folder = fs::temp_directory_path() / ("sinew names " + std::to_string(getpid()));
  fs::create_directories(folder);
  TinyGltf file;
  file.vec3({1, 2, 3});
  std::ofstream(folder / "Box With Spaces \xC3\xA4.bin", std::ios::binary) << std::string(12, '\0');
  for (const char* uri :
       {"Box With Spaces \xC3\xA4.bin", "Box%20With%20Spaces%20%C3%A4.bin", "./Box%20With Spaces \xC3\xA4.bin"}) {
    file.root["buffers"] = Json::array({{{"byteLength", 12}, {"uri", uri}}});
    std::ofstream(folder / "with spaces.gltf") << file.text();
    EXPECT_EQ(outcome(import_gltf(folder / "with spaces.gltf")), "ok") << uri;
  }
  fs::remove_all(folder);
}

TEST(sample_features, facts_name_the_files_that_were_read_and_no_other) {
  TinyGltf file;
  file.add_triangle();
  const std::size_t view = file.add_view(std::vector<std::uint8_t>(8));
  file.root["images"] = {{{"uri", "data:image/png;base64,iVBORw0KGgo="}},
                         {{"bufferView", view}, {"mimeType", "image/png"}},
                         {{"uri", "there%20it is.png"}}};
  const fs::path folder = fs::temp_directory_path() / ("sinew_facts." + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "there it is.png") << "not read";
  std::ofstream(folder / "x.gltf") << file.text();
  const auto result = import_gltf(folder / "x.gltf");
  ASSERT_EQ(outcome(result), "ok");
  std::vector<std::string> names;
  for (const fs::path& named : result->facts.files) names.push_back(named.filename().string());
  EXPECT_THAT(names, testing::UnorderedElementsAre("x.gltf", "there it is.png"));
  fs::remove_all(folder);
}

TEST(sample_features, G66_a_missing_buffer_that_is_unpacked_from_another_is_not_missed) {
  for (const bool says_fallback : {true, false})
    for (const bool with_uri : {true, false}) {
      SCOPED_TRACE(std::to_string(says_fallback) + std::to_string(with_uri));
      TinyGltf file;
      // A valid stream would need an encoder. An unknown stream is enough to see which rule is reported first.
      const std::size_t view = file.add_view(std::vector<std::uint8_t>(16, 0));
      file.add_triangle();
      const Json whole = Json::parse(file.text());
      Json fallback{{"byteLength", 16}};
      if (says_fallback) fallback["extensions"]["EXT_meshopt_compression"]["fallback"] = true;
      if (with_uri) fallback["uri"] = "not there.bin";
      file.root["buffers"] = Json::array({whole["buffers"][0], fallback});
      file.root["bufferViews"][view] = {
          {"buffer", 1},
          {"byteLength", 16},
          {"extensions",
           {{"EXT_meshopt_compression",
             {{"buffer", 0}, {"byteLength", 16}, {"byteStride", 4}, {"count", 4}, {"mode", "ATTRIBUTES"}}}}}};
      file.root["accessors"].push_back({{"bufferView", view}, {"componentType", 5121}, {"count", 4}, {"type", "VEC4"}});
      file.root["extensionsUsed"] = {"EXT_meshopt_compression"};
      const auto text = file.root.dump();
      const auto result = import_gltf(bytes_of(text), "x");
      ASSERT_FALSE(result) << "the stream is damaged";
      EXPECT_NE(result.error().issue.rule, "buffer-missing");
      for (const ImportIssue& other : result.error().more_errors) EXPECT_NE(other.rule, "buffer-missing");
      for (const ImportIssue& other : result.error().warnings) EXPECT_NE(other.rule, "buffer-unread");
    }
}

TEST(sample_features, G66_a_plain_view_of_a_buffer_that_only_holds_room_is_missed) {
  const auto with_views = [](int unpacked, int plain) {
    Json root = Json::parse(R"({"asset": {"version": "2.0"}, "extensionsUsed": ["EXT_meshopt_compression"]})");
    const Json room{{"byteLength", 16}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}};
    root["buffers"] = {room, room};
    root["bufferViews"] = {
        {{"buffer", unpacked},
         {"byteLength", 16},
         {"extensions",
          {{"EXT_meshopt_compression",
            {{"buffer", 0}, {"byteLength", 16}, {"byteStride", 4}, {"count", 4}, {"mode", "ATTRIBUTES"}}}}}},
        {{"buffer", plain}, {"byteLength", 16}}};
    root["accessors"] = {{{"bufferView", 1}, {"componentType", 5121}, {"count", 4}, {"type", "VEC4"}}};
    const std::string text = root.dump();
    return outcome(import_gltf(bytes_of(text), "x"));
  };
  EXPECT_EQ(with_views(1, 0), "buffer-missing at /bufferViews/1/buffer");
  EXPECT_EQ(with_views(0, 1), "buffer-missing at /bufferViews/1/buffer");
}

TEST(sample_features, one_run_finds_the_errors_after_a_broken_scene_or_too_deep_a_tree) {
  TinyGltf file;
  file.root["scene"] = 7;
  file.root["nodes"] = Json::array({{{"children", {1}}}, {{"children", {2}}}, Json::object()});
  const std::size_t times = file.times({0, 1});
  file.animate("translation", times, times);
  ImportOptions options;
  options.max_node_depth = 2;
  options.collect_all_errors = true;
  const auto result = file.import(options);
  ASSERT_FALSE(result);
  std::vector<std::string> rules{result.error().issue.rule};
  for (const ImportIssue& issue : result.error().more_errors) rules.push_back(issue.rule);
  EXPECT_THAT(rules, testing::UnorderedElementsAre("reference", "too-many", "animation-output"));
}

TEST(sample_features, indices_written_as_fractions_and_minus_zero_are_indices) {
  TinyGltf file;
  file.add_triangle();
  std::string text = file.text();
  const std::string plain = R"("mesh":0)";
  ASSERT_NE(text.find(plain), std::string::npos);
  for (const char* written : {R"("mesh":0.0)", R"("mesh":-0.0)", R"("mesh":0e5)", R"("mesh":-0)"}) {
    std::string other = text;
    other.replace(other.find(plain), plain.size(), written);
    const auto result = import_gltf(bytes_of(other), "x");
    ASSERT_EQ(outcome(result), "ok") << written;
    EXPECT_EQ(result->scene.instances.size(), 1u) << written;
  }
}

}  // namespace
}  // namespace sinew::test
