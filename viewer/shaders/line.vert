#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Lines over the picture. The vertices are in view space.
#include "frame_uniforms.glsl"
#include "projection.glsl"

layout(location = 0) in vec3 view_position;
layout(location = 1) in vec4 rgba;

layout(location = 0) out vec4 line_color;

void main() {
  gl_Position = clip_from_view(view_position);
  line_color = rgba;
}
