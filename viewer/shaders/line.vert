#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Lines over the picture; vertices are in view space already.
#include "frame_uniforms.glsl"

layout(location = 0) in vec3 view_position;
layout(location = 1) in vec4 rgba;

layout(location = 0) out vec4 line_color;

void main() {
  gl_Position = vec4(view_position.x * frame.projection.x, -view_position.y * frame.projection.y, frame.projection.z,
                     -view_position.z);
  line_color = rgba;
}
