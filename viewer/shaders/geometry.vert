#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Transforms meshes to view space. Prepass and shading passes share this module; `invariant` makes their depths equal.
#include "frame_uniforms.glsl"
#include "geometry.glsl"
#include "projection.glsl"
#include "quaternion_normal.glsl"

layout(constant_id = 16) const bool kShadowMap = false;      // `draw` has the matrix of a shadow map
layout(constant_id = 20) const bool kVertexVisibility = false;   // ambient visibility is a vertex attribute

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 texcoord_0;
layout(location = 4) in vec2 texcoord_1;
layout(location = 5) in vec4 color;
layout(location = 6) in float visibility;  // ambient visibility at the key poses before and after the frame's time
layout(location = 7) in float next_visibility;

layout(location = 0) out vec3 view_position;
layout(location = 1) out vec3 view_normal;   // with quaternions: the half-way vector
layout(location = 2) out vec4 view_tangent;
layout(location = 3) out vec4 texcoords;
layout(location = 4) out vec4 vertex_color;
layout(location = 5) out float vertex_visibility;

// Quaternion frames. q and -q are the same frame, but interpolation needs matching signs across a triangle. A vertex
// does not know the other corners, so it outputs both signs. One has the cosine of half the rotation about the normal
// positive, one with the sine. The first (provoking) vertex decides which of them all corners use: the one that is
// farther from its change of sign. Frames that differ by less than 90 degrees within a triangle are then interpolated
// the short way. Back sides have their own frames, for -n.
layout(location = 6) out vec4 frame_by_cosine;
layout(location = 7) out vec4 frame_by_sine;
layout(location = 8) out vec3 back_half_way;
layout(location = 9) out vec4 back_frame_by_cosine;
layout(location = 10) out vec4 back_frame_by_sine;
layout(location = 11) flat out vec2 sine_is_larger;   // for front and back: above 0 = use the frame by sine

invariant gl_Position;

// eq   n' = sign(det M) * cofactor(M) * n: no division; correct for mirrored and flattened meshes
vec3 transformed_normal(vec3 n) {
  vec3 a = draw.view_from_mesh[0].xyz, b = draw.view_from_mesh[1].xyz, c = draw.view_from_mesh[2].xyz;
  vec3 bc = cross(b, c);
  vec3 turned = vec3(dot(bc, n), dot(cross(c, a), n), dot(cross(a, b), n));
  turned = mix(turned, -turned, bvec3(dot(a, bc) < 0.0));
  float length_squared = dot(turned, turned);
  return length_squared > 0.0 ? turned * inversesqrt(length_squared) : n;
}

// out  by_cosine, by_sine  the frame with both signs, zero without a tangent;   returns sine_is_larger
float both_signs(vec3 h, vec3 along, out vec4 by_cosine, out vec4 by_sine) {
  vec2 spinor;
  by_cosine = frame_quaternion(h, along, spinor);
  by_sine = spinor.y < 0.0 ? -by_cosine : by_cosine;
  return abs(spinor.y) - spinor.x;
}

void main() {
  vec4 local = vec4(position, 1.0);
  vec3 view = vec3(dot(draw.view_from_mesh[0], local), dot(draw.view_from_mesh[1], local), dot(draw.view_from_mesh[2], local));
  vec4 direction = vec4(tangent.xyz, 0.0);
  view_position = view;
  view_normal = transformed_normal(normal);
  view_tangent = vec4(dot(draw.view_from_mesh[0], direction), dot(draw.view_from_mesh[1], direction),
                      dot(draw.view_from_mesh[2], direction), tangent.w);
  if (kQuaternions != 0) {
    vec3 n = view_normal;
    view_normal = half_way(n);
    sine_is_larger.x = both_signs(view_normal, view_tangent.xyz, frame_by_cosine, frame_by_sine);
    back_half_way = half_way(-n);
    sine_is_larger.y = both_signs(back_half_way, view_tangent.xyz, back_frame_by_cosine, back_frame_by_sine);
  }
  texcoords = vec4(texcoord_0, texcoord_1);
  vertex_color = color;
  vertex_visibility = kVertexVisibility ? mix(visibility, next_visibility, draw.visibility_factor) : 1.0;
  gl_Position = kShadowMap ? vec4(view, dot(draw.shadow_w, local)) : clip_from_view(view);
  gl_PointSize = draw.point_size;
}
