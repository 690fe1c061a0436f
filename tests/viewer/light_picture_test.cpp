// SPDX-License-Identifier: MIT
// Pictures of one term of the light model each, compared with the reference renderer.
#include <array>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "samples/showcase/shapes.h"
#include "tests/reference/picture.h"
#include "tests/reference/shade.h"
#include "tests/viewer/reference_picture.h"
#include "viewer/app/headless.h"
#include "viewer/passes/frame_uniforms.h"

namespace sinew::viewer {
namespace {

class light_picture : public DeviceTest {};

BuiltScene matte_wall() {
  BuiltScene built;
  built.add(wall(), built.add_material(matte({0.8f, 0.7f, 0.6f})));
  return built;
}

BuiltScene ball(float metallic, float roughness) {
  BuiltScene built;
  Material material = matte({0.8f, 0.5f, 0.3f});
  material.metallic = metallic;
  material.roughness = roughness;
  built.add(showcase::sphere({0, 0, 0}, 0.9f, 20, 12), built.add_material(material));
  return built;
}

View view_of_ball() { return look_at({0.8, 1.2, 2.2}, {0.0, 0.0, 0.0}, 0.75, 0.05); }

Light lamp(Light::Kind kind, float intensity) {
  return {.kind = kind, .color = {1.0f, 0.8f, 0.5f}, .intensity = intensity};
}

TEST_F(light_picture, directional_light_has_a_direction_a_color_and_an_intensity) {
  for (const glm::vec3 direction : {glm::vec3(-0.4f, -0.7f, -0.6f), glm::vec3(0.8f, 0.2f, -0.3f)}) {
    BuiltScene built = ball(0.0f, 0.6f);
    add_light_at(built, lamp(Light::Kind::directional, 2.2f), {5.0f, -3.0f, 0.5f}, direction);
    expect_reference_picture(built, view_of_ball(), only_scene_lights());
  }
}

TEST_F(light_picture, point_light_falls_off_with_the_square_of_the_distance) {
  for (const float distance : {0.4f, 1.0f, 3.0f}) {
    BuiltScene built = matte_wall();
    add_light_at(built, lamp(Light::Kind::point, 1.5f), {0.2f, 0.1f, distance}, {0, 0, -1});
    expect_reference_picture(built, view_of_wall(), only_scene_lights(), {.sharp = 0.3});
  }
}

TEST_F(light_picture, range_ends_light_smoothly) {
  for (const float range : {0.9f, 1.4f}) {
    BuiltScene built = matte_wall();
    Light light = lamp(Light::Kind::point, 2.0f);
    light.range_m = range;
    add_light_at(built, light, {0.2f, 0.1f, 0.7f}, {0, 0, -1});
    expect_reference_picture(built, view_of_wall(), only_scene_lights(), {.sharp = 0.3});
  }
}

TEST_F(light_picture, spot_light_fades_between_its_cones_and_is_dark_outside) {
  for (const float inner : {0.0f, 0.35f, 0.499f}) {
    BuiltScene built = matte_wall();
    Light light = lamp(Light::Kind::spot, 4.0f);
    light.inner_cone_rad = inner;
    light.outer_cone_rad = 0.5f;
    add_light_at(built, light, {-0.3f, 0.4f, 1.0f}, {0.35f, -0.4f, -1.0f});
    expect_reference_picture(built, view_of_wall(), only_scene_lights(), {.sharp = 0.3});
  }
}

TEST_F(light_picture, spot_light_has_a_range_too) {
  BuiltScene built = matte_wall();
  Light light = lamp(Light::Kind::spot, 4.0f);
  light.outer_cone_rad = 1.2f;
  light.range_m = 1.1f;
  add_light_at(built, light, {0.2f, 0.1f, 0.8f}, {0.1f, 0.0f, -1.0f});
  expect_reference_picture(built, view_of_wall(), only_scene_lights(), {.sharp = 0.3});
}

TEST_F(light_picture, scale_of_a_node_changes_no_light) {
  for (const Light::Kind kind : {Light::Kind::directional, Light::Kind::spot}) {
    BuiltScene built = matte_wall();
    Affine scaled = affine_from(glm::mat3(2.5f), {0.1f, 0.2f, 1.0f});
    scaled.row[1].y = 0.5f;
    built.add_light(lamp(kind, 2.0f), scaled);
    expect_reference_picture(built, view_of_wall(), only_scene_lights(), {.sharp = 0.3});
  }
}

TEST_F(light_picture, lights_add_up_and_the_seventeenth_is_left_out) {
  BuiltScene built = matte_wall();
  for (int i = 0; i < 17; ++i) {
    Light light = lamp(i % 3 == 0 ? Light::Kind::point : Light::Kind::spot, 0.15f);
    light.color = {0.3f + 0.04f * static_cast<float>(i), 0.9f - 0.05f * static_cast<float>(i), i == 16 ? 9.0f : 0.4f};
    const float turn = 0.4f * static_cast<float>(i);
    add_light_at(built, light, {0.6f * std::cos(turn), 0.5f * std::sin(turn), 0.5f}, {0.1f, 0.0f, -1.0f});
  }
  expect_reference_picture(built, view_of_wall(), only_scene_lights());
}

TEST_F(light_picture, key_light_shines_where_the_scene_has_no_light_or_none_is_wanted) {
  BuiltScene built = ball(0.0f, 0.5f);
  RenderOptions options;
  options.ao.on = false;
  options.lighting.environment = nullptr;
  options.lighting.to_key = {0.9f, 0.9f, -0.3f};
  for (const bool follows : {false, true}) {
    options.lighting.key_follows_camera = follows;
    expect_reference_picture(built, view_of_ball(), options);
  }
  add_light_at(built, lamp(Light::Kind::directional, 3.0f), {0, 0, 0}, {1, 0, 0});
  options.lighting.scene_lights = false;
  expect_reference_picture(built, view_of_ball(), options);
}

TEST_F(light_picture, highlights_of_every_roughness_of_metals_and_others) {
  for (const float metallic : {0.0f, 0.5f, 1.0f})
    for (const float roughness : {0.25f, 0.5f, 1.0f}) {
      BuiltScene built = ball(metallic, roughness);
      add_light_at(built, lamp(Light::Kind::directional, 1.5f), {0, 0, 0}, {-0.9f, -0.3f, -0.2f});
      expect_reference_picture(built, view_of_ball(), only_scene_lights());
    }
}

TEST_F(light_picture, light_that_grazes_a_surface_is_reflected_and_no_longer_scattered) {
  for (const float roughness : {0.3f, 0.0f}) {
    BuiltScene built;
    Material material = matte({0.05f, 0.1f, 0.4f});
    material.roughness = roughness;
    built.add(square(3.0f), built.add_material(material));
    add_light_at(built, lamp(Light::Kind::directional, 0.4f), {0, 0, 0}, {0.1f, -0.12f, 1.0f});
    const View low = look_at({0.0, 0.15, 1.2}, {0.0, 0.0, 0.0}, 0.4, 0.02);
    // The highlight of a mirror changes by far within a pixel.
    expect_reference_picture(built, low, only_scene_lights(), {.sharp = roughness > 0.0f ? 0.5 : 0.0});
  }
}

TEST_F(light_picture, ambient_light_comes_from_sky_and_ground) {
  for (const float metallic : {0.0f, 1.0f})
    for (const float roughness : {0.1f, 0.9f}) {
      RenderOptions options = only_ambient_light();
      const Gradient light{.sky = {0.2f, 0.5f, 0.9f}, .ground = {0.7f, 0.2f, 0.05f}};
      options.lighting.environment = gradient_environment(light);
      options.lighting.environment_intensity = 0.8f;
      // Rough levels of the environment have few texels, and roughness between two levels is interpolated.
      expect_reference_picture(ball(metallic, roughness), view_of_ball(), options, {.bound = 0.004}, {}, light);
    }
}

TEST_F(light_picture, white_surfaces_in_white_light_return_all_of_it) {
  constexpr float radiance = 0.5f;
  RenderOptions options = only_ambient_light();
  options.transparent_background = true;
  options.lighting.environment = gradient_environment({.sky = glm::vec3(radiance), .ground = glm::vec3(radiance)});
  options.lighting.tone_curve = ToneCurve::none;
  for (const float metallic : {0.0f, 0.4f, 1.0f})
    for (const float roughness : {0.05f, 0.3f, 0.6f, 1.0f}) {
      BuiltScene built = ball(metallic, roughness);
      built.scene.materials[0].base_color = glm::vec4(1.0f);
      const FloatPicture drawn = render_float(built, 32, 32, view_of_ball(), options);
      int covered = 0;
      for (const glm::vec4& pixel : drawn.pixels) {
        if (pixel.a == 0.0f) continue;
        ++covered;
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(linear_from_srgb(pixel[c]), radiance, kFurnaceBound * radiance) << metallic << " " << roughness;
      }
      EXPECT_GT(covered, 200);
    }
}

/// A sky that is asymmetric on all axes.
glm::vec3 colored_sky(const glm::vec3& d) {
  return {0.4f + 0.3f * d.x, 0.3f + 0.2f * d.y * d.z + 0.1f * d.z, 0.4f - 0.2f * d.z + 0.1f * d.x * d.y};
}

TEST_F(light_picture, environment_turns_counter_clockwise_from_above) {
  constexpr float turn = 1.1f;
  const float c = std::cos(turn), s = std::sin(turn);
  RenderOptions options = only_ambient_light();
  options.lighting.environment = make_environment(cube_of(64, colored_sky));
  options.lighting.environment_turn_rad = turn;
  RenderOptions turned = only_ambient_light();
  turned.lighting.environment = make_environment(cube_of(64, [&](const glm::vec3& d) {
    return colored_sky({c * d.x - s * d.z, d.y, s * d.x + c * d.z});  // what comes from d came from there before
  }));
  for (const float metallic : {0.0f, 1.0f}) {
    const BuiltScene built = ball(metallic, 0.2f);
    const FloatPicture a = render_float(built, 32, 32, view_of_ball(), options),
                       b = render_float(built, 32, 32, view_of_ball(), turned);
    float apart = 0.0f, range = 0.0f;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
      apart = std::max(apart, glm::length(a.pixels[i] - b.pixels[i]));
      range = std::max(range, glm::length(a.pixels[i] - a.pixels[a.pixels.size() / 2]));
    }
    EXPECT_LT(apart, 0.03f) << metallic;
    EXPECT_GT(range, 0.1f) << metallic;
  }
}

TEST_F(light_picture, small_bright_light_takes_no_light_from_the_other_side) {
  RenderOptions options = only_ambient_light();
  options.transparent_background = true;
  options.lighting.environment =
      make_environment(cube_of(64, [](const glm::vec3& d) { return glm::vec3(d.y > 0.95f ? 40.0f : 0.0f); }));
  BuiltScene built = ball(0.0f, 1.0f);
  built.scene.materials[0].emissive = glm::vec3(0.3f);
  const auto glow = static_cast<float>(reference::srgb_encoded(reference::tone_mapped(glm::dvec3(0.3)).r));
  const FloatPicture drawn = render_float(built, 32, 32, look_at({0.0, -2.2, 1.0}, {0, 0, 0}, 0.75, 0.05), options);
  int covered = 0;
  for (const glm::vec4& pixel : drawn.pixels) {
    if (pixel.a == 0.0f) continue;
    ++covered;
    for (int c = 0; c < 3; ++c) EXPECT_GT(pixel[c], glow - 0.002f);
  }
  EXPECT_GT(covered, 200);
}

/// The factors of the terms of Environment::diffuse.
std::array<double, 9> diffuse_terms(const glm::dvec3& n) {
  return {1.0, n.y, n.z, n.x, n.x * n.y, n.y * n.z, 3.0 * n.z * n.z - 1.0, n.x * n.z, n.x * n.x - n.y * n.y};
}

TEST_F(light_picture, each_term_of_diffuse_light_is_that_of_its_direction) {
  const BuiltScene built = ball(0.0f, 1.0f);
  const FrameResult frame = built.frame();
  const View view = look_at({1.0, 1.4, 2.2}, {0.0, 0.0, 0.0}, 0.6, 0.05);
  constexpr int size = 16;
  constexpr float share = 0.3f;
  RenderOptions options = only_ambient_light();
  options.lighting.tone_curve = ToneCurve::none;
  const auto drawn_with = [&](std::size_t term, float light) {
    Environment environment = *gradient_environment({glm::vec3(0.0f), glm::vec3(0.0f)});
    environment.diffuse[0] = glm::vec3(0.4f);
    environment.diffuse[term] += glm::vec3(light);
    options.lighting.environment = std::make_shared<const Environment>(environment);
    return render_float(built, size, size, view, options);
  };
  const FloatPicture even = drawn_with(0, 0.0f);
  for (std::size_t term = 0; term < 9; ++term) {
    const FloatPicture drawn = drawn_with(term, 0.4f * share);
    int compared = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const auto seen = reference::surfaces_along(
            built.scene, frame,
            reference::sight_line({built.scene, frame, view, options, size, size}, x + 0.5, y + 0.5));
        if (seen.empty()) continue;
        const double expected = 1.0 + static_cast<double>(share) * diffuse_terms(seen[0].normal)[term];
        EXPECT_NEAR(linear_from_srgb(drawn.at(x, y).g) / linear_from_srgb(even.at(x, y).g), expected, 0.01) << term;
        ++compared;
      }
    EXPECT_GT(compared, 100);
  }
}

