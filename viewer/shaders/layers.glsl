// SPDX-License-Identifier: MIT
// The layers of a surface. A material without a layer has none of its code: each is a specialisation constant.

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

struct Coat {
  vec3 n;
  float roughness;
  float share;   // of the light that the layer reflects and the surface below does not get
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

// Light of one direction on the layer and on what is below.
vec3 coated(Coat coat, vec3 below, vec3 to_viewer, vec3 to_light, vec3 irradiance) {
  if (!kClearcoat) return below;
  return mix(below, ggx(coat.n, to_viewer, to_light, coat.roughness) * irradiance, coat.share);
}

// Ambient light on the layer and on what is below. Fresnel is in the share, so the lobe reflects all light.
// in   access  share of the light that arrives at the layer; `below` has its own
vec3 coated(Coat coat, vec3 below, vec3 to_viewer, float access) {
  if (!kClearcoat) return below;
  vec2 sums = split_sums(clamp(dot(coat.n, to_viewer), 0.0, 1.0), coat.roughness);
  float once = sums.x + sums.y;
  vec3 direction = frame.environment_from_view * reflect(-to_viewer, coat.n);
  vec3 lobe = mirrored_light(direction, coat.roughness) * once +
              diffuse_light(frame.environment_from_view * coat.n) * (1.0 - once);
  return mix(below, lobe * access, coat.share);
}
