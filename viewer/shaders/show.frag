#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Displays an intermediate buffer instead of the picture.
#include "frame_uniforms.glsl"
#include "encode.glsl"
#include "view_position.glsl"
#include "octahedral.glsl"
#include "same_surface.glsl"
#include "ambient_visibility.glsl"

layout(constant_id = 1) const int kShow = 1;   // enum Show: 1 ambient occlusion, 2 normals, 3 depth, 4 level
layout(constant_id = 20) const bool kVertexVisibility = false;   // ambient visibility is in alpha of the normal image
layout(constant_id = 14) const bool kTransparentBackground = false;

layout(location = 0) out vec4 shown;

float visibility_at(ivec2 pixel, float far_p) {
  vec3 n = texelFetch(normal_image, pixel, 0).xyz;
  return n == vec3(0.0) ? 1.0 : ambient_visibility(pixel, view_point(pixel, far_p), normalize(n));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float far_p = distance_at(pixel);
  float covered = far_p > 0.0 ? 1.0 : 0.0;
  vec3 value;
  if (kShow == 1) {
    float visibility = 1.0;
    if (kVertexVisibility) visibility = clamp(texelFetch(normal_image, pixel, 0).a, 0.0, 1.0);
    else if (kOccluded) visibility = visibility_at(pixel, far_p);
    value = vec3(covered == 0.0 ? 1.0 : visibility);
  } else if (kShow == 2) {
    value = covered == 0.0 ? vec3(0.5) : texelFetch(normal_image, pixel, 0).xyz * 0.5 + 0.5;
  } else if (kShow == 4) {
    value = covered == 0.0 ? vec3(0.5) : texelFetch(normal_image, pixel, 0).xyz;   // normal_depth.frag wrote a colour
  } else {
    float part = (far_p - frame.nearest_shown_m) / (frame.farthest_shown_m - frame.nearest_shown_m);
    value = vec3(covered == 0.0 ? 0.0 : 1.0 - clamp(part, 0.0, 1.0));
  }
  shown = vec4(displayed_data(value), kTransparentBackground ? covered : 1.0);
}
