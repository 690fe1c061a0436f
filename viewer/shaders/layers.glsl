// SPDX-License-Identifier: MIT
// Material layers. Each is enabled by a specialisation constant, so materials without a layer do not pay for it.

// eq   KHR_materials_ior and KHR_materials_specular: f0 = min(f0 of ior * color, 1) * specular, f90 = specular
void set_specular(inout Surface s) {
  s.dielectric_f0 = vec3(0.04);
  s.dielectric_f90 = 1.0;
  if (!kSpecular) return;
  vec3 f0 = material.dielectric_f0;
  s.dielectric_f90 = material.specular;
  if (kSpecularTexture != 0) s.dielectric_f90 *= layer_texel(kSpecularTexture, 5, texcoords).a;
  if (kSpecularColorTexture != 0) f0 *= layer_texel(kSpecularColorTexture, 6, texcoords).rgb;
  s.dielectric_f0 = min(f0, vec3(1.0)) * s.dielectric_f90;
}

// eq   KHR_materials_transmission
void set_transmission(inout Surface s) {
  s.transmission = 0.0;
  if (kThrough == kOpaque) return;
  s.transmission = material.transmission;
  if (kTransmissionTexture != 0) s.transmission *= layer_texel(kTransmissionTexture, 12, texcoords).r;
}

// eq   KHR_materials_iridescence: factor * R; thickness = mix(thinnest, thickest, G). Ambient light meets the film at the
//      angle of the viewer.
void set_film(inout Surface s) {
  s.film = Film(0.0, 1.0, 0.0);
  s.metal_f0 = s.base_color;
  if (!kIridescence) return;
  s.film = Film(material.iridescence, material.film_ior, material.film_thinnest_m);
  if (kIridescenceTexture != 0) s.film.share *= layer_texel(kIridescenceTexture, 13, texcoords).r;
  if (kFilmThicknessTexture != 0)
    s.film.thickness_m = mix(material.film_thinnest_m, material.film_thickest_m,
                             layer_texel(kFilmThicknessTexture, 14, texcoords).g);
  s.film.share *= step(1e-12, s.film.thickness_m);
}

// The surface as ambient light sees it: the film changes its reflectance at normal incidence.
Surface with_film(Surface s) {
  if (!kIridescence) return s;
  float n_v = clamp(dot(s.n, s.to_viewer), 0.0, 1.0);
  vec3 dielectric = normal_reflectance(film_reflectance(s.film, s.dielectric_f0, n_v), n_v);
  s.metal_f0 = mix(s.metal_f0, normal_reflectance(film_reflectance(s.film, s.base_color, n_v), n_v), s.film.share);
  s.dielectric_f0 = mix(s.dielectric_f0, dielectric, s.film.share);
  return s;
}

