// SPDX-License-Identifier: MIT
#include "runtime/deform/skin_dual_quaternion.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/deform/skin_dual_quaternion.cpp"
#include <hwy/foreach_target.h>

#include "runtime/deform/scalar_blend.h"
#include "runtime/deform/simd/blend_dual_quaternions-inl.h"
#include "runtime/deform/simd/blend_stretch_lanes-inl.h"
#include "runtime/deform/simd/rotate_directions-inl.h"
#include "runtime/deform/vertex_checks.h"
#include "runtime/pose/simd/dispatch.h"

#ifndef SINEW_SKIN_DUAL_QUATERNION_ONCE
#define SINEW_SKIN_DUAL_QUATERNION_ONCE
namespace sinew {
namespace {

/// The scalar path: one vertex, with every degenerate case.
template <int kCount, bool kStretch, class In, class Out>
void skin_vertex(std::span<const RigidStretch> split, const VertexJoints<kCount>& joints, const In& in, const Out& out,
                 std::size_t v) noexcept {
  const double scale = weight_scale(joints);
  const DualQuat motion = blend_dual_quaternion(split, joints, scale);
  glm::vec3 p = in.positions[v];
  Mat3<float> stretch(1.0f);
  if constexpr (kStretch) {
    stretch = blend_stretch(split, joints, scale);
    p = stretch * p;
  }
  rotate_directions<kStretch>(motion.real, stretch, in, out, v);
  out.positions[v] = transform_point(motion, p);
}

/// Far enough from zero that the sign of the dot product does not depend on the order of its sum.
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

/// Skins rows of tiles. Dual quaternions are blended some tiles ahead: blends wait for memory, the rest for arithmetic,
/// and processors do not look far enough ahead to overlap the two.
template <int kCount, bool kStretch>
struct SkinRow {
  using Row = TileRow<kCount>;
  const SkinDualQuaternionJob& job;
  bool one_side;

  HWY_INLINE void operator()(const Row& row) const {
    const RigidStretch* split = job.split.data();
    if constexpr (kCount == 1) {  // nothing to blend
      for (std::size_t t = 0; t < row.tile_count; ++t)
        skin_tile(blend_dual_quaternions(split, row.joints(t), one_side), row, t);
      return;
    }
    KeptDualQuats motions[kAhead];
    for (std::size_t first = 0; first < row.tile_count; first += kAhead) {
      const std::size_t end = std::min(row.tile_count, first + kAhead);
      for (std::size_t t = first; t < end; ++t) motions[t - first].keep(split, row.joints(t), one_side);
      for (std::size_t t = first; t < end; ++t) skin_tile(motions[t - first].template lanes<kCount>(), row, t);
    }
  }

 private:
  static constexpr std::size_t kAhead = 8;  ///< tiles

  /// Vertices whose blend cancels or is tiny, or whose directions are in doubt, are redone by the scalar path.
  HWY_INLINE void skin_tile(const DualQuatLanes& motion, const Row& row, std::size_t t) const {
    const TileInfluences<kCount> joints = row.joints(t);
    const TileInput in = row.in(t);
    const TileOutput out = row.out(t);
    StretchLanes stretch{};
    if constexpr (kStretch) stretch = blend_stretches(job.split.data(), joints);
    const auto sound = rotate_directions<kStretch>(motion, stretch, in, out);
    Lanes3 p = load3(in.positions);
    if constexpr (kStretch) p = apply(stretch, p);
    store3(plus(rotate(motion, p), translation(motion)), out.positions);
    for_each_lane_not_in(sound, [&](std::size_t lane) {
      const std::size_t v = vertex_of_lane(lane);
      skin_vertex<kCount, kStretch>(job.split, joints.at(v), in, out, v);
    });
  }
};

void skin_dual_quaternion(const SkinDualQuaternionJob& job) {
  const bool one_side = are_on_one_side(job);
  for_each_group(job.influences, job.any_stretch, [&](const InfluenceGroup& group, auto count, auto stretched) {
    for_each_row<count>(job.influences, group, job.vertices, job.out, SkinRow<count, stretched>{job, one_side});
  });
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
ErrorCode check(const SkinDualQuaternionJob& job) noexcept {
  const std::size_t count = job.split.size();
  const auto outside = [count](const JointPair& pair) { return pair.first >= count || pair.second >= count; };
  if (std::any_of(job.pairs.begin(), job.pairs.end(), outside)) return ErrorCode::index_out_of_range;
  return check_skinning(job.influences, job.vertices, job.out, count);
}

SINEW_DISPATCH_RUN(SkinDualQuaternionJob, skin_dual_quaternion)

}  // namespace sinew
#endif
