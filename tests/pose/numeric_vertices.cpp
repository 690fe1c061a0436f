// SPDX-License-Identifier: MIT
#include <algorithm>

#include "runtime/deform/morph_vertices.h"
#include "runtime/deform/skin_center_of_rotation.h"
#include "runtime/deform/skin_dual_quaternion.h"
#include "runtime/deform/skin_linear.h"
#include "tests/pose/numeric_jobs.h"
#include "tests/reference/skinning.h"
#include "tests/support/numeric_read.h"

namespace sinew::test {
namespace {

/// The vertex of a case, nine times: enough for whole blocks and a tail. Its copies carry different normals: the case's
/// own, then the axes, whose images are the columns of the rotation that the kernel blended.
class Vertices {
 public:
  static constexpr std::uint32_t kCount = 9;

  Vertices(const glm::vec3& p, const glm::vec3& n, const std::vector<double>& weights)
      : positions_(kCount, p), normals_(kCount, n) {
    for (int axis = 0; axis < 3; ++axis)
      normals_[static_cast<std::size_t>(1 + axis)] = glm::vec3(axis == 0, axis == 1, axis == 2);
    add_influences(weights);
  }

  const VertexInfluences& influences() const { return influences_; }
  VertexInput in() const { return {positions_, normals_, {}}; }
  VertexOutput out() { return {out_positions_, out_normals_, {}}; }

  glm::vec3 position() const { return out_positions_[0]; }
  glm::vec3 normal() const { return out_normals_[0]; }
  Quat<float> rotation() const {
    return quat_from_matrix(glm::mat3(out_normals_[1], out_normals_[2], out_normals_[3]));
  }
  Outcome rigid_outcome() const {
    return {{"p", numbers(position())}, {"n", numbers(normal())}, {"q", numbers(rotation())}};
  }

 private:
  /// As the importer prepares them: divided by their sum, heaviest first, the first one on a tie.
  void add_influences(const std::vector<double>& weights) {
    double sum = 0;
    std::vector<std::uint16_t> order;
    for (std::uint16_t i = 0; i < weights.size(); ++i) {
      sum += weights[i];
      if (weights[i] > 0) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint16_t a, std::uint16_t b) { return weights[a] > weights[b]; });
    influences_.groups = {{0, kCount, static_cast<std::uint32_t>(order.size()), 0}};
    for (std::uint32_t v = 0; v < kCount; ++v)
      for (const std::uint16_t i : order) {
        influences_.joints.push_back(i);
        influences_.weights.push_back(static_cast<float>(weights[i] / sum));
      }
  }

  std::vector<glm::vec3> positions_, normals_, out_positions_ = positions_, out_normals_ = normals_;
  VertexInfluences influences_;
};

/// Palettes of a case: matrices as they are, or rigid motions with an optional scale.
struct Palettes {
  std::vector<JointMatrix> matrices;
  std::vector<RigidStretch> split;
  bool any_stretch = false;

  explicit Palettes(const Json& in) {
    if (in.contains("matrices"))
      for (const Json& m : in["matrices"]) matrices.push_back(joint_matrix_from(affine<float>(m)));
    for (std::size_t i = 0; in.contains("quats") && i < in["quats"].size(); ++i)
      add_motion(normalised(quat<float>(in["quats"][i])), vec3<float>(in["translations"][i]));
    if (!in.contains("scales")) return;
    any_stretch = true;
    for (std::size_t i = 0; i < split.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) split[i].stretch[axis] = scalar<float>(in["scales"][i][axis]);
  }

