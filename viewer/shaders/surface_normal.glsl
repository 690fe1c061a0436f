// SPDX-License-Identifier: MIT
// The view-space normal on the side facing the viewer; zero if the mesh has no normals (points and lines).
#include "projection.glsl"
#include "quaternion_normal.glsl"

layout(location = 8) centroid in vec3 back_half_way;

bool back_side() { return kQuaternions == 2 && !gl_FrontFacing; }

// in   interpolated  output of geometry.vert: with quaternions a half-way vector
vec3 surface_normal(vec3 interpolated, vec3 p) {
  if (kNormals == 1) {
    vec3 face = normalize(cross(dFdx(p), dFdy(p)));
    return dot(face, towards_viewer(p)) < 0.0 ? -face : face;
  }
  if (kNormals == 0 || dot(interpolated, interpolated) == 0.0) return vec3(0.0);
  if (kQuaternions != 0) return normal_of(back_side() ? back_half_way : interpolated);
  vec3 n = normalize(interpolated);
  return gl_FrontFacing ? n : -n;
}
