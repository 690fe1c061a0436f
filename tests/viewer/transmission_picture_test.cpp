// SPDX-License-Identifier: MIT
// Pictures of thin transmissive surfaces (KHR_materials_transmission), compared with the reference renderer.
#include <algorithm>
#include <utility>

#include "samples/showcase/shapes.h"
#include "tests/reference/shade.h"
#include "tests/viewer/reference_picture.h"
#include "viewer/light/rooms.h"

namespace sinew::viewer {
namespace {

class transmission_picture : public DeviceTest {};

/// Glass; clear by default.
Material glass(const glm::vec4& color = {0.9f, 0.5f, 0.2f, 1.0f}, float roughness = 0.0f) {
  Material material;
  material.base_color = color;
  material.metallic = 0.0f;
  material.roughness = roughness;
  material.transmission.factor = 0.8f;
  return material;
}

/// A pane in the middle, and a wall that covers the right half of the picture. One part of the pane has the wall behind
/// it, the other part has nothing.
BuiltScene pane_before_wall(const Material& pane, const Material& behind = plain()) {
  BuiltScene built;
  built.add(wall(), built.add_material(pane), translation({-0.2f, 0.1f, 0.3f}));
  return lit_wall(std::move(built), behind, wall(), translation({1.4f, 0.0f, 0.0f}));
}

View before_pane() { return look_at({0.5, 0.4, 2.4}, {0.1, 0.0, 0.0}, 1.0, 0.05); }

constexpr PictureBounds kBounds{.bound = 0.002, .sharp = 0.5};

TEST_F(transmission_picture, what_is_behind_is_seen_through_the_colour_and_what_passes_is_not_scattered) {
  for (const float metallic : {0.0f, 0.4f, 1.0f}) {
    Material pane = glass();
    pane.metallic = metallic;
    pane.emissive = {0.0f, 0.1f, 0.2f};
    pane.specular.ior = 1.8f;
    for (const RenderOptions& options : {only_scene_lights(), only_ambient_light(), every_light()})
      expect_reference_picture(pane_before_wall(pane), before_pane(), options, kBounds);
  }
}

TEST_F(transmission_picture, the_environment_is_seen_through_the_colour_too) {
  for (const bool transparent : {false, true}) {
    RenderOptions options = every_light();
    options.backdrop = Backdrop::sharp;
    options.transparent_background = transparent;
    expect_reference_picture(pane_before_wall(glass()), before_pane(), options, kBounds);
  }
}

TEST_F(transmission_picture, coverage_counts_by_alpha_where_the_material_blends_or_cuts) {
  for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::mask, AlphaMode::blend})
    for (const Backdrop backdrop : {Backdrop::plain, Backdrop::sharp}) {
      Material pane = glass({0.3f, 0.9f, 0.5f, 0.6f});
      pane.alpha_mode = mode;
      pane.alpha_cutoff = 0.7f;
      RenderOptions options = every_light();
      options.backdrop = backdrop;
      SCOPED_TRACE(static_cast<int>(mode));
      expect_reference_picture(pane_before_wall(pane), before_pane(), options, kBounds);
    }
}

TEST_F(transmission_picture, panes_filter_each_other_from_far_to_near) {
  BuiltScene built = pane_before_wall(glass());
  Material second = glass({0.2f, 0.6f, 0.9f, 1.0f}), blended = plain();
  second.transmission.factor = 1.0f;
  blended.base_color.a = 0.5f;
  blended.alpha_mode = AlphaMode::blend;
  Primitive moved = wall();  // its middle is not its origin
  for (glm::vec3& p : moved.positions) p += glm::vec3(0.6f, -0.5f, 0.5f);
  built.add(moved, built.add_material(second));
  for (const glm::vec3& place : {glm::vec3(0.1f, 0.3f, 0.1f), {0.9f, -0.4f, 0.7f}})  // behind all, and before them
    built.add(wall(), built.add_material(blended), translation(place));
  expect_reference_picture(built, before_pane(), every_light(), kBounds);
}

TEST_F(transmission_picture, unlit_colours_are_seen_through_it) {
  Material behind = plain();
  behind.unlit = true;
  for (const Backdrop backdrop : {Backdrop::plain, Backdrop::sharp}) {
    RenderOptions options = every_light();
    options.backdrop = backdrop;
    for (const float roughness : {0.0f, 0.4f})
      expect_reference_picture(pane_before_wall(glass({0.9f, 0.5f, 0.2f, 1.0f}, roughness), behind), before_pane(),
                               options, kBounds);
  }
}

