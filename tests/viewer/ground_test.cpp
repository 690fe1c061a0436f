// SPDX-License-Identifier: MIT
// The ground, compared with a diffuse floor whose light is computed by rays towards the light and ambient light in
// closed form.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

#include "samples/showcase/shapes.h"
#include "tests/reference/picture.h"
#include "tests/viewer/reference_picture.h"
#include "viewer/app/headless.h"
#include "viewer/passes/frame_uniforms.h"
#include "viewer/passes/ground_reach.h"

namespace sinew::viewer {
namespace {

constexpr int kGroundWidth = 64, kGroundHeight = 48;

class ground : public DeviceTest {};

/// A box that stands on the ground and a ball above it.
BuiltScene box_and_ball() {
  BuiltScene built;
  const std::uint32_t grey = built.add_material(matte({0.6f, 0.6f, 0.6f}));
  built.add(showcase::box({0, 0, 0}, glm::vec3(0.4f)), grey, translation({-0.3f, 0.4f, 0.0f}));
  built.add(showcase::sphere({0, 0, 0}, 0.3f, 24, 16), grey, translation({0.7f, 0.9f, 0.3f}));
  return built;
}

Aabb bounds() { return {{-0.7f, 0.0f, -0.4f}, {1.0f, 1.2f, 0.6f}}; }

RenderOptions options_for(GroundLook look) {
  RenderOptions options = render_options_for(bounds(), {0, 0, 5});
  options.ao.on = false;
  options.lighting.key = {1.2f, 1.0f, 0.9f};
  options.lighting.to_key = {-0.7f, 0.8f, -0.35f};
  options.lighting.environment = plain_environment();
  options.shadows = {true, bounds()};
  options.transparent_background = true;
  options.ground.look = look;
  options.ground.radius_m = 40.0f;  // nothing fades in the picture
  return options;
}

View from_above() { return look_at({2.0, 2.6, 3.6}, {0.0, 0.2, 0.0}, 0.9, 0.05); }

double luminance(const glm::vec3& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

double ambient_irradiance() {
  // The cosine-weighted mean of the gradient over the upper half sphere is 5/6 sky and 1/6 ground.
  const Gradient light;
  return std::numbers::pi * (luminance(light.ground) + 5.0 * luminance(light.sky)) / 6.0;
}

double key_irradiance(const Lighting& lighting) { return luminance(lighting.key) * glm::normalize(lighting.to_key).y; }

/// The visible point of the ground at a pixel; empty if something is in front.
std::optional<glm::dvec3> ground_at(const BuiltScene& built, const View& view, const Ground& ground, int x, int y) {
  const FrameResult frame = built.frame();
  const auto line =
      reference::sight_line({built.scene, frame, view, {}, kGroundWidth, kGroundHeight}, x + 0.5, y + 0.5);
  const double t = (ground.middle.y - line.from.y) / line.direction.y;
  if (!(t > 0.0)) return std::nullopt;
  for (const reference::SurfacePoint& p : reference::surfaces_along(built.scene, frame, line))
    if (p.distance_m > 0.0 && p.distance_m < t) return std::nullopt;
  return line.from + t * line.direction;
}

bool in_shadow(const BuiltScene& built, const glm::dvec3& point, const glm::dvec3& to_light) {
  Scene two_sided = built.scene;
  for (Material& material : two_sided.materials) material.double_sided = true;
  const auto above = reference::surfaces_along(two_sided, built.frame(), {point, to_light});
  return std::any_of(above.begin(), above.end(), [](const reference::SurfacePoint& p) { return p.distance_m > 0.0; });
}

/// True if a pixel and its neighbours are in shadow, false if all are lit; empty at shadow edges and where the ground
/// is hidden.
std::optional<bool> shadow_around(const BuiltScene& built, const RenderOptions& options, int x, int y) {
  const glm::dvec3 to_light = glm::normalize(glm::dvec3(options.lighting.to_key));
  std::optional<bool> all;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const auto point = ground_at(built, from_above(), options.ground, x + dx, y + dy);
      if (!point) return std::nullopt;
      const bool dark = in_shadow(built, *point, to_light);
      if (all && *all != dark) return std::nullopt;
      all = dark;
    }
  return all;
}

void expect_shadows(const RenderOptions& options, int least_dark, const BuiltScene& built = box_and_ball()) {
  const double key = key_irradiance(options.lighting),
               ambient = options.lighting.ambient() ? ambient_irradiance() : 0.0;
  const FloatPicture drawn = render_float(built, kGroundWidth, kGroundHeight, from_above(), options);
  int dark = 0, lit = 0, wrong = 0;
  for (int y = 1; y < kGroundHeight - 1; ++y)
    for (int x = 1; x < kGroundWidth - 1; ++x) {
      const std::optional<bool> shadow = shadow_around(built, options, x, y);
      if (!shadow) continue;
      (*shadow ? dark : lit) += 1;
      const double expected = *shadow ? key / (key + ambient) : 0.0;
      const glm::vec4 pixel = drawn.at(x, y);
      if (std::abs(static_cast<double>(pixel.a) - expected) < 0.002 && glm::vec3(pixel) == glm::vec3(0.0f)) continue;
      if (++wrong <= 3) ADD_FAILURE() << "pixel " << x << ' ' << y << ": " << pixel.a << ", expected " << expected;
    }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(dark, least_dark);
  EXPECT_GT(lit, 300);
}

TEST_F(ground, is_as_much_darker_as_a_diffuse_floor_where_a_ray_to_the_light_is_blocked) {
  RenderOptions options = options_for(GroundLook::shadows);
  expect_shadows(options, 30);
  for (const glm::vec3 to_key : {glm::vec3(-0.9f, 0.35f, -0.3f), glm::vec3(0.1f, 0.5f, -1.2f)}) {
    options.lighting.to_key = to_key;  // low light: long shadows
    expect_shadows(options, 80);
  }
}

TEST_F(ground, is_black_in_the_shadow_of_the_only_light) {
  RenderOptions options = options_for(GroundLook::shadows);
  options.lighting.environment = nullptr;
  expect_shadows(options, 30);
  options.smooth_edges = true;
  expect_shadows(options, 30);
}

TEST_F(ground, is_darker_in_the_shadow_of_the_light_that_casts_it) {
  RenderOptions options = options_for(GroundLook::shadows);  // its key light defines the directional light
  options.lighting.scene_lights = true;
  BuiltScene built = box_and_ball();
  add_light_at(built, {.kind = Light::Kind::point, .intensity = 1e-6f}, {0.0f, 3.0f, 0.0f}, {0, -1, 0});
  add_light_at(built, {.kind = Light::Kind::directional, .color = options.lighting.key}, {9, 9, 9},
               -options.lighting.to_key);
  expect_shadows(options, 30, built);
}

TEST_F(ground, has_less_ambient_light_beside_what_stands_on_it) {
  const BuiltScene built = box_and_ball();
  RenderOptions options = options_for(GroundLook::shadows);
  options.shadows.on = false;
  options.ao = {.radius_m = 0.6f, .surface_epsilon_m = 0.01f, .fade_start_m = 0.3f, .fade_end_m = 1.2f};
  RenderOptions visibility = options;
  visibility.show = Show::ao;
  const FloatPicture drawn = render_float(built, kGroundWidth, kGroundHeight, from_above(), options),
                     seen = render_float(built, kGroundWidth, kGroundHeight, from_above(), visibility);
  const double key = key_irradiance(options.lighting), ambient = ambient_irradiance();
  int touched = 0, beside = 0;
  for (int y = 0; y < kGroundHeight; ++y)
    for (int x = 0; x < kGroundWidth; ++x) {
      const auto point = ground_at(built, from_above(), options.ground, x, y);
      if (!point) continue;
      const double share = static_cast<double>(seen.at(x, y).x);
      const double expected = ambient * (1.0 - share) / (ambient + key);
      EXPECT_NEAR(static_cast<double>(drawn.at(x, y).a), expected, 0.004) << x << ' ' << y;
      touched += share < 0.9;
      const Aabb& box = options.ground.bounds;
      const bool within = point->x > static_cast<double>(box.lower.x) && point->x < static_cast<double>(box.upper.x) &&
                          point->z > static_cast<double>(box.lower.z) && point->z < static_cast<double>(box.upper.z);
      beside += !within && share < 0.97;
    }
  EXPECT_GT(touched, 30);
  EXPECT_GT(beside, 10) << "contact reaches farther than what stands there";
}

TEST_F(ground, is_drawn_as_far_as_shadows_of_a_spot_light_reach) {
  for (const glm::vec3 position : {glm::vec3(-1.0f, 2.2f, -0.8f), glm::vec3(-1.5f, 1.0f, -1.0f)}) {
    BuiltScene built = box_and_ball();
    add_light_at(built, {.kind = Light::Kind::spot, .intensity = 9.0f, .outer_cone_rad = 0.9f}, position, -position);
    RenderOptions options = options_for(GroundLook::shadows), everywhere = options;
    options.lighting.scene_lights = everywhere.lighting.scene_lights = true;
    everywhere.ground.bounds = {glm::vec3(-30.0f), glm::vec3(30.0f)};
    const FloatPicture drawn = render_float(built, kGroundWidth, kGroundHeight, from_above(), options);
    const FloatPicture whole = render_float(built, kGroundWidth, kGroundHeight, from_above(), everywhere);
    int dark = 0;
    for (int y = 0; y < kGroundHeight; ++y)
      for (int x = 0; x < kGroundWidth; ++x) {
        EXPECT_NEAR(drawn.at(x, y).a, whole.at(x, y).a, 0.05f) << x << ' ' << y;  // roundings at the edge of a shadow
        dark += drawn.at(x, y).a > 0.1f && ground_at(built, from_above(), options.ground, x, y).has_value();
      }
    EXPECT_GT(dark, 40);
  }
}

TEST_F(ground, fades_out_towards_its_radius) {
  const BuiltScene built = box_and_ball();
  RenderOptions options = options_for(GroundLook::shadows);
  const FloatPicture whole = render_float(built, kGroundWidth, kGroundHeight, from_above(), options);
  options.ground.radius_m = 1.5f;
  const FloatPicture small = render_float(built, kGroundWidth, kGroundHeight, from_above(), options);
  int fading = 0;
  for (int y = 0; y < kGroundHeight; ++y)
    for (int x = 0; x < kGroundWidth; ++x) {
      const auto point = ground_at(built, from_above(), options.ground, x, y);
      if (!point) continue;
      const double part = glm::length(*point - options.ground.middle) / 1.5;
      const double s = std::clamp((part - 0.6) / 0.4, 0.0, 1.0), kept = 1.0 - s * s * (3.0 - 2.0 * s);
      EXPECT_NEAR(static_cast<double>(small.at(x, y).a), kept * static_cast<double>(whole.at(x, y).a), 0.002);
      fading += kept > 0.1 && kept < 0.9 && whole.at(x, y).a > 0.1f;
    }
  EXPECT_GT(fading, 5);
}

TEST_F(ground, grid_lines_are_at_multiples_of_the_step) {
  BuiltScene built;
  built.add(showcase::box({0, 0, 0}, glm::vec3(0.01f)), built.add_material(matte({1, 1, 1})));
  RenderOptions options = options_for(GroundLook::grid);
  options.ground.middle = {3.25, 0.0, -7.5};
  options.ground.grid_step_m = 1.0f;
  View down = look_at({3.25, 5.0, -7.5}, {3.25, 0.0, -7.5}, 0.9, 0.05, {0.0, 0.0, -1.0});
  down.half_height_m = 1.5;
  down.far_m = 20.0;
  const int size = 48;  // 16 pixels a metre
  const FloatPicture drawn = render_float(built, size, size, down, options);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double at_x = 3.25 + (x + 0.5 - 24.0) / 16.0, at_z = -7.5 + (y + 0.5 - 24.0) / 16.0;
      const double nearest = std::min(std::abs(at_x - std::round(at_x)), std::abs(at_z - std::round(at_z))) * 16.0;
      const double expected = 0.3 * std::clamp(1.0 - nearest, 0.0, 1.0) * 0.75;  // 4 / 16 is the share that fades
      EXPECT_NEAR(static_cast<double>(drawn.at(x, y).a), expected, 0.003) << x << ' ' << y;
    }
}

TEST_F(ground, grid_lines_are_as_bright_whatever_the_exposure_and_the_light) {
  const BuiltScene built = box_and_ball();
  const auto drawn = [&](float light, bool automatic, float exposure) {
    RenderOptions options = options_for(GroundLook::grid);
    options.transparent_background = false;
    options.backdrop = Backdrop::plain;
    options.ground.grid_step_m = 1.0f;
    options.shadows.on = false;
    options.lighting.key *= light;
    options.lighting.environment_intensity = light;
    options.lighting.auto_exposure = automatic;
    options.lighting.exposure = exposure;
    return render_float(built, kGroundWidth, kGroundHeight, from_above(), options);
  };
  const FloatPicture given = drawn(1.0f, false, 1.0f);
  for (const FloatPicture& other :
       {drawn(1.0f, false, 4.0f), drawn(1.0f, true, 1.0f), drawn(400.0f, true, 1.0f), drawn(0.01f, true, 2.0f)}) {
    int lines = 0;
    for (int y = 0; y < kGroundHeight; ++y)
      for (int x = 0; x < kGroundWidth; ++x) {
        if (!ground_at(built, from_above(), options_for(GroundLook::grid).ground, x, y)) continue;
        lines += given.at(x, y).r > 0.2f;
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(other.at(x, y)[c], given.at(x, y)[c], 0.002) << x << ' ' << y;
      }
    EXPECT_GT(lines, 50);
  }
}

TEST_F(ground, cannot_be_seen_from_below_and_is_in_no_buffer) {
  const BuiltScene built = box_and_ball();
  Headless pictures(*test_device(), built.scene, kGroundWidth, kGroundHeight);
  const auto runs = [&](const View& view, const RenderOptions& options) {
    pictures.render(built.frame(), view, options);
    return pictures.report().passes[static_cast<std::size_t>(Pass::ground)].runs;
  };
  RenderOptions options = options_for(GroundLook::shadows);
  const View below = look_at({2.0, -1.0, 3.0}, {0.0, 0.2, 0.0}, 0.9, 0.05);
  View parallel = from_above(), parallel_below = below;
  parallel.half_height_m = parallel_below.half_height_m = 2.0;
  parallel.far_m = parallel_below.far_m = 20.0;
  EXPECT_TRUE(runs(from_above(), options));
  EXPECT_TRUE(runs(parallel, options));
  EXPECT_FALSE(runs(below, options));
  EXPECT_FALSE(runs(parallel_below, options));
  options.ground.look = GroundLook::none;
  EXPECT_FALSE(runs(from_above(), options));
  for (const Show show : {Show::normals, Show::depth, Show::level}) {
    RenderOptions with = options_for(GroundLook::grid), without = with;
    without.ground.look = GroundLook::none;
    with.show = without.show = show;
    EXPECT_FALSE(runs(from_above(), with));
    EXPECT_EQ(render_float(built, kGroundWidth, kGroundHeight, from_above(), with).pixels,
              render_float(built, kGroundWidth, kGroundHeight, from_above(), without).pixels);
  }
}

TEST_F(ground, is_left_out_where_nothing_darkens_it) {
  BuiltScene built = box_and_ball();
  Headless pictures(*test_device(), built.scene, kGroundWidth, kGroundHeight);
  const auto reason = [&](const View& view, const RenderOptions& options, const FrameResult& frame) {
    const Picture drawn = pictures.render(frame, view, options);
    const PassStage stage = pictures.report().passes[static_cast<std::size_t>(Pass::ground)];
    RenderOptions without = options;
    without.ground.look = GroundLook::none;
    const bool same = drawn.rgba == pictures.render(frame, view, without).rgba;
    EXPECT_EQ(stage.runs, !same) << stage.reason;
    return stage.runs ? std::string() : std::string(stage.reason.substr(0, 19));
  };
  const FrameResult frame = built.frame();
  RenderOptions options = options_for(GroundLook::shadows);
  EXPECT_EQ(reason(from_above(), options, frame), "");
  RenderOptions touched = options;
  touched.shadows.on = false;
  touched.ao = {.radius_m = 0.6f, .surface_epsilon_m = 0.01f, .fade_start_m = 0.3f, .fade_end_m = 1.2f};
  EXPECT_EQ(reason(from_above(), touched, frame), "") << "ambient occlusion alone";
  RenderOptions dark = options;
  dark.shadows.on = false;
  EXPECT_EQ(reason(from_above(), dark, frame), "nothing darkens it:") << "no shadows and no occlusion";
  RenderOptions lit_from_below = options;
  lit_from_below.lighting.to_key = {0.3f, -1.0f, 0.2f};
  EXPECT_EQ(reason(from_above(), lit_from_below, frame), "nothing darkens it:");
  const View past = look_at({2.0, 2.6, 3.6}, {6.0, 2.2, 9.0}, 0.4, 0.05);
  EXPECT_EQ(reason(past, options, frame), "nothing darkens it:") << "its shadows are out of view";
  RenderOptions unlit = touched;
  unlit.lighting.environment = nullptr;
  EXPECT_EQ(reason(from_above(), unlit, frame), "nothing darkens it:") << "no ambient light to hide";
}

TEST(ground_reach, follows_what_stands_there_now) {
  Ground ground = ground_for({{-5, 0, -5}, {5, 3, 5}});
  ground.look = GroundLook::shadows;
  ShadowLights lights;
  lights.add({0, glm::normalize(glm::dvec3(1.0, 1.0, 0.0))});
  const Aabb standing{{-1.0f, 0.0f, -1.0f}, {1.0f, 2.0f, 1.0f}};
  const double below = -ground.middle.y;
  const GroundReach reach = ground_reach(ground, standing, lights, 0.25);
  EXPECT_NEAR(static_cast<double>(reach.rectangle.x), -1.0 - 2.0 - below - 0.25, 1e-5) << "the shadow of its top";
  EXPECT_NEAR(reach.rectangle.z, 1.25f, 1e-5f);
  EXPECT_EQ(reach.contact, glm::vec4(-1.25f, -1.25f, 1.25f, 1.25f));
  EXPECT_TRUE(reach.darkened);
  EXPECT_FALSE(ground_reach(ground, {{-1, 1, -1}, {1, 2, 1}}, {}, 0.25).darkened) << "in the air, without shadows";
  EXPECT_TRUE(ground_reach(ground, {{-1, 1, -1}, {1, 2, 1}}, lights, 0.0).darkened);
  EXPECT_TRUE(ground_reach(ground, {}, lights, 0.0).darkened) << "unknown bounds";
  EXPECT_EQ(ground_reach(ground, {}, lights, 0.0).rectangle.x, -ground.radius_m);
}

TEST_F(ground, nothing_opaque_is_needed_to_see_its_grid) {
  const BuiltScene empty;
  const FloatPicture drawn =
      render_float(empty, kGroundWidth, kGroundHeight, from_above(), options_for(GroundLook::grid));
  EXPECT_TRUE(std::any_of(drawn.pixels.begin(), drawn.pixels.end(), [](const glm::vec4& p) { return p.a > 0.1f; }));
}

}  // namespace
}  // namespace sinew::viewer
