// SPDX-License-Identifier: MIT
#include "importer/rewrite_gltf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <utility>

#include "importer/rewrite/references.h"
#include "tests/importer/rewritten.h"
#include "tests/importer/tiny_draco.h"
#include "tests/support/scene_equality.h"

namespace sinew::test {
namespace {

using testing::HasSubstr;

Json extras(int at) { return {{"at", at}, {"list", {1, 2.5, "three", nullptr, {{"deep", true}}}}}; }

/// A file with unknown and unused properties at every level.
TinyGltf strange_file() {
  TinyGltf gltf;
  Json& primitive =
      gltf.add_skinned_triangle({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  Json& root = gltf.root;
  primitive["attributes"]["_HEAT"] = gltf.scalars({3, 1, 4});
  primitive["attributes"]["COLOR_1"] = gltf.vec3({1, 0, 0, 0, 1, 0, 0, 0, 1});
  primitive["attributes"]["TEXCOORD_2"] = gltf.add<float>({0, 0, 1, 0, 0, 1}, "VEC2", 5126, 2);
  primitive["extras"] = extras(1);
  primitive["extensions"]["NOT_A_primitive"] = {{"strength", 0.25}};
  root["accessors"].push_back({{"componentType", 5126}, {"count", 7}, {"type", "SCALAR"}, {"name", "unused"}});
  root["asset"] = {{"version", "2.0"}, {"generator", "by hand"}, {"copyright", "nobody"}, {"extras", extras(2)}};
  root["extras"] = extras(3);
  root["extensions"]["NOT_A_root"] = {{"nodes", {2, 0}}, {"image", 0}, {"bytes", 1}};
  root["nodes"][1]["extras"] = extras(4);
  root["nodes"][2]["extensions"]["NOT_A_node"] = Json::object();
  root["meshes"][0]["extras"] = extras(5);
  root["skins"][0]["name"] = "bones";
  root["cameras"] = {{{"type", "perspective"}, {"name", "unused"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.125}}}}};
  root["extensions"]["KHR_lights_punctual"] = {
      {"lights", {{{"type", "point"}, {"name", "unused"}, {"extras", extras(6)}}}}};
  root["samplers"] = {{{"name", "sharp"}, {"magFilter", 9728}}, {{"name", "unused"}}};
  root["textures"] = {{{"name", "skin of a frog"}, {"sampler", 0}, {"source", 0}, {"extras", extras(7)}},
                      {{"extensions", {{"KHR_texture_basisu", {{"source", 1}}}}}}};
  root["images"] = {{{"name", "kept"}, {"uri", "data:image/png;base64,iVBORw0KGgo="}},
                    {{"uri", "data:image/ktx2;base64,q0tUWCAyMLsNChoK"}, {"extras", extras(8)}}};
  root["materials"] = {
      {{"extensions",
        {{"KHR_materials_transmission", {{"transmissionFactor", 0.5}, {"transmissionTexture", {{"index", 1}}}}},
         {"KHR_materials_ior", {{"ior", 1.25}}}}},
       {"extras", extras(9)}}};
  root["scenes"] = {{{"name", "first"}, {"nodes", {0, 1}}, {"extras", extras(10)}}};
  gltf.animate("translation", gltf.times({0, 1}), gltf.vec3({0, 0, 0, 1, 0, 0}));
  root["animations"][0]["samplers"][0]["extras"] = extras(11);
  root["animations"][0]["channels"].push_back(
      {{"sampler", 0},
       {"target",
        {{"path", "pointer"},
         {"extensions",
          {{"KHR_animation_pointer", {{"pointer", "/materials/0/extensions/KHR_materials_ior/ior"}}}}}}}});
  root["extensionsUsed"] = {"NOT_A_root",         "NOT_A_node",           "NOT_A_primitive",
                            "KHR_texture_basisu", "KHR_lights_punctual",  "KHR_materials_transmission",
                            "KHR_materials_ior",  "KHR_animation_pointer"};
  return gltf;
}

TEST(rewrite_gltf, carries_all_that_the_importer_does_not_know_or_use) {
  const TinyGltf gltf = strange_file();
  const GlbParts out = rewritten(gltf);
  Json before = gltf.root;
  for (Json& image : before["images"]) image.erase("uri");
  Json after = out.json;
  EXPECT_EQ(after["images"][0]["mimeType"], "image/png");
  EXPECT_EQ(after["images"][1]["mimeType"], "image/ktx2");
  EXPECT_EQ(out.view(after["images"][1]["bufferView"])[1], std::byte{'K'}) << "encoded images keep their bytes";
  for (Json& image : after["images"]) {
    image.erase("mimeType");
    image.erase("bufferView");
  }
  EXPECT_EQ(Json::diff(without_places(before), without_places(after)), Json::array());
}

TEST(rewrite_gltf, G24_elements_keep_their_bytes_whatever_reads_them) {
  const TinyGltf gltf = strange_file();
  const Json source = Json::parse(gltf.text());
  const GlbParts out = rewritten(gltf);
  const auto before = gltf.import(carrying()), after = import_gltf(rewrite(gltf)->file, "after.glb", carrying());
  ASSERT_TRUE(before && after);
  expect_equal(before->scene, after->scene);
  const std::vector<float> heat{3, 1, 4};
  const auto bytes =
      out.view(source["accessors"][source["meshes"][0]["primitives"][0]["attributes"]["_HEAT"].get<std::size_t>()]
                     ["bufferView"]);
  EXPECT_EQ(std::memcmp(bytes.data(), heat.data(), bytes.size()), 0);
}

TEST(rewrite_gltf, changes_no_byte_of_what_it_wrote) {
  for (const TinyGltf& gltf : {strange_file(), draco_document({{"POSITION", {0, 0, 0, 1, 0, 0, 0, 1, 0}}})}) {
    const auto once = rewrite(gltf);
    ASSERT_TRUE(once) << once.error().issue.detail;
    const auto again = import_gltf(once->file, "once.glb", carrying());
    ASSERT_TRUE(again);
    const auto twice = rewrite_gltf(*again);
    ASSERT_TRUE(twice);
    EXPECT_TRUE(once->file == twice->file);
  }
}

TEST(rewrite_gltf, views_without_bytes_name_a_buffer_that_is_there) {
  TinyGltf gltf;
  gltf.root = {{"asset", {{"version", "2.0"}}},
               {"buffers", {{{"byteLength", 1}}}},
               {"bufferViews", {{{"buffer", 0}, {"byteLength", 0}}}}};
  const auto once = rewrite(gltf);
  ASSERT_TRUE(once) << once.error().issue.detail;
  EXPECT_EQ(split_glb(once->file).json["buffers"], Json({{{"byteLength", 4}}}));
  const auto again = import_gltf(once->file, "once.glb", carrying());
  ASSERT_TRUE(again) << "the view names a buffer";
  EXPECT_TRUE(rewrite_gltf(*again)->file == once->file);
}

TEST(rewrite_gltf, views_whose_buffer_is_missing_hold_nothing_where_something_names_them) {
  TinyGltf gltf;
  gltf.add_triangle();
  Json whole = Json::parse(gltf.text());
  whole["buffers"].push_back({{"byteLength", 8}});
  whole["bufferViews"].push_back({{"buffer", 1}, {"byteOffset", 4}, {"byteLength", 4}});
  whole["extensions"]["NOT_A_root"] = {{"bufferView", whole["bufferViews"].size() - 1}};
  whole["extensionsUsed"] = {"NOT_A_root"};
  const std::string text = whole.dump();
  const auto file = import_gltf(bytes_of(text), "file.gltf", carrying());
  ASSERT_EQ(outcome(file), "ok");
  RewriteOptions options;
  options.drop = {"all"};
  const auto again = rewrite_gltf(*file, options);
  ASSERT_TRUE(again) << again.error().issue.detail;
  EXPECT_EQ(split_glb(again->file).json["bufferViews"],
            Json::parse(R"([{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteLength": 0}])"));
}

TEST(rewrite_gltf, writes_text_and_a_buffer_that_say_the_same_as_a_glb) {
  const TinyGltf gltf = strange_file();
  RewriteOptions options;
  options.buffer_uri = "model.bin";
  const auto pair = rewrite(gltf, options);
  ASSERT_TRUE(pair);
  const GlbParts glb = rewritten(gltf);
  Json text = Json::parse(reinterpret_cast<const char*>(pair->file.data()),
                          reinterpret_cast<const char*>(pair->file.data() + pair->file.size()));
  EXPECT_EQ(text["buffers"][0]["uri"], "model.bin");
  text["buffers"][0].erase("uri");
  EXPECT_EQ(text, glb.json);
  EXPECT_TRUE(std::equal(pair->buffer.begin(), pair->buffer.end(), glb.bin.begin()));
}

/// The rule or extension that makes the rewrite fail; "carried" if it succeeds.
std::string refused(const TinyGltf& gltf, const std::set<std::string>& drop = {}) {
  RewriteOptions options;
  options.drop = drop;
  const auto out = rewrite(gltf, options);
  if (out) return "carried";
  EXPECT_EQ(out.error().issue.rule, "not-carried");
  return out.error().issue.detail.substr(0, out.error().issue.detail.find(':'));
}

TEST(rewrite_gltf, G66_refuses_a_missing_image_unless_it_may_be_dropped) {
  TinyGltf gltf;
  gltf.root["images"] = {{{"uri", "data:image/png;base64,iVBORw0KGgo="}}, {{"uri", "nowhere.png"}, {"name", "gone"}}};
  EXPECT_EQ(refused(gltf), "image-missing");
  EXPECT_EQ(refused(gltf, {"json-duplicate"}), "image-missing");
  EXPECT_EQ(refused(gltf, {"all"}), "carried");
  RewriteOptions options;
  options.drop = {"image-missing"};
  const auto out = rewrite(gltf, options);
  ASSERT_TRUE(out);
  ASSERT_EQ(out->drops.size(), 1u);
  EXPECT_EQ(out->drops[0].json_pointer, "/images/1");
  EXPECT_EQ(split_glb(out->file).json["images"][1], (Json{{"uri", "nowhere.png"}, {"name", "gone"}}))
      << "no placeholder";
}

TEST(rewrite_gltf, images_take_the_name_of_their_file_where_they_have_none) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("sinew-images-" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  for (const char* name : {"red wall.png", "second.png"}) std::ofstream(folder / name) << "\x89PNG\r\n\x1a\n";
  std::ofstream(folder / "model.gltf") << R"({"asset": {"version": "2.0"}, "images": [
      {"uri": "red%20wall.png"}, {"uri": "second.png", "name": "named"}]})";
  const auto file = import_gltf(folder / "model.gltf", carrying());
  std::filesystem::remove_all(folder);
  ASSERT_TRUE(file) << file.error().issue.detail;
  const auto out = rewrite_gltf(*file);
  ASSERT_TRUE(out) << out.error().issue.detail;
  const Json images = split_glb(out->file).json["images"];
  EXPECT_EQ(images[0]["name"], "red wall");
  EXPECT_EQ(images[1]["name"], "named");
}

