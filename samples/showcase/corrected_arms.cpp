// SPDX-License-Identifier: MIT
#include <iterator>
#include <utility>

#include "runtime/base/contract.h"
#include "runtime/math/axis_angle.h"
#include "runtime/math/inverse.h"
#include "runtime/plan/run_plan.h"
#include "samples/showcase/showcase.h"

namespace sinew::showcase {
namespace {

constexpr std::uint32_t kLinearArm = 1, kDualQuaternionArm = 2;  // indices of instances in twisted_arms()
constexpr double kSculpted_deg[] = {30.0, 60.0, 90.0, 120.0,
                                    150.0};  // at 180 linear blending collapses the wrist to a point
constexpr double kSecondsPerDegree = 3.0 / 180.0;

Affined blended_matrix(const Scene& scene, const FrameResult& frame, const Primitive& arm, std::uint32_t vertex) {
  const Skin& skin = scene.skins[scene.instances[kLinearArm].skin];
  Affined sum{{Vec4<double>(0.0), Vec4<double>(0.0), Vec4<double>(0.0)}};
  for (const InfluenceGroup& group : arm.influences.groups) {
    if (vertex < group.first_vertex || vertex >= group.first_vertex + group.vertex_count) continue;
    const std::size_t first = group.first_influence + std::size_t{vertex - group.first_vertex} * group.influence_count;
    for (std::size_t i = first; i < first + group.influence_count; ++i) {
      const std::size_t joint = arm.influences.joints[i];
      const Affined matrix = affine_cast<double>(frame.model[skin.joints[joint]] * skin.inverse_bind[joint]);
      for (int r = 0; r < 3; ++r) sum.row[r] += static_cast<double>(arm.influences.weights[i]) * matrix.row[r];
    }
  }
  return sum;
}

template <class V>
void displace(SparseDeltas<V>& deltas, std::uint32_t vertex, const V& delta) {
  constexpr float kNoticeable = 1e-5f;
  if (glm::dot(delta, delta) < kNoticeable * kNoticeable) return;
  deltas.vertices.push_back(vertex);
  deltas.deltas.push_back(delta);
}

/// The morph target to add before linear blending, so that the result equals that of dual quaternions.
/// eq   M (p + d) = p', so d = M^-1 p' - p;  normals likewise   (Lewis, Cordner and Fong 2000, section 3)
MorphTarget sculpt(const Scene& scene, const FrameResult& frame, const Primitive& arm) {
  const DeformedPrimitive& wanted = frame.primitives[frame.instances[kDualQuaternionArm].first_primitive];
  const Vec3<float> apart =
      translation_of(frame.model[scene.skins[1].joints[0]]) - translation_of(frame.model[scene.skins[0].joints[0]]);
  MorphTarget target;
  for (std::uint32_t v = 0; v < arm.vertex_count(); ++v) {
    const auto back = inverse_of(blended_matrix(scene, frame, arm, v));
    CONTRACT(back.has_value());
    const Vec3<double> position = transform_point(*back, Vec3<double>(wanted.positions[v] - apart));
    const Vec3<double> normal = transform_vector(*back, Vec3<double>(wanted.normals[v]));
    displace(target.positions, v, glm::vec3(position) - arm.positions[v]);
    displace(target.normals, v, glm::vec3(normalised_or(normal, normal)) - arm.normals[v]);
  }
  return target;
}

/// One shape for each sculpted twist of the wrist, with full weight there. The linear kernel mixes neighbouring shapes.
PoseSamples samples_of(const Scene& scene, std::uint32_t first_weight) {
  PoseSamples samples;
  samples.name = "volume of a twisted arm";
  samples.drivers = {
      {.joint = scene.skins[scene.instances[kLinearArm].skin].joints[1], .measure = RotationMeasure::twist}};
  samples.kernel = RadialKernel::linear;
  samples.rotations = {quat_identity<float>()};
  samples.values.assign(std::size(kSculpted_deg), 0.0f);
  for (std::uint32_t s = 0; s < std::size(kSculpted_deg); ++s) {
    const double angle_rad = kSculpted_deg[s] * 3.14159265358979323846 / 180.0;
    samples.rotations.push_back(quat_cast<float>(quat_from_axis_angle(Vec3<double>(0.0, 1.0, 0.0), angle_rad)));
    samples.weights.push_back(first_weight + s);
    for (std::uint32_t w = 0; w < std::size(kSculpted_deg); ++w) samples.values.push_back(w == s ? 1.0f : 0.0f);
  }
  return samples;
}

}  // namespace

ShowcaseScene corrected_arms() {
  ShowcaseScene out = twisted_arms();
  Scene& scene = out.scene;
  Mesh corrected = scene.meshes[scene.instances[kLinearArm].mesh];
  corrected.name = "corrected arm";
  {
    const Plan plan = compile_plan(lend(scene), out.needs);
    FrameBuffer frame(plan);
    for (const double degrees : kSculpted_deg) {
      const ClipLayer layer{.clip = 0, .time_s = degrees * kSecondsPerDegree};
      CONTRACT(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frame) == ErrorCode::ok);
      corrected.primitives[0].morphs.targets.push_back(sculpt(scene, frame.result(), corrected.primitives[0]));
      corrected.target_names.push_back("twist " + std::to_string(static_cast<int>(degrees)));
      corrected.default_weights.push_back(0.0f);
    }
  }
  scene.instances[kLinearArm].mesh = static_cast<std::uint32_t>(scene.meshes.size());
  scene.instances[kLinearArm].rest_weights = corrected.default_weights;
  scene.meshes.push_back(std::move(corrected));
  finish_scene(scene);
  auto solved = solve_corrective(samples_of(scene, scene.first_weight[kLinearArm]));
  CONTRACT(solved.has_value());
  scene.correctives.push_back(*std::move(solved));
  CONTRACT(check(scene) == ErrorCode::ok);

  out.name = "corrected arms";
  out.what_to_look_at =
      "Left: linear-blend skinning with five corrective shapes, mixed by the twist of the wrist. Right: dual "
      "quaternions.";
  return out;
}

}  // namespace sinew::showcase
