// SPDX-License-Identifier: MIT
#include "runtime/deform/skin_center_of_rotation.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/deform/skin_center_of_rotation.cpp"
#include <hwy/foreach_target.h>

#include "runtime/deform/simd/blend_columns-inl.h"
#include "runtime/deform/simd/blend_matrix.h"
#include "runtime/deform/simd/blend_motion.h"
#include "runtime/deform/simd/one_matrix-inl.h"
#include "runtime/deform/simd/turn_directions-inl.h"
#include "runtime/deform/simd/turn_directions.h"
#include "runtime/deform/vertex_checks.h"

#ifndef SINEW_SKIN_CENTER_OF_ROTATION_ONCE
#define SINEW_SKIN_CENTER_OF_ROTATION_ONCE
namespace sinew {
namespace {

/// One vertex, with every degenerate case.
template <int kCount, bool kStretch, class In, class Out>
void skin_vertex(const SkinCenterOfRotationJob& job, const VertexJoints<kCount>& joints, const glm::vec3& center,
                 const In& in, const Out& out, std::size_t v) noexcept {
  const Quat<float> rotation = blend_motion(job.split, joints).real;
  const glm::vec3 moved_center = transform_point(blend_matrix(job.palette, joints), center);
  glm::vec3 arm = in.positions[v] - center;
  Mat3<float> stretch(1.0f);
  if constexpr (kStretch) stretch = blend_stretch(job.split, joints), arm = stretch * arm;
  turn_directions<kStretch>(rotation, stretch, in, out, v);
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
  return transform_points(blend_one_matrix(palette, joints), load3(centers));
#else
  Wide quarters[4];
  for_each_quarter([&](auto q) HWY_ATTR {
    quarters[q] = transform_points(blend_columns(palette, joints, q), load_spread<q>(centers));
  });
  const Lanes4 moved = transpose(quarters[0], quarters[1], quarters[2], quarters[3]);
  return {moved.x, moved.y, moved.z};
#endif
}

/// The centers of a tile that is not full, filled up as its vertices are.
struct CenterCopies {
  glm::vec3 centers[kTileSize];

  const glm::vec3* load(const glm::vec3* from, std::size_t count) {
    for (std::size_t k = 0; k < kTileSize; ++k) centers[k] = from[std::min(k, count - 1)];
    return centers;
  }
};

/// Skins tiles. Vertices whose blend cancels, or whose directions leave float's range, are done again the careful way.
template <int kCount, bool kStretch>
struct SkinTile {
  const SkinCenterOfRotationJob& job;
  CenterCopies& copies;

  HWY_INLINE void operator()(const TilePlace& place, const TileInfluences<kCount>& joints, const TileInput& in,
                             const TileOutput& out) const {
    const glm::vec3* centers = job.centers.data() + place.first_vertex;
    if (HWY_UNLIKELY(!place.whole)) centers = copies.load(centers, place.count);
    const MotionLanes motion = blend_motions(job.split.data(), joints, false);
    const Lanes3 moved = moved_centers(job.palette.data(), joints, centers);
    StretchLanes stretch{};
    if constexpr (kStretch) stretch = blend_stretches(job.split.data(), joints);
    const auto sound = turn_directions<kStretch>(motion, stretch, in, out);
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
namespace {
HWY_EXPORT(skin_center_of_rotation);
}  // namespace

ErrorCode check(const SkinCenterOfRotationJob& job) noexcept {
  const std::size_t count = job.vertices.positions.size();
  if (job.centers.size() != count || job.palette.size() != job.split.size()) return ErrorCode::size_mismatch;
  return check_skinning(job.influences, job.vertices, job.out, job.palette.size());
}

void run(const SkinCenterOfRotationJob& job) noexcept { HWY_DYNAMIC_DISPATCH(skin_center_of_rotation)(job); }

}  // namespace sinew
#endif
