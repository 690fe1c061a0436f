#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Maps light of the scene to light of the display with the Khronos PBR Neutral curve: it keeps base colours up to 0.8
// and compresses highlights. The output has straight alpha.
#include "frame_uniforms.glsl"
#include "encode.glsl"

layout(constant_id = 14) const bool kTransparentBackground = false;

layout(location = 0) out vec4 shown;

vec3 tone_mapped(vec3 color) {
  const float start = 0.8 - 0.04, desaturation = 0.15;
  float smallest = min(color.r, min(color.g, color.b));
  color -= smallest < 0.08 ? smallest - 6.25 * smallest * smallest : 0.04;
  float peak = max(color.r, max(color.g, color.b));
  if (peak < start) return color;
  float room = 1.0 - start;
  float new_peak = 1.0 - room * room / (peak + room - start);
  color *= new_peak / peak;
  float whitened = 1.0 - 1.0 / (desaturation * (peak - new_peak) + 1.0);
  return mix(color, vec3(new_peak), whitened);
}

void main() {
  vec4 stored = texelFetch(color_image, ivec2(gl_FragCoord.xy), 0);
  float coverage = clamp(stored.a, 0.0, 1.0);
  vec3 light = coverage > 0.0 ? tone_mapped(stored.rgb / coverage * frame.exposure) : vec3(0.0);
  if (kTransparentBackground) shown = vec4(displayed(light), coverage);
  else shown = vec4(displayed(mix(frame.background.rgb, light, coverage)), 1.0);
}
