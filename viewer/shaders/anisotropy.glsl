// SPDX-License-Identifier: MIT
// KHR_materials_anisotropy: a highlight stretched along a direction of the surface.
// eq   roughness along the direction alpha_t = mix(alpha, 1, strength^2), across it alpha_b = alpha

layout(constant_id = 29) const bool kAnisotropy = false;

// D V n.l of anisotropic GGX.
// eq   D = 1 / (pi a b ((t.h / a)^2 + (b.h / b)^2 + n.h^2)^2);
//      V = 0.5 / (n.l |(a t.v, b b.v, n.v)| + n.v |(a t.l, b b.l, n.l)|)
float lobe(Surface s, vec3 to_light) {
  if (!kAnisotropy) return ggx(s.n, s.to_viewer, to_light, s.roughness);
  float n_l = dot(s.n, to_light);
  if (n_l <= 0.0) return 0.0;
  float n_v = max(dot(s.n, s.to_viewer), 1e-4);
  vec3 across = cross(s.n, s.along), h = normalize(to_light + s.to_viewer);
  float alpha = s.roughness * s.roughness;
  vec2 alphas = vec2(mix(alpha, 1.0, s.anisotropy * s.anisotropy), alpha);
  vec3 scaled = vec3(vec2(dot(s.along, h), dot(across, h)) / alphas, dot(s.n, h));
  float d = dot(scaled, scaled), distribution = 1.0 / (kPi * alphas.x * alphas.y * d * d);
  float view = length(vec3(alphas * vec2(dot(s.along, s.to_viewer), dot(across, s.to_viewer)), n_v));
  float light = length(vec3(alphas * vec2(dot(s.along, to_light), dot(across, to_light)), n_l));
  return distribution * 0.5 / (n_l * view + n_v * light) * n_l;
}

// The normal about which the environment is mirrored. With more stretch and less roughness it turns towards the plane of
// the viewer and the direction across.
vec3 mirror_normal(Surface s) {
  if (!kAnisotropy) return s.n;
  vec3 across = cross(s.n, s.along), bent = cross(cross(across, s.to_viewer), across);
  float left = 1.0 - s.anisotropy * (1.0 - s.roughness), left2 = left * left;
  return normalize(mix(bent, s.n, left2 * left2));
}
