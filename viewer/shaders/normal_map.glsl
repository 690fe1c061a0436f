// SPDX-License-Identifier: MIT
// Normal mapping. The including shader must declare the inputs view_position, view_tangent and texcoords.

layout(location = 6) centroid in vec4 frame_by_cosine;
layout(location = 7) centroid in vec4 frame_by_sine;
layout(location = 9) centroid in vec4 back_frame_by_cosine;
layout(location = 10) centroid in vec4 back_frame_by_sine;
layout(location = 11) flat in vec2 sine_is_larger;

// Projects `along` onto the plane perpendicular to n and normalises it. False if `along` is zero or nearly parallel to
// n.
bool perpendicular(vec3 n, vec3 along, out vec3 t) {
  t = along - n * dot(n, along);
  float square = dot(t, t);
  if (!(square > kLeastSine * kLeastSine * dot(along, along))) return false;
  t *= inversesqrt(square);
  return true;
}

// Sign of the bitangent. On back faces n is reversed, but the bitangent must not change.
float bitangent_side() { return view_tangent.w * (gl_FrontFacing ? draw.handedness : -draw.handedness); }

// Tangent frame from interpolated quaternions; false if the tangents are degenerate.
bool quaternion_frame(inout vec3 n, out vec3 t, out vec3 b) {
  vec4 q = sine_is_larger.x > 0.0 ? frame_by_sine : frame_by_cosine;
  if (back_side()) q = sine_is_larger.y > 0.0 ? back_frame_by_sine : back_frame_by_cosine;
  if (dot(q, q) < 1e-6) return false;
  mat3 frame_of_map = frame_of(q);
  n = frame_of_map[2];
  t = frame_of_map[0];
  b = frame_of_map[1] * bitangent_side();
  return true;
}

// Tangent and bitangent from the mesh's tangents; false if the tangent is degenerate.
bool stored_frame(vec3 n, out vec3 t, out vec3 b) {
  if (!perpendicular(n, view_tangent.xyz, t)) return false;
  b = cross(n, t) * bitangent_side();
  return true;
}

// Tangent and bitangent from screen-space derivatives, for a mesh without tangents. Follows the convention of stored
// tangents: the tangent lies along u, the bitangent is perpendicular to it, on the side where v decreases.
// eq   [dP/dx, dP/dy] = [dP/du, dP/dv] * [duv/dx, duv/dy]
bool derived_frame(vec3 n, int set, out vec3 t, out vec3 b) {
  vec3 dx = dFdx(view_position), dy = dFdy(view_position);
  vec2 uv = uv_of_set(set, texcoords), uv_x = dFdx(uv), uv_y = dFdy(uv);
  float side = sign(uv_x.x * uv_y.y - uv_y.x * uv_x.y);
  vec3 along_u = side * (dx * uv_y.y - dy * uv_x.y), along_v = side * (dy * uv_x.x - dx * uv_y.x);
  if (!perpendicular(n, along_u, t)) return false;
  b = cross(n, t);
  if (dot(b, along_v) > 0.0) b = -b;
  return true;
}

// Tangent and bitangent of a texture coordinate set, 1 or 2; false if they are degenerate.
// in   n  normal on the visible side; quaternions replace it
bool map_frame(inout vec3 n, int set, out vec3 t, out vec3 b) {
  if (kTangents && kQuaternions != 0) return quaternion_frame(n, t, b);
  if (kTangents) return stored_frame(n, t, b);
  return derived_frame(n, set, t, b);
}

// in   n  normal on the visible side;   texel  of the map;   set  texture coordinate set, 1 or 2
vec3 mapped_normal(vec3 n, vec3 texel, float scale, int set) {
  vec3 relief = texel * 2.0 - 1.0;
  vec3 t, b;
  if (!map_frame(n, set, t, b)) return n;
  if (!gl_FrontFacing) relief.xy = -relief.xy;   // n is already reversed; a bump on the front is a dent on the back
  return normalize(t * relief.x * scale + b * relief.y * scale + n * relief.z);
}

vec3 with_normal_map(vec3 n) {
  if (kNormalSet == 0) return n;
  vec3 texel = filtered_texel(normal_texture, 2, transformed_uv(2, kNormalSet, texcoords)).xyz;
  return mapped_normal(n, texel, material.normal_scale, kNormalSet);
}
