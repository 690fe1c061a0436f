// SPDX-License-Identifier: MIT
#include "runtime/procedures/chain/best_rotation.h"

#include <cmath>

namespace sinew::ik {

Quat<double> BestRotation::rotation() const noexcept {
  const auto at = [&](int row, int column) { return sum_[column][row]; };
  const double trace = at(0, 0) + at(1, 1) + at(2, 2);
  const Vec3<double> z(at(2, 1) - at(1, 2), at(0, 2) - at(2, 0), at(1, 0) - at(0, 1));
  double squares = 0.0;
  for (int c = 0; c < 3; ++c) squares += glm::dot(sum_[c], sum_[c]);
  if (!(squares > 0.0) || !std::isfinite(squares)) return quat_identity<double>();
  // Rows and columns are x y z w. All eigenvalues lie within +-sqrt(3 squares), so the shift makes them positive.
  glm::dmat4 power(0.0);
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) power[c][r] = at(r, c) + at(c, r) - (r == c ? trace : 0.0);
    power[3][r] = power[r][3] = z[r];
  }
  power[3][3] = trace;
  const double shift = std::sqrt(3.0 * squares);
  for (int i = 0; i < 4; ++i) power[i][i] += shift;
  // The matrix to the power of 2^14: an eigenvalue that is smaller by a thousandth then counts 1e-7.
  for (int i = 0; i < 14; ++i) {
    power = power / (power[0][0] + power[1][1] + power[2][2] + power[3][3]);
    power = power * power;
  }
  const glm::dvec4 near = power[3];
  if (glm::dot(near, near) > 1e-24 * glm::dot(power[0], power[0]))
    return normalised(quat_xyzw(near.x, near.y, near.z, near.w));
  // The best rotation is a half turn, so the identity has no component along its eigenvector.
  int longest = 0;
  for (int i = 1; i < 3; ++i)
    if (power[i][i] > power[longest][longest]) longest = i;
  const glm::dvec4 turn = power[longest];
  return normalised(quat_xyzw(turn.x, turn.y, turn.z, turn.w));
}

}  // namespace sinew::ik