TEST_F(light_picture, another_environment_is_shown_by_the_next_picture) {
  const BuiltScene built = ball(1.0f, 0.3f);
  Headless pictures(*test_device(), built.scene, 16, 16);
  const auto bright_pixel = [&](std::shared_ptr<const Environment> environment) {
    RenderOptions options = only_ambient_light();
    options.lighting.environment = std::move(environment);
    return pictures.render(built.frame(), view_of_ball(), options).rgba[4 * (8 * 16 + 8)];
  };
  const int dim = bright_pixel(gradient_environment({glm::vec3(0.1f), glm::vec3(0.1f)}));
  const int bright = bright_pixel(gradient_environment({glm::vec3(0.6f), glm::vec3(0.6f)}));
  EXPECT_GT(bright, dim + 60);
  EXPECT_EQ(bright_pixel(nullptr), 0) << "without an environment there is no ambient light";
  EXPECT_EQ(bright_pixel(gradient_environment({glm::vec3(0.6f), glm::vec3(0.6f)})), bright);
}

TEST_F(light_picture, exposure_scales_light_before_the_tone_curve) {
  for (const float exposure : {0.1f, 0.5f, 3.0f}) {
    RenderOptions options = only_ambient_light();
    options.lighting.exposure = exposure;
    expect_reference_picture(ball(0.0f, 0.8f), view_of_ball(), options);
  }
}

