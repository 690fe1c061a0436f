// SPDX-License-Identifier: MIT
// Texels of ao_image: ambient access, distance, and the normal of the surface. Where reflections read it, the bent normal
// is there, too: the mean direction of the light that arrives. Then each of the last two numbers holds one of either
// normal, with 12 bits for each: such whole numbers are exact in a float.

layout(constant_id = 23) const bool kBent = false;   // there are bent normals

const float kSteps12 = 2047.0;
const float kNoNormal = 33554432.0;

vec4 access_texel(float access, float distance, vec3 n, vec3 bent) {
  if (!kBent) return vec4(access, distance, pack_normal(n));
  if (n == vec3(0.0)) return vec4(access, distance, vec2(kNoNormal));
  vec2 first = round(kSteps12 * (pack_normal(n) + 1.0)), second = round(kSteps12 * (pack_normal(bent) + 1.0));
  return vec4(access, distance, first * 4096.0 + second);
}

bool has_normal(vec4 texel) { return kBent ? texel.b < kNoNormal : texel.b <= 1.5; }

vec3 normal_of(vec4 texel) {
  return unpack_normal(kBent ? floor(texel.ba / 4096.0) / kSteps12 - 1.0 : texel.ba);
}

// From the normal to the bent normal: 0 where nothing is in the way. It is that of their packed numbers, so that neighbours
// are averaged without unpacking. Packed numbers jump only straight away from the viewer, where no visible surface faces.
vec2 bend_of(vec4 texel) {
  if (!kBent || !has_normal(texel)) return vec2(0.0);
  vec2 first = floor(texel.ba / 4096.0);
  return (texel.ba - 4097.0 * first) / kSteps12;
}

// The texel with another bend.
vec4 with_bend(vec4 texel, vec2 bend) {
  vec2 first = floor(texel.ba / 4096.0);
  texel.ba = first * 4096.0 + clamp(first + round(kSteps12 * bend), 0.0, 2.0 * kSteps12);
  return texel;
}

vec3 bent_normal(vec3 n, vec2 bend) { return unpack_normal(clamp(pack_normal(n) + bend, -1.0, 1.0)); }
