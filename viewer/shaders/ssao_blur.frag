#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// One direction of the edge-preserving blur. The noise of the occlusion pass repeats every 4 texels; the weights 1/2 1
// 1 1 1/2 average every pattern of period 4 exactly.
#include "frame_uniforms.glsl"
#include "view_position.glsl"
#include "octahedral.glsl"
#include "visibility_texel.glsl"
#include "same_surface.glsl"

layout(constant_id = 0) const bool kVertical = false;
layout(constant_id = 1) const int kReach = 2;          // OcclusionShape::blur_reach
layout(constant_id = 2) const bool kKeepEdges = true;  // OcclusionShape::keep_edges

layout(location = 0) out vec4 visibility_distance_normal;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 middle = texelFetch(ao_image, texel, 0);
  visibility_distance_normal = middle;
  if (middle.g == 0.0 || !has_normal(middle)) return;
  vec3 n = normal_of(middle);
  vec3 p = view_point(full_pixel(texel), middle.g);
  ivec2 last = textureSize(ao_image, 0) - 1;
  // Two scalar selections instead of one vector selection, which Mesa 22.3 wrongly folds to (0, 0).
  ivec2 direction = ivec2(kVertical ? 0 : 1, kVertical ? 1 : 0);
  float metres_per_texel = float(kAoStep) / pixels_per_metre(middle.g);
  float sum = middle.r, weight_sum = 1.0;
  vec2 bend = bend_of(middle);
  for (int k = -kReach; k <= kReach; ++k) {
    ivec2 at = texel + k * direction;
    if (k == 0 || any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) continue;
    vec4 other = texelFetch(ao_image, at, 0);
    if (other.g == 0.0 || !has_normal(other)) continue;
    vec3 q = view_point(full_pixel(at), other.g);
    float weight = abs(k) == kReach ? 0.5 : 1.0;
    if (kKeepEdges) weight *= same_surface(p, n, q, normal_of(other), float(abs(k)) * metres_per_texel);
    sum += weight * other.r;
    if (kBent) bend += weight * bend_of(other);
    weight_sum += weight;
  }
  if (kBent) visibility_distance_normal = with_bend(middle, bend / weight_sum);
  visibility_distance_normal.r = sum / weight_sum;
}
