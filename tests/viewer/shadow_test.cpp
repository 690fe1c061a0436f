// SPDX-License-Identifier: MIT
// Shadows, compared pixel by pixel with rays towards the light.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "samples/showcase/shapes.h"
#include "tests/reference/picture.h"
#include "tests/viewer/reference_picture.h"
#include "viewer/app/headless.h"
#include "viewer/passes/frame_uniforms.h"
#include "viewer/passes/shadow_view.h"

namespace sinew::viewer {
namespace {

constexpr int kWidth = 64, kHeight = 48;

class shadows : public DeviceTest {};

Aabb around(float size) { return {glm::vec3(-size), glm::vec3(size)}; }

/// Box and sphere on a floor, in the light of a key light alone.
RenderOptions key_light_alone() {
  RenderOptions options = only_scene_lights();
  options.lighting.key = glm::vec3(1.5f);
  options.lighting.to_key = {0.7f, 0.8f, 0.35f};
  options.shadows = {true, around(4.0f)};
  return options;
}

glm::dvec4 from_far(const glm::dvec3& to_light) { return {glm::normalize(to_light), 0.0}; }

View from_above() { return look_at({2.5, 3.2, 4.0}, {0.0, 0.3, 0.0}, 0.8, 0.05); }

struct Seen {
  bool in_shadow = false;
  glm::dvec3 normal{0.0};

