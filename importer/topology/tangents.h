// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/mesh.h"

namespace sinew {

/// Makes tangents for normal mapping by the rules of MikkTSpace (Mikkelsen 2008). Vertices with equal position, normal
/// and texture coordinate count as one. Around such a vertex, faces that are connected by edges and have the same
/// texture orientation form a group with one tangent. A vertex in several groups (at mirrored seams) is split.
/// eq    t = sum(angle_f * t_f) / |...|, t_f = dp/du of the face, projected into the plane of the vertex normal;
///       w = -1 if (u, v) wind like the face, else +1, so that bitangent = cross(n, t) * w points to decreasing v, as
///       glTF's normal textures need ("+Y up", v down)
/// Faces without texture area contribute nothing. If no direction remains, t is any unit vector perpendicular to n, so
/// tangents are always finite and of unit length.
/// in    texcoord_set   index into texcoords; without that set or without normals, nothing is done
/// out   tangents[V']; morph deltas of tangents are removed
/// cost  O(F) expected
void make_tangents(Primitive& primitive, std::uint32_t texcoord_set);

}  // namespace sinew
