// SPDX-License-Identifier: MIT
// The normal on the side that faces the viewer, in view space; zero if the mesh has no normals (points and lines).
#include "projection.glsl"

vec3 surface_normal(vec3 interpolated, vec3 p) {
  if (kNormals == 1) {
    vec3 face = normalize(cross(dFdx(p), dFdy(p)));
    return dot(face, towards_viewer(p)) < 0.0 ? -face : face;
  }
  if (kNormals == 0 || dot(interpolated, interpolated) == 0.0) return vec3(0.0);
  vec3 n = normalize(interpolated);
  return gl_FrontFacing ? n : -n;
}
