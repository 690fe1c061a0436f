// SPDX-License-Identifier: MIT
#include "runtime/jobs/skin_center_of_rotation.h"

#include "runtime/jobs/blend_matrix.h"
#include "runtime/jobs/blend_motion.h"
#include "runtime/jobs/vertex_checks.h"

namespace sinew {
namespace {

template <bool kStretch, bool kNormals, bool kTangents>
void skin(const SkinCenterOfRotationJob& job) noexcept {
  for_each_vertex(*job.influences, [&](std::size_t v, const auto& vertex) {
    const Quat<float> rotation = blend_motion(job.split, vertex).real;
    const glm::vec3 center = job.centers[v];
    const glm::vec3 moved_center = transform_point(blend_matrix(job.palette, vertex), center);
    glm::vec3 arm = job.vertices.positions[v] - center;
    Mat3<float> stretch(1.0f);
    if constexpr (kStretch) stretch = blend_stretch(job.split, vertex), arm = stretch * arm;
    job.out.positions[v] = rotate_vector(rotation, arm) + moved_center;
    if constexpr (kNormals) {
      glm::vec3 n = job.vertices.normals[v];
      if constexpr (kStretch) n = transform_normal_outward(stretch, n);
      job.out.normals[v] = normalised_or(rotate_vector(rotation, n), n);
    }
    if constexpr (kTangents) {
      const glm::vec4 tangent = job.vertices.tangents[v];
      glm::vec3 t(tangent);
      if constexpr (kStretch) t = stretch * t;
      job.out.tangents[v] = glm::vec4(normalised_or(rotate_vector(rotation, t), glm::vec3(tangent)), tangent.w);
    }
  });
}

}  // namespace

ErrorCode check(const SkinCenterOfRotationJob& job) noexcept {
  if (const auto error = check_streams(job.vertices, job.out); error != ErrorCode::ok) return error;
  const std::size_t count = job.vertices.positions.size();
  if (job.centers.size() != count || job.palette.size() != job.split.size()) return ErrorCode::size_mismatch;
  return check_influences(job.influences, count, job.palette.size());
}

void run(const SkinCenterOfRotationJob& job) noexcept {
  const auto wanted = present(job.vertices, job.out);
  with_attributes(wanted.normals, wanted.tangents, [&](auto normals, auto tangents) {
    if (job.any_stretch) skin<true, normals, tangents>(job);
    else skin<false, normals, tangents>(job);
  });
}

}  // namespace sinew