TEST_F(transmission_picture, back_faces_of_two_sided_surfaces_filter_first) {
  Material material = glass();
  material.double_sided = true;
  BuiltScene built;
  built.add(showcase::sphere({0.1f, 0.0f, 0.5f}, 0.4f, 16, 8), built.add_material(material));
  expect_reference_picture(lit_wall(std::move(built), plain()), view_of_wall(), every_light(), kBounds);
}

TEST_F(transmission_picture, other_layers_and_the_texture_scale_what_passes) {
  Material material = glass();
  material.transmission.factor = 1.0f;
  material.metallic = 0.3f;  // metal lets nothing pass
  material.sheen = {.color = {0.5f, 0.2f, 0.1f}, .roughness = 0.5f};
  material.clearcoat = {.factor = 0.7f, .roughness = 0.3f};
  for (const TextureUse& placed : placed_textures()) {
    BuiltScene built;
    Material pane = material;
    pane.transmission.texture = placed;
    pane.transmission.texture.texture = add_noise_texture(built);
    built.add(wall(), built.add_material(pane), translation({-0.2f, 0.1f, 0.3f}));
    expect_reference_picture(lit_wall(std::move(built), plain()), before_pane(), every_light(), kBounds);
  }
}

TEST_F(transmission_picture, the_texture_of_the_colour_filters_what_passes) {
  BuiltScene built;
  Material pane = glass({1.0f, 0.9f, 0.8f, 1.0f});
  pane.base_color_texture.texture = add_noise_texture(built);
  built.add(wall(), built.add_material(pane), translation({-0.2f, 0.1f, 0.3f}));
  PictureBounds bounds = kBounds;
  bounds.bound = kDecodedBound;
  expect_reference_picture(lit_wall(std::move(built), plain()), before_pane(), every_light(), bounds);
}

TEST_F(transmission_picture, rough_surfaces_blur_what_is_opaque_behind_them) {
  for (const float roughness : {0.02f, 0.3f, 0.55f, 1.0f})
    for (const bool transparent : {false, true})
      for (const Backdrop backdrop : {Backdrop::plain, Backdrop::sharp}) {
        RenderOptions options = every_light();
        options.transparent_background = transparent;
        options.backdrop = backdrop;
        SCOPED_TRACE(roughness);
        expect_reference_picture(pane_before_wall(glass({0.9f, 0.5f, 0.2f, 1.0f}, roughness)), before_pane(), options,
                                 kBounds);
      }
}

TEST_F(transmission_picture, rough_surfaces_in_pictures_of_any_size) {
  for (const auto& [width, height] : {std::pair(1, 1), {23, 17}, {40, 1}, {3, 31}}) {
    PictureBounds bounds = kBounds;
    bounds.width = width;
    bounds.height = height;
    bounds.sharp = 0.0;  // edges are wide where pixels are large
    SCOPED_TRACE(width);
    expect_reference_picture(pane_before_wall(glass({0.9f, 0.5f, 0.2f, 1.0f}, 0.6f)), before_pane(), every_light(),
                             bounds);
  }
}

TEST_F(transmission_picture, rough_surfaces_blur_as_far_in_long_pictures_as_in_others) {
  PictureBounds bounds = kBounds;
  bounds.width = 64;
  bounds.height = 10;
  const View close = look_at({0.3, 0.1, 2.4}, {0.3, 0.1, 0.0}, 0.25, 0.05);
  for (const float roughness : {0.5f, 1.0f})
    expect_reference_picture(pane_before_wall(glass({0.9f, 0.5f, 0.2f, 1.0f}, roughness)), close, every_light(),
                             bounds);
}

TEST_F(transmission_picture, rough_surfaces_cover_by_their_alpha) {
  Material unlit = plain();
  unlit.unlit = true;
  for (const Material& behind : {plain(), unlit})
    for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::mask, AlphaMode::blend})
      for (const Backdrop backdrop : {Backdrop::plain, Backdrop::sharp}) {
        Material pane = glass({0.3f, 0.9f, 0.5f, 0.6f}, 0.5f);
        pane.alpha_mode = mode;
        pane.alpha_cutoff = 0.7f;
        RenderOptions options = every_light();
        options.backdrop = backdrop;
        SCOPED_TRACE(static_cast<int>(mode));
        expect_reference_picture(pane_before_wall(pane, behind), before_pane(), options, kBounds);
      }
}

