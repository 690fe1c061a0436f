// SPDX-License-Identifier: MIT
// Features that change the picture without moving a vertex: orthographic cameras, copies, variants, animated materials
// and visibility.
#include "tests/viewer/device_fixture.h"
#include "viewer/app/headless.h"
#include "viewer/passes/draw_list.h"

namespace sinew::viewer {
namespace {

class look : public DeviceTest {};

constexpr std::uint32_t kLookSize = 64;

Material glowing(const glm::vec3& color) {
  Material material;
  material.unlit = true;
  material.base_color = glm::vec4(color, 1.0f);
  return material;
}

/// A square of 1 m in the plane y = 0, seen from above by a parallel camera that shows 4 m by 4 m.
struct Seen {
  BuiltScene built;
  View view = look_at({0.0, 3.0, 0.0}, {0.0, 0.0, 0.0}, 0.8, 0.5);

  Seen() {
    view.half_height_m = 2.0;
    view.far_m = 10.0;
    built.add(square(0.5f), built.add_material(glowing({1, 0, 0})));
  }
  Picture picture(std::uint32_t variant = kNone, const FrameResult* frame = nullptr) {
    Headless renderer(*test_device(), built.scene, kLookSize, kLookSize);
    RenderOptions options;
    options.transparent_background = true;
    return renderer.render(frame ? *frame : built.frame(), view, options, {}, variant);
  }
};

std::size_t covered(const Picture& picture) {
  std::size_t count = 0;
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) count += picture.rgba[i] == 255;
  return count;
}

const std::uint8_t* middle(const Picture& picture) {
  return &picture.rgba[4 * (kLookSize / 2 * kLookSize + kLookSize / 2)];
}

TEST_F(look, a_parallel_camera_shows_the_same_size_at_any_distance) {
  Seen seen;
  const std::size_t near = covered(seen.picture());
  EXPECT_EQ(near, 16u * 16u) << "1 m of 4 m on 64 pixels";
  seen.view = look_at({0.0, 8.0, 0.0}, {0.0, 0.0, 0.0}, 0.8, 0.5);
  seen.view.half_height_m = 2.0;
  seen.view.far_m = 10.0;
  EXPECT_EQ(covered(seen.picture()), near);
  seen.view.far_m = 7.5;
  EXPECT_EQ(covered(seen.picture()), 0u) << "behind the far plane";
}

TEST_F(look, N30_a_far_plane_cuts_and_keeps_the_distances_before_it) {
  Seen seen;
  seen.view = look_at({0.5, 3.0, 1.5}, {0.0, 0.0, 0.0}, 0.8, 0.5);
  const auto without = gpu_depth_and_normals(seen.built, kLookSize, kLookSize, seen.view, {});
  seen.view.far_m = 4.5;
  const auto with = gpu_depth_and_normals(seen.built, kLookSize, kLookSize, seen.view, {});
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < with.distance.size(); ++i) {
    drawn += with.distance[i] > 0.0;
    ASSERT_NEAR(with.distance[i], without.distance[i], 1e-4);
  }
  EXPECT_GT(drawn, 100u);
  seen.view.far_m = 3.4;  // through the middle of the square
  std::size_t kept = 0;
  for (const double d : gpu_depth_and_normals(seen.built, kLookSize, kLookSize, seen.view, {}).distance) {
    kept += d > 0.0;
    EXPECT_LE(d, 3.4001);
  }
  EXPECT_GT(kept, drawn / 4);
  EXPECT_LT(kept, drawn * 3 / 4);
}

TEST_F(look, ambient_visibility_of_a_plane_is_open_in_a_parallel_view) {
  Seen seen;
  seen.built.scene.materials[0] = matte({0.5f, 0.5f, 0.5f});
  Headless renderer(*test_device(), seen.built.scene, kLookSize, kLookSize);
  RenderOptions options;
  options.show = Show::ao;
  const Picture picture = renderer.render(seen.built.frame(), seen.view, options);
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) ASSERT_GE(picture.rgba[i], 250);
}

TEST_F(look, every_copy_is_drawn) {
  Seen seen;
  const glm::quat none(1, 0, 0, 0);
  seen.built.scene.instances[0].copies = {
      {{-1, 0, 0}, none, {1, 1, 1}}, {{1, 0, 0}, none, {-1, 1, 1}}, {{0, 0, 1}, none, {0.5f, 1, 1}}};
  EXPECT_EQ(covered(seen.picture()), 2u * 16u * 16u + 8u * 16u);
}

