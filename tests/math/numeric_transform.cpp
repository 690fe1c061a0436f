// SPDX-License-Identifier: MIT
#include "runtime/math/decompose.h"
#include "runtime/math/matrix_rotation.h"
#include "runtime/math/normal_transform.h"
#include "runtime/math/transform.h"
#include "tests/math/numeric_variants.h"
#include "tests/reference/quaternion_normal.h"
#include "tests/support/numeric_read.h"
#include "tests/viewer/stored_depth.h"
#include "viewer/passes/projection.h"

namespace sinew::test {
namespace {

using namespace viewer;
using namespace reference;

using V = Vec3<float>;
using M = Mat3<float>;

template <class T>
TransformT<T> transform_of(const Json& j) {
  return {vec3<T>(j["t"]), quat<T>(j["q"]), vec3<T>(j["s"])};
}

template <class T>
Outcome trs_outcome(const Json& in) {
  if (in["op"] == "trs") return {{"m", numbers(mat4_from_affine(affine_from_transform(transform_of<T>(in))))}};
  if (in["op"] != "chain") return {};
  AffineT<T> world;
  for (const Json& local : in["locals"]) world = world * affine_from_transform(transform_of<T>(local));
  return {{"m", numbers(mat4_from_affine(world))}};
}

Outcome trs_with_scaled_translation(const Json& in) {
  if (in["op"] != "trs") return {};
  const Transform x = transform_of<float>(in);
  const M r = matrix_from_unit_quat(x.rotation);
  M m;
  for (int c = 0; c < 3; ++c) m[c] = r[c] * x.scale;
  return {{"m", numbers(mat4_from_affine(affine_from(m, x.translation * x.scale)))}};
}

template <class T>
Outcome decompose_outcome(const Json& in) {
  const auto m = affine<T>(in["m"]);
  if (in["op"] == "polar") {
    const auto p = decompose_polar(linear_part(m));
    return {{"rotation", numbers(p.rotation)},
            {"q", numbers(p.quat)},
            {"t", numbers(translation_of(m))},
            {"stretch", std::vector<double>(std::begin(p.stretch), std::end(p.stretch))}};
  }
  if (in["op"] != "trs") return {};
  const auto found = decompose_trs(m).transform;
  return {{"t", numbers(found.translation)}, {"q", numbers(found.rotation)}, {"s", numbers(found.scale)}};
}

/// Polar decomposition by averaging with the inverse transpose until it converges; the scale is the column lengths.
Outcome decompose_by_newton(const Json& in) {
  const auto m = affine<float>(in["m"]);
  const M linear = linear_part(m);
  if (in["op"] == "polar") {
    M r = linear;
    for (int i = 0; i < 12; ++i) r = (r + glm::transpose(glm::inverse(r))) * 0.5f;
    const M s = glm::transpose(r) * linear;
    return {{"rotation", numbers(r)},
            {"q", numbers(quat_from_matrix(r))},
            {"t", numbers(translation_of(m))},
            {"stretch", {s[0][0], s[1][1], s[2][2], s[1][0], s[2][0], s[2][1]}}};
  }
  M r;
  V scale;
  for (int c = 0; c < 3; ++c) {
    scale[c] = glm::length(linear[c]);
    r[c] = linear[c] / scale[c];
  }
  return {{"t", numbers(translation_of(m))}, {"q", numbers(quat_from_matrix(r))}, {"s", numbers(scale)}};
}

Outcome normal_by(const Json& in, M (*matrix)(const M&)) {
  const V moved = matrix(mat3<float>(in["m"])) * vec3<float>(in["n"]);
  return {{"n", numbers(moved / glm::length(moved))}};
}

template <class T>
DepthMapping mapping_of(const std::string& op) {
  if (op.find("reversed") != std::string::npos) return DepthMapping::reversed;
  return op.find("01") != std::string::npos ? DepthMapping::zero_one : DepthMapping::gl;
}

bool contains(const std::string& op, const char* part) { return op.find(part) != std::string::npos; }

template <class T>
Mat4<T> projection_of(const Json& in, const Mat4<T>& frame) {
  const std::string op = in["op"];
  const T near_m = scalar<T>(in["near"]);
  if (contains(op, "infinite")) return with_infinite_depth(frame, mapping_of<T>(op), near_m);
  return with_depth(frame, mapping_of<T>(op), near_m, scalar<T>(in["far"]));
}

template <class T>
Outcome projection_outcome(const Json& in) {
  const std::string op = in["op"];
  const T facing = contains(op, "_lh") ? T(1) : T(-1);
  if (in.contains("fov_y")) {
    const auto frame = perspective_frame(scalar<T>(in["fov_y"]), scalar<T>(in["aspect"]), facing);
    return {{"m", numbers(projection_of(in, frame))}};
  }
  const T l = scalar<T>(in["l"]), r = scalar<T>(in["r"]), b = scalar<T>(in["b"]), t = scalar<T>(in["t"]),
          n = scalar<T>(in["near"]);
  if (contains(op, "ortho"))
    return {{"m", numbers(orthographic(ViewBoxT<T>{l, r, b, t, n, scalar<T>(in["far"])}, mapping_of<T>(op)))}};
  return {{"m", numbers(projection_of(in, perspective_frame(FrustumT<T>{l, r, b, t, n}, facing)))}};
}

/// Perspective projections with another formula for the depth row.
Outcome projection_with_row(const Json& in, float (*offset)(float n, float f), float (*slope)(float n, float f)) {
  const std::string op = in["op"];
  if (!contains(op, "persp") || contains(op, "infinite") || !in.contains("fov_y")) return {};
  Outcome out = projection_outcome<float>(in);
  const float n = scalar<float>(in["near"]), f = scalar<float>(in["far"]), sign = contains(op, "_lh") ? 1.0f : -1.0f;
  const float reversed = contains(op, "reversed") ? -1.0f : 1.0f, twice = contains(op, "gl") ? 2.0f : 1.0f;
  out["m"][14] = -reversed * twice * offset(n, f);
  if (twice == 1.0f && reversed == 1.0f) out["m"][10] = sign * slope(n, f);
  return out;
}

template <class T>
Outcome depth_outcome(const Json& in) {
  const T facing = contains(in["op"], "_lh") ? T(1) : T(-1);
  const auto terms = depth_terms(projection_of(in, perspective_frame(T(1), T(1), facing)));
  return {{"depth", numbers(depth_from_distance(terms, scalar<T>(in["distance"])))},
          {"distance", numbers(distance_from_depth(terms, scalar<T>(in["stored_depth"])))}};
}

Outcome reversed_as_one_minus_forward(const Json& in) {
  if (!contains(in["op"], "reversed")) return {};
  Json forward = in;
  forward["op"] = in.contains("far") ? "persp_01" : "persp_01_infinite";
  forward["stored_depth"] = 1.0f - scalar<float>(in["stored_depth"]);
  Outcome out = depth_outcome<float>(forward);
  out["depth"][0] = 1.0f - static_cast<float>(out["depth"][0]);
  return out;
}

template <class T>
Outcome hast_outcome(const Json& in) {
  const auto h0 = half_way_from_normal(vec3<T>(in["n0"])), h1 = half_way_from_normal(vec3<T>(in["n1"]));
  return {{"n", numbers(normal_between(h0, h1, scalar<T>(in["t"])))}, {"q0", numbers(h0)}, {"q1", numbers(h1)}};
}

V printed_half_way(const V& n) {
  const float z = std::sqrt((n.z + 1) / 2);
  return {n.x / (2 * z), n.y / (2 * z), z};
}

Outcome hast_as_printed(const Json& in, bool overwrite_z) {
  const float t = scalar<float>(in["t"]);
  const V h0 = printed_half_way(vec3<float>(in["n0"])), h1 = printed_half_way(vec3<float>(in["n1"]));
  const V h = h0 * (1 - t) + h1 * t;
  V n = h * (2 * h.z / glm::dot(h, h));
  n.z = overwrite_z ? -1.0f : n.z - 1.0f;
  return {{"n", numbers(n)}, {"q0", numbers(h0)}, {"q1", numbers(h1)}};
}

}  // namespace

NumericKind trs_compose_kind() {
  return {"trs_compose",
          in_both_precisions("affine_from_transform", []<class T>(const Json& in) { return trs_outcome<T>(in); }),
          {{"translation scaled too", trs_with_scaled_translation}}};
}

NumericKind decompose_kind() {
  return {"decompose",
          in_both_precisions("decompose", []<class T>(const Json& in) { return decompose_outcome<T>(in); }),
          {{"Newton iteration, plain lengths", decompose_by_newton}}};
}

NumericKind normal_transform_kind() {
  return {"normal_transform",
          in_both_precisions("transform_normal",
                             []<class T>(const Json& in) {
                               const auto m = mat3<T>(in["m"]);
                               const auto n = vec3<T>(in["n"]);
                               return Outcome{{"n", numbers(transform_normal(m, n))},
                                              {"n_outward", numbers(transform_normal_outward(m, n))}};
                             }),
          {{"cofactor, unscaled", [](const Json& in) { return normal_by(in, cofactor<float>); }},
           {"inverse transpose with 1/det",
            [](const Json& in) { return normal_by(in, [](const M& m) { return glm::transpose(glm::inverse(m)); }); }},
           {"the matrix itself", [](const Json& in) { return normal_by(in, [](const M& m) { return m; }); }}}};
}

NumericKind projection_kind() {
  return {"projection",
          in_both_precisions("projection", []<class T>(const Json& in) { return projection_outcome<T>(in); }),
          {{"textbook order (2 f n) / (f - n)",
            [](const Json& in) {
              return projection_with_row(
                  in, [](float n, float f) { return f * n / (f - n); }, [](float n, float f) { return f / (f - n); });
            }},
           {"far plane as 1 / (1/n - 1/f)", [](const Json& in) {
              return projection_with_row(
                  in, [](float n, float f) { return 1 / (1 / n - 1 / f); },
                  [](float n, float f) { return 1 / (1 / n - 1 / f) / n; });
            }}}};
}

NumericKind depth_kind() {
  return {"depth",
          in_both_precisions("depth", []<class T>(const Json& in) { return depth_outcome<T>(in); }),
          {{"reversed z as 1 - forward z", reversed_as_one_minus_forward}}};
}

NumericKind hast_kind() {
  return {"hast",
          in_both_precisions("quaternion_normal", []<class T>(const Json& in) { return hast_outcome<T>(in); }),
          {{"eqs. 16-17 as printed", [](const Json& in) { return hast_as_printed(in, false); }},
           {"N.z = -1 as printed", [](const Json& in) { return hast_as_printed(in, true); }},
           {"normalised lerp", [](const Json& in) {
              const float t = scalar<float>(in["t"]);
              const V n = vec3<float>(in["n0"]) * (1 - t) + vec3<float>(in["n1"]) * t;
              return Outcome{{"n", numbers(n / glm::length(n))}};
            }}}};
}

}  // namespace sinew::test
