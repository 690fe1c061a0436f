// SPDX-License-Identifier: MIT
#include "importer/add_centers_of_rotation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "importer/import_gltf.h"
#include "tests/importer/tool_model.h"
#include "tests/scenes/random_scene.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/skinned_surface.h"
#include "tests/scenes/swinging.h"

namespace sinew::test {
namespace {

/// One skinned surface of a biped, four influences a vertex.
Scene surface() {
  const Skeleton skeleton = scenes::biped();
  return scenes::swinging_surface(skeleton, scenes::swinging(skeleton, 4), 300, 4);
}

/// Splits the triangles of a mesh into two primitives, as if it had two materials. Both keep all vertices.
void cut_in_two(Mesh& mesh) {
  mesh.primitives.push_back(mesh.primitives[0]);
  auto &first = mesh.primitives[0].indices, &second = mesh.primitives[1].indices;
  const auto middle = static_cast<std::ptrdiff_t>(first.size() / 6 * 3);
  first.erase(first.begin() + middle, first.end());
  second.erase(second.begin(), second.begin() + middle);
}

TEST(add_centers_of_rotation, N21_gives_every_skinned_primitive_its_centers) {
  Scene scene = surface();
  ASSERT_FALSE(scene.meshes[0].primitives[0].indices.empty());
  add_centers_of_rotation(scene);
  EXPECT_EQ(scene.meshes[0].primitives[0].centers_of_rotation, centers_of_rotation(scene.meshes[0].primitives[0]));
  EXPECT_NE(scene.meshes[0].primitives[0].centers_of_rotation, scene.meshes[0].primitives[0].positions);
  EXPECT_EQ(check(scene), ErrorCode::ok);
}

TEST(add_centers_of_rotation, N21_materials_do_not_move_centers) {
  Scene whole = surface(), cut = surface();
  cut_in_two(cut.meshes[0]);
  add_centers_of_rotation(whole);
  add_centers_of_rotation(cut);
  const auto& expected = whole.meshes[0].primitives[0].centers_of_rotation;
  for (const Primitive& part : cut.meshes[0].primitives) EXPECT_EQ(part.centers_of_rotation, expected);
  EXPECT_NE(expected, centers_of_rotation(cut.meshes[0].primitives[0]))
      << "half of the triangles alone would move them";
}

TEST(add_centers_of_rotation, leaves_alone_what_no_skin_moves_and_what_has_centers) {
  Scene scene = surface();
  scene.instances[0].skin = kNone;
  add_centers_of_rotation(scene);
  EXPECT_TRUE(scene.meshes[0].primitives[0].centers_of_rotation.empty());
  scene = surface();
  const std::vector<glm::vec3> own(scene.meshes[0].primitives[0].vertex_count(), glm::vec3(7));
  scene.meshes[0].primitives[0].centers_of_rotation = own;
  add_centers_of_rotation(scene);
  EXPECT_EQ(scene.meshes[0].primitives[0].centers_of_rotation, own);
}

TEST(add_centers_of_rotation, a_part_with_centers_keeps_them_beside_parts_without) {
  Scene whole = surface(), cut = surface();
  cut_in_two(cut.meshes[0]);
  add_centers_of_rotation(whole);
  const std::vector<glm::vec3> own(cut.meshes[0].primitives[0].vertex_count(), glm::vec3(7));
  cut.meshes[0].primitives[0].centers_of_rotation = own;
  add_centers_of_rotation(cut);
  EXPECT_EQ(cut.meshes[0].primitives[0].centers_of_rotation, own);
  EXPECT_EQ(cut.meshes[0].primitives[1].centers_of_rotation, whole.meshes[0].primitives[0].centers_of_rotation);
}

TEST(add_centers_of_rotation, progress_rises_once_over_all_meshes) {
  RandomSceneOptions options;
  options.meshes = 3;
  options.instances = 6;
  Scene scene = random_scene(5, options);
  std::vector<double> seen;
  CentersOptions how;
  how.progress = [&](double done) { seen.push_back(done); };
  add_centers_of_rotation(scene, how);
  ASSERT_FALSE(seen.empty());
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1.0);
}

TEST(import_gltf, makes_centers_of_rotation_only_when_asked) {
  const std::string text = tool_model();
  const auto bytes = std::as_bytes(std::span(text));
  ImportOptions options;
  EXPECT_TRUE(import_gltf(bytes, "model.gltf", options)->scene.meshes[0].primitives[0].centers_of_rotation.empty());
  options.make_centers_of_rotation = true;
  bool told = false;
  options.progress = [&](const std::string& stage, double) { told |= stage == "centers of rotation"; };
  const auto file = import_gltf(bytes, "model.gltf", options);
  const Primitive& strip = file->scene.meshes[0].primitives[0];
  EXPECT_EQ(strip.centers_of_rotation, strip.positions) << "points: no triangle is similar to any vertex";
  EXPECT_TRUE(file->scene.meshes[1].primitives[0].centers_of_rotation.empty()) << "not skinned";
  EXPECT_TRUE(told);
}

}  // namespace
}  // namespace sinew::test
