// SPDX-License-Identifier: MIT
#include "runtime/math/matrix_rotation.h"
#include "tests/math/numeric_variants.h"
#include "tests/reference/skinning.h"
#include "tests/support/numeric_read.h"

namespace sinew::test {
namespace {

/// A vertex with all its influences, as read from a skinning case.
template <class T>
struct Vertex {
  explicit Vertex(const Json& in) : p(vec3<T>(in["p"])) {
    if (in.contains("n")) n = vec3<T>(in["n"]);
    for (const Json& w : in["weights"]) weights.push_back(scalar<T>(w));
    if (in.contains("matrices"))
      for (const Json& m : in["matrices"]) matrices.push_back(affine<T>(m));
    for (std::size_t i = 0; in.contains("quats") && i < in["quats"].size(); ++i) {
      const Quat<T> q = quat<T>(in["quats"][i]);
      const Vec3<T> t = vec3<T>(in["translations"][i]);
      motions.push_back(dual_quat_from(normalised(q), t));
      matrices.push_back(affine_from(matrix_from_quat(q), t));
    }
    if (in.contains("scales"))
      for (const Json& s : in["scales"]) {
        Mat3<T> stretch(T(1));
        for (int i = 0; i < 3; ++i) stretch[i][i] = scalar<T>(s[static_cast<std::size_t>(i)]);
        stretches.push_back(stretch);
      }
  }

  std::span<const AffineT<T>> affines() const { return matrices; }
  std::span<const DualQuatT<T>> rigid() const { return motions; }
  std::span<const Mat3<T>> stretch() const { return stretches; }
  std::span<const T> w() const { return weights; }

