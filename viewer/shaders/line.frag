#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Lines over the picture: as much of a pixel as they cover, fainter the farther away they are, and behind surfaces.
#include "frame_uniforms.glsl"
#include "encode.glsl"
#include "projection.glsl"
#include "line.glsl"

const float kFarthest = 0.5, kHidden = 0.75;   // of the coverage that is left

layout(location = 0) flat in vec4 line_color;   // sRGB
layout(location = 1) noperspective in float across;

layout(location = 0) out vec4 shown;

float depth_cue() {
  float part = (distance_of(gl_FragCoord.z) - frame.nearest_shown_m) / (frame.farthest_shown_m - frame.nearest_shown_m);
  ivec2 pixel = min(ivec2(gl_FragCoord.xy), textureSize(depth_image, 0) - 1);   // without surfaces, it is a single texel
  bool hidden = texelFetch(depth_image, pixel, 0).r > gl_FragCoord.z;
  return mix(1.0, kFarthest, clamp(part, 0.0, 1.0)) * (hidden ? kHidden : 1.0);
}

void main() {
  float covered = clamp(kLineReach - abs(across), 0.0, 1.0);
  shown = vec4(displayed_data(line_color.rgb), line_color.a * covered * depth_cue());
}
