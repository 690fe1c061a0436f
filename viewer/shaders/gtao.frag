#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Horizon-based ambient occlusion, at half size. In each slice through the line of sight, the highest surface within
// the radius on either side limits the arriving light.
// eq   Jimenez, Wu, Pesce and Jarabo, "Practical Realtime Strategies for Accurate Indirect Occlusion" (2016), eqs. 6,
//      7: visibility = 1 - mean over slices of |m| * (cos g + g sin g - sum over both sides of arc(h)) arc(h) = (cos g
//      + 2 h sin g - cos(2 h - g)) / 4;   m = normal projected to the slice, g = its angle to the line of sight, h =
//      horizon angle. cos g + g sin g is the sum for free horizons, so visibility is exactly 1 in each slice if nothing
//      occludes bent normal = direction of 2/3 n - mean over slices of |m| * the part of it hidden by horizons; exactly
//      n if nothing occludes
#include "frame_uniforms.glsl"
#include "view_position.glsl"
#include "octahedral.glsl"
#include "visibility_texel.glsl"

layout(constant_id = 0) const int kSlices = 2;   // OcclusionShape::slices
layout(constant_id = 1) const int kSteps = 6;    // OcclusionShape::steps

const float kPi = 3.14159265358979;
// Least sine of a surface's elevation above the tangent plane. Samples at pixel centers lie beside the slice, so
// without it a steep plane would occlude itself. Lower surfaces hide less than the square of this sine of the light.
const float kLevel = 0.02;
// Relative distances between which an occluder fades out. With a sharp end, a thin occluder can fall between two
// look-ups, and their pattern shows as stripes.
const float kFadeStart = 0.95, kFadeEnd = 1.3;

layout(location = 0) out vec4 visibility_distance_normal;

// Cosine of the angle between the line of sight and the highest surface on one side.
// in   way  vector of the slice, as long as the radius in pixels;   lowest  cosine of a free horizon
float horizon(ivec2 pixel, vec2 way, float jitter, vec3 p, vec3 n, vec3 v, float lowest) {
  ivec2 last = textureSize(depth_image, 0) - 1;
  float highest = lowest, scale = 1.0 / (kFadeEnd - kFadeStart);
  // view_point() without its divisions
  vec2 half_size = 0.5 * vec2(last + 1), slope = vec2(1.0, -1.0) / (half_size * frame.projection.xy);
  for (int i = 0; i < kSteps; ++i) {
    float part = (float(i) + jitter) / float(kSteps);
    vec2 at = way * part * sqrt(part);
    ivec2 there = pixel + ivec2(round(at + normalize(way)));
    if (any(lessThan(there, ivec2(0))) || any(greaterThan(there, last))) continue;
    float far_r = distance_at(there);
    vec2 aside = (vec2(there) + 0.5 - half_size) * slope;
    vec3 to_r = vec3(kParallel ? aside : aside * far_r, -far_r) - p;
    float squared = dot(to_r, to_r), inverse = inversesqrt(max(squared, 1e-30));
    float counts = min(kFadeEnd * scale - squared * inverse * (scale / frame.occlusion_radius_m), 1.0);
    if (far_r == 0.0 || counts <= 0.0) continue;
    vec3 direction = to_r * inverse;
    if (dot(direction, n) > kLevel) highest = max(highest, mix(lowest, dot(direction, v), counts));
  }
  return highest;
}

float arc(float h, float g) { return 0.25 * (cos(g) + 2.0 * h * sin(g) - cos(2.0 * h - g)); }

// Light of a slice between the line of sight and a horizon, as a vector with components along the slice and towards the
// viewer.
// eq   integral of cos(t - g) sin t (sin t, cos t) over t from 0 to h, without the terms that do not depend on h
vec2 light_up_to(float cos_h, float cos_g, float sin_g) {
  float cube = cos_h * cos_h * cos_h / 3.0, sine2 = 1.0 - cos_h * cos_h, sine3 = sine2 * sqrt(max(sine2, 0.0)) / 3.0;
  return vec2(cos_g * sine3 + sin_g * (cube - cos_h), sin_g * sine3 - cos_g * cube);
}

