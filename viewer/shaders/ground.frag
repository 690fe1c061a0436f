#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// A transparent ground that darkens what is behind it by the factor by which shadow and occlusion darken a diffuse
// floor.
// eq   coverage by black = 1 - (irradiance) / (irradiance without shadows and occlusion), both as luminance
#include "frame_uniforms.glsl"
#include "projection.glsl"
#include "view_position.glsl"
#include "octahedral.glsl"
#include "same_surface.glsl"
#include "ambient_visibility.glsl"
#include "lighting.glsl"
#include "shadow.glsl"
#include "luminance.glsl"
#include "tone_curve.glsl"

layout(constant_id = 0) const bool kGrid = false;
layout(constant_id = 13) const int kLightCount = 1;
layout(constant_id = 15) const bool kAmbient = true;   // environment light is present
layout(constant_id = 18) const bool kUnlitImage = false;   // the unlit image exists

const float kFadeStart = 0.6;       // relative to the radius
const float kLineCoverage = 0.3;
const float kLineLight = 0.4;       // brightness of grid lines before the tone curve

layout(location = 0) in vec3 view_position;
layout(location = 1) in vec2 from_middle;
// An input, because software drivers recompile for uniforms in branches (surface_features.glsl).
layout(location = 2) flat in vec3 normal;

layout(location = 0) out vec4 color;   // premultiplied
layout(location = 1) out vec4 unlit;   // as displayed

// Coverage of a pixel by grid lines. A line's coverage falls to 0 one pixel from its center; lines that are too dense
// fade out.
float grid_coverage() {
  vec2 at = (from_middle + frame.ground_grid_offset) / frame.ground_grid_step_m;
  vec2 pixel = max(fwidth(at), vec2(1e-9));
  vec2 away = 0.5 - abs(fract(at) - 0.5);   // distance from the nearest line, in grid steps
  vec2 covered = clamp(1.0 - away / pixel, 0.0, 1.0) * clamp(1.0 - 4.0 * pixel, 0.0, 1.0);
  return max(covered.x, covered.y);
}

float shadow_coverage() {
  float unhindered = 0.0, hindered = 0.0;
  if (kAmbient) {
    unhindered = kPi * dot(diffuse_light(frame.environment_from_view * normal), kLuminance);
    bool near = all(greaterThan(from_middle, frame.ground_contact.xy)) && all(lessThan(from_middle, frame.ground_contact.zw));
    hindered = unhindered;
    for (int once = 0; once < int(near); ++once)   // a loop, because software drivers execute both sides of a branch
      hindered *= ambient_visibility(ivec2(gl_FragCoord.xy), view_position, normal);
  }
  for (int i = 0; i < kLightCount; ++i) {
    vec3 to_light;
    float light = dot(arriving(frame.lights[i], view_position, to_light), kLuminance) * max(dot(normal, to_light), 0.0);
    unhindered += light;
    if (casts_shadows(i)) light *= light_share(i, view_position, normal, to_light);
    hindered += light;
  }
  return 1.0 - hindered / max(unhindered, 1e-9);
}

void main() {
  float fade = 1.0 - smoothstep(kFadeStart, 1.0, length(from_middle) / frame.ground_radius_m);
  float line = kGrid ? kLineCoverage * grid_coverage() * fade : 0.0;
  float dark = shadow_coverage() * fade;
  float covered = line + dark * (1.0 - line);
  // Line brightness does not depend on exposure. Automatic exposure is not known yet, so such frames write lines to the
  // unlit image.
  color = vec4(kUnlitImage ? vec3(0.0) : vec3(kLineLight / frame.exposure * line), covered);
  unlit = vec4(tone_mapped(vec3(kLineLight)) * line, covered);
}
