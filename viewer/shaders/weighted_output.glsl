// SPDX-License-Identifier: MIT
// The outputs of a surface that blends in any order: its sums instead of its colours.
#include "weighted_sums.glsl"

layout(constant_id = 39) const bool kWeighted = false;
layout(location = 2) out vec4 unlit_sum;

// Turns `color` and `unlit` into what Blending::weighted sums (viewer/device/pipeline.h).
void weigh(float distance_m, float coverage, bool is_unlit) {
  float weight = blend_weight(distance_m);
  unlit_sum = is_unlit ? unlit * weight : vec4(0.0);
  color = vec4(color.rgb * weight, coverage * weight);
  unlit = vec4(coverage);
}
