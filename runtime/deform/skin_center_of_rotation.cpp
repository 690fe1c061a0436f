// SPDX-License-Identifier: MIT
#include "runtime/deform/skin_center_of_rotation.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/deform/skin_center_of_rotation.cpp"
#include <hwy/foreach_target.h>

#include "runtime/deform/scalar_blend.h"
#include "runtime/deform/simd/blend_columns-inl.h"
#include "runtime/deform/simd/rotate_directions-inl.h"
#include "runtime/deform/simd/scalar_matrix-inl.h"
#include "runtime/deform/vertex_checks.h"
#include "runtime/pose/simd/dispatch.h"

#ifndef SINEW_SKIN_CENTER_OF_ROTATION_ONCE
#define SINEW_SKIN_CENTER_OF_ROTATION_ONCE
namespace sinew {
namespace {

/// The scalar path: one vertex, with every degenerate case.
template <int kCount, bool kStretch, class In, class Out>
void skin_vertex(const SkinCenterOfRotationJob& job, const VertexJoints<kCount>& joints, const glm::vec3& center,
                 const In& in, const Out& out, std::size_t v) noexcept {
  const double scale = weight_scale(joints);
  const Quat<float> rotation = blend_dual_quaternion(job.split, joints, scale).real;
  const glm::vec3 moved_center = transform_point(blend_matrix(job.palette, joints, scale), center);
  glm::vec3 arm = in.positions[v] - center;
  Mat3<float> stretch(1.0f);
  if constexpr (kStretch) {
    stretch = blend_stretch(job.split, joints, scale);
    arm = stretch * arm;
  }
  rotate_directions<kStretch>(rotation, stretch, in, out, v);
  out.positions[v] = rotate_vector(rotation, arm) + moved_center;
}

}  // namespace
}  // namespace sinew
#endif

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

/// eq   M c of a tile, M the blended matrices
template <int kCount>
HWY_INLINE Lanes3 moved_centers(const JointMatrix* palette, const TileInfluences<kCount>& joints,
                                const glm::vec3* centers) {
#if HWY_TARGET == HWY_SCALAR
  return transform_points(blend_scalar_matrix(PaletteBases(palette), joints), load3(centers));
#else
  Wide quarters[4];
  for_each_quarter([&](auto q) HWY_ATTR {
    quarters[q] = transform_points(blend_columns(PaletteBases(palette), joints, q), load_spread<q>(centers));
  });
  const Lanes4 moved = transpose(quarters[0], quarters[1], quarters[2], quarters[3]);
  return {moved.x, moved.y, moved.z};
#endif
}

/// Centers of a tile that is not full, filled up as its vertices are.
struct CenterCopies {
  glm::vec3 centers[kTileSize];

  const glm::vec3* load(const glm::vec3* from, std::size_t count) {
    for (std::size_t k = 0; k < kTileSize; ++k) centers[k] = from[std::min(k, count - 1)];
    return centers;
  }
};

/// Skins tiles. Vertices whose blend cancels or is tiny, or whose directions are in doubt, are redone by the scalar
/// path.
template <int kCount, bool kStretch>
struct SkinTile {
  const SkinCenterOfRotationJob& job;
  CenterCopies& copies;

  HWY_INLINE void operator()(const TilePlace& place, const TileInfluences<kCount>& joints, const TileInput& in,
                             const TileOutput& out) const {
    const glm::vec3* centers = job.centers.data() + place.first_vertex;
    if (HWY_UNLIKELY(!place.whole)) centers = copies.load(centers, place.count);
    const DualQuatLanes motion = blend_dual_quaternions(job.split.data(), joints, false);
    const Lanes3 moved = moved_centers(job.palette.data(), joints, centers);
    StretchLanes stretch{};
    if constexpr (kStretch) stretch = blend_stretches(job.split.data(), joints);
    const auto sound = rotate_directions<kStretch>(motion, stretch, in, out);
    Lanes3 arm = minus(load3(in.positions), load3(centers));
    if constexpr (kStretch) arm = apply(stretch, arm);
    store3(plus(rotate(motion, arm), moved), out.positions);
    for_each_lane_not_in(sound, [&](std::size_t lane) {
      const std::size_t v = vertex_of_lane(lane);
      skin_vertex<kCount, kStretch>(job, joints.at(v), centers[v], in, out, v);
    });
  }
};

void skin_center_of_rotation(const SkinCenterOfRotationJob& job) {
  CenterCopies copies;
  for_each_group(job.influences, job.any_stretch, [&](const InfluenceGroup& group, auto count, auto stretched) {
    for_each_tile<count>(job.influences, group, job.vertices, job.out, SkinTile<count, stretched>{job, copies});
  });
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
ErrorCode check(const SkinCenterOfRotationJob& job) noexcept {
  const std::size_t count = job.vertices.positions.size();
  if (job.centers.size() != count || job.palette.size() != job.split.size()) return ErrorCode::size_mismatch;
  return check_skinning(job.influences, job.vertices, job.out, job.palette.size());
}

SINEW_DISPATCH_RUN(SkinCenterOfRotationJob, skin_center_of_rotation)

}  // namespace sinew
#endif
