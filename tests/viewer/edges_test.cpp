// SPDX-License-Identifier: MIT
// Multisampled edges, compared with exact pixel coverage.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "samples/showcase/shapes.h"
#include "tests/viewer/reference_picture.h"
#include "viewer/app/headless.h"

namespace sinew::viewer {
namespace {

constexpr int kSize = 48;

class edges : public DeviceTest {};

Material glowing(const glm::vec3& color) {
  Material material = matte(color);
  material.unlit = true;
  material.double_sided = true;
  return material;
}

/// A parallel projection, 2.4 m high. A point (x, y, z) is at the pixel (24 + 20 x, 24 - 20 y).
View straight() {
  View view = look_at({0, 0, 3}, {0, 0, 0}, 0.8, 0.1);
  view.half_height_m = 1.2;
  view.far_m = 10.0;
  return view;
}

RenderOptions plain(bool smooth) {
  RenderOptions options = only_scene_lights();
  options.lighting.tone_curve = ToneCurve::none;
  options.transparent_background = true;
  options.smooth_edges = smooth;
  return options;
}

/// Fraction of a pixel's area where `inside` is true, from 400 points.
template <class Inside>
double area(int x, int y, const Inside& inside) {
  int count = 0;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j)
      count += inside((x + (i + 0.5) / 20.0 - 24.0) / 20.0, (24.0 - y - (j + 0.5) / 20.0) / 20.0);
  return count / 400.0;
}

/// Greatest and mean difference between alpha and the area.
template <class Inside>
glm::dvec2 off(const FloatPicture& drawn, const Inside& inside) {
  glm::dvec2 worst(0.0);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const double difference = std::abs(static_cast<double>(drawn.at(x, y).a) - area(x, y, inside));
      worst = {std::max(worst.x, difference), worst.y + difference / (kSize * kSize)};
    }
  return worst;
}

TEST_F(edges, alpha_is_the_area_that_a_surface_covers) {
  BuiltScene built;
  Affine turned = affine_from(glm::mat3(glm::vec3(0.9f, 0.3f, 0.0f), glm::vec3(0, 0, 1), glm::vec3(0.3f, -0.9f, 0.0f)),
                              {0.0f, 0.0f, 0.0f});
  built.add(square(0.7f), built.add_material(glowing({1.0f, 1.0f, 1.0f})), turned);
  const auto inside = [](double x, double y) {
    const double u = (0.9 * x + 0.3 * y) / 0.9, v = (0.3 * x - 0.9 * y) / 0.9;  // the columns have length sqrt(0.9)
    return std::abs(u) <= 0.7 && std::abs(v) <= 0.7;
  };
  const glm::dvec2 sharp = off(render_float(built, kSize, kSize, straight(), plain(false)), inside),
                   smooth = off(render_float(built, kSize, kSize, straight(), plain(true)), inside);
  EXPECT_LT(smooth.x, 0.3);
  EXPECT_GT(sharp.x, 0.4);
  EXPECT_LT(smooth.y, 0.5 * sharp.y);
}

/// Two surfaces that cut each other along a slanted line.
BuiltScene crossed() {
  BuiltScene built;
  built.add(wall(), built.add_material(glowing({1.0f, 0.0f, 0.0f})));
  const Affine tilted =
      affine_from(glm::mat3(glm::vec3(0.8f, 0.0f, 0.6f), glm::vec3(0.1f, 1.0f, 0.3f), glm::vec3(-0.6f, 0.0f, 0.8f)),
                  {0.0f, 0.0f, 0.0f});
  built.add(wall(), built.add_material(glowing({0.0f, 1.0f, 0.0f})), tilted);
  return built;
}

TEST_F(edges, alpha_masks_are_as_smooth_as_outlines) {
  BuiltScene built;
  Primitive sheet = wall();
  for (const glm::vec3& p : sheet.positions)
    sheet.colors.push_back({1.0f, 1.0f, 1.0f, 0.4f + 0.2f * p.x + 0.11f * p.y});
  Material cut = glowing({1.0f, 1.0f, 1.0f});
  cut.alpha_mode = AlphaMode::mask;
  cut.alpha_cutoff = 0.43f;
  built.add(sheet, built.add_material(cut));
  const auto inside = [](double x, double y) { return 0.4 + 0.2 * x + 0.11 * y > 0.43; };
  const glm::dvec2 sharp = off(render_float(built, kSize, kSize, straight(), plain(false)), inside),
                   smooth = off(render_float(built, kSize, kSize, straight(), plain(true)), inside);
  EXPECT_GT(sharp.x, 0.4);
  EXPECT_LT(smooth.x, 0.25);
  EXPECT_LT(smooth.y, 0.6 * sharp.y);
}

TEST_F(edges, masks_of_even_alpha_are_whole_or_nothing) {
  for (const float alpha : {0.499f, 0.5f, 0.501f}) {
    BuiltScene built;
    Material cut = glowing({1.0f, 1.0f, 1.0f});
    cut.alpha_mode = AlphaMode::mask;
    cut.base_color.a = alpha;
    built.add(wall(), built.add_material(cut));
    EXPECT_EQ(render_float(built, kSize, kSize, straight(), plain(true)).at(24, 24).a, alpha < 0.5f ? 0.0f : 1.0f);
  }
}

