// SPDX-License-Identifier: MIT
// The side that faces the viewer, in view space; zero where the mesh has no normals (points and lines).
#include "projection.glsl"

vec3 surface_normal(vec3 interpolated, vec3 p) {
  if ((draw.flags & kFlatNormals) != 0u) {
    vec3 face = normalize(cross(dFdx(p), dFdy(p)));
    return dot(face, towards_viewer(p)) < 0.0 ? -face : face;
  }
  if ((draw.flags & kHasNormals) == 0u || dot(interpolated, interpolated) == 0.0) return vec3(0.0);
  vec3 n = normalize(interpolated);
  return gl_FrontFacing ? n : -n;
}
