// SPDX-License-Identifier: MIT
// Encodes linear values to sRGB, unless the target's format does that in hardware.
#include "srgb.glsl"

layout(constant_id = 0) const bool kEncode = true;

vec3 displayed(vec3 linear) { return kEncode ? srgb_encoded(linear) : linear; }

// For values to be displayed unchanged, such as normals.
vec3 displayed_data(vec3 value) { return kEncode ? clamp(value, 0.0, 1.0) : srgb_decoded(value); }
