#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Texture reads and dFdx need the neighbours in a 2 x 2 pixel quad. They happen in control flow that is uniform over a
// draw, and before any discard; otherwise their values are undefined.
//
// Centroid: with multisampling the pixel center may lie outside the triangle, where normals and colours would be
// extrapolated. Position and texture coordinates are not centroid, because their derivatives need a regular pixel grid.
layout(location = 0) in vec3 view_position;
layout(location = 1) centroid in vec3 view_normal;
layout(location = 2) centroid in vec4 view_tangent;
layout(location = 3) in vec4 texcoords;
layout(location = 4) centroid in vec4 vertex_color;
layout(location = 5) centroid in float vertex_visibility;

#include "frame_uniforms.glsl"
#include "geometry.glsl"
#include "material.glsl"
#include "surface_normal.glsl"
#include "view_position.glsl"
#include "octahedral.glsl"
#include "same_surface.glsl"
#include "ambient_visibility.glsl"
#include "lighting.glsl"
#include "mirrored_visibility.glsl"
#include "shadow.glsl"
#include "normal_map.glsl"

// Step of drawing a transmissive surface (enum Through in viewer/passes/pipeline_keys.h).
const int kOpaque = 0, kFilter = 1, kFilterDrawn = 2, kBlurredBackdrop = 3, kSharpBackdrop = 4, kLightAlone = 5;
const int kErase = 6, kFrosted = 7, kFrostedBlurred = 8, kFrostedSharp = 9;
layout(constant_id = 27) const int kThrough = kOpaque;

const bool kShowsFrosted = kThrough == kFrosted || kThrough == kFrostedBlurred || kThrough == kFrostedSharp;
const bool kOwnLight = kThrough == kOpaque || kThrough == kLightAlone || kShowsFrosted;

#include "layers.glsl"
#include "volume.glsl"

layout(constant_id = 0) const bool kMasked = false;      // do the alpha test, if no prepass did it
layout(constant_id = 1) const bool kBlended = false;  // coverage from alpha; no ambient visibility image covers these
layout(constant_id = 13) const int kLightCount = 1;
layout(constant_id = 20) const bool kVertexVisibility = false;   // ambient visibility is a vertex attribute
layout(constant_id = 15) const bool kAmbient = true;     // environment light is present
layout(constant_id = 18) const bool kUnlitImage = false; // an image for display colours without tone curve exists

#include "frosted.glsl"

const bool kHidden = kOccluded || kVertexVisibility || kOcclusionSet != 0;   // ambient light may be occluded

const float kMostLight = 65504.0;   // largest half float: beyond it drivers store infinity, which later gives NaN

layout(location = 0) out vec4 color;   // premultiplied light, and coverage of all surfaces
layout(location = 1) out vec4 unlit;   // display colours and coverage of unlit surfaces
#include "weighted_output.glsl"

// out  through  fraction of emitted light that the coat transmits
vec3 lit(vec3 base_color, vec3 geometry_normal, out float through, out Passed behind) {
  Surface s;
  s.base_color = base_color;
  s.metallic = material.metallic;
  s.roughness = material.roughness;
  if (kMetallicRoughnessSet != 0) {
    vec4 texel = filtered_texel(metallic_roughness_texture, 1, transformed_uv(1, kMetallicRoughnessSet, texcoords));
    s.metallic *= texel.b;
    s.roughness *= texel.g;
  }
  if (kGlossiness) s.roughness = 1.0 - (1.0 - s.roughness) * layer_texel(kSpecularColorTexture, 6, texcoords).a;
  behind = Passed(vec3(0.0), clamp(s.roughness, 0.0, 1.0), view_position);
  s.roughness = max(behind.frost, kLeastRoughness);
  set_specular(s);
  set_transmission(s);
  s.n = with_normal_map(geometry_normal);
  s.to_viewer = towards_viewer(view_position);
  set_film(s);
  set_anisotropy(s, geometry_normal);
  Surface around = with_film(s);
  vec2 bend;
  float open = ambient_visibility(ivec2(gl_FragCoord.xy), view_position, s.n, bend);
  if (kVertexVisibility) open = vertex_visibility;
  float baked = 1.0;
  if (kOcclusionSet != 0) {
    float texel = filtered_texel(occlusion_texture, 3, transformed_uv(3, kOcclusionSet, texcoords)).r;
    baked += material.occlusion_strength * (texel - 1.0);
  }
  float visibility = open * baked;
  Sheen sheen = sheen_at(s);
  Coat coat = coat_at(geometry_normal, s.to_viewer);
  through = 1.0 - coat.share;
  vec3 sum = vec3(0.0);
  if (kThrough != kOpaque && kThrough != kLightAlone) {
    behind.share = transmitted(around) * left_by_sheen(sheen) * through;
    pass_volume(s.n, s.to_viewer, behind);
  }
  if (!kOwnLight) return sum;
  if (kAmbient) {
    vec3 scattered = kHidden ? scattered_visibility(visibility, s.base_color * (1.0 - s.metallic)) : vec3(1.0);
    float mirrored = mirrored_visibility(open, bend, s.n, s.to_viewer, s.roughness);
    vec3 surroundings = mirrored_surroundings(visibility, mirrored, s.base_color);
    vec3 below = under_sheen(sheen, s, ambient(around, scattered, mirrored * baked, surroundings), visibility);
    float on_coat = kClearcoat ? mirrored_visibility(open, bend, coat.n, s.to_viewer, coat.roughness) : 1.0;
    surroundings = mirrored_surroundings(visibility, on_coat, s.base_color);
    sum += coated(coat, below, s.to_viewer, on_coat * baked, surroundings);
  }
  for (int i = 0; i < kLightCount; ++i) {
    vec3 to_light, irradiance = arriving(frame.lights[i], view_position, to_light);
    vec3 below = under_sheen(sheen, s, reflected(s, to_light, irradiance), to_light, irradiance);
    vec3 light = coated(coat, below, s.to_viewer, to_light, irradiance);
    if (casts_shadows(i)) light *= light_share(i, view_position, geometry_normal, frame.lights[i].to_light);
    sum += light;
  }
  return sum;
}

