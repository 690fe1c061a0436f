#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Shades opaque and transparent surfaces. Ambient occlusion scales the ambient term only.
// Textures and dFdx use the neighbours in a quad of pixels. They are read in control flow that all pixels of a draw share,
// and before any discard: otherwise their values are undefined.
#include "frame_uniforms.glsl"
#include "geometry.glsl"
#include "material.glsl"
#include "surface_normal.glsl"
#include "view_position.glsl"
#include "octahedral.glsl"
#include "same_surface.glsl"
#include "ambient_access.glsl"
#include "lighting.glsl"
#include "shadow.glsl"

layout(constant_id = 0) const bool kMasked = false;      // the alpha test, when no prepass did it
layout(constant_id = 1) const bool kBlended = false;     // coverage from alpha; there is no ambient access for these
layout(constant_id = 13) const int kLightCount = 1;
layout(constant_id = 17) const int kShadowLight = -1;    // index of the light that casts shadows, -1 = none
layout(constant_id = 20) const bool kVertexAccess = false;   // vertices bring their ambient access
layout(constant_id = 15) const bool kAmbient = true;     // there is an environment

const float kMostLight = 65504.0;   // largest half float: beyond it drivers store infinity, which later gives NaN

layout(location = 0) in vec3 view_position;
layout(location = 1) in vec3 view_normal;
layout(location = 2) in vec4 view_tangent;
layout(location = 3) in vec4 texcoords;
layout(location = 4) in vec4 vertex_color;
layout(location = 5) in float vertex_access;

layout(location = 0) out vec4 color;   // premultiplied light, and coverage of all surfaces
layout(location = 1) out vec4 unlit;   // the same of unlit surfaces alone, for the image of such a frame

// Tangent and bitangent of the normal map, from the tangents of the mesh; false if the tangent has no direction.
bool stored_frame(vec3 n, out vec3 t, out vec3 b) {
  t = view_tangent.xyz - n * dot(n, view_tangent.xyz);
  if (dot(t, t) == 0.0) return false;
  t = normalize(t);
  // On back faces n is reversed; the bitangent must not change then.
  float side = gl_FrontFacing ? draw.handedness : -draw.handedness;
  b = cross(n, t) * view_tangent.w * side;
  return true;
}

// The same for a mesh without tangents, from screen-space derivatives, as stored tangents would have it: the tangent lies
// along u, and the bitangent is perpendicular to it on the side where v falls.
// eq   [dP/dx, dP/dy] = [dP/du, dP/dv] * [duv/dx, duv/dy]
bool derived_frame(vec3 n, out vec3 t, out vec3 b) {
  vec3 dx = dFdx(view_position), dy = dFdy(view_position);
  vec2 uv = uv_of_set(kNormalSet, texcoords), uv_x = dFdx(uv), uv_y = dFdy(uv);
  float side = sign(uv_x.x * uv_y.y - uv_y.x * uv_x.y);
  vec3 along_u = side * (dx * uv_y.y - dy * uv_x.y), along_v = side * (dy * uv_x.x - dx * uv_y.x);
  t = along_u - n * dot(n, along_u);
  if (dot(t, t) == 0.0) return false;
  t = normalize(t);
  b = cross(n, t);
  if (dot(b, along_v) > 0.0) b = -b;
  return true;
}

vec3 mapped_normal(vec3 n) {
  if (kNormalSet == 0) return n;
  vec3 relief = texture(normal_texture, transformed_uv(2, kNormalSet, texcoords)).xyz * 2.0 - 1.0;
  vec3 t, b;
  bool found;
  if (kTangents) found = stored_frame(n, t, b);
  else found = derived_frame(n, t, b);
  if (!found) return n;
  if (!gl_FrontFacing) relief.xy = -relief.xy;   // n is reversed already: a bump of the front is a dent of the back
  return normalize(t * relief.x * material.normal_scale + b * relief.y * material.normal_scale + n * relief.z);
}

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

vec3 lit(vec3 base_color, vec3 geometry_normal) {
  Surface s;
  s.base_color = base_color;
  s.metallic = material.metallic;
  s.roughness = material.roughness;
  if (kMetallicRoughnessSet != 0) {
    vec4 texel = texture(metallic_roughness_texture, transformed_uv(1, kMetallicRoughnessSet, texcoords));
    s.metallic *= texel.b;
    s.roughness *= texel.g;
  }
  s.roughness = clamp(s.roughness, 0.045, 1.0);   // keeps the highlight of a mirror visible and finite
  set_specular(s);
  s.n = mapped_normal(geometry_normal);
  s.to_viewer = towards_viewer(view_position);
  float access = ambient_access(ivec2(gl_FragCoord.xy), view_position, geometry_normal);
  if (kVertexAccess) access = clamp(vertex_access, 0.0, 1.0);   // at edges it is interpolated beyond the triangle
  if (kOcclusionSet != 0) {
    float baked = texture(occlusion_texture, transformed_uv(3, kOcclusionSet, texcoords)).r;
    access *= 1.0 + material.occlusion_strength * (baked - 1.0);
  }
  vec3 sum = vec3(0.0);
  if (kAmbient) sum += ambient(s) * access;
  for (int i = 0; i < kLightCount; ++i) {
    vec3 light = from_light(frame.lights[i], s, view_position);
    if (i == kShadowLight) light *= light_share(view_position, geometry_normal, frame.lights[i].to_light);
    sum += light;
  }
  return sum;
}

void main() {
  vec4 base = base_color_at(texcoords, vertex_color);
  vec3 n = surface_normal(view_normal, view_position);
  vec3 light = base.rgb;
  if (!kUnlit) {
    if (kNormals != 0) {
      vec3 shaded = lit(base.rgb, n);
      if (n != vec3(0.0)) light = shaded;
    }
    vec3 emitted = material.emissive;
    if (kEmissiveSet != 0) emitted *= texture(emissive_texture, transformed_uv(4, kEmissiveSet, texcoords)).rgb;
    light += emitted;
  }
  float coverage = kBlended ? clamp(base.a, 0.0, 1.0) : 1.0;
  if (kUnlit) {
    unlit = vec4(clamp(light, 0.0, 1.0) * coverage, coverage);
    color = vec4(vec3(0.0), coverage);
  } else {
    unlit = vec4(vec3(0.0), kBlended ? coverage : 0.0);   // blending covers what is behind, and adds nothing
    color = vec4(min(light, vec3(kMostLight)) * coverage, coverage);
  }
  if (kMasked && is_cut(base.a)) discard;
}
