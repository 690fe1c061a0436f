// SPDX-License-Identifier: MIT
// KHR_materials_iridescence: a thin film over the surface. Light that both of its sides reflect interferes.
// eq   Belcour and Barla, "A Practical Extension to Microfacet Theory for the Modeling of Varying Iridescence" (2017):
//      R = C0 + 2 sum over m = 1, 2 of Cm S(m D, m phi), with D = 2 ior thickness cos(angle in the film), and S the
//      spectral sensitivity of the eye as Gaussians in the frequency domain

layout(constant_id = 28) const bool kIridescence = false;

struct Film {
  float share;   // 0 = no film, 1 = all of the surface
  float ior, thickness_m;
};

vec3 fifth_power_edge(vec3 f0, float cosine) {
  float away = 1.0 - cosine, away2 = away * away;
  return f0 + (1.0 - f0) * (away2 * away2 * away);
}

// Light of the path difference `path_m` in linear sRGB, relative to white. The shift is per channel of x, y and z.
vec3 film_sensitivity(float path_m, vec3 shift) {
  const vec3 height = vec3(5.4856e-13, 4.4201e-13, 5.2481e-13), middle = vec3(1.6810e6, 1.7953e6, 2.2084e6);
  const vec3 width = vec3(4.3278e9, 9.3046e9, 6.6121e9);
  const mat3 srgb_from_xyz = mat3(3.2404542, -0.9692660, 0.0556434, -1.5371385, 1.8760108, -0.2040259, -0.4985314,
                                  0.0415560, 1.0572252);
  const float turn = 6.28318530717959;
  float phase = turn * path_m, phase2 = phase * phase;
  vec3 xyz = height * sqrt(turn * width) * cos(middle * phase + shift) * exp(-width * phase2);
  xyz.x += 9.7470e-14 * sqrt(turn * 4.5282e9) * cos(2.2399e6 * phase + shift.x) * exp(-4.5282e9 * phase2);
  return srgb_from_xyz * (xyz / 1.0685e-7);
}

// Reflectance of the film and the surface below, per channel.
// in   f0  reflectance of the surface in air, along its normal;   cosine  of the angle of incidence
vec3 film_reflectance(Film film, vec3 f0, float cosine) {
  // A film much thinner than light has no effect: its index fades to that of air.
  float ior = mix(1.0, film.ior, smoothstep(0.0, 0.03e-6, film.thickness_m));
  float inside2 = 1.0 - (1.0 - cosine * cosine) / (ior * ior);
  float inside = sqrt(max(inside2, 0.0));
  float root = (ior - 1.0) / (ior + 1.0);
  float outer = fifth_power_edge(vec3(root * root), cosine).x, passed = 1.0 - outer;
  vec3 amplitude = sqrt(clamp(f0, 0.0, 0.9999)), below_ior = (1.0 + amplitude) / (1.0 - amplitude);
  vec3 roots = (below_ior - ior) / (below_ior + ior), inner = fifth_power_edge(roots * roots, inside);
  // Light that meets a denser medium is shifted by half a wave.
  vec3 shift = kPi * (mix(vec3(0.0), vec3(1.0), lessThan(below_ior, vec3(ior))) + step(1.0, ior));
  float path_m = 2.0 * ior * film.thickness_m * inside;
  vec3 both = clamp(outer * inner, 1e-5, 0.9999), returned = passed * passed * inner / (1.0 - both);
  vec3 sum = outer + returned, amplitude_m = returned - passed;
  for (int m = 1; m <= 2; ++m) {
    amplitude_m *= sqrt(both);
    sum += amplitude_m * 2.0 * film_sensitivity(float(m) * path_m, float(m) * shift);
  }
  return inside2 < 0.0 ? vec3(1.0) : max(sum, vec3(0.0));
}

// The reflectance along the normal that has this reflectance at the angle.
// eq   Schlick's approximation, solved for f0
vec3 normal_reflectance(vec3 reflectance, float cosine) {
  float away = 1.0 - cosine, away2 = away * away, edge = min(away2 * away2 * away, 0.9999);
  return clamp((reflectance - edge) / (1.0 - edge), 0.0, 1.0);
}
