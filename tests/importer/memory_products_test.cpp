// SPDX-License-Identifier: MIT
// Files in which one list refers to another's entries many times, so that sizes multiply. However long both lists are,
// an import takes no more than the allowed memory plus a small multiple of the file size.
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "importer/read/memory_budget.h"
#include "runtime/clip/clip_layout.h"
#include "tests/importer/encoded_images.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

constexpr std::uint64_t kAllowed = std::uint64_t{4} << 20;  ///< options.max_unpacked_bytes
constexpr std::size_t kPerByte = 40;  ///< allowance per byte of the file, for JSON trees, document and scene

ImportOptions small_allowance() {
  ImportOptions options;
  options.max_unpacked_bytes = kAllowed;
  return options;
}

Json repeated(std::size_t count, const Json& entry) { return Json::array_t(count, entry); }

/// A clip that moves node 0 by one key.
Json one_key_clip(std::size_t input, std::size_t output) {
  return {{"samplers", {{{"input", input}, {"output", output}}}},
          {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}};
}

/// A mesh with `targets` morph targets on one triangle.
Json morphed_mesh(TinyGltf& file, std::size_t targets) {
  const std::size_t position = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0}), moved = file.vec3({0, 0, 0, 0, 0, 0, 0, 0, 0});
  return {{"primitives",
           {{{"attributes", {{"POSITION", position}}}, {"targets", repeated(targets, {{"POSITION", moved}})}}}}};
}

TinyGltf clips_times_nodes() {
  TinyGltf file;
  const std::size_t input = file.times({0}), output = file.vec3({1, 2, 3});
  file.root["nodes"] = repeated(4000, Json::object());
  file.root["animations"] = repeated(2000, one_key_clip(input, output));
  return file;
}

TinyGltf clips_times_weights() {
  TinyGltf file;
  file.root["meshes"] = Json::array({morphed_mesh(file, 500)});
  file.root["nodes"] = repeated(500, {{"mesh", 0}});
  file.root["animations"] = repeated(400, one_key_clip(file.times({0}), file.vec3({1, 2, 3})));
  return file;
}

TinyGltf nodes_times_weights() {
  TinyGltf file;
  file.root["meshes"] = Json::array({morphed_mesh(file, 5000)});
  file.root["nodes"] = repeated(5000, {{"mesh", 0}});
  return file;
}

TinyGltf primitives_times_targets() {
  TinyGltf file;
  file.root["meshes"] = Json::array({morphed_mesh(file, 3000)});
  Json plain = file.root["meshes"][0]["primitives"][0];
  plain.erase("targets");
  for (int i = 0; i < 3000; ++i) file.root["meshes"][0]["primitives"].push_back(plain);
  return file;
}

