#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Prepass: writes view-space normals (normal maps included) and, in alpha, per-vertex ambient visibility. Does the
// alpha test of masked materials. With kShowLevel, writes the sampled texture level instead, for display.
layout(location = 0) in vec3 view_position;
layout(location = 1) in vec3 view_normal;
layout(location = 2) in vec4 view_tangent;
layout(location = 3) in vec4 texcoords;
layout(location = 4) in vec4 vertex_color;
layout(location = 5) in float vertex_visibility;

#include "frame_uniforms.glsl"
#include "geometry.glsl"
#include "material.glsl"
#include "surface_normal.glsl"
#include "normal_map.glsl"

layout(constant_id = 0) const bool kMasked = false;
layout(constant_id = 37) const bool kShowLevel = false;

const float kColorOfLevel = 0.1;   // per level: red along u, green along v; blue = no texture

layout(location = 0) out vec4 normal;

vec3 color_of_level() {
  if (kBaseColorSet == 0) return vec3(0.0, 0.0, 0.5);
  return vec3(kColorOfLevel * read_level(base_color_texture, transformed_uv(0, kBaseColorSet, texcoords)), 0.0);
}

void main() {
  if (kShowLevel) {
    normal = vec4(color_of_level(), 1.0);
  } else {
    vec3 n = surface_normal(view_normal, view_position), mapped = with_normal_map(n);
    normal = vec4(n == vec3(0.0) ? n : mapped, vertex_visibility);
  }
  if (kMasked && is_cut(base_color_at(texcoords, vertex_color).a)) discard;
}
