// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/mesh.h"

namespace sinew {

/// Makes tangents for normal mapping by the rules of MikkTSpace (Mikkelsen 2008). Vertices that agree in position,
/// normal and texture coordinate count as one. Around it, faces that meet along edges and whose texture has the same
/// orientation form a group; each group has one tangent, and a vertex in several groups is split (mirrored seams).
/// eq    t = sum(angle_f * t_f) / |...|, t_f = dp/du of the face, projected into the plane of the vertex normal;
///       w = -1 where (u, v) turn like the face, else +1, so that bitangent = cross(n, t) * w points to falling v, as
///       glTF's normal textures need ("+Y up", v down)
/// A face without texture area adds no direction. Where no direction is left, t is any direction perpendicular to n, so
/// tangents are always finite and of unit length.
/// in    texcoord_set   index into texcoords; without that set or without normals nothing happens
/// out   tangents[V']; morph deltas of tangents are removed
/// cost  O(F) expected
void make_tangents(Primitive& primitive, std::uint32_t texcoord_set);

}  // namespace sinew
