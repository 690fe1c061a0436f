// SPDX-License-Identifier: MIT
// Where a pixel is covered. With several samples a pixel, its middle may lie outside of the triangle: what is interpolated
// there is beyond what any vertex has, and shows at edges as dots of other texels and of light from behind.

layout(location = 12) centroid in vec3 covered_position;   // of the surface, in view space

// From the middle of the pixel to where it is covered, in pixels.
// in   p  the position in the middle, interpolated without centroid: its neighbours are one pixel away
// eq   covered - p = x dFdx(p) + y dFdy(p)
vec2 covered_place(vec3 p) {
  vec3 dx = dFdx(p), dy = dFdy(p), d = covered_position - p, n = cross(dx, dy);
  float square = dot(n, n);
  return square > 0.0 ? clamp(vec2(dot(cross(d, dy), n), dot(cross(dx, d), n)) / square, -0.5, 0.5) : vec2(0.0);
}
