// SPDX-License-Identifier: MIT
// A neighbouring sample lies on the same surface, so that ambient access may be averaged: its normal is similar, and it
// lies near the tangent plane. The tolerance grows with the distance on screen, because surfaces curve.

const float kSimilarNormal = 0.8;
const float kCurve = 0.25;

bool same_surface(vec3 p, vec3 n, vec3 other_p, vec3 other_n, float screen_m) {
  float off_plane = abs(dot(n, other_p - p));
  return dot(n, other_n) >= kSimilarNormal && off_plane <= frame.surface_epsilon_m + kCurve * screen_m;
}
