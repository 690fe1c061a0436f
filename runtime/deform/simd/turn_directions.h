// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/normal_transform.h"

namespace sinew {

/// The normal and the tangent of vertex `v`, stretched and then turned: what dual quaternions and centers of rotation
/// share. eq   n' = R sign(det S) cof(S) n, t' = R S t, unit   (conventions.h)
template <bool kStretch, class In, class Out>
void turn_directions(const Quat<float>& rotation, const Mat3<float>& stretch, const In& in, const Out& out,
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
