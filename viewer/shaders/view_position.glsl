// SPDX-License-Identifier: MIT
// From pixels to view space. Depth is reversed with the far plane at infinity: distance = near / depth (N30).

float distance_at(ivec2 pixel) {
  float depth = texelFetch(depth_image, pixel, 0).r;
  return depth > 0.0 ? frame.projection.z / depth : 0.0;   // 0 = nothing drawn there
}

vec3 view_ray(ivec2 pixel) {   // to distance 1
  vec2 ndc = (vec2(pixel) + 0.5) / vec2(textureSize(depth_image, 0)) * 2.0 - 1.0;
  return vec3(ndc.x / frame.projection.x, -ndc.y / frame.projection.y, -1.0);
}

// Half-size texels stand for every second pixel of the full image.
ivec2 full_pixel(ivec2 half_pixel) {
  return min(half_pixel * 2, textureSize(depth_image, 0) - 1);
}
