// SPDX-License-Identifier: MIT
// Pictures of thin surfaces that light passes through (KHR_materials_transmission), compared with the reference
// renderer.
#include "samples/showcase/shapes.h"
#include "tests/reference/shade.h"
#include "tests/viewer/reference_picture.h"

namespace sinew::viewer {
namespace {

class transmission_picture : public DeviceTest {};

Material glass(const glm::vec4& color = {0.9f, 0.5f, 0.2f, 1.0f}) {
  Material material;
  material.base_color = color;
  material.metallic = 0.0f;
  material.roughness = 0.3f;
  material.transmission.factor = 0.8f;
  return material;
}

/// A pane before the right half of the picture's wall, so that it is seen before a surface and before nothing. The wall
/// is on the right.
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
  built.add(wall(), built.add_material(blended), translation({0.1f, 0.3f, 0.1f}));
  expect_reference_picture(built, before_pane(), every_light(), kBounds);
}

TEST_F(transmission_picture, unlit_colours_are_seen_through_it) {
  Material behind = plain();
  behind.unlit = true;
  for (const Backdrop backdrop : {Backdrop::plain, Backdrop::sharp}) {
    RenderOptions options = every_light();
    options.backdrop = backdrop;
    expect_reference_picture(pane_before_wall(glass(), behind), before_pane(), options, kBounds);
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
