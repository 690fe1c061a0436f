// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>

#include "runtime/deform/morph_vertices.h"
#include "runtime/deform/skin_center_of_rotation.h"
#include "runtime/deform/skin_dual_quaternion.h"
#include "runtime/deform/skin_linear.h"
#include "runtime/math/normal_transform.h"
#include "samples/where_float_ends/rows.h"

namespace sinew::sample {
namespace {

constexpr const char* kPart = "vertices";
constexpr std::uint32_t kVertices = 2000, kInfluences = 4;

/// Vertices within a metre, each with its own four rigid joints; all inputs are exact floats.
struct Crowd {
  std::vector<glm::vec3> positions, normals, centers, out_positions, out_normals;
  VertexInfluences influences;
  std::vector<JointMatrix> palette;
  std::vector<RigidStretch> split;

  explicit Crowd(double most_degrees) {
    Sweep sweep;
    influences.groups = {{0, kVertices, kInfluences, 0}};
    for (std::uint32_t v = 0; v < kVertices; ++v) {
      positions.emplace_back(sweep.direction());
      normals.emplace_back(sweep.direction());
      centers.emplace_back(sweep.direction() * 0.2);
      for (const float weight : {0.4f, 0.3f, 0.2f, 0.1f}) {
        influences.joints.push_back(static_cast<std::uint16_t>(split.size()));
        influences.weights.push_back(weight);
        const DualQuat motion = dual_quat_from(quat_cast<float>(sweep.turn(sweep.in(0, most_degrees) * kDegree)),
                                               glm::vec3(sweep.direction()));
        split.push_back({motion, {1, 1, 1, 0, 0, 0}});
        palette.push_back(joint_matrix_from(affine_from_dual_quat(motion)));
      }
    }
    out_positions = positions;
    out_normals = normals;
  }

  VertexInput in() const { return {positions, normals, {}}; }
  VertexOutput out() { return {out_positions, out_normals, {}}; }
  double weight(std::size_t i) const { return static_cast<double>(influences.weights[i]); }
  double weight_sum(std::size_t v) const {
    double sum = 0;
    for (std::size_t i = v * kInfluences; i < (v + 1) * kInfluences; ++i) sum += weight(i);
    return sum;
  }

  /// eq   sum(w M p)   (Real-Time Rendering, eq. 4.59)
  Vec3<double> true_linear(std::size_t v, const glm::vec3& p) const {
    Vec3<double> sum(0);
    for (std::size_t i = v * kInfluences; i < (v + 1) * kInfluences; ++i)
      sum += weight(i) * transform_point(affine_cast<double>(affine_from(palette[i])), Vec3<double>(p));
    return sum / weight_sum(v);
  }

