// SPDX-License-Identifier: MIT
#include "runtime/math/axis_angle.h"
#include "runtime/math/euler.h"
#include "runtime/math/matrix_rotation.h"
#include "runtime/math/quat_log_exp.h"
#include "runtime/math/rotation_between.h"
#include "tests/math/numeric_variants.h"
#include "tests/support/numeric_read.h"

namespace sinew::test {
namespace {

using Q = Quat<float>;
using V = Vec3<float>;

V vector_part(const Q& q) { return {q.x, q.y, q.z}; }
float plain_length(const V& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

/// The operations log, exp and pow, from a given logarithm and exponential.
template <class T, class Log, class Exp>
Outcome log_exp_pow(const Json& in, Log log, Exp exp) {
  if (in["op"] == "log") return {{"v", numbers(log(quat<T>(in["q"])))}};
  if (in["op"] == "exp") return {{"q", numbers(exp(vec3<T>(in["v"])))}};
  if (in["op"] == "pow") return {{"q", numbers(exp(log(quat<T>(in["q"])) * scalar<T>(in["t"])))}};
  return {};
}

Q exp_by_plain_length(const V& v) {
  const float phi = plain_length(v);
  const V u = phi > 0 ? v * (std::sin(phi) / phi) : v;
  return quat_xyzw(u.x, u.y, u.z, std::cos(phi));
}

V log_by_acos(const Q& q) {
  const float phi = std::acos(q.w), s = std::sin(phi);
  return std::abs(s) > 1e-6f ? vector_part(q) * (phi / s) : vector_part(q);
}

V log_by_plain_length(const Q& q) {
  const float length = plain_length(vector_part(q));
  return vector_part(q) * (std::atan2(length, q.w) / length);
}

template <class T>
Outcome axis_angle_outcome(const Json& in) {
  if (in["op"] == "to_quat") return {{"q", numbers(quat_from_axis_angle(vec3<T>(in["axis"]), scalar<T>(in["angle"])))}};
  if (in["op"] == "to_matrix")
    return {{"m", numbers(matrix_from_axis_angle(vec3<T>(in["axis"]), scalar<T>(in["angle"])))}};
  if (in["op"] != "from_quat") return {};
  const auto found = axis_angle_from_quat(quat<T>(in["q"]));
  return {{"axis", numbers(found.axis)}, {"angle", numbers(found.angle_rad)}};
}

Outcome axis_angle_plain(const Json& in) {
  if (in["op"] == "to_quat") {
    const V axis = vec3<float>(in["axis"]);
    const V v = axis / plain_length(axis) * std::sin(scalar<float>(in["angle"]) / 2);
    return {{"q", numbers(quat_xyzw(v.x, v.y, v.z, std::cos(scalar<float>(in["angle"]) / 2)))}};
  }
  if (in["op"] != "from_quat") return {};
  Q q = quat<float>(in["q"]);
  if (q.w < 0) q = -q;
  return {{"axis", numbers(vector_part(q) / plain_length(vector_part(q)))}, {"angle", numbers(2 * std::acos(q.w))}};
}

template <class T>
Outcome angles(T head, T pitch, T roll) {
  return {{"h", numbers(head)}, {"p", numbers(pitch)}, {"r", numbers(roll)}};
}

template <class T>
Outcome euler_outcome(const Json& in) {
  if (in["op"] == "extract") {
    const auto e = head_pitch_roll_from_matrix(mat3<T>(in["m"]));
    return angles(e.head_rad, e.pitch_rad, e.roll_rad);
  }
  if (in["op"] != "compose") return {};
  const HeadPitchRollT<T> e{scalar<T>(in["h"]), scalar<T>(in["p"]), scalar<T>(in["r"])};
  return {{"m", numbers(matrix_from_head_pitch_roll(e))}, {"q", numbers(quat_from_head_pitch_roll(e))}};
}

Outcome euler_by_arcsine(const Json& in) {
  if (in["op"] != "extract") return {};
  const auto m = mat3<float>(in["m"]);
  return angles(std::atan2(-m[0][2], m[2][2]), std::asin(m[1][2]), std::atan2(-m[1][0], m[1][1]));
}

Outcome euler_by_clamped_arcsine(const Json& in) {
  if (in["op"] != "extract") return {};
  const auto m = mat3<float>(in["m"]);
  const float s = std::min(1.0f, std::max(-1.0f, m[1][2]));
  if (std::abs(s) > 0.9999f) return angles(0.0f, std::asin(s), std::atan2(m[0][1], m[0][0]));
  return angles(std::atan2(-m[0][2], m[2][2]), std::asin(s), std::atan2(-m[1][0], m[1][1]));
}

Q quat_by_trace(const Mat3<float>& m) {
  const float w = std::sqrt(m[0][0] + m[1][1] + m[2][2] + 1) / 2;
  return quat_xyzw((m[1][2] - m[2][1]) / (4 * w), (m[2][0] - m[0][2]) / (4 * w), (m[0][1] - m[1][0]) / (4 * w), w);
}

Q quat_by_four_roots(const Mat3<float>& m) {
  const auto root = [](float x) { return std::sqrt(std::max(0.0f, x)) / 2; };
  const float x = m[0][0], y = m[1][1], z = m[2][2];
  return quat_xyzw(std::copysign(root(1 + x - y - z), m[1][2] - m[2][1]),
                   std::copysign(root(1 - x + y - z), m[2][0] - m[0][2]),
                   std::copysign(root(1 - x - y + z), m[0][1] - m[1][0]), root(1 + x + y + z));
}

V unit_or_as_it_is(const V& v) { return v / plain_length(v); }

/// Eq. 4.56 as printed, with a half turn about some axis if 1 + s . t is below 1e-6.
Q between_by_dot(const V& from, const V& to) {
  const V s = unit_or_as_it_is(from), t = unit_or_as_it_is(to);
  const float twice = 2 * (1 + glm::dot(s, t));
  if (twice < 2e-6f) {
    const V axis = perpendicular_to(s);
    return quat_xyzw(axis.x, axis.y, axis.z, 0.0f);
  }
  const V v = glm::cross(s, t) / std::sqrt(twice);
  return quat_xyzw(v.x, v.y, v.z, std::sqrt(twice) / 2);
}

Q between_by_acos(const V& from, const V& to) {
  const V s = unit_or_as_it_is(from), t = unit_or_as_it_is(to);
  const float half = std::acos(glm::dot(s, t)) / 2;
  const V axis = unit_or_as_it_is(glm::cross(s, t)) * std::sin(half);
  return quat_xyzw(axis.x, axis.y, axis.z, std::cos(half));
}

template <class Between>
NumericVariant between(const std::string& name, Between f) {
  return {name, [f](const Json& in) { return Outcome{{"q", numbers(f(vec3<float>(in["s"]), vec3<float>(in["t"])))}}; }};
}

}  // namespace

NumericKind quat_log_exp_pow_kind() {
  return {"quat_log_exp_pow",
          in_both_precisions("quat_log, quat_exp, quat_pow",
                             []<class T>(const Json& in) {
                               if (in["op"] == "pow")
                                 return Outcome{{"q", numbers(quat_pow(quat<T>(in["q"]), scalar<T>(in["t"])))}};
                               return log_exp_pow<T>(in, quat_log<T>, quat_exp<T>);
                             }),
          {{"acos(w), threshold 1e-6 on sin",
            [](const Json& in) { return log_exp_pow<float>(in, log_by_acos, exp_by_plain_length); }},
           {"atan2, plain squared length",
            [](const Json& in) { return log_exp_pow<float>(in, log_by_plain_length, exp_by_plain_length); }}}};
}

NumericKind axis_angle_kind() {
  return {"axis_angle",
          in_both_precisions("axis_angle", []<class T>(const Json& in) { return axis_angle_outcome<T>(in); }),
          {{"2 acos(w), plain length", axis_angle_plain}}};
}

NumericKind euler_kind() {
  return {"euler",
          in_both_precisions("head_pitch_roll", []<class T>(const Json& in) { return euler_outcome<T>(in); }),
          {{"asin, two atan2 (eq. 4.25)", euler_by_arcsine},
           {"asin clamped, gimbal branch at 0.9999", euler_by_clamped_arcsine}}};
}

NumericKind quat_to_matrix_kind() {
  return {"quat_to_matrix",
          in_both_precisions("matrix_from_quat",
                             []<class T>(const Json& in) {
                               return Outcome{{"m", numbers(matrix_from_quat(quat<T>(in["q"])))}};
                             }),
          {{"unit length assumed (eq. 4.46)", [](const Json& in) {
              return Outcome{{"m", numbers(matrix_from_unit_quat(quat<float>(in["q"])))}};
            }}}};
}

NumericKind matrix_to_quat_kind() {
  return {"matrix_to_quat",
          in_both_precisions("quat_from_matrix",
                             []<class T>(const Json& in) {
                               return Outcome{{"q", numbers(quat_from_matrix(mat3<T>(in["m"])))}};
                             }),
          {{"trace only (eq. 4.49)",
            [](const Json& in) {
              return Outcome{{"q", numbers(quat_by_trace(mat3<float>(in["m"])))}};
            }},
           {"four square roots with copysign", [](const Json& in) {
              return Outcome{{"q", numbers(quat_by_four_roots(mat3<float>(in["m"])))}};
            }}}};
}

NumericKind vector_to_vector_kind() {
  return {"vector_to_vector",
          in_both_precisions("rotation_between",
                             []<class T>(const Json& in) {
                               return Outcome{{"q", numbers(rotation_between(vec3<T>(in["s"]), vec3<T>(in["t"])))}};
                             }),
          {between("eq. 4.56, fallback below 1e-6", between_by_dot),
           between("acos and normalised cross product", between_by_acos)}};
}

}  // namespace sinew::test
