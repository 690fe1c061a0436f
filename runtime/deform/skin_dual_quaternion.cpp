// SPDX-License-Identifier: MIT
#include "runtime/deform/skin_dual_quaternion.h"

#include <algorithm>
#include <cassert>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/deform/skin_dual_quaternion.cpp"
#include <hwy/foreach_target.h>

#include "runtime/deform/scalar_blend.h"
#include "runtime/deform/simd/kept_splits-inl.h"
#include "runtime/deform/simd/rotate_directions-inl.h"
#include "runtime/deform/skin_single_influences.h"
#include "runtime/deform/vertex_checks.h"

#ifndef SINEW_SKIN_DUAL_QUATERNION_ONCE
#define SINEW_SKIN_DUAL_QUATERNION_ONCE
namespace sinew {
namespace {

/// The scalar path: skins one vertex, with every degenerate case.
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

}  // namespace
}  // namespace sinew
#endif

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

template <int kCount, bool kStretch>
struct SkinRow {
  using Row = TileRow<kCount>;
  const SkinDualQuaternionJob& job;
  bool one_hemisphere;

  HWY_INLINE void operator()(const Row& row) const {
    KeptSplits<kStretch> kept[kTilesAhead];
    for (std::size_t first = 0; first < row.tile_count; first += kTilesAhead) {
      const std::size_t end = std::min(row.tile_count, first + kTilesAhead);
      for (std::size_t t = first; t < end; ++t) kept[t - first].keep(job.split.data(), row.joints(t), one_hemisphere);
      auto sound = hn::FirstN(TileTag(), kTileSize);
      for (std::size_t t = first; t < end; ++t) sound = hn::And(sound, skin_tile(kept[t - first], row, t));
      if (HWY_UNLIKELY(!hn::AllTrue(TileTag(), sound)))
        for (std::size_t t = first; t < end; ++t) SkinRow(*this).skin_careful(kept[t - first], Row(row), t);
    }
  }

 private:
  /// Skins a tile. Returns the vertices that are done.
  HWY_INLINE hn::Mask<TileTag> skin_tile(const KeptSplits<kStretch>& kept, const Row& row, std::size_t t) const {
    const DualQuatLanes motion = kept.template motion<kCount>();
    StretchLanes stretch{};
    if constexpr (kStretch) stretch = kept.stretch();
    Lanes3 p = load3(row.in(t).positions);
    if constexpr (kStretch) p = apply(stretch, p);
    store3(move_points(motion, p), row.out(t).positions);
    return rotate_directions<kStretch>(motion, stretch, row.in(t), row.out(t));
  }

  /// Skins some vertices of a tile by the scalar path: their blend cancels or is tiny, or their directions lose digits.
  HWY_NOINLINE void skin_careful(const KeptSplits<kStretch>& kept, const Row& row, std::size_t t) const {
    for_each_lane_not_in(skin_tile(kept, row, t), [&](std::size_t lane) {
      const std::size_t v = vertex_of_lane(lane);
      skin_vertex<kCount, kStretch>(job.split, row.joints(t).at(v), row.in(t), row.out(t), v);
    });
  }
};

void skin_dual_quaternion(const SkinDualQuaternionJob& job) {
  const bool one_hemisphere = are_in_one_hemisphere(job.pairs, job.split);
  for_each_group(job.influences, job.any_stretch, [&](const InfluenceGroup& group, auto each_count, auto stretched) {
    if (each_count == 1 && !job.palette.empty()) return;
    // Without a palette, which is rare, single influences use the general kernel.
    constexpr int kEach = each_count == 1 ? 0 : static_cast<int>(each_count);
    constexpr bool kRare = stretched && kEach == 8;
    constexpr int kCount = kKernelCount<kEach, kRare>;
    for_each_row<kCount>(job.influences, group, job.vertices, job.out, SkinRow<kCount, stretched>{job, one_hemisphere});
  });
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {
HWY_EXPORT(skin_dual_quaternion);
}

ErrorCode check(const SkinDualQuaternionJob& job) noexcept {
  const std::size_t count = job.split.size();
  if (!job.palette.empty() && job.palette.size() < count) return ErrorCode::size_mismatch;
  if (!have_memory(job.palette, job.split, job.pairs)) return ErrorCode::size_mismatch;
  if (!are_in_range(job.pairs, count)) return ErrorCode::index_out_of_range;
  return check_skinning(job.influences, job.vertices, job.out, count);
}

void run_unchecked(const SkinDualQuaternionJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  if (!job.palette.empty()) skin_single_influences(job.influences, job.palette, job.any_stretch, job.vertices, job.out);
  HWY_DYNAMIC_DISPATCH(skin_dual_quaternion)(job);
}

}  // namespace sinew
#endif
