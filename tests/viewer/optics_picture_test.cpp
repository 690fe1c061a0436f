// SPDX-License-Identifier: MIT
// Pictures of thin films, stretched highlights and volumes, compared with the reference renderer.
#include <utility>

#include "samples/showcase/shapes.h"
#include "tests/viewer/reference_picture.h"

namespace sinew::viewer {
namespace {

class optics_picture : public DeviceTest {};

/// A sphere of this material before a wall, so that light grazes it somewhere.
void expect_ball(const Material& material, const PictureBounds& bounds) {
  for (const RenderOptions& options : {only_scene_lights(), only_ambient_light(), every_light()}) {
    BuiltScene built;
    built.add(showcase::sphere({0.1f, 0.0f, 0.4f}, 0.4f, 16, 8), built.add_material(material));
    expect_reference_picture(lit_wall(std::move(built), plain()), view_of_wall(), options, bounds);
  }
}

TEST_F(optics_picture, thin_films_colour_what_dielectrics_and_metals_reflect) {
  for (const float metallic : {0.0f, 1.0f})
    for (const float thickest_nm : {0.0f, 450.0f}) {
      Material material = plain();
      material.roughness = 0.35f;
      material.metallic = metallic;
      material.iridescence = {.factor = 0.8f, .ior = 1.6f, .thickest_nm = thickest_nm};
      SCOPED_TRACE(thickest_nm);
      expect_ball(material, {.bound = 0.003, .sharp = 0.5});
    }
}

TEST_F(optics_picture, textures_of_a_film_scale_its_share_and_its_thickness) {
  for (const bool thickness : {false, true})
    for (const TextureUse& placed : placed_textures()) {
      BuiltScene built;
      Material material = plain();
      material.metallic = 0.5f;
      material.iridescence = {.factor = 1.0f, .ior = 1.8f, .thinnest_nm = 150.0f, .thickest_nm = 550.0f};
      TextureUse& use = thickness ? material.iridescence.thickness_texture : material.iridescence.texture;
      use = placed;
      use.texture = add_noise_texture(built);
      expect_reference_picture(lit_wall(std::move(built), material), view_of_wall(), every_light(),
                               {.bound = 0.003, .sharp = 0.4});
    }
}

TEST_F(optics_picture, highlights_are_stretched_along_the_turned_tangent) {
  for (const bool tangents : {false, true})
    for (const float rotation_rad : {0.0f, 0.7f, 2.0f}) {
      Material material = plain();
      material.metallic = 0.5f;
      material.roughness = 0.35f;
      material.anisotropy = {.strength = 0.8f, .rotation_rad = rotation_rad};
      Primitive p = wall();
      if (!tangents) p.tangents.clear();
      SCOPED_TRACE(rotation_rad);
      for (const RenderOptions& options : {only_scene_lights(), only_ambient_light()})
        expect_reference_picture(lit_wall({}, material, p), view_of_wall(), options, {.bound = 0.003, .sharp = 0.5});
    }
}

TEST_F(optics_picture, the_texture_of_anisotropy_has_direction_and_strength) {
  for (const TextureUse& placed : placed_textures()) {
    BuiltScene built;
    Material material = plain();
    material.roughness = 0.4f;
    material.anisotropy = {.strength = 0.9f, .texture = placed};
    material.anisotropy.texture.texture = add_noise_texture(built);
    expect_reference_picture(lit_wall(std::move(built), material), view_of_wall(), every_light(),
                             {.bound = 0.003, .sharp = 0.4});
  }
}

TEST_F(optics_picture, the_specular_texture_has_glossiness_in_its_alpha) {
  for (const TextureUse& placed : placed_textures()) {
    BuiltScene built;
    Material material = plain();
    material.metallic = 0.0f;
    material.roughness = 0.2f;
    material.specular = {.ior = 0.0f, .color = {0.5f, 0.3f, 0.2f}, .color_texture = placed, .has_glossiness = true};
    material.specular.color_texture.texture = add_noise_texture(built);
    expect_reference_picture(lit_wall(std::move(built), material), view_of_wall(), every_light(),
                             {.bound = kDecodedBound, .sharp = 0.4});
  }
}

/// Glass with a thickness, before a wall that covers the right half of the picture.
BuiltScene glass_before_wall(const Material& glass, float scale, BuiltScene built = {}) {
  Affine place = translation({-0.2f, 0.1f, 0.3f});
  for (int i = 0; i < 3; ++i) place.row[i][i] = scale;
  built.add(wall(), built.add_material(glass), place);
  return lit_wall(std::move(built), plain(), wall(), translation({1.4f, 0.0f, 0.0f}));
}

Material thick_glass(float roughness) {
  Material glass;
  glass.base_color = {0.9f, 0.8f, 0.7f, 1.0f};
  glass.metallic = 0.0f;
  glass.roughness = roughness;
  glass.transmission.factor = 0.9f;
  glass.volume = {.thickness_m = 0.3f};
  return glass;
}

TEST_F(optics_picture, volumes_refract_the_opaque_picture_and_blur_it_by_roughness) {
  for (const float roughness : {0.0f, 0.5f})
    for (const float scale : {1.0f, 0.6f})
      for (const Backdrop backdrop : {Backdrop::plain, Backdrop::sharp}) {
        RenderOptions options = every_light();
        options.backdrop = backdrop;
        SCOPED_TRACE(roughness);
        expect_reference_picture(glass_before_wall(thick_glass(roughness), scale),
                                 look_at({0.9, 0.4, 2.2}, {0.2, 0.0, 0.0}, 1.0, 0.05), options,
                                 {.bound = 0.003, .sharp = 0.5});
      }
}

TEST_F(optics_picture, volumes_absorb_light_by_the_length_of_its_way) {
  for (const float distance_m : {0.1f, 1.0f}) {
    BuiltScene built;
    Material glass = thick_glass(0.4f);
    glass.volume.attenuation_distance_m = distance_m;
    glass.volume.attenuation_color = {0.9f, 0.4f, 0.1f};
    glass.volume.texture.texture = add_plain_texture(built, {0, 180, 0, 255});
    expect_reference_picture(glass_before_wall(glass, 0.8f, std::move(built)),
                             look_at({0.9, 0.4, 2.2}, {0.2, 0.0, 0.0}, 1.0, 0.05), every_light(),
                             {.bound = 0.003, .sharp = 0.5});
  }
}

}  // namespace
}  // namespace sinew::viewer