/// An emissive wall with a horizontal colour gradient.
BuiltScene glowing_wall(const glm::vec3& left, const glm::vec3& right) {
  BuiltScene built;
  Primitive p = wall();
  p.colors = {glm::vec4(left, 1.0f), glm::vec4(left, 1.0f), glm::vec4(right, 1.0f), glm::vec4(right, 1.0f)};
  Material material;
  material.unlit = true;
  built.add(p, built.add_material(material));
  return built;
}

TEST_F(light_picture, tone_curve_keeps_colors_and_whitens_highlights) {
  const std::pair<glm::vec3, glm::vec3> ramps[] = {{{0, 0, 0}, {0.2f, 0.15f, 0.1f}},
                                                   {{0, 0, 0}, {1, 1, 1}},
                                                   {{0.5f, 0.2f, 0.0f}, {9.0f, 2.0f, 0.05f}},
                                                   {{0.1f, 3.0f, 2.0f}, {4.0f, 60.0f, 30.0f}}};
  for (const ToneCurve curve : {ToneCurve::neutral, ToneCurve::aces, ToneCurve::none})
    for (const auto& [left, right] : ramps) {
      RenderOptions options = only_scene_lights();
      options.lighting.tone_curve = curve;
      expect_reference_picture(glowing_wall(left, right), view_of_wall(), options);
    }
}

