#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The environment behind the scene.
#include "frame_uniforms.glsl"
#include "encode.glsl"
#include "projection.glsl"
#include "tone_curve.glsl"
#include "environment_behind.glsl"

layout(constant_id = 1) const bool kAtCorners = false;
layout(constant_id = 19) const bool kAutoExposure = false;   // exposure is read from exposure_image

layout(location = 0) in vec2 ndc;
layout(location = 1) in vec3 shown_here;

layout(location = 0) out vec4 shown;

void main() {
  shown = vec4(shown_here, 1.0);
  if (kAtCorners) return;
  float exposure = frame.exposure;
  if (kAutoExposure) exposure *= texelFetch(exposure_image, ivec2(0), 0).r;
  shown.rgb = displayed(tone_mapped(environment_behind(ndc) * exposure));
}
