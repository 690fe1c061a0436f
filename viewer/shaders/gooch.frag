#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Gooch shading: cool tones away from the first light, warm tones towards it, and a white highlight. As in the paper,
// tones are display colours (sRGB); exposure and tone curve do not apply.
// eq   Gooch, Gooch, Shirley and Cohen, "A Non-Photorealistic Lighting Model for Automatic Technical Illustration"
//      (1998), eq. 2 with eqs. 3 and 4: t = (1 + n.l) / 2, colour = (1 - t) (blue + 0.2 base) + t (yellow + 0.6 base);
//      highlight as in Akenine-Moeller et al., "Real-Time Rendering", 4th ed. (2018), eq. 5.2: s = clamp(100 r.v - 97),
//      r = l mirrored about n
#include "frame_uniforms.glsl"
#include "geometry.glsl"
#include "material.glsl"
#include "surface_normal.glsl"
#include "lighting.glsl"
#include "srgb.glsl"

layout(constant_id = 0) const bool kMasked = false;    // do the alpha test, if no prepass did it
layout(constant_id = 1) const bool kBlended = false;   // coverage from alpha

const vec3 kBlue = vec3(0.0, 0.0, 0.4), kYellow = vec3(0.4, 0.4, 0.0);
const float kBaseInCool = 0.2, kBaseInWarm = 0.6;

layout(location = 0) in vec3 view_position;
layout(location = 1) centroid in vec3 view_normal;
layout(location = 3) in vec4 texcoords;
layout(location = 4) centroid in vec4 vertex_color;

layout(location = 0) out vec4 color;   // no light, only coverage
layout(location = 1) out vec4 unlit;   // premultiplied, as displayed
#include "weighted_output.glsl"

// in   base  sRGB;   out  sRGB
vec3 tone(vec3 base, vec3 n, vec3 to_viewer) {
  vec3 to_light;
  arriving(frame.lights[0], view_position, to_light);
  float n_l = dot(n, to_light), warm = 0.5 + 0.5 * n_l;
  vec3 shade = mix(kBlue + kBaseInCool * base, kYellow + kBaseInWarm * base, warm);
  float highlight = clamp(100.0 * dot(2.0 * n_l * n - to_light, to_viewer) - 97.0, 0.0, 1.0);
  return mix(clamp(shade, 0.0, 1.0), vec3(1.0), highlight);
}

void main() {
  vec4 base = base_color_at(texcoords, vertex_color);
  vec3 n = surface_normal(view_normal, view_position);
  vec3 shown = clamp(base.rgb, 0.0, 1.0);
  if (n != vec3(0.0)) shown = srgb_decoded(tone(srgb_encoded(base.rgb), n, towards_viewer(view_position)));
  float coverage = kBlended ? clamp(base.a, 0.0, 1.0) : 1.0;
  color = vec4(vec3(0.0), coverage);
  unlit = vec4(shown * coverage, coverage);
  if (kWeighted) weigh(-view_position.z, coverage, true);
  if (kMasked && is_cut(base.a)) discard;
}
