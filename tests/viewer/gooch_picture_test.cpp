// SPDX-License-Identifier: MIT
// Gooch shading, compared with the reference renderer: tones, outlines, and skipped passes.
#include <algorithm>

#include "samples/showcase/shapes.h"
#include "tests/viewer/reference_picture.h"

namespace sinew::viewer {
namespace {

class gooch_picture : public DeviceTest {};

RenderOptions gooch() {
  RenderOptions options;
  options.shading = Shading::gooch;
  return options;
}

/// Tolerance for 8-bit display colours.
constexpr PictureBounds kBounds{.width = 32, .height = 26, .bound = 0.003, .sharp = 0.5};

View the_view() { return look_at({2.5, 2.2, 4.0}, {0.0, 0.4, 0.0}, 0.8, 0.05); }

TEST_F(gooch_picture, tones_go_from_cool_to_warm_with_the_light_and_have_a_white_highlight) {
  BuiltScene built;
  const Primitive ball = showcase::sphere({0.0f, 0.0f, 0.0f}, 1.0f);
  built.add(ball, built.add_material(matte({0.8f, 0.2f, 0.1f})));
  const View view = look_at({0.0, 0.0, 3.2}, {0.0, 0.0, 0.0}, 0.4, 0.05);  // inside of the contour
  expect_reference_picture(built, view, gooch(), kBounds);
  const FloatPicture drawn = render_float(built, 33, 33, view, gooch());
  float whitest = 0.0f;
  for (const glm::vec4& pixel : drawn.pixels) whitest = std::max(whitest, std::min({pixel.r, pixel.g, pixel.b}));
  EXPECT_GT(whitest, 0.95f);
}

TEST_F(gooch_picture, the_first_lamp_of_the_file_is_the_light_and_its_strength_does_not_count) {
  for (const float intensity : {0.01f, 1000.0f}) {
    BuiltScene built;
    built.add(wall(), built.add_material(matte({0.3f, 0.6f, 0.9f})));
    add_light_at(built, {.kind = Light::Kind::point, .intensity = intensity}, {-0.8f, 0.6f, 0.5f}, {0, 0, -1});
    add_light_at(built, {.kind = Light::Kind::directional, .intensity = 2.0f}, {0, 0, 1}, {1, -1, -1});
    expect_reference_picture(built, view_of_wall(), gooch(), kBounds);
  }
}

TEST_F(gooch_picture, outlines_are_at_silhouettes_and_creases_and_on_no_plane_however_steep) {
  const BuiltScene built = box_and_sphere_on_floor();
  View parallel = the_view();
  parallel.half_height_m = 1.8;
  parallel.far_m = 9.0;
  View cut = the_view();
  cut.far_m = 20.0;
  for (const View& view : {the_view(), parallel, cut}) expect_reference_picture(built, view, gooch(), kBounds);

  BuiltScene plane;
  plane.add(square(40.0f), plane.add_material(matte({1, 1, 1})));
  const View steep = look_at({0.0, 0.3, 0.0}, {0.0, -0.2, -2.0}, 0.3, 0.05);
  View near_parallel = look_at({0.0, 0.3, 0.0}, {0.0, -0.2, -0.4}, 0.3, 0.05);
  near_parallel.half_height_m = 0.1;
  near_parallel.far_m = 9.0;
  for (const View& view : {steep, near_parallel})
    for (const glm::vec4& pixel : render_float(plane, 64, 64, view, gooch()).pixels)
      EXPECT_GT(pixel.r, 0.2f) << "a line on a plane";
}

TEST_F(gooch_picture, outlines_of_steps_near_a_parallel_camera_are_as_black_as_the_steps_are_high) {
  View view = look_at({0.0, 0.0, 0.4}, {0.0, 0.0, 0.0}, 0.8, 0.05);
  view.half_height_m = 1.0;  // a pixel is 0.077 m, a step of 0.45 m six of them: part of a line
  view.far_m = 4.0;
  BuiltScene built;
  const std::uint32_t material = built.add_material(matte({0.8f, 0.6f, 0.4f}));
  for (const float step : {0.0f, 1.0f, 2.0f})
    built.add(wall(), material, translation({1.3f - 0.7f * step, -0.1f * step, -0.45f * step}));
  expect_reference_picture(built, view, gooch(), kBounds);
}

TEST_F(gooch_picture, outlines_are_not_beside_points_that_have_no_normals) {
  BuiltScene built;
  const std::uint32_t material = built.add_material(matte({0.8f, 0.6f, 0.4f}));
  const View view = look_at({0.0, 0.0, 2.0}, {0.0, 0.0, 0.0}, 0.8, 0.05);  // the wall fills the picture
  built.add(wall(), material);
  const FloatPicture alone = render_float(built, 32, 26, view, gooch());
  Primitive dots;
  dots.topology = Topology::points;
  for (float x = -0.8f; x < 0.9f; x += 0.4f) dots.positions.emplace_back(x, 0.1f, 0.001f);
  for (std::uint32_t i = 0; i < dots.positions.size(); ++i) dots.indices.push_back(i);
  built.add(dots, material);
  const FloatPicture drawn = render_float(built, 32, 26, view, gooch());
  int changed = 0;
  for (std::size_t i = 0; i < drawn.pixels.size(); ++i) {
    changed += drawn.pixels[i] != alone.pixels[i];
    EXPECT_GT(drawn.pixels[i].r, 0.2f) << "a line at pixel " << i;
  }
  EXPECT_EQ(changed, 5 * 4 * 4) << "nothing but the points, 4 pixels wide";
}

TEST_F(gooch_picture, normal_maps_make_creases_and_change_no_tone) {
  const View view = look_at({0.3, 0.2, 3.0}, {0.0, 0.0, 0.0}, 0.5, 0.05);
  for (const bool tangents : {false, true})
    for (const bool mapped : {false, true}) {
      BuiltScene built;
      Primitive p = wall();
      if (!tangents) p.tangents.clear();
      Material material = matte({0.8f, 0.6f, 0.4f});
      built.add(p, built.add_material(material), translation({-1.2f, 0.0f, 0.0f}));
      if (mapped) material.normal_texture.texture = add_plain_texture(built, {196, 60, 200, 255});
      built.add(p, built.add_material(material), translation({1.2f, 0.0f, 0.0f}));
      expect_reference_picture(built, view, gooch(), kBounds);
      int black = 0;
      for (const glm::vec4& pixel : render_float(built, 24, 20, view, gooch()).pixels) black += pixel.r < 0.1f;
      EXPECT_EQ(black > 0, mapped);
    }
}

TEST_F(gooch_picture, blended_masked_and_unlit_surfaces_are_as_the_reference_has_them) {
  BuiltScene built = box_and_sphere_on_floor();
  Material glass = matte({0.2f, 0.3f, 0.9f});
  glass.base_color.a = 0.4f;
  glass.alpha_mode = AlphaMode::blend;
  built.add(wall(), built.add_material(glass), translation({-0.5f, 0.6f, 1.3f}));
  Material plain = matte({0.1f, 0.9f, 0.3f});
  plain.unlit = true;
  built.add(wall(), built.add_material(plain), translation({0.9f, 0.8f, -1.5f}));
  Material holes = matte({1, 1, 1});
  holes.alpha_mode = AlphaMode::mask;
  holes.base_color_texture.texture = add_noise_texture(built);
  built.add(wall(), built.add_material(holes), translation({-1.3f, 1.2f, -1.2f}));
  for (const bool transparent : {false, true}) {
    RenderOptions options = gooch();
    options.transparent_background = transparent;
    PictureBounds bounds = kBounds;
    bounds.bound = kDecodedBound;
    expect_reference_picture(built, the_view(), options, bounds);
  }
}

TEST_F(gooch_picture, glass_is_opaque_but_for_the_holes_of_its_mask) {
  BuiltScene built;
  built.add(wall(), built.add_material(matte({0.9f, 0.3f, 0.1f})), translation({0.0f, 0.0f, -0.1f}));
  Material glass = matte({0.6f, 0.9f, 1.0f});
  glass.alpha_mode = AlphaMode::mask;
  glass.transmission.factor = 0.8f;
  glass.base_color_texture.texture = add_noise_texture(built);
  built.add(wall(), built.add_material(glass));
  PictureBounds bounds = kBounds;
  bounds.bound = kDecodedBound;
  expect_reference_picture(built, view_of_wall(), gooch(), bounds);
}

TEST_F(gooch_picture, exposure_tone_curve_shadows_and_environment_change_no_byte) {
  const BuiltScene built = box_and_sphere_on_floor();
  const FloatPicture plain = render_float(built, 24, 20, the_view(), gooch());
  RenderOptions options = gooch();
  options.lighting.exposure = 7.0f;
  options.lighting.auto_exposure = true;
  options.lighting.tone_curve = ToneCurve::aces;
  options.lighting.environment = nullptr;
  options.ao.on = false;
  options.shadows = {true, {{-3.0f, -1.0f, -3.0f}, {3.0f, 3.0f, 3.0f}}};
  options.ground = ground_for(options.shadows.bounds);
  options.ground.look = GroundLook::shadows;
  EXPECT_EQ(plain.pixels, render_float(built, 24, 20, the_view(), options).pixels);
}

TEST_F(gooch_picture, the_backdrop_is_the_environment_as_in_physical_shading) {
  BuiltScene built;
  built.add(showcase::sphere({0.0f, 0.4f, 0.0f}, 0.5f), built.add_material(matte({0.8f, 0.2f, 0.1f})));
  for (const Backdrop backdrop : {Backdrop::blurred, Backdrop::sharp}) {
    RenderOptions options = gooch();
    options.backdrop = backdrop;
    options.lighting.environment = studio_environment();
    const FloatPicture drawn = render_float(built, 24, 20, the_view(), options);
    options.shading = Shading::physical;
    const FloatPicture physical = render_float(built, 24, 20, the_view(), options);
    for (int x = 0; x < 24; ++x)
      for (const int y : {0, 19}) EXPECT_EQ(drawn.at(x, y), physical.at(x, y)) << x << ' ' << y;
    EXPECT_NE(drawn.at(0, 0), drawn.at(23, 19)) << "it is not plain";
  }
}

TEST_F(gooch_picture, smooth_edges_are_black_where_a_surface_covers_less_than_the_middle_of_a_pixel) {
  View view = look_at({0.0, 0.0, 3.0}, {0.0, 0.0, 0.0}, 0.6, 0.05);
  view.half_height_m = 2.0;
  view.far_m = 9.0;
  RenderOptions options = gooch();
  options.smooth_edges = true;
  options.transparent_background = true;
  // A pixel is 0.1 m wide. Two opposite edges of the wall cover 0.75 of their pixels and thus the pixel centers. The
  // other two cover 0.3 and no center.
  for (const glm::vec2& half : {glm::vec2(1.075f, 1.03f), {1.03f, 1.075f}}) {
    BuiltScene built;
    Primitive p = wall();
    for (glm::vec3& at : p.positions) at = {at.x > 0.0f ? half.x : -half.x, at.y > 0.0f ? half.y : -half.y, 0.0f};
    built.add(p, built.add_material(matte({0.2f, 0.9f, 0.2f})));
    int partly = 0;
    for (const glm::vec4& pixel : render_float(built, 40, 40, view, options).pixels) {
      if (pixel.a == 0.0f || pixel.a == 1.0f) continue;
      ++partly;
      EXPECT_LT(std::max({pixel.r, pixel.g, pixel.b}), 0.01f);
    }
    EXPECT_EQ(partly, 84);
  }
}

TEST_F(gooch_picture, smooth_edges_have_lines_on_what_is_covered_alone) {
  BuiltScene built;
  built.add(wall(), built.add_material(matte({0.2f, 0.9f, 0.2f})));
  RenderOptions options = gooch();
  options.smooth_edges = true;
  options.background = {1, 1, 1};
  const View far = look_at({1.0, 0.7, 6.0}, {0.0, 0.0, 0.0}, 0.6, 0.05);
  const FloatPicture drawn = render_float(built, 40, 40, far, options);
  int partly = 0;
  for (const glm::vec4& pixel : drawn.pixels) {
    const bool grey = std::abs(pixel.r - pixel.g) < 0.01f && std::abs(pixel.b - pixel.g) < 0.01f;
    partly += grey && pixel.r > 0.3f && pixel.r < 0.95f;  // shares of a line and of the white behind
  }
  EXPECT_GT(partly, 12) << "the outer edges of lines are smooth";
  EXPECT_NEAR(drawn.at(0, 0).r, 1.0f, 0.001f);
}

}  // namespace
}  // namespace sinew::viewer
