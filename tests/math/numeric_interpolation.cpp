// SPDX-License-Identifier: MIT
#include "runtime/math/interpolate.h"
#include "tests/math/numeric_variants.h"
#include "tests/support/numeric_read.h"

namespace sinew::test {
namespace {

using Q = Quat<float>;
using Blend = Q (*)(const Q&, const Q&, float);

NumericVariant of_two_keys(const std::string& name, Blend blend) {
  return {name, [blend](const Json& in) {
            return Outcome{{"q", numbers(blend(quat<float>(in["q"]), quat<float>(in["r"]), scalar<float>(in["t"])))}};
          }};
}

Q plain_unit(const Q& q) { return q / std::sqrt(quat_dot(q, q)); }

/// Slerp by eq. 4.53 with the angle from acos. If the dot product exceeds `threshold`, nlerp is used.
Q acos_slerp(const Q& q, const Q& r, float t, float threshold, bool align) {
  const Q s = align ? aligned_with(q, r) : r;
  const float d = quat_dot(q, s);
  if (d > threshold) return plain_unit(q * (1 - t) + s * t);
  const float a = std::acos(d);
  return plain_unit((q * std::sin((1 - t) * a) + s * std::sin(t * a)) / std::sin(a));
}

/// Slerp by the series of sin(t a) / sin(a) in cos(a) - 1, with eight terms, the last one corrected (Eberly 2011).
Q short_polynomial_slerp(const Q& q, const Q& r, float t) {
  const Q s = aligned_with(q, r);
  const float x = quat_dot(q, s) - 1, mu = 1.85298109240830f;
  const auto weight = [&](float u) {
    float sum = 1;
    for (int i = 8; i >= 1; --i) {
      const float n = static_cast<float>(i), scale = i == 8 ? mu : 1;
      sum = 1 + scale * (u * u / (n * (2 * n + 1)) - n / (2 * n + 1)) * x * sum;
    }
    return u * sum;
  };
  return q * weight(1 - t) + s * weight(t);
}

Outcome squad_outcome(const Q (&k)[4], float t, bool align, Blend blend) {
  Q key[4] = {k[0], k[1], k[2], k[3]};
  for (int i = 1; i < 4 && align; ++i) key[i] = aligned_with(key[i - 1], key[i]);
  const Q a0 = squad_control(key[0], key[1], key[2]), a1 = squad_control(key[1], key[2], key[3]);
  const Q q = blend(blend(key[1], key[2], t), blend(a0, a1, t), 2 * t * (1 - t));
  return {{"q", numbers(q)}, {"a0", numbers(a0)}, {"a1", numbers(a1)}};
}

NumericVariant naive_squad(const std::string& name, bool align, Blend blend) {
  return {name, [align, blend](const Json& in) {
            const Json& j = in["keys"];
            const Q keys[4] = {quat<float>(j[0]), quat<float>(j[1]), quat<float>(j[2]), quat<float>(j[3])};
            return squad_outcome(keys, scalar<float>(in["t"]), align, blend);
          }};
}

/// Evaluates a Hermite case with `curve(v0, out0, in1, v1, s, td)`. The result has the name that the case expects.
template <class T, class Curve>
Outcome hermite_outcome(const Json& in, Curve curve) {
  const T t0 = scalar<T>(in["t0"]), td = scalar<T>(in["t1"]) - t0, s = (scalar<T>(in["t"]) - t0) / td;
  if (in["op"] == "vec3")
    return {{"v", numbers(curve(vec3<T>(in["v0"]), vec3<T>(in["out_tangent0"]), vec3<T>(in["in_tangent1"]),
                                vec3<T>(in["v1"]), s, td))}};
  return {{"q", numbers(curve(quat<T>(in["v0"]), quat<T>(in["out_tangent0"]), quat<T>(in["in_tangent1"]),
                              quat<T>(in["v1"]), s, td))}};
}

template <class V>
constexpr bool kIsRotation = V::length() == 4;

Outcome hermite_expanded(const Json& in) {
  return hermite_outcome<float>(in, [](auto v0, auto b, auto a, auto v1, float s, float td) {
    const float s2 = s * s, s3 = s2 * s;
    auto v = v0 * (2 * s3 - 3 * s2 + 1) + b * (td * (s3 - 2 * s2 + s)) + v1 * (-2 * s3 + 3 * s2) + a * (td * (s3 - s2));
    if constexpr (kIsRotation<decltype(v)>) v = plain_unit(v);
    return v;
  });
}

Outcome hermite_unscaled_tangents(const Json& in) {
  return hermite_outcome<float>(in, [](auto v0, auto b, auto a, auto v1, float s, float) {
    auto v = hermite(v0, b, a, v1, s, 1.0f);
    if constexpr (kIsRotation<decltype(v)>) v = plain_unit(v);
    return v;
  });
}

Outcome hermite_not_normalised(const Json& in) {
  return hermite_outcome<float>(
      in, [](auto v0, auto b, auto a, auto v1, float s, float td) { return hermite(v0, b, a, v1, s, td); });
}

}  // namespace

NumericKind slerp_kind() {
  return {
      "slerp",
      in_both_precisions(
          "slerp_short_arc",
          []<class T>(const Json& in) {
            return Outcome{{"q", numbers(slerp_short_arc(quat<T>(in["q"]), quat<T>(in["r"]), scalar<T>(in["t"])))}};
          }),
      {of_two_keys("acos, nlerp above cos 0.999",
                   [](const Q& q, const Q& r, float t) { return acos_slerp(q, r, t, 0.999f, true); }),
       of_two_keys("acos without clamp",
                   [](const Q& q, const Q& r, float t) { return acos_slerp(q, r, t, 2.0f, true); }),
       of_two_keys("no sign flip",
                   [](const Q& q, const Q& r, float t) { return acos_slerp(q, r, t, 0.9999999f, false); }),
       of_two_keys("polynomial of eight terms", short_polynomial_slerp), of_two_keys("nlerp", nlerp_short_arc<float>)}};
}

NumericKind nlerp_kind() {
  return {"nlerp",
          in_both_precisions(
              "nlerp_short_arc",
              []<class T>(const Json& in) {
                return Outcome{{"q", numbers(nlerp_short_arc(quat<T>(in["q"]), quat<T>(in["r"]), scalar<T>(in["t"])))}};
              }),
          {of_two_keys("no sign flip", [](const Q& q, const Q& r, float t) { return plain_unit(q * (1 - t) + r * t); }),
           of_two_keys("not normalised",
                       [](const Q& q, const Q& r, float t) { return q * (1 - t) + aligned_with(q, r) * t; })}};
}

NumericKind squad_kind() {
  return {"squad",
          in_both_precisions("squad",
                             []<class T>(const Json& in) {
                               Quat<T> k[4];
                               for (std::size_t i = 0; i < 4; ++i) k[i] = quat<T>(in["keys"][i]);
                               for (int i = 1; i < 4; ++i) k[i] = aligned_with(k[i - 1], k[i]);
                               const auto a0 = squad_control(k[0], k[1], k[2]), a1 = squad_control(k[1], k[2], k[3]);
                               return Outcome{{"q", numbers(squad(k[1], a0, a1, k[2], scalar<T>(in["t"])))},
                                              {"a0", numbers(a0)},
                                              {"a1", numbers(a1)}};
                             }),
          {naive_squad("keys not aligned", false, slerp_as_given<float>),
           naive_squad("shortest-path slerp inside", true, slerp_short_arc<float>),
           naive_squad("acos slerp, nlerp above cos 0.999", true,
                       [](const Q& q, const Q& r, float t) { return acos_slerp(q, r, t, 0.999f, false); })}};
}

NumericKind hermite_kind() {
  return {"hermite",
          in_both_precisions("hermite",
                             []<class T>(const Json& in) {
                               return hermite_outcome<T>(in, [](auto v0, auto b, auto a, auto v1, T s, T td) {
                                 if constexpr (kIsRotation<decltype(v0)>)
                                   return hermite_rotation(v0, b, a, v1, s, td);
                                 else
                                   return hermite(v0, b, a, v1, s, td);
                               });
                             }),
          {{"quaternion not normalised", hermite_not_normalised},
           {"expanded polynomial", hermite_expanded},
           {"tangents not scaled by the interval", hermite_unscaled_tangents}}};
}

}  // namespace sinew::test
