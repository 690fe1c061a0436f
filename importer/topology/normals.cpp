// SPDX-License-Identifier: MIT
#include "importer/topology/normals.h"

#include <numeric>
#include <vector>

#include "importer/topology/face_frame.h"
#include "importer/topology/flat_order.h"
#include "importer/topology/split_vertices.h"

namespace sinew {
namespace {

constexpr glm::vec3 kUp{0.0f, 0.0f, 1.0f};

bool has_faces(const Primitive& p) noexcept { return p.topology == Topology::triangles && p.indices.size() >= 3; }

/// Removes data that new normals invalidate: tangents, and the morph deltas of normals and tangents.
void remove_normals(Primitive& primitive) {
  primitive.tangents.clear();
  primitive.normals.clear();
  for (MorphTarget& target : primitive.morphs.targets) target.normals = target.tangents = {};
}

}  // namespace

void make_flat_normals(Primitive& primitive) {
  if (!has_faces(primitive)) return;
  remove_normals(primitive);
  std::vector<std::uint32_t> own_copy(primitive.indices.size());
  std::iota(own_copy.begin(), own_copy.end(), 0u);
  split_vertices(primitive, own_copy);
  order_flat_corners(primitive);

  primitive.normals.assign(primitive.vertex_count(), kUp);
  for (std::size_t f = 0; f < primitive.indices.size() / 3; ++f) {
    const glm::vec3 normal(unit_or(face_area_normal(face_positions(primitive, f)), glm::dvec3(kUp)));
    for (std::size_t k = 0; k < 3; ++k) primitive.normals[primitive.indices[3 * f + k]] = normal;
  }
  primitive.flat_normals = true;
}

}  // namespace sinew
