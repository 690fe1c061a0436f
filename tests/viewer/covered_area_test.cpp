// SPDX-License-Identifier: MIT
// The area for which ambient occlusion is computed: its texels, and that it has no effect on pictures.
#include "viewer/passes/covered_area.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "samples/showcase/shapes.h"
#include "tests/support/fixed_random.h"
#include "tests/viewer/device_fixture.h"
#include "viewer/app/headless.h"

namespace sinew::viewer {
namespace {

/// From the origin along -z; at distance 10 the picture is 10 metres high.
View view_ahead() { return look_at({0, 0, 0}, {0, 0, -1}, 2.0 * std::atan(0.5), 1.0); }

Aabb box_around(const glm::vec3& middle, const glm::vec3& half) { return {middle - half, middle + half}; }

/// The texels of one box, in a picture with aspect 2.
VkRect2D texels_of(const View& view, const Aabb& box, VkExtent2D picture, std::uint32_t step) {
  CoveredArea area(view, 2.0);
  area.add_box(view.view_from_world, box);
  return area.texels(picture, step);
}

void expect_rect(const VkRect2D& rect, std::int32_t x, std::int32_t y, std::uint32_t width, std::uint32_t height) {
  EXPECT_EQ(rect.offset.x, x);
  EXPECT_EQ(rect.offset.y, y);
  EXPECT_EQ(rect.extent.width, width);
  EXPECT_EQ(rect.extent.height, height);
}

TEST(covered_area, is_the_rectangle_of_the_corners_and_a_texel_around_it) {
  const Aabb flat = box_around({3.05f, 2.05f, -10}, {1, 0.5f, 0});  // ten pixels a metre
  expect_rect(texels_of(view_ahead(), flat, {200, 100}, 1), 119, 23, 23, 13);
  expect_rect(texels_of(view_ahead(), flat, {200, 100}, 2), 59, 11, 13, 8);
  View parallel = view_ahead();
  parallel.half_height_m = 5.0;
  parallel.far_m = 100.0;
  expect_rect(texels_of(parallel, box_around({3.05f, 2.05f, -70}, {1, 0.5f, 20}), {200, 100}, 1), 119, 23, 23, 13);
  CoveredArea two(view_ahead(), 2.0);
  two.add_box(view_ahead().view_from_world, flat);
  two.add_point({-4.05, 1.05, -10});
  expect_rect(two.texels({200, 100}, 1), 58, 23, 84, 18);
}

TEST(covered_area, ends_at_the_edges_of_the_picture) {
  expect_rect(texels_of(view_ahead(), box_around({10, 5, -10}, {1, 1, 0}), {200, 100}, 1), 189, 0, 11, 11);
  expect_rect(texels_of(view_ahead(), box_around({-10, -5, -10}, {1, 1, 0}), {200, 100}, 1), 0, 89, 11, 11);
  for (const float side : {-30.0f, 30.0f}) {
    EXPECT_EQ(texels_of(view_ahead(), box_around({side, 0, -10}, {1, 1, 0}), {200, 100}, 1).extent.width, 0u);
    EXPECT_EQ(texels_of(view_ahead(), box_around({0, side, -10}, {1, 1, 0}), {200, 100}, 1).extent.height, 0u);
  }
  expect_rect(texels_of(view_ahead(), box_around({0, 0, -10}, {40, 40, 0}), {13, 7}, 2), 0, 0, 7, 4);
  expect_rect(texels_of(view_ahead(), box_around({0, 0, -10}, {40, 40, 0}), {1, 1}, 2), 0, 0, 1, 1);
}

TEST(covered_area, is_nothing_without_surfaces_and_everything_where_bounds_are_unknown_or_reach_the_eye) {
  expect_rect(CoveredArea(view_ahead(), 2.0).texels({200, 100}, 2), 0, 0, 0, 0);
  expect_rect(texels_of(view_ahead(), {}, {200, 100}, 2), 0, 0, 100, 50);
  expect_rect(texels_of(view_ahead(), box_around({5, 0, -1}, {0.1f, 0.1f, 0.5f}), {200, 100}, 2), 0, 0, 100, 50);
  CoveredArea more(view_ahead(), 2.0);
  more.add_point({100, 0, -10});
  more.add_everything();
  expect_rect(more.texels({200, 100}, 1), 0, 0, 200, 100);
}

TEST(covered_area, holds_every_point_of_its_boxes) {
  test::FixedRandom random(1);
  int inside = 0;
  for (int i = 0; i < 200; ++i) {
    View view = look_at(3.0 * random.vec3<double>(), random.vec3<double>(), 0.3 + 0.1 * (i % 10), 0.1);
    if (i % 2 == 1) {
      view.half_height_m = 1.5;
      view.far_m = 20.0;
    }
    const VkExtent2D picture{61u + static_cast<std::uint32_t>(i % 7), 33};
    const double aspect = static_cast<double>(picture.width) / picture.height;
    const Aabb box = box_around(random.vec3<float>(), glm::abs(random.vec3<float>()) + 0.01f);
    CoveredArea area(view, aspect);
    area.add_box(view.view_from_world, box);
    const std::uint32_t step = 1u + static_cast<std::uint32_t>(i % 3);
    const VkRect2D texels = area.texels(picture, step);
    for (int k = 0; k < 50; ++k) {
      const glm::dvec3 part = 0.5 * (random.vec3<double>() + 1.0);
      const glm::dvec3 p =
          transform_point(view.view_from_world, glm::mix(glm::dvec3(box.lower), glm::dvec3(box.upper), part));
      const glm::dvec4 clip = clip_from_view(view, aspect) * glm::dvec4(p, 1.0);
      if (clip.w < view.near_m) continue;
      const int x = static_cast<int>(std::floor((clip.x / clip.w * 0.5 + 0.5) * picture.width / step)),
                y = static_cast<int>(std::floor((0.5 - clip.y / clip.w * 0.5) * picture.height / step));
      if (x < 0 || y < 0 || x * step >= picture.width || y * step >= picture.height) continue;
      ++inside;
      EXPECT_TRUE(x >= texels.offset.x && x < texels.offset.x + static_cast<int>(texels.extent.width)) << i;
      EXPECT_TRUE(y >= texels.offset.y && y < texels.offset.y + static_cast<int>(texels.extent.height)) << i;
    }
  }
  EXPECT_GT(inside, 1000);
}

class covered_area_picture : public DeviceTest {};

constexpr std::uint32_t kWidth = 160, kHeight = 48;

/// Two balls that touch, in the middle of a wide picture; with specks in two of its corners, or without.
BuiltScene balls(bool specks) {
  BuiltScene built;
  const std::uint32_t material = built.add_material(matte({0.8f, 0.6f, 0.4f}));
  for (const float side : {-1.0f, 1.0f}) built.add(showcase::sphere({0.4f * side, 0, -5}, 0.5f), material);
  if (specks)
    for (const float side : {-1.0f, 1.0f}) built.add(showcase::sphere({side * 8.2f, side * 2.4f, -5}, 0.02f), material);
  return built;
}

std::uint64_t occlusion_texels(const Headless& pictures) {
  return pictures.report().passes[static_cast<std::size_t>(Pass::ssao)].count;
}

TEST_F(covered_area_picture, ambient_occlusion_is_the_same_where_the_whole_picture_is_computed) {
  const View view = view_ahead();
  for (const OcclusionMethod method : {OcclusionMethod::ssao, OcclusionMethod::gtao})
    for (const bool lit : {false, true}) {
      RenderOptions options;
      options.show = lit ? Show::color : Show::ao;
      options.ao.method = method;
      options.ao.radius_m = 0.5f;
      options.ao.surface_epsilon_m = 0.01f;
      options.ao.fade_start_m = 0.2f;
      options.ao.fade_end_m = 1.0f;
      if (lit) options.lighting.environment = studio_environment();
      const BuiltScene part = balls(false), whole = balls(true);
      const FloatPicture seen = render_float(part, kWidth, kHeight, view, options),
                         expected = render_float(whole, kWidth, kHeight, view, options);
      int dark = 0;
      for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 8; x < kWidth - 8; ++x) {
          EXPECT_EQ(seen.at(x, y), expected.at(x, y)) << x << ", " << y;
          dark += seen.at(x, y).r < 0.9f;
        }
      EXPECT_GT(dark, 10);
    }
}

TEST_F(covered_area_picture, meshes_that_moved_are_where_they_are_now_and_points_may_be_anywhere) {
  RenderOptions options;
  options.show = Show::ao;
  const auto texels = [&](const BuiltScene& built, const Aabb& bounds) {
    Headless pictures(*test_device(), built.scene, kWidth, kHeight);
    FrameResult frame = built.frame();
    std::vector<InstanceResult> instances(frame.instances.begin(), frame.instances.end());
    for (InstanceResult& instance : instances) instance.bounds = bounds;
    frame.instances = instances;
    pictures.render(frame, view_ahead(), options);
    return occlusion_texels(pictures);
  };
  BuiltScene ball;
  const std::uint32_t material = ball.add_material(matte({0.8f, 0.6f, 0.4f}));
  const Primitive shape = showcase::sphere({0, 0, -5}, 0.5f);
  ball.add(shape, material);
  const std::uint64_t at_rest = texels(ball, {});
  EXPECT_LT(at_rest, 100u);
  std::vector<glm::vec3> larger = shape.positions;
  for (glm::vec3& p : larger) p = {3.0f * p.x, 3.0f * p.y, p.z};
  ball.deform(0, larger, shape.normals);
  EXPECT_GT(texels(ball, {{-1.5f, -1.5f, -5.5f}, {1.5f, 1.5f, -4.5f}}), 2 * at_rest);
  EXPECT_EQ(texels(ball, {}), kWidth / 2 * kHeight / 2) << "nobody knows where";
  BuiltScene points;
  Primitive dots;
  dots.topology = Topology::points;
  dots.positions = {{0, 0, -5}};
  dots.indices = {0};
  dots.bounds.add(dots.positions[0]);
  points.add(dots, points.add_material(matte({1, 1, 1})));
  EXPECT_EQ(texels(points, {}), kWidth / 2 * kHeight / 2);
}

TEST_F(covered_area_picture, P17_work_is_told_and_is_that_of_the_area) {
  RenderOptions options;
  options.show = Show::ao;
  const auto texels = [&](bool specks) {
    const BuiltScene built = balls(specks);
    Headless pictures(*test_device(), built.scene, kWidth, kHeight);
    pictures.render(built.frame(), view_ahead(), options);
    return occlusion_texels(pictures);
  };
  EXPECT_EQ(texels(true), kWidth / 2 * kHeight / 2) << "half of the size along each axis";
  // Seen from the eye, the nearest corners of the boxes are at (0.9, 0.5, -4.5): 4.8 texels a metre there.
  EXPECT_EQ(texels(false), 12u * 8u);
}

}  // namespace
}  // namespace sinew::viewer
