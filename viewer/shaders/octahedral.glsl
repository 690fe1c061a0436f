// SPDX-License-Identifier: MIT
// Octahedral encoding: unit vectors as two numbers in [-1, 1] (Cigolle et al., "A Survey of Efficient Representations for
// Independent Unit Vectors", JCGT 2014). The zero vector ("no normal") is stored as 2, 2.

vec2 pack_normal(vec3 n) {
  float sum = abs(n.x) + abs(n.y) + abs(n.z);
  if (sum == 0.0) return vec2(2.0);
  vec2 p = n.xy / sum;
  vec2 folded = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
  return n.z < 0.0 ? folded : p;
}

vec3 unpack_normal(vec2 p) {
  if (p.x > 1.5) return vec3(0.0);
  vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
  float below = max(-n.z, 0.0);
  n.x += n.x >= 0.0 ? -below : below;
  n.y += n.y >= 0.0 ? -below : below;
  return normalize(n);
}