TEST_F(edges, depth_is_tested_for_each_sample) {
  // z of the tilted wall at (x, y): a (0.8, 0, 0.6) + b (0.1, 1, 0.3), so b = y and a = (x - 0.1 y) / 0.8
  const auto green = [](double x, double y) { return 0.6 * (x - 0.1 * y) / 0.8 + 0.3 * y > 0.0; };
  double worst[2] = {};
  for (const bool smooth : {false, true}) {
    const FloatPicture drawn = render_float(crossed(), kSize, kSize, straight(), plain(smooth));
    for (int y = 12; y < 36; ++y)
      for (int x = 12; x < 36; ++x)
        worst[smooth] = std::max(worst[smooth], std::abs(std::pow(drawn.at(x, y).g, 2.2) - area(x, y, green)));
  }
  EXPECT_GT(worst[0], 0.4);
  EXPECT_LT(worst[1], 0.3);
}

TEST_F(edges, surfaces_themselves_look_the_same) {
  const BuiltScene built = box_and_sphere_on_floor();
  RenderOptions options;
  options.shadows = {true, {glm::vec3(-4.0f), glm::vec3(4.0f)}};
  const View view = look_at({2.5, 3.2, 4.0}, {0.0, 0.3, 0.0}, 0.8, 0.05);
  const FloatPicture sharp = render_float(built, kSize, kSize, view, options);
  options.smooth_edges = true;
  const FloatPicture smooth = render_float(built, kSize, kSize, view, options);
  int same = 0;
  for (std::size_t i = 0; i < sharp.pixels.size(); ++i) same += glm::length(sharp.pixels[i] - smooth.pixels[i]) < 0.01f;
  EXPECT_GT(same, kSize * kSize * 8 / 10);
}

/// A wheel of thin triangles that are at most half red.
BuiltScene red_wheel() {
  BuiltScene built;
  Primitive p;
  for (int i = 0; i < 60; ++i) {
    const float a = 0.1f * static_cast<float>(i), b = a + 0.03f;
    const auto corner = static_cast<std::uint32_t>(p.positions.size());
    p.indices.insert(p.indices.end(), {corner, corner + 1, corner + 2});
    p.positions.insert(p.positions.end(),
                       {glm::vec3(0.0f), {std::cos(a), std::sin(a), 0}, {std::cos(b), std::sin(b), 0}});
    p.colors.insert(p.colors.end(), {{0.5f, 0, 0, 1}, {0.5f, 0, 0, 1}, {0, 0, 0, 1}});
  }
  built.add(p, built.add_material(glowing({1.0f, 1.0f, 1.0f})));
  return built;
}

TEST_F(edges, colours_are_those_where_the_pixel_is_covered) {
  const FloatPicture drawn = render_float(red_wheel(), kSize, kSize, straight(), plain(true));
  int partly = 0;
  for (const glm::vec4& pixel : drawn.pixels) {
    partly += pixel.a > 0.0f && pixel.a < 1.0f;
    EXPECT_LE(pixel.r, 0.736f) << "0.5 as displayed";
  }
  EXPECT_GT(partly, 300);
}

TEST_F(edges, blended_surfaces_are_smooth_too_and_lie_over_what_is_behind) {
  BuiltScene built = crossed();
  Material glass = glowing({0.0f, 0.0f, 1.0f});
  glass.alpha_mode = AlphaMode::blend;
  glass.base_color.a = 0.5f;
  const Affine front = affine_from(
      glm::mat3(glm::vec3(0.9f, 0.3f, 0.0f), glm::vec3(0, 0, 1), glm::vec3(0.3f, -0.9f, 0.0f)), {0.0f, 0.0f, 1.5f});
  built.add(square(0.5f), built.add_material(glass), front);
  const FloatPicture sharp = render_float(built, kSize, kSize, straight(), plain(false)),
                     smooth = render_float(built, kSize, kSize, straight(), plain(true));
  EXPECT_EQ(sharp.at(20, 24), smooth.at(20, 24));
  int between = 0;
  for (const glm::vec4& pixel : smooth.pixels) between += pixel.b > 0.1f && pixel.b < 0.6f;
  EXPECT_GT(between, 20);
}

TEST_F(edges, nothing_of_it_exists_where_it_is_switched_off_or_a_buffer_is_shown) {
  EXPECT_FALSE(FrameGraph({.opaque = true}).sampled);
  EXPECT_FALSE(FrameGraph({.opaque = true, .smooth_edges = true, .show = Show::normals}).sampled);
  const FrameGraph graph({.opaque = true, .occlusion = false, .smooth_edges = true});
  EXPECT_TRUE(graph.sampled);
  EXPECT_FALSE(graph.depth_image) << "only the depth of the samples is needed";
}

}  // namespace
}  // namespace sinew::viewer
