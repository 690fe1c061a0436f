// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/matrix_rotation.h"

namespace sinew::ik {

/// Finds the rotation that best maps a set of vectors to their targets. Internal to procedures/
class BestRotation {
 public:
  /// Adds a pair: the rotation should turn `from` to `to`.
  void add(const Vec3<double>& from, const Vec3<double>& to, double weight) noexcept {
    sum_ += glm::outerProduct(to, from) * weight;
  }
  /// Adds a wish for a whole rotation.
  void add(const Quat<double>& rotation, double weight) noexcept { sum_ += matrix_from_unit_quat(rotation) * weight; }

  /// The rotation q with the least sum of weight |q from - to|^2. If many are equally good, the one with the smallest
  /// angle; the identity if all are equally good.
  /// eq   the largest eigenvector of Davenport's matrix, as the limit of high powers of the matrix applied to the
  ///      identity
  Quat<double> rotation() const noexcept;

 private:
  Mat3<double> sum_{0.0};
};

}  // namespace sinew::ik
