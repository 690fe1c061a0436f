// SPDX-License-Identifier: MIT
// Outputs of a surface with weighted blending: terms of sums instead of colours.
#include "weighted_sums.glsl"

layout(constant_id = 39) const bool kWeighted = false;
layout(location = 2) out vec4 unlit_sum;

// Converts `color` and `unlit` to the terms that Blending::weighted sums up (viewer/device/pipeline.h).
void weigh(float distance_m, float coverage, bool is_unlit) {
  float weight = blend_weight(distance_m);
  unlit_sum = is_unlit ? unlit * weight : vec4(0.0);
  color = vec4(color.rgb * weight, coverage * weight);
  unlit = vec4(coverage);
}
