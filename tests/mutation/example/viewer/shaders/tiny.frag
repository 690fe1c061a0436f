#version 460
// SPDX-License-Identifier: MIT
layout(location = 0) in vec3 color;
layout(location = 0) out vec4 result;
const float kGamma = 2.2;

float luminance(vec3 c) {
  if (c.x < 0.0) return 0.0;
  return dot(c, vec3(0.2, 0.7, 0.1)) - 1.0;
}

void main() { result = vec4(mix(color, vec3(luminance(color)), 0.5), 1.0); }
