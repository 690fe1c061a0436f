// SPDX-License-Identifier: MIT
#ifndef SINEW_PROJECTION
#define SINEW_PROJECTION
// Conversions between view space and clip space, for perspective and orthographic projection. Depth is reversed; y
// points down in the framebuffer.

layout(constant_id = 4) const bool kParallel = false;

vec4 clip_from_view(vec3 p) {
  return vec4(p.x * frame.projection.x, -p.y * frame.projection.y, frame.projection.z + frame.projection.w * p.z, kParallel ? 1.0 : -p.z);
}

// Converts a stored depth above 0 to the distance from the eye plane.
float distance_of(float depth) {
  return kParallel ? (frame.projection.z - depth) / frame.projection.w : frame.projection.z / (depth + frame.projection.w);
}

// Pixels that one metre covers at this distance.
float pixels_per_metre(float distance) { return kParallel ? frame.pixels_per_metre : frame.pixels_per_metre / distance; }

// Unit vector from a surface point to the viewer.
vec3 towards_viewer(vec3 p) {
  if (kParallel) return vec3(0.0, 0.0, 1.0);
  return normalize(-p);
}
#endif