TEST_F(light_picture, environment_is_the_backdrop_where_it_is_asked_for) {
  const Gradient light{.sky = {0.2f, 0.5f, 0.9f}, .ground = {0.7f, 0.2f, 0.05f}};
  RenderOptions options = only_ambient_light();
  options.lighting.environment = gradient_environment(light);
  options.lighting.environment_intensity = 0.6f;
  options.lighting.exposure = 1.5f;
  options.backdrop = Backdrop::sharp;
  BuiltScene built = ball(0.0f, 1.0f);
  View parallel = view_of_ball();
  parallel.half_height_m = 1.1;
  parallel.far_m = 6.0;
  for (const View& view : {view_of_ball(), look_at({1.5, -0.8, 0.4}, {0, 0, 0}, 1.2, 0.05), parallel})
    expect_reference_picture(built, view, options, {.bound = 0.004}, {}, light);
}

TEST_F(light_picture, a_dark_backdrop_darkens_what_is_seen_of_the_environment_and_no_surface) {
  const Gradient light{.sky = {0.2f, 0.5f, 0.9f}, .ground = {0.7f, 0.2f, 0.05f}};
  auto dark = std::make_shared<Environment>(*gradient_environment(light));
  dark->backdrop = 0.3f;
  RenderOptions options = only_ambient_light();
  options.lighting.environment = dark;
  options.backdrop = Backdrop::sharp;
  expect_reference_picture(ball(0.0f, 1.0f), view_of_ball(), options, {.bound = 0.004}, {}, light);
}

