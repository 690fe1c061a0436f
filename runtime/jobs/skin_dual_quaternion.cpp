// SPDX-License-Identifier: MIT
#include "runtime/jobs/skin_dual_quaternion.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/jobs/skin_dual_quaternion.cpp"
#include <hwy/foreach_target.h>

#include "runtime/jobs/blend_motion.h"
#include "runtime/jobs/blend_motion_lanes-inl.h"
#include "runtime/jobs/four_vertices.h"
#include "runtime/jobs/vertex_checks.h"

#ifndef SINEW_SKIN_DUAL_QUATERNION_ONCE
#define SINEW_SKIN_DUAL_QUATERNION_ONCE
namespace sinew {
namespace {

/// One vertex, with every degenerate case: the only way of the scalar target, and the way out of the lanes.
template <int kCount, bool kStretch, bool kNormals, bool kTangents>
void skin_vertex(std::span<const RigidStretch> split, const VertexJoints<kCount>& joints, const VertexInput& in, const VertexOutput& out,
                 std::size_t v) noexcept {
  const DualQuat motion = blend_motion(split, joints);
  glm::vec3 p = in.positions[v];
  Mat3<float> stretch(1.0f);
  if constexpr (kStretch) stretch = blend_stretch(split, joints), p = stretch * p;
  if constexpr (kNormals) {
    glm::vec3 n = in.normals[v];
    if constexpr (kStretch) n = transform_normal_outward(stretch, n);
    out.normals[v] = normalised_or(transform_vector(motion, n), n);
  }
  if constexpr (kTangents) {
    const glm::vec4 tangent = in.tangents[v];
    glm::vec3 t(tangent);
    if constexpr (kStretch) t = stretch * t;
    out.tangents[v] = glm::vec4(normalised_or(transform_vector(motion, t), glm::vec3(tangent)), tangent.w);
  }
  out.positions[v] = transform_point(motion, p);
}

}  // namespace
}  // namespace sinew
#endif

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR

template <int kCount, bool kStretch, bool kNormals, bool kTangents>
void skin_group(const SkinDualQuaternionJob& job, const InfluenceGroup& group) {
  for (std::size_t i = 0; i < group.vertex_count; ++i)
    skin_vertex<kCount, kStretch, kNormals, kTangents>(job.split, joints_of<kCount>(*job.influences, group, i), job.vertices, job.out,
                                                       group.first_vertex + i);
}

#else

/// Answers false, with nothing written, when some vertex needs the careful way.
template <int kCount, bool kStretch, bool kNormals, bool kTangents>
HWY_ATTR bool skin_four(std::span<const RigidStretch> split, const VertexJoints<kCount> (&joints)[4], const VertexInput& in, const VertexOutput& out) {
  MotionLanes motion;
  if (!blend_motions(split.data(), joints, motion)) return false;
  StretchLanes stretch{};
  if constexpr (kStretch) stretch = blend_stretches(split.data(), joints);
  Lanes3 p = load3(in.positions.data()), n{}, t{};
  V4 handedness{};
  if constexpr (kStretch) p = apply(stretch, p);
  if constexpr (kNormals) {
    n = load3(in.normals.data());
    if constexpr (kStretch) n = apply_to_normal(stretch, n);
    n = rotate(motion.real, n);
    if (!normalise(n)) return false;
  }
  if constexpr (kTangents) {
    hn::LoadInterleaved4(D4(), &in.tangents[0].x, t.x, t.y, t.z, handedness);
    if constexpr (kStretch) t = apply(stretch, t);
    t = rotate(motion.real, t);
    if (!normalise(t)) return false;
  }
  p = rotate(motion.real, p);
  const Lanes3 moved = translation(motion);
  store3({hn::Add(p.x, moved.x), hn::Add(p.y, moved.y), hn::Add(p.z, moved.z)}, out.positions.data());
  if constexpr (kNormals) store3(n, out.normals.data());
  if constexpr (kTangents) hn::StoreInterleaved4(t.x, t.y, t.z, handedness, D4(), &out.tangents[0].x);
  return true;
}

template <int kCount, bool kStretch, bool kNormals, bool kTangents>
void skin_group(const SkinDualQuaternionJob& job, const InfluenceGroup& group) {
  for_each_four<kCount, kNormals, kTangents>(
      *job.influences, group, job.vertices, job.out,
      [&](const VertexJoints<kCount>(&joints)[4], const VertexInput& in, const VertexOutput& out) HWY_ATTR {
        if (skin_four<kCount, kStretch, kNormals, kTangents>(job.split, joints, in, out)) return;
        for (std::size_t k = 0; k < 4; ++k) skin_vertex<kCount, kStretch, kNormals, kTangents>(job.split, joints[k], in, out, k);
      });
}

#endif  // HWY_TARGET

void skin_dual_quaternion(const SkinDualQuaternionJob& job) {
  const auto wanted = present(job.vertices, job.out);
  with_attributes(wanted.normals, wanted.tangents, [&](auto normals, auto tangents) {
    for (const auto& group : job.influences->groups)
      with_influence_count(group.influence_count, [&](auto count) {
        if (job.any_stretch) skin_group<count, true, normals, tangents>(job, group);
        else skin_group<count, false, normals, tangents>(job, group);
      });
  });
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {
HWY_EXPORT(skin_dual_quaternion);
}  // namespace

ErrorCode check(const SkinDualQuaternionJob& job) noexcept {
  if (const auto error = check_streams(job.vertices, job.out); error != ErrorCode::ok) return error;
  return check_influences(job.influences, job.vertices.positions.size(), job.split.size());
}

void run(const SkinDualQuaternionJob& job) noexcept { HWY_DYNAMIC_DISPATCH(skin_dual_quaternion)(job); }

}  // namespace sinew
#endif
