// SPDX-License-Identifier: MIT
// What all passes of a frame share; mirrors viewer/passes/frame_uniforms.h.

const float kBlurredLevel = 3.5;   // of the environment, where it is shown blurred behind the scene

struct Light {
  vec3 position;              // view space
  uint kind;                  // 0 directional, 1 point, 2 spot
  vec3 to_light;              // directional and spot: unit vector against the direction of the light
  float range_m;              // 0 = unlimited
  vec3 color;                 // linear, times intensity
  float cos_outer;            // of the cone of a spot light
  float inverse_cone_width;   // 1 / (cos(inner) - cos(outer))
};

struct ShadowMap {            // (viewer/passes/shadow_view.h)
  vec4 from_view[4];          // rows x, y, z, w
  float texel_m;              // where w is 1
};

layout(set = 0, binding = 0, std140) uniform Frame {
  vec4 projection;            // clip x and y = these * view x and y; clip z = third + fourth * view z
  float near_m;
  float pixels_per_metre;     // of a perspective: at distance 1
  float exposure;
  float occlusion_power;
  float occlusion_radius_m;
  float surface_epsilon_m;    // smaller differences of depth are the surface itself
  float fade_start_m;
  float fade_end_m;
  float nearest_shown_m;      // range of the depth picture
  float farthest_shown_m;
  float environment_intensity;
  mat3 environment_from_view;
  vec4 diffuse_light[9];      // spherical harmonics of the environment times its intensity (viewer/light/environment.h)
  ShadowMap shadow_maps[4];
  vec3 ground_middle;         // view space
  float ground_radius_m;
  vec3 ground_x;              // x and z of the world in view space
  float ground_grid_step_m;
  vec3 ground_z;
  vec2 ground_grid_offset;    // metres from a corner of the grid to the middle of the ground
  vec2 weighted_range;        // least distance of what blends by weights, and 1 / (most - least)
  vec4 ground_reach;          // least x and z, most x and z of what is drawn, from the middle
  vec4 background;            // linear, as displayed
  vec4 offsets[64];           // of the occlusion samples, random lengths; as many as there are samples
  vec4 noise[16];             // unit vectors, one per pixel of a 4 x 4 tile
  Light lights[16];
} frame;

layout(set = 0, binding = 1) uniform sampler2D depth_image;    // near / distance, 0 = nothing
layout(set = 0, binding = 2) uniform sampler2D normal_image;   // view space, zero = surface without normal
layout(set = 0, binding = 3) uniform sampler2D ao_image;       // half size: ambient access, distance, packed normals (access_texel.glsl)
layout(set = 0, binding = 4) uniform sampler2D color_image;    // linear, premultiplied
layout(set = 0, binding = 5) uniform samplerCube environment_image;   // radiance; level i filtered for roughness i / last
layout(set = 0, binding = 6) uniform sampler2D split_sum_image;       // (viewer/light/split_sum.h)
layout(set = 0, binding = 7) uniform sampler2D shadow_image;          // depths of the lights that cast shadows, in tiles; 1 = near
layout(set = 0, binding = 8) uniform sampler2D unlit_image;           // linear, premultiplied, as displayed; alpha: its share
layout(set = 0, binding = 9) uniform sampler2D exposure_image;        // automatic exposure: one texel, or the sums that it is made of
layout(set = 0, binding = 10) uniform sampler2D weighted_image;       // sums over blended surfaces: weight * coverage * colour, weight * coverage
layout(set = 0, binding = 11) uniform sampler2D weighted_coverage_image;   // of all of them together
layout(set = 0, binding = 12) uniform sampler2D weighted_unlit_image;      // the sums of unlit surfaces alone
layout(set = 0, binding = 13) uniform sampler2D behind_image;              // color_image of what is opaque, with mip levels
layout(set = 0, binding = 14) uniform sampler2D behind_unlit_image;        // the same of unlit_image