TEST(rewrite_gltf, images_keep_the_type_that_their_uri_says_where_their_bytes_say_none) {
  TinyGltf gltf;
  gltf.root["images"] = {{{"uri", "data:image/png;base64,AAAA"}}, {{"uri", "data:image/jpeg;base64,iVBORw0KGgo="}}};
  const Json images = rewritten(gltf).json["images"];
  EXPECT_EQ(images[0]["mimeType"], "image/png");
  EXPECT_EQ(images[1]["mimeType"], "image/png") << "by its bytes";
}

TEST(rewrite_gltf, lists_what_lies_outside_of_the_document) {
  TinyGltf gltf;
  gltf.root["bufferViews"] = {{{"buffer", 0}, {"byteLength", 4}}};
  gltf.root["buffers"] = {{{"byteLength", 4}}};
  EXPECT_EQ(refused(gltf), "buffer-unread");
  const std::string twice = R"({"asset":{"version":"2.0"},"nodes":[{"name":"a","name":"b"}]})";
  const auto file = import_gltf(bytes_of(twice), "twice.gltf", carrying());
  ASSERT_TRUE(file);
  const auto out = rewrite_gltf(*file);
  ASSERT_FALSE(out);
  EXPECT_THAT(out.error().issue.detail, HasSubstr("json-duplicate"));
}

