#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Covers the picture with cells. A blurred backdrop is computed at their corners: it changes so slowly that values in
// between are within a step of 8 bits.
#include "frame_uniforms.glsl"
#include "encode.glsl"
#include "projection.glsl"
#include "tone_curve.glsl"
#include "environment_behind.glsl"

layout(constant_id = 1) const bool kAtCorners = false;
layout(constant_id = 10) const int kColumns = 1;
layout(constant_id = 11) const int kRows = 1;

layout(location = 0) out vec2 ndc;
layout(location = 1) out vec3 shown_here;

const vec2 kCorners[6] = vec2[](vec2(0.0, 0.0), vec2(0.0, 1.0), vec2(1.0, 1.0), vec2(1.0, 1.0), vec2(1.0, 0.0), vec2(0.0, 0.0));

void main() {
  int cell = gl_VertexIndex / 6;
  vec2 cells = kAtCorners ? vec2(kColumns, kRows) : vec2(1.0);
  vec2 first = vec2(float(cell % int(cells.x)), float(cell / int(cells.x)));
  ndc = (first + kCorners[gl_VertexIndex % 6]) / cells * 2.0 - 1.0;
  shown_here = kAtCorners ? displayed(tone_mapped(environment_behind(ndc) * frame.exposure)) : vec3(0.0);
  gl_Position = vec4(ndc, 0.0, 1.0);
}
