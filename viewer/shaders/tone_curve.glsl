// SPDX-License-Identifier: MIT
// Tone curves: map scene light to display light, both linear.

layout(constant_id = 8) const int kToneCurve = 0;   // enum ToneCurve: 0 neutral, 1 ACES, 2 none

// Khronos PBR Neutral: keeps base colours up to 0.8 and compresses highlights.
vec3 neutral(vec3 color) {
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

// Hill's fit of ACES' reference rendering and sRGB output transforms ("BakingLab", 2016). The light is divided by 0.6, so
// that middle grey stays about as bright as with the other curves.
vec3 aces(vec3 color) {
  const mat3 into = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
  const mat3 out_of = mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);
  vec3 v = into * (color / 0.6);
  vec3 fit = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
  return clamp(out_of * fit, 0.0, 1.0);
}

vec3 tone_mapped(vec3 color) {
  if (kToneCurve == 1) return aces(color);
  if (kToneCurve == 2) return min(color, 1.0);
  return neutral(color);
}
