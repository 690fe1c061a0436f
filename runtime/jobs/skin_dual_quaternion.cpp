// SPDX-License-Identifier: MIT
#include "runtime/jobs/skin_dual_quaternion.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/jobs/skin_dual_quaternion.cpp"
#include <hwy/foreach_target.h>

#include "runtime/jobs/blend_motion.h"
#include "runtime/jobs/blend_motion_lanes-inl.h"
#include "runtime/jobs/vertex_checks.h"

#ifndef SINEW_SKIN_DUAL_QUATERNION_ONCE
#define SINEW_SKIN_DUAL_QUATERNION_ONCE
namespace sinew {
namespace {

/// One vertex, with every degenerate case: the only way of the scalar target, and the way out of the lanes.
template <int kCount, bool kStretch, bool kNormals, bool kTangents, class In, class Out>
void skin_vertex(std::span<const RigidStretch> split, const VertexJoints<kCount>& joints, const In& in, const Out& out, std::size_t v) noexcept {
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

/// Far enough from zero that no order of summing the dot product comes to another sign.
constexpr float kOneSide = 1e-5f;

bool are_on_one_side(const SkinDualQuaternionJob& job) noexcept {
  return !job.pairs.empty() && std::all_of(job.pairs.begin(), job.pairs.end(), [&](const JointPair& pair) {
    return quat_dot(job.split[pair.first].rigid.real, job.split[pair.second].rigid.real) > kOneSide;
  });
}

}  // namespace
}  // namespace sinew
#endif

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR

template <int kCount, bool kStretch, bool kNormals, bool kTangents>
void skin_group(const SkinDualQuaternionJob& job, const InfluenceGroup& group, bool) {
  for (std::size_t i = 0; i < group.vertex_count; ++i)
    skin_vertex<kCount, kStretch, kNormals, kTangents>(job.split, joints_of<kCount>(*job.influences, group, i), job.vertices, job.out,
                                                       group.first_vertex + i);
}

#else

/// Skins a tile. Vertices whose blend cancels, or whose directions leave float's range, are done again the careful way.
template <int kCount, bool kStretch, bool kNormals, bool kTangents>
HWY_INLINE void skin_tile(const SkinDualQuaternionJob& job, bool one_side, const TileInfluences<kCount>& joints, const TileInput& in,
                          const TileOutput& out) {
  const MotionLanes motion = blend_motions(job.split.data(), joints, one_side);
  StretchLanes stretch{};
  if constexpr (kStretch) stretch = blend_stretches(job.split.data(), joints);
  auto sound = motion.sound;
  Lanes3 p = load3(in.positions);
  if constexpr (kStretch) p = apply(stretch, p);
  if constexpr (kNormals) {
    Lanes3 n = load3(in.normals);
    if constexpr (kStretch) n = apply_to_normal(stretch, n);
    n = rotate(motion.real, n);
    sound = hn::And(sound, normalise(n));
    store3(n, out.normals);
  }
  if constexpr (kTangents) {
    const Lanes4 tangent = load4(in.tangents);
    Lanes3 t{tangent.x, tangent.y, tangent.z};
    if constexpr (kStretch) t = apply(stretch, t);
    t = rotate(motion.real, t);
    sound = hn::And(sound, normalise(t));
    store4({t.x, t.y, t.z, tangent.w}, out.tangents);
  }
  store3(plus(rotate(motion.real, p), translation(motion)), out.positions);
  for_each_lane_not_in(sound, [&](std::size_t v) { skin_vertex<kCount, kStretch, kNormals, kTangents>(job.split, joints.at(v), in, out, v); });
}

template <int kCount, bool kStretch, bool kNormals, bool kTangents>
void skin_group(const SkinDualQuaternionJob& job, const InfluenceGroup& group, bool one_side) {
  for_each_tile<kCount, kNormals, kTangents>(*job.influences, group, job.vertices, job.out,
                                             [&](const TilePlace&, const TileInfluences<kCount>& joints, const TileInput& in, const TileOutput& out)
                                                 HWY_ATTR { skin_tile<kCount, kStretch, kNormals, kTangents>(job, one_side, joints, in, out); });
}

#endif  // HWY_TARGET

void skin_dual_quaternion(const SkinDualQuaternionJob& job) {
  const bool one_side = are_on_one_side(job);
  for_each_group(*job.influences, present(job.vertices, job.out), [&](const InfluenceGroup& group, auto count, auto normals, auto tangents) {
    if (job.any_stretch) skin_group<count, true, normals, tangents>(job, group, one_side);
    else skin_group<count, false, normals, tangents>(job, group, one_side);
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
  const std::size_t count = job.split.size();
  const auto outside = [count](const JointPair& pair) { return pair.first >= count || pair.second >= count; };
  if (std::any_of(job.pairs.begin(), job.pairs.end(), outside)) return ErrorCode::index_out_of_range;
  return check_skinning(job.influences, job.vertices, job.out, count);
}

void run(const SkinDualQuaternionJob& job) noexcept { HWY_DYNAMIC_DISPATCH(skin_dual_quaternion)(job); }

}  // namespace sinew
#endif