TEST(rewrite_gltf, lists_what_lies_behind_a_glb_and_may_drop_it) {
  TinyGltf gltf;
  gltf.add_triangle();
  const std::vector<std::byte> whole = rewrite(gltf)->file;
  std::vector<std::byte> longer = whole;
  longer.insert(longer.end(), 4, std::byte{7});
  const auto file = import_gltf(longer, "longer.glb", carrying());
  ASSERT_TRUE(file);
  const auto refused = rewrite_gltf(*file);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().issue.rule, "not-carried");
  EXPECT_THAT(refused.error().issue.detail, HasSubstr("glb-extra-data: "));
  EXPECT_TRUE(refused.error().more_errors.empty());
  RewriteOptions options;
  options.drop = {"glb-extra-data"};
  const auto dropped = rewrite_gltf(*file, options);
  ASSERT_TRUE(dropped);
  EXPECT_EQ(dropped->file, whole);
  ASSERT_EQ(dropped->drops.size(), 1u);
  EXPECT_EQ(dropped->drops[0].severity, Severity::warning);
}

TEST(rewrite_gltf, refuses_extensions_that_name_places_in_a_buffer) {
  TinyGltf gltf;
  gltf.add_triangle();
  gltf.root["bufferViews"][0]["extensions"]["NOT_A_codec"] = {{"buffer", 0}, {"byteOffset", 4}};
  EXPECT_EQ(refused(gltf), "NOT_A_codec");
  EXPECT_EQ(refused(gltf, {"NOT_A_codec"}), "carried");
}

