// SPDX-License-Identifier: MIT
// Normals and tangent frames as quaternions. Interpolated linearly between vertices, they give unit normals and
// orthonormal frames without a square root. A normal's quaternion with w = 0 is the half-way vector between the normal
// and +z. It is discontinuous near -z, so callers orient surfaces towards +z.
// eq   Hast, "Shading by Quaternion Interpolation" (WSCG 2005), eqs. 16 and 17, with the last line read as N.z -= 1

// 0 = linear interpolation, 1 = quaternions for front sides, 2 = for both sides.
layout(constant_id = 38) const int kQuaternions = 0;

const float kLeastSine = 1e-3;   // between normal and tangent; below it, rounding would decide the direction

// The unit half-way vector between n and +z. At n = -z every perpendicular vector is valid; +x is used. Zero stays
// zero.
// eq   (n.x, n.y, 2 z^2) / (2 z), 2 z^2 = 1 + n.z, for n.z < 0 computed as (x^2 + y^2) / (1 - n.z), which avoids
//      cancellation
vec3 half_way(vec3 n) {
  float side = dot(n.xy, n.xy), twice_square = n.z < 0.0 ? side / (1.0 - n.z) : 1.0 + n.z;
  vec3 h = vec3(n.xy, twice_square);
  float most = max(max(abs(h.x), abs(h.y)), h.z);   // scaled, because squares near -z would underflow
  if (n == vec3(0.0)) return vec3(0.0);
  return most > 0.0 ? normalize(h / most) : vec3(1.0, 0.0, 0.0);
}

// The unit normal of a half-way vector h of any length: +z mirrored about h.
vec3 normal_of(vec3 h) { return h * (2.0 * h.z / dot(h, h)) - vec3(0.0, 0.0, 1.0); }

// The quaternion (xyzw) that rotates x to the tangent, y to n x tangent and z to n. It is the half-way vector times a
// rotation by a about the normal: q = h * (cos(a / 2) + z sin(a / 2)).
// in   h       half_way(n);   along  only its direction in the plane of n counts
// out  spinor  (cos, sin) of half the rotation, cos >= 0: -q is the same frame; returns zero if `along` is parallel to
//      n
vec4 frame_quaternion(vec3 h, vec3 along, out vec2 spinor) {
  vec2 turn = vec2(dot(along, 2.0 * h.x * h - vec3(1.0, 0.0, 0.0)), dot(along, 2.0 * h.y * h - vec3(0.0, 1.0, 0.0)));
  float square = dot(turn, turn);
  spinor = vec2(0.0);
  if (!(square > kLeastSine * kLeastSine * dot(along, along))) return vec4(0.0);
  turn *= inversesqrt(square);
  float c = sqrt(0.5 + 0.5 * abs(turn.x)), s = 0.5 * turn.y / c;
  spinor = turn.x >= 0.0 ? vec2(c, s) : vec2(abs(s), turn.y >= 0.0 ? c : -c);
  return vec4(spinor.x * h.x + spinor.y * h.y, spinor.x * h.y - spinor.y * h.x, spinor.x * h.z, -spinor.y * h.z);
}

// The rotation matrix of q, which may have any length except 0.
mat3 frame_of(vec4 q) {
  float twice = 2.0 / dot(q, q);
  vec3 v = q.xyz * twice;
  float xx = q.x * v.x, yy = q.y * v.y, zz = q.z * v.z, xy = q.x * v.y, xz = q.x * v.z, yz = q.y * v.z;
  vec3 w = q.w * v;
  return mat3(1.0 - yy - zz, xy + w.z, xz - w.y,
              xy - w.z, 1.0 - xx - zz, yz + w.x,
              xz + w.y, yz - w.x, 1.0 - xx - yy);
}
