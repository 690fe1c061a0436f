// SPDX-License-Identifier: MIT
// Picking, influences, colours and lines of what the user looks at.
#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "runtime/plan/run_plan.h"
#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"
#include "viewer/app/inspect/overlay_lines.h"
#include "viewer/app/inspect/paint.h"
#include "viewer/app/inspect/pick.h"

namespace sinew::viewer {
namespace {

/// A box of half a metre at x = -1, and another one at x = 1 that moves up by 2 m in its clip of 2 s.
Scene two_boxes() {
  showcase::SceneBuilder builder;
  const std::uint32_t grey = builder.add_material("grey", glm::vec3(0.5f), 0.5f);
  const std::uint32_t root = builder.add_joint("root", kNone, {});
  for (const float x : {-1.0f, 1.0f}) {
    const std::uint32_t joint =
        builder.add_joint(x < 0.0f ? "left" : "right", root, {{x, 0, 0}, {1, 0, 0, 0}, {1, 1, 1}});
    Mesh mesh{x < 0.0f ? "still" : "moving", {showcase::box({0, 0, 0}, glm::vec3(0.25f))}, {}, {}};
    mesh.primitives[0].material = grey;
    builder.add_instance(joint, builder.add_mesh(std::move(mesh)));
  }
  BoneAnimation bone;
  bone.joint = 2;
  bone.translation = {Interpolation::linear, {0.0f, 2.0f}, {{1, 0, 0}, {1, 2, 0}}};
  builder.add_animation({"rise", 2.0, {bone}, {}});
  return builder.finish();
}

class Inspect : public testing::Test {
 protected:
  const FrameResult& at(double time_s) {
    const ClipLayer layer{0, time_s, 1.0f};
    FrameInput input;
    input.layers = {&layer, 1};
    EXPECT_EQ(run_plan(plan_, input, frame_), ErrorCode::ok);
    return frame_.result();
  }

  static Needs needs() {
    Needs needs;
    needs.out.bounds = true;
    return needs;
  }