// in,out  hidden  adds the light hidden by horizons, as a vector
float slice_occlusion(ivec2 pixel, float turn, float jitter, float radius_pixels, vec3 p, vec3 n, vec3 v, inout vec3 hidden) {
  vec2 along = vec2(cos(turn), sin(turn));
  vec3 direction = vec3(along.x, -along.y, 0.0);
  vec3 axis = normalize(cross(direction, v));
  vec3 aside = direction - v * dot(direction, v);
  vec3 m = n - axis * dot(n, axis);
  float size = length(m);
  float g = sign(dot(aside, m)) * acos(clamp(dot(m, v) / max(size, 1e-6), -1.0, 1.0));
  float free_ahead = cos(g + 0.5 * kPi), free_behind = cos(g - 0.5 * kPi);
  float cos_ahead = clamp(horizon(pixel, along * radius_pixels, jitter, p, n, v, free_ahead), -1.0, 1.0);
  float cos_behind = clamp(horizon(pixel, -along * radius_pixels, jitter, p, n, v, free_behind), -1.0, 1.0);
  if (kBent) {
    float c = cos(g), s = sin(g);
    vec2 off_ahead = light_up_to(free_ahead, c, s) - light_up_to(cos_ahead, c, s);
    vec2 off_behind = light_up_to(free_behind, c, -s) - light_up_to(cos_behind, c, -s);
    hidden += size * (normalize(aside) * (off_ahead.x - off_behind.x) + v * (off_ahead.y + off_behind.y));
  }
  float ahead = acos(cos_ahead), behind = acos(cos_behind);
  return size * (cos(g) + g * sin(g) - arc(ahead, g) - arc(-behind, g));
}

// The texel of a surface at distance far_p with unit normal n.
vec4 occluded_texel(ivec2 texel, ivec2 pixel, float far_p, vec3 n, float radius_pixels, float resolved) {
  vec3 p = view_point(pixel, far_p);
  vec3 v = towards_viewer(p);
  // A tile of 4 x 4 texels has 16 slice rotations and 4 step offsets; the blur averages them.
  float turn = float((((texel.x + texel.y) & 3) << 2) + (texel.x & 3)) / 16.0;
  float jitter = (float((texel.y - texel.x) & 3) + 0.5) / 4.0;
  float sum = 0.0;
  vec3 hidden = vec3(0.0);
  for (int i = 0; i < kSlices; ++i)
    sum += slice_occlusion(pixel, (float(i) + turn) * kPi / float(kSlices), jitter, radius_pixels, p, n, v, hidden);
  float open = clamp(1.0 - resolved * sum / float(kSlices), 0.0, 1.0), visibility = pow(open, frame.occlusion_power);
  float contrast = (1.0 - visibility) / max(1.0 - open, 1e-6);
  vec3 bent = n - 1.5 * contrast * resolved / float(kSlices) * hidden;
  return visibility_texel(visibility, far_p, n, dot(bent, bent) > 1e-6 ? normalize(bent) : n);
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 pixel = full_pixel(texel);
  float far_p = distance_at(pixel);
  vec3 n = texelFetch(normal_image, pixel, 0).xyz;
  visibility_distance_normal = visibility_texel(1.0, far_p, n, n);
  bool surface = far_p > 0.0 && n != vec3(0.0);
  float radius_pixels = frame.occlusion_radius_m * pixels_per_metre(surface ? far_p : 1.0);
  float resolved = surface ? clamp(radius_pixels - 2.0, 0.0, 1.0) : 0.0;   // fades out where the radius is below 3 pixels
  // A loop, because software drivers execute both sides of a branch.
  for (int once = 0; once < int(resolved > 0.0); ++once) {
    n = normalize(n);
    visibility_distance_normal = occluded_texel(texel, pixel, far_p, n, radius_pixels, resolved);
  }
}
