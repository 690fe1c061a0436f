// SPDX-License-Identifier: MIT
#include "importer/ambient/visibility_surfaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "importer/ambient/bake_key_poses.h"

namespace sinew {
namespace {

Primitive square(float half) {
  Primitive p;
  p.positions = {{-half, 0, half}, {half, 0, half}, {half, 0, -half}, {-half, 0, -half}};
  p.normals.assign(4, {0, 1, 0});
  p.indices = {0, 1, 2, 0, 2, 3};
  return p;
}

Affine at_height(float y, float turned = 1.0f) {
  Affine m;
  m.row[1] = {0, turned, 0, y};
  return m;
}

/// A scene of squares, with a hand-made frame that places them.
struct Placed {
  Scene scene;
  std::vector<InstanceResult> instances;
  std::vector<DeformedPrimitive> primitives;

  std::uint32_t add_mesh(Primitive primitive) {
    scene.meshes.push_back({"", {std::move(primitive)}, {}, {}});
    return static_cast<std::uint32_t>(scene.meshes.size() - 1);
  }
  void add(std::uint32_t mesh, const Affine& place, bool mirrored = false) {
    InstanceResult instance;
    instance.world_from_mesh = place;
    instance.first_primitive = static_cast<std::uint32_t>(primitives.size());
    instance.mirrored = mirrored;
    scene.instances.push_back({0, mesh});
    instances.push_back(instance);
    primitives.push_back({static_cast<std::uint32_t>(instances.size() - 1), 0, {}, {}, {}, {}});
  }
  FrameResult frame() const {
    FrameResult result;
    result.instances = instances;
    result.primitives = primitives;
    return result;
  }
  MeshVisibility bake(std::uint32_t rays = 512) const { return bake_mesh_visibility(scene, frame(), {.rays = rays}); }
};

Material material(bool double_sided, AlphaMode mode) {
  Material m;
  m.double_sided = double_sided;
  m.alpha_mode = mode;
  return m;
}

TEST(visibility_surfaces, are_in_the_world_and_face_as_they_are_placed) {
  Placed placed;
  placed.add(placed.add_mesh(square(1.0f)), at_height(3.0f));
  placed.add(0, at_height(5.0f, -1.0f), true);
  const auto surfaces = surfaces_of(placed.scene, placed.frame());
  ASSERT_EQ(surfaces.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const VisibilitySurface& s = surfaces[i].surface;
    const float up = i == 0 ? 1.0f : -1.0f;
    const glm::vec3 &a = s.positions[s.indices[0]], &b = s.positions[s.indices[1]], &c = s.positions[s.indices[2]];
    EXPECT_EQ(a.y, i == 0 ? 3.0f : 5.0f);
    EXPECT_GT(glm::cross(b - a, c - a).y * up, 0.0f) << "the winding of a mirrored mesh is reversed";
    EXPECT_EQ(s.normals[0], glm::vec3(0, up, 0));
  }
}

TEST(visibility_surfaces, deformed_vertices_take_the_place_of_the_meshs_own) {
  Placed placed;
  placed.add(placed.add_mesh(square(1.0f)), {});
  const std::vector<glm::vec3> moved(4, {7, 8, 9}), turned(4, {0, 0, 1});
  placed.primitives[0].positions = moved;
  placed.primitives[0].normals = turned;
  const auto surfaces = surfaces_of(placed.scene, placed.frame());
  EXPECT_EQ(surfaces[0].surface.positions, moved);
  EXPECT_EQ(surfaces[0].surface.normals, turned);
}

TEST(visibility_surfaces, materials_say_what_blocks_and_points_lines_and_hidden_meshes_are_no_surfaces) {
  Placed placed;
  placed.scene.materials = {material(true, AlphaMode::opaque), material(false, AlphaMode::blend),
                            material(false, AlphaMode::mask)};
  for (const std::uint32_t m : {0u, 1u, 2u, kNone}) {
    Primitive p = square(1.0f);
    p.material = m;
    p.flat_normals = m == 2u;
    placed.add(placed.add_mesh(p), {});
  }
  Primitive lines = square(1.0f);
  lines.topology = Topology::lines;
  placed.add(placed.add_mesh(lines), {});
  placed.add(0, {});
  placed.instances.back().visible = false;
  const auto surfaces = surfaces_of(placed.scene, placed.frame());
  ASSERT_EQ(surfaces.size(), 4u);
  const std::vector<bool> both = {true, false, false, false}, blocks = {true, false, true, true};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(surfaces[i].surface.both_sides, both[i]) << i;
    EXPECT_EQ(surfaces[i].surface.blocks, blocks[i]) << i;
    EXPECT_EQ(surfaces[i].surface.normals.empty(), i == 2) << "flat: vertices of faces are not one";
  }
}

TEST(bake_mesh_visibility, a_mesh_at_several_places_gets_the_mean_of_them) {
  Placed placed;
  placed.add(placed.add_mesh(square(1.0f)), at_height(0.0f));
  placed.add(0, at_height(10.0f));
  placed.add(placed.add_mesh(square(50.0f)), at_height(0.01f, -1.0f), true);  // a lid over the first
  placed.add(placed.add_mesh(square(1.0f)), at_height(0.0f));
  placed.instances.back().visible = false;
  const MeshVisibility visibility = placed.bake();
  ASSERT_EQ(visibility[0][0].size(), 4u);
  for (const float share : visibility[0][0]) EXPECT_NEAR(share, 0.5f, 0.01f);
  EXPECT_TRUE(visibility[2][0].empty()) << "nobody sees it";
}

TEST(key_pose_baker, meshes_are_open_in_poses_that_hide_them_and_have_no_values_if_all_do) {
  Placed placed;
  placed.add(placed.add_mesh(square(1.0f)), at_height(0.0f));
  placed.add(placed.add_mesh(square(50.0f)), at_height(0.01f, -1.0f), true);  // a lid over it
  placed.add(placed.add_mesh(square(1.0f)), at_height(0.0f));
  placed.instances[2].visible = false;
  VertexVisibility visibility;
  visibility.times_s = {0.0, 1.0, 2.0, 3.0};
  std::vector<double> told;
  const VisibilityOptions how{.rays = 64, .progress = [&](double part) { told.push_back(part); }};
  KeyPoseBaker baker(placed.scene, how, 100.0, visibility);
  const bool ground_seen[] = {false, true, true, false}, lid_seen[] = {true, true, false, true};
  for (std::size_t pose = 0; pose < 4; ++pose) {
    placed.instances[0].visible = ground_seen[pose];
    placed.instances[1].visible = lid_seen[pose];
    baker.add(placed.frame());
    EXPECT_DOUBLE_EQ(told.back(), 0.25 * static_cast<double>(pose + 1));
  }
  ASSERT_EQ(visibility.values.size(), 3u);
  const std::vector<float>& ground = visibility.values[0][0];
  ASSERT_EQ(ground.size(), 16u);
  for (std::size_t v = 0; v < 4; ++v) {
    EXPECT_EQ(ground[v], 1.0f) << "not shown";
    EXPECT_LT(ground[4 + v], 0.05f) << "under the lid";
    EXPECT_EQ(ground[8 + v], 1.0f) << "without the lid";
    EXPECT_EQ(ground[12 + v], 1.0f) << "not shown any more";
  }
  EXPECT_EQ(visibility.values[1][0].size(), 16u);
  EXPECT_TRUE(visibility.values[2][0].empty());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
}

TEST(key_pose_baker, poses_have_the_distance_that_is_given_else_that_of_the_first_pose) {
  const auto baked = [](std::optional<double> distance_m, std::initializer_list<float> heights) {
    Placed placed;
    placed.add(placed.add_mesh(square(1.0f)), at_height(0.0f));
    placed.add(placed.add_mesh(square(50.0f)), {}, true);
    VertexVisibility visibility;
    visibility.times_s.assign(heights.size(), 0.0);
    KeyPoseBaker baker(placed.scene, {.rays = 64, .distance_m = 0.001}, distance_m, visibility);
    for (const float height : heights) {
      placed.instances[1].world_from_mesh = at_height(height, -1.0f);
      baker.add(placed.frame());
    }
    return visibility.values[0][0];
  };
  EXPECT_THAT(baked(1.0, {2.0f}), testing::Each(1.0f));
  EXPECT_THAT(baked(10.0, {2.0f}), testing::Each(testing::Lt(0.1f)));
  EXPECT_THAT(baked(std::nullopt, {20.0f}), testing::Each(testing::Lt(0.7f))) << "a quarter of 100 m";
  EXPECT_THAT(baked(std::nullopt, {200.0f}), testing::Each(1.0f)) << "a quarter of 200 m";
  EXPECT_GT(baked(std::nullopt, {1.0f, 24.0f}).back(), baked(std::nullopt, {140.0f, 24.0f}).back())
      << "the first says it for all";
}

TEST(key_pose_times, are_spread_evenly_with_both_ends) {
  EXPECT_EQ(key_pose_times(3.0, 4), (std::vector<double>{0.0, 1.0, 2.0, 3.0}));
  EXPECT_EQ(key_pose_times(3.0, 2), (std::vector<double>{0.0, 3.0}));
  EXPECT_EQ(key_pose_times(3.0, 1), std::vector<double>{0.0});
  EXPECT_EQ(key_pose_times(0.0, 4), std::vector<double>{0.0}) << "lasts no time";
  EXPECT_EQ(key_pose_times(-1.0, 4), std::vector<double>{0.0});
}

TEST(bake_mesh_visibility, copies_of_an_instance_count_like_instances) {
  Placed placed;
  placed.add(placed.add_mesh(square(1.0f)), {});
  Transform above;
  above.translation = {0, 10, 0};
  placed.scene.instances[0].copies = {Transform{}, above, above};
  placed.add(placed.add_mesh(square(50.0f)), at_height(0.01f, -1.0f), true);
  const MeshVisibility visibility = placed.bake();
  for (const float share : visibility[0][0]) EXPECT_NEAR(share, 2.0f / 3.0f, 0.01f);
}

}  // namespace
}  // namespace sinew
