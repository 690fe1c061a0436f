// SPDX-License-Identifier: MIT
// Rays in scenes whose answers have a closed form.
#include "tests/study/ray_caster.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "runtime/math/quaternion.h"
#include "tests/viewer/built_scenes.h"

namespace sinew::viewer {
namespace {

/// A square of 2 by 2 in the plane y = 0, far away from any edge for rays of some metres when it is scaled by 100.
BuiltScene floor_scene(float half_size = 100.0f) {
  BuiltScene built;
  built.add(square(half_size), built.add_material(matte({1, 1, 1})));
  return built;
}

Affine scaled(const glm::vec3& s) {
  Affine m;
  for (int i = 0; i < 3; ++i) m.row[i][i] = s[i];
  return m;
}

/// The plane y = height, facing down.
Affine ceiling_at(float height) {
  Affine m = scaled({1, -1, -1});
  m.row[1].w = height;
  return m;
}

/// What a ray straight down from (x, 5, z) meets.
std::optional<RayCaster::Seen> below(const RayCaster& rays, double x = 0.1, double z = 0.2) {
  return rays.seen({x, 5.0, z}, {0, -1, 0});
}

TEST(ray_caster_forms, N34_under_a_ceiling_the_rays_that_reach_it_are_those_within_a_cone) {
  // Directions have density cos / pi, so that cos^2 is uniform: a ceiling at h stops cos > h / radius, 1 - (h / r)^2.
  for (const float height : {0.5f, 1.0f, 1.5f}) {
    BuiltScene built = floor_scene();
    built.add(square(100.0f), 0, ceiling_at(height));
    const RayCaster rays(built.scene, built.frame());
    const auto seen = rays.seen({0.3, 0.4 * height, 0.2}, {0, -1, 0});
    ASSERT_TRUE(seen);
    const double part = height / 2.0;
    EXPECT_NEAR(rays.open_share(*seen, 2.0, 256), part * part, 1.01 / 256) << height;
    EXPECT_EQ(rays.open_share(*seen, 0.99 * height, 256), 1.0) << "out of reach";
  }
}

TEST(ray_caster_forms, N34_at_the_foot_of_a_wall_half_of_the_light_arrives) {
  for (int axis = 0; axis < 4; ++axis) {
    BuiltScene built = floor_scene();
    Affine wall;  // x = 0 or z = 0, facing the side that is looked at
    const float side = axis < 2 ? 1.0f : -1.0f;
    const int across = axis % 2 == 0 ? 0 : 2;
    wall.row[across] = {0, side, 0, 0};
    wall.row[1] = {across == 0 ? -side : 0, 0, across == 0 ? 0 : -side, 0};
    wall.row[2 - across] = {across == 0 ? 0.0f : 1.0f, 0, across == 0 ? 1.0f : 0.0f, 0};
    built.add(square(100.0f), 0, wall, determinant(wall) < 0.0f);
    const RayCaster rays(built.scene, built.frame());
    glm::dvec3 from(0, 0.5, 0);
    from[across] = 1e-3 * static_cast<double>(side);
    const auto seen = rays.seen(from, {0, -1, 0});
    ASSERT_TRUE(seen) << axis;
    EXPECT_NEAR(rays.open_share(*seen, 10.0, 1024), 0.5, 0.01) << axis;
  }
}

TEST(ray_caster_forms, rays_spread_about_the_shading_normal_and_the_surface_itself_stops_those_below_it) {
  // A share of (1 + cos a) / 2 is above the surface when the normal leans by a.
  for (const double angle : {0.0, 0.5, 1.0}) {
    BuiltScene built;
    Primitive leaning = square(100.0f);
    leaning.normals.assign(4, glm::vec3(std::sin(angle), std::cos(angle), 0.0));
    Material both_sides = matte({1, 1, 1});
    both_sides.double_sided = true;
    built.add(leaning, built.add_material(both_sides));
    const RayCaster rays(built.scene, built.frame());
    const auto seen = below(rays);
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->normal.x, std::sin(angle), 1e-6);
    EXPECT_NEAR(seen->geometric.y, 1.0, 1e-12);
    EXPECT_NEAR(rays.open_share(*seen, 1.0, 1024), 0.5 * (1.0 + std::cos(angle)), 0.005);
    const auto back = rays.seen({0.1, -5.0, 0.2}, {0, 1, 0});
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->normal.x, -std::sin(angle), 1e-6) << "seen from below both normals turn";
    EXPECT_NEAR(back->geometric.y, -1.0, 1e-12);
  }
}