TEST_F(look, a_variant_brings_its_material) {
  Seen seen;
  const std::uint32_t blue = seen.built.add_material(glowing({0, 0, 1}));
  seen.built.scene.variants = {"red", "blue"};
  seen.built.scene.meshes[0].primitives[0].variant_materials = {{1, blue}};
  EXPECT_GT(middle(seen.picture())[0], 200);
  EXPECT_GT(middle(seen.picture(0))[0], 200);
  EXPECT_GT(middle(seen.picture(1))[2], 200);
  EXPECT_LT(middle(seen.picture(1))[0], 60);
}

TEST_F(look, animated_materials_follow_the_frame) {
  Seen seen;
  seen.built.scene.properties.entries = {{{PropertyKind::base_color, 0}, 0, 4}};
  seen.built.scene.properties.rest = {1, 0, 0, 1};
  const float green[] = {0, 1, 0, 1};
  FrameResult frame = seen.built.frame();
  EXPECT_GT(middle(seen.picture(kNone, &frame))[0], 200);
  frame.properties = green;
  const Picture picture = seen.picture(kNone, &frame);
  EXPECT_GT(middle(picture)[1], 200);
  EXPECT_LT(middle(picture)[0], 60);
}

TEST_F(look, hidden_instances_are_not_drawn) {
  Seen seen;
  const FrameResult frame = seen.built.frame();
  InstanceResult hidden = frame.instances[0];
  hidden.visible = false;
  FrameResult other = frame;
  other.instances = {&hidden, 1};
  EXPECT_EQ(covered(seen.picture(kNone, &other)), 0u);
}

TEST_F(look, lights_follow_the_frame_and_go_out_with_their_hidden_node) {
  Seen seen;
  seen.built.scene.materials[0] = matte({1, 1, 1});
  seen.built.add_light({.kind = Light::Kind::point, .color = {1, 1, 1}, .intensity = 20.0f}, translation({0, 2, 0}));
  seen.built.scene.properties.entries = {{{PropertyKind::light_color, 0}, 0, 3}};
  seen.built.scene.properties.rest = {1, 1, 1};
  FrameResult frame = seen.built.frame();
  const Picture white = seen.picture(kNone, &frame);
  EXPECT_GT(middle(white)[2], 200);
  const float red[] = {1, 0, 0};
  frame.properties = red;
  const Picture reddish = seen.picture(kNone, &frame);
  EXPECT_GT(middle(reddish)[0], 200);
  EXPECT_LT(middle(reddish)[2], middle(white)[2] - 20);
  frame.properties = {};
  const bool hidden[] = {false, true};  // the light's joint
  frame.hidden = hidden;
  const Picture key_light = seen.picture(kNone, &frame);  // used when no light is left
  seen.built.scene.lights.clear();
  EXPECT_EQ(key_light.rgba, seen.picture(kNone, &frame).rgba);
}

TEST_F(look, P14_what_is_out_of_view_is_not_drawn_and_changes_no_pixel) {
  Seen seen;
  seen.view = look_at({0.3, 0.8, 0.4}, {0.0, 0.0, 0.0}, 0.8, 0.5);
  const Picture alone = seen.picture();
  seen.built.add(square(0.5f), seen.built.add_material(glowing({0, 1, 0})), translation({30, 0, 0}));
  seen.built.scene.instances[0].copies = {{{0, 0, 0}, glm::quat(1, 0, 0, 0), {1, 1, 1}},
                                          {{-40, 0, 0}, glm::quat(1, 0, 0, 0), {1, 1, 1}}};
  EXPECT_EQ(alone.rgba, seen.picture().rgba);

  const SceneUpload scene(*test_device(), seen.built.scene);
  FrameUpload frame(*test_device(), seen.built.scene, 1);
  frame.update(0, seen.built.frame());
  const DrawnScene drawn{&scene, &frame};
  DrawList draws;
  draws.collect({&drawn, 1}, 0, seen.view, 1.0, 1.0f);
  EXPECT_EQ(draws.opaque().size(), 1u);
  EXPECT_EQ(draws.out_of_view(), 2u);
}

TEST_F(look, P14_deformed_meshes_are_culled_by_the_box_of_their_vertices) {
  Seen seen;
  const Primitive shape = square(0.5f);
  std::vector<glm::vec3> away = shape.positions;
  for (glm::vec3& p : away) p.x += 50.0f;
  seen.built.deform(0, away, shape.normals);
  const auto draw_count = [&](const Aabb& bounds) {
    FrameResult result = seen.built.frame();
    InstanceResult instance = result.instances[0];
    instance.bounds = bounds;
    result.instances = {&instance, 1};
    const SceneUpload scene(*test_device(), seen.built.scene);
    FrameUpload frame(*test_device(), seen.built.scene, 1);
    frame.update(0, result);
    const DrawnScene drawn{&scene, &frame};
    DrawList draws;
    draws.collect({&drawn, 1}, 0, seen.view, 1.0, 1.0f);
    return draws.opaque().size();
  };
  EXPECT_EQ(draw_count({{49.5f, 0, -0.5f}, {50.5f, 0, 0.5f}}), 0u);
  EXPECT_EQ(draw_count({{-0.5f, 0, -0.5f}, {0.5f, 0, 0.5f}}), 1u) << "the rest pose's box does not count";
  EXPECT_EQ(draw_count({}), 1u) << "not asked for: drawn";
}

