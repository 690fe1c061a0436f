// SPDX-License-Identifier: MIT
// Uniforms and images shared by all passes of a frame; mirrors viewer/passes/frame_uniforms.h.

const float kBlurredLevel = 3.5;   // mip level of the environment for a blurred backdrop

struct Light {
  vec3 position;              // view space
  uint kind;                  // 0 directional, 1 point, 2 spot
  vec3 to_light;              // directional and spot: unit vector towards the light
  float range_m;              // 0 = unlimited
  vec3 color;                 // linear, times intensity
  float cos_outer;            // spot: cosine of the outer cone angle
  float inverse_cone_width;   // 1 / (cos(inner) - cos(outer))
};

struct ShadowMap {            // (viewer/passes/shadow_view.h)
  vec4 from_view[4];          // rows x, y, z, w
  float texel_m;              // size of a texel where w is 1
};

layout(set = 0, binding = 0, std140) uniform Frame {
  vec4 projection;            // clip x, y = xy * view x, y; clip z = z + w * view z
  float near_m;
  float pixels_per_metre;     // perspective: at distance 1
  float exposure;
  float occlusion_power;
  float occlusion_radius_m;
  float surface_epsilon_m;    // smaller depth differences count as the same surface
  float fade_start_m;
  float fade_end_m;
  float nearest_shown_m;      // distance range of the depth picture
  float farthest_shown_m;
  float environment_intensity;
  float backdrop_intensity;   // of the environment where it is seen behind the scene
  mat3 environment_from_view;
  vec4 diffuse_light[9];      // spherical harmonics of the environment times its intensity (viewer/light/environment.h)
  ShadowMap shadow_maps[4];
  vec3 ground_middle;         // view space
  float ground_radius_m;
  vec3 ground_x;              // x and z of the world in view space
  float ground_grid_step_m;
  vec3 ground_z;
  vec2 ground_grid_offset;    // metres from a grid line crossing to the ground's center
  vec2 weighted_range;        // nearest distance of weighted surfaces, and 1 / (farthest - nearest)
  vec4 ground_reach;          // drawn rectangle: min x, min z, max x, max z from the center
  vec4 ground_contact;        // the part of it that ambient occlusion may reach
  vec4 background;            // linear, as displayed
  vec4 offsets[64];           // offsets of the occlusion samples; only the first kSamples are used
  vec4 noise[16];             // unit vectors, one per pixel of a 4 x 4 tile
  Light lights[16];
} frame;

layout(set = 0, binding = 1) uniform sampler2D depth_image;    // near / distance; 0 = nothing drawn
layout(set = 0, binding = 2) uniform sampler2D normal_image;   // view space, zero = surface without normal
layout(set = 0, binding = 3) uniform sampler2D ao_image;       // (visibility_texel.glsl)
layout(set = 0, binding = 4) uniform sampler2D color_image;    // linear, premultiplied
// Radiance; level i is filtered for roughness i / last.
layout(set = 0, binding = 5) uniform samplerCube environment_image;
layout(set = 0, binding = 6) uniform sampler2D split_sum_image;       // (viewer/light/split_sum.h)
layout(set = 0, binding = 7) uniform sampler2D shadow_image;          // shadow maps as tiles; 1 = near
layout(set = 0, binding = 8) uniform sampler2D unlit_image;  // display colours, linear, premultiplied; alpha: coverage
layout(set = 0, binding = 9) uniform sampler2D exposure_image;  // automatic exposure: one texel, or the block sums
// Sums over blended surfaces: rgb = weight * coverage * colour, a = weight * coverage.
layout(set = 0, binding = 10) uniform sampler2D weighted_image;
layout(set = 0, binding = 11) uniform sampler2D weighted_coverage_image;   // combined coverage of the blended surfaces
layout(set = 0, binding = 12) uniform sampler2D weighted_unlit_image;      // the same sums for unlit surfaces only
layout(set = 0, binding = 13) uniform sampler2D behind_image;  // color_image of opaque surfaces, with mip levels
layout(set = 0, binding = 14) uniform sampler2D behind_unlit_image;  // unlit_image of opaque surfaces, with mip levels
