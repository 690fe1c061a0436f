// SPDX-License-Identifier: MIT
// Weight of a neighbouring sample in a mean of ambient visibility: how likely it is on the same surface. Falls smoothly
// with the angle between normals and with the distance from the tangent plane. The distance scale grows with screen
// distance, because surfaces curve. Exactly 1 on a plane.
// eq   max(n . other n, 0)^4 * exp(-(n . (other - p) / scale)^2 / 2)

const float kCurve = 0.25;

float same_surface(vec3 p, vec3 n, vec3 other_p, vec3 other_n, float screen_m) {
  float off = dot(n, other_p - p) / (frame.surface_epsilon_m + kCurve * screen_m);
  float turned = max(dot(n, other_n), 0.0);
  return turned * turned * turned * turned * exp(-0.5 * off * off);
}
