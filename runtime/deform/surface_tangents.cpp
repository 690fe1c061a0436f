// SPDX-License-Identifier: MIT
#include "runtime/deform/surface_normals.h"

#include <cassert>

#include "runtime/math/quaternion.h"

namespace sinew {

ErrorCode check(const SurfaceTangentsJob& job) noexcept {
  const std::size_t count = job.positions.size();
  if (job.faces == nullptr || job.faces->tangents.size() != job.faces->corners.size()) return ErrorCode::size_mismatch;
  if (job.rest_tangents.size() != count || job.tangents.size() != count) return ErrorCode::size_mismatch;
  if (!have_memory(job.positions, job.rest_tangents, job.tangents)) return ErrorCode::size_mismatch;
  return check_indices(*job.faces, count);
}

void run_unchecked(const SurfaceTangentsJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  const SurfaceFaces& faces = *job.faces;
  for (glm::vec4& tangent : job.tangents) tangent = glm::vec4(0.0f);
  for (std::size_t i = 0; i < faces.corners.size(); i += 3) {
    const std::uint32_t* const corners = &faces.corners[i];
    const glm::vec3 a = job.positions[corners[0]], ab = job.positions[corners[1]] - a,
                    ac = job.positions[corners[2]] - a;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec2 along = faces.tangents[i + k];
      job.tangents[corners[k]] += glm::vec4(along.x * ab + along.y * ac, 0.0f);
    }
  }
  for (std::size_t v = 0; v < job.tangents.size(); ++v) {
    const glm::vec4 rest = job.rest_tangents[v];
    job.tangents[v] = glm::vec4(normalised_or(glm::vec3(job.tangents[v]), glm::vec3(rest)), rest.w);
  }
}

}  // namespace sinew