  LoadedScene loaded_ = [] {
    LoadedScene loaded;
    loaded.scene = two_boxes();
    return loaded;
  }();
  Plan plan_ = compile_plan(lend(loaded_.scene), needs());
  FrameBuffer frame_{plan_};
};

/// Where a view shows a point: x and y from -1 to 1.
glm::dvec2 seen_at(const View& view, double aspect, const glm::dvec3& point) {
  const glm::dvec3 p = transform_point(view.view_from_world, point);
  if (view.parallel()) return glm::dvec2(p.x / aspect, p.y) / view.half_height_m;
  const double slope = std::tan(0.5 * view.fov_y_rad);
  return glm::dvec2(p.x / aspect, p.y) / (-p.z * slope);
}

TEST_F(Inspect, a_ray_meets_what_the_view_shows_there) {
  View view = look_at({1, 2, 5}, {0.2, 0.3, 0}, 0.7, 0.1);
  for (const bool parallel : {false, true}) {
    view.half_height_m = parallel ? 1.5 : 0.0;
    for (const glm::dvec3 point : {glm::dvec3(0.5, 0.2, -1), glm::dvec3(-1, 1, 0.5), glm::dvec3(0.2, 0.3, 0)}) {
      const glm::dvec2 at = seen_at(view, 1.6, point);
      const Ray ray = ray_through(view, 1.6, at.x, at.y);
      EXPECT_NEAR(glm::length(glm::cross(point - ray.from, ray.along)), 0.0, 1e-12) << parallel;
      EXPECT_GT(glm::dot(point - ray.from, ray.along), 0.0);
    }
  }
}

TEST_F(Inspect, the_nearest_corner_of_the_nearest_triangle_is_picked_where_it_is_now) {
  const FrameResult& frame = at(1.0);
  const auto corner = pick_vertex(loaded_.scene, frame, {{1.2, 1.2, 5}, {0, 0, -1}});
  ASSERT_TRUE(corner);
  EXPECT_EQ(corner->instance, 1u);
  EXPECT_LT(glm::distance(position_of(loaded_.scene, frame, *corner), glm::dvec3(1.25, 1.25, 0.25)), 1e-6);
  for (const double x : {0.8, 1.2})
    for (const double y : {0.8, 1.2}) {
      const auto picked = pick_vertex(loaded_.scene, frame, {{x, y, 5}, {0, 0, -1}});
      ASSERT_TRUE(picked);
      const glm::dvec3 expected(x < 1.0 ? 0.75 : 1.25, y < 1.0 ? 0.75 : 1.25, 0.25);
      EXPECT_LT(glm::distance(position_of(loaded_.scene, frame, *picked), expected), 1e-6) << x << " " << y;
    }
  EXPECT_FALSE(pick_vertex(loaded_.scene, frame, {{1, 0, 5}, {0, 0, -1}})) << "it has moved away from there";
  EXPECT_FALSE(pick_vertex(loaded_.scene, frame, {{1.2, 1.2, 5}, {0, 0, 1}})) << "behind the eye";
  const auto back = pick_vertex(loaded_.scene, frame, {{-0.8, 0.2, -5}, {0, 0, 1}});
  ASSERT_TRUE(back);
  EXPECT_LT(glm::distance(position_of(loaded_.scene, frame, *back), glm::dvec3(-0.75, 0.25, -0.25)), 1e-6);
}

TEST_F(Inspect, a_mesh_without_a_skin_is_moved_by_its_joint) {
  const auto influences = influences_of(loaded_.scene, {1, 0, 3});
  ASSERT_EQ(influences.size(), 1u);
  EXPECT_EQ(influences[0].joint, 2u);
  EXPECT_EQ(influences[0].weight, 1.0f);
}

/// A skin of two joints with three vertices: two follow both joints, the last one follows a single joint.
Scene skinned() {
  Scene scene;
  scene.skeleton.parents = {kNone, 0, 1};
  scene.skeleton.rest.resize(3);
  scene.skins.push_back({"body", {2, 1}, {Affine(), Affine()}});
  Primitive primitive;
  primitive.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  primitive.indices = {0, 1, 2};
  primitive.texcoords = {{{0, 0}, {1, 0}, {0, 1}}};
  primitive.influences = {{{0, 2, 2, 0}, {2, 1, 1, 4}}, {0, 1, 1, 0, 1}, {0.75f, 0.25f, 0.5f, 0.5f, 1.0f}};
  scene.meshes.push_back({"cloth", {primitive}, {}, {}});
  scene.instances.push_back({0, 0, 0, {}});
  return scene;
}

TEST_F(Inspect, the_joints_of_a_vertex_are_those_of_its_skin) {
  const Scene scene = skinned();
  const auto second = influences_of(scene, {0, 0, 0}), last = influences_of(scene, {0, 0, 2});
  ASSERT_EQ(second.size(), 2u);
  EXPECT_EQ(second[0].joint, 2u);
  EXPECT_EQ(second[0].weight, 0.75f);
  EXPECT_EQ(second[1].joint, 1u);
  ASSERT_EQ(last.size(), 1u);
  EXPECT_EQ(last[0].joint, 1u);
}

TEST_F(Inspect, weights_are_colours_of_the_vertices) {
  const Scene scene = painted(skinned(), Paint::weights, 1);
  const auto& colors = scene.meshes[0].primitives[0].colors;
  ASSERT_EQ(colors.size(), 3u);
  EXPECT_EQ(colors[0], glm::vec4(share_color(0.25), 1.0f));
  EXPECT_EQ(colors[1], glm::vec4(share_color(0.5), 1.0f));
  EXPECT_EQ(colors[2], glm::vec4(share_color(1.0), 1.0f));
  EXPECT_EQ(scene.materials.at(scene.meshes[0].primitives[0].material).base_color, glm::vec4(1.0f));
  EXPECT_EQ(painted(skinned(), Paint::weights, kNone).meshes[0].primitives[0].colors[2],
            glm::vec4(share_color(0.0), 1.0f));
}

TEST_F(Inspect, texture_coordinates_are_squares_of_a_texture) {
  const Scene scene = painted(skinned(), Paint::uv, kNone);
  const Material& material = scene.materials.at(scene.meshes[0].primitives[0].material);
  const Image& image = scene.images.at(scene.textures.at(material.base_color_texture.texture).image);
  ASSERT_EQ(image.rgba.size(), std::size_t{4} * image.width * image.height);
  EXPECT_EQ(painted(skinned(), Paint::materials, 1).images.size(), 0u);
  const auto blue = [&](std::size_t x, std::size_t y) { return image.rgba[4 * (y * image.width + x) + 2]; };
  EXPECT_NE(blue(0, 0), blue(image.width / 16, 0));
  EXPECT_EQ(blue(0, 0), blue(image.width / 8, 0));
}

TEST_F(Inspect, lines_show_edges_boxes_and_the_way_of_a_joint) {
  const FrameResult& frame = at(1.0);
  OverlayLines lines(loaded_);
  const Aabb size = frame.instances[0].bounds;
  const auto count = [&](const Inspected& inspected) {
    return lines.make(frame, inspected, false, {0, 1.0}, size).size();
  };
  EXPECT_EQ(count({}), 0u);
  EXPECT_EQ(count({.boxes = true}), 2 * 2 * 12u);
  const std::size_t triangles = loaded_.scene.meshes[0].primitives[0].indices.size() / 3;
  const std::size_t edges = 2 * 6 * 5;  // each side of a box has its own four vertices, and a diagonal
  EXPECT_EQ(triangles, 12u);
  EXPECT_EQ(count({.wireframe = true}), 2 * edges);
  EXPECT_EQ(count({.joint = 2}), 6u);
  EXPECT_EQ(count({.joint = 99, .trail = true}), 0u) << "no such joint";
  const auto trail = lines.make(frame, {.joint = 2, .trail = true}, false, {0, 1.0}, size).subspan(6);
  ASSERT_EQ(trail.size(), 2 * 63u);
  EXPECT_LT(glm::distance(trail.front().position, glm::vec3(1, 0, 0)), 1e-6f);
  EXPECT_LT(glm::distance(trail.back().position, glm::vec3(1, 2, 0)), 1e-6f);
  const auto box = lines.make(frame, {.boxes = true}, false, {0, 1.0}, size);
  float top = 0.0f;
  for (const LineVertex& vertex : box) top = std::max(top, vertex.position.y);
  EXPECT_NEAR(top, 1.25f, 1e-6f) << "of this moment";
}

TEST_F(Inspect, ghosts_are_fainter_the_farther_they_are_in_time) {
  const FrameResult& frame = at(1.0);
  OverlayLines lines(loaded_);
  const auto ghosts = lines.make(frame, {.ghosts = true}, false, {0, 1.0}, frame.instances[0].bounds);
  const std::size_t each = SkeletonLines::kVerticesPerBone * 2 + 6 * 3;
  ASSERT_EQ(ghosts.size(), 6 * each);
  EXPECT_GT(ghosts[0].rgba >> 24, ghosts[2 * each].rgba >> 24);
  const auto at_start = lines.make(frame, {.ghosts = true}, false, {0, 0.0}, frame.instances[0].bounds);
  EXPECT_EQ(at_start.size(), 3 * each) << "nothing is before the start";
}

}  // namespace
}  // namespace sinew::viewer
