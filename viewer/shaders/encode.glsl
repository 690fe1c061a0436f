// SPDX-License-Identifier: MIT
// Encodes linear values to sRGB (IEC 61966-2-1), unless the format of the target does it.

layout(constant_id = 0) const bool kEncode = true;

vec3 displayed(vec3 linear) {
  if (!kEncode) return linear;
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
}

// For values that are shown unchanged, such as normals.
vec3 displayed_data(vec3 value) {
  vec3 c = clamp(value, 0.0, 1.0);
  if (kEncode) return c;
  return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, lessThanEqual(c, vec3(0.04045)));
}
