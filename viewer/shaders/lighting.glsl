// SPDX-License-Identifier: MIT
// Direct and ambient light on a metallic-roughness surface.
// eq   glTF 2.0, Appendix B: mix(dielectric, metal, metallic); the dielectric is Lambert under a Fresnel layer of GGX with
//      height-correlated Smith visibility

const float kPi = 3.14159265358979;

struct Surface {
  vec3 base_color;
  float metallic, roughness;
  vec3 n, to_viewer;
};

vec3 reflected(Surface s, vec3 to_light, vec3 irradiance) {
  float n_l = dot(s.n, to_light);
  if (n_l <= 0.0) return vec3(0.0);
  float n_v = max(dot(s.n, s.to_viewer), 1e-4);
  vec3 middle = normalize(to_light + s.to_viewer);
  float n_h = clamp(dot(s.n, middle), 0.0, 1.0), v_h = clamp(dot(s.to_viewer, middle), 0.0, 1.0);
  float alpha = s.roughness * s.roughness, alpha2 = alpha * alpha;
  float d = n_h * n_h * (alpha2 - 1.0) + 1.0;
  float distribution = alpha2 / (kPi * d * d);
  float smith = n_l * sqrt(n_v * n_v * (1.0 - alpha2) + alpha2) + n_v * sqrt(n_l * n_l * (1.0 - alpha2) + alpha2);
  vec3 f0 = mix(vec3(0.04), s.base_color, s.metallic);
  float away = 1.0 - v_h, edge = away * away * away * away * away;
  vec3 fresnel = f0 + (1.0 - f0) * edge;
  vec3 diffuse = (1.0 - 0.04) * (1.0 - edge) * (1.0 - s.metallic) * s.base_color / kPi;
  return (diffuse + fresnel * distribution * 0.5 / smith) * n_l * irradiance;
}

// eq   KHR_lights_punctual: inverse square with a smooth end at the range, and a smooth edge of the cone of a spot light
// The kind and the range of the light select values, not branches, because they are uniforms (surface_features.glsl).
vec3 from_light(Light light, Surface s, vec3 p) {
  vec3 towards = light.position - p;
  float d2 = max(dot(towards, towards), 1e-8), d = sqrt(d2);
  vec3 to_point = towards / d;
  float part = d / light.range_m;
  float within = mix(1.0, clamp(1.0 - part * part * part * part, 0.0, 1.0), light.range_m > 0.0);
  float edge = clamp((dot(light.to_light, to_point) - light.cos_outer) * light.inverse_cone_width, 0.0, 1.0);
  float cone = mix(1.0, edge * edge, light.kind == 2u);
  bool directional = light.kind == 0u;
  vec3 to_light = mix(to_point, light.to_light, bvec3(directional));
  return reflected(s, to_light, light.color * mix(1.0 / d2 * within * cone, 1.0, directional));
}

vec3 hemisphere(vec3 direction) { return mix(frame.ground.rgb, frame.sky.rgb, 0.5 + 0.5 * dot(direction, frame.up.xyz)); }

// Ambient light. The specular part uses the fit of Karis ("Physically Based Shading on Mobile", 2014) and the light from
// the mirror direction.
vec3 ambient(Surface s) {
  float n_v = clamp(dot(s.n, s.to_viewer), 0.0, 1.0);
  vec4 r = s.roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float a = min(r.x * r.x, exp2(-9.28 * n_v)) * r.x + r.y;
  vec2 fit = vec2(-1.04, 1.04) * a + r.zw;
  vec3 f0 = mix(vec3(0.04), s.base_color, s.metallic);
  vec3 diffuse = hemisphere(s.n) * s.base_color * (1.0 - s.metallic);
  return diffuse * (1.0 - 0.04) + hemisphere(reflect(-s.to_viewer, s.n)) * (f0 * fit.x + fit.y);
}
