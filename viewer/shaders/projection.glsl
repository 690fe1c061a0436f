// SPDX-License-Identifier: MIT
#ifndef SINEW_PROJECTION
#define SINEW_PROJECTION
// Between view space and clip space, for both kinds of projection. Depth is reversed; y points down in the frame buffer.

bool is_parallel() { return frame.lens.z == 1.0; }

vec4 clip_from_view(vec3 p) {
  return vec4(p.x * frame.projection.x, -p.y * frame.projection.y, frame.projection.z + frame.projection.w * p.z, is_parallel() ? 1.0 : -p.z);
}

// Distance along the line of sight of a stored depth above 0.
float distance_of(float depth) {
  return is_parallel() ? (frame.projection.z - depth) / frame.projection.w : frame.projection.z / (depth + frame.projection.w);
}

// Pixels that one metre covers at this distance.
float pixels_per_metre(float distance) { return is_parallel() ? frame.lens.y : frame.lens.y / distance; }

// Unit vector from a surface point to the viewer.
vec3 towards_viewer(vec3 p) { return is_parallel() ? vec3(0.0, 0.0, 1.0) : normalize(-p); }
#endif
