// SPDX-License-Identifier: MIT
// Pictures of one term of the material model each, compared with the reference renderer.
#include <glm/geometric.hpp>

#include "samples/showcase/shapes.h"
#include "tests/viewer/reference_picture.h"

namespace sinew::viewer {
namespace {

class material_picture : public DeviceTest {};

TEST_F(material_picture, base_color_is_factor_times_texture_times_vertex_color) {
  BuiltScene built;
  Material material;
  material.unlit = true;
  material.base_color = {0.9f, 0.5f, 0.7f, 1.0f};
  material.base_color_texture.texture = add_noise_texture(built);
  Primitive p = wall();
  p.colors = {{1, 0.2f, 0.5f, 1}, {0.3f, 1, 0.4f, 1}, {0.8f, 0.6f, 0.1f, 1}, {0.2f, 0.4f, 1, 1}};
  built.add(p, built.add_material(material));
  expect_reference_picture(built, view_of_wall(), every_light(), {.bound = kDecodedBound});
}

TEST_F(material_picture, G60_each_texture_has_its_own_coordinates_and_transform) {
  for (TextureUse Material::*const slot :
       {&Material::base_color_texture, &Material::metallic_roughness_texture, &Material::normal_texture,
        &Material::occlusion_texture, &Material::emissive_texture})
    for (const TextureUse& placed : placed_textures()) {
      BuiltScene built;
      Material material = plain();
      material.metallic = material.roughness = 0.9f;
      material.emissive = glm::vec3(0.5f);
      TextureUse& use = material.*slot;
      use = placed;
      use.texture = add_noise_texture(built);
      const bool srgb = slot == &Material::base_color_texture || slot == &Material::emissive_texture;
      expect_reference_picture(lit_wall(built, material), view_of_wall(), every_light(),
                               {.bound = srgb ? kDecodedBound : 0.002, .sharp = 0.5});
      if (HasFailure()) FAIL() << "set " << use.texcoord << ", turned by " << use.rotation_rad;
    }
}

TEST_F(material_picture, textures_repeat_clamp_or_mirror_on_each_axis) {
  for (const Wrap u : {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat})
    for (const Wrap v : {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat}) {
      BuiltScene built;
      Material material;
      material.unlit = true;
      material.base_color_texture.texture = add_noise_texture(
          built,
          {.magnify = Filter::nearest, .minify = Filter::nearest, .use_mipmaps = false, .wrap_u = u, .wrap_v = v});
      material.base_color_texture.offset = {-1.1f, -0.8f};
      material.base_color_texture.scale = {2.2f, 1.9f};
      built.add(wall(), built.add_material(material));
      expect_reference_picture(built, view_of_wall(), every_light(), {.bound = kDecodedBound, .sharp = 0.4});
    }
}

TEST_F(material_picture, linear_filter_mixes_light_between_texels) {
  BuiltScene built;
  Material material;
  material.unlit = true;
  material.base_color_texture.texture = add_noise_texture(built, {.use_mipmaps = false});
  material.base_color_texture.scale = {0.4f, 0.4f};
  built.add(wall(), built.add_material(material));
  expect_reference_picture(built, view_of_wall(), every_light(), {.bound = kDecodedBound, .sharp = 0.5});
}

TEST_F(material_picture, metallic_is_blue_and_roughness_is_green) {
  for (const std::array<std::uint8_t, 4>& rgba :
       {std::array<std::uint8_t, 4>{255, 90, 230, 10}, {0, 230, 40, 255}, {128, 120, 128, 0}}) {
    BuiltScene built;
    Material material = plain();
    material.metallic = 0.9f;
    material.roughness = 0.8f;
    material.metallic_roughness_texture.texture = add_plain_texture(built, rgba);
    expect_reference_picture(lit_wall(built, material), view_of_wall(), every_light());
  }
}

TEST_F(material_picture, baked_occlusion_is_red_and_scales_ambient_light_alone) {
  for (const float strength : {0.0f, 0.5f, 1.0f}) {
    BuiltScene built;
    Material material = plain();
    material.emissive = {0.02f, 0.05f, 0.01f};
    material.occlusion_strength = strength;
    material.occlusion_texture.texture = add_plain_texture(built, {60, 200, 120, 255});
    const BuiltScene scene = lit_wall(built, material);
    expect_reference_picture(scene, view_of_wall(), only_ambient_light());
    expect_reference_picture(scene, view_of_wall(), every_light());
  }
}

TEST_F(material_picture, emission_is_factor_times_strength_times_texture) {
  for (const float strength : {0.5f, 1.0f, 6.0f}) {
    BuiltScene built;
    Material material = plain();
    material.base_color = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
    material.emissive = {0.9f, 0.4f, 0.6f};
    material.emissive_strength = strength;
    material.emissive_texture.texture = add_noise_texture(built);
    built.add(wall(), built.add_material(material));
    expect_reference_picture(built, view_of_wall(), only_scene_lights(), {.bound = kDecodedBound});
  }
}

/// A wall with a normal map of leaning normals.
BuiltScene relief_wall(float scale, const Primitive& primitive, const Affine& world_from_wall = {},
                       bool mirrored = false) {
  BuiltScene built;
  Material material = plain();
  material.double_sided = true;
  material.normal_texture.texture = add_plain_texture(built, {196, 90, 220, 255});
  material.normal_scale = scale;
  return lit_wall(built, material, primitive, world_from_wall, mirrored);
}

TEST_F(material_picture, normal_map_is_scaled_across_the_surface) {
  for (const float scale : {0.0f, 0.4f, 1.0f, 2.5f, -1.0f})
    expect_reference_picture(relief_wall(scale, wall()), view_of_wall(), every_light());
}

TEST_F(material_picture, normal_map_follows_the_handedness_of_tangents) {
  Primitive p = wall();
  for (glm::vec4& t : p.tangents) t = {0.6f, 0.8f, 0.0f, -1.0f};
  expect_reference_picture(relief_wall(1.0f, p), view_of_wall(), every_light());
  for (glm::vec4& t : p.tangents) t = {0.6f, 0.5f, 0.62f, 1.0f};  // not in the surface
  expect_reference_picture(relief_wall(1.0f, p), view_of_wall(), every_light());
}

TEST_F(material_picture, G48_normal_map_keeps_its_sense_where_a_mesh_is_mirrored) {
  Affine mirror;
  mirror.row[0].x = -1.0f;
  expect_reference_picture(relief_wall(1.0f, wall(), mirror, true), view_of_wall(), every_light());
}

TEST_F(material_picture, normal_map_without_tangents_follows_the_texture_coordinates) {
  Primitive p = wall();
  p.tangents.clear();
  expect_reference_picture(relief_wall(1.0f, p), view_of_wall(), every_light());
  p.texcoords[0] = {{1, 0}, {1, 1}, {0, 1}, {0, 0}};  // mirrored
  expect_reference_picture(relief_wall(1.0f, p), view_of_wall(), every_light());
  p.texcoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};  // turned
  expect_reference_picture(relief_wall(1.0f, p), view_of_wall(), every_light());
  p.texcoords[0] = {{0, 0}, {1, 3}, {5, 4}, {4, 1}};  // stretched and sheared: tangents are unit vectors all the same
  expect_reference_picture(relief_wall(1.0f, p), view_of_wall(), every_light());
  BuiltScene built = relief_wall(1.0f, p);
  built.scene.materials[0].normal_texture.texcoord = 1;
  expect_reference_picture(built, view_of_wall(), every_light());
}

TEST_F(material_picture, normal_map_without_tangents_on_one_texel_changes_nothing) {
  const auto pixels = [](float scale, const Primitive& p) {
    return render_float(relief_wall(scale, p), 16, 16, view_of_wall(), every_light()).pixels;
  };
  Primitive p = wall();
  const auto plain = pixels(0.0f, p);
  p.tangents.clear();
  for (glm::vec2& uv : p.texcoords[0]) uv = {0.0f, 0.0f};
  EXPECT_EQ(pixels(1.0f, p), plain);
}

TEST_F(material_picture, tangents_nearly_parallel_to_the_normal_change_nothing) {
  const auto pixels = [](float scale, const Primitive& p) {
    return render_float(relief_wall(scale, p), 24, 20, view_of_wall(), every_light()).pixels;
  };
  const auto unmapped = pixels(0.0f, wall());
  for (const float length : {1.0f, 1e-6f, 1e6f})
    for (const float sine : {0.0f, 1e-8f, 3e-7f, 5e-4f}) {
      Primitive p = wall();
      for (glm::vec4& t : p.tangents) t = {sine * length, 0.0f, length, 1.0f};
      const auto mapped = pixels(1.0f, p);
      for (std::size_t i = 0; i < mapped.size(); ++i)
        ASSERT_LT(glm::length(mapped[i] - unmapped[i]), 1e-3f) << "sine " << sine << ", length " << length;
      for (glm::vec4& t : p.tangents) t = {0.01f * length, 0.0f, length, 1.0f};  // this one has a direction
      expect_reference_picture(relief_wall(1.0f, p), view_of_wall(), every_light());
    }
}

TEST_F(material_picture, back_sides_have_the_whole_normal_reversed) {
  Affine turned;  // about y by 180 degrees
  turned.row[0].x = turned.row[2].z = -1.0f;
  Primitive without = wall();
  without.tangents.clear();
  for (const Primitive& p : {wall(), without})
    for (const float scale : {0.0f, 1.0f})
      expect_reference_picture(relief_wall(scale, p, turned), view_of_wall(), every_light());
}

TEST_F(material_picture, unlit_shows_the_base_color_alone) {
  BuiltScene built;
  Material material = plain();
  material.unlit = true;
  material.emissive = glm::vec3(0.5f);
  material.normal_texture.texture = material.occlusion_texture.texture = material.emissive_texture.texture =
      material.metallic_roughness_texture.texture = add_plain_texture(built, {30, 60, 90, 255});
  expect_reference_picture(lit_wall(built, material), view_of_wall(), every_light());
}

TEST_F(material_picture, meshes_without_normals_show_base_color_and_emission) {
  Primitive p = wall();
  p.normals.clear();
  p.tangents.clear();
  Material material = plain();
  material.emissive = {0.0f, 0.1f, 0.2f};
  expect_reference_picture(lit_wall({}, material, p), view_of_wall(), every_light());
}

/// A wall whose alpha is factor * texture * vertex colour, before another wall.
BuiltScene wall_of_alpha(AlphaMode mode, float cutoff) {
  BuiltScene built;
  Material material = plain(), behind = plain();
  material.base_color = {0.3f, 0.7f, 0.4f, 0.8f};
  material.alpha_mode = mode;
  material.alpha_cutoff = cutoff;
  material.base_color_texture.texture = add_noise_texture(built);
  behind.base_color = {0.8f, 0.1f, 0.1f, 0.2f};  // opaque all the same
  Primitive p = wall();
  p.colors = {{1, 1, 1, 0.5f}, {1, 1, 1, 0.7f}, {1, 1, 1, 2.6f}, {1, 1, 1, 1.8f}};
  built.add(p, built.add_material(material), translation({0.0f, 0.0f, 0.1f}));
  return lit_wall(built, behind);
}

TEST_F(material_picture, alpha_is_ignored_cut_or_blended) {
  for (const float cutoff : {0.2f, 0.5f})
    expect_reference_picture(wall_of_alpha(AlphaMode::mask, cutoff), view_of_wall(), every_light(),
                             {.bound = kDecodedBound, .sharp = 0.5});
  for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::blend})
    expect_reference_picture(wall_of_alpha(mode, 0.5f), view_of_wall(), every_light(), {.bound = kDecodedBound});
}

