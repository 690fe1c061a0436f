// SPDX-License-Identifier: MIT
#include "runtime/model/scene_look.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

/// A scene with one camera, one light and one material.
Scene one_of_each() {
  Scene scene;
  scene.cameras.resize(1);
  scene.lights.resize(1);
  scene.materials.resize(1);
  return scene;
}

/// True if the components of a property are the members of the look that begin at `first`.
bool is_at(SceneLook& look, PropertyKind kind, const float& first, TextureSlot slot = TextureSlot::base_color) {
  const std::span<float> found = components_of(look, {kind, 0, slot});
  return found.data() == &first && found.size() == component_count(kind);
}

TEST(scene_look, every_property_is_a_member_of_its_own) {
  SceneLook look(one_of_each());
  const Camera& camera = look.cameras[0];
  EXPECT_TRUE(is_at(look, PropertyKind::camera_fov_y, camera.fov_y_rad));
  EXPECT_TRUE(is_at(look, PropertyKind::camera_aspect, camera.aspect));
  EXPECT_TRUE(is_at(look, PropertyKind::camera_half_width, camera.half_width));
  EXPECT_TRUE(is_at(look, PropertyKind::camera_half_height, camera.half_height));
  EXPECT_TRUE(is_at(look, PropertyKind::camera_near, camera.near_m));
  EXPECT_TRUE(is_at(look, PropertyKind::camera_far, camera.far_m));
  const Light& light = look.lights[0];
  EXPECT_TRUE(is_at(look, PropertyKind::light_color, light.color.x));
  EXPECT_TRUE(is_at(look, PropertyKind::light_intensity, light.intensity));
  EXPECT_TRUE(is_at(look, PropertyKind::light_range, light.range_m));
  EXPECT_TRUE(is_at(look, PropertyKind::light_inner_cone, light.inner_cone_rad));
  EXPECT_TRUE(is_at(look, PropertyKind::light_outer_cone, light.outer_cone_rad));
  const Material& material = look.materials[0];
  EXPECT_TRUE(is_at(look, PropertyKind::base_color, material.base_color.x));
  EXPECT_TRUE(is_at(look, PropertyKind::metallic, material.metallic));
  EXPECT_TRUE(is_at(look, PropertyKind::roughness, material.roughness));
  EXPECT_TRUE(is_at(look, PropertyKind::normal_scale, material.normal_scale));
  EXPECT_TRUE(is_at(look, PropertyKind::occlusion_strength, material.occlusion_strength));
  EXPECT_TRUE(is_at(look, PropertyKind::emissive, material.emissive.x));
  EXPECT_TRUE(is_at(look, PropertyKind::emissive_strength, material.emissive_strength));
  EXPECT_TRUE(is_at(look, PropertyKind::alpha_cutoff, material.alpha_cutoff));
}

TEST(scene_look, transforms_of_every_texture_are_those_of_its_slot) {
  SceneLook look(one_of_each());
  const Material& material = look.materials[0];
  const std::pair<TextureSlot, const TextureUse*> slots[] = {
      {TextureSlot::base_color, &material.base_color_texture},
      {TextureSlot::metallic_roughness, &material.metallic_roughness_texture},
      {TextureSlot::normal, &material.normal_texture},
      {TextureSlot::occlusion, &material.occlusion_texture},
      {TextureSlot::emissive, &material.emissive_texture}};
  for (const auto& [slot, texture] : slots) {
    EXPECT_TRUE(is_at(look, PropertyKind::texture_offset, texture->offset.x, slot));
    EXPECT_TRUE(is_at(look, PropertyKind::texture_rotation, texture->rotation_rad, slot));
    EXPECT_TRUE(is_at(look, PropertyKind::texture_scale, texture->scale.x, slot));
  }
}

TEST(scene_look, whether_a_joint_is_shown_is_no_part_of_the_look) {
  SceneLook look(one_of_each());
  EXPECT_TRUE(components_of(look, {PropertyKind::node_visible, 0}).empty());
}

}  // namespace
}  // namespace sinew
