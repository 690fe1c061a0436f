// SPDX-License-Identifier: MIT
#include "runtime/deform/flat_faces.h"

#include <algorithm>

namespace sinew {
namespace {

bool is_run(std::span<const std::uint32_t> triangle) {
  return triangle[1] == triangle[0] + 1 && triangle[2] == triangle[0] + 2;
}

}  // namespace

FlatFaces sort_flat_faces(std::span<const std::uint32_t> triangles, std::size_t vertex_count) {
  FlatFaces faces;
  triangles = triangles.first(triangles.size() / 3 * 3);
  std::vector<bool> has_face(vertex_count);
  for (const std::uint32_t vertex : triangles) {
    faces.share_vertices |= has_face[vertex];
    has_face[vertex] = true;
  }
  for (std::uint32_t v = 0; v < vertex_count; ++v)
    if (!has_face[v]) faces.faceless.push_back(v);
  if (faces.share_vertices) {
    faces.corners.assign(triangles.begin(), triangles.end());
    return faces;
  }
  std::vector<std::uint32_t> last;
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const auto triangle = triangles.subspan(t, 3);
    if (is_run(triangle))
      faces.runs.push_back(triangle[0]);
    else if (std::find(triangle.begin(), triangle.end(), vertex_count - 1) == triangle.end())
      faces.corners.insert(faces.corners.end(), triangle.begin(), triangle.end());
    else
      last.assign(triangle.begin(), triangle.end());
  }
  faces.corners.insert(faces.corners.end(), last.begin(), last.end());
  const auto run_of_last = std::find(faces.runs.begin(), faces.runs.end(), vertex_count - 3);
  if (run_of_last != faces.runs.end()) std::rotate(run_of_last, run_of_last + 1, faces.runs.end());
  return faces;
}

}  // namespace sinew
