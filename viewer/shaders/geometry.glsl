// SPDX-License-Identifier: MIT
// What a draw call brings; mirrors DrawConstants in viewer/passes/draw_list.h. The matrix already contains the view, multiplied in
// double precision, so that large world coordinates cancel before they are rounded (N25).

layout(push_constant) uniform Draw {
  vec4 view_from_mesh[3];   // rows
  uint flags;
  float point_size;
} draw;

const uint kFlatNormals = 1u;   // faces are flat: normals from the shape itself (G46)
const uint kHasNormals = 2u;
const uint kHasTangents = 4u;
const uint kMirrored = 8u;      // the bitangent is -w cross(n, t) (runtime/math/conventions.h)