  /// True if both are lit or both in shadow, with similar normals, so that filtering across them has no effect.
  bool like(const std::optional<Seen>& other) const {
    return other && other->in_shadow == in_shadow && glm::dot(normal, other->normal) > 0.9;
  }
};

/// The visible surface at each pixel; empty where there is none, or where it faces away from the light or is nearly
/// parallel to it.
/// in   light  world space: the position of a lamp (w = 1) or the unit direction to it (w = 0)
std::vector<std::optional<Seen>> truth(const BuiltScene& built, const View& view, const glm::dvec4& light) {
  Scene two_sided = built.scene;
  for (Material& material : two_sided.materials) material.double_sided = true;
  const FrameResult frame = built.frame();
  std::vector<std::optional<Seen>> pixels;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const auto seen = reference::surfaces_along(
          two_sided, frame, reference::sight_line({built.scene, frame, view, {}, kWidth, kHeight}, x + 0.5, y + 0.5));
      pixels.emplace_back();
      if (seen.empty()) continue;
      const glm::dvec3 way = glm::dvec3(light) - light.w * seen[0].position, to_light = glm::normalize(way);
      if (glm::dot(seen[0].normal, to_light) < 0.15) continue;
      const auto above = reference::surfaces_along(two_sided, frame, {seen[0].position + 0.01 * to_light, to_light});
      const double end = light.w > 0.0 ? glm::length(way) : 1e9;
      const bool in_shadow = std::any_of(above.begin(), above.end(), [end](const reference::SurfacePoint& p) {
        return p.distance_m > 0.0 && p.distance_m < end;
      });
      pixels.back() = Seen{in_shadow, seen[0].normal};
    }
  return pixels;
}

/// Expects that pixels with only lit neighbours look as without shadows, and pixels with only shadowed neighbours as
/// without the light.
/// in   dark_scene  the scene without the light; null = the key light casts the shadows
void expect_shadows(const BuiltScene& built, const View& view, const RenderOptions& options, const glm::dvec4& light,
                    const BuiltScene* dark_scene = nullptr) {
  RenderOptions lit = options;
  lit.shadows.on = false;
  RenderOptions dark = lit;
  if (!dark_scene) dark.lighting.key = glm::vec3(0.0f);
  const FloatPicture drawn = render_float(built, kWidth, kHeight, view, options),
                     as_lit = render_float(built, kWidth, kHeight, view, lit),
                     as_dark = render_float(dark_scene ? *dark_scene : built, kWidth, kHeight, view, dark);
  const auto pixels = truth(built, view, light);
  int in_shadow = 0, in_light = 0, wrong = 0;
  for (int y = 2; y < kHeight - 2; ++y)
    for (int x = 2; x < kWidth - 2; ++x) {
      const auto& here = pixels[static_cast<std::size_t>(y * kWidth + x)];
      bool alike = here.has_value();
      for (int dy = -2; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx)
          alike = alike && here->like(pixels[static_cast<std::size_t>((y + dy) * kWidth + x + dx)]);
      if (!alike) continue;
      const glm::vec4 expected = (here->in_shadow ? as_dark : as_lit).at(x, y);
      (here->in_shadow ? in_shadow : in_light) += 1;
      if (glm::length(drawn.at(x, y) - expected) <= 0.01f) continue;
      if (++wrong <= 3) ADD_FAILURE() << "pixel " << x << " " << y << " is wrong, in shadow: " << here->in_shadow;
    }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(in_shadow, 30);
  EXPECT_GT(in_light, 400);
}

TEST_F(shadows, fall_where_a_ray_to_the_light_meets_something) {
  const BuiltScene built = box_and_sphere_on_floor();
  RenderOptions options = key_light_alone();
  for (const glm::vec3 to_key :
       {glm::vec3(0.5f, 0.8f, -0.6f), glm::vec3(-0.8f, 0.5f, 0.1f), glm::vec3(0.2f, 0.9f, -1.0f)}) {
    options.lighting.to_key = to_key;
    expect_shadows(built, from_above(), options, from_far(to_key));
  }
}

TEST_F(shadows, do_not_depend_on_the_camera) {
  const BuiltScene built = box_and_sphere_on_floor();
  View parallel = look_at({-3.0, 4.0, 2.0}, {0.0, 0.2, 0.0}, 0.8, 0.05);
  parallel.half_height_m = 1.6;
  parallel.far_m = 12.0;
  for (const View& view : {look_at({-4.0, 3.0, 3.0}, {0.0, 0.2, 0.0}, 0.7, 0.05), parallel})
    expect_shadows(built, view, key_light_alone(), from_far({0.7, 0.8, 0.35}));
}

TEST_F(shadows, key_light_that_follows_the_camera_casts_them_from_there) {
  RenderOptions options = key_light_alone();
  options.lighting.key_follows_camera = true;
  options.lighting.to_key = {-0.9f, 0.8f, 0.3f};
  const View view = look_at({-3.5, 3.5, -2.0}, {0.0, 0.2, 0.0}, 0.8, 0.05);
  const glm::dmat3 turn = linear_part(view.view_from_world);
  expect_shadows(box_and_sphere_on_floor(), view, options,
                 from_far(glm::transpose(turn) * glm::dvec3(options.lighting.to_key)));
}

TEST_F(shadows, first_directional_light_of_the_scene_casts_them_alone) {
  BuiltScene built = box_and_sphere_on_floor();
  add_light_at(built, {.kind = Light::Kind::point, .intensity = 3.0f}, {0.0f, 3.0f, 0.0f}, {0, -1, 0});
  const BuiltScene without_sun = built;
  add_light_at(built, {.kind = Light::Kind::directional, .intensity = 1.5f}, {9, 9, 9}, {-0.5f, -0.8f, 0.6f});
  RenderOptions options = key_light_alone();
  options.lighting.scene_lights = true;
  const ShadowLights casting = [&] {
    const FrameResult frame = built.frame();
    const std::vector<PlacedLight> placed = {{&built.scene.lights[0], frame.model[built.scene.lights[0].joint]},
                                             {&built.scene.lights[1], frame.model[built.scene.lights[1].joint]}};
    return shadow_lights(from_above(), options, placed);
  }();
  ASSERT_EQ(casting.count(), 1u);
  const ShadowLight chosen = *casting.begin();
  EXPECT_EQ(chosen.index, 1u);
  EXPECT_EQ(casting.mask(), 2u);
  EXPECT_LT(glm::length(chosen.to_light - glm::normalize(glm::dvec3(0.5, 0.8, -0.6))), 1e-6);
  expect_shadows(built, from_above(), options, from_far({0.5, 0.8, -0.6}), &without_sun);
}

TEST_F(shadows, first_spot_light_casts_them_where_there_is_no_directional_light) {
  BuiltScene built = box_and_sphere_on_floor();
  add_light_at(built, {.kind = Light::Kind::point, .intensity = 3.0f}, {0.0f, 3.0f, 0.0f}, {0, -1, 0});
  const BuiltScene without_spot = built;
  const glm::vec3 position(1.6f, 3.4f, -1.2f);
  RenderOptions options = key_light_alone();
  options.lighting.scene_lights = true;
  for (const float cone : {0.45f, 0.9f, 1.55f}) {
    BuiltScene lit = without_spot;
    add_light_at(lit,
                 {.kind = Light::Kind::spot, .intensity = 20.0f, .inner_cone_rad = 0.9f * cone, .outer_cone_rad = cone},
                 position, glm::vec3(0.0f, 0.2f, 0.0f) - position);
    expect_shadows(lit, from_above(), options, {glm::dvec3(position), 1.0}, &without_spot);
  }
}

TEST_F(shadows, of_a_spot_light_amid_the_scene_are_those_of_what_it_shines_on) {
  BuiltScene built = box_and_sphere_on_floor();
  add_light_at(built, {.kind = Light::Kind::point, .intensity = 1.0f}, {0.0f, 3.0f, 0.0f}, {0, -1, 0});
  const BuiltScene without = built;
  const glm::vec3 position(0.0f, 1.4f, 1.3f);
  add_light_at(built, {.kind = Light::Kind::spot, .intensity = 5.0f, .outer_cone_rad = 1.2f}, position,
               glm::vec3(0.0f, 0.2f, 0.1f) - position);
  RenderOptions options = key_light_alone();
  options.lighting.scene_lights = true;
  expect_shadows(built, from_above(), options, {glm::dvec3(position), 1.0}, &without);
}

/// A light of the test, and its position or direction for truth().
struct Lamp {
  Light light;
  glm::vec3 position, target;

