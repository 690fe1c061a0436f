// SPDX-License-Identifier: MIT
// The fields of materials, textures, cameras and lights, and of the model block as a whole; see asset_fields.h.
#pragma once
#include "runtime/asset_file/asset_fields.h"

namespace sinew {

auto fields(Is<Sampler> auto& s) {
  auto& [magnify, minify, mipmap, use_mipmaps, wrap_u, wrap_v] = s;
  return std::tie(magnify, minify, mipmap, use_mipmaps, wrap_u, wrap_v);
}

auto fields(Is<Image> auto& i) {
  auto& [name, width, height, rgba, missing_reason, mime_type, encoded_size, encoded] = i;
  return std::tie(name, width, height, rgba, missing_reason, mime_type, encoded_size, encoded);
}

auto fields(Is<Texture> auto& t) {
  auto& [image, sampler] = t;
  return std::tie(image, sampler);
}

auto fields(Is<TextureUse> auto& u) {
  auto& [texture, texcoord, offset, rotation_rad, scale] = u;
  return std::tie(texture, texcoord, offset, rotation_rad, scale);
}

auto fields(Is<Specular> auto& s) {
  auto& [ior, factor, texture, color, color_texture, has_glossiness] = s;
  return std::tie(ior, factor, texture, color, color_texture, has_glossiness);
}

auto fields(Is<Clearcoat> auto& c) {
  auto& [factor, texture, roughness, roughness_texture, normal_texture, normal_scale] = c;
  return std::tie(factor, texture, roughness, roughness_texture, normal_texture, normal_scale);
}

auto fields(Is<Sheen> auto& s) {
  auto& [color, color_texture, roughness, roughness_texture] = s;
  return std::tie(color, color_texture, roughness, roughness_texture);
}

auto fields(Is<Transmission> auto& t) {
  auto& [factor, texture] = t;
  return std::tie(factor, texture);
}

auto fields(Is<Iridescence> auto& i) {
  auto& [factor, texture, ior, thinnest_nm, thickest_nm, thickness_texture] = i;
  return std::tie(factor, texture, ior, thinnest_nm, thickest_nm, thickness_texture);
}

auto fields(Is<Anisotropy> auto& a) {
  auto& [strength, rotation_rad, texture] = a;
  return std::tie(strength, rotation_rad, texture);
}

auto fields(Is<Volume> auto& v) {
  auto& [thickness_m, texture, attenuation_distance_m, attenuation_color] = v;
  return std::tie(thickness_m, texture, attenuation_distance_m, attenuation_color);
}

auto fields(Is<Material> auto& m) {
  auto& [name, base_color, base_color_texture, metallic, roughness, metallic_roughness_texture, normal_texture,
         normal_scale, occlusion_texture, occlusion_strength, emissive, emissive_strength, emissive_texture, alpha_mode,
         alpha_cutoff, double_sided, unlit, specular, clearcoat, sheen, transmission, iridescence, anisotropy, volume] =
      m;
  return std::tie(name, base_color, base_color_texture, metallic, roughness, metallic_roughness_texture, normal_texture,
                  normal_scale, occlusion_texture, occlusion_strength, emissive, emissive_strength, emissive_texture,
                  alpha_mode, alpha_cutoff, double_sided, unlit, specular, clearcoat, sheen, transmission, iridescence,
                  anisotropy, volume);
}

auto fields(Is<Camera> auto& c) {
  auto& [name, joint, perspective, fov_y_rad, aspect, half_width, half_height, near_m, far_m] = c;
  return std::tie(name, joint, perspective, fov_y_rad, aspect, half_width, half_height, near_m, far_m);
}

auto fields(Is<Light> auto& l) {
  auto& [name, kind, joint, color, intensity, range_m, inner_cone_rad, outer_cone_rad] = l;
  return std::tie(name, kind, joint, color, intensity, range_m, inner_cone_rad, outer_cone_rad);
}

/// The block AssetKind::model: a scene without its skeleton, its clips and their authoring form.
template <class S>
requires Is<S, Scene>
auto model_fields(S& scene) {
  auto& [skeleton, animations, clips, skins, meshes, instances, first_weight, correctives, properties, hidden_joints,
         materials, variants, textures, images, cameras, lights, scenes, default_scene] = scene;
  return std::tie(skins, meshes, instances, first_weight, correctives, properties, hidden_joints, materials, variants,
                  textures, images, cameras, lights, scenes, default_scene);
}

}  // namespace sinew