TinyGltf clips_times_properties() {
  TinyGltf file;
  const std::size_t input = file.times({0}), output = file.scalars({0.5f});
  file.root["materials"] = repeated(3000, Json::object());
  Json clip{{"samplers", {{{"input", input}, {"output", output}, {"interpolation", "STEP"}}}},
            {"channels", Json::array()}};
  for (int m = 0; m < 3000; ++m) {
    const std::string target = "/materials/" + std::to_string(m) + "/alphaCutoff";
    clip["channels"].push_back(
        {{"sampler", 0},
         {"target", {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", target}}}}}}}});
  }
  file.root["animations"] = repeated(1, clip);
  for (int c = 0; c < 1000; ++c) file.root["animations"].push_back(one_key_clip(input, file.root["accessors"].size()));
  file.vec3({1, 2, 3});
  file.root["nodes"] = repeated(1, Json::object());
  return file;
}

TinyGltf nodes_times_light_name() {
  TinyGltf file;
  const Json light{{"type", "point"}, {"name", std::string(20'000, 'n')}};
  file.root["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({light});
  file.root["nodes"] = repeated(5000, {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  return file;
}

TinyGltf nodes_times_camera_name() {
  TinyGltf file;
  file.root["cameras"] = Json::array(
      {{{"name", std::string(20'000, 'n')}, {"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}});
  file.root["nodes"] = repeated(5000, {{"camera", 0}});
  return file;
}

TinyGltf primitives_times_accessor() {
  TinyGltf file;
  const std::size_t position = file.vec3(std::vector<float>(30'000, 1.0f));
  file.root["meshes"] =
      Json::array({{{"primitives", repeated(2000, {{"attributes", {{"POSITION", position}}}, {"mode", 0}})}}});
  return file;
}

TinyGltf channels_times_keys() {
  TinyGltf file;
  std::vector<float> times(10'000);
  for (std::size_t k = 0; k < times.size(); ++k) times[k] = static_cast<float>(k);
  const std::size_t input = file.times(times), output = file.vec3(std::vector<float>(30'000, 1.0f));
  file.root["nodes"] = repeated(1000, Json::object());
  Json clip = one_key_clip(input, output);
  for (int n = 1; n < 1000; ++n) {
    clip["channels"].push_back(clip["channels"][0]);
    clip["channels"].back()["target"]["node"] = n;
  }
  file.root["animations"] = Json::array({clip});
  return file;
}

TinyGltf skins_times_matrices() {
  TinyGltf file;
  const std::size_t matrices = file.add(std::vector<float>(16 * 2000, 1.0f), "MAT4", 5126, 16);
  file.root["nodes"] = repeated(2, Json::object());
  file.root["skins"] = repeated(2000, {{"joints", {0, 1}}, {"inverseBindMatrices", matrices}});
  return file;
}

TinyGltf nodes_times_copies() {
  TinyGltf file;
  file.add_triangle();
  const std::size_t places = file.vec3(std::vector<float>(30'000, 1.0f));
  const Json copies{{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", places}}}}}};
  file.root["nodes"] = repeated(1000, {{"mesh", 0}, {"extensions", copies}});
  return file;
}

TinyGltf expressions_times_nodes() {
  TinyGltf file;
  file.root["meshes"] = Json::array({morphed_mesh(file, 1)});
  file.root["nodes"] = repeated(5000, {{"mesh", 0}});
  const Json group{{"name", "a"}, {"binds", repeated(5000, {{"mesh", 0}, {"index", 0}, {"weight", 50}})}};
  file.root["extensions"]["VRM"]["blendShapeMaster"]["blendShapeGroups"] = Json::array({group});
  return file;
}

TinyGltf springs_times_colliders() {
  TinyGltf file;
  file.root["nodes"] = repeated(1, Json::object());
  Json& springs = file.root["extensions"]["VRMC_springBone"];
  springs["colliders"] = repeated(1, {{"node", 0}, {"shape", {{"sphere", {{"radius", 1}}}}}});
  springs["colliderGroups"] = repeated(1, {{"colliders", Json(std::vector<int>(5000, 0))}});
  springs["springs"] = repeated(5000, {{"colliderGroups", {0}}});
  return file;
}

struct Product {
  const char* name;
  TinyGltf (*make)();
};
constexpr Product kProducts[] = {{"clips x nodes", clips_times_nodes},
                                 {"clips x weights", clips_times_weights},
                                 {"clips x properties", clips_times_properties},
                                 {"nodes x weights", nodes_times_weights},
                                 {"nodes x name of a light", nodes_times_light_name},
                                 {"nodes x name of a camera", nodes_times_camera_name},
                                 {"nodes x copies", nodes_times_copies},
                                 {"primitives x targets", primitives_times_targets},
                                 {"primitives x accessor", primitives_times_accessor},
                                 {"channels x keys", channels_times_keys},
                                 {"skins x matrices", skins_times_matrices},
                                 {"expressions x nodes", expressions_times_nodes},
                                 {"springs x colliders", springs_times_colliders}};

TEST(memory_products, G68_no_two_lists_multiply) {
  for (const Product& product : kProducts) {
    const std::string text = product.make().text();
    ImportOptions options = small_allowance();
    options.thorough = true;
    const PeakMemory peak;
    const auto result = import_gltf(bytes_of(text), "product", options);
    EXPECT_LT(peak.bytes(), kAllowed + kPerByte * text.size()) << product.name << ": " << text.size() << " bytes";
  }
}

/// With a larger allowance the same files load: it is the limit that refuses them.
TEST(memory_products, G68_what_is_allowed_grows_with_the_file_up_to_the_limit) {
  constexpr std::uint64_t kFree = std::uint64_t{64} << 20, kMost = std::uint64_t{1} << 50;
  EXPECT_EQ(allowed_bytes(0, kMost), kFree);
  EXPECT_EQ(allowed_bytes(1000, kMost), kFree + 64'000);
  EXPECT_EQ(allowed_bytes(std::uint64_t{1} << 60, kMost), kFree + (std::uint64_t{64} << 40)) << "no overflow";
  EXPECT_EQ(allowed_bytes(1000, 5), 5u);
}

TEST(memory_products, G68_large_products_name_the_limit) {
  for (const Product& product : {kProducts[3], kProducts[7], kProducts[9]}) {
    const auto result = import_gltf(bytes_of(product.make().text()), "product", small_allowance());
    EXPECT_EQ(outcome(result), "memory-budget at ") << product.name;
  }
}

TEST(memory_products, clips_take_memory_for_what_they_move_not_for_all_nodes_weights_and_properties) {
  for (const Product& product : {kProducts[0], kProducts[1], kProducts[2]}) {
    const auto result = import_gltf(bytes_of(product.make().text()), "product", small_allowance());
    ASSERT_EQ(outcome(result), "ok") << product.name;
    std::size_t bytes = 0;
    for (const Clip& clip : result->scene.clips) bytes += clip.byte_size();
    EXPECT_LT(bytes, 400 * result->scene.clips.size()) << product.name;
    const ClipLayout& first = result->scene.clips.front().layout();
    for (const Clip& clip : result->scene.clips) {
      EXPECT_EQ(clip.layout().base_pose.rest(), first.base_pose.rest()) << product.name;
      EXPECT_EQ(clip.layout().base_weights.rest(), first.base_weights.rest()) << product.name;
    }
  }
}

/// An entry of two characters takes two thousand bytes once it is read. A few are accepted; many are refused before
/// they are read.
TEST(memory_products, G68_entries_of_few_characters_are_counted_before_they_are_read) {
  TinyGltf file;
  file.root["materials"] = repeated(60'000, Json::object());
  const std::string text = file.text();
  const PeakMemory peak;
  EXPECT_EQ(outcome(import_gltf(bytes_of(text), "materials")), "memory-budget at ");
  EXPECT_LT(peak.bytes(), (std::size_t{1} << 20) + kPerByte * text.size());
  file.root["materials"] = repeated(20'000, Json::object());
  EXPECT_EQ(outcome(file.import()), "ok");
}

TEST(memory_products, names_of_cameras_and_lights_exist_once_however_many_nodes_place_them) {
  const auto lights = import_gltf(bytes_of(nodes_times_light_name().text()), "lights", small_allowance());
  ASSERT_EQ(outcome(lights), "ok");
  ASSERT_EQ(lights->scene.lights.size(), 5000u);
  for (const Light& light : lights->scene.lights) EXPECT_EQ(&light.name.str(), &lights->scene.lights[0].name.str());
  EXPECT_EQ(lights->scene.lights[4999].name.str(), std::string(20'000, 'n'));
  const auto cameras = import_gltf(bytes_of(nodes_times_camera_name().text()), "cameras", small_allowance());
  ASSERT_EQ(outcome(cameras), "ok");
  ASSERT_EQ(cameras->scene.cameras.size(), 5000u);
  for (const Camera& camera : cameras->scene.cameras)
    EXPECT_EQ(&camera.name.str(), &cameras->scene.cameras[0].name.str());
}

TEST(memory_products, clips_of_a_real_size_stay_within_the_limit) {
  TinyGltf file;
  const std::size_t input = file.times({0}), output = file.vec3({1, 2, 3});
  file.root["nodes"] = repeated(300, Json::object());
  file.root["animations"] = repeated(200, one_key_clip(input, output));
  EXPECT_EQ(outcome(file.import()), "ok");
}

TEST(memory_products, many_images_on_one_view_are_decoded_once) {
  TinyGltf file;
  const std::size_t view = file.add_view(encode_png(256, 256, 4, std::vector<std::uint8_t>(256 * 256 * 4, 9)));
  file.root["images"] = repeated(400, {{"bufferView", view}, {"mimeType", "image/png"}});
  for (int t = 0; t < 400; ++t) file.root["textures"].push_back({{"source", t}});
  const std::string text = file.text();
  const PeakMemory peak;
  const auto result = import_gltf(bytes_of(text), "images");
  EXPECT_LT(peak.bytes(), (std::size_t{2} << 20) + kPerByte * text.size());
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_TRUE(result->warnings.empty());
  EXPECT_EQ(result->scene.images[0].rgba.size(), 256u * 256 * 4);
  for (const Texture& texture : result->scene.textures) EXPECT_EQ(texture.image, 0u);
}

TEST(memory_products, a_file_that_many_uris_name_is_read_once) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("sinew-products-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  constexpr std::size_t kSize = std::size_t{1} << 20;
  std::ofstream(folder / "a.bin", std::ios::binary) << std::string(kSize, 'a');
  fs::create_hard_link(folder / "a.bin", folder / "b.bin");
  fs::create_symlink("a.bin", folder / "c.bin");
  TinyGltf file;
  for (int i = 0; i < 300; ++i)
    for (const char* name : {"a.bin", "./a.bin", "%61.bin", "b.bin", "c.bin"})
      file.root["buffers"].push_back({{"byteLength", kSize}, {"uri", name}});
  std::ofstream(folder / "x.gltf") << file.text();
  const PeakMemory peak;
  const auto result = import_gltf(folder / "x.gltf");
  EXPECT_LT(peak.bytes(), 2 * kSize + kPerByte * file.text().size());
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_EQ(result->facts.file_bytes, kSize + fs::file_size(folder / "x.gltf"));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace sinew::test
