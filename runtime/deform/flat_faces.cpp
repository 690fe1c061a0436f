// SPDX-License-Identifier: MIT
#include "runtime/deform/flat_faces.h"

#include <algorithm>
#include <utility>

namespace sinew {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

bool follows(const Triangle& next, const Triangle& triangle) {
  return next[0] == triangle[0] + 1 && next[1] == triangle[1] + 1 && next[2] == triangle[2] + 1;
}

std::vector<Triangle> sorted_by_first_corner(std::span<const std::uint32_t> triangles) {
  std::vector<Triangle> sorted;
  sorted.reserve(triangles.size() / 3);
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3)
    sorted.push_back({triangles[t], triangles[t + 1], triangles[t + 2]});
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

void append(const Triangle& triangle, std::vector<std::uint32_t>& to) {
  to.insert(to.end(), triangle.begin(), triangle.end());
}

/// Repeats triangles from the start of the list until it fills the widest vectors.
void fill_vectors(std::vector<std::uint32_t>& corners) {
  constexpr std::size_t kWhole = 3 * FlatStream::kFewest;
  const std::size_t count = (corners.size() + kWhole - 1) / kWhole * kWhole;
  corners.reserve(count);
  for (std::size_t i = 0; corners.size() < count; ++i) corners.push_back(corners[i]);
}

/// Vertices without a triangle, and vertices of the triangles in `alone`.
std::vector<std::uint32_t> vertices_at_rest(std::vector<bool> has_face, std::span<const std::uint32_t> alone) {
  for (const std::uint32_t vertex : alone) has_face[vertex] = false;
  std::vector<std::uint32_t> at_rest;
  for (std::uint32_t v = 0; v < has_face.size(); ++v)
    if (!has_face[v]) at_rest.push_back(v);
  return at_rest;
}

/// Sorts triangles into streams, `corners` and `alone`. No two triangles share a vertex.
void sort_disjoint(std::span<const std::uint32_t> triangles, std::size_t vertex_count, FlatFaces& faces) {
  const auto has_last_vertex = [&](const Triangle& triangle) {
    return std::find(triangle.begin(), triangle.end(), vertex_count - 1) != triangle.end();
  };
  const auto breaks = [](const Triangle& before, const Triangle& after) { return !follows(after, before); };
  const std::vector<Triangle> sorted = sorted_by_first_corner(triangles);
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto last = std::adjacent_find(first, sorted.end(), breaks);
    const auto end = last == sorted.end() ? last : last + 1;
    if (static_cast<std::size_t>(end - first) >= FlatStream::kFewest)
      faces.streams.push_back({*first, static_cast<std::uint32_t>(end - first)});
    else
      for (auto t = first; t != end; ++t) append(*t, has_last_vertex(*t) ? faces.alone : faces.corners);
    first = end;
  }
  fill_vectors(faces.corners);
}

}  // namespace

FlatFaces sort_flat_faces(std::span<const std::uint32_t> triangles, std::size_t vertex_count) {
  FlatFaces faces;
  triangles = triangles.first(triangles.size() / 3 * 3);
  faces.count = triangles.size() / 3;
  std::vector<bool> has_face(vertex_count);
  bool share_vertices = false;
  for (const std::uint32_t vertex : triangles) {
    share_vertices |= has_face[vertex];
    has_face[vertex] = true;
  }
  if (share_vertices)
    faces.alone.assign(triangles.begin(), triangles.end());
  else
    sort_disjoint(triangles, vertex_count, faces);
  faces.at_rest = vertices_at_rest(std::move(has_face), faces.alone);
  return faces;
}

}  // namespace sinew
