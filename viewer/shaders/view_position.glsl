// SPDX-License-Identifier: MIT
// Conversions from pixels to view space.
#include "projection.glsl"

float distance_at(ivec2 pixel) {
  float depth = texelFetch(depth_image, pixel, 0).r;
  return depth > 0.0 ? distance_of(depth) : 0.0;   // 0 = nothing drawn
}

vec3 view_point(ivec2 pixel, float distance) {
  vec2 ndc = (vec2(pixel) + 0.5) / vec2(textureSize(depth_image, 0)) * 2.0 - 1.0;
  vec2 xy = vec2(ndc.x, -ndc.y) / frame.projection.xy;
  if (kParallel) return vec3(xy, -distance);
  return vec3(xy * distance, -distance);
}

layout(constant_id = 3) const int kAoStep = 2;   // OcclusionShape::step: pixels per texel of ao_image

// The pixel for which a texel of ao_image is computed.
ivec2 full_pixel(ivec2 texel) {
  return min(texel * kAoStep, textureSize(depth_image, 0) - 1);
}