TEST(ray_caster_forms, normals_and_points_are_interpolated_between_the_corners) {
  BuiltScene built;
  Primitive p;
  p.positions = {{0, 0, 0}, {0, 0, 4}, {4, 2, 0}};
  p.normals = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  p.indices = {0, 1, 2};
  built.add(p, built.add_material(matte({1, 1, 1})));
  const RayCaster rays(built.scene, built.frame());
  const auto seen = below(rays, 1.0, 2.0);  // weights 1/4, 1/2, 1/4
  ASSERT_TRUE(seen);
  EXPECT_LT(glm::length(seen->point - glm::dvec3(1, 0.5, 2)), 1e-6);
  EXPECT_LT(glm::length(seen->normal - glm::normalize(glm::dvec3(0.25, 0.25, 0.5))), 1e-6);
  EXPECT_LT(glm::length(seen->geometric - glm::normalize(glm::dvec3(-0.5, 1, 0))), 1e-6);
  for (const auto& [x, z] : {std::pair{-0.01, 1.0}, {1.0, -0.01}, {2.01, 2.0}})
    EXPECT_FALSE(below(rays, x, z)) << x << ' ' << z;
  for (const auto& [x, z] : {std::pair{0.01, 1.0}, {1.0, 0.01}, {1.99, 2.0}}) EXPECT_TRUE(below(rays, x, z));
}

TEST(ray_caster_forms, flat_surfaces_and_those_without_normals_have_the_normal_of_their_triangles) {
  for (const bool has_normals : {false, true}) {
    BuiltScene built;
    Primitive p = square(2.0f);
    if (has_normals) {
      p.normals.assign(4, {1, 0, 0});
      p.flat_normals = true;
    } else {
      p.normals.clear();
    }
    built.add(p, built.add_material(matte({1, 1, 1})));
    const auto seen = below(RayCaster(built.scene, built.frame()));
    ASSERT_TRUE(seen);
    EXPECT_LT(glm::length(seen->normal - glm::dvec3(0, 1, 0)), 1e-6) << has_normals;
  }
}

TEST(ray_caster_forms, N22_normals_of_stretched_meshes_stay_perpendicular) {
  BuiltScene built;
  Primitive p = square(2.0f);
  const glm::vec3 slope = glm::normalize(glm::vec3(1, 2, 0));
  for (glm::vec3& v : p.positions) v.y = -0.5f * v.x;
  p.normals.assign(4, slope);
  built.add(p, built.add_material(matte({1, 1, 1})), scaled({1, 4, 1}));
  const auto seen = below(RayCaster(built.scene, built.frame()));
  ASSERT_TRUE(seen);
  EXPECT_LT(glm::length(seen->normal - glm::normalize(glm::dvec3(2, 1, 0))), 1e-6);
  EXPECT_LT(glm::length(seen->geometric - glm::normalize(glm::dvec3(2, 1, 0))), 1e-6);
  EXPECT_NEAR(seen->point.y, -0.2, 1e-6);
}

TEST(ray_caster_forms, deformed_vertices_take_the_place_of_those_at_rest) {
  BuiltScene built;
  Primitive p = square(2.0f);
  const std::uint32_t instance = built.add(p, built.add_material(matte({1, 1, 1})));
  std::vector<glm::vec3> raised = p.positions;
  for (glm::vec3& v : raised) v.y = 3.0f;
  built.deform(instance, raised, std::vector<glm::vec3>(4, {0.6f, 0.8f, 0}));
  const auto seen = below(RayCaster(built.scene, built.frame()));
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->point.y, 3.0, 1e-6);
  EXPECT_NEAR(seen->normal.x, 0.6, 1e-6);
}

TEST(ray_caster_forms, the_nearest_of_several_surfaces_is_seen_and_nothing_where_there_is_none) {
  BuiltScene built = floor_scene(1.0f);
  built.add(square(1.0f), 0, translation({0.5f, 2, 0}));
  built.add(square(1.0f), 0, translation({0, 1, 0}));
  const RayCaster rays(built.scene, built.frame());
  EXPECT_NEAR(below(rays, 0.7)->point.y, 2.0, 1e-6);
  EXPECT_NEAR(below(rays, -0.7)->point.y, 1.0, 1e-6);
  EXPECT_FALSE(below(rays, 1.7));
  EXPECT_FALSE(below(rays, 0.0, 1.01));
  EXPECT_FALSE(rays.seen({0, 5, 0}, {0, 1, 0}));
  const BuiltScene empty;
  EXPECT_FALSE(RayCaster(empty.scene, empty.frame()).seen({0, 0, 0}, {0, 1, 0}));
}

TEST(ray_caster_forms, what_is_hidden_blended_or_no_surface_stops_no_ray) {
  for (const int left_out : {0, 1, 2, 3}) {
    BuiltScene built = floor_scene(1.0f);
    Primitive upper = square(1.0f);
    Material material = matte({1, 1, 1});
    if (left_out == 1) material.alpha_mode = AlphaMode::blend;
    if (left_out == 2) upper.topology = Topology::lines;
    built.add(upper, built.add_material(material), translation({0, 1, 0}));
    FrameResult frame = built.frame();
    std::vector<InstanceResult> instances(frame.instances.begin(), frame.instances.end());
    if (left_out == 3) instances[1].visible = false;
    frame.instances = instances;
    const auto seen = below(RayCaster(built.scene, frame));
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->point.y, left_out == 0 ? 1.0 : 0.0, 1e-6) << left_out;
  }
}

