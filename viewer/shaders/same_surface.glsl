// SPDX-License-Identifier: MIT
// Whether a neighbouring sample lies on the same surface, so that ambient access may be shared between them: similar
// normal, and inside the tangent plane give or take what a gentle curve does over that many metres of screen (N33).

const float kSimilarNormal = 0.8;
const float kCurve = 0.25;

bool same_surface(vec3 p, vec3 n, vec3 other_p, vec3 other_n, float screen_m) {
  float off_plane = abs(dot(n, other_p - p));
  return dot(n, other_n) >= kSimilarNormal && off_plane <= frame.occlusion.y + kCurve * screen_m;
}
