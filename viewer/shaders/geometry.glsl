// SPDX-License-Identifier: MIT
// What a draw call brings; mirrors DrawConstants in viewer/passes/draw_list.h. The CPU multiplies the matrices of view and
// mesh in double precision, so that large world coordinates cancel before they are rounded.

layout(push_constant) uniform Draw {
  vec4 view_from_mesh[3];   // rows
  float handedness;         // -1 for mirrored meshes: their bitangent is -w cross(n, t) (runtime/math/conventions.h)
  float point_size;
  float access_factor;      // between the two key poses of ambient access
} draw;
