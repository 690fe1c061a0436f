// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "runtime/math/quat_log_exp.h"
#include "runtime/transition/inertialize.h"

namespace sinew {
namespace {

using Vec = Vec3<double>;

constexpr std::size_t kPlanesOfPart = 8;

/// An offset x and its velocity per duration, k x + r with r perpendicular to x.
template <class V>
struct Offset {
  V x;
  double k;
  V r;
};

double product(double a, double b) noexcept { return a * b; }
double product(const Vec& a, const Vec& b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }

template <class V>
Offset<V> offset_of(const V& x, const V& v) noexcept {
  constexpr double kNoLength2 = 1e-20;  // squared length below which an offset has no direction
  const double length2 = product(x, x);
  if (!(length2 > kNoLength2)) return {x, 0.0, v};
  const double k = product(v, x) / length2;
  return {x, k, v - x * k};
}

/// Rotation vector of q: twice its logarithm. q and -q give different vectors.
Vec turn_of(const Quat<double>& q) noexcept { return quat_log(q) * 2.0; }

/// Upper bound of the rotation's angle during the transition, in radians.
double largest_turn(const Offset<Vec>& turn) noexcept {
  const double k = std::max(turn.k, 0.0), lengthened = (4.0 / 5.0) * (k + 5.0) / (k + 4.0);
  const double peak = k > 0.0 ? lengthened * lengthened * lengthened * lengthened * (1.0 + k / 5.0) : 1.0;
  constexpr double kMostAcross = 0.08192;  // maximum of u (1 - u)^4
  return std::sqrt(product(turn.x, turn.x)) * peak + kMostAcross * std::sqrt(product(turn.r, turn.r));
}

Offset<Vec> rotation_offset(const InertializeStart& start, double steps, std::size_t j) noexcept {
  const auto between = [&](const TransitionPose& source, const TransitionPose& target) {
    return quat_cast<double>(source.pose.get(j).rotation) *
           quat_conjugate(quat_cast<double>(target.pose.get(j).rotation));
  };
  Quat<double> now = between(start.source, start.target), before = between(start.source_before, start.target_before);
  if (now.w < 0.0) now = now * -1.0;
  if (quat_dot(now, before) < 0.0) before = before * -1.0;
  const Vec x = turn_of(now);
  constexpr double kHalfTurn = 3.14159265358979;
  const Offset<Vec> moving = offset_of(x, (x - turn_of(before)) * steps);
  return largest_turn(moving) <= kHalfTurn ? moving : Offset<Vec>{x, 0.0, Vec(0.0)};
}

/// A quarter of the rotation, which the series of the kernel need. Invisibly small components become 0, since their
/// squares would be denormal numbers.
Offset<Vec> quarter_of(const Offset<Vec>& turn) noexcept {
  const auto seen = [](const Vec& v) {
    const auto or_zero = [](double x) { return std::abs(x) < 1e-9 ? 0.0 : x * 0.25; };
    return product(v, v) < 1e-14 ? Vec(0.0) : Vec(or_zero(v.x), or_zero(v.y), or_zero(v.z));
  };
  return {seen(turn.x), turn.k, seen(turn.r)};
}

void set(const TransitionNumbers& numbers, std::size_t plane, std::size_t j, const Offset<Vec>& offset) noexcept {
  const double values[kPlanesOfPart] = {
      offset.x.x, offset.x.y, offset.x.z, std::max(1.0, offset.k / -5.0), std::max(offset.k, -5.0) + 4.0,
      offset.r.x, offset.r.y, offset.r.z};
  for (std::size_t i = 0; i < kPlanesOfPart; ++i) numbers.plane(plane + i)[j] = static_cast<float>(values[i]);
}

void make_number_offsets(const InertializeStart& start, std::span<float> TransitionPose::*of, double steps,
                         std::span<float> out) noexcept {
  for (std::size_t i = 0; i < (start.source.*of).size(); ++i) {
    const auto between = [&](const TransitionPose& source, const TransitionPose& target) {
      return double{(source.*of)[i]} - double{(target.*of)[i]};
    };
    const double x = between(start.source, start.target);
    const double v = (x - between(start.source_before, start.target_before)) * steps;
    const Offset<double> offset = offset_of(x, v);
    out[3 * i] = static_cast<float>(offset.x);
    out[3 * i + 1] = static_cast<float>(offset.k);
    out[3 * i + 2] = static_cast<float>(offset.r);
  }
}

void find_still_blocks(const TransitionNumbers& numbers) noexcept {
  constexpr std::size_t kBlock = TransitionNumbers::kBlock, kFlags = 24;
  for (std::size_t j = 0; j < numbers.stride(); j += kBlock)
    for (std::size_t part = 0; part < 3; ++part) {
      bool moves = false;
      for (const std::size_t p : {0, 1, 2, 5, 6, 7}) {
        const float* const of = numbers.plane(part * kPlanesOfPart + p) + j;
        moves |= std::any_of(of, of + kBlock, [](float x) { return x != 0.0f; });
      }
      numbers.plane(kFlags)[j + part] = moves ? 1.0f : 0.0f;
    }
}

}  // namespace

void make_offsets(const InertializeStart& start, const TransitionNumbers& numbers) noexcept {
  const double steps = start.steps;
  for (std::size_t j = 0; j < numbers.joint_count; ++j) {
    const auto vector_offset = [&](glm::vec3 Transform::*of) {
      const auto between = [&](const TransitionPose& source, const TransitionPose& target) {
        return Vec(source.pose.get(j).*of) - Vec(target.pose.get(j).*of);
      };
      const Vec x = between(start.source, start.target);
      return offset_of(x, (x - between(start.source_before, start.target_before)) * steps);
    };
    set(numbers, 0, j, vector_offset(&Transform::translation));
    set(numbers, 8, j, quarter_of(rotation_offset(start, steps, j)));
    set(numbers, 16, j, vector_offset(&Transform::scale));
  }
  for (std::size_t p = 0; p < TransitionNumbers::kPlanes; ++p)
    std::fill(numbers.plane(p) + numbers.joint_count, numbers.plane(p) + numbers.stride(), 0.0f);
  find_still_blocks(numbers);
  make_number_offsets(start, &TransitionPose::weights, steps, numbers.weights);
  make_number_offsets(start, &TransitionPose::properties, steps, numbers.properties);
}

}  // namespace sinew
