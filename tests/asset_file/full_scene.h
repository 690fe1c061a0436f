// SPDX-License-Identifier: MIT
#pragma once
#include "tests/scenes/random_scene.h"

namespace sinew::test {

/// A small scene with at least one thing of every kind that an asset file stores.
inline Scene full_scene(std::uint64_t seed) {
  Scene scene = random_scene(seed, {.joints = 9, .triangles = 6, .centers = true, .correctives = 1});
  scene.materials.resize(2);
  scene.materials[0] = {.name = "cloth", .metallic = 0.25f, .alpha_mode = AlphaMode::blend, .unlit = true};
  scene.materials[0].base_color_texture = {0, 1, {0.5f, 0.25f}, 1.5f, {2.0f, 3.0f}};
  scene.materials[1].emissive_texture.texture = 1;
  scene.materials[1].specular = {1.25f, 0.5f, {0, 1}, {2.0f, 0.5f, 1.0f}, {1, 0}, true};
  scene.materials[1].clearcoat = {0.75f, {0, 0}, 0.25f, {1, 1}, {0, 1, {0.5f, 0.0f}}, -2.0f};
  scene.materials[1].sheen = {{0.5f, 0.25f, 1.0f}, {1, 1}, 0.625f, {0, 0}};
  scene.materials[1].transmission = {0.375f, {1, 0}};
  scene.materials[1].iridescence = {0.5f, {1, 0}, 1.75f, 50.0f, 300.0f, {0, 1}};
  scene.materials[1].anisotropy = {0.25f, 1.5f, {1, 1}};
  scene.materials[1].volume = {0.125f, {0, 0}, 2.0f, {0.5f, 1.0f, 0.25f}};
  scene.textures = {{0, {.minify = Filter::nearest, .use_mipmaps = false, .wrap_v = Wrap::mirrored_repeat}}, {1, {}}};
  scene.images.resize(2);
  scene.images[0] = {"pixels", 2, 1, {1, 2, 3, 4, 5, 6, 7, 8}, "", "image/png", 77, {std::byte{9}, std::byte{8}}};
  scene.images[1].missing_reason = "not found";
  const SharedName shared("lamp");
  scene.cameras = {{.name = "eye", .joint = 2, .perspective = false, .far_m = 9.0f}};
  scene.lights = {{shared, Light::Kind::spot, 1, {0.1f, 0.2f, 0.3f}, 4.0f},
                  {.name = SharedName(), .joint = kNone},
                  {shared, Light::Kind::point, 3, {1.0f, 0.0f, 0.0f}, 2.0f}};
  scene.scenes = {{"main", {0}}, {"", {}}};
  scene.default_scene = 0;
  scene.variants = {"red", "blue"};
  scene.hidden_joints = {3};
  Primitive& primitive = scene.meshes[0].primitives[0];
  primitive.material = 1;
  primitive.variant_materials = {{0, 0}, {1, 1}};
  primitive.texcoords = {std::vector<glm::vec2>(primitive.vertex_count(), {0.5f, 0.75f}), {}};
  for (std::uint32_t v = 0; v < primitive.vertex_count(); ++v) primitive.source_vertex.push_back(v / 2);
  scene.instances[0].copies = {};
  const WeightTrack light{Interpolation::linear, {0.0f, 1.0f}, {1.0f, 0.5f}, 1};
  const WeightTrack shown{Interpolation::step, {0.0f, 0.5f}, {1.0f, 0.0f}, 1};
  scene.animations[0].properties = {{{PropertyKind::light_intensity, 0}, light}};
  scene.animations[1].properties = {{{PropertyKind::node_visible, 4}, shown},
                                    {{PropertyKind::metallic, 1}, {Interpolation::step, {0.0f}, {0.125f}, 1}}};
  finish_scene(scene);
  return scene;
}

}  // namespace sinew::test
