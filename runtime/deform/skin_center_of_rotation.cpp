// SPDX-License-Identifier: MIT
#include "runtime/deform/skin_center_of_rotation.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/deform/skin_center_of_rotation.cpp"
#include <hwy/foreach_target.h>
#include <cassert>

#include "runtime/deform/scalar_blend.h"
#include "runtime/deform/simd/blend_columns-inl.h"
#include "runtime/deform/simd/kept_splits-inl.h"
#include "runtime/deform/simd/rotate_directions-inl.h"
#include "runtime/deform/simd/shared_matrices-inl.h"
#include "runtime/deform/skin_single_influences.h"
#include "runtime/deform/vertex_checks.h"

#ifndef SINEW_SKIN_CENTER_OF_ROTATION_ONCE
#define SINEW_SKIN_CENTER_OF_ROTATION_ONCE
namespace sinew {
namespace {

/// The scalar path: skins one vertex, with every degenerate case.
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

/// eq   M c for a tile, M the blended matrices
template <int kCount>
HWY_INLINE Lanes3 moved_centers(const JointMatrix* palette, const TileInfluences<kCount>& joints,
                                [[maybe_unused]] bool share_joints, const glm::vec3* centers) {
#if HWY_TARGET == HWY_SCALAR
  return transform_points(blend_lane_matrix(PaletteBases(palette), joints), load3(centers));
#else
  if constexpr (kMayShareJoints<kCount>)
    if (share_joints) {
      const SharedMatrices<kCount> shared(palette, joints.first.joints);
      return transform_points(shared.blend(weight_lanes(joints)), load3(centers));
    }
  Wide quarters[4];
  for_each_quarter([&](auto q) HWY_ATTR {
    quarters[q] = transform_points(blend_columns(PaletteBases(palette), joints, q), load_spread<q>(centers));
  });
  const Lanes4 moved = lanes_of_quarters(quarters[0], quarters[1], quarters[2], quarters[3]);
  return {moved.x, moved.y, moved.z};
#endif
}

/// Centers of an incomplete tile, padded like its vertices.
struct CenterCopies {
  glm::vec3 centers[kTileSize];

  const glm::vec3* load(const glm::vec3* from, std::size_t count) {
    for (std::size_t k = 0; k < kTileSize; ++k) centers[k] = from[std::min(k, count - 1)];
    return centers;
  }
};

template <int kCount, bool kStretch>
struct SkinRow {
  using Row = TileRow<kCount>;
  const SkinCenterOfRotationJob& job;
  CenterCopies& copies;
  bool one_hemisphere;

  HWY_INLINE void operator()(const Row& row) const {
    const glm::vec3* centers = job.centers.data() + row.place.first_vertex;
    if (HWY_UNLIKELY(!row.place.whole)) centers = copies.load(centers, row.place.count);
    KeptSplits<kStretch> kept[kTilesAhead];
    for (std::size_t first = 0; first < row.tile_count; first += kTilesAhead) {
      const std::size_t end = std::min(row.tile_count, first + kTilesAhead);
      for (std::size_t t = first; t < end; ++t) kept[t - first].keep(job.split.data(), row.joints(t), one_hemisphere);
      auto sound = hn::FirstN(TileTag(), kTileSize);
      for (std::size_t t = first; t < end; ++t)
        sound = hn::And(sound, skin_tile(kept[t - first], row, t, centers + t * kTileSize));
      if (HWY_UNLIKELY(!hn::AllTrue(TileTag(), sound)))
        for (std::size_t t = first; t < end; ++t)
          SkinRow(*this).skin_careful(kept[t - first], Row(row), t, centers + t * kTileSize);
    }
  }

 private:
  /// Skins a tile. Returns the vertices that are done.
  HWY_INLINE hn::Mask<TileTag> skin_tile(const KeptSplits<kStretch>& kept, const Row& row, std::size_t t,
                                         const glm::vec3* centers) const {
    const Lanes3 moved = moved_centers(job.palette.data(), row.joints(t), kept.share_joints(), centers);
    const DualQuatLanes motion = kept.template motion<kCount>();
    StretchLanes stretch{};
    if constexpr (kStretch) stretch = kept.stretch();
    Lanes3 arm = minus(load3(row.in(t).positions), load3(centers));
    if constexpr (kStretch) arm = apply(stretch, arm);
    store3(plus(rotate(motion, arm), moved), row.out(t).positions);
    return rotate_directions<kStretch>(motion, stretch, row.in(t), row.out(t));
  }

  /// Skins some vertices of a tile by the scalar path: their blend cancels or is tiny, or their directions lose digits.
  HWY_NOINLINE void skin_careful(const KeptSplits<kStretch>& kept, const Row& row, std::size_t t,
                                 const glm::vec3* centers) const {
    for_each_lane_not_in(skin_tile(kept, row, t, centers), [&](std::size_t lane) {
      const std::size_t v = vertex_of_lane(lane);
      skin_vertex<kCount, kStretch>(job, row.joints(t).at(v), centers[v], row.in(t), row.out(t), v);
    });
  }
};

void skin_center_of_rotation(const SkinCenterOfRotationJob& job) {
  CenterCopies copies;
  const bool one_hemisphere = are_in_one_hemisphere(job.pairs, job.split);
  for_each_group(job.influences, job.any_stretch, [&](const InfluenceGroup& group, auto each_count, auto stretched) {
    constexpr int kEach = each_count;
    constexpr bool kRare = stretched && kEach == 8;
    constexpr int kCount = kKernelCount<kEach, kRare>;
    if constexpr (kCount != 1)
      for_each_row<kCount>(job.influences, group, job.vertices, job.out,
                           SkinRow<kCount, stretched>{job, copies, one_hemisphere});
  });
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {
HWY_EXPORT(skin_center_of_rotation);
}

ErrorCode check(const SkinCenterOfRotationJob& job) noexcept {
  const std::size_t count = job.vertices.positions.size();
  if (job.centers.size() != count || job.palette.size() != job.split.size()) return ErrorCode::size_mismatch;
  if (!have_memory(job.centers, job.palette, job.split, job.pairs)) return ErrorCode::size_mismatch;
  if (!are_in_range(job.pairs, job.split.size())) return ErrorCode::index_out_of_range;
  return check_skinning(job.influences, job.vertices, job.out, job.palette.size());
}

void run_unchecked(const SkinCenterOfRotationJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  skin_single_influences(job.influences, job.palette, job.any_stretch, job.vertices, job.out);
  HWY_DYNAMIC_DISPATCH(skin_center_of_rotation)(job);
}

}  // namespace sinew
#endif
