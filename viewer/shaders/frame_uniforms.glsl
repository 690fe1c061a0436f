// SPDX-License-Identifier: MIT
// What all passes of a frame share; mirrors viewer/passes/frame_uniforms.h.

struct Light {
  vec4 position_kind;        // view space; w: 0 directional, 1 point, 2 spot
  vec4 to_light_range;       // directional and spot: unit vector against the light's direction; w: range, 0 = endless
  vec4 color;                // linear, times intensity
  vec4 cone;                 // cos(outer), 1 / (cos(inner) - cos(outer))
};

layout(set = 0, binding = 0, std140) uniform Frame {
  vec4 projection;           // clip x and y = these * view x and y; clip z = third + fourth * view z
  vec4 lens;                 // near, pixels per metre (of a perspective: at distance 1), 1 = parallel
  vec4 occlusion;            // radius, surface epsilon, fade start, fade end
  vec4 occlusion_use;        // power, 1 = on
  vec4 sky;                  // ambient radiance from above
  vec4 ground;               // and from below
  vec4 up;                   // world +y in view space
  vec4 background;           // linear, as displayed; w: 1 = transparent background
  vec4 output_range;         // exposure, nearest and farthest shown depth, light count
  vec4 offsets[64];          // of the occlusion samples, random lengths; as many as there are samples
  vec4 noise[16];            // unit vectors, one per pixel of a 4 x 4 tile
  Light lights[16];
} frame;

layout(set = 0, binding = 1) uniform sampler2D depth_image;      // near / distance, 0 = nothing
layout(set = 0, binding = 2) uniform sampler2D normal_image;     // view space, zero = surface without normal
layout(set = 0, binding = 3) uniform sampler2D ao_image;     // half size: ambient access, distance, packed normal
layout(set = 0, binding = 4) uniform sampler2D color_image;      // linear, premultiplied
