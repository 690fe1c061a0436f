// SPDX-License-Identifier: MIT
#pragma once
#include <limits>
#include <optional>

#include "runtime/math/normal_transform.h"
#include "runtime/math/transform.h"

namespace sinew {

/// Inverses by the structure of the matrix. The most special one that applies is the cheapest and the most accurate
/// (Real-Time Rendering, 4.1.8).

/// Inverse of a rotation and translation.
/// eq   (T(t) R)^-1 = R^T T(-t) = [R^T | -R^T t]   (Real-Time Rendering, eq. 4.17)
template <class T>
AffineT<T> inverse_rigid(const AffineT<T>& m) noexcept {
  const Mat3<T> transposed = glm::transpose(linear_part(m));
  return affine_from(transposed, -(transposed * translation_of(m)));
}

/// Inverse of translation * rotation * scale. It is a matrix, since with non-uniform scale the inverse is no T * R *
/// S.
/// eq   S^-1 R^T T(-t);  nullopt if a scale is zero
template <class T>
std::optional<AffineT<T>> inverse_of(const TransformT<T>& local) noexcept {
  const Vec3<T>& s = local.scale;
  if (s.x == T(0) || s.y == T(0) || s.z == T(0)) return std::nullopt;
  TransformT<T> rigid = local;
  rigid.scale = Vec3<T>(T(1));
  AffineT<T> out = inverse_rigid(affine_from_transform(rigid));
  for (int r = 0; r < 3; ++r) out.row[r] /= s[r];
  return out;
}

/// Inverse of any affine matrix; nullopt if its linear part is singular within rounding or not finite. The inverse
/// mirrors exactly when the matrix does.
/// eq   M^-1 = cof(M)^T / det M   (Real-Time Rendering, section 4.1.8), with each column first divided by its largest
///      entry, so that no scale overflows or looks singular
template <class T>
std::optional<AffineT<T>> inverse_of(const AffineT<T>& m) noexcept {
  Mat3<T> scaled = linear_part(m);
  Vec3<T> scale(T(1));
  for (int c = 0; c < 3; ++c) {
    scale[c] = largest_component(scaled[c]);
    if (!(scale[c] > T(0)) || !std::isfinite(scale[c])) return std::nullopt;
    scaled[c] /= scale[c];
  }
  const Mat3<T> cof = cofactor(scaled);
  const T det = glm::dot(scaled[0], cof[0]);
  // Entries are at most 1, so rounding changes the determinant by less than 6.5 epsilon: beyond this its sign is
  // right.
  if (!(std::abs(det) > T(8) * std::numeric_limits<T>::epsilon())) return std::nullopt;
  const Mat3<T> inverse =
      glm::transpose(Mat3<T>(cof[0] / det / scale.x, cof[1] / det / scale.y, cof[2] / det / scale.z));
  return affine_from(inverse, -(inverse * translation_of(m)));
}

}  // namespace sinew
