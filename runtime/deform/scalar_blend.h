// SPDX-License-Identifier: MIT
#pragma once
// Blends one vertex at a time and handles every degenerate case. The SIMD code in deform/simd leaves degenerate
// vertices to these functions.
#include <cmath>
#include <span>

#include "runtime/deform/influence_dispatch.h"
#include "runtime/math/decompose.h"
#include "runtime/math/joint_matrix.h"
#include "runtime/math/normal_transform.h"
#include "runtime/pose/joint_palette.h"

namespace sinew {

/// Factor that makes the absolute weights sum to 1 if their sum is below 0.5. Unscaled, the squared length of their
/// blend could underflow, or look like a cancelled blend. For larger sums the factor is 1, so weights keep their bits.
template <int kCount>
double weight_scale(const VertexJoints<kCount>& vertex) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < vertex.count(); ++i) sum += std::abs(static_cast<double>(vertex.weights[i]));
  return sum > 0.0 && sum < 0.5 ? 1.0 / sum : 1.0;
}

/// Weight `i` of a vertex times `scale`, multiplied in double.
template <int kCount>
float scaled_weight(const VertexJoints<kCount>& vertex, std::size_t i, double scale) noexcept {
  return static_cast<float>(static_cast<double>(vertex.weights[i]) * scale);
}

/// eq   M = sum(w_i * palette[joint_i])   (Real-Time Rendering, 4th ed., eq. 4.59); weights sum to 1 once scaled.
/// A vertex with one influence takes the joint's matrix as it is.
template <int kCount>
Affine blend_matrix(std::span<const JointMatrix> palette, const VertexJoints<kCount>& vertex,
                    double scale = 1.0) noexcept {
  const JointMatrix& first = palette[vertex.joints[0]];
  if (vertex.count() == 1) return affine_from(first);
  JointMatrix sum;
  const float first_weight = scaled_weight(vertex, 0, scale);
  for (int c = 0; c < 4; ++c) sum.column[c] = first.column[c] * first_weight;
  for (std::size_t i = 1; i < vertex.count(); ++i) {
    const JointMatrix& next = palette[vertex.joints[i]];
    const float weight = scaled_weight(vertex, i, scale);
    for (int c = 0; c < 4; ++c) sum.column[c] += next.column[c] * weight;
  }
  return affine_from(sum);
}

/// Blended rigid motion of one vertex, a unit dual quaternion.
/// eq   d = sum(w sign(r . r_pivot) d_i) / |real part|   (Kavan et al. 2008, sec. 3.4)
///      The pivot is the first influence: VertexInfluences orders them by falling weight, then by rising joint.
///      If the real part cancels (squared length below 1e-12), the vertex follows the pivot alone.
template <int kCount>
DualQuat blend_dual_quaternion(std::span<const RigidStretch> split, const VertexJoints<kCount>& vertex,
                               double scale = 1.0) noexcept {
  const DualQuat& pivot = split[vertex.joints[0]].rigid;
  if (vertex.count() == 1) return pivot;
  const float first_weight = scaled_weight(vertex, 0, scale);
  DualQuat sum{pivot.real * first_weight, pivot.dual * first_weight};
  for (std::size_t i = 1; i < vertex.count(); ++i) {
    const DualQuat& next = split[vertex.joints[i]].rigid;
    const float weight = scaled_weight(vertex, i, scale);
    const float w = quat_dot(pivot.real, next.real) < 0.0f ? -weight : weight;
    sum.real = sum.real + next.real * w;
    sum.dual = sum.dual + next.dual * w;
  }
  const float squared = quat_dot(sum.real, sum.real);
  if (!(squared > 1e-12f)) return pivot;
  const float length = std::sqrt(squared);
  return {sum.real / length, sum.dual / length};
}

/// Blended stretch in bind space, the first phase of two-phase skinning. A vertex with one influence takes the joint's
/// stretch as it is.
/// eq   S = sum(w S_i)
template <int kCount>
Mat3<float> blend_stretch(std::span<const RigidStretch> split, const VertexJoints<kCount>& vertex,
                          double scale = 1.0) noexcept {
  if (vertex.count() == 1) return matrix_from_stretch(split[vertex.joints[0]].stretch);
  float s[6] = {};
  for (std::size_t i = 0; i < vertex.count(); ++i) {
    const auto& stretch = split[vertex.joints[i]].stretch;
    const float weight = scaled_weight(vertex, i, scale);
    for (int c = 0; c < 6; ++c) s[c] += stretch[c] * weight;
  }
  return matrix_from_stretch(s);
}

/// The normal and the tangent of vertex `v`, stretched and then rotated.
/// eq   n' = R sign(det S) cof(S) n, t' = R S t, unit   (conventions.h)
template <bool kStretch, class In, class Out>
void rotate_directions(const Quat<float>& rotation, const Mat3<float>& stretch, const In& in, const Out& out,
                       std::size_t v) noexcept {
  if (out.normals) {
    glm::vec3 n = in.normals[v];
    if constexpr (kStretch) n = transform_normal_outward(stretch, n);
    out.normals[v] = normalised_or(rotate_vector(rotation, n), n);
  }
  if (out.tangents) {
    const glm::vec4 tangent = in.tangents[v];
    glm::vec3 t(tangent);
    if constexpr (kStretch) t = stretch * t;
    out.tangents[v] = glm::vec4(normalised_or(rotate_vector(rotation, t), glm::vec3(tangent)), tangent.w);
  }
}

}  // namespace sinew
