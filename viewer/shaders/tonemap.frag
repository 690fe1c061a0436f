#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Applies exposure and tone curve, adds unlit colours unchanged, and composites over what is behind. The output has
// straight alpha. Where nothing is drawn, the target keeps its backdrop.
#include "frame_uniforms.glsl"
#include "encode.glsl"
#include "projection.glsl"
#include "tone_curve.glsl"
#include "weighted_sums.glsl"
#include "environment_behind.glsl"

layout(constant_id = 18) const bool kUnlitImage = false;   // the unlit image exists
layout(constant_id = 14) const bool kTransparentBackground = false;

layout(constant_id = 39) const bool kWeightedSums = false;    // weighted sums must be composited over the picture
layout(constant_id = 19) const bool kAutoExposure = false;   // exposure is read from exposure_image

layout(location = 0) out vec4 shown;

// The displayed colour of a pixel that something covers.
// in   stored  premultiplied light, and coverage;   unlit  likewise, as displayed
vec4 shown_over(vec4 stored, vec4 unlit, float coverage, float exposure) {
  float lit = coverage - clamp(unlit.a, 0.0, coverage);
  vec3 light = tone_mapped(lit > 0.0 ? stored.rgb / lit * exposure : vec3(0.0)), behind = frame.background.rgb;
  if (kBackdrop != 0 && !kTransparentBackground) {
    vec2 ndc = gl_FragCoord.xy / vec2(textureSize(color_image, 0)) * 2.0 - 1.0;
    for (int edge = 0; edge < int(coverage < 1.0); ++edge) behind = tone_mapped(environment_behind(ndc) * exposure);
  }
  if (kUnlitImage && unlit.a > 0.0) light = ((lit > 0.0 ? light * lit : vec3(0.0)) + unlit.rgb) / coverage;
  if (kTransparentBackground) return vec4(displayed(light), coverage);
  return vec4(displayed(mix(behind, light, coverage)), 1.0);
}

void main() {
  float exposure = frame.exposure;
  if (kAutoExposure) exposure *= texelFetch(exposure_image, ivec2(0), 0).r;
  vec4 stored = texelFetch(color_image, ivec2(gl_FragCoord.xy), 0);
  vec4 unlit = kUnlitImage ? texelFetch(unlit_image, ivec2(gl_FragCoord.xy), 0) : vec4(0.0);
  if (kWeightedSums) lay_over(ivec2(gl_FragCoord.xy), stored, unlit);
  float coverage = clamp(stored.a, 0.0, 1.0);
  shown = vec4(0.0);
  // Loops, because software drivers execute both sides of a branch.
  for (int once = 0; once < int(coverage > 0.0); ++once) shown = shown_over(stored, unlit, coverage, exposure);
  if (coverage == 0.0) discard;
}
