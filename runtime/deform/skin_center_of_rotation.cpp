// SPDX-License-Identifier: MIT
#include "runtime/deform/skin_center_of_rotation.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/deform/skin_center_of_rotation.cpp"
#include <hwy/foreach_target.h>
#include <cassert>

#include "runtime/deform/scalar_blend.h"
#include "runtime/deform/simd/blend_columns-inl.h"
#include "runtime/deform/simd/kept_splits-inl.h"
#include "runtime/deform/simd/rigid_tiles-inl.h"
#include "runtime/deform/simd/rotate_directions-inl.h"
#include "runtime/deform/simd/spread_matrices-inl.h"
#include "runtime/deform/skin_single_influences.h"
#include "runtime/deform/vertex_checks.h"

#ifndef SINEW_SKIN_CENTER_OF_ROTATION_ONCE
#define SINEW_SKIN_CENTER_OF_ROTATION_ONCE
namespace sinew {
namespace {

/// The scalar path: skins one vertex, with every degenerate case.
template <bool kStretch, class In, class Out>
void skin_vertex(const SkinCenterOfRotationJob& job, const VertexJoints<0>& joints, const glm::vec3& center,
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

/// Moved centers of a tile.
/// eq   M c, M the blended matrices
template <int kCount>
HWY_INLINE Lanes3 moved_centers(const JointMatrix* palette, const TileInfluences<kCount>& joints,
                                const glm::vec3* centers) {
#if HWY_TARGET == HWY_SCALAR
  return transform_points(blend_lane_matrix(PaletteBases(palette), joints), load3(centers));
#else
  Wide quarters[4];
  for_each_quarter([&](auto q) HWY_ATTR {
    quarters[q] = transform_points(blend_columns(PaletteBases(palette), joints, q), load_spread<q>(centers));
  });
  const Lanes4 moved = lanes_of_quarters(quarters[0], quarters[1], quarters[2], quarters[3]);
  return {moved.x, moved.y, moved.z};
#endif
}

/// Differences of positions and centers. They are subtracted as they lie in memory, so that they are moved to lanes
/// once.
HWY_INLINE Lanes3 load_arms(const glm::vec3* positions, const glm::vec3* centers) {
  const TileTag d;
  HWY_ALIGN glm::vec3 arms[kTileSize];
  for (std::size_t i = 0; i < 3 * kTileSize; i += kTileSize)
    hn::Store(hn::Sub(hn::LoadU(d, &positions->x + i), hn::LoadU(d, &centers->x + i)), d, &arms->x + i);
  return load3(arms);
}

/// Moved centers of one tile, kept in memory like its splits.
struct KeptCenters {
  HWY_ALIGN float of[3][kTileSize];
};

/// Moves the centers of the tiles [first, end) of a row. Only this stage and KeepSplits depend on the number of
/// influences.
using KeepCenters = void(const JointMatrix* palette, const TileRow<0>& row, std::size_t first, std::size_t end,
                         const glm::vec3* centers, KeptCenters* kept);

template <int kCount>
HWY_NOINLINE void keep_centers(const JointMatrix* palette, const TileRow<0>& row, std::size_t first, std::size_t end,
                               const glm::vec3* centers, KeptCenters* kept) {
  const TileTag d;
  const TileRow<kCount> tiles = row.with_count<kCount>();
  for (std::size_t t = first; t < end; ++t) {
    auto& of = kept[t - first].of;
    const Lanes3 moved = moved_centers(palette, tiles.joints(t), centers + t * kTileSize);
    hn::Store(moved.x, d, of[0]);
    hn::Store(moved.y, d, of[1]);
    hn::Store(moved.z, d, of[2]);
  }
}

/// Centers of an incomplete tile, padded like its vertices.
struct CenterCopies {
  glm::vec3 centers[kTileSize];

  const glm::vec3* load(const glm::vec3* from, std::size_t count) {
    for (std::size_t k = 0; k < kTileSize; ++k) centers[k] = from[std::min(k, count - 1)];
    return centers;
  }
};

template <bool kStretch>
struct SkinRow {
  using Row = TileRow<0>;
  const SkinCenterOfRotationJob& job;
  CenterCopies& copies;
  bool one_hemisphere;
  KeepSplits<kStretch>* keep;
  KeepCenters* move;

  HWY_INLINE void operator()(const Row& row) const {
    const Row own = row;  // a copy, which no store can change
    const glm::vec3* centers = job.centers.data() + row.place.first_vertex;
    if (HWY_UNLIKELY(!row.place.whole)) centers = copies.load(centers, row.place.count);
    KeptSplits<kStretch> kept[kTilesAhead];
    KeptCenters moved[kTilesAhead];
    for (std::size_t first = 0; first < row.tile_count; first += kTilesAhead) {
      const std::size_t end = std::min(row.tile_count, first + kTilesAhead);
      keep(job.split.data(), row, first, end, one_hemisphere, kept);
      move(job.palette.data(), row, first, end, centers, moved);
      auto sound = hn::FirstN(TileTag(), kTileSize);
      for (std::size_t t = first; t < end; ++t)
        sound = hn::And(sound, skin_tile(kept[t - first], moved[t - first], own, t, centers + t * kTileSize));
      if (HWY_UNLIKELY(!hn::AllTrue(TileTag(), sound)))
        for (std::size_t t = first; t < end; ++t)
          skin_careful(kept[t - first], moved[t - first], row, t, centers + t * kTileSize);
    }
  }

 private:
  /// Skins a tile. Returns the vertices that are done.
  HWY_INLINE hn::Mask<TileTag> skin_tile(const KeptSplits<kStretch>& kept, const KeptCenters& moved, const Row& row,
                                         std::size_t t, const glm::vec3* centers) const {
    const TileTag d;
    const DualQuatLanes motion = kept.motion();
    StretchLanes stretch{};
    if constexpr (kStretch) stretch = kept.stretch();
    Lanes3 arm = load_arms(row.in(t).positions, centers);
    if constexpr (kStretch) arm = apply(stretch, arm);
    store3(plus(rotate(motion, arm), {hn::Load(d, moved.of[0]), hn::Load(d, moved.of[1]), hn::Load(d, moved.of[2])}),
           row.out(t).positions);
    return rotate_directions<kStretch>(motion, stretch, row.in(t), row.out(t));
  }

  /// Skins some vertices of a tile by the scalar path: their blend cancels or is tiny, or their directions lose digits.
  HWY_NOINLINE void skin_careful(const KeptSplits<kStretch>& kept, const KeptCenters& moved, const Row& row,
                                 std::size_t t, const glm::vec3* centers) const {
    for_each_lane_not_in(skin_tile(kept, moved, row, t, centers), [&](std::size_t lane) {
      const std::size_t v = vertex_of_lane(lane);
      skin_vertex<kStretch>(job, row.joints(t).at(v), centers[v], row.in(t), row.out(t), v);
    });
  }
};

/// A job without stretches, and its attributes.
struct CenteredTiles {
  const SkinCenterOfRotationJob& job;
  AttributesPresent wanted;
};

/// Skins vectors of a run with any number of joints. Kernels for 1 to 4 joints would take 15 % fewer instructions and
/// as long to compile as the rest of this file.
/// eq   p' = R (p - c) + M c
class CenteredLanes {
 public:
  static constexpr int kCount = 0;
  static constexpr bool kCenters = true;
  AttributesPresent wanted() const { return wanted_; }

  HWY_INLINE CenteredLanes(const CenteredTiles& tiles, const TileStreams& s, const TileRun& run)
      : job_(tiles.job),
        vertices_(s.vertices_of(run)),
        wanted_(tiles.wanted),
        motions_(tiles.job.split.data(), s.joints_of(run), run.joint_count),
        matrices_(tiles.job.palette.data(), s.joints_of(run), run.joint_count) {}

  /// Skins one vector of lanes. Returns the lanes that are done.
  HWY_INLINE hn::Mask<TileTag> skin(std::size_t lane, const TileInputs& tile, const LaneOutputs& out) const {
    SpreadMatrices<0>::Blend blend(matrices_, tile.weights, lane);
    const Lanes3 c = load_planes3(tile.centers, lane);
    const Lanes3 of_x = blend.column(0);
    Lanes3 moved = plus_product(blend.column(3), of_x, c.x);
    moved = plus_product(moved, blend.column(1), c.y);
    moved = plus_product(moved, blend.column(2), c.z);
    const DualQuatLanes motion = motions_.blend(tile.weights, lane);
    const Lanes3 arm = minus(load_planes3(tile.positions, lane), c);
    pack(plus(rotate(motion, arm), moved), out.positions);
    return rotate_directions(motion, wanted_, tile, lane, out);
  }

  HWY_INLINE void mend(hn::Mask<TileTag> sound, const TileRun&, std::size_t lane, const TileInputs&) const {
    for_each_lane_not_in(sound, [&](std::size_t i) { skin_careful(vertices_[lane + i]); });
  }

 private:
  HWY_NOINLINE void skin_careful(std::size_t v) const {
    WidenedInfluences widened;
    const VertexJoints<0> joints = influences_of(job_.influences, v, widened);
    skin_vertex<false>(job_, joints, job_.centers[v], inputs_of(job_), outputs_of(job_, wanted_), v);
  }

  const SkinCenterOfRotationJob& job_;
  const std::uint32_t* vertices_;
  AttributesPresent wanted_;
  SpreadMotions<0> motions_;
  SpreadMatrices<0> matrices_;
};

void skin_centered_tiles(const SkinCenterOfRotationJob& job, AttributesPresent wanted) {
  const TileStreams streams{*job.tiles, attributes_of(*job.tiles), job.out, wants_streams(*job.tiles, wanted, false)};
  for (const TileRun& run : job.tiles->runs) skin_run<CenteredLanes>(streams, run, CenteredTiles{job, wanted});
  if (streams.past_caches) hwy::FlushStream();  // makes the output visible to threads that this one signals afterwards
}

void skin_center_of_rotation(const SkinCenterOfRotationJob& job) {
  CenterCopies copies;
  const bool one_hemisphere = are_in_one_hemisphere(job.pairs, job.split);
  const AttributesPresent wanted = present(job.vertices, job.out);
  if (one_hemisphere && may_use_tiles(job, wanted)) return skin_centered_tiles(job, wanted);
  skin_single_influences(job.influences, job.palette, job.any_stretch, job.vertices, job.out);
  for_each_group(job.influences, job.any_stretch, [&](const InfluenceGroup& group, auto each_count, auto stretched) {
    constexpr int kEach = each_count;
    if constexpr (kEach != 1)
      for_each_row<0>(job.influences, group, job.vertices, job.out,
                      SkinRow<stretched>{job, copies, one_hemisphere, keep_splits_of<stretched>(group.influence_count),
                                         &keep_centers<kKernelCount<kEach, false>>});
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
  if (job.tiles && (job.tiles->vertex_count != count || job.tiles->centers.empty() != job.tiles->empty()))
    return ErrorCode::size_mismatch;
  if (job.tiles && job.tiles->joint_count > job.split.size()) return ErrorCode::index_out_of_range;
  if (job.centers.size() != count || job.palette.size() != job.split.size()) return ErrorCode::size_mismatch;
  if (!have_memory(job.centers, job.palette, job.split, job.pairs)) return ErrorCode::size_mismatch;
  if (!are_in_range(job.pairs, job.split.size())) return ErrorCode::index_out_of_range;
  return check_skinning(job.influences, job.vertices, job.out, job.palette.size());
}

void run_unchecked(const SkinCenterOfRotationJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  HWY_DYNAMIC_DISPATCH(skin_center_of_rotation)(job);
}

}  // namespace sinew
#endif
