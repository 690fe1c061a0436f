// SPDX-License-Identifier: MIT
#include "importer/topology/adjacency.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <algorithm>
#include <array>

#include "importer/topology/corner_sets.h"
#include "runtime/base/contract.h"

namespace sinew {
namespace {

using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<>;

/// An edge of a face, from the vertex of `corner` to the next corner's. `low` < `high` are its end vertices; `rising`
/// is true if it runs from low to high.
struct Edge {
  std::uint32_t low, high, corner;
  bool rising;
};

std::vector<Edge> sorted_edges(std::span<const std::uint32_t> triangles, const std::vector<bool>& whole) {
  std::vector<Edge> edges;
  edges.reserve(triangles.size());
  for (std::size_t c = 0; c < triangles.size(); ++c) {
    if (!whole[c / 3]) continue;
    const std::uint32_t a = triangles[c], b = triangles[next_corner(c)];
    edges.push_back({std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(c), a < b});
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& x, const Edge& y) {
    return std::array{x.low, x.high, x.corner} < std::array{y.low, y.high, y.corner};
  });
  return edges;
}

/// Joins corners across every edge of exactly two consistently wound faces (which traverse the edge in opposite
/// directions).
void join_fans(CornerSets& sets, const std::vector<Edge>& edges) {
  for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
    while (end < edges.size() && edges[end].low == edges[first].low && edges[end].high == edges[first].high) ++end;
    if (end - first != 2 || edges[first].rising == edges[first + 1].rising) continue;
    const std::size_t c = edges[first].corner, d = edges[first + 1].corner;
    sets.join(c, next_corner(d));
    sets.join(next_corner(c), d);
  }
}

/// Numbers the sets of corners in order of their first corner; each becomes a half-edge vertex.
void number_vertices(CornerSets& sets, std::span<const std::uint32_t> triangles, const std::vector<bool>& whole,
                     Adjacency& out) {
  out.corner_vertex.assign(triangles.size(), kNone);
  for (std::size_t c = 0; c < triangles.size(); ++c) {
    if (!whole[c / 3]) continue;
    const std::uint32_t leader = sets.leader(c);
    if (leader == c) {
      out.corner_vertex[c] = static_cast<std::uint32_t>(out.source.size());
      out.source.push_back(triangles[c]);
    } else {
      out.corner_vertex[c] = out.corner_vertex[leader];
    }
  }
}

HalfEdgeMesh build_mesh(const Adjacency& a, std::vector<std::uint32_t>& triangle_of_face) {
  HalfEdgeMesh mesh;
  mesh.reserve(a.source.size(), a.corner_vertex.size(), a.face_count());
  for (std::size_t v = 0; v < a.source.size(); ++v) mesh.add_vertex(HalfEdgeMesh::Point(0.0f, 0.0f, 0.0f));
  const auto vertex = [&](std::size_t c) { return HalfEdgeMesh::VertexHandle(static_cast<int>(a.corner_vertex[c])); };
  for (std::size_t f = 0; f < a.face_count(); ++f) {
    if (a.corner_vertex[3 * f] == kNone) continue;
    // Always succeeds. The faces at each vertex are one fan with at most two border edges, of opposite directions.
    // Even if both lie on the same cut edge of the input, they use different half-edges.
    const auto face = mesh.add_face(vertex(3 * f), vertex(3 * f + 1), vertex(3 * f + 2));
    CONTRACT(face.is_valid());
    triangle_of_face.push_back(static_cast<std::uint32_t>(f));
  }
  return mesh;
}

}  // namespace

Adjacency make_adjacency(std::span<const std::uint32_t> triangles, std::size_t vertex_count) {
  CONTRACT(triangles.size() % 3 == 0);
  std::vector<bool> whole(triangles.size() / 3);
  for (std::size_t f = 0; f < whole.size(); ++f) {
    const std::uint32_t a = triangles[3 * f], b = triangles[3 * f + 1], c = triangles[3 * f + 2];
    CONTRACT(a < vertex_count && b < vertex_count && c < vertex_count);
    whole[f] = a != b && b != c && c != a;
  }

  Adjacency result;
  CornerSets sets(triangles.size());
  join_fans(sets, sorted_edges(triangles, whole));
  number_vertices(sets, triangles, whole, result);

  std::vector<std::uint32_t> triangle_of_face;
  const HalfEdgeMesh mesh = build_mesh(result, triangle_of_face);
  result.neighbour.assign(triangles.size(), kNone);
  for (std::size_t i = 0; i < triangle_of_face.size(); ++i) {
    const std::size_t f = triangle_of_face[i];
    auto edge = mesh.halfedge_handle(OpenMesh::FaceHandle(static_cast<int>(i)));
    for (int side = 0; side < 3; ++side, edge = mesh.next_halfedge_handle(edge)) {
      const auto across = mesh.face_handle(mesh.opposite_halfedge_handle(edge));
      if (!across.is_valid()) continue;
      const auto from = static_cast<std::uint32_t>(mesh.from_vertex_handle(edge).idx());
      std::size_t c = 3 * f;
      while (result.corner_vertex[c] != from) ++c;
      result.neighbour[c] = triangle_of_face[static_cast<std::size_t>(across.idx())];
    }
  }
  return result;
}

}  // namespace sinew
