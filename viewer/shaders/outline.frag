#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Black lines at silhouettes (the surface ends in front of something farther) and at creases (normals change).
// eq   Saito and Takahashi, "Comprehensible Rendering of 3-D Shapes" (1990): lines where the second difference of depth
//      is large. 1 / distance is linear in screen space on a plane, so planes have no lines
//
// The triangle has depth 0 and the depth test is LESS, so with multisampling only samples on surfaces get the line.
#include "frame_uniforms.glsl"
#include "view_position.glsl"

const float kGapStart = 4.0, kGapFull = 8.0;         // depth gap in pixels: line starts, full line
const float kCreaseStart = 0.87, kCreaseFull = 0.7;  // cosine between neighbouring normals
const float kNothing = 1e30;                         // distance used where nothing is drawn

layout(location = 0) out vec4 color;
layout(location = 1) out vec4 unlit;

vec3 normal_at(ivec2 pixel) { return texelFetch(normal_image, pixel, 0).xyz; }

// Mean distance of two opposite neighbours behind the surface, in metres; 0 on a plane.
float gap(float near_m, float a, float b) {
  if (kParallel) return 0.5 * ((a > 0.0 ? a : kNothing) + (b > 0.0 ? b : kNothing)) - near_m;
  vec2 inverse = vec2(a > 0.0 ? 1.0 / a : 0.0, b > 0.0 ? 1.0 / b : 0.0);
  return near_m * (1.0 - 0.5 * near_m * (inverse.x + inverse.y));
}

float crease(vec3 n, ivec2 other) {
  vec3 m = normal_at(other);
  return m == vec3(0.0) ? 0.0 : 1.0 - smoothstep(kCreaseFull, kCreaseStart, dot(n, normalize(m)));
}

// Line strength from the two neighbours along `step`; 0 at the border of the picture.
float line_along(ivec2 pixel, ivec2 step, vec3 n, float distance) {
  ivec2 before = pixel - step, behind = pixel + step;
  if (any(lessThan(before, ivec2(0))) || any(greaterThanEqual(behind, textureSize(depth_image, 0)))) return 0.0;
  float behind_m = gap(distance, distance_at(before), distance_at(behind));
  float silhouette = smoothstep(kGapStart, kGapFull, 2.0 * behind_m * pixels_per_metre(distance));
  return max(silhouette, max(crease(n, before), crease(n, behind)));
}

// For a pixel whose center is empty: with multisampling, some of its samples may lie on a neighbouring surface.
float line_beside(ivec2 pixel) {
  ivec2 last = textureSize(depth_image, 0) - 1;
  vec3 sum = vec3(0.0);
  sum += abs(normal_at(max(pixel - ivec2(1, 0), ivec2(0)))) + abs(normal_at(min(pixel + ivec2(1, 0), last)));
  sum += abs(normal_at(max(pixel - ivec2(0, 1), ivec2(0)))) + abs(normal_at(min(pixel + ivec2(0, 1), last)));
  return sum == vec3(0.0) ? 0.0 : 1.0;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float distance = distance_at(pixel);
  vec3 n = normal_at(pixel);
  float line = 0.0;
  // Loops, because software drivers execute both sides of a branch.
  for (int once = 0; once < int(distance == 0.0); ++once) line = line_beside(pixel);
  for (int once = 0; once < int(distance > 0.0 && n != vec3(0.0)); ++once) {
    n = normalize(n);
    line = max(line_along(pixel, ivec2(1, 0), n, distance), line_along(pixel, ivec2(0, 1), n, distance));
  }
  color = unlit = vec4(vec3(0.0), line);
}
