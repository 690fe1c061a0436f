// SPDX-License-Identifier: MIT
#include "runtime/deform/skin_dual_quaternion.h"

#include <cassert>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/deform/skin_dual_quaternion.cpp"
#include <hwy/foreach_target.h>

#include "runtime/deform/scalar_blend.h"
#include "runtime/deform/simd/kept_splits-inl.h"
#include "runtime/deform/simd/rigid_tiles-inl.h"
#include "runtime/deform/simd/rotate_directions-inl.h"
#include "runtime/deform/simd/spread_motions-inl.h"
#include "runtime/deform/skin_single_influences.h"
#include "runtime/deform/vertex_checks.h"

#ifndef SINEW_SKIN_DUAL_QUATERNION_ONCE
#define SINEW_SKIN_DUAL_QUATERNION_ONCE
namespace sinew {
namespace {

/// The scalar path: skins one vertex, with every degenerate case.
template <bool kStretch, class In, class Out>
void skin_vertex(std::span<const RigidStretch> split, const VertexJoints<0>& joints, const In& in, const Out& out,
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
HWY_NOINLINE void keep_splits(const RigidStretch* split, const TileRow<0>& row, std::size_t first, std::size_t end,
                              bool one_hemisphere, KeptSplits<kStretch>* kept) {
  const TileRow<kCount> tiles = row.with_count<kCount>();
  for (std::size_t t = first; t < end; ++t) kept[t - first].keep(split, tiles.joints(t), one_hemisphere);
}

/// Kernels with stretches for eight influences are rare.
template <bool kStretch>
KeepSplits<kStretch>* choose_keep_splits(std::uint32_t influence_count) {
  KeepSplits<kStretch>* chosen = nullptr;
  with_influence_count(influence_count, [&](auto count) {
    constexpr int kEach = count == 1 ? 0 : static_cast<int>(count);  // single influences mostly skin linearly
    constexpr bool kRare = kStretch && kEach == 8;
    constexpr int kCount = kKernelCount<kEach, kRare>;
    chosen = &keep_splits<kCount, kStretch>;
  });
  return chosen;
}

template <bool kStretch>
struct SkinRow {
  using Row = TileRow<0>;
  const SkinDualQuaternionJob& job;
  bool one_hemisphere;
  KeepSplits<kStretch>* keep;

  HWY_INLINE void operator()(const Row& row) const {
    const Row own = row;  // a copy, which no store can change
    KeptSplits<kStretch> kept[kTilesAhead];
    for (std::size_t first = 0; first < row.tile_count; first += kTilesAhead) {
      const std::size_t end = std::min(row.tile_count, first + kTilesAhead);
      keep(job.split.data(), row, first, end, one_hemisphere, kept);
      auto sound = hn::FirstN(TileTag(), kTileSize);
      for (std::size_t t = first; t < end; ++t) sound = hn::And(sound, skin_tile(kept[t - first], own, t));
      if (HWY_UNLIKELY(!hn::AllTrue(TileTag(), sound)))
        for (std::size_t t = first; t < end; ++t) skin_careful(kept[t - first], row, t);
    }
  }

 private:
  /// Skins a tile. Returns the vertices that are done.
  HWY_INLINE hn::Mask<TileTag> skin_tile(const KeptSplits<kStretch>& kept, const Row& row, std::size_t t) const {
    const DualQuatLanes motion = kept.motion();
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
      skin_vertex<kStretch>(job.split, row.joints(t).at(v), row.in(t), row.out(t), v);
    });
  }
};

/// Skins one vertex by the scalar path, from the job's arrays.
HWY_NOINLINE void skin_careful(const SkinDualQuaternionJob& job, AttributesPresent wanted, std::size_t v) {
  WidenedInfluences widened;
  skin_vertex<false>(job.split, influences_of(job.influences, v, widened), inputs_of(job), outputs_of(job, wanted), v);
}

/// A job without stretches, and its attributes.
struct RigidTiles {
  const SkinDualQuaternionJob& job;
  AttributesPresent wanted;
};

/// Skins vectors of a run whose vertices have `kJoints` joints; 0 = known at run time only.
template <int kJoints>
class RigidLanes {
 public:
  static constexpr int kCount = kJoints;
  static constexpr bool kCenters = false;
  AttributesPresent wanted() const { return wanted_; }