  void add_motion(const Quat<float>& q, const glm::vec3& t) {
    matrices.push_back(joint_matrix_from(affine_from(matrix_from_quat(q), t)));
    split.push_back({dual_quat_from(q, t), {1, 1, 1, 0, 0, 0}});
  }
};

std::vector<double> weights_of(const Json& in) { return in["weights"].get<std::vector<double>>(); }
glm::vec3 normal_of(const Json& in) { return in.contains("n") ? vec3<float>(in["n"]) : glm::vec3(0, 0, 1); }

void skin_linearly(Vertices& v, const Palettes& palettes) {
  run_unchecked(SkinLinearJob{&v.influences(), palettes.matrices, v.in(), v.out()});
}

void skin_by_dual_quaternions(Vertices& v, const Palettes& palettes) {
  run_unchecked(SkinDualQuaternionJob{&v.influences(), palettes.split, palettes.any_stretch, v.in(), v.out()});
}

void skin_about_center(Vertices& v, const Palettes& palettes, const glm::vec3& center) {
  const std::vector<glm::vec3> centers(Vertices::kCount, center);
  run_unchecked(SkinCenterOfRotationJob{&v.influences(), palettes.matrices, palettes.split, palettes.any_stretch,
                                        centers, v.in(), v.out()});
}

/// The job answers unit normals, the case a blend that is not: its length is taken from double precision.
Outcome linear_of(const Json& in) {
  Vertices v(vec3<float>(in["p"]), normal_of(in), weights_of(in));
  skin_linearly(v, Palettes(in));
  std::vector<AffineT<double>> matrices;
  for (const Json& m : in["matrices"]) matrices.push_back(affine<double>(m));
  const auto weights = weights_of(in);
  const auto blended = reference::blend_matrices<double>(matrices, weights);
  const double length = safe_length(transform_vector(blended, Vec3<double>(normal_of(in))));
  return {{"p", numbers(v.position())}, {"n_linear", numbers(Vec3<double>(v.normal()) * length)}};
}

Outcome dual_quaternion_of(const Json& in) {
  Vertices v(vec3<float>(in["p"]), normal_of(in), weights_of(in));
  skin_by_dual_quaternions(v, Palettes(in));
  return v.rigid_outcome();
}

Outcome center_of(const Json& in) {
  Vertices v(vec3<float>(in["p"]), normal_of(in), weights_of(in));
  skin_about_center(v, Palettes(in), vec3<float>(in["cor"]));
  return v.rigid_outcome();
}

Outcome candy_of(const Json& in) {
  Palettes palettes(Json::object());
  palettes.add_motion(quat_identity<float>(), glm::vec3(0));
  palettes.add_motion(normalised(quat<float>(in["q1"])), glm::vec3(0));
  palettes.matrices[1] = joint_matrix_from(affine_from(mat3<float>(in["m1"]), glm::vec3(0)));
  const double w1 = scalar<double>(in["weight1"]);
  Vertices v(vec3<float>(in["p"]), glm::vec3(0, 1, 0), {1 - w1, w1});
  Outcome out;
  skin_linearly(v, palettes);
  out["lbs_p"] = numbers(v.position());
  skin_by_dual_quaternions(v, palettes);
  out["dqs_p"] = numbers(v.position());
  skin_about_center(v, palettes, vec3<float>(in["cor"]));
  out["cor_p"] = numbers(v.position());
  return out;
}

/// A single joint with the case's matrix: the cofactor rule, turned outward. Where the truth has no outward side the
/// matrix is flat, and the cofactor's own direction counts.
Outcome normal_of_matrix(const Json& in) {
  Vertices v(glm::vec3(0), vec3<float>(in["n"]), {1.0});
  const std::vector<JointMatrix> palette{joint_matrix_from(affine_from(mat3<float>(in["m"]), glm::vec3(0)))};
  run_unchecked(SkinLinearJob{&v.influences(), palette, v.in(), v.out(), NormalRule::cofactor});
  const auto truth = mat3<double>(in["m"]);
  const double side = glm::determinant(truth) < 0 ? -1 : 1;
  return {{"n", numbers(Vec3<double>(v.normal()) * side)},
          {"n_outward", numbers(v.normal())},
          {"cofactor_times_n", numbers(v.normal())}};
}

Outcome morph_of(const Json& in) {
  const std::size_t count = in["weights"].size();
  MorphSet morphs;
  std::vector<float> weights;
  for (std::size_t i = 0; i < count; ++i) {
    const Json& d = in["deltas"];
    MorphTarget& target = morphs.targets.emplace_back();
    target.positions = {{0}, {{scalar<float>(d[3 * i]), scalar<float>(d[3 * i + 1]), scalar<float>(d[3 * i + 2])}}};
    weights.push_back(scalar<float>(in["weights"][i]));
  }
  const std::vector<glm::vec3> base{vec3<float>(in["base"])};
  std::vector<glm::vec3> out(1), scratch(1);
  run_unchecked(MorphVerticesJob{&morphs, weights, {base, {}, {}}, {out, {}, {}}, scratch, false});
  return {{"p", numbers(out[0])}};
}

}  // namespace

std::vector<NumericJob> vertex_jobs() {
  return {{"lbs", linear_of},
          {"dqs", dual_quaternion_of},
          {"cor", center_of},
          {"candy_wrapper", candy_of},
          {"normal_transform", normal_of_matrix},
          {"morph", morph_of}};
}

}  // namespace sinew::test