// eq   KHR_materials_anisotropy: direction = turned by the rotation (2 RG - 1), strength * B
void set_anisotropy(inout Surface s, vec3 geometry_normal) {
  s.along = vec3(0.0);
  s.anisotropy = 0.0;
  if (!kAnisotropy) return;
  s.anisotropy = material.anisotropy;
  vec2 direction = vec2(1.0, 0.0);
  if (kAnisotropyTexture != 0) {
    vec3 texel = layer_texel(kAnisotropyTexture, 15, texcoords).xyz;
    direction = texel.xy * 2.0 - 1.0;
    s.anisotropy *= texel.z;
  }
  vec2 turn = material.anisotropy_turn;
  direction = vec2(turn.x * direction.x - turn.y * direction.y, turn.y * direction.x + turn.x * direction.y);
  int set = kAnisotropyTexture != 0 ? 1 + (kAnisotropyTexture - 1) % 2 : max(kNormalSet, 1);
  vec3 n = geometry_normal, t, b;
  bool found = map_frame(n, set, t, b) && perpendicular(s.n, t * direction.x + b * direction.y, s.along);
  if (!found) {
    s.along = normalize(cross(s.n, abs(s.n.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
    s.anisotropy = 0.0;
  }
}

struct Sheen {
  vec3 color;
  float roughness;
  float albedo;   // directional albedo of white sheen, towards the viewer
};

const float kLeastSheenRoughness = 5.0 / 63.0;   // (viewer/light/sheen_albedo.h)

Sheen sheen_at(Surface s) {
  Sheen sheen = Sheen(vec3(0.0), 1.0, 0.0);
  if (!kSheen) return sheen;
  sheen.color = material.sheen_color;
  sheen.roughness = material.sheen_roughness;
  if (kSheenColorTexture != 0) sheen.color *= layer_texel(kSheenColorTexture, 10, texcoords).rgb;
  if (kSheenRoughnessTexture != 0) sheen.roughness *= layer_texel(kSheenRoughnessTexture, 11, texcoords).a;
  sheen.roughness = max(sheen.roughness, kLeastSheenRoughness);
  sheen.albedo = tabled(clamp(dot(s.n, s.to_viewer), 0.0, 1.0), sheen.roughness).z;
  return sheen;
}

// eq   Estevez and Kulla, "Production Friendly Microfacet Sheen BRDF" (2017): their fit of Lambda
float sheen_lambda(float x, float alpha) {
  float smooth_part = (1.0 - alpha) * (1.0 - alpha), at = x < 0.5 ? x : 1.0 - x;
  float a = mix(21.5473, 25.3245, smooth_part), b = mix(3.82987, 3.32435, smooth_part);
  float c = mix(0.19823, 0.16801, smooth_part), d = mix(-1.97760, -1.27393, smooth_part);
  float e = mix(-4.32054, -4.85967, smooth_part);
  float log_at = a / (1.0 + b * pow(at, c)) + d * at + e;
  float log_middle = a / (1.0 + b * pow(0.5, c)) + d * 0.5 + e;
  return exp(x < 0.5 ? log_at : 2.0 * log_middle - log_at);
}

// Direct light on sheen and on the layers below, which get the light that sheen lets pass.
// eq   KHR_materials_sheen: color D V + below * min(1 - max(color) E(n.v), 1 - max(color) E(n.l)); D V is divided by
//      max(E(n.v), 1), so that no energy is created
vec3 under_sheen(Sheen sheen, Surface s, vec3 below, vec3 to_light, vec3 irradiance) {
  if (!kSheen) return below;
  float n_l = dot(s.n, to_light);
  if (n_l <= 0.0) return below;
  n_l = max(n_l, 1e-4);
  float n_v = max(dot(s.n, s.to_viewer), 1e-4), n_h = clamp(dot(s.n, normalize(to_light + s.to_viewer)), 0.0, 1.0);
  float alpha = sheen.roughness * sheen.roughness, inverse = 1.0 / alpha;
  float distribution = (2.0 + inverse) * pow(max(1.0 - n_h * n_h, 0.0), 0.5 * inverse) / (2.0 * kPi);
  float lambdas = sheen_lambda(min(n_v, 1.0), alpha) + sheen_lambda(min(n_l, 1.0), alpha);
  float lobe = distribution / ((1.0 + lambdas) * 4.0 * n_v) / max(sheen.albedo, 1.0);
  float most = max(sheen.albedo, tabled(min(n_l, 1.0), sheen.roughness).z);
  return sheen.color * lobe * irradiance + below * (1.0 - greatest(sheen.color) * min(most, 1.0));
}

// Fraction of the light from below that sheen transmits towards the viewer.
float left_by_sheen(Sheen sheen) { return kSheen ? 1.0 - greatest(sheen.color) * min(sheen.albedo, 1.0) : 1.0; }

// Ambient light on sheen and on the layers below. Fibres gather it from the hemisphere.
// in   visibility  fraction of ambient light that arrives at the fibres; `below` already includes it
vec3 under_sheen(Sheen sheen, Surface s, vec3 below, float visibility) {
  if (!kSheen) return below;
  vec3 arriving_light = diffuse_light(frame.environment_from_view * s.n);
  return sheen.color * min(sheen.albedo, 1.0) * arriving_light * visibility + below * left_by_sheen(sheen);
}

struct Coat {
  vec3 n;
  float roughness;
  float share;   // fraction of light reflected by the coat, which the surface below does not get
};

// eq   KHR_materials_clearcoat: share = clearcoat * (0.04 + 0.96 (1 - |n.v|)^5); (1 - share) * below + share * GGX
Coat coat_at(vec3 geometry_normal, vec3 to_viewer) {
  Coat coat = Coat(geometry_normal, 1.0, 0.0);
  if (!kClearcoat) return coat;
  coat.share = material.clearcoat;
  coat.roughness = material.clearcoat_roughness;
  if (kClearcoatTexture != 0) coat.share *= layer_texel(kClearcoatTexture, 7, texcoords).r;
  if (kClearcoatRoughnessTexture != 0) coat.roughness *= layer_texel(kClearcoatRoughnessTexture, 8, texcoords).g;
  if (kClearcoatNormalTexture != 0) {
    vec3 texel = layer_texel(kClearcoatNormalTexture, 9, texcoords).xyz;
    coat.n = mapped_normal(geometry_normal, texel, material.clearcoat_normal_scale, 1 + (kClearcoatNormalTexture - 1) % 2);
  }
  coat.roughness = clamp(coat.roughness, kLeastRoughness, 1.0);
  float away = 1.0 - min(abs(dot(coat.n, to_viewer)), 1.0);
  coat.share *= 0.04 + 0.96 * away * away * away * away * away;
  return coat;
}

// Direct light on the coat and on the surface below.
vec3 coated(Coat coat, vec3 below, vec3 to_viewer, vec3 to_light, vec3 irradiance) {
  if (!kClearcoat) return below;
  return mix(below, ggx(coat.n, to_viewer, to_light, coat.roughness) * irradiance, coat.share);
}

// Ambient light on the coat and on the surface below. Fresnel is part of `share`, so the lobe has reflectance 1.
// in   visibility  fraction of light that arrives at the coat; `below` already includes it
//      surroundings  hemisphere light that occluders reflect in place of the hidden part
vec3 coated(Coat coat, vec3 below, vec3 to_viewer, float visibility, vec3 surroundings) {
  if (!kClearcoat) return below;
  vec2 sums = split_sums(clamp(dot(coat.n, to_viewer), 0.0, 1.0), coat.roughness);
  float once = sums.x + sums.y;
  vec3 direction = frame.environment_from_view * reflect(-to_viewer, coat.n);
  vec3 around = diffuse_light(frame.environment_from_view * coat.n);
  vec3 lobe = mirrored_light(direction, coat.roughness) * once + around * (1.0 - once);
  return mix(below, lobe * visibility + around * surroundings, coat.share);
}
