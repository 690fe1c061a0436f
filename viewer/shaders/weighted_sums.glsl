// SPDX-License-Identifier: MIT
// Weighted, order-independent blending.
// eq   McGuire and Bavoil, "Weighted Blended Order-Independent Transparency" (JCGT 2, 2013), eqs. 6 and 7: sum(w a c) /
//      sum(w a) * (1 - product(1 - a)) over what is behind. The weight w decreases with distance: by 2^-kFall over the
//      distance range of the blended surfaces.
const float kFall = 5.0;   // gives the least mean error for 2 to 8 surfaces of any coverage at random distances
const float kRoom = 4.0;   // headroom: half floats can hold the sum of 2^kRoom surfaces of the largest radiance

float blend_weight(float distance_m) {
  return exp2(-kRoom - kFall * clamp((distance_m - frame.weighted_range.x) * frame.weighted_range.y, 0.0, 1.0));
}

// Composites the weighted surfaces of a pixel over its colours.
// inout  stored  premultiplied light, and coverage; unlit  likewise, for unlit surfaces only
void lay_over(ivec2 pixel, inout vec4 stored, inout vec4 unlit) {
  vec4 sums = texelFetch(weighted_image, pixel, 0);
  if (!(sums.a > 0.0)) return;
  float coverage = texelFetch(weighted_coverage_image, pixel, 0).a, scale = coverage / sums.a;
  stored = vec4(min(sums.rgb, vec3(65504.0)) * scale, coverage) + stored * (1.0 - coverage);
  unlit = texelFetch(weighted_unlit_image, pixel, 0) * scale + unlit * (1.0 - coverage);
}
