// SPDX-License-Identifier: MIT
// Environment light behind the scene. Needs frame_uniforms.glsl and projection.glsl.

layout(constant_id = 9) const int kBackdrop = 0;   // enum Backdrop: 0 plain, 1 blurred, 2 sharp

// in   ndc  point of the picture, -1 to 1 from left to right and from top to bottom
vec3 environment_behind(vec2 ndc) {
  vec3 direction = kParallel ? vec3(0.0, 0.0, -1.0) : vec3(vec2(ndc.x, -ndc.y) / frame.projection.xy, -1.0);
  float level = kBackdrop == 1 ? kBlurredLevel : 0.0;
  return textureLod(environment_image, frame.environment_from_view * direction, level).rgb * frame.backdrop_intensity;
}
