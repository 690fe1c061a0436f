// SPDX-License-Identifier: MIT
// Texels of ao_image: ambient visibility, distance and the surface normal. If reflections need it, also the bent
// normal: the mean direction of arriving light. Then each of the last two channels packs 12 bits of either normal as
// integers, which are exact in a float.

layout(constant_id = 23) const bool kBent = false;   // texels also hold bent normals

const float kSteps12 = 2047.0;
const float kNoNormal = 33554432.0;

vec4 visibility_texel(float visibility, float distance, vec3 n, vec3 bent) {
  if (!kBent) return vec4(visibility, distance, pack_normal(n));
  if (n == vec3(0.0)) return vec4(visibility, distance, vec2(kNoNormal));
  vec2 first = round(kSteps12 * (pack_normal(n) + 1.0)), second = round(kSteps12 * (pack_normal(bent) + 1.0));
  return vec4(visibility, distance, first * 4096.0 + second);
}

bool has_normal(vec4 texel) { return kBent ? texel.b < kNoNormal : texel.b <= 1.5; }

vec3 normal_of(vec4 texel) {
  return unpack_normal(kBent ? floor(texel.ba / 4096.0) / kSteps12 - 1.0 : texel.ba);
}

// Difference of the bent normal and the normal in packed coordinates; 0 if nothing is occluded. It can be averaged
// without unpacking. Packed coordinates are discontinuous only for normals that point straight away from the viewer,
// which no visible surface has.
vec2 bend_of(vec4 texel) {
  if (!kBent || !has_normal(texel)) return vec2(0.0);
  vec2 first = floor(texel.ba / 4096.0);
  return (texel.ba - 4097.0 * first) / kSteps12;
}

// Replaces the bend of a texel.
vec4 with_bend(vec4 texel, vec2 bend) {
  vec2 first = floor(texel.ba / 4096.0);
  texel.ba = first * 4096.0 + clamp(first + round(kSteps12 * bend), 0.0, 2.0 * kSteps12);
  return texel;
}

vec3 bent_normal(vec3 n, vec2 bend) { return unpack_normal(clamp(pack_normal(n) + bend, -1.0, 1.0)); }