  glm::dvec4 way() const {
    if (light.kind == Light::Kind::directional) return from_far(glm::dvec3(position - target));
    return {glm::dvec3(position), 1.0};
  }
};

/// Box and sphere on a floor in the light of some of the lamps.
BuiltScene lit_by(std::span<const Lamp> lamps, std::uint32_t which) {
  BuiltScene built = box_and_sphere_on_floor();
  for (std::size_t i = 0; i < lamps.size(); ++i)
    if ((which >> i & 1u) != 0)
      add_light_at(built, lamps[i].light, lamps[i].position, lamps[i].target - lamps[i].position);
  return built;
}

/// Expects each pixel around which all shadows are the same to be the sum of the lamps that reach it.
/// in   casting  bit i is set: lamp i casts shadows
void expect_shadows_of_all(std::span<const Lamp> lamps, std::uint32_t casting) {
  RenderOptions options = key_light_alone();
  options.lighting.scene_lights = true;
  options.lighting.tone_curve = ToneCurve::none;
  const auto all = static_cast<std::uint32_t>((1u << lamps.size()) - 1u);
  const FloatPicture drawn = render_float(lit_by(lamps, all), kWidth, kHeight, from_above(), options);
  options.shadows.on = false;
  std::vector<FloatPicture> alone;
  std::vector<std::vector<std::optional<Seen>>> truths;
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    alone.push_back(render_float(lit_by(lamps, 1u << i), kWidth, kHeight, from_above(), options));
    truths.push_back(truth(box_and_sphere_on_floor(), from_above(), lamps[i].way()));
  }
  std::vector<int> seen(lamps.size());  // pixels in the shadow of each lamp
  for (int y = 2; y < kHeight - 2; ++y)
    for (int x = 2; x < kWidth - 2; ++x) {
      glm::vec3 expected(0.0f);
      std::uint32_t shadows = 0;
      bool alike = true;
      for (std::size_t i = 0; i < lamps.size(); ++i) {
        const auto& here = truths[i][static_cast<std::size_t>(y * kWidth + x)];
        alike = alike && here.has_value();
        for (int dy = -2; dy <= 2 && alike; ++dy)
          for (int dx = -2; dx <= 2; ++dx)
            alike = alike && here->like(truths[i][static_cast<std::size_t>((y + dy) * kWidth + x + dx)]);
        if (!alike) break;
        const bool dark = here->in_shadow && (casting >> i & 1u) != 0;
        shadows |= dark ? 1u << i : 0u;
        for (int c = 0; c < 3; ++c) expected[c] += dark ? 0.0f : linear_from_srgb(alone[i].at(x, y)[c]);
      }
      if (!alike) continue;
      for (std::size_t i = 0; i < lamps.size(); ++i) seen[i] += static_cast<int>(shadows >> i & 1u);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(linear_from_srgb(drawn.at(x, y)[c]), expected[c], 0.004f) << x << ' ' << y << ' ' << shadows;
    }
  for (std::size_t i = 0; i < lamps.size(); ++i)
    EXPECT_EQ(seen[i] > 10, (casting >> i & 1u) != 0) << "shadow of lamp " << i << ": " << seen[i];
}

