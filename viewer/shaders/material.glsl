// SPDX-License-Identifier: MIT
// A glTF 2.0 metallic-roughness material; mirrors MaterialUniforms in viewer/upload/upload_materials.h.

struct TextureUse {
  vec4 row_u;   // u' = row_u.xy . uv + row_u.z; w: 0 = no texture, 1 = texcoord 0, 2 = texcoord 1
  vec4 row_v;   // v' = row_v.xy . uv + row_v.z
};

layout(set = 1, binding = 0, std140) uniform Material {
  vec4 base_color;
  vec4 emissive;              // w: alpha cutoff
  vec4 surface;               // metallic, roughness, normal scale, occlusion strength
  vec4 kind;                  // x: 1 = unlit
  TextureUse uses[5];
} material;

layout(set = 1, binding = 1) uniform sampler2D base_color_texture;
layout(set = 1, binding = 2) uniform sampler2D metallic_roughness_texture;
layout(set = 1, binding = 3) uniform sampler2D normal_texture;
layout(set = 1, binding = 4) uniform sampler2D occlusion_texture;
layout(set = 1, binding = 5) uniform sampler2D emissive_texture;

bool has_texture(int use) { return material.uses[use].row_u.w > 0.0; }

vec2 set_of(int use, vec4 texcoords) { return material.uses[use].row_u.w > 1.5 ? texcoords.zw : texcoords.xy; }

vec2 texcoord_of(int use, vec4 texcoords) {
  TextureUse t = material.uses[use];
  vec2 uv = set_of(use, texcoords);
  return vec2(dot(t.row_u.xy, uv) + t.row_u.z, dot(t.row_v.xy, uv) + t.row_v.z);
}

vec4 base_color_at(vec4 texcoords, vec4 vertex_color) {
  vec4 color = material.base_color * vertex_color;
  if (has_texture(0)) color *= texture(base_color_texture, texcoord_of(0, texcoords));
  return color;
}
