// SPDX-License-Identifier: MIT
#include "importer/topology/tangents.h"

#include <cmath>
#include <vector>

#include "importer/topology/adjacency.h"
#include "importer/topology/corner_sets.h"
#include "importer/topology/face_frame.h"
#include "importer/topology/split_vertices.h"
#include "importer/topology/weld.h"

namespace sinew {
namespace {

/// Texture mapping of a face. `turn` is +1 if (u, v) wind like the face, -1 if they wind the other way (mirrored), 0
/// without texture area.
struct FaceTexture {
  glm::dvec3 rising_u{0.0};  ///< dp/du, not normalised
  int turn = 0;
};

FaceTexture face_texture(const Primitive& p, std::size_t f, std::uint32_t set) noexcept {
  const auto corners = face_positions(p, f);
  const auto uv = [&](std::size_t k) { return glm::dvec2(p.texcoords[set][p.indices[3 * f + k]]); };
  const glm::dvec2 a = uv(1) - uv(0), b = uv(2) - uv(0);
  const double area = a.x * b.y - a.y * b.x;
  if (!(area != 0.0) || !std::isfinite(area)) return {};
  const int turn = area > 0.0 ? 1 : -1;
  return {((corners[1] - corners[0]) * b.y - (corners[2] - corners[0]) * a.y) * double(turn), turn};
}

/// Any unit vector perpendicular to n: its cross product with the axis of its smallest component.
glm::dvec3 perpendicular(const glm::dvec3& n) noexcept {
  const glm::dvec3 size = glm::abs(n);
  const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                          : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                               : glm::dvec3(0, 0, 1);
  return unit_or(glm::cross(n, axis), glm::dvec3(1, 0, 0));
}

/// Adjacency over merged vertices: equal in all attributes that tangents depend on.
Adjacency textured_adjacency(const Primitive& p, std::uint32_t set) {
  std::vector<float> keys;
  keys.reserve(8 * p.vertex_count());
  for (std::size_t v = 0; v < p.vertex_count(); ++v) {
    const glm::vec3 &x = p.positions[v], &n = p.normals[v];
    const glm::vec2& uv = p.texcoords[set][v];
    keys.insert(keys.end(), {x.x, x.y, x.z, n.x, n.y, n.z, uv.x, uv.y});
  }
  const auto first_alike = weld(keys, 8);
  std::vector<std::uint32_t> triangles(p.indices.size());
  for (std::size_t c = 0; c < triangles.size(); ++c) triangles[c] = first_alike[p.indices[c]];
  return make_adjacency(triangles, p.vertex_count());
}

/// Gives faces without texture area the orientation of the nearest neighbour across edges, so that they do not separate
/// groups.
void spread_turn(std::vector<FaceTexture>& faces, const Adjacency& adjacency) {
  std::vector<std::uint32_t> queue;
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (faces[f].turn != 0) queue.push_back(static_cast<std::uint32_t>(f));
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t g = adjacency.neighbour[3 * std::size_t{queue[i]} + k];
      if (g == kNone || faces[g].turn != 0) continue;
      faces[g].turn = faces[queue[i]].turn;
      queue.push_back(g);
    }
}

/// Groups corners that share a tangent: around a vertex, across edges between faces of equal orientation.
std::vector<std::uint32_t> tangent_groups(const std::vector<FaceTexture>& faces, const Adjacency& adjacency) {
  const auto corner_at = [&](std::size_t face, std::uint32_t vertex) {
    std::size_t c = 3 * face;
    while (adjacency.corner_vertex[c] != vertex) ++c;
    return c;
  };
  CornerSets sets(adjacency.corner_vertex.size());
  for (std::size_t c = 0; c < adjacency.neighbour.size(); ++c) {
    const std::uint32_t g = adjacency.neighbour[c];
    if (g == kNone || faces[g].turn != faces[c / 3].turn) continue;
    const std::size_t end = next_corner(c);
    sets.join(c, corner_at(g, adjacency.corner_vertex[c]));
    sets.join(end, corner_at(g, adjacency.corner_vertex[end]));
  }
  std::vector<std::uint32_t> group(adjacency.corner_vertex.size(), kNone);
  for (std::size_t c = 0; c < group.size(); ++c)
    if (adjacency.corner_vertex[c] != kNone) group[c] = sets.leader(c);
  return group;
}

/// Contribution of a face to the tangent at its corner k: dp/du projected into the plane of the normal, weighted by the
/// angle at the corner.
glm::dvec3 contribution(const Primitive& p, std::size_t f, std::size_t k, const FaceTexture& face,
                        const glm::dvec3& n) {
  const auto corners = face_positions(p, f);
  const auto into_plane = [&](const glm::dvec3& v) { return v - n * glm::dot(n, v); };
  const glm::dvec3 direction = unit_or(into_plane(unit_or(face.rising_u, glm::dvec3(0.0))), glm::dvec3(0.0));
  return direction *
         angle_between(into_plane(corners[(k + 1) % 3] - corners[k]), into_plane(corners[(k + 2) % 3] - corners[k]));
}

}  // namespace

void make_tangents(Primitive& primitive, std::uint32_t texcoord_set) {
  const std::size_t corner_count = primitive.indices.size();
  if (primitive.topology != Topology::triangles || corner_count == 0 || texcoord_set >= primitive.texcoords.size() ||
      primitive.texcoords[texcoord_set].empty() || primitive.normals.empty())
    return;
  primitive.tangents.clear();
  for (MorphTarget& target : primitive.morphs.targets) target.tangents = {};

  const Adjacency adjacency = textured_adjacency(primitive, texcoord_set);
  std::vector<FaceTexture> faces(corner_count / 3);
  for (std::size_t f = 0; f < faces.size(); ++f) faces[f] = face_texture(primitive, f, texcoord_set);
  spread_turn(faces, adjacency);
  const auto group = tangent_groups(faces, adjacency);

  // Sum of each group, at the index of its representative corner.
  std::vector<glm::dvec3> sums(corner_count, glm::dvec3(0.0));
  const auto normal_at = [&](std::size_t v) { return unit_or(glm::dvec3(primitive.normals[v]), glm::dvec3(0, 0, 1)); };
  for (std::size_t c = 0; c < corner_count; ++c)
    if (group[c] != kNone)
      sums[group[c]] += contribution(primitive, c / 3, c % 3, faces[c / 3], normal_at(primitive.indices[c]));

  split_vertices(primitive, group);
  primitive.tangents.resize(primitive.vertex_count());
  for (std::size_t v = 0; v < primitive.vertex_count(); ++v)
    primitive.tangents[v] = glm::vec4(glm::vec3(perpendicular(normal_at(v))), 1.0f);
  for (std::size_t c = 0; c < corner_count; ++c) {
    if (group[c] == kNone) continue;
    const std::size_t v = primitive.indices[c];
    const glm::dvec3 tangent = unit_or(sums[group[c]], perpendicular(normal_at(v)));
    primitive.tangents[v] = glm::vec4(glm::vec3(tangent), faces[c / 3].turn > 0 ? -1.0f : 1.0f);
  }
}

}  // namespace sinew