TEST_F(shadows, fall_from_four_lights_of_the_scene_each_where_its_own_rays_meet_something) {
  const auto spot = [](glm::vec3 position) {
    return Lamp{{.kind = Light::Kind::spot, .intensity = 1.5f, .inner_cone_rad = 0.8f, .outer_cone_rad = 0.9f},
                position,
                {0.0f, 0.0f, 0.0f}};
  };
  const Lamp sun{{.kind = Light::Kind::directional, .intensity = 0.25f}, {0.5f, 0.8f, -0.6f}, {0, 0, 0}};
  const Lamp bulb{{.kind = Light::Kind::point, .intensity = 0.5f}, {0.0f, 3.0f, 0.0f}, {0, 0, 0}};
  const Lamp a = spot({2.2f, 2.4f, -1.2f}), b = spot({-2.0f, 2.6f, 1.4f}), c = spot({-1.6f, 2.8f, -2.0f}),
             d = spot({2.4f, 2.2f, 1.6f});
  expect_shadows_of_all(std::vector{bulb, a, b}, 0b110);
  expect_shadows_of_all(std::vector{a, bulb, sun, b}, 0b1101);
  expect_shadows_of_all(std::vector{a, bulb, b, c, sun}, 0b11101);
  expect_shadows_of_all(std::vector{a, b, bulb, c, d, sun}, 0b101011);
}

TEST_F(shadows, of_a_spot_light_end_where_its_cone_is_wider_than_the_map) {
  // The map extends 2.93 m to each side. A caster at its border must cast no shadow beyond it.
  BuiltScene built;
  const std::uint32_t white = built.add_material(matte({1, 1, 1}));
  built.add(square(4.0f), white);
  built.add(showcase::box({2.55f, 0.04f, 0.0f}, {0.15f, 0.01f, 1.5f}), white);
  add_light_at(built, {.kind = Light::Kind::spot, .intensity = 100.0f, .inner_cone_rad = 1.5f, .outer_cone_rad = 1.55f},
               {0.0f, 0.5f, 0.0f}, {0, -1, 0});
  RenderOptions options = key_light_alone();
  options.lighting.scene_lights = true;
  const View beyond = look_at({3.6, 1.5, 0.01}, {3.6, 0.0, 0.0}, 0.5, 0.05);
  const FloatPicture drawn = render_float(built, kWidth, kHeight, beyond, options);
  options.shadows.on = false;
  EXPECT_EQ(drawn.pixels, render_float(built, kWidth, kHeight, beyond, options).pixels);
  EXPECT_GT(drawn.at(kWidth / 2, kHeight / 2).r, 0.1f) << "no light is there";
}

TEST_F(shadows, normal_maps_make_no_surface_shadow_itself) {
  BuiltScene built;
  Material leaning = matte({0.7f, 0.7f, 0.7f});
  leaning.normal_texture.texture = add_plain_texture(built, {245, 128, 150, 255});
  built.add(wall(), built.add_material(leaning));
  RenderOptions options = key_light_alone();
  options.lighting.to_key = {0.9f, 0.1f, 0.3f};
  const FloatPicture drawn = render_float(built, kWidth, kHeight, view_of_wall(), options);
  options.shadows.on = false;
  EXPECT_EQ(drawn.pixels, render_float(built, kWidth, kHeight, view_of_wall(), options).pixels);
}

TEST_F(shadows, come_from_what_is_out_of_view) {
  BuiltScene built;
  const std::uint32_t grey = built.add_material(matte({0.7f, 0.7f, 0.7f}));
  built.add(square(2.0f), grey);
  built.add(showcase::box({0, 0, 0}, glm::vec3(0.5f)), grey, translation({0.0f, 3.0f, 0.0f}));
  RenderOptions options = key_light_alone();
  options.lighting.to_key = {0.1f, 1.0f, 0.05f};
  const View floor_alone = look_at({0.0, 1.5, 2.0}, {0.0, 0.0, 0.0}, 0.8, 0.05);
  Headless pictures(*test_device(), built.scene, kWidth, kHeight);
  pictures.render(built.frame(), floor_alone, options);
  EXPECT_EQ(pictures.report().drawn, 1u) << "the box must be out of view";
  expect_shadows(built, floor_alone, options, from_far(glm::dvec3(options.lighting.to_key)));
}

