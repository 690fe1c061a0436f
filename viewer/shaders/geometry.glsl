// SPDX-License-Identifier: MIT
// Push constants of a draw call; mirrors DrawConstants in viewer/passes/draw_list.h. The CPU multiplies view and mesh
// matrices in double precision, so that large world coordinates cancel before rounding.

layout(push_constant) uniform Draw {
  vec4 view_from_mesh[3];   // rows
  float handedness;         // -1 for mirrored meshes: their bitangent is -w cross(n, t) (runtime/math/conventions.h)
  float point_size;
  float visibility_factor;      // blend factor between two key poses
  vec4 shadow_w;            // shadow maps: view_from_mesh has rows x, y and z of map_from_mesh, this is row w
} draw;
