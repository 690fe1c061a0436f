// SPDX-License-Identifier: MIT
// Random combinations of materials, layers, textures, sides, lights, cameras and options, compared with the reference
// renderer. Other tests check each term alone; this one checks that they do not affect each other.
#include <glm/geometric.hpp>

#include "samples/showcase/shapes.h"
#include "tests/support/fixed_random.h"
#include "tests/viewer/reference_picture.h"
#include "viewer/upload/upload_materials.h"

namespace sinew::viewer {
namespace {

using test::FixedRandom;

class any_picture : public DeviceTest {};

bool chance(FixedRandom& random, double share) { return random.in(0.0, 1.0) < share; }
float between(FixedRandom& random, float low, float high) { return static_cast<float>(random.in(low, high)); }
template <class T>
T one_of(FixedRandom& random, std::initializer_list<T> values) {
  const auto i = static_cast<std::size_t>(random.in(0.0, static_cast<double>(values.size())));
  return values.begin()[std::min(i, values.size() - 1)];
}

void add_layers(FixedRandom& random, Material& material) {
  if (chance(random, 0.4))
    material.specular = {
        .ior = between(random, 1.1f, 2.2f), .factor = between(random, 0.3f, 1.0f), .color = random.vec3(0.3, 1.0)};
  if (chance(random, 0.4))
    material.clearcoat = {.factor = between(random, 0.4f, 1.0f), .roughness = between(random, 0.3f, 0.8f)};
  if (chance(random, 0.4)) material.sheen = {.color = random.vec3(0.2, 0.9), .roughness = between(random, 0.3f, 1.0f)};
  if (chance(random, 0.25)) {
    material.transmission.factor = between(random, 0.4f, 1.0f);
    if (chance(random, 0.5)) material.roughness = 0.0f;  // clear
  }
}

/// Adds textures to random slots of a material, each with its own coordinates.
void add_textures(FixedRandom& random, BuiltScene& built, Material& material) {
  const std::uint32_t noise = add_noise_texture(built), leaning = add_plain_texture(built, {176, 100, 225, 255});
  const auto places = placed_textures();
  for (TextureUse* use : texture_uses(material)) {
    if (!chance(random, 0.35)) continue;
    // Mesa 22.3 chooses one mip level of the picture behind for each 2 x 2 pixels, which is visible if roughness varies
    // within them.
    if (use == &material.metallic_roughness_texture && material.transmission.factor > 0.0f) continue;
    *use = one_of(random, {places[0], places[1], places[2], places[3]});
    use->texture = use == &material.normal_texture || use == &material.clearcoat.normal_texture ? leaning : noise;
    if (!shows_all_textures(material)) *use = {};
  }
}

Material any_material(FixedRandom& random) {
  Material material = matte(random.vec3(0.1, 0.9));
  material.metallic = one_of(random, {0.0f, 0.0f, 0.4f, 1.0f});
  material.roughness = between(random, 0.35f, 1.0f);
  material.base_color.a = between(random, 0.3f, 0.9f);
  material.alpha_mode = one_of(random, {AlphaMode::opaque, AlphaMode::opaque, AlphaMode::mask, AlphaMode::blend});
  material.alpha_cutoff = between(random, 0.1f, 0.5f);
  material.double_sided = chance(random, 0.5);
  material.unlit = chance(random, 0.1);
  material.normal_scale = between(random, 0.3f, 1.2f);
  material.occlusion_strength = between(random, 0.2f, 1.0f);
  if (chance(random, 0.3)) material.emissive = random.vec3(0.0, 0.4);
  add_layers(random, material);
  return material;
}

/// A random transform: slightly rotated and scaled, sometimes mirrored.
Affine any_place(FixedRandom& random, const glm::vec3& at, bool& mirrored) {
  Affine place = affine_from(glm::mat3_cast(random.rotation_by(random.in(0.0, 0.5))), at);
  mirrored = chance(random, 0.3);
  for (int r = 0; r < 3; ++r) {
    place.row[static_cast<std::size_t>(r)].x *= mirrored ? -1.0f : 1.0f;
    place.row[static_cast<std::size_t>(r)].y *= 0.8f;
  }
  return place;
}

/// A pane before a ball before a wall, in the light of one to three lamps. None of them intersect.
BuiltScene any_scene(FixedRandom& random) {
  BuiltScene built;
  Material pane = any_material(random), ball = any_material(random), behind = plain();
  add_textures(random, built, pane);
  add_textures(random, built, behind);
  bool mirrored = false;
  Primitive p = wall();
  for (glm::vec3& position : p.positions) position *= 0.5f;
  if (chance(random, 0.4)) p.tangents.clear();
  if (chance(random, 0.3))
    for (int i = 0; i < 4; ++i) p.colors.emplace_back(random.vec3(0.4, 1.0), between(random, 0.7f, 1.0f));
  const Affine place = any_place(random, {0.4f, 0.2f, 1.3f}, mirrored);
  built.add(p, built.add_material(pane), place, mirrored);
  built.add(showcase::sphere({-0.3f, -0.1f, 0.4f}, 0.35f, 16, 8), built.add_material(ball));
  built.add(wall(), built.add_material(behind), translation({0.0f, 0.0f, -0.3f}));
  for (int lamps = one_of(random, {1, 2, 3}); lamps > 0; --lamps) {
    const Light light{.kind = one_of(random, {Light::Kind::directional, Light::Kind::point, Light::Kind::spot}),
                      .color = random.vec3(0.3, 1.0),
                      .intensity = between(random, 0.5f, 1.5f),
                      .range_m = chance(random, 0.3) ? 4.0f : 0.0f,
                      .inner_cone_rad = 0.2f,
                      .outer_cone_rad = 0.9f};
    const glm::vec3 at = random.vec3(-1.0, 1.0) + glm::vec3(0.0f, 0.0f, 2.2f);
    add_light_at(built, light, at, -at);
  }
  return built;
}

View any_view(FixedRandom& random) {
  View view = look_at({random.in(-0.8, 0.8), random.in(-0.6, 0.8), 2.8}, {0.1, 0.0, 0.2}, 0.75, 0.05);
  if (chance(random, 0.3)) {
    view.half_height_m = 1.0;
    view.far_m = 7.0;
  } else if (chance(random, 0.3)) {
    view.far_m = 8.0;
  }
  return view;
}

RenderOptions any_options(FixedRandom& random, const Gradient& light) {
  RenderOptions options = every_light();
  options.lighting.environment = chance(random, 0.8) ? gradient_environment(light) : nullptr;
  options.lighting.environment_intensity = between(random, 0.4f, 1.2f);
  options.lighting.environment_turn_rad = between(random, -3.0f, 3.0f);  // of no effect on a gradient
  options.lighting.exposure = between(random, 0.5f, 1.8f);
  options.lighting.tone_curve = one_of(random, {ToneCurve::neutral, ToneCurve::aces, ToneCurve::none});
  options.transparency = chance(random, 0.3) ? Transparency::weighted : Transparency::sorted;
  options.shading = chance(random, 0.12) ? Shading::gooch : Shading::physical;
  options.backdrop = chance(random, 0.4) ? Backdrop::sharp : Backdrop::plain;
  options.transparent_background = chance(random, 0.25);
  options.background = random.vec3(0.0, 1.0);
  return options;
}

TEST_F(any_picture, has_the_colours_of_the_reference_renderer) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    FixedRandom random(seed);
    const Gradient light{.sky = random.vec3(0.2, 0.9), .ground = random.vec3(0.1, 0.5)};
    const BuiltScene built = any_scene(random);
    const View view = any_view(random);
    const RenderOptions options = any_options(random, light);
    SCOPED_TRACE(seed);
    expect_reference_picture(built, view, options, {.width = 20, .height = 16, .bound = 0.008, .sharp = 0.3}, {},
                             light);
  }
}

}  // namespace
}  // namespace sinew::viewer
