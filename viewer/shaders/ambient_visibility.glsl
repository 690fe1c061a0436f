// SPDX-License-Identifier: MIT
// Ambient visibility of a full-size pixel (the fraction of ambient light that arrives), upsampled from the half-size
// image. It is the mean of the neighbouring texels, weighted by how likely they are on the same surface. If none is,
// the texel nearest in space is used.
#include "visibility_texel.glsl"

const float kLeastWeight = 1e-6;   // a smaller weight sum counts as "no texel on the same surface"

layout(constant_id = 2) const bool kOccluded = false;   // an ambient visibility image exists

// out  bend  argument for bent_normal(); 0 where nothing is occluded, and if there are no bent normals
float ambient_visibility(ivec2 pixel, vec3 p, vec3 n, out vec2 bend) {
  bend = vec2(0.0);
  if (!kOccluded || n == vec3(0.0)) return 1.0;
  ivec2 last = textureSize(ao_image, 0) - 1;
  float metres_per_pixel = 1.0 / pixels_per_metre(-p.z);
  float sum = 0.0, weight_sum = 0.0, nearest = 1.0, nearest_squared = 3.4e38;
  vec2 bend_sum = vec2(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 offset = ivec2(i & 1, i >> 1);
    if (any(greaterThan(offset, pixel % kAoStep))) continue;   // along this axis the pixel coincides with a texel
    ivec2 texel = min(pixel / kAoStep + offset, last);
    vec4 stored = texelFetch(ao_image, texel, 0);
    if (stored.g <= 0.0) continue;
    vec3 other = view_point(full_pixel(texel), stored.g);
    float squared = dot(other - p, other - p);
    if (squared < nearest_squared) {
      nearest_squared = squared;
      nearest = stored.r;
      bend = bend_of(stored);
    }
    float weight = same_surface(p, n, other, normal_of(stored), metres_per_pixel);
    sum += weight * stored.r;
    bend_sum += weight * bend_of(stored);
    weight_sum += weight;
  }
  if (weight_sum < kLeastWeight) return nearest;
  bend = bend_sum / weight_sum;
  return sum / weight_sum;
}

float ambient_visibility(ivec2 pixel, vec3 p, vec3 n) {
  vec2 bend;
  return ambient_visibility(pixel, p, n, bend);
}