TEST_F(transmission_picture, rough_surfaces_hide_other_panes_behind_them) {
  BuiltScene built = pane_before_wall(glass({0.2f, 0.6f, 0.9f, 1.0f}));
  Primitive moved = wall();
  for (glm::vec3& p : moved.positions) p += glm::vec3(0.6f, -0.5f, 0.5f);
  built.add(moved, built.add_material(glass({0.9f, 0.9f, 0.5f, 1.0f}, 0.4f)));
  expect_reference_picture(built, before_pane(), every_light(), kBounds);
}

/// The picture behind has one colour, because Mesa's software driver reads one mip level for 2 x 2 pixels.
TEST_F(transmission_picture, the_texture_of_roughness_tells_how_much_is_blurred) {
  BuiltScene built;
  Material pane = glass(glm::vec4(1.0f), 0.9f);
  pane.metallic_roughness_texture.texture = add_plain_texture(built, {255, 110, 0, 255});
  built.add(wall(), built.add_material(pane), translation({-0.2f, 0.1f, 0.3f}));
  expect_reference_picture(lit_wall(std::move(built), plain(), wall(), translation({1.4f, 0.0f, 0.0f})), before_pane(),
                           every_light(), kBounds);
}

TEST_F(transmission_picture, smooth_edges_change_nothing_inside_of_rough_surfaces) {
  const BuiltScene built = pane_before_wall(glass(glm::vec4(1.0f), 0.6f));
  RenderOptions options = every_light();
  const FloatPicture plain_edges = render_float(built, 48, 40, before_pane(), options);
  options.smooth_edges = true;
  const FloatPicture smooth = render_float(built, 48, 40, before_pane(), options);
  for (int y = 12; y < 28; ++y)
    for (int x = 12; x < 36; ++x)
      EXPECT_LT(glm::length(smooth.at(x, y) - plain_edges.at(x, y)), 0.02f) << x << ' ' << y;
}

TEST_F(transmission_picture, the_blurred_backdrop_is_seen_through_rough_surfaces_at_least_as_blurred) {
  RenderOptions options = only_ambient_light();
  options.backdrop = Backdrop::blurred;
  options.lighting.environment = make_environment(sky_of(Room::studio));  // as bright behind as it lights
  BuiltScene built;
  const auto pane = [](float roughness) {
    Material material = glass(glm::vec4(1.0f), roughness);
    material.transmission.factor = 1.0f;
    return material;
  };
  built.add(wall(), built.add_material(pane(0.1f)));
  const FloatPicture through = render_float(built, 24, 20, look_at({0.0, 0.0, 1.0}, {0, 0, 0}, 0.6, 0.05), options),
                     directly =
                         render_float(BuiltScene(), 24, 20, look_at({0.0, 0.0, 1.0}, {0, 0, 0}, 0.6, 0.05), options);
  double off = 0.0;
  for (std::size_t i = 0; i < through.pixels.size(); ++i)
    off = std::max(off, static_cast<double>(glm::length(through.pixels[i] - directly.pixels[i])));
  EXPECT_LT(off, 0.06) << "all but what the surface reflects";
}

TEST_F(transmission_picture, white_glass_in_white_light_is_not_seen) {
  constexpr float radiance = 0.5f;
  RenderOptions options = only_ambient_light();
  options.backdrop = Backdrop::sharp;
  options.lighting.environment = gradient_environment({.sky = glm::vec3(radiance), .ground = glm::vec3(radiance)});
  const double white = reference::srgb_encoded(reference::tone_mapped(glm::dvec3(radiance)).r);
  for (const float factor : {0.3f, 1.0f})
    for (const float roughness : {0.1f, 1.0f}) {
      Material material = glass(glm::vec4(1.0f));
      material.roughness = roughness;
      material.transmission.factor = factor;
      BuiltScene built;
      built.add(showcase::sphere({0, 0, 0}, 0.9f, 20, 12), built.add_material(material));
      const View view = look_at({0.8, 1.2, 2.2}, {0.0, 0.0, 0.0}, 0.75, 0.05);
      for (const glm::vec4& pixel : render_float(built, 32, 32, view, options).pixels)
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(pixel[c], white, 0.004) << roughness;
    }
}

}  // namespace
}  // namespace sinew::viewer
