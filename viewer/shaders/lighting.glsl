// SPDX-License-Identifier: MIT
// Direct and ambient light on a metallic-roughness surface.
// eq   glTF 2.0, Appendix B: mix(dielectric, metal, metallic); the dielectric is Lambert under a Fresnel layer of GGX with
//      height-correlated Smith visibility. KHR_materials_specular: F = f0 + (f90 - f0) (1 - v.h)^5, and Lambert gets
//      1 - max(F)

const float kPi = 3.14159265358979;
const float kLeastRoughness = 0.045;   // keeps the highlight of a mirror visible and finite

#include "thin_film.glsl"

struct Surface {
  vec3 base_color;
  float metallic, roughness;
  vec3 n, to_viewer;
  vec3 dielectric_f0;     // reflectance at normal incidence,
  float dielectric_f90;   // and at grazing angles
  float transmission;     // fraction of refracted light that passes through instead of being scattered
  Film film;
  vec3 metal_f0;          // reflectance of the metal at normal incidence
  vec3 along;             // direction of a stretched highlight, unit,
  float anisotropy;       // and how far it is stretched, 0 to 1
};

float greatest(vec3 v) { return max(v.r, max(v.g, v.b)); }

// D V n.l of GGX, without Fresnel; 0 if the light is behind the surface.
float ggx(vec3 n, vec3 to_viewer, vec3 to_light, float roughness) {
  float n_l = dot(n, to_light);
  if (n_l <= 0.0) return 0.0;
  float n_v = max(dot(n, to_viewer), 1e-4);
  float n_h = clamp(dot(n, normalize(to_light + to_viewer)), 0.0, 1.0);
  float alpha = roughness * roughness, alpha2 = alpha * alpha;
  float d = n_h * n_h * (alpha2 - 1.0) + 1.0;
  float distribution = alpha2 / (kPi * d * d);
  float smith = n_l * sqrt(n_v * n_v * (1.0 - alpha2) + alpha2) + n_v * sqrt(n_l * n_l * (1.0 - alpha2) + alpha2);
  return distribution * 0.5 / smith * n_l;
}

#include "anisotropy.glsl"

vec3 reflected(Surface s, vec3 to_light, vec3 irradiance) {
  float n_l = dot(s.n, to_light);
  if (n_l <= 0.0) return vec3(0.0);
  float v_h = clamp(dot(s.to_viewer, normalize(to_light + s.to_viewer)), 0.0, 1.0);
  float away = 1.0 - v_h, edge = away * away * away * away * away;
  vec3 dielectric = s.dielectric_f0 + (s.dielectric_f90 - s.dielectric_f0) * edge;
  vec3 metal = s.base_color + (1.0 - s.base_color) * edge;
  float below = 1.0 - greatest(dielectric);
  if (kIridescence) {
    vec3 film = film_reflectance(s.film, s.dielectric_f0, v_h);
    below = mix(below, 1.0 - greatest(min(film, vec3(1.0))), s.film.share);
    dielectric = mix(dielectric, film, s.film.share);
    metal = mix(metal, film_reflectance(s.film, s.base_color, v_h), s.film.share);
  }
  vec3 diffuse = below * (1.0 - s.metallic) * (1.0 - s.transmission) * s.base_color / kPi;
  return (diffuse * n_l + mix(dielectric, metal, s.metallic) * lobe(s, to_light)) * irradiance;
}

// eq   KHR_lights_punctual: inverse square with a smooth end at the range, and a smooth edge of the cone of a spot light
// The kind and the range of the light select values, not branches, because they are uniforms (surface_features.glsl).
// out  irradiance of a surface at p that faces the light
vec3 arriving(Light light, vec3 p, out vec3 to_light) {
  vec3 towards = light.position - p;
  float d2 = max(dot(towards, towards), 1e-8), d = sqrt(d2);
  vec3 to_point = towards / d;
  float part = d / light.range_m;
  float within = mix(1.0, clamp(1.0 - part * part * part * part, 0.0, 1.0), light.range_m > 0.0);
  float edge = clamp((dot(light.to_light, to_point) - light.cos_outer) * light.inverse_cone_width, 0.0, 1.0);
  float cone = mix(1.0, edge * edge, light.kind == 2u);
  bool directional = light.kind == 0u;
  to_light = mix(to_point, light.to_light, bvec3(directional));
  return light.color * mix(1.0 / d2 * within * cone, 1.0, directional);
}