  /// eq   sum(w sign d) / |real|, signs aligned with the heaviest influence, which is first   (Kavan et al. 2008)
  DualQuatd true_motion(std::size_t v) const {
    const auto at = [&](std::size_t i) {
      return DualQuatd{quat_cast<double>(split[i].rigid.real), quat_cast<double>(split[i].rigid.dual)};
    };
    const DualQuatd pivot = at(v * kInfluences);
    DualQuatd sum{pivot.real * 0.0, pivot.real * 0.0};
    for (std::size_t i = v * kInfluences; i < (v + 1) * kInfluences; ++i) {
      const double w = quat_dot(pivot.real, at(i).real) < 0 ? -weight(i) : weight(i);
      sum = {sum.real + at(i).real * w, sum.dual + at(i).dual * w};
    }
    return normalised(sum);
  }
};

/// Adds the errors of positions of all three kinds, and of normals of the rigid kinds, for joints that turn up to
/// `most_degrees`.
void add_skinning(Rows& rows, double most_degrees, double bound) {
  Crowd c(most_degrees);
  Largest linear, dual, dual_normals, center;
  run_unchecked(SkinLinearJob{&c.influences, c.palette, c.in(), c.out()});
  for (std::size_t v = 0; v < kVertices; ++v) linear.add_place(c.out_positions[v], c.true_linear(v, c.positions[v]));
  run_unchecked(SkinDualQuaternionJob{&c.influences, c.split, false, c.in(), c.out()});
  for (std::size_t v = 0; v < kVertices; ++v) {
    const DualQuatd motion = c.true_motion(v);
    dual.add_place(c.out_positions[v], transform_point(motion, Vec3<double>(c.positions[v])));
    dual_normals.add_direction(Vec3<double>(c.out_normals[v]), rotate_vector(motion.real, Vec3<double>(c.normals[v])));
  }
  run_unchecked(SkinCenterOfRotationJob{&c.influences, c.palette, c.split, false, c.centers, c.in(), c.out()});
  for (std::size_t v = 0; v < kVertices; ++v) {
    const Vec3<double> from_center = Vec3<double>(c.positions[v]) - Vec3<double>(c.centers[v]);
    center.add_place(c.out_positions[v],
                     rotate_vector(c.true_motion(v).real, from_center) + c.true_linear(v, c.centers[v]));
  }
  char sweep[48];
  std::snprintf(sweep, sizeof sweep, "4 joints, turned up to %g degrees", most_degrees);
  rows.push_back(linear.row(kPart, "linear-blend skinning", sweep, "m", 1e-6));
  rows.push_back(dual.row(kPart, "dual-quaternion skinning", sweep, "m", bound));
  rows.push_back(dual_normals.row(kPart, "dual-quaternion normals", sweep, "rad", bound));
  rows.push_back(center.row(kPart, "center-of-rotation skinning", sweep, "m", bound));
}

/// Adds the errors of normals under a matrix that flattens by `flatness`, by the cofactor rule and by the matrix
/// itself.
void add_normals(Rows& rows, double flatness, double bound) {
  Sweep sweep;
  Largest cofactor, plain;
  for (std::uint32_t i = 0; i < kVertices; ++i) {
    const Transformd local{Vec3<double>(0), sweep.rotation(), Vec3<double>(1, flatness, 1)};
    const Mat3<float> m(linear_part(affine_from_transform(local)));
    const glm::vec3 n(sweep.direction());
    const Vec3<double> truth = transform_normal_outward(Mat3<double>(m), Vec3<double>(n));
    cofactor.add_direction(Vec3<double>(transform_normal_outward(m, n)), truth);
    plain.add_direction(Vec3<double>(m * n), truth);
  }
  char text[48];
  std::snprintf(text, sizeof text, "one axis scaled by %g", flatness);
  rows.push_back(cofactor.row(kPart, "normal by the cofactor matrix", text, "rad", bound));
  rows.push_back(plain.row(kPart, "normal by the matrix itself", text, "rad", 3.2));
}

/// Adds the error of two hundred displacements of a millimetre on a vertex far from its mesh's origin.
void add_morphs(Rows& rows, double distance) {
  Sweep sweep;
  Largest job, one_by_one;
  for (int i = 0; i < 100; ++i) {
    MorphSet morphs;
    std::vector<float> weights;
    const std::vector<glm::vec3> base{glm::vec3(sweep.direction() * distance)};
    glm::vec3 running = base[0];
    Vec3<double> truth(base[0]);
    for (int t = 0; t < 200; ++t) {
      const glm::vec3 delta(sweep.direction() * 1e-3);
      weights.push_back(static_cast<float>(sweep.in(0, 1)));
      morphs.targets.emplace_back().positions = {{0}, {delta}};
      running += delta * weights.back();
      truth += Vec3<double>(delta) * static_cast<double>(weights.back());
    }
    std::vector<glm::vec3> out(1), scratch(1);
    run_unchecked(MorphVerticesJob{&morphs, weights, {base, {}, {}}, {out, {}, {}}, scratch, false});
    job.add_place(out[0], truth);
    one_by_one.add_place(running, truth);
  }
  char text[48];
  std::snprintf(text, sizeof text, "200 targets, %g m from the origin", distance);
  rows.push_back(job.row(kPart, "morph: displacements summed first", text, "m", distance * 1.1e-7));
  rows.push_back(one_by_one.row(kPart, "morph: added one by one", text, "m", distance * 2e-6));
}

}  // namespace

void add_vertex_rows(Rows& rows) {
  add_skinning(rows, 90, 1.5e-6);
  add_skinning(rows, 179, 1e-5);
  for (const double flatness : {1.0, 0.1, 1e-4}) add_normals(rows, flatness, 5e-7);
  for (const double distance : {1.0, 1000.0}) add_morphs(rows, distance);
}

}  // namespace sinew::sample
