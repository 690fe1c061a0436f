#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Writes view-space normals and the ambient access of the vertices beside the depth, and does the alpha test of masked materials.
#include "frame_uniforms.glsl"
#include "material.glsl"
#include "surface_normal.glsl"

layout(constant_id = 0) const bool kMasked = false;

layout(location = 0) in vec3 view_position;
layout(location = 1) in vec3 view_normal;
layout(location = 3) in vec4 texcoords;
layout(location = 4) in vec4 vertex_color;
layout(location = 5) in float vertex_access;

layout(location = 0) out vec4 normal;

void main() {
  normal = vec4(surface_normal(view_normal, view_position), vertex_access);
  if (kMasked && is_cut(base_color_at(texcoords, vertex_color).a)) discard;
}
