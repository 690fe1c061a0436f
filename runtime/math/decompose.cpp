// SPDX-License-Identifier: MIT
#include "runtime/math/decompose.h"

#include <limits>
#include <utility>

#include "runtime/math/determinant_sign.h"
#include "runtime/math/matrix_rotation.h"
#include "runtime/math/normal_transform.h"
#include "runtime/math/rotation_between.h"

namespace sinew {
namespace {

using Vec = Vec3<double>;
using Mat = Mat3<double>;

/// m * v with perpendicular columns, longest first; v is a rotation.
struct Orthogonalised {
  Mat columns;
  Mat v;
};

bool finite(const Mat& m) noexcept {
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      if (!std::isfinite(m[c][r])) return false;
  return true;
}

/// Rotates columns i and j until they are perpendicular; false if they already were.
bool rotate_columns(Mat& b, Mat& v, int i, int j) noexcept {
  const double ii = glm::dot(b[i], b[i]), jj = glm::dot(b[j], b[j]), ij = glm::dot(b[i], b[j]);
  if (std::abs(ij) <= std::numeric_limits<double>::epsilon() * std::sqrt(ii) * std::sqrt(jj)) return false;
  const double zeta = (jj - ii) / (2.0 * ij);
  const double tangent = std::copysign(1.0, zeta) / (std::abs(zeta) + std::hypot(1.0, zeta));
  const double c = 1.0 / std::hypot(1.0, tangent), s = c * tangent;
  for (Mat* m : {&b, &v}) {
    const Vec a = (*m)[i];
    (*m)[i] = a * c - (*m)[j] * s;
    (*m)[j] = a * s + (*m)[j] * c;
  }
  return true;
}

/// Exchanges two columns; the sign keeps v a rotation.
void swap_columns(Orthogonalised& o, int i, int j) noexcept {
  for (Mat* m : {&o.columns, &o.v}) {
    const Vec a = (*m)[i];
    (*m)[i] = (*m)[j];
    (*m)[j] = -a;
  }
}

Orthogonalised orthogonalise(const Mat& m) noexcept {
  Orthogonalised o{m, Mat(1.0)};
  constexpr int kMaxSweeps = 20;  // converges quadratically: 3 to 6 sweeps are seen
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    const bool a = rotate_columns(o.columns, o.v, 0, 1);
    const bool b = rotate_columns(o.columns, o.v, 0, 2);
    const bool c = rotate_columns(o.columns, o.v, 1, 2);
    if (!a && !b && !c) break;
  }
  const auto longer = [&](int i, int j) { return safe_length(o.columns[i]) < safe_length(o.columns[j]); };
  if (longer(0, 1)) swap_columns(o, 0, 1);
  if (longer(1, 2)) swap_columns(o, 1, 2);
  if (longer(0, 1)) swap_columns(o, 0, 1);
  return o;
}

/// R S = m. Singular values below `rounding` times the largest count as rounding noise.
PolarT<double> polar_of(const Mat& m, double rounding) noexcept {
  PolarT<double> out;
  if (!finite(m)) {
    out.status = DecomposeStatus::not_finite;
    return out;
  }
  const double largest = largest_entry(m);
  int exponent = 0;
  std::frexp(largest, &exponent);
  Mat scaled = m;  // by a power of two: exact
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) scaled[c][r] = std::ldexp(m[c][r], -exponent);

  const Orthogonalised o = orthogonalise(scaled);
  Vec sigma(safe_length(o.columns[0]), safe_length(o.columns[1]), safe_length(o.columns[2]));
  const Vec u0 = normalised_or(o.columns[0], o.v[0]);
  const Vec second = o.columns[1] - u0 * glm::dot(u0, o.columns[1]);
  // With rank 1 or 0 the second axis is arbitrary. That of v gives the smallest rotation.
  const Vec kept = o.v[1] - u0 * glm::dot(u0, o.v[1]);
  const Vec free_axis = glm::dot(kept, kept) > 0.25 ? normalised_or(kept, kept) : perpendicular_to(u0);
  const bool rank_two = sigma.y > rounding * sigma.x;
  const Vec u1 = rank_two ? normalised_or(second, free_axis) : free_axis;
  const Vec u2 = glm::cross(u0, u1);
  if (!rank_two) sigma.y = glm::dot(u1, o.columns[1]);
  sigma.z = glm::dot(u2, o.columns[2]);
  const int sign = determinant_sign(m);
  if (rank_two && (sigma.z < 0.0) != (sign < 0)) sigma.z = -sigma.z;  // its sign was rounding noise

