#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Automatic exposure, second step: the factor that maps the log average luminance to middle grey; 1 if there is no
// light.
// eq   Reinhard, Stark, Shirley and Ferwerda, "Photographic Tone Reproduction for Digital Images" (2002), eqs. 1 and 2:
//      exposure = 0.18 / 2^mean(log2(light))
#include "frame_uniforms.glsl"

const float kMiddleGrey = 0.18;

layout(location = 0) out vec4 exposure;

void main() {
  ivec2 size = textureSize(exposure_image, 0);
  vec2 sums = vec2(0.0);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) sums += texelFetch(exposure_image, ivec2(x, y), 0).xy;
  exposure = vec4(sums.y > 0.0 ? kMiddleGrey * exp2(-sums.x / sums.y) : 1.0);
}
