#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Screen-space ambient occlusion, at half size. Random points around a surface point p with normal n are looked up in
// the depth image; r is the surface point found there.
// eq   occlusion = sum over N samples of fade(distance(p) - distance(r)) * max(n . normalise(r - p), 0) / N
//      visibility = (1 - occlusion)^power
//
// r is the center of the pixel whose depth was read, not the sample point. Then n . (r - p) is 0 on a plane of any
// slope, and planes do not occlude themselves.
#include "frame_uniforms.glsl"
#include "view_position.glsl"
#include "octahedral.glsl"

layout(constant_id = 0) const int kSamples = 14;   // OcclusionShape::samples

layout(location = 0) out vec4 visibility_distance_normal;

// 0 within the surface epsilon, then 1 up to fade start, then linear to 0 at fade end.
float fade(float nearer_by) {
  if (nearer_by <= frame.surface_epsilon_m) return 0.0;
  return clamp((frame.fade_end_m - nearer_by) / (frame.fade_end_m - frame.fade_start_m), 0.0, 1.0);
}

float occlusion_of(vec3 sample_point, vec3 p, vec3 n) {
  if (sample_point.z >= -frame.near_m) return 0.0;                        // in front of the near plane
  ivec2 size = textureSize(depth_image, 0);
  vec4 clip = clip_from_view(sample_point);
  vec2 ndc = clip.xy / clip.w;
  ivec2 pixel = clamp(ivec2(floor((ndc * 0.5 + 0.5) * vec2(size))), ivec2(0), size - 1);
  float far_r = distance_at(pixel);
  if (far_r == 0.0) return 0.0;                                                 // nothing drawn there
  vec3 to_r = view_point(pixel, far_r) - p;
  float length_squared = dot(to_r, to_r);
  if (length_squared == 0.0) return 0.0;                                        // p itself
  return fade(-p.z - far_r) * max(dot(n, to_r) * inversesqrt(length_squared), 0.0);
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 pixel = full_pixel(texel);
  float far_p = distance_at(pixel);
  vec3 n = texelFetch(normal_image, pixel, 0).xyz;
  visibility_distance_normal = vec4(1.0, far_p, pack_normal(n));
  if (far_p == 0.0 || n == vec3(0.0)) return;
  n = normalize(n);
  float radius_pixels = frame.occlusion_radius_m * pixels_per_metre(far_p);
  float resolved = clamp(radius_pixels - 2.0, 0.0, 1.0);                        // fades out where the radius is below 3 pixels
  if (resolved == 0.0) return;
  vec3 p = view_point(pixel, far_p);
  vec3 mirror = frame.noise[(texel.y & 3) * 4 + (texel.x & 3)].xyz;
  float sum = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    vec3 offset = reflect(frame.offsets[i].xyz, mirror);
    if (dot(offset, n) < 0.0) offset = -offset;                                 // into the hemisphere about n
    sum += occlusion_of(p + frame.occlusion_radius_m * offset, p, n);
  }
  visibility_distance_normal.r = pow(max(1.0 - sum / float(kSamples) * resolved, 0.0), frame.occlusion_power);
}
