// SPDX-License-Identifier: MIT
#include "importer/topology/normals.h"

#include <numeric>
#include <vector>

#include "importer/topology/adjacency.h"
#include "importer/topology/face_frame.h"
#include "importer/topology/flat_order.h"
#include "importer/topology/split_vertices.h"
#include "importer/topology/weld.h"

namespace sinew {
namespace {

constexpr glm::vec3 kUp{0.0f, 0.0f, 1.0f};

bool has_faces(const Primitive& p) noexcept { return p.topology == Topology::triangles && p.indices.size() >= 3; }

/// Normals of the half-edge vertices: normals of their faces, weighted by angle.
std::vector<glm::dvec3> vertex_normals(const Primitive& p, const Adjacency& adjacency) {
  std::vector<glm::dvec3> sums(adjacency.source.size(), glm::dvec3(0.0)), fallback = sums;
  for (std::size_t f = 0; f < adjacency.face_count(); ++f) {
    const auto corners = face_positions(p, f);
    const glm::dvec3 normal = unit_or(face_area_normal(corners), glm::dvec3(0.0));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = adjacency.corner_vertex[3 * f + k];
      if (v == kNone) continue;
      sums[v] += normal * corner_angle(corners, k);
      if (fallback[v] == glm::dvec3(0.0)) fallback[v] = normal;
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) sums[v] = unit_or(sums[v], unit_or(fallback[v], glm::dvec3(kUp)));
  return sums;
}

/// Removes what new normals make wrong: tangents, and morph deltas of both.
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

void make_smooth_normals(Primitive& primitive) {
  if (!has_faces(primitive)) return;
  remove_normals(primitive);

  const auto place = weld({&primitive.positions[0].x, 3 * primitive.vertex_count()}, 3);
  std::vector<std::uint32_t> triangles(primitive.indices.size());
  for (std::size_t c = 0; c < triangles.size(); ++c) triangles[c] = place[primitive.indices[c]];
  const Adjacency adjacency = make_adjacency(triangles, primitive.vertex_count());
  const auto normals = vertex_normals(primitive, adjacency);

  split_vertices(primitive, adjacency.corner_vertex);
  primitive.normals.assign(primitive.vertex_count(), kUp);
  for (std::size_t c = 0; c < primitive.indices.size(); ++c)
    if (adjacency.corner_vertex[c] != kNone)
      primitive.normals[primitive.indices[c]] = glm::vec3(normals[adjacency.corner_vertex[c]]);
  primitive.flat_normals = false;
}

}  // namespace sinew
