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

}  // namespace
}  // namespace sinew
