#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Applies exposure and tone curve, adds unlit colours unchanged, and composites over the backdrop. The output has
// straight alpha.
#include "frame_uniforms.glsl"
#include "encode.glsl"
#include "projection.glsl"
#include "tone_curve.glsl"
#include "weighted_sums.glsl"

layout(constant_id = 9) const int kBackdrop = 0;   // enum Backdrop: 0 plain, 1 blurred, 2 sharp
layout(constant_id = 18) const bool kUnlitImage = false;   // the unlit image exists
layout(constant_id = 14) const bool kTransparentBackground = false;

layout(constant_id = 39) const bool kWeightedSums = false;    // weighted sums must be composited over the picture
layout(constant_id = 19) const bool kAutoExposure = false;   // exposure is read from exposure_image

layout(location = 0) out vec4 shown;

// Environment light behind a pixel.
vec3 environment_behind(vec2 pixel) {
  vec2 ndc = pixel / vec2(textureSize(color_image, 0)) * 2.0 - 1.0;
  vec3 direction = kParallel ? vec3(0.0, 0.0, -1.0) : vec3(vec2(ndc.x, -ndc.y) / frame.projection.xy, -1.0);
  float level = kBackdrop == 1 ? kBlurredLevel : 0.0;
  return textureLod(environment_image, frame.environment_from_view * direction, level).rgb * frame.backdrop_intensity;
}

void main() {
  float exposure = frame.exposure;
  if (kAutoExposure) exposure *= texelFetch(exposure_image, ivec2(0), 0).r;
  vec4 stored = texelFetch(color_image, ivec2(gl_FragCoord.xy), 0);
  vec4 unlit = kUnlitImage ? texelFetch(unlit_image, ivec2(gl_FragCoord.xy), 0) : vec4(0.0);
  if (kWeightedSums) lay_over(ivec2(gl_FragCoord.xy), stored, unlit);
  float coverage = clamp(stored.a, 0.0, 1.0);
  float lit = coverage - clamp(unlit.a, 0.0, coverage);
  vec3 light = lit > 0.0 ? stored.rgb / lit * exposure : vec3(0.0), behind = frame.background.rgb;
  if (kBackdrop == 0 || kTransparentBackground) {
    light = tone_mapped(light);
  } else {
    // Most pixels are only light or only backdrop and evaluate the tone curve once. Edge pixels evaluate it again in a
    // loop, because software drivers execute both sides of a branch. They read the environment everywhere; a loop
    // around that read would cost more.
    vec3 around = vec3(0.0);
    if (coverage < 1.0) around = environment_behind(gl_FragCoord.xy) * exposure;
    behind = tone_mapped(lit > 0.0 ? light : around);
    light = behind;
    for (int again = 0; again < int(lit > 0.0 && coverage < 1.0); ++again) behind = tone_mapped(around);
  }
  if (kUnlitImage && unlit.a > 0.0) light = ((lit > 0.0 ? light * lit : vec3(0.0)) + unlit.rgb) / coverage;
  if (kTransparentBackground) {
    shown = vec4(displayed(light), coverage);
    return;
  }
  shown = vec4(displayed(mix(behind, light, coverage)), 1.0);
}