TEST_F(look, what_is_deformed_covers_the_box_of_its_vertices_wherever_its_node_is) {
  Seen seen;
  const Primitive shape = square(0.5f);
  BuiltScene built;
  built.add(shape, built.add_material(glowing({1, 0, 0})), translation({1.2f, 0.0f, 0.0f}));
  built.deform(0, shape.positions, shape.normals);
  FrameResult result = built.frame();
  InstanceResult instance = result.instances[0];
  instance.bounds = {{0.7f, 0, -0.5f}, {1.7f, 0, 0.5f}};
  result.instances = {&instance, 1};
  const SceneUpload scene(*test_device(), built.scene);
  FrameUpload frame(*test_device(), built.scene, 1);
  frame.update(0, result);
  const DrawnScene drawn{&scene, &frame};
  DrawList draws;
  draws.collect({&drawn, 1}, 0, seen.view, 1.0, 1.0f);
  CoveredArea expected(seen.view, 1.0);
  expected.add_box(seen.view.view_from_world, instance.bounds);
  const VkRect2D area = draws.opaque_area().texels({kLookSize, kLookSize}, 1),
                 box = expected.texels({kLookSize, kLookSize}, 1);
  EXPECT_EQ(area.offset.x, box.offset.x);
  EXPECT_EQ(area.offset.y, box.offset.y);
  EXPECT_EQ(area.extent.width, box.extent.width);
  EXPECT_EQ(area.extent.height, box.extent.height);
}

TEST_F(look, what_blends_in_any_order_lies_between_the_ends_of_its_bounds) {
  Seen seen;
  Material glass = matte(glm::vec3(0.5f));
  glass.alpha_mode = AlphaMode::blend;
  seen.built.scene.materials = {glass};
  for (Mesh& mesh : seen.built.scene.meshes) mesh.primitives[0].material = 0;
  const Primitive shape = square(0.5f);
  seen.built.deform(0, shape.positions, shape.normals);
  const auto range_of = [&](const Aabb& bounds, Transparency transparency = Transparency::weighted) {
    FrameResult result = seen.built.frame();
    InstanceResult instance = result.instances[0];
    instance.bounds = bounds;
    result.instances = {&instance, 1};
    const SceneUpload scene(*test_device(), seen.built.scene);
    FrameUpload frame(*test_device(), seen.built.scene, 1);
    frame.update(0, result);
    const DrawnScene drawn{&scene, &frame};
    DrawList draws;
    draws.collect({&drawn, 1}, 0, seen.view, 1.0, 1.0f, false, transparency);
    EXPECT_EQ(draws.weighted().size(), transparency == Transparency::weighted ? 1u : 0u);
    EXPECT_EQ(draws.blended().size(), transparency == Transparency::weighted ? 0u : 1u);
    return draws.weighted_range();
  };
  const auto distance = [&](const glm::vec3& point) {
    return static_cast<float>(-transform_point(seen.view.view_from_world, glm::dvec3(point)).z);
  };
  const Aabb box{{-0.5f, -0.25f, -0.5f}, {0.5f, 0.25f, 0.5f}};
  float nearest = 1e9f, farthest = 0.0f;
  for (int corner = 0; corner < 8; ++corner) {
    const float at = distance({corner & 1 ? 0.5f : -0.5f, corner & 2 ? 0.25f : -0.25f, corner & 4 ? 0.5f : -0.5f});
    nearest = std::min(nearest, at);
    farthest = std::max(farthest, at);
  }
  EXPECT_NEAR(range_of(box).nearest_m, nearest, 1e-5f);
  EXPECT_NEAR(range_of(box).farthest_m, farthest, 1e-5f);
  EXPECT_EQ(range_of({}).nearest_m, range_of({}).farthest_m) << "without bounds it is at its centre";
  EXPECT_NEAR(range_of({}).nearest_m, distance({0, 0, 0}), 1e-5f);
  range_of(box, Transparency::sorted);
}

}  // namespace
}  // namespace sinew::viewer