// Outputs one step of a transmissive surface. viewer/device/pipeline.h has the blending of each step.
// in   behind  from lit();   light  of the surface itself;   coverage  from alpha
void show_through(Passed passed, vec3 light, float coverage) {
  vec3 behind = passed.share;
  unlit = vec4(0.0);
  if (kThrough == kLightAlone) {
    color = vec4(min(light, vec3(kMostLight)) * coverage, 0.0);
  } else if (kThrough == kErase) {
    color = unlit = vec4(vec3(0.0), coverage);
  } else if (kShowsFrosted) {
    vec4 seen = frosted_light(passed), seen_unlit = frosted_unlit(passed);
    float most = greatest(behind);
    color = vec4(min(light + behind * seen.rgb, vec3(kMostLight)), 1.0 - most * (1.0 - seen.a)) * coverage;
    unlit = vec4(behind * seen_unlit.rgb, most * seen_unlit.a) * coverage;
  } else if (kThrough == kFilter || kThrough == kFilterDrawn) {
    vec3 filtered = 1.0 - coverage + coverage * behind;
    float hidden = 1.0 - greatest(filtered);
    unlit = vec4(filtered, hidden);
    color = vec4(filtered, kThrough == kFilter ? hidden : 0.0);
  } else {
    float level = kThrough == kBlurredBackdrop ? kBlurredLevel : 0.0;
    vec3 direction = frame.environment_from_view * -towards_viewer(view_position);
    vec3 arriving_light = textureLod(environment_image, direction, level).rgb * frame.backdrop_intensity;
    color = vec4(min(arriving_light * behind, vec3(kMostLight)) * coverage, coverage);
  }
}

void main() {
  vec4 base = base_color_at(texcoords, vertex_color);
  vec3 n = surface_normal(view_normal, view_position);
  vec3 light = base.rgb;
  Passed behind = Passed(vec3(0.0), 0.0, view_position);
  if (!kUnlit) {
    float through = 1.0;
    if (kNormals != 0) {
      float share;
      Passed passed;
      vec3 shaded = lit(base.rgb, n, share, passed);
      behind.frost = passed.frost;
      if (n != vec3(0.0)) {
        light = shaded;
        through = share;
        behind = passed;
      }
    }
    vec3 emitted = material.emissive;
    if (kEmissiveSet != 0)
      emitted *= filtered_texel(emissive_texture, 4, transformed_uv(4, kEmissiveSet, texcoords)).rgb;
    light += emitted * through;
  }
  float coverage = kBlended ? clamp(base.a, 0.0, 1.0) : 1.0;
  if (kThrough != kOpaque) {
    show_through(behind, light, coverage);
  } else if (kUnlit) {
    unlit = vec4(clamp(light, 0.0, 1.0) * coverage, coverage);
    color = vec4(vec3(0.0), coverage);
  } else {
    // Blended surfaces cover unlit colours behind them and add none.
    unlit = vec4(vec3(0.0), kBlended ? coverage : 0.0);
    color = vec4(min(light, vec3(kMostLight)) * coverage, coverage);
  }
  if (kWeighted) weigh(-view_position.z, coverage, kUnlit);
  if (kMasked && is_cut(base.a)) discard;
}