TEST_F(shadows, blended_surfaces_cast_none_and_holes_of_masks_let_light_through) {
  for (const AlphaMode mode : {AlphaMode::blend, AlphaMode::mask}) {
    BuiltScene built;
    Material roof = matte({0.7f, 0.7f, 0.7f});
    roof.alpha_mode = mode;
    roof.base_color.a = 0.3f;
    roof.alpha_cutoff = 0.5f;
    built.add(square(2.0f), built.add_material(matte({0.7f, 0.7f, 0.7f})));
    built.add(square(0.6f), built.add_material(roof), translation({0.0f, 1.0f, 0.0f}));
    RenderOptions options = key_light_alone(), without = options;
    without.shadows.on = false;
    EXPECT_EQ(render_float(built, kWidth, kHeight, from_above(), options).pixels,
              render_float(built, kWidth, kHeight, from_above(), without).pixels);
    built.scene.materials[1].base_color.a = 0.9f;
    if (mode == AlphaMode::blend) continue;
    EXPECT_NE(render_float(built, kWidth, kHeight, from_above(), options).pixels,
              render_float(built, kWidth, kHeight, from_above(), without).pixels);
  }
}

TEST_F(shadows, cost_nothing_where_no_light_casts_them) {
  BuiltScene built = box_and_sphere_on_floor();
  Headless pictures(*test_device(), built.scene, kWidth, kHeight);
  const auto runs = [&](const RenderOptions& options) {
    pictures.render(built.frame(), from_above(), options);
    return pictures.report().passes[static_cast<std::size_t>(Pass::shadow)].runs;
  };
  RenderOptions options = key_light_alone();
  EXPECT_TRUE(runs(options));
  options.shadows.on = false;
  EXPECT_FALSE(runs(options));
  options = key_light_alone();
  options.shadows.bounds = {};
  EXPECT_FALSE(runs(options));
  options = key_light_alone();
  options.lighting.key = glm::vec3(0.0f);
  EXPECT_FALSE(runs(options));
  options = key_light_alone();
  options.show = Show::normals;
  EXPECT_FALSE(runs(options));
}

TEST(shadow_lights, the_ground_is_drawn_as_far_as_any_of_their_shadows_reaches) {
  BuiltScene built = box_and_sphere_on_floor();
  add_light_at(built, {.kind = Light::Kind::directional}, {0, 0, 0}, {-0.5f, -0.8f, 0.6f});
  add_light_at(built, {.kind = Light::Kind::spot, .outer_cone_rad = 0.5f}, {1.5f, 6.0f, 1.0f}, {-0.2f, -1.0f, -0.1f});
  const FrameResult frame = built.frame();
  std::vector<PlacedLight> both;
  for (const Light& light : built.scene.lights) both.push_back({&light, frame.model[light.joint]});
  RenderOptions options = key_light_alone();
  options.lighting.scene_lights = true;
  options.ao.on = false;
  options.ground = ground_for(around(1.0f));
  options.ground.look = GroundLook::shadows;
  const auto reach_of = [&](std::span<const PlacedLight> lights) {
    const ShadowLights shadows = shadow_lights(from_above(), options, lights);
    EXPECT_EQ(shadows.count(), lights.size());
    return make_frame_uniforms(from_above(), {64, 48}, options, false, lights, shadows, {}).ground_reach;
  };
  const glm::vec4 sun = reach_of({&both[0], 1}), spot = reach_of({&both[1], 1}), all = reach_of(both);
  EXPECT_NE(sun, spot);
  EXPECT_EQ(all, glm::vec4(std::min(sun.x, spot.x), std::min(sun.y, spot.y), std::max(sun.z, spot.z),
                           std::max(sun.w, spot.w)));
}