  const bool singular = !rank_two || !(std::abs(sigma.z) > rounding * sigma.x);
  const bool mirrored = !singular && sign < 0;
  // u2 makes the frame right-handed. For a mirroring m, u0 and u1 are negated and all singular values become negative.
  const double side = mirrored ? -1.0 : 1.0;
  const Mat u(u0 * side, u1 * side, u2);
  const Vec d(sigma.x * side, sigma.y * side, sigma.z);
  out.rotation = u * glm::transpose(o.v);
  out.quat = quat_from_matrix(out.rotation);
  const auto entry = [&](int r, int c) {
    const double sum = o.v[0][r] * d.x * o.v[0][c] + o.v[1][r] * d.y * o.v[1][c] + o.v[2][r] * d.z * o.v[2][c];
    return std::ldexp(sum, exponent);
  };
  constexpr int kRow[6] = {0, 1, 2, 0, 0, 1}, kColumn[6] = {0, 1, 2, 1, 2, 2};
  for (int i = 0; i < 6; ++i) out.stretch[i] = entry(kRow[i], kColumn[i]);
  out.status = singular ? DecomposeStatus::singular : (mirrored ? DecomposeStatus::mirrored : DecomposeStatus::ok);
  return out;
}

/// Replaces the columns of length zero, so that the three are a right-handed frame where possible. If all are zero
/// they stay as they are.
Mat complete_frame(Mat unit, const bool (&known)[3]) noexcept {
  const int count = known[0] + known[1] + known[2];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (count == 2 && !known[i]) unit[i] = normalised_or(glm::cross(unit[j], unit[k]), perpendicular_to(unit[j]));
    if (count == 1 && known[i]) {
      unit[j] = perpendicular_to(unit[i]);
      unit[k] = glm::cross(unit[i], unit[j]);
    }
  }
  return unit;
}

TrsT<double> trs_of(const AffineT<double>& m, double rounding) noexcept {
  TrsT<double> out;
  Mat linear = linear_part(m);
  out.transform.translation = translation_of(m);
  if (!finite(linear)) {
    out.status = DecomposeStatus::not_finite;
    return out;
  }
  bool known[3];
  Mat unit(1.0);
  Vec& scale = out.transform.scale;
  for (int c = 0; c < 3; ++c) {
    scale[c] = safe_length(linear[c]);
    known[c] = scale[c] > 0.0;
    if (known[c]) unit[c] = normalised_or(linear[c], unit[c]);
  }
  const bool flat = !(known[0] && known[1] && known[2]);
  if (flat) unit = complete_frame(unit, known);
  const bool mirrored = determinant_sign(linear) < 0;
  if (mirrored) {
    scale.x = -scale.x;
    unit[0] = -unit[0];
  }
  const double skew = std::max({std::abs(glm::dot(unit[0], unit[1])), std::abs(glm::dot(unit[0], unit[2])),
                                std::abs(glm::dot(unit[1], unit[2]))});
  const PolarT<double> nearest = polar_of(unit, rounding);
  out.transform.rotation = nearest.quat;
  if (flat || nearest.status == DecomposeStatus::singular)
    out.status = DecomposeStatus::singular;
  else if (skew > 64.0 * rounding)
    out.status = DecomposeStatus::sheared;
  else if (mirrored)
    out.status = DecomposeStatus::mirrored;
  return out;
}

/// Singular values smaller than this times the largest are rounding noise of T.
template <class T>
constexpr double kRounding = 4.0 * static_cast<double>(std::numeric_limits<T>::epsilon());

/// Rounding a singular stretch to T can flip the sign of its determinant, which decides the side of normals. This moves
/// the eigenvalues by the size of that rounding until the sign is that of the matrix. For sign 0 a positive determinant
/// is fine too.
template <class T>
void keep_side(int sign, PolarT<T>& polar) noexcept {
  T* s = polar.stretch;
  const T step = std::max({std::abs(s[0]), std::abs(s[1]), std::abs(s[2])}) * std::numeric_limits<T>::epsilon();
  constexpr int kMostSteps = 4;  // larger singular values do not count as singular
  for (int i = 0; i < kMostSteps; ++i) {
    const int found = determinant_sign(matrix_from_stretch(polar.stretch));
    if (found == sign || (sign == 0 && found > 0)) return;
    for (int axis = 0; axis < 3; ++axis) s[axis] += sign < 0 ? -step : step;
  }
}

template <class T>
PolarT<T> polar_in(const Mat3<T>& m) noexcept {
  const PolarT<double> p = polar_of(Mat(m), kRounding<T>);
  PolarT<T> out{Mat3<T>(p.rotation), quat_cast<T>(p.quat), {}, p.status};
  for (int i = 0; i < 6; ++i) out.stretch[i] = static_cast<T>(p.stretch[i]);
  if (p.status == DecomposeStatus::singular) keep_side(determinant_sign(m), out);
  return out;
}

template <class T>
TrsT<T> trs_in(const AffineT<T>& m) noexcept {
  const TrsT<double> d = trs_of(affine_cast<double>(m), kRounding<T>);
  const auto& t = d.transform;
  return {{Vec3<T>(t.translation), quat_cast<T>(t.rotation), Vec3<T>(t.scale)}, d.status};
}

}  // namespace

template <>
PolarT<float> decompose_polar(const Mat3<float>& m) noexcept {
  return polar_in(m);
}

template <>
PolarT<double> decompose_polar(const Mat3<double>& m) noexcept {
  return polar_in(m);
}

template <>
TrsT<float> decompose_trs(const AffineT<float>& m) noexcept {
  return trs_in(m);
}

template <>
TrsT<double> decompose_trs(const AffineT<double>& m) noexcept {
  return trs_in(m);
}

}  // namespace sinew