TEST(rewrite_gltf, merges_buffers_and_lists_the_properties_that_get_lost) {
  TinyGltf gltf;
  gltf.root["buffers"] = {{{"byteLength", 3}, {"uri", "data:;base64,AQID"}, {"name", "first"}},
                          {{"byteLength", 3}, {"uri", "data:;base64,BAUG"}}};
  gltf.root["bufferViews"] = {{{"buffer", 1}, {"byteLength", 2}, {"byteOffset", 1}},
                              {{"buffer", 0}, {"byteLength", 3}}};
  const GlbParts out = rewritten(gltf);
  EXPECT_EQ(out.json["buffers"], (Json::array({{{"byteLength", 7}, {"name", "first"}}})));
  EXPECT_EQ(out.view(0), (std::vector<std::byte>{std::byte{5}, std::byte{6}}));
  EXPECT_EQ(out.json["bufferViews"][0]["byteOffset"], 5) << "offsets keep their place modulo 4";
  gltf.root["buffers"][1]["extras"] = "said";
  EXPECT_EQ(refused(gltf), "buffer-properties");
}

TEST(rewrite_gltf, shared_bytes_stay_shared_and_bytes_without_a_view_go) {
  TinyGltf gltf;
  gltf.root["buffers"] = {{{"byteLength", 9}, {"uri", "data:;base64,AAECAwQFBgcI"}}};
  gltf.root["bufferViews"] = {{{"buffer", 0}, {"byteLength", 4}, {"byteOffset", 4}},
                              {{"buffer", 0}, {"byteLength", 2}, {"byteOffset", 6}},
                              {{"buffer", 0}, {"byteLength", 4}, {"byteOffset", 4}}};
  const GlbParts out = rewritten(gltf);
  EXPECT_EQ(out.json["buffers"][0]["byteLength"], 4);
  EXPECT_EQ(out.json["bufferViews"][1]["byteOffset"], 2);
  EXPECT_EQ(out.view(2)[0], std::byte{4});
}

TEST(rewrite_gltf, a_view_within_another_cuts_nothing_off) {
  TinyGltf gltf;
  gltf.root["buffers"] = {{{"byteLength", 9}, {"uri", "data:;base64,AAECAwQFBgcI"}}};
  gltf.root["bufferViews"] = {{{"buffer", 0}, {"byteLength", 9}},
                              {{"buffer", 0}, {"byteLength", 1}, {"byteOffset", 1}},
                              {{"buffer", 0}, {"byteLength", 4}, {"byteOffset", 4}}};
  const GlbParts out = rewritten(gltf);
  EXPECT_EQ(out.json["buffers"][0]["byteLength"], 9);
  for (const auto& [view, first] : {std::pair(0u, 0), {1u, 1}, {2u, 4}})
    for (int i = 0; const std::byte byte : out.view(view)) EXPECT_EQ(byte, std::byte(first + i++)) << view;
}

