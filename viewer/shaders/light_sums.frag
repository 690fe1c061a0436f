#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Automatic exposure, first step: each of 32 x 32 texels sums log luminance over its block of the picture, in a fixed
// order. Unlit surfaces, the backdrop and black pixels do not count.
#include "frame_uniforms.glsl"
#include "luminance.glsl"
#include "weighted_sums.glsl"

layout(constant_id = 18) const bool kUnlitImage = false;   // the unlit image exists
layout(constant_id = 39) const bool kWeightedSums = false;   // weighted sums must be composited over the picture

const int kBlocks = 32;            // kExposureBlocks
const float kLeastLight = 1e-6;    // darker counts as black

layout(location = 0) out vec4 sums;   // coverage * log2(luminance), coverage

void main() {
  ivec2 size = textureSize(color_image, 0), block = ivec2(gl_FragCoord.xy);
  ivec2 first = block * size / kBlocks, end = (block + 1) * size / kBlocks;
  sums = vec4(0.0);
  for (int y = first.y; y < end.y; ++y)
    for (int x = first.x; x < end.x; ++x) {
      vec4 stored = texelFetch(color_image, ivec2(x, y), 0);
      vec4 unlit = kUnlitImage ? texelFetch(unlit_image, ivec2(x, y), 0) : vec4(0.0);
      if (kWeightedSums) lay_over(ivec2(x, y), stored, unlit);
      float lit = stored.a - unlit.a;
      float light = dot(stored.rgb, kLuminance);
      if (lit > 0.0 && light > kLeastLight * lit) sums.xy += vec2(lit * log2(light / lit), lit);
    }
}
