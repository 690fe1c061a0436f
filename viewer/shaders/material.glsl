// SPDX-License-Identifier: MIT
// A glTF 2.0 metallic-roughness material; mirrors MaterialUniforms in viewer/upload/upload_materials.h.
#include "surface_features.glsl"
#include "texture_filter.glsl"

struct TextureTransform {
  vec4 row_u;   // u' = row_u.xy . uv + row_u.z
  vec4 row_v;   // v' = row_v.xy . uv + row_v.z
};

layout(set = 1, binding = 0, std140) uniform Material {
  vec4 base_color;
  vec3 emissive;
  float alpha_cutoff;
  float metallic;
  float roughness;
  float normal_scale;
  float occlusion_strength;
  vec3 dielectric_f0;               // from ior and specular colour; may exceed 1
  float specular;
  float clearcoat;
  float clearcoat_roughness;
  float clearcoat_normal_scale;
  float transmission;
  vec3 sheen_color;
  float sheen_roughness;
  float iridescence;
  float film_ior;
  float film_thinnest_m;
  float film_thickest_m;
  vec2 anisotropy_turn;             // cosine and sine
  float anisotropy;
  float thickness_m;                // in the space of the mesh
  vec3 absorption_per_m;
  float inverse_ior;
  TextureTransform transforms[17];  // of the five textures below in this order, then of the layer textures
} material;

layout(set = 1, binding = 1) uniform sampler2D base_color_texture;
layout(set = 1, binding = 2) uniform sampler2D metallic_roughness_texture;
layout(set = 1, binding = 3) uniform sampler2D normal_texture;
layout(set = 1, binding = 4) uniform sampler2D occlusion_texture;
layout(set = 1, binding = 5) uniform sampler2D emissive_texture;
layout(set = 1, binding = 6) uniform sampler2D other_texture;
layout(set = 1, binding = 7) uniform sampler2D last_texture;

// in   set  one of the constants k...Set;   texcoords  both sets, xy and zw
vec2 uv_of_set(int set, vec4 texcoords) {
  if (set == 2) return texcoords.zw;
  return texcoords.xy;
}

// in   index  into material.transforms
vec2 transformed_uv(int index, int set, vec4 texcoords) {
  TextureTransform t = material.transforms[index];
  vec2 uv = uv_of_set(set, texcoords);
  return vec2(dot(t.row_u.xy, uv) + t.row_u.z, dot(t.row_v.xy, uv) + t.row_v.z);
}

// Reads a layer texture. Its image is bound to one of the places above: an unused one, or one with the same image.
// in   use    one of the constants k...Texture;   index  into material.transforms
vec4 layer_texel(int use, int index, vec4 texcoords) {
  vec2 uv = transformed_uv(index, 1 + (use - 1) % 2, texcoords);
  int place = (use - 1) / 2;
  if (place == 0) return filtered_texel(base_color_texture, 0, uv);
  if (place == 1) return filtered_texel(metallic_roughness_texture, 1, uv);
  if (place == 2) return filtered_texel(normal_texture, 2, uv);
  if (place == 3) return filtered_texel(occlusion_texture, 3, uv);
  if (place == 4) return filtered_texel(emissive_texture, 4, uv);
  if (place == 5) return filtered_texel(other_texture, 5, uv);
  return filtered_texel(last_texture, 6, uv);
}

vec4 base_color_at(vec4 texcoords, vec4 vertex_color) {
  vec4 color = material.base_color * vertex_color;
  if (kBaseColorSet != 0)
    color *= filtered_texel(base_color_texture, 0, transformed_uv(0, kBaseColorSet, texcoords));
  return color;
}

// The alpha test. The margin allows for interpolated values slightly below the exact one; it is far below a step of an
// 8-bit texture.
bool is_cut(float alpha) { return alpha < material.alpha_cutoff - 1e-6; }