TEST(rewrite_gltf, completes_what_gltf_demands) {
  TinyGltf gltf;
  gltf.add_triangle();
  gltf.root["skins"] = {{{"joints", Json::array()}}};
  gltf.root["animations"] = Json::array();
  gltf.root["cameras"] = {
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 2}, {"ymag", 2}, {"znear", 1}, {"zfar", 0}}}}};
  const Json out = rewritten(gltf).json;
  EXPECT_EQ(out["skins"][0]["joints"], Json::array({0}));
  EXPECT_FALSE(out.contains("animations"));
  EXPECT_EQ(out["cameras"][0]["orthographic"]["zfar"], 10001.0);
}

TEST(rewrite_gltf, attributes_that_are_left_out_go_from_every_primitive) {
  TinyGltf gltf;
  gltf.add_triangle();
  Json& primitives = gltf.root["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  for (Json& primitive : primitives) primitive["attributes"]["_HEAT"] = gltf.scalars({3, 1, 4});
  gltf.root["meshes"].push_back(gltf.root["meshes"][0]);
  const std::vector<std::string> names{"_HEAT"};
  RewriteOptions options;
  options.left_out_attributes = names;
  const Json out = rewritten(gltf, options).json;
  for (const Json& mesh : out["meshes"])
    for (const Json& primitive : mesh["primitives"]) EXPECT_EQ(primitive["attributes"], (Json{{"POSITION", 0}}));
  EXPECT_EQ(out["accessors"].size(), 1u);
  EXPECT_EQ(out["buffers"][0]["byteLength"], 36);
}

TEST(rewrite_gltf, references_in_extensions_are_those_of_the_table_and_of_telling_names) {
  Json root = Json::parse(R"({"meshes": [{"extensions": {
      "EXT_mesh_manifold": {"mergeIndices": 11, "other": 3, "manifoldPrimitive": {"indices": 12, "mode": 4}}}}],
    "extensions": {"EXT_structural_metadata": {"propertyTables": [{"properties": {"a": {"values": 21, "count": 9}}}]},
      "KHR_audio_of_some_kind": {"accessor": 13, "level": 5, "inner": [{"bufferView": 22, "accessor": 14}],
                                 "extras": {"accessor": 99}}}})");
  std::multiset<std::pair<int, int>> seen;
  rewrite::for_each_reference(root, [&](rewrite::Referenced kind, Json& index) {
    seen.insert({static_cast<int>(kind), index.get<int>()});
    index = 0;
  });
  const int accessor = static_cast<int>(rewrite::Referenced::accessor),
            view = static_cast<int>(rewrite::Referenced::view);
  EXPECT_EQ(seen, (std::multiset<std::pair<int, int>>{
                      {accessor, 11}, {accessor, 12}, {accessor, 13}, {accessor, 14}, {view, 21}, {view, 22}}));
  EXPECT_EQ(root["extensions"]["KHR_audio_of_some_kind"]["level"], 5);
  EXPECT_EQ(root["extensions"]["KHR_audio_of_some_kind"]["extras"]["accessor"], 99);
}

TEST(rewrite_gltf, G62_draco_moves_entries_and_refuses_numbers_that_may_name_them) {
  TinyGltf gltf = draco_document({{"POSITION", {0, 0, 0, 1, 0, 0, 0, 1, 0}}});
  gltf.root["images"] = {
      {{"bufferView", gltf.add_view(std::vector<std::uint8_t>{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'})}}};
  gltf.root["extensions"]["NOT_A_sound"] = {{"bufferView", 1}, {"level", 0.5}};
  EXPECT_EQ(refused(gltf), "NOT_A_sound");
  gltf.root["extensions"] = {{"VRMC_vrm", {{"meta", {{"thumbnailImage", 0}}}}},
                             {"MSFT_audio_emitter", {{"clips", {{{"bufferView", 1}}}}}}};
  const GlbParts out = rewritten(gltf);
  const Json& image = out.json["images"][0];
  EXPECT_EQ(image["bufferView"], 0) << "the stream of the primitive has gone";
  EXPECT_EQ(out.json["extensions"]["MSFT_audio_emitter"]["clips"][0]["bufferView"], 0);
  EXPECT_EQ(out.view(0)[1], std::byte{'P'});
}

}  // namespace
}  // namespace sinew::test
