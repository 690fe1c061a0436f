// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/model/mesh.h"

namespace sinew::reference {

using Point = glm::dvec3;

/// Vertices that share the rest position and rest normal of this vertex.
inline std::vector<std::size_t> joined_with(const Primitive& rest, std::size_t vertex) {
  std::vector<std::size_t> joined;
  for (std::size_t v = 0; v < rest.positions.size(); ++v)
    if (rest.positions[v] == rest.positions[vertex] && rest.normals[v] == rest.normals[vertex]) joined.push_back(v);
  return joined;
}

/// eq   the vector area of the triangles around a point: half the sum of (b - a) x (c - a)
inline Point vector_area(const Primitive& rest, std::span<const Point> moved, std::span<const std::size_t> vertices) {
  Point sum(0.0);
  for (std::size_t i = 0; i < rest.indices.size(); i += 3)
    for (std::size_t corner = 0; corner < 3; ++corner)
      for (const std::size_t vertex : vertices)
        if (rest.indices[i + corner] == vertex) {
          const Point a = moved[rest.indices[i]], b = moved[rest.indices[i + 1]], c = moved[rest.indices[i + 2]];
          sum += 0.5 * glm::cross(b - a, c - a);
        }
  return sum;
}

/// Smooth normal of each vertex of a moved surface. A vertex without area keeps its normal at rest. `turned` reverses
/// them.
inline std::vector<Point> surface_normals(const Primitive& rest, std::span<const Point> moved, bool turned) {
  std::vector<Point> normals;
  for (std::size_t v = 0; v < moved.size(); ++v) {
    const Point area = vector_area(rest, moved, joined_with(rest, v));
    const double length = glm::length(area);
    normals.push_back(length > 0.0 ? (turned ? -1.0 : 1.0) * area / length : Point(rest.normals[v]));
  }
  return normals;
}

/// The rest tangent after its triangle has moved. In the plane of the rest triangle, x (b - a) + y (c - a) is nearest
/// to the tangent; x and y come from the normal equations. The result applies x and y to the moved edges.
inline Point moved_tangent(const Point& tangent, const Point& ab, const Point& ac, const Point& moved_ab,
                           const Point& moved_ac) {
  const double bb = glm::dot(ab, ab), bc = glm::dot(ab, ac), cc = glm::dot(ac, ac), determinant = bb * cc - bc * bc;
  if (!(determinant > 0.0)) return Point(0.0);
  const double tb = glm::dot(tangent, ab), tc = glm::dot(tangent, ac);
  return (tb * cc - tc * bc) / determinant * moved_ab + (tc * bb - tb * bc) / determinant * moved_ac;
}

/// eq   normalise(sum over the triangles at a vertex, by their area at rest, of the moved tangent)
inline std::vector<Point> surface_tangents(const Primitive& rest, std::span<const Point> moved) {
  std::vector<Point> tangents(moved.size(), Point(0.0));
  for (std::size_t i = 0; i < rest.indices.size(); ++i) {
    const std::uint32_t* const t = &rest.indices[i / 3 * 3];
    const Point a(rest.positions[t[0]]), ab = Point(rest.positions[t[1]]) - a, ac = Point(rest.positions[t[2]]) - a;
    const Point tangent(rest.tangents[rest.indices[i]]);
    tangents[rest.indices[i]] += glm::length(glm::cross(ab, ac)) *
                                 moved_tangent(tangent, ab, ac, moved[t[1]] - moved[t[0]], moved[t[2]] - moved[t[0]]);
  }
  for (std::size_t v = 0; v < tangents.size(); ++v) {
    const double length = glm::length(tangents[v]);
    tangents[v] = length > 0.0 ? tangents[v] / length : Point(rest.tangents[v]);
  }
  return tangents;
}

}  // namespace sinew::reference