TEST_F(light_picture, blurred_backdrop_is_a_filtered_level_of_the_environment) {
  RenderOptions options = only_ambient_light();
  options.lighting.environment =
      make_environment(cube_of(64, [](const glm::vec3& d) { return glm::vec3(d.x > 0.0f ? 0.6f : 0.0f); }));
  BuiltScene empty;
  float steepest[2] = {};
  for (const Backdrop backdrop : {Backdrop::blurred, Backdrop::sharp}) {
    options.backdrop = backdrop;
    const FloatPicture drawn = render_float(empty, 64, 4, look_at({0, 0, 0}, {0, 0, -1}, 0.3, 0.05), options);
    float& steep = steepest[backdrop == Backdrop::sharp];
    for (int x = 1; x < 64; ++x) steep = std::max(steep, std::abs(drawn.at(x, 2).x - drawn.at(x - 1, 2).x));
    EXPECT_GT(drawn.at(63, 2).x, drawn.at(0, 2).x) << "+x is to the right of -z";
  }
  EXPECT_GT(steepest[1], 4.0f * steepest[0]);
}

TEST_F(light_picture, backdrop_is_plain_without_an_environment) {
  BuiltScene built = ball(0.0f, 1.0f);
  RenderOptions options = only_scene_lights();
  add_light_at(built, lamp(Light::Kind::directional, 2.0f), {0, 0, 0}, {-0.9f, -0.3f, -0.2f});
  const FloatPicture plain = render_float(built, 16, 16, view_of_ball(), options);
  options.backdrop = Backdrop::sharp;
  EXPECT_EQ(render_float(built, 16, 16, view_of_ball(), options).pixels, plain.pixels);
}

TEST_F(light_picture, background_is_shown_as_it_is_given_and_behind_what_lets_light_through) {
  BuiltScene built;
  Material glass = matte({0.9f, 0.3f, 0.1f});
  glass.unlit = true;
  glass.alpha_mode = AlphaMode::blend;
  glass.base_color.a = 0.35f;
  built.add(showcase::box({0, 0, 0}, glm::vec3(0.5f)), built.add_material(glass));
  RenderOptions options = only_scene_lights();
  options.background = {0.8f, 0.02f, 0.4f};
  options.lighting.exposure = 1.7f;
  for (const bool transparent : {false, true}) {
    options.transparent_background = transparent;
    expect_reference_picture(built, view_of_ball(), options);
  }
}

TEST_F(light_picture, parallel_camera_sees_every_point_from_one_direction) {
  BuiltScene built = ball(0.6f, 0.35f);
  built.add(square(2.0f), built.add_material(matte({0.4f, 0.6f, 0.3f})), translation({0.0f, -0.9f, 0.0f}));
  add_light_at(built, lamp(Light::Kind::point, 6.0f), {1.2f, 1.4f, 0.8f}, {0, -1, 0});
  View view = view_of_ball();
  view.half_height_m = 1.1;
  view.far_m = 6.0;
  RenderOptions options;
  options.ao.on = false;
  expect_reference_picture(built, view, options);
}

TEST_F(light_picture, near_and_far_plane_cut_the_scene) {
  BuiltScene built = ball(0.0f, 0.7f);
  built.scene.materials[0].double_sided = true;
  View view = view_of_ball();
  RenderOptions options;
  options.ao.on = false;
  view.near_m = 2.0;
  expect_reference_picture(built, view, options);
  view.near_m = 0.05;
  view.far_m = 2.2;
  expect_reference_picture(built, view, options);
}

}  // namespace
}  // namespace sinew::viewer
