// SPDX-License-Identifier: MIT
#include "runtime/jobs/skin_linear.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/jobs/skin_linear.cpp"
#include <hwy/foreach_target.h>

#include "runtime/jobs/blend_matrix.h"
#include "runtime/jobs/blend_rows-inl.h"
#include "runtime/jobs/four_vertices.h"
#include "runtime/jobs/vertex_checks.h"
#include "runtime/math/normal_transform.h"

#ifndef SINEW_SKIN_LINEAR_ONCE
#define SINEW_SKIN_LINEAR_ONCE
namespace sinew {
namespace {

/// The normal of one vertex where squares leave float's range, or the blend has none.
template <int kCount>
glm::vec3 careful_normal(std::span<const Affine> palette, const VertexJoints<kCount>& vertex, const glm::vec3& n, bool cofactor) noexcept {
  const Affine m = blend_matrix(palette, vertex);
  return cofactor ? transform_normal(linear_part(m), n) : normalised_or(transform_vector(m, n), n);
}

}  // namespace
}  // namespace sinew
#endif

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR

template <int kCount, bool kNormals, bool kTangents>
void skin_group(const SkinLinearJob& job, const InfluenceGroup& group) {
  for (std::size_t i = 0; i < group.vertex_count; ++i) {
    const std::size_t v = group.first_vertex + i;
    const auto joints = joints_of<kCount>(*job.influences, group, i);
    const glm::vec3 p = transform_point(blend_matrix(job.palette, joints), job.vertices.positions[v]);
    if constexpr (kNormals)
      job.out.normals[v] = careful_normal(job.palette, joints, job.vertices.normals[v], job.normal_rule == NormalRule::cofactor);
    if constexpr (kTangents) {
      const glm::vec4 t = job.vertices.tangents[v];
      job.out.tangents[v] = glm::vec4(careful_normal(job.palette, joints, glm::vec3(t), false), t.w);
    }
    job.out.positions[v] = p;
  }
}

#else

template <int kCount, bool kNormals, bool kTangents>
struct FourVertices {
  const SkinLinearJob& job;
  const VertexJoints<kCount> (&joints)[4];

  /// Skins the vertices at `in`, four of them and readable one float beyond, to `out`.
  HWY_ATTR void run(const VertexInput& in, const VertexOutput& out) const {
    Rows matrix[4], product[4];
    for (int k = 0; k < 4; ++k) {
      matrix[k] = blend_rows(job.palette.data(), joints[k]);
      product[k] = against(matrix[k], &in.positions[static_cast<std::size_t>(k)].x, true);
    }
    if constexpr (kTangents) tangents(matrix, in, out);
    if constexpr (kNormals) normals(matrix, in, out);
    store3(sum_rows(product, true), out.positions.data());
  }

 private:
  HWY_ATTR void normals(const Rows (&matrix)[4], const VertexInput& in, const VertexOutput& out) const {
    const bool cofactor = job.normal_rule == NormalRule::cofactor;
    Rows product[4];
    for (int k = 0; k < 4; ++k)
      product[k] = against(cofactor ? cofactor_rows(matrix[k]) : matrix[k], &in.normals[static_cast<std::size_t>(k)].x, false);
    Lanes3 n = sum_rows(product, false);
    if (normalise(n)) return store3(n, out.normals.data());
    glm::vec3 careful[4];
    for (std::size_t k = 0; k < 4; ++k) careful[k] = careful_normal(job.palette, joints[k], in.normals[k], cofactor);
    std::copy_n(careful, 4, out.normals.begin());
  }

  HWY_ATTR void tangents(const Rows (&matrix)[4], const VertexInput& in, const VertexOutput& out) const {
    Rows product[4];
    for (int k = 0; k < 4; ++k) product[k] = against(matrix[k], &in.tangents[static_cast<std::size_t>(k)].x, false);
    Lanes3 t = sum_rows(product, false);
    if (normalise(t)) {
      const D4 d;
      V4 x, y, z, handedness;
      hn::LoadInterleaved4(d, &in.tangents[0].x, x, y, z, handedness);
      return hn::StoreInterleaved4(t.x, t.y, t.z, handedness, d, &out.tangents[0].x);
    }
    glm::vec4 careful[4];
    for (std::size_t k = 0; k < 4; ++k) {
      const glm::vec4 tangent = in.tangents[k];
      careful[k] = glm::vec4(careful_normal(job.palette, joints[k], glm::vec3(tangent), false), tangent.w);
    }
    std::copy_n(careful, 4, out.tangents.begin());
  }
};

template <int kCount, bool kNormals, bool kTangents>
void skin_group(const SkinLinearJob& job, const InfluenceGroup& group) {
  for_each_four<kCount, kNormals, kTangents>(
      *job.influences, group, job.vertices, job.out,
      [&](const VertexJoints<kCount>(&joints)[4], const VertexInput& in, const VertexOutput& out)
          HWY_ATTR { FourVertices<kCount, kNormals, kTangents>{job, joints}.run(in, out); });
}

#endif  // HWY_TARGET

void skin_linear(const SkinLinearJob& job) {
  const auto wanted = present(job.vertices, job.out);
  with_attributes(wanted.normals, wanted.tangents, [&](auto normals, auto tangents) {
    for (const auto& group : job.influences->groups)
      with_influence_count(group.influence_count, [&](auto count) { skin_group<count, normals, tangents>(job, group); });
  });
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {
HWY_EXPORT(skin_linear);
}  // namespace

ErrorCode check(const SkinLinearJob& job) noexcept {
  if (const auto error = check_streams(job.vertices, job.out); error != ErrorCode::ok) return error;
  return check_influences(job.influences, job.vertices.positions.size(), job.palette.size());
}

void run(const SkinLinearJob& job) noexcept { HWY_DYNAMIC_DISPATCH(skin_linear)(job); }

}  // namespace sinew
#endif
