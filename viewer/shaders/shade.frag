#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Opaque and transparent surfaces. Ambient occlusion scales the ambient term only.
// Textures and dFdx are read where all pixels of a draw come by, and nothing is discarded before: what they take from the
// neighbours in a quad is undefined otherwise.
#include "frame_uniforms.glsl"
#include "geometry.glsl"
#include "material.glsl"
#include "surface_normal.glsl"
#include "view_position.glsl"
#include "octahedral.glsl"
#include "same_surface.glsl"
#include "ambient_access.glsl"
#include "lighting.glsl"

layout(constant_id = 0) const bool kMasked = false;      // the alpha test, when no prepass did it
layout(constant_id = 1) const bool kBlended = false;     // coverage from alpha; there is no ambient access for these
layout(constant_id = 2) const bool kOccluded = false;    // the ambient-access image exists

const float kMostLight = 65504.0;   // of a half float; beyond it drivers store infinity, and 0 times that is no light

layout(location = 0) in vec3 view_position;
layout(location = 1) in vec3 view_normal;
layout(location = 2) in vec4 view_tangent;
layout(location = 3) in vec4 texcoords;
layout(location = 4) in vec4 vertex_color;

layout(location = 0) out vec4 color;   // premultiplied

// Where the relief's right and up point on the surface; false when nothing tells.
bool stored_frame(vec3 n, out vec3 t, out vec3 b) {
  t = view_tangent.xyz - n * dot(n, view_tangent.xyz);
  if (dot(t, t) == 0.0) return false;
  t = normalize(t);
  // On back faces n is turned round; t and the handedness turn with it, so that the relief keeps its direction.
  float turn = gl_FrontFacing == ((draw.flags & kMirrored) == 0u) ? 1.0 : -1.0;
  b = cross(n, t) * view_tangent.w * turn;
  return true;
}

// The same of a mesh without tangents, from how position and texture coordinate change over the screen; v points down.
// eq   Schueler, "Followup: Normal Mapping Without Precomputed Tangents" (2013)
bool derived_frame(vec3 n, out vec3 t, out vec3 b) {
  vec3 dx = dFdx(view_position), dy = dFdy(view_position);
  vec2 uv = set_of(2, texcoords), uv_x = dFdx(uv), uv_y = dFdy(uv);
  vec3 across_y = cross(dy, n), across_x = cross(n, dx);
  float side = sign(dot(dx, across_y));
  t = side * (across_y * uv_x.x + across_x * uv_y.x);
  b = -side * (across_y * uv_x.y + across_x * uv_y.y);
  float longest = max(dot(t, t), dot(b, b));
  if (longest == 0.0) return false;
  t *= inversesqrt(longest);
  b *= inversesqrt(longest);
  return true;
}

vec3 mapped_normal(vec3 n) {
  if (!has_texture(2)) return n;
  vec3 relief = texture(normal_texture, texcoord_of(2, texcoords)).xyz * 2.0 - 1.0;
  vec3 t, b;
  if (!((draw.flags & kHasTangents) != 0u ? stored_frame(n, t, b) : derived_frame(n, t, b))) return n;
  return normalize(t * relief.x * material.surface.z + b * relief.y * material.surface.z + n * relief.z);
}

vec3 lit(vec3 base_color, vec3 geometry_normal) {
  Surface s;
  s.base_color = base_color;
  s.metallic = material.surface.x;
  s.roughness = material.surface.y;
  if (has_texture(1)) {
    vec4 texel = texture(metallic_roughness_texture, texcoord_of(1, texcoords));
    s.metallic *= texel.b;
    s.roughness *= texel.g;
  }
  s.roughness = clamp(s.roughness, 0.045, 1.0);   // keeps the highlight of a mirror visible and finite
  s.n = mapped_normal(geometry_normal);
  s.to_viewer = towards_viewer(view_position);
  float open = kOccluded ? ambient_access(ivec2(gl_FragCoord.xy), view_position, geometry_normal) : 1.0;
  if (has_texture(3)) {
    float baked = texture(occlusion_texture, texcoord_of(3, texcoords)).r;
    open *= 1.0 + material.surface.w * (baked - 1.0);
  }
  vec3 sum = ambient(s) * open;
  for (int i = 0; i < int(frame.output_range.w); ++i) sum += from_light(frame.lights[i], s, view_position);
  return sum;
}

void main() {
  vec4 base = base_color_at(texcoords, vertex_color);
  vec3 n = surface_normal(view_normal, view_position);
  vec3 light = base.rgb;
  if (material.kind.x == 0.0) {
    if ((draw.flags & (kFlatNormals | kHasNormals)) != 0u) {
      vec3 shaded = lit(base.rgb, n);
      if (n != vec3(0.0)) light = shaded;
    }
    vec3 glow = material.emissive.rgb;
    if (has_texture(4)) glow *= texture(emissive_texture, texcoord_of(4, texcoords)).rgb;
    light += glow;
  }
  float coverage = kBlended ? clamp(base.a, 0.0, 1.0) : 1.0;
  color = vec4(min(light, vec3(kMostLight)) * coverage, coverage);
  if (kMasked && base.a < material.emissive.w) discard;
}
