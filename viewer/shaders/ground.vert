#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The ground rectangle, two triangles without vertex buffers. Prepass and ground pass share this module; `invariant`
// makes their depths equal.
#include "frame_uniforms.glsl"
#include "projection.glsl"

layout(location = 0) out vec3 view_position;
layout(location = 1) out vec2 from_middle;   // metres along x and z of the world
layout(location = 2) flat out vec3 normal;

invariant gl_Position;

const vec2 kCorners[6] = vec2[](vec2(0.0, 0.0), vec2(0.0, 1.0), vec2(1.0, 1.0), vec2(1.0, 1.0), vec2(1.0, 0.0), vec2(0.0, 0.0));

void main() {
  from_middle = mix(frame.ground_reach.xy, frame.ground_reach.zw, kCorners[gl_VertexIndex]);
  view_position = frame.ground_middle + frame.ground_x * from_middle.x + frame.ground_z * from_middle.y;
  normal = cross(frame.ground_z, frame.ground_x);
  gl_Position = clip_from_view(view_position);
}
