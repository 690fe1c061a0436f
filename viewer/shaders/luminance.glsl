// SPDX-License-Identifier: MIT
// Luminance of linear sRGB (IEC 61966-2-1).

const vec3 kLuminance = vec3(0.2126, 0.7152, 0.0722);