  Vec3<T> p, n{T(0), T(0), T(1)};
  std::vector<T> weights;
  std::vector<AffineT<T>> matrices;
  std::vector<DualQuatT<T>> motions;
  std::vector<Mat3<T>> stretches;
};

template <class T>
Outcome linear_outcome(const Vertex<T>& v) {
  const auto m = reference::blend_matrices(v.affines(), v.w());
  return {{"p", numbers(transform_point(m, v.p))}, {"n_linear", numbers(transform_vector(m, v.n))}};
}

template <class T>
Outcome skinned_outcome(const reference::SkinnedT<T>& s) {
  return {{"p", numbers(s.position)}, {"n", numbers(s.normal)}, {"q", numbers(s.rotation)}};
}

template <class T>
Outcome dual_outcome(const Vertex<T>& v) {
  return skinned_outcome(reference::skin_dual_quaternion(v.rigid(), v.stretch(), v.w(), v.p, v.n));
}

template <class T>
Outcome center_outcome(const Vertex<T>& v, const Vec3<T>& center) {
  return skinned_outcome(reference::skin_center_of_rotation(v.rigid(), v.affines(), v.w(), v.p, v.n, center));
}

template <class T>
Outcome candy_outcome(const Json& in, bool linear_for_dual) {
  const T w1 = scalar<T>(in["weight1"]);
  const std::vector<T> weights{T(1) - w1, w1};
  const std::vector<DualQuatT<T>> motions{{}, dual_quat_from(normalised(quat<T>(in["q1"])), Vec3<T>(T(0)))};
  const std::vector<AffineT<T>> matrices{{}, affine_from(mat3<T>(in["m1"]), Vec3<T>(T(0)))};
  const std::span<const T> w(weights);
  const std::span<const DualQuatT<T>> rigid(motions);
  const std::span<const AffineT<T>> affines(matrices);
  const Vec3<T> p = vec3<T>(in["p"]), n(T(0), T(1), T(0));
  const Vec3<T> linear = reference::skin_linear(affines, w, p);
  const Vec3<T> dual = reference::skin_dual_quaternion<T>(rigid, {}, w, p, n).position;
  const Vec3<T> center = reference::skin_center_of_rotation(rigid, affines, w, p, n, vec3<T>(in["cor"])).position;
  return {{"lbs_p", numbers(linear)}, {"dqs_p", numbers(linear_for_dual ? linear : dual)}, {"cor_p", numbers(center)}};
}

/// Dual quaternion blend without sign alignment, or with signs aligned with the first influence.
Outcome misaligned_blend(const Vertex<float>& v, bool first_pivot, bool normalise) {
  DualQuat sum{quat_xyzw(0.f, 0.f, 0.f, 0.f), quat_xyzw(0.f, 0.f, 0.f, 0.f)};
  const Quat<float> pivot = v.motions[normalise ? 0 : reference::pivot_of(v.w())].real;
  for (std::size_t i = 0; i < v.motions.size(); ++i) {
    const bool flip = (first_pivot || !normalise) && quat_dot(pivot, v.motions[i].real) < 0;
    const float w = flip ? -v.weights[i] : v.weights[i];
    sum = {sum.real + v.motions[i].real * w, sum.dual + v.motions[i].dual * w};
  }
  const float length = normalise ? std::sqrt(quat_dot(sum.real, sum.real)) : 1.0f;
  const DualQuat d{sum.real / length, sum.dual / length};
  const Vec3<float> p = v.stretches.empty() ? v.p : reference::blend_stretches(v.stretch(), v.w()) * v.p;
  return {{"p", numbers(transform_point(d, p))}, {"n", numbers(transform_vector(d, v.n))}, {"q", numbers(d.real)}};
}

Outcome linear_with_weights(Vertex<float> v, void (*change)(std::vector<float>&)) {
  change(v.weights);
  AffineT<float> sum{{Vec4<float>(0.f), Vec4<float>(0.f), Vec4<float>(0.f)}};
  for (std::size_t i = 0; i < v.weights.size(); ++i)
    for (int r = 0; r < 3; ++r) sum.row[r] += v.matrices[i].row[r] * v.weights[i];
  return {{"p", numbers(transform_point(sum, v.p))}, {"n_linear", numbers(transform_vector(sum, v.n))}};
}

Outcome center_misaligned(const Json& in) {
  const Vertex<float> v(in);
  Quat<float> sum = quat_xyzw(0.f, 0.f, 0.f, 0.f);
  for (std::size_t i = 0; i < v.motions.size(); ++i) sum = sum + v.motions[i].real * v.weights[i];
  sum = sum / std::sqrt(quat_dot(sum, sum));
  const Vec3<float> c = vec3<float>(in["cor"]), moved = reference::skin_linear(v.affines(), v.w(), c);
  return {{"p", numbers(rotate_vector(sum, v.p - c) + moved)}, {"q", numbers(sum)}};
}

Outcome center_without_renormalising(const Json& in) {
  Outcome out = center_outcome(Vertex<float>(in), vec3<float>(in["cor"]));
  const Vertex<float> v(in);
  const float total = reference::weight_sum(v.w());
  const Vec3<float> moved = reference::skin_linear(v.affines(), v.w(), vec3<float>(in["cor"]));
  for (int i = 0; i < 3; ++i) out["p"][static_cast<std::size_t>(i)] += moved[i] * total - moved[i];
  return out;
}

/// eq   base + sum(w d): deltas are summed first, so that small deltas are not lost on a large base (eq. 4.61)
template <class T>
Outcome morph_outcome(const Json& in, bool base_first) {
  const Vec3<T> base = vec3<T>(in["base"]);
  Vec3<T> sum = base_first ? base : Vec3<T>(T(0));
  const Json& deltas = in["deltas"];
  for (std::size_t i = 0; i < in["weights"].size(); ++i) {
    const T w = scalar<T>(in["weights"][i]);
    for (std::size_t c = 0; c < 3; ++c) sum[static_cast<int>(c)] += w * scalar<T>(deltas[3 * i + c]);
  }
  return {{"p", numbers(base_first ? sum : base + sum)}};
}

}  // namespace

NumericKind lbs_kind() {
  return {"lbs",
          in_both_precisions("reference::skin_linear",
                             []<class T>(const Json& in) { return linear_outcome(Vertex<T>(in)); }),
          {{"weights not renormalised",
            [](const Json& in) { return linear_with_weights(Vertex<float>(in), [](auto&) {}); }},
           {"last weight = 1 - sum",
            [](const Json& in) {
              return linear_with_weights(Vertex<float>(in), [](auto& w) {
                w.back() = 1;
                for (std::size_t i = 0; i + 1 < w.size(); ++i) w.back() -= w[i];
              });
            }},
           {"first four influences only", [](const Json& in) {
              return linear_with_weights(Vertex<float>(in),
                                         [](auto& w) { w.resize(std::min<std::size_t>(w.size(), 4)); });
            }}}};
}

NumericKind dqs_kind() {
  return {"dqs",
          in_both_precisions("reference::skin_dual_quaternion",
                             []<class T>(const Json& in) { return dual_outcome(Vertex<T>(in)); }),
          {{"no sign alignment", [](const Json& in) { return misaligned_blend(Vertex<float>(in), false, true); }},
           {"first influence as pivot", [](const Json& in) { return misaligned_blend(Vertex<float>(in), true, true); }},
           {"not normalised after the blend",
            [](const Json& in) { return misaligned_blend(Vertex<float>(in), false, false); }},
           {"scale ignored", [](const Json& in) {
              Vertex<float> v(in);
              v.stretches.clear();
              return dual_outcome(v);
            }}}};
}

NumericKind cor_kind() {
  return {"cor",
          in_both_precisions("reference::skin_center_of_rotation",
                             []<class T>(const Json& in) { return center_outcome(Vertex<T>(in), vec3<T>(in["cor"])); }),
          {{"no sign alignment", center_misaligned}, {"weights not renormalised", center_without_renormalising}}};
}

NumericKind candy_wrapper_kind() {
  return {"candy_wrapper",
          in_both_precisions("reference, three skinnings",
                             []<class T>(const Json& in) { return candy_outcome<T>(in, false); }),
          {{"linear in place of dual quaternion", [](const Json& in) { return candy_outcome<float>(in, true); }}}};
}

NumericKind morph_kind() {
  return {"morph",
          in_both_precisions("deltas first, base last",
                             []<class T>(const Json& in) { return morph_outcome<T>(in, false); }),
          {{"base first, targets in order", [](const Json& in) { return morph_outcome<float>(in, true); }}}};
}

}  // namespace sinew::test
