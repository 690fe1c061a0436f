// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/mesh.h"

namespace sinew {

/// Tangents for normal mapping, by the rules of MikkTSpace (Mikkelsen 2008): vertices that agree in position, normal
/// and texture coordinate are one; around it, faces that meet along edges and have the same texture orientation form a
/// group; each group has one tangent, and a vertex in several groups is split (mirrored texture seams).
/// eq   t = sum(angle_f * t_f) / |...|, t_f = dp/du of the face, laid into the plane of the vertex normal;
///      w = -1 where (u, v) turn like the face, else +1, so that bitangent = cross(n, t) * w points to falling v, as
///      glTF's normal textures need ("+Y up", v down)
/// A face without texture area takes part with no direction of its own. Where nothing is left, t is any direction
/// perpendicular to n: always finite and of unit length.
/// in   texcoord_set  index into texcoords; it and normals must be present, else nothing happens
/// out  tangents[V']; morph deltas of tangents go.   cost O(F) expected
void make_tangents(Primitive& primitive, std::uint32_t texcoord_set);

}  // namespace sinew
