// SPDX-License-Identifier: MIT
#include "runtime/jobs/skin_dual_quaternion.h"

#include "runtime/jobs/blend_motion.h"
#include "runtime/jobs/vertex_checks.h"

namespace sinew {
namespace {

template <bool kStretch, bool kNormals, bool kTangents>
void skin(const SkinDualQuaternionJob& job) noexcept {
  for_each_vertex(*job.influences, [&](std::size_t v, const auto& vertex) {
    const DualQuat motion = blend_motion(job.split, vertex);
    glm::vec3 p = job.vertices.positions[v];
    Mat3<float> stretch(1.0f);
    if constexpr (kStretch) stretch = blend_stretch(job.split, vertex), p = stretch * p;
    job.out.positions[v] = transform_point(motion, p);
    if constexpr (kNormals) {
      glm::vec3 n = job.vertices.normals[v];
      if constexpr (kStretch) n = transform_normal(stretch, n);
      job.out.normals[v] = normalised_or(transform_vector(motion, n), n);
    }
    if constexpr (kTangents) {
      const glm::vec4 tangent = job.vertices.tangents[v];
      glm::vec3 t(tangent);
      if constexpr (kStretch) t = stretch * t;
      job.out.tangents[v] = glm::vec4(normalised_or(transform_vector(motion, t), glm::vec3(tangent)), tangent.w);
    }
  });
}

}  // namespace

ErrorCode check(const SkinDualQuaternionJob& job) noexcept {
  if (const auto error = check_streams(job.vertices, job.out); error != ErrorCode::ok) return error;
  return check_influences(job.influences, job.vertices.positions.size(), job.split.size());
}

void run(const SkinDualQuaternionJob& job) noexcept {
  const auto wanted = present(job.vertices, job.out);
  with_attributes(wanted.normals, wanted.tangents, [&](auto normals, auto tangents) {
    if (job.any_stretch) skin<true, normals, tangents>(job);
    else skin<false, normals, tangents>(job);
  });
}

}  // namespace sinew
