// SPDX-License-Identifier: MIT
#include "runtime/compress/virtual_vertices.h"

#include <gtest/gtest.h>

#include "runtime/pose/local_to_model.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

TEST(virtual_vertices, C13_joints_without_vertices_have_a_stated_shell) {
  const VirtualVertices v = virtual_vertices(test::chain_skeleton(3));
  ASSERT_EQ(v.boxes.size(), 3u);
  for (const Aabb& box : v.boxes) {
    EXPECT_EQ(box.lower, glm::vec3(-VirtualVertices::kShell));
    EXPECT_EQ(box.upper, glm::vec3(VirtualVertices::kShell));
  }
}

TEST(virtual_vertices, every_weighted_vertex_lies_in_the_boxes_of_its_joints_also_when_morphed) {
  const Scene scene = test::random_scene(5);
  const VirtualVertices v = virtual_vertices(scene);
  EXPECT_EQ(v.metres_per_weight.size(), scene.weight_count());
  std::size_t looked_at = 0;
  for (const MeshInstance& instance : scene.instances)
    for (const Primitive& p : scene.meshes[instance.mesh].primitives) {
      const auto expect_inside = [&](std::uint32_t joint, const glm::vec3& point) {
        const Aabb& box = v.boxes[joint];
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(point, box.lower)) &&
                    glm::all(glm::lessThanEqual(point, box.upper)));
        ++looked_at;
      };
      const auto expect_vertex = [&](std::uint32_t vertex, const glm::vec3& position) {
        if (instance.skin == kNone) return expect_inside(instance.joint, position);
        for (const InfluenceGroup& g : p.influences.groups)
          if (vertex >= g.first_vertex && vertex < g.first_vertex + g.vertex_count)
            for (std::uint32_t i = 0; i < g.influence_count; ++i) {
              const std::uint16_t j =
                  p.influences.joints[g.first_influence + (vertex - g.first_vertex) * g.influence_count + i];
              const Skin& skin = scene.skins[instance.skin];
              expect_inside(skin.joints[j], transform_point(skin.inverse_bind[j], position));
            }
      };
      for (std::uint32_t i = 0; i < p.vertex_count(); ++i) expect_vertex(i, p.positions[i]);
      for (const MorphTarget& target : p.morphs.targets)
        for (std::size_t i = 0; i < target.positions.vertices.size(); ++i) {
          const std::uint32_t vertex = target.positions.vertices[i];
          expect_vertex(vertex, p.positions[vertex] + target.positions.deltas[i]);
        }
    }
  EXPECT_GT(looked_at, 1000u);
}

TEST(virtual_vertices, copies_of_a_mesh_are_all_inside) {
  Scene scene;
  scene.skeleton = test::chain_skeleton(1);
  scene.meshes.resize(1);
  scene.meshes[0].primitives.resize(1);
  scene.meshes[0].primitives[0].positions = {{0, 0, 0}, {1, 1, 1}};
  MeshInstance instance;
  instance.copies = {Transform{{5, 0, 0}, quat_identity<float>(), {1, 1, 1}},
                     Transform{{-5, 0, 0}, quat_identity<float>(), {2, 2, 2}}};
  scene.instances.push_back(instance);
  const VirtualVertices v = virtual_vertices(scene);
  EXPECT_EQ(v.boxes[0].lower, glm::vec3(-5, 0, 0));
  EXPECT_EQ(v.boxes[0].upper, glm::vec3(6, 2, 2));
}

/// A mesh of one vertex whose targets move it by these lengths along x; a length of 0 makes an empty target.
Mesh mesh_moved_by(std::initializer_list<float> lengths) {
  Mesh mesh;
  Primitive& primitive = mesh.primitives.emplace_back();
  primitive.positions = {{1, 2, 3}};
  for (const float length : lengths) {
    MorphTarget& target = primitive.morphs.targets.emplace_back();
    if (length != 0.0f) target.positions = {{0}, {{length, 0, 0}}};
  }
  mesh.default_weights.assign(lengths.size(), 0.0f);
  return mesh;
}

TEST(virtual_vertices, weights_have_the_longest_displacement_of_any_primitive_and_a_shell_without_any) {
  Scene scene;
  scene.skeleton = test::chain_skeleton(2);
  scene.meshes = {mesh_moved_by({3.0f, 0.0f, 1.0f}), mesh_moved_by({0.5f})};
  scene.meshes[0].primitives.push_back(mesh_moved_by({2.0f, 0.0f, -4.0f}).primitives[0]);
  for (const std::uint32_t mesh : {1u, 0u, 1u}) scene.instances.push_back({.joint = 1, .mesh = mesh});
  const VirtualVertices v = virtual_vertices(scene);
  EXPECT_EQ(v.metres_per_weight, (std::vector<float>{0.5f, 3.0f, VirtualVertices::kShell, 4.0f, 0.5f}));
  EXPECT_EQ(v.moves_vertices, (std::vector<bool>{false, true}));
  EXPECT_EQ(v.boxes[0].upper, glm::vec3(VirtualVertices::kShell));
  EXPECT_EQ(v.boxes[1].lower, glm::vec3(-3, 2, 3)) << "where the targets put the vertex";
  EXPECT_EQ(v.boxes[1].upper, glm::vec3(4, 2, 3));
}

TEST(virtual_vertices, skinned_vertices_are_in_the_boxes_of_their_own_joints_only) {
  Scene scene;
  scene.skeleton = test::chain_skeleton(4);
  Mesh& mesh = scene.meshes.emplace_back();
  Primitive& primitive = mesh.primitives.emplace_back();
  primitive.positions = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  // The first vertex follows one joint of the skin, the other two vertices follow two joints.
  primitive.influences.groups = {{.first_vertex = 0, .vertex_count = 1, .influence_count = 1, .first_influence = 0},
                                 {.first_vertex = 1, .vertex_count = 2, .influence_count = 2, .first_influence = 1}};
  primitive.influences.joints = {0, 1, 0, 2, 1};
  primitive.influences.weights = {1.0f, 0.5f, 0.5f, 0.5f, 0.5f};
  Skin& skin = scene.skins.emplace_back();
  skin.joints = {3, 1, 2};
  skin.inverse_bind.assign(3, affine_from_transform(Transform{{0, 10, 0}, quat_identity<float>(), {1, 1, 1}}));
  scene.instances.push_back({.joint = 0, .mesh = 0, .skin = 0});
  const VirtualVertices v = virtual_vertices(scene);
  EXPECT_EQ(v.moves_vertices, (std::vector<bool>{false, true, true, true}));
  const auto expect_box = [&](std::size_t joint, float from, float to) {
    EXPECT_EQ(v.boxes[joint].lower, glm::vec3(from, 10, 0)) << joint;
    EXPECT_EQ(v.boxes[joint].upper, glm::vec3(to, 10, 0)) << joint;
  };
  expect_box(3, 1, 2);
  expect_box(1, 2, 3);
  expect_box(2, 3, 3);
}

TEST(virtual_vertices, a_primitive_without_influences_follows_the_joint_of_its_instance) {
  Scene scene;
  scene.skeleton = test::chain_skeleton(2);
  scene.meshes = {mesh_moved_by({})};
  Skin& skin = scene.skins.emplace_back();
  skin.joints = {0};
  skin.inverse_bind.resize(1);
  scene.instances.push_back({.joint = 1, .mesh = 0, .skin = 0});
  EXPECT_EQ(virtual_vertices(scene).moves_vertices, (std::vector<bool>{false, true}));
}

}  // namespace
}  // namespace sinew
