// SPDX-License-Identifier: MIT
// Pictures of one layer of a material each (ior, specular, clearcoat, sheen), compared with the reference renderer.
#include "samples/showcase/shapes.h"
#include "tests/reference/shade.h"
#include "tests/viewer/reference_picture.h"
#include "viewer/passes/frame_uniforms.h"
#include "viewer/upload/upload_materials.h"

namespace sinew::viewer {
namespace {

class layer_picture : public DeviceTest {};

/// A wall with a sphere before it, so that light grazes the surface somewhere.
BuiltScene lit_ball(const Material& material, BuiltScene built = {}) {
  built.add(showcase::sphere({0.1f, 0.0f, 0.4f}, 0.4f, 16, 8), built.add_material(material));
  return lit_wall(std::move(built), plain());
}

void expect_layer(const Material& material, const char* what) {
  SCOPED_TRACE(what);
  for (const RenderOptions& options : {only_scene_lights(), only_ambient_light(), every_light()})
    expect_reference_picture(lit_ball(material), view_of_wall(), options, {.bound = 0.002});
}

TEST_F(layer_picture, index_of_refraction_says_what_is_reflected_along_the_normal) {
  for (const float ior : {1.0f, 1.2f, 2.4f, 0.0f}) {
    Material material = plain();
    material.roughness = 0.4f;
    material.specular.ior = ior;
    expect_layer(material, ("ior " + std::to_string(ior)).c_str());
  }
}

TEST_F(layer_picture, specular_scales_what_a_dielectric_reflects_and_tints_it_along_the_normal) {
  for (const float metallic : {0.0f, 0.4f, 1.0f}) {
    Material material = plain();
    material.roughness = 0.35f;
    material.metallic = metallic;
    material.specular.factor = 0.3f;
    expect_layer(material, "factor");
    material.specular.color = {1.0f, 0.2f, 0.6f};
    expect_layer(material, "colour");
    material.specular = {.ior = 1.8f, .factor = 0.6f, .color = {30.0f, 2.0f, 0.0f}};  // red is clipped, then scaled
    expect_layer(material, "colour above 1");
  }
}

TEST_F(layer_picture, clearcoat_reflects_by_its_own_roughness_and_takes_light_from_what_is_below) {
  for (const float metallic : {0.0f, 1.0f})
    for (const float roughness : {0.0f, 0.5f}) {
      Material material = plain();
      material.metallic = metallic;
      material.emissive = {0.1f, 0.3f, 0.0f};
      material.clearcoat = {.factor = 0.8f, .roughness = roughness};
      SCOPED_TRACE(roughness);
      for (const RenderOptions& options : {only_scene_lights(), only_ambient_light(), every_light()})
        expect_reference_picture(lit_ball(material), view_of_wall(), options,
                                 {.bound = 0.002, .sharp = roughness > 0.0f ? 0.7 : 0.5});
    }
}

TEST_F(layer_picture, clearcoat_has_the_normals_of_the_mesh_or_of_its_own_map) {
  for (const int own_set : {-1, 0, 1})  // -1: no map of its own
    for (const bool tangents : {false, true}) {
      BuiltScene built;
      Material material = plain();
      material.clearcoat = {.factor = 1.0f, .roughness = 0.4f};
      material.normal_texture.texture = add_plain_texture(built, {196, 90, 220, 255});
      if (own_set >= 0)
        material.clearcoat.normal_texture = {.texture = add_plain_texture(built, {80, 150, 230, 255}),
                                             .texcoord = static_cast<std::uint32_t>(own_set)};
      material.clearcoat.normal_scale = 0.7f;
      Primitive p = wall();
      if (!tangents) p.tangents.clear();
      expect_reference_picture(lit_wall(built, material, p), view_of_wall(), every_light(), {.bound = 0.002});
    }
}

TEST_F(layer_picture, back_sides_are_coated_with_the_normal_reversed) {
  BuiltScene built;
  Material material = plain();
  material.double_sided = true;
  material.clearcoat = {.factor = 1.0f, .roughness = 0.3f};
  material.clearcoat.normal_texture.texture = add_plain_texture(built, {196, 90, 220, 255});
  Affine turned;  // about y by 180 degrees
  turned.row[0].x = turned.row[2].z = -1.0f;
  expect_reference_picture(lit_wall(built, material, wall(), turned), view_of_wall(), every_light(), {.bound = 0.002});
}

TEST_F(layer_picture, sheen_shines_at_grazing_angles_and_takes_as_much_from_what_is_below) {
  for (const float roughness : {0.0f, 0.2f, 0.5f, 1.0f}) {
    Material material = plain();
    material.base_color = {0.3f, 0.1f, 0.1f, 1.0f};
    material.sheen = {.color = {0.9f, 0.6f, 0.2f}, .roughness = roughness};
    SCOPED_TRACE(roughness);
    for (const RenderOptions& options : {only_scene_lights(), only_ambient_light(), every_light()})
      expect_reference_picture(lit_ball(material), view_of_wall(), options, {.bound = 0.003, .sharp = 0.5});
  }
}

TEST_F(layer_picture, sheen_returns_no_more_light_than_there_is_along_the_surface) {
  for (const float roughness : {0.0f, 0.15f}) {
    Material material = plain();
    material.sheen = {.color = {0.9f, 0.6f, 0.2f}, .roughness = roughness};
    BuiltScene built;
    built.add(wall(), built.add_material(material));
    add_light_at(built, {.intensity = 0.8f}, {0, 0, 0}, {-0.6f, 0.8f, -0.03f});
    const View along = look_at({0.0, -1.1, 0.03}, {0.0, 0.2, 0.0}, 0.3, 0.05);
    expect_reference_picture(built, along, only_scene_lights(), {.bound = 0.003, .sharp = 0.4});
  }
}

TEST_F(layer_picture, sheen_lies_between_the_surface_and_its_coat) {
  Material material = plain();
  material.emissive = {0.1f, 0.0f, 0.2f};
  material.sheen = {.color = {0.2f, 0.9f, 0.5f}, .roughness = 0.4f};
  material.clearcoat = {.factor = 0.9f, .roughness = 0.3f};
  for (const RenderOptions& options : {only_scene_lights(), only_ambient_light(), every_light()})
    expect_reference_picture(lit_ball(material), view_of_wall(), options, {.bound = 0.003, .sharp = 0.5});
}

struct LayerTexture {
  const char* what;
  TextureUse& (*use)(Material&);
  bool srgb;
};

constexpr LayerTexture kTextures[] = {
    {"specular", [](Material& m) -> TextureUse& { return m.specular.texture; }, false},
    {"specular colour", [](Material& m) -> TextureUse& { return m.specular.color_texture; }, true},
    {"clearcoat", [](Material& m) -> TextureUse& { return m.clearcoat.texture; }, false},
    {"clearcoat roughness", [](Material& m) -> TextureUse& { return m.clearcoat.roughness_texture; }, false},
    {"clearcoat normal", [](Material& m) -> TextureUse& { return m.clearcoat.normal_texture; }, false},
    {"sheen colour", [](Material& m) -> TextureUse& { return m.sheen.color_texture; }, true},
    {"sheen roughness", [](Material& m) -> TextureUse& { return m.sheen.roughness_texture; }, false},
};

Material with_all_layers() {
  Material material = plain();
  material.roughness = 0.4f;
  material.specular = {.ior = 1.9f, .factor = 0.8f, .color = {0.9f, 0.5f, 0.7f}};
  material.clearcoat = {.factor = 0.9f, .roughness = 0.6f};
  material.sheen = {.color = {0.4f, 0.7f, 0.9f}, .roughness = 0.8f};
  return material;
}

TEST_F(layer_picture, each_texture_of_a_layer_has_its_own_coordinates_and_transform) {
  for (const LayerTexture& texture : kTextures)
    for (const TextureUse& placed : placed_textures()) {
      BuiltScene built;
      Material material = with_all_layers();
      TextureUse& use = texture.use(material);
      use = placed;
      use.texture = add_noise_texture(built);
      expect_reference_picture(lit_wall(built, material), view_of_wall(), every_light(),
                               {.bound = texture.srgb ? kDecodedBound : 0.002, .sharp = 0.5});
      if (HasFailure()) FAIL() << texture.what << ", set " << use.texcoord << ", turned by " << use.rotation_rad;
    }
}

TEST_F(layer_picture, textures_of_layers_share_images_with_others) {
  for (const std::uint32_t set : {0u, 1u}) {
    BuiltScene built;
    Material material = with_all_layers();
    const std::uint32_t shared = add_noise_texture(built);
    const std::uint32_t other = add_plain_texture(built, {196, 90, 220, 255});
    for (TextureUse* use : texture_uses(material)) use->texture = shared;
    material.normal_texture.texture = material.occlusion_texture.texture = other;
    for (const LayerTexture& texture : kTextures) {
      texture.use(material).texcoord = set;
      if (!texture.srgb) texture.use(material).texture = other;
    }
    ASSERT_TRUE(shows_all_textures(material));
    expect_reference_picture(lit_wall(built, material), view_of_wall(), every_light(),
                             {.bound = kDecodedBound, .sharp = 0.4});
  }
}

TEST_F(layer_picture, white_surfaces_in_white_light_return_all_of_it_under_every_layer) {
  constexpr float radiance = 0.5f;
  RenderOptions options = only_ambient_light();
  options.transparent_background = true;
  options.lighting.environment = gradient_environment({.sky = glm::vec3(radiance), .ground = glm::vec3(radiance)});
  options.lighting.tone_curve = ToneCurve::none;
  Material layers[6];
  layers[0].specular = {.ior = 2.2f, .factor = 0.6f};
  layers[1].clearcoat = {.factor = 1.0f, .roughness = 0.0f};
  layers[2].clearcoat = {.factor = 0.7f, .roughness = 0.8f};
  for (int i = 3; i < 6; ++i)
    layers[i].sheen = {.color = glm::vec3(1.0f), .roughness = 0.1f + 0.4f * static_cast<float>(i - 3)};
  for (Material& material : layers)
    for (const float roughness : {0.1f, 0.5f, 1.0f}) {
      material.metallic = 0.0f;
      material.roughness = roughness;
      BuiltScene built;
      built.add(showcase::sphere({0, 0, 0}, 0.9f, 20, 12), built.add_material(material));
      const View view = look_at({0.8, 1.2, 2.2}, {0.0, 0.0, 0.0}, 0.75, 0.05);
      int covered = 0;
      for (const glm::vec4& pixel : render_float(built, 32, 32, view, options).pixels) {
        if (pixel.a == 0.0f) continue;
        ++covered;
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(linear_from_srgb(pixel[c]), radiance, kFurnaceBound * radiance) << roughness;
      }
      EXPECT_GT(covered, 200);
    }
}

}  // namespace
}  // namespace sinew::viewer
