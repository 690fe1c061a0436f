// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "importer/c/sinew_import.h"
#include "importer/export_glb.h"
#include "importer/import_gltf.h"
#include "runtime/c/handles.h"
#include "tests/c/engine.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/support/scene_equality.h"

namespace sinew::test {
namespace {

std::vector<std::byte> arm_file() { return export_glb(arm_scene()).value(); }

TEST(c_import, a_file_in_memory_gives_the_scene_of_the_cpp_importer) {
  const auto bytes = arm_file();
  sinew_scene* scene = nullptr;
  sinew_messages* messages = nullptr;
  ASSERT_EQ(sinew_import_memory(bytes.data(), bytes.size(), "arm.glb", nullptr, &scene, &messages), SINEW_OK);
  EXPECT_EQ(sinew_message_count(messages), 0u);
  expect_equal(scene->scene, import_gltf(bytes, "arm.glb")->scene);
  EXPECT_EQ(sinew_find_clip(scene, "bend"), 0u);
  engine_numbers numbers{};
  EXPECT_EQ(engine_play(scene, nullptr, nullptr, nullptr, &numbers), SINEW_OK);
  EXPECT_GT(numbers.count, 36u);
  engine_free(&numbers);
  sinew_messages_destroy(messages);
  sinew_scene_destroy(scene);
}

TEST(c_import, a_file_on_disk_is_read_by_its_utf8_path) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) /
      (std::to_string(getpid()) + reinterpret_cast<const char*>(u8"_sinew_c_\u00e4rm.glb"));
  const auto bytes = arm_file();
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  sinew_scene* scene = nullptr;
  EXPECT_EQ(sinew_import_file(reinterpret_cast<const char*>(path.u8string().c_str()), nullptr, &scene, nullptr),
            SINEW_OK);
  ASSERT_NE(scene, nullptr);
  EXPECT_EQ(sinew_joint_count(scene), 3u);
  sinew_scene_destroy(scene);
  std::filesystem::remove(path);
}

TEST(c_import, a_bad_file_says_where_and_why) {
  const std::string text = R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 3}]})";
  sinew_scene* scene = nullptr;
  sinew_messages* messages = nullptr;
  ASSERT_EQ(sinew_import_memory(text.data(), text.size(), "bad.gltf", nullptr, &scene, &messages), SINEW_BAD_FILE);
  EXPECT_EQ(scene, nullptr);
  ASSERT_GE(sinew_message_count(messages), 1u);
  EXPECT_TRUE(std::string(sinew_message(messages, 0)).starts_with("bad.gltf: /nodes/0/mesh"))
      << sinew_message(messages, 0);
  EXPECT_STREQ(sinew_message(messages, sinew_message_count(messages)), "");
  sinew_messages_destroy(messages);
  EXPECT_EQ(sinew_import_memory(text.data(), text.size(), "bad.gltf", nullptr, &scene, nullptr), SINEW_BAD_FILE);
}

/// A file of triangles without normals or tangents, with a normal map in their material.
std::vector<std::byte> bare_file() {
  Scene scene = arm_scene();
  scene.images.push_back({.name = "bumps", .width = 1, .height = 1, .rgba = {128, 128, 255, 255}});
  scene.textures.push_back({.image = 0});
  scene.materials.resize(1);
  scene.materials[0].normal_texture.texture = 0;
  Primitive& arm = scene.meshes[0].primitives[0];
  arm.material = 0;
  arm.normals.clear();
  arm.texcoords = {{{0, 0}, {0, 1}, {1, 0.5f}, {-1, 0.5f}}};
  finish_scene(scene);
  return export_glb(scene).value();
}

TEST(c_import, each_option_does_what_the_cpp_option_of_its_name_does) {
  const auto bytes = bare_file();
  for (std::uint32_t on = 0; on < 16; ++on) {
    sinew_import_options options = sinew_default_import_options();
    options.decode_images = on & 1;
    options.make_normals = on >> 1 & 1;
    options.make_tangents = on >> 2 & 1;
    options.make_centers_of_rotation = on >> 3 & 1;
    sinew_scene* scene = nullptr;
    ASSERT_EQ(sinew_import_memory(bytes.data(), bytes.size(), "bare.glb", &options, &scene, nullptr), SINEW_OK);
    const Primitive& arm = scene->scene.meshes[0].primitives[0];
    EXPECT_EQ(scene->scene.images[0].rgba.empty(), !options.decode_images) << on;
    EXPECT_EQ(arm.normals.empty(), !options.make_normals) << on;
    EXPECT_EQ(arm.centers_of_rotation.empty(), !options.make_centers_of_rotation) << on;
    if (options.make_normals) {
      EXPECT_EQ(arm.tangents.empty(), !options.make_tangents) << on;
    }
    sinew_scene_destroy(scene);
  }
}

TEST(c_import, all_errors_of_a_file_are_told) {
  const std::string text = R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 3}, {"camera": 5}, {"skin": 7}]})";
  sinew_scene* scene = nullptr;
  sinew_messages* messages = nullptr;
  ASSERT_EQ(sinew_import_memory(text.data(), text.size(), "bad.gltf", nullptr, &scene, &messages), SINEW_BAD_FILE);
  const auto own = import_gltf(std::as_bytes(std::span(text)), "bad.gltf");
  ASSERT_FALSE(own);
  EXPECT_GE(own.error().more_errors.size(), 1u);
  ASSERT_EQ(sinew_message_count(messages), 1 + own.error().more_errors.size() + own.error().warnings.size());
  for (std::size_t i = 0; i < own.error().more_errors.size(); ++i)
    EXPECT_EQ(sinew_message(messages, 1 + i), describe("bad.gltf", own.error().more_errors[i]));
  sinew_messages_destroy(messages);
}

TEST(c_import, limits_are_obeyed_and_bad_calls_refused) {
  const auto bytes = arm_file();
  sinew_scene* scene = nullptr;
  sinew_import_options options = sinew_default_import_options();
  options.max_file_bytes = 100;
  EXPECT_EQ(sinew_import_memory(bytes.data(), bytes.size(), "arm.glb", &options, &scene, nullptr), SINEW_BAD_FILE);
  options = sinew_default_import_options();
  options.max_unpacked_bytes = 100;
  EXPECT_EQ(sinew_import_memory(bytes.data(), bytes.size(), "arm.glb", &options, &scene, nullptr), SINEW_BAD_FILE);
  options.struct_size = 1;
  EXPECT_EQ(sinew_import_memory(bytes.data(), bytes.size(), "arm.glb", &options, &scene, nullptr),
            SINEW_WRONG_STRUCT_SIZE);
  EXPECT_EQ(sinew_import_file(nullptr, nullptr, &scene, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_import_file("arm.glb", nullptr, nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_import_memory(nullptr, 4, "arm.glb", nullptr, &scene, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_import_memory(bytes.data(), bytes.size(), nullptr, nullptr, &scene, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_import_memory(bytes.data(), bytes.size(), "arm.glb", nullptr, nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(scene, nullptr);
}

}  // namespace
}  // namespace sinew::test
