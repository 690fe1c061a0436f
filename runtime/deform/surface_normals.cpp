// SPDX-License-Identifier: MIT
#include "runtime/deform/surface_normals.h"

#include <algorithm>

#include "runtime/math/quaternion.h"

namespace sinew {

void run(const SurfaceNormalsJob& job) noexcept {
  const SurfaceFaces& faces = *job.faces;
  std::fill(job.sums.begin(), job.sums.end(), Vec3<double>(0.0));
  for (std::size_t i = 0; i < faces.corners.size(); i += 3) {
    const std::uint32_t* const corners = &faces.corners[i];
    const Vec3<double> a(job.positions[corners[0]]), b(job.positions[corners[1]]), c(job.positions[corners[2]]);
    const Vec3<double> n = glm::cross(b - a, c - a);
    for (int k = 0; k < 3; ++k) job.sums[faces.point_of_vertex[corners[k]]] += n;
  }
  const double sign = job.turned ? -1.0 : 1.0;
  for (std::size_t v = 0; v < job.normals.size(); ++v)
    job.normals[v] =
        glm::vec3(normalised_or(sign * job.sums[faces.point_of_vertex[v]], Vec3<double>(job.rest_normals[v])));
}

void run(const SurfaceTangentsJob& job) noexcept {
  const SurfaceFaces& faces = *job.faces;
  for (glm::vec4& tangent : job.tangents) tangent = glm::vec4(0.0f);
  for (std::size_t i = 0; i < faces.corners.size(); ++i) {
    const std::uint32_t* const triangle = &faces.corners[i / 3 * 3];
    const glm::vec3 a = job.positions[triangle[0]], ab = job.positions[triangle[1]] - a,
                    ac = job.positions[triangle[2]] - a;
    job.tangents[faces.corners[i]] += glm::vec4(faces.tangents[i].x * ab + faces.tangents[i].y * ac, 0.0f);
  }
  for (std::size_t v = 0; v < job.tangents.size(); ++v) {
    const glm::vec4 rest = job.rest_tangents[v];
    job.tangents[v] = glm::vec4(glm::vec3(normalised_or(Vec3<double>(job.tangents[v]), Vec3<double>(rest))), rest.w);
  }
}

}  // namespace sinew