// Irradiance / pi of the environment on a surface.
// in   n  unit, in the space of the environment
vec3 diffuse_light(vec3 n) {
  vec3 sum = frame.diffuse_light[0].rgb + frame.diffuse_light[1].rgb * n.y + frame.diffuse_light[2].rgb * n.z +
             frame.diffuse_light[3].rgb * n.x + frame.diffuse_light[4].rgb * n.x * n.y +
             frame.diffuse_light[5].rgb * n.y * n.z + frame.diffuse_light[6].rgb * (3.0 * n.z * n.z - 1.0) +
             frame.diffuse_light[7].rgb * n.x * n.z + frame.diffuse_light[8].rgb * (n.x * n.x - n.y * n.y);
  return max(sum, vec3(0.0));   // three bands undershoot on the side opposite to a small bright light
}

// Environment light around the mirror direction, prefiltered for the roughness.
vec3 mirrored_light(vec3 direction, float roughness) {
  float last = float(textureQueryLevels(environment_image) - 1);
  return textureLod(environment_image, direction, roughness * last).rgb * frame.environment_intensity;
}

// Fractions of ambient light that a rough layer reflects after one bounce, and after further bounces.
// eq   Fdez-Aguera, "A Multiple-Scattering Microfacet Model for Real-Time Image-based Lighting" (2019): the loss of the
//      first bounce, 1 - x - y, is reflected again with the mean reflectance f0 + (f90 - f0) / 21
// in   sums  of the split sum: once = f0 * x + f90 * y
void layer(vec3 f0, float f90, vec2 sums, out vec3 once, out vec3 again) {
  once = f0 * sums.x + f90 * sums.y;
  float lost = 1.0 - sums.x - sums.y;
  vec3 mean = f0 + (f90 - f0) / 21.0;
  again = once * mean * lost / (1.0 - mean * lost);
}

// Reads the table of viewer/light/split_sum.h: split sum in xy, sheen albedo in z.
vec3 tabled(float n_v, float roughness) {
  vec2 size = vec2(textureSize(split_sum_image, 0));
  return textureLod(split_sum_image, (vec2(sqrt(n_v), roughness) * (size - 1.0) + 0.5) / size, 0.0).rgb;
}

vec2 split_sums(float n_v, float roughness) { return tabled(n_v, roughness).xy; }

// Ambient visibility of a diffuse surface with interreflections, assuming that occluders have its albedo. Exactly 1 at
// visibility 1.
// eq   Jimenez, Wu, Pesce and Jarabo, "Practical Realtime Strategies for Accurate Indirect Occlusion" (2016), section 5
vec3 scattered_visibility(float visibility, vec3 albedo) {
  vec3 a = 2.0404 * albedo - 0.3324, b = 0.6417 - 4.7951 * albedo, c = 2.7552 * albedo + 0.6903;
  return clamp(((a * visibility + b) * visibility + c) * visibility, vec3(visibility), vec3(1.0));
}

// Ambient light. Light that a dielectric does not reflect is scattered below its surface, so a white furnace test
// returns all light.
// in   scattered, mirrored  visibility of the hemisphere, and around the mirror direction
//      surroundings  hemisphere light that occluders reflect in place of the hidden part of the mirror lobe
vec3 ambient(Surface s, vec3 scattered, float mirrored, vec3 surroundings) {
  vec2 sums = split_sums(clamp(dot(s.n, s.to_viewer), 0.0, 1.0), s.roughness);
  vec3 metal_once, metal_again, once, again;
  layer(s.metal_f0, 1.0, sums, metal_once, metal_again);
  layer(s.dielectric_f0, s.dielectric_f90, sums, once, again);
  vec3 below = s.base_color * (1.0 - greatest(once + again)) * (1.0 - s.transmission);
  vec3 direction = frame.environment_from_view * reflect(-s.to_viewer, mirror_normal(s));
  vec3 around = diffuse_light(frame.environment_from_view * s.n), reflectance = mix(once, metal_once, s.metallic);
  return around * mix(again + below, metal_again, s.metallic) * scattered +
         mirrored_light(direction, s.roughness) * reflectance * mirrored + around * reflectance * surroundings;
}

// Fraction of light that passes straight through a thin surface.
// eq   KHR_materials_transmission: base colour times the light that the dielectric does not reflect
vec3 transmitted(Surface s) {
  vec3 once, again;
  layer(s.dielectric_f0, s.dielectric_f90, split_sums(clamp(dot(s.n, s.to_viewer), 0.0, 1.0), s.roughness), once, again);
  return s.base_color * (1.0 - greatest(once + again)) * (1.0 - s.metallic) * s.transmission;
}
