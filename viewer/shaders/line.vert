#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Overlay lines drawn as rectangles, because few devices support smooth lines. One instance per line; positions in view
// space.
#include "frame_uniforms.glsl"
#include "projection.glsl"
#include "line.glsl"

layout(location = 0) in vec3 from;
layout(location = 1) in vec4 rgba;
layout(location = 2) in vec3 to;

layout(location = 0) flat out vec4 line_color;
layout(location = 1) noperspective out float across;   // pixels from the middle of the line

const int kCorners[6] = int[](0, 1, 2, 2, 1, 3);   // corners of two triangles; odd = right side, 2 and 3 = end point

// Clips point p of a line to the near plane.
vec3 in_front(vec3 p, vec3 other) {
  float behind = p.z + frame.near_m;
  return behind <= 0.0 ? p : mix(p, other, behind / (p.z - other.z));
}

void main() {
  line_color = rgba;
  int corner = kCorners[gl_VertexIndex];
  if (min(from.z, to.z) >= -frame.near_m) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);   // the whole line is behind the near plane
    return;
  }
  vec4 a = clip_from_view(in_front(from, to)), b = clip_from_view(in_front(to, from));
  vec2 pixels = frame.pixels_per_metre / frame.projection.xy;   // half the picture's size
  vec2 along = (b.xy / b.w - a.xy / a.w) * pixels;
  vec2 right = vec2(-along.y, along.x) / max(length(along), 1e-6);
  across = kLineReach * ((corner & 1) == 0 ? -1.0 : 1.0);
  gl_Position = corner < 2 ? a : b;
  gl_Position.xy += across * right / pixels * gl_Position.w;
}