  HWY_INLINE RigidLanes(const RigidTiles& tiles, const TileStreams& s, const TileRun& run)
      : job_(tiles.job),
        vertices_(s.vertices_of(run)),
        wanted_(tiles.wanted),
        motions_(tiles.job.split.data(), s.joints_of(run), run.joint_count) {}

  /// Skins one vector of lanes. Returns the lanes that are done.
  HWY_INLINE hn::Mask<TileTag> skin(std::size_t lane, const TileInputs& tile, const LaneOutputs& out) const {
    const DualQuatLanes motion = motions_.blend(tile.weights, lane);
    pack(move_points(motion, load_planes3(tile.positions, lane)), out.positions);
    return rotate_directions(motion, wanted_, tile, lane, out);
  }

  HWY_INLINE void mend(hn::Mask<TileTag> sound, const TileRun&, std::size_t lane, const TileInputs&) const {
    for_each_lane_not_in(sound, [&](std::size_t i) { skin_careful(job_, wanted_, vertices_[lane + i]); });
  }

 private:
  const SkinDualQuaternionJob& job_;
  const std::uint32_t* vertices_;
  AttributesPresent wanted_;
  SpreadMotions<kCount> motions_;
};

void skin_rigid_tiles(const SkinDualQuaternionJob& job, AttributesPresent wanted) {
  const TileStreams streams{*job.tiles, attributes_of(*job.tiles), job.out, wants_streams(*job.tiles, wanted, false)};
  for (const TileRun& run : job.tiles->runs)
    with_joint_count(run, [&](auto count) { skin_run<RigidLanes<count>>(streams, run, RigidTiles{job, wanted}); });
  if (streams.past_caches) hwy::FlushStream();  // makes the output visible to threads that this one signals afterwards
}

void skin_dual_quaternion(const SkinDualQuaternionJob& job) {
  const bool one_hemisphere = are_in_one_hemisphere(job.pairs, job.split);
  const AttributesPresent wanted = present(job.vertices, job.out);
  if (one_hemisphere && may_use_tiles(job, wanted)) return skin_rigid_tiles(job, wanted);
  if (!job.palette.empty()) skin_single_influences(job.influences, job.palette, job.any_stretch, job.vertices, job.out);
  for (const InfluenceGroup& group : job.influences.groups) {
    if (group.influence_count == 1 && !job.palette.empty()) continue;
    const auto skin = [&](auto stretched) {
      for_each_row<0>(job.influences, group, job.vertices, job.out,
                      SkinRow<stretched>{job, one_hemisphere, keep_splits_of<stretched>(group.influence_count)});
    };
    if (job.any_stretch)
      skin(std::true_type{});
    else
      skin(std::false_type{});
  }
}

}  // namespace

template <>
KeepSplits<false>* keep_splits_of<false>(std::uint32_t influence_count) {
  return choose_keep_splits<false>(influence_count);
}
template <>
KeepSplits<true>* keep_splits_of<true>(std::uint32_t influence_count) {
  return choose_keep_splits<true>(influence_count);
}

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
  if (job.tiles && job.tiles->vertex_count != job.vertices.positions.size()) return ErrorCode::size_mismatch;
  if (job.tiles && job.tiles->joint_count > count) return ErrorCode::index_out_of_range;
  return check_skinning(job.influences, job.vertices, job.out, count);
}

void run_unchecked(const SkinDualQuaternionJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  HWY_DYNAMIC_DISPATCH(skin_dual_quaternion)(job);
}

}  // namespace sinew
#endif
