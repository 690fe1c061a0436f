// SPDX-License-Identifier: MIT
#include "runtime/jobs/skin_linear.h"

#include "runtime/jobs/blend_matrix.h"
#include "runtime/jobs/vertex_checks.h"
#include "runtime/math/normal_transform.h"

namespace sinew {
ErrorCode check(const SkinLinearJob& job) noexcept {
  if (const auto error = check_streams(job.vertices, job.out); error != ErrorCode::ok) return error;
  return check_influences(job.influences, job.vertices.positions.size(), job.palette.size());
}

void run(const SkinLinearJob& job) noexcept {
  const auto wanted = present(job.vertices, job.out);
  const bool cofactor_normals = job.normal_rule == NormalRule::cofactor;
  with_attributes(wanted.normals, wanted.tangents, [&](auto normals, auto tangents) {
    for_each_vertex(*job.influences, [&](std::size_t v, const auto& vertex) {
      const Affine m = blend_matrix(job.palette, vertex);
      if constexpr (normals) {
        const glm::vec3 n = job.vertices.normals[v];
        job.out.normals[v] = cofactor_normals ? transform_normal(linear_part(m), n) : normalised_or(transform_vector(m, n), n);
      }
      if constexpr (tangents) {
        const glm::vec4 t = job.vertices.tangents[v];
        job.out.tangents[v] = glm::vec4(normalised_or(transform_vector(m, glm::vec3(t)), glm::vec3(t)), t.w);
      }
      job.out.positions[v] = transform_point(m, job.vertices.positions[v]);
    });
  });
}

}  // namespace sinew
