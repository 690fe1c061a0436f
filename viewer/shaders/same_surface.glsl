// SPDX-License-Identifier: MIT
// How much a neighbouring sample counts in a mean of ambient access: as far as it may be on the same surface. It falls off
// smoothly as normals turn and as the sample leaves the tangent plane. The scale of that grows with the distance on
// screen, because surfaces curve. On a plane it is 1.
// eq   max(n . other n, 0)^4 * exp(-(n . (other - p) / scale)^2 / 2)

const float kCurve = 0.25;

float same_surface(vec3 p, vec3 n, vec3 other_p, vec3 other_n, float screen_m) {
  float off = dot(n, other_p - p) / (frame.surface_epsilon_m + kCurve * screen_m);
  float turned = max(dot(n, other_n), 0.0);
  return turned * turned * turned * turned * exp(-0.5 * off * off);
}