TEST(ray_caster_forms, every_primitive_of_a_mesh_is_there_also_without_a_material) {
  BuiltScene built = floor_scene(1.0f);
  Mesh& mesh = built.scene.meshes[0];
  Primitive other = square(1.0f);
  for (glm::vec3& v : other.positions) v += glm::vec3(3, 2, 0);
  other.material = kNone;
  mesh.primitives.push_back(other);
  FrameResult frame = built.frame();
  const std::vector<DeformedPrimitive> deformed(2);
  frame.primitives = deformed;
  const RayCaster rays(built.scene, frame);
  EXPECT_NEAR(below(rays)->point.y, 0.0, 1e-6);
  ASSERT_TRUE(below(rays, 3.1));
  EXPECT_NEAR(below(rays, 3.1)->point.y, 2.0, 1e-6);
}

TEST(ray_caster_forms, copies_stand_in_the_space_of_their_instance_and_mirror_by_themselves) {
  BuiltScene built = floor_scene(1.0f);
  MeshInstance& instance = built.scene.instances[0];
  instance.copies = {Transform{{3, 0, 0}, quat_identity<float>(), {1, 1, 1}},
                     Transform{{0, 2, 3}, quat_identity<float>(), {-1, 1, 1}},
                     Transform{{9, 0, 0}, quat_identity<float>(), {0, 1, 1}},
                     Transform{{-6, 0, 0}, quat_identity<float>(), {1, 0, 1}}};
  FrameResult frame = built.frame();
  std::vector<InstanceResult> placed(frame.instances.begin(), frame.instances.end());
  placed[0].world_from_mesh = translation({0, 1, 0});
  placed[0].mirrored = true;  // says nothing of copies
  frame.instances = placed;
  const RayCaster rays(built.scene, frame);
  EXPECT_FALSE(below(rays)) << "the mesh itself is not drawn";
  ASSERT_TRUE(below(rays, 3.1));
  EXPECT_NEAR(below(rays, 3.1)->point.y, 1.0, 1e-6);
  ASSERT_TRUE(below(rays, 0.1, 3.2)) << "its front is above, though it is mirrored";
  EXPECT_NEAR(below(rays, 0.1, 3.2)->point.y, 3.0, 1e-6);
  EXPECT_FALSE(rays.seen({3.1, -5, 0.2}, {0, 1, 0})) << "its back is below";
  EXPECT_FALSE(rays.seen({0.1, -5, 3.2}, {0, 1, 0}));
  EXPECT_FALSE(below(rays, 9.0)) << "a copy without width";
  EXPECT_TRUE(below(rays, -5.9)) << "one without height is not mirrored";
  EXPECT_FALSE(rays.seen({-5.9, -5, 0.2}, {0, 1, 0}));
}

TEST(ray_caster_forms, back_faces_stop_light_only_where_the_material_has_two_sides) {
  for (const bool double_sided : {false, true}) {
    BuiltScene built = floor_scene();
    Material material = matte({1, 1, 1});
    material.double_sided = double_sided;
    built.add(square(100.0f), built.add_material(material), translation({0, 1, 0}));  // faces up, away from the floor
    const RayCaster rays(built.scene, built.frame());
    const auto seen = rays.seen({0.3, 0.5, 0.2}, {0, -1, 0});
    ASSERT_TRUE(seen);
    EXPECT_NEAR(rays.open_share(*seen, 2.0, 256), double_sided ? 0.25 : 1.0, 1.01 / 256);
  }
}

TEST(ray_caster_forms, N36_rays_start_in_front_of_their_surface_along_every_axis_and_far_out) {
  for (int out = 0; out < 3; ++out)
    for (const float sign : {-1.0f, 1.0f}) {
      BuiltScene built;
      Material both_sides = matte({1, 1, 1});
      both_sides.double_sided = true;
      Affine placed;
      placed.row[1].x = 0.7f;  // tilted, so that no coordinate is round
      placed.row[1].z = 0.3f;
      placed.row[out].w = sign * 16384.0f;
      built.add(square(2.0f), built.add_material(both_sides), placed);
      const RayCaster rays(built.scene, built.frame());
      const glm::dvec3 middle(placed.row[0].w, placed.row[1].w, placed.row[2].w);
      for (const double x : {-0.61, 0.13, 0.77}) {
        const auto seen = rays.seen(middle + glm::dvec3(x, 4.0, 0.2 * x), {0, -1, 0});
        ASSERT_TRUE(seen) << out;
        EXPECT_EQ(rays.open_share(*seen, 5.0, 256), 1.0) << "a plane does not darken itself, axis " << out;
      }
    }
}

}  // namespace
}  // namespace sinew::viewer