TEST_F(material_picture, alpha_equal_to_the_cutoff_is_kept) {
  for (const float alpha : {0.5f, 0.4999f}) {
    Material material = plain();
    material.base_color.a = alpha;
    material.alpha_mode = AlphaMode::mask;
    for (const bool prepass : {false, true}) {
      RenderOptions options = every_light();
      options.ao.on = prepass;
      expect_reference_picture(lit_wall({}, material), view_of_wall(), options);
    }
  }
}

TEST_F(material_picture, lit_panes_mix_with_their_light_from_far_to_near) {
  BuiltScene built;
  for (const float alpha : {0.3f, 0.6f}) {
    Material pane = plain();
    pane.base_color = {alpha, 1.0f - alpha, 0.2f, alpha};
    pane.alpha_mode = AlphaMode::blend;
    pane.emissive = {0.0f, 0.0f, 1.5f * alpha};
    built.add(wall(), built.add_material(pane), translation({0.9f * alpha, -0.3f, 0.5f * alpha}));
  }
  RenderOptions options = every_light();
  expect_reference_picture(lit_wall(built, plain()), view_of_wall(), options);
  options.transparent_background = true;
  expect_reference_picture(built, view_of_wall(), options);
}

TEST_F(material_picture, both_sides_of_a_glass_ball_are_lit_from_where_they_are_seen) {
  BuiltScene built;
  Material glass = plain();
  glass.base_color.a = 0.4f;
  glass.alpha_mode = AlphaMode::blend;
  glass.double_sided = true;
  built.add(showcase::sphere({0, 0, 0.9f}, 0.4f, 16, 8), built.add_material(glass));
  expect_reference_picture(lit_wall(built, plain()), view_of_wall(), every_light());
}

TEST_F(material_picture, N22_normals_of_scaled_and_mirrored_meshes_are_lit_from_their_outside) {
  for (const float mirror : {1.0f, -1.0f}) {
    Affine m;
    m.row[0] = {0.5f * mirror, 0.2f, 0.0f, 0.0f};
    m.row[1] = {0.0f, 1.3f, 0.1f, 0.0f};
    m.row[2] = {0.1f, 0.0f, 0.7f, 0.3f};
    expect_reference_picture(lit_wall({}, plain(), showcase::sphere({0, 0, 0}, 0.4f, 16, 8), m, mirror < 0.0f),
                             view_of_wall(), every_light());
  }
}

TEST_F(material_picture, flat_normals_are_those_of_the_faces_as_deformed) {
  Primitive p = showcase::sphere({0, 0, 0.2f}, 0.45f, 8, 5);
  p.flat_normals = true;
  BuiltScene built = lit_wall({}, plain(), p);
  std::vector<glm::vec3> moved = p.positions;
  for (glm::vec3& v : moved) v.x *= 0.6f + v.y;
  built.deform(0, moved, p.normals);
  expect_reference_picture(built, view_of_wall(), every_light(), {.sharp = 0.5});
}

}  // namespace
}  // namespace sinew::viewer
