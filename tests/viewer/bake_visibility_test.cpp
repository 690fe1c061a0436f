// SPDX-License-Identifier: MIT
#include "viewer/app/bake_visibility.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "importer/ambient/visibility_surfaces.h"
#include "importer/import_gltf.h"
#include "samples/showcase/showcase.h"
#include "viewer/app/clip_poses.h"

namespace sinew::viewer {
namespace {

LoadedScene arms() {
  LoadedScene loaded;
  loaded.name = "arms";
  loaded.scene = showcase::twisted_arms().scene;
  return loaded;
}

/// The ambient visibility of a single pose, with the default ray length of the clip's first pose.
MeshVisibility baked(const Scene& scene, std::uint32_t clip, double time_s) {
  VisibilityOptions how;
  const double times[] = {0.0, time_s};
  bool first = true;
  MeshVisibility visibility;
  for_each_pose(scene, clip, nullptr, times, [&](const FrameResult& pose) {
    if (first) how.distance_m = default_visibility_distance_m(scene, pose);
    first = false;
    visibility = bake_mesh_visibility(scene, pose, how);
  });
  return visibility;
}

TEST(bake_visibility, key_poses_are_spread_over_the_clip_one_after_another) {
  LoadedScene loaded = arms();
  loaded.scene.animations[0].duration_s *= 0.4;  // the motion is symmetric in time, so use only part of it
  const double duration = loaded.scene.animations[0].duration_s;
  std::vector<std::string> messages;
  std::vector<double> told;
  ASSERT_TRUE(bake_missing_visibility(
      loaded, {4, 0}, [&](const std::string& line) { messages.push_back(line); },
      [&](double part) { told.push_back(part); }));
  ASSERT_TRUE(loaded.visibility);
  EXPECT_EQ(loaded.visibility->clip, 0u);
  EXPECT_THAT(loaded.visibility->times_s, testing::ElementsAre(0.0, duration / 3, duration * 2 / 3, duration));
  const MeshVisibility second = baked(loaded.scene, 0, duration / 3);
  for (std::size_t m = 0; m < loaded.scene.meshes.size(); ++m) {
    const std::vector<float>&all = loaded.visibility->values[m][0], &own = second[m][0];
    const std::size_t vertices = loaded.scene.meshes[m].primitives[0].vertex_count();
    if (own.empty()) continue;
    ASSERT_EQ(all.size(), 4 * vertices);
    EXPECT_TRUE(std::equal(own.begin(), own.end(), all.begin() + static_cast<std::ptrdiff_t>(vertices)));
  }
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_THAT(messages[0],
              testing::MatchesRegex("arms: ambient visibility of 4 key poses, 256 rays a vertex, baked in .* s"));
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1.0);
}

TEST(bake_visibility, one_pose_is_the_rest_pose_and_what_is_there_stays) {
  LoadedScene loaded = arms();
  int messages = 0;
  const auto log_line = [&](const std::string&) { ++messages; };
  ASSERT_TRUE(bake_missing_visibility(loaded, {1, 0}, log_line));
  EXPECT_EQ(loaded.visibility->clip, kNone);
  const MeshVisibility rest = baked(loaded.scene, kNone, 0.0);
  for (std::size_t m = 0; m < rest.size(); ++m) {
    if (!rest[m][0].empty()) {
      EXPECT_EQ(loaded.visibility->values[m][0], rest[m][0]);
    }
  }
  const auto before = loaded.visibility;
  ASSERT_TRUE(bake_missing_visibility(loaded, {4, 0}, log_line));
  EXPECT_EQ(loaded.visibility, before);
  EXPECT_EQ(messages, 1);
}

/// A triangle; `attribute` are members added to its attributes. All accessors read the position data.
ImportResult<ImportedFile> triangle_with(const std::string& attribute) {
  const std::string json =
      R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0)" +
      attribute + R"(}}]}],
      "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
      {"bufferView":0,"componentType":5126,"count":3,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteLength":36}],
      "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
  ImportOptions options;
  options.carry_document = true;
  return import_gltf(std::as_bytes(std::span(json)), "triangle.gltf", options);
}

TEST(bake_visibility, without_a_clip_there_is_one_pose_however_many_are_asked_for) {
  LoadedScene loaded;
  loaded.scene = triangle_with("").value().scene;
  ASSERT_TRUE(bake_missing_visibility(loaded, {4, kNone}, [](const std::string&) {}));
  EXPECT_THAT(loaded.visibility->times_s, testing::ElementsAre(0.0));
  EXPECT_EQ(loaded.visibility->clip, kNone);
}

TEST(bake_visibility, of_a_file_is_what_its_vertices_have) {
  std::vector<std::string> messages;
  const auto log_line = [&](const std::string& line) { messages.push_back(line); };
  const auto without = triangle_with(""), with = triangle_with(R"(,"_AMBIENT_ACCESS":1)");
  ASSERT_TRUE(without && with);
  EXPECT_EQ(file_visibility(*without, log_line), nullptr);
  const auto visibility = file_visibility(*with, log_line);
  ASSERT_TRUE(visibility);
  EXPECT_THAT(visibility->values[0][0], testing::ElementsAre(0.0f, 0.0f, 0.0f)) << "the numbers of its first vertex";
  EXPECT_THAT(messages, testing::IsEmpty());
  const auto strange = triangle_with(R"(,"_AMBIENT_ACCESS":0)");
  EXPECT_EQ(file_visibility(*strange, log_line), nullptr);
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_THAT(messages[0], testing::HasSubstr("/meshes/0/primitives/0/attributes/_AMBIENT_ACCESS: warning: "));
}

TEST(bake_visibility, what_is_wrong_with_attributes_names_the_file) {
  auto file = triangle_with(R"(,"_AMBIENT_ACCESS":0)").value();
  file.facts.files = {"some/triangle.gltf"};
  std::vector<std::string> messages;
  EXPECT_EQ(file_visibility(file, [&](const std::string& line) { messages.push_back(line); }), nullptr);
  EXPECT_THAT(messages, testing::ElementsAre(testing::StartsWith("some/triangle.gltf: /meshes/0")));
}

}  // namespace
}  // namespace sinew::viewer