TEST(shadow_lights, are_directional_ones_before_spots_and_four_at_most_by_their_place) {
  BuiltScene built;
  for (const Light::Kind kind : {Light::Kind::spot, Light::Kind::point, Light::Kind::directional, Light::Kind::spot,
                                 Light::Kind::spot, Light::Kind::directional})
    add_light_at(built, {.kind = kind}, {0, 3, 0}, {0, -1, 0});
  const FrameResult frame = built.frame();
  std::vector<PlacedLight> placed;
  for (const Light& light : built.scene.lights) placed.push_back({&light, frame.model[light.joint]});
  RenderOptions options = key_light_alone();
  options.lighting.scene_lights = true;
  const ShadowLights casting = shadow_lights(from_above(), options, placed);
  EXPECT_EQ(casting.mask(), 0b101101u);
  EXPECT_TRUE(std::is_sorted(casting.begin(), casting.end(),
                             [](const ShadowLight& a, const ShadowLight& b) { return a.index < b.index; }));
  EXPECT_TRUE(casting.begin()[0].spot);
  EXPECT_FALSE(casting.begin()[1].spot);
  EXPECT_EQ(shadow_lights(from_above(), options, {placed.data() + 1, 1}).count(), 0u) << "points cast none";
  options.shadows.on = false;
  EXPECT_EQ(shadow_lights(from_above(), options, placed).count(), 0u);
}

glm::dvec3 on_map(const ShadowView& view, const glm::dvec3& p) {
  const glm::dvec4 at(p, 1.0);
  const auto& m = view.map_from_world;
  return glm::dvec3(glm::dot(m[0], at), glm::dot(m[1], at), glm::dot(m[2], at)) / glm::dot(m[3], at);
}

TEST(shadow_view, of_a_spot_light_is_its_cone_between_the_ends_of_the_scene) {
  const Aabb bounds{{-1.0f, 0.0f, -1.0f}, {1.0f, 2.0f, 1.0f}};
  const glm::dvec3 position(0.5, 9.0, 1.0), to_light = glm::normalize(glm::dvec3(0.2, 1.0, 0.3));
  const ShadowView view = spot_shadow_view(bounds, position, to_light, 0.4);
  const glm::dvec3 aside = glm::normalize(glm::cross(to_light, glm::dvec3(0.3, 0.1, 1.0)));
  const double distance = glm::length(position - glm::dvec3(0, 1, 0)), radius = 1.01 * std::sqrt(3.0);
  for (const double d : {distance - radius, distance, distance + radius}) {
    const glm::dvec3 edge = on_map(view, position - d * to_light + d * std::tan(0.4) * aside);
    EXPECT_NEAR(std::hypot(edge.x, edge.y), 1.0 / 1.01, 1e-9);
    const double near = distance - radius, far = distance + radius;
    EXPECT_NEAR(on_map(view, position - d * to_light).z, near * (far - d) / (d * (far - near)), 1e-9);
  }
  EXPECT_NEAR(view.texel_m, 2.0 * 1.01 * std::tan(0.4) / kShadowSize, 1e-12);
}

TEST(shadow_view, holds_the_bounds_and_is_nearest_to_the_light) {
  const Aabb bounds{{-3.0f, 0.0f, 1.0f}, {1.0f, 2.0f, 7.0f}};
  for (const glm::dvec3 to_light :
       {glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0), glm::normalize(glm::dvec3(-2, 0.5, 1))}) {
    const ShadowView view = shadow_view(bounds, to_light);
    for (int c = 0; c < 8; ++c) {
      const glm::dvec3 corner(c & 1 ? bounds.upper.x : bounds.lower.x, c & 2 ? bounds.upper.y : bounds.lower.y,
                              c & 4 ? bounds.upper.z : bounds.lower.z);
      const glm::dvec3 at = on_map(view, corner);
      EXPECT_LT(std::max(std::abs(at.x), std::abs(at.y)), 1.0);
      EXPECT_GT(at.z, 0.0);
      EXPECT_LT(at.z, 1.0);
      const glm::dvec3 nearer = on_map(view, corner + 0.1 * to_light);
      EXPECT_GT(nearer.z, at.z);
      EXPECT_NEAR(nearer.x, at.x, 1e-12);
      EXPECT_NEAR(nearer.y, at.y, 1e-12);
    }
    const double across = 2.0 / glm::length(glm::dvec3(view.map_from_world[0]));
    EXPECT_NEAR(view.texel_m, across / kShadowSize, 1e-9);
  }
}

}  // namespace
}  // namespace sinew::viewer
