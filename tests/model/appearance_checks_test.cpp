// SPDX-License-Identifier: MIT
// Makes each number of a material, camera or light NaN or infinite, one at a time.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "runtime/model/scene.h"

namespace sinew {
namespace {

using Numbers = std::vector<float*>;

/// Expects that check(Scene) finds a bad value in each number.
/// in   numbers_of  gives the numbers of the scene's only asset
template <class NumbersOf>
void expect_each_is_checked(Scene scene, const NumbersOf& numbers_of) {
  finish_scene(scene);
  ASSERT_EQ(check(scene), ErrorCode::ok);
  std::size_t index = 0;
  for (float* number : numbers_of(scene)) {
    for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
      const float right = *number;
      *number = wrong;
      EXPECT_EQ(check(scene), ErrorCode::not_finite) << "number " << index;
      *number = right;
    }
    ++index;
  }
  EXPECT_EQ(check(scene), ErrorCode::ok);
}

TEST(asset_checks, each_number_of_a_material_has_to_be_finite) {
  Scene scene;
  scene.materials.emplace_back();
  const auto factors = [](Scene& s) {
    Material& m = s.materials[0];
    return Numbers{&m.base_color.x, &m.base_color.y, &m.base_color.z,    &m.base_color.w,   &m.metallic,
                   &m.roughness,    &m.normal_scale, &m.emissive.x,      &m.emissive.y,     &m.emissive.z,
                   &m.alpha_cutoff, &m.specular.ior, &m.specular.factor, &m.sheen.roughness};
  };
  expect_each_is_checked(scene, factors);
  const auto others = [](Scene& s) {
    Material& m = s.materials[0];
    return Numbers{&m.occlusion_strength, &m.emissive_strength, &m.specular.color.x,    &m.specular.color.y,
                   &m.specular.color.z,   &m.clearcoat.factor,  &m.clearcoat.roughness, &m.clearcoat.normal_scale,
                   &m.sheen.color.x,      &m.sheen.color.y,     &m.sheen.color.z,       &m.transmission.factor};
  };
  expect_each_is_checked(scene, others);
  expect_each_is_checked(scene, [](Scene& s) {
    Iridescence& i = s.materials[0].iridescence;
    Anisotropy& a = s.materials[0].anisotropy;
    Volume& v = s.materials[0].volume;
    return Numbers{&i.factor,
                   &i.ior,
                   &i.thinnest_nm,
                   &i.thickest_nm,
                   &a.strength,
                   &a.rotation_rad,
                   &v.thickness_m,
                   &v.attenuation_distance_m,
                   &v.attenuation_color.x,
                   &v.attenuation_color.y,
                   &v.attenuation_color.z};
  });
}

TEST(asset_checks, each_number_of_a_place_of_a_texture_has_to_be_finite) {
  Scene scene;
  scene.materials.emplace_back();
  const auto places = [](Scene& s) {
    TextureUse& use = s.materials[0].emissive_texture;
    return Numbers{&use.offset.x, &use.offset.y, &use.rotation_rad, &use.scale.x, &use.scale.y};
  };
  expect_each_is_checked(scene, places);
}

TEST(asset_checks, each_number_of_a_camera_and_of_a_light_has_to_be_finite) {
  Scene scene;
  scene.cameras.emplace_back();
  scene.lights.emplace_back();
  expect_each_is_checked(scene, [](Scene& s) {
    Camera& c = s.cameras[0];
    return Numbers{&c.fov_y_rad, &c.aspect, &c.half_width, &c.half_height, &c.near_m, &c.far_m};
  });
  expect_each_is_checked(scene, [](Scene& s) {
    Light& l = s.lights[0];
    return Numbers{&l.color.x, &l.color.y, &l.color.z, &l.intensity, &l.range_m, &l.inner_cone_rad, &l.outer_cone_rad};
  });
}

}  // namespace
}  // namespace sinew
