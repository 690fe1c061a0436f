// SPDX-License-Identifier: MIT
// Baking point caches and numbered files onto a mesh: which vertex each point moves, and when.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "importer/tool/bake/bake_points.h"
#include "tests/geometry_cache/point_cache_files.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/importer/tool_model.h"

namespace sinew::tool {
namespace {
using test::ToolModelFile;
using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<glm::vec3> kInFile = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};  // the triangle of TinyGltf

/// Vertex 0 has two influences and the others one, so the importer moves it to the end.
test::TinyGltf skinned_triangle() {
  test::TinyGltf file;
  file.add_skinned_triangle({0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}, {0.5f, 0.5f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  file.root["meshes"][0]["name"] = "sail";
  return file;
}

Scene scene_of(const test::TinyGltf& file) {
  auto imported = file.import();
  EXPECT_EQ(test::outcome(imported), "ok");
  return imported ? std::move(imported->scene) : Scene{};
}

/// Three frames, starting at 0.5 s. Vertex v of the file rises by v + 1 per frame.
std::string rising_points(const ToolModelFile& folder) {
  std::vector<std::vector<glm::vec3>> frames(3, kInFile);
  for (int f = 0; f < 3; ++f)
    for (std::size_t v = 0; v < kInFile.size(); ++v)
      frames[static_cast<std::size_t>(f)][v].z += static_cast<float>(f) * static_cast<float>(v + 1);
  const std::string file = folder.beside("points.mdd");
  test::write_file(file, test::mdd_file(frames, {0.5f, 0.75f, 1.0f}));
  return file;
}

std::string fault_of(const ImportResult<BakedPoints>& baked) {
  return baked ? "none" : baked.error().issue.rule + ": " + baked.error().issue.detail;
}

TEST(bake_points, points_are_in_the_order_of_the_files_vertices_whatever_the_scene_makes_of_it) {
  const ToolModelFile folder;
  const Scene scene = scene_of(skinned_triangle());
  const Primitive& primitive = scene.meshes[0].primitives[0];
  ASSERT_THAT(primitive.source_vertex, ElementsAre(1, 2, 0)) << "the scene has another order";
  const PointsOptions options{rising_points(folder), {}, 30.0};
  const auto baked = bake_points(scene, options);
  ASSERT_TRUE(baked) << fault_of(baked);
  EXPECT_EQ(baked->found, options.file + ": y is up, since its first frame is the mesh at rest that way");
  ASSERT_EQ(baked->take.meshes.size(), 1u);
  const TakeMesh& mesh = baked->take.meshes[0];
  EXPECT_EQ(mesh.name, "sail");
  EXPECT_EQ(mesh.vertex_count, 3u);
  EXPECT_EQ(mesh.triangles, primitive.indices);
  ASSERT_EQ(mesh.streams[0].frames.size(), 3u);
  EXPECT_THAT(mesh.streams[0].frames[0], ElementsAre(kInFile[1], kInFile[2], kInFile[0]));
  EXPECT_THAT(mesh.streams[0].frames[2], ElementsAre(glm::vec3(1, 0, 4), glm::vec3(0, 1, 6), glm::vec3(0, 0, 2)));
}

TEST(bake_points, a_take_has_the_times_of_the_point_cache) {
  const ToolModelFile folder;
  const auto of_scene = bake_points(scene_of(skinned_triangle()), {rising_points(folder), {}, 30.0});
  const std::string obj = folder.beside("mesh.obj");
  test::write_file(obj, std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  const auto of_obj = bake_points(std::filesystem::path(obj), {rising_points(folder), {}, 30.0});
  for (const auto* baked : {&of_scene, &of_obj}) {
    ASSERT_TRUE(*baked) << fault_of(*baked);
    EXPECT_EQ((*baked)->take.start_s, 0.5);
    EXPECT_EQ((*baked)->take.frame_s, 0.25);
  }
  EXPECT_EQ(of_obj->take.meshes[0].name, "mesh");
}

TEST(bake_points, only_a_scene_of_one_mesh_of_triangles_can_be_moved) {
  const ToolModelFile folder;
  const PointsOptions options{rising_points(folder), {}, 30.0};
  const auto refused = [&](const char* what, const Scene& scene) {
    EXPECT_THAT(fault_of(bake_points(scene, options)), HasSubstr("points-mesh: a point cache moves one mesh")) << what;
  };
  test::TinyGltf no_triangles = skinned_triangle();
  no_triangles.root["meshes"][0]["primitives"][0]["mode"] = 0;
  refused("points", scene_of(no_triangles));
  test::TinyGltf twice = skinned_triangle();
  twice.root["nodes"].push_back({{"mesh", 0}});
  refused("two instances", scene_of(twice));
  test::TinyGltf two_parts = skinned_triangle();
  two_parts.root["meshes"][0]["primitives"].push_back(two_parts.root["meshes"][0]["primitives"][0]);
  refused("two primitives", scene_of(two_parts));
  refused("no mesh", Scene{});
}

TEST(bake_points, a_mesh_whose_vertices_are_a_part_of_the_files_is_refused) {
  const ToolModelFile folder;
  Scene scene = scene_of(skinned_triangle());
  scene.meshes[0].primitives[0].source_vertex = {1, 3, 0};
  EXPECT_EQ(fault_of(bake_points(scene, {rising_points(folder), {}, 30.0})),
            "points-mesh: the mesh shares its vertices with another one");
}

TEST(bake_points, a_cache_of_another_mesh_is_told_by_its_number_of_points) {
  const ToolModelFile folder;
  const Scene scene = scene_of(skinned_triangle());
  const std::string file = folder.beside("other.mdd");
  test::write_file(file, test::mdd_file({{{0, 0, 0}}}, {0.0f}));
  EXPECT_EQ(fault_of(bake_points(scene, {file, {}, 30.0})), "points-count: 1 point, and the mesh has 3 vertices");
}

TEST(bake_points, one_vertex_is_not_several) {
  const ToolModelFile folder;
  const std::string obj = folder.beside("dot.obj");
  for (const auto& [vertices, words] : {std::pair("v 0 0 0\n", "1 vertex"), {"v 0 0 0\nv 1 0 0\n", "2 vertices"}}) {
    test::write_file(obj, std::string(vertices) + "f 1 1 1\n");
    EXPECT_EQ(fault_of(bake_points(obj, {rising_points(folder), {}, 30.0})),
              "points-count: 3 points, and the mesh has " + std::string(words));
  }
}

TEST(bake_points, numbered_files_keep_their_digits_and_stop_at_the_first_gap) {
  const ToolModelFile folder;
  for (const char* name : {"cloth_008.obj", "cloth_009.obj", "cloth_010.obj", "cloth_11.obj", "cloth_012.obj"})
    test::write_file(folder.beside(name), std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  const auto files = numbered_obj_files(folder.beside("cloth_008.obj"));
  ASSERT_TRUE(files);
  EXPECT_THAT(*files, ElementsAre(folder.beside("cloth_008.obj"), folder.beside("cloth_009.obj"),
                                  folder.beside("cloth_010.obj")));
  const auto baked = bake_numbered_obj(*files, 20.0);
  ASSERT_TRUE(baked) << fault_of(baked);
  EXPECT_EQ(baked->take.meshes[0].name, "cloth_");
  EXPECT_EQ(baked->take.frame_s, 1.0 / 20.0);
  EXPECT_EQ(baked->take.start_s, 0.0);
}

}  // namespace
}  // namespace sinew::tool
