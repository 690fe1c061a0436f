// SPDX-License-Identifier: MIT
#include "viewer/app/bake_access.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "importer/ambient/access_surfaces.h"
#include "importer/import_gltf.h"
#include "samples/showcase/showcase.h"
#include "viewer/app/clip_poses.h"

namespace sinew::viewer {
namespace {

Exhibit arms() {
  Exhibit exhibit;
  exhibit.name = "arms";
  exhibit.scene = showcase::twisted_arms().scene;
  return exhibit;
}

/// What a pose has by itself, within the reach that the first pose of the clip gives.
MeshAccess baked(const Scene& scene, std::uint32_t clip, double time_s) {
  AccessOptions how;
  const double times[] = {0.0, time_s};
  bool first = true;
  MeshAccess access;
  for_each_pose(scene, clip, nullptr, times, [&](const FrameResult& pose) {
    if (first) how.distance_m = default_access_distance_m(scene, pose);
    first = false;
    access = bake_mesh_access(scene, pose, how);
  });
  return access;
}

TEST(bake_access, key_poses_are_spread_over_the_clip_one_after_another) {
  Exhibit exhibit = arms();
  exhibit.scene.animations[0].duration_s *= 0.4;  // the arms go there and back: the whole is the same in reverse
  const double duration = exhibit.scene.animations[0].duration_s;
  std::vector<std::string> said;
  std::vector<double> told;
  ASSERT_TRUE(add_missing_access(
      exhibit, {4, 0}, [&](const std::string& line) { said.push_back(line); },
      [&](double part) { told.push_back(part); }));
  ASSERT_TRUE(exhibit.access);
  EXPECT_EQ(exhibit.access->clip, 0u);
  EXPECT_THAT(exhibit.access->times_s, testing::ElementsAre(0.0, duration / 3, duration * 2 / 3, duration));
  const MeshAccess second = baked(exhibit.scene, 0, duration / 3);
  for (std::size_t m = 0; m < exhibit.scene.meshes.size(); ++m) {
    const std::vector<float>&all = exhibit.access->values[m][0], &own = second[m][0];
    const std::size_t vertices = exhibit.scene.meshes[m].primitives[0].vertex_count();
    if (own.empty()) continue;
    ASSERT_EQ(all.size(), 4 * vertices);
    EXPECT_TRUE(std::equal(own.begin(), own.end(), all.begin() + static_cast<std::ptrdiff_t>(vertices)));
  }
  ASSERT_EQ(said.size(), 1u);
  EXPECT_THAT(said[0], testing::MatchesRegex("arms: ambient access of 4 key poses, 256 rays a vertex, baked in .* s"));
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1.0);
}

TEST(bake_access, one_pose_is_the_rest_pose_and_what_is_there_stays) {
  Exhibit exhibit = arms();
  int said = 0;
  const auto say = [&](const std::string&) { ++said; };
  ASSERT_TRUE(add_missing_access(exhibit, {1, 0}, say));
  EXPECT_EQ(exhibit.access->clip, kNone);
  const MeshAccess rest = baked(exhibit.scene, kNone, 0.0);
  for (std::size_t m = 0; m < rest.size(); ++m) {
    if (!rest[m][0].empty()) {
      EXPECT_EQ(exhibit.access->values[m][0], rest[m][0]);
    }
  }
  const auto before = exhibit.access;
  ASSERT_TRUE(add_missing_access(exhibit, {4, 0}, say));
  EXPECT_EQ(exhibit.access, before);
  EXPECT_EQ(said, 1);
}

/// A triangle; `attribute` are members of its attributes besides the positions, which all accessors read.
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

TEST(bake_access, without_a_clip_there_is_one_pose_however_many_are_asked_for) {
  Exhibit exhibit;
  exhibit.scene = triangle_with("").value().scene;
  ASSERT_TRUE(add_missing_access(exhibit, {4, kNone}, [](const std::string&) {}));
  EXPECT_THAT(exhibit.access->times_s, testing::ElementsAre(0.0));
  EXPECT_EQ(exhibit.access->clip, kNone);
}

TEST(bake_access, of_a_file_is_what_its_vertices_have) {
  std::vector<std::string> said;
  const auto say = [&](const std::string& line) { said.push_back(line); };
  const auto without = triangle_with(""), with = triangle_with(R"(,"_AMBIENT_ACCESS":1)");
  ASSERT_TRUE(without && with);
  EXPECT_EQ(access_of_file(*without, say), nullptr);
  const auto access = access_of_file(*with, say);
  ASSERT_TRUE(access);
  EXPECT_THAT(access->values[0][0], testing::ElementsAre(0.0f, 0.0f, 0.0f)) << "the numbers of its first vertex";
  EXPECT_THAT(said, testing::IsEmpty());
  const auto strange = triangle_with(R"(,"_AMBIENT_ACCESS":0)");
  EXPECT_EQ(access_of_file(*strange, say), nullptr);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_THAT(said[0], testing::HasSubstr("/meshes/0/primitives/0/attributes/_AMBIENT_ACCESS: warning: "));
}

TEST(bake_access, what_is_wrong_with_attributes_names_the_file) {
  auto file = triangle_with(R"(,"_AMBIENT_ACCESS":0)").value();
  file.facts.files = {"some/triangle.gltf"};
  std::vector<std::string> said;
  EXPECT_EQ(access_of_file(file, [&](const std::string& line) { said.push_back(line); }), nullptr);
  EXPECT_THAT(said, testing::ElementsAre(testing::StartsWith("some/triangle.gltf: /meshes/0")));
}

}  // namespace
}  // namespace sinew::viewer
