#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Antialiased overlay lines, fainter with distance and behind surfaces.
#include "frame_uniforms.glsl"
#include "encode.glsl"
#include "projection.glsl"
#include "line.glsl"

const float kFarthest = 0.5, kHidden = 0.75;   // factors of coverage: at the far distance, and behind surfaces

layout(location = 0) flat in vec4 line_color;   // sRGB
layout(location = 1) noperspective in float across;

layout(location = 0) out vec4 shown;

float depth_cue() {
  float part = (distance_of(gl_FragCoord.z) - frame.nearest_shown_m) / (frame.farthest_shown_m - frame.nearest_shown_m);
  // If there are no surfaces, the image is a single texel.
  ivec2 pixel = min(ivec2(gl_FragCoord.xy), textureSize(depth_image, 0) - 1);
  bool hidden = texelFetch(depth_image, pixel, 0).r > gl_FragCoord.z;
  return mix(1.0, kFarthest, clamp(part, 0.0, 1.0)) * (hidden ? kHidden : 1.0);
}

void main() {
  float covered = clamp(kLineReach - abs(across), 0.0, 1.0);
  shown = vec4(displayed_data(line_color.rgb), line_color.a * covered * depth_cue());
}
