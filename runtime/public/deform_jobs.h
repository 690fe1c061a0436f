// SPDX-License-Identifier: MIT
#pragma once
/// Jobs on vertices, for engines that run stages themselves: morph, three kinds of skinning, normals, bounds. They work
/// like those of pose_jobs.h. Normals and tangents need tables that are made once: sort_flat_faces, join_surface.
/// Linear skinning takes about half of the time with vertices that were sorted once (tile_vertices, SkinTilesJob), and
/// dual quaternions two thirds (SkinDualQuaternionJob::tiles). StridedSkinJob skins vertices in interleaved buffers;
/// WriteVerticesJob and QuantizeVerticesJob copy packed ones to such buffers, also as 16-bit integers.
///
///     const sinew::SkinLinearJob skin{
///         .influences = &primitive.influences,
///         .palette = palette,
///         .vertices = {.positions = primitive.positions, .normals = primitive.normals, .tangents = {}},
///         .out = {.positions = positions, .normals = normals, .tangents = {}}};
///     if (check(skin) == sinew::ErrorCode::ok) run(skin);
#include "runtime/deform/blend_combinations.h"
#include "runtime/deform/combine_influences.h"
#include "runtime/deform/flat_faces.h"
#include "runtime/deform/flat_normals.h"
#include "runtime/deform/grow_bounds.h"
#include "runtime/deform/influence_streams.h"
#include "runtime/deform/morph_tiles.h"
#include "runtime/deform/morph_vertices.h"
#include "runtime/deform/skin_center_of_rotation.h"
#include "runtime/deform/skin_dual_quaternion.h"
#include "runtime/deform/skin_linear.h"
#include "runtime/deform/skin_strided.h"
#include "runtime/deform/skin_tiles.h"
#include "runtime/deform/strided_vertices.h"
#include "runtime/deform/surface_normals.h"
#include "runtime/deform/tiled_morphs.h"
#include "runtime/deform/vertex_streams.h"
#include "runtime/deform/vertex_tiles.h"
#include "runtime/deform/write_vertices.h"
