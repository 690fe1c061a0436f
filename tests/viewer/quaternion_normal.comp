#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Runs the arithmetic of viewer/shaders/quaternion_normal.glsl over one case, for quaternion_shader_test.cpp.
#include "quaternion_normal.glsl"

layout(local_size_x = 1) in;

layout(set = 0, binding = 0, std430) readonly buffer Case {
  vec4 n0;      // w: the interpolation factor
  vec4 n1;
  vec4 along0;  // towards the tangents
  vec4 along1;
} given;

layout(set = 0, binding = 1, std430) writeonly buffer Answer {
  vec4 h0;
  vec4 h1;
  vec4 n;
  vec4 q0;
  vec4 frame[3];   // images of x, y and z between the frames
} answer;

void main() {
  vec3 h0 = half_way(given.n0.xyz), h1 = half_way(given.n1.xyz);
  float t = given.n0.w;
  vec2 spinor;
  vec4 q0 = frame_quaternion(h0, given.along0.xyz, spinor), q1 = frame_quaternion(h1, given.along1.xyz, spinor);
  answer.h0 = vec4(h0, 0.0);
  answer.h1 = vec4(h1, 0.0);
  answer.n = vec4(normal_of(h0 * (1.0 - t) + h1 * t), 0.0);
  answer.q0 = q0;
  mat3 between = frame_of(q0 * (1.0 - t) + q1 * t);
  for (int i = 0; i < 3; ++i) answer.frame[i] = vec4(between[i], 0.0);
}
