// SPDX-License-Identifier: MIT
#include "runtime/deform/skin_tiles.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/deform/skin_tiles.cpp"
#include <hwy/foreach_target.h>

#include "runtime/deform/influence_dispatch.h"
#include "runtime/deform/simd/spread_matrices-inl.h"
#include "runtime/deform/simd/tile_runs-inl.h"
#include "runtime/deform/vertex_checks.h"
#include "runtime/math/normal_transform.h"
#include "runtime/pose/simd/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

/// The scalar path for normals and tangents of a vector of lanes. It is needed if squares leave the range of float, the
/// side of a normal is in doubt, or a direction vanishes. The matrices have the same bits as for the positions.
HWY_NOINLINE void write_careful(const TileStreams& s, const JointMatrix* palette, const TileRun& run,
                                std::size_t lane_of_run, TileInputs tile, AttributesPresent wanted, bool cofactor) {
  const TileTag d;
  const std::size_t lane = lane_of_run % VertexTiles::kLanes;
  const std::uint32_t* vertices = s.vertices_of(run) + lane_of_run;
  const SpreadMatrices<0> matrices(palette, s.joints_of(run), run.joint_count);
  SpreadMatrices<0>::Blend blend(matrices, tile.weights, lane);
  Lanes3 columns[4];
  for (const std::size_t c : {0, 3, 1, 2}) columns[c] = blend.column(c);
  const LaneMatrix m{columns[0], columns[1], columns[2], columns[3]};
  HWY_ALIGN float entries[4][3][kTileSize];
  for (std::size_t c = 0; c < 4; ++c) {
    hn::Store(columns[c].x, d, entries[c][0]);
    hn::Store(columns[c].y, d, entries[c][1]);
    hn::Store(columns[c].z, d, entries[c][2]);
  }
  const auto careful = [&](const TilePlane* from, std::size_t i, bool by_cofactors) {
    Affine of_lane;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) of_lane.row[r][c] = entries[c][r][i];
    const glm::vec3 v(from[0].lane[lane + i], from[1].lane[lane + i], from[2].lane[lane + i]);
    return by_cofactors ? transform_normal_outward(linear_part(of_lane), v)
                        : normalised_or(transform_vector(of_lane, v), v);
  };
  if (wanted.normals) {
    Lanes3 moved = moved_normals(m, load_planes3(tile.normals, lane), cofactor);
    for_each_lane_not_in(normalise(moved),
                         [&](std::size_t i) { s.out.normals[vertices[i]] = careful(tile.normals, i, cofactor); });
  }
  if (wanted.tangents) {
    Lanes3 moved = transform_vectors(m, load_planes3(tile.tangents, lane));
    for_each_lane_not_in(normalise(moved), [&](std::size_t i) {
      s.out.tangents[vertices[i]] = glm::vec4(careful(tile.tangents, i, false), tile.tangents[3].lane[lane + i]);
    });
  }
}

/// Skins vectors of a run whose vertices have `kCount` joints; 0 = known at run time only.
template <int kJoints, bool kNormals, bool kTangents, bool kCofactor>
class LinearLanes {
 public:
  static constexpr int kCount = kJoints;
  static constexpr bool kCenters = false;
  static constexpr AttributesPresent wanted() { return {kNormals, kTangents}; }

  HWY_INLINE LinearLanes(const JointMatrix* palette, const TileStreams& s, const TileRun& run)
      : palette_(palette), streams_(s), matrices_(palette, s.joints_of(run), run.joint_count) {}

  /// Skins one vector of lanes, column by column, so that everything fits into sixteen registers. Returns true if all
  /// directions keep their digits.
  HWY_INLINE bool skin(std::size_t lane, const TileInputs& tile, const LaneOutputs& out) const {
    typename SpreadMatrices<kCount>::Blend blend(matrices_, tile.weights, lane);
    const auto column = [&](std::size_t c) HWY_ATTR { return blend.column(c); };
    const Lanes3 p = load_planes3(tile.positions, lane);
    Lanes3 n{}, t{}, moved_n{}, moved_t{};
    if constexpr (kNormals) n = load_planes3(tile.normals, lane);
    if constexpr (kTangents) t = load_planes3(tile.tangents, lane);
    LaneMatrix m;
    m.c0 = column(0);
    Lanes3 moved_p = plus_product(column(3), m.c0, p.x);
    if constexpr (kNormals && !kCofactor) moved_n = times(m.c0, n.x);
    if constexpr (kTangents) moved_t = times(m.c0, t.x);
    m.c1 = column(1);
    moved_p = plus_product(moved_p, m.c1, p.y);
    if constexpr (kNormals && !kCofactor) moved_n = plus_product(moved_n, m.c1, n.y);
    if constexpr (kTangents) moved_t = plus_product(moved_t, m.c1, t.y);
    m.c2 = column(2);
    pack(plus_product(moved_p, m.c2, p.z), out.positions);
    auto sound = hn::FirstN(TileTag(), kTileSize);
    if constexpr (kNormals) {
      moved_n = kCofactor ? moved_normals(m, n, true) : plus_product(moved_n, m.c2, n.z);
      sound = normalise(moved_n);
      pack(moved_n, out.normals);
    }
    if constexpr (kTangents) {
      moved_t = plus_product(moved_t, m.c2, t.z);
      sound = hn::And(sound, normalise(moved_t));
      pack(Lanes4{moved_t.x, moved_t.y, moved_t.z, load_plane(tile.tangents[3], lane)}, out.tangents);
    }
    return hn::AllTrue(TileTag(), sound);
  }

  HWY_INLINE void mend([[maybe_unused]] bool sound, const TileRun& run, std::size_t lane,
                       const TileInputs& tile) const {
    if constexpr (kNormals || kTangents)
      if (HWY_UNLIKELY(!sound)) write_careful(streams_, palette_, run, lane, tile, wanted(), kCofactor);
  }

 private:
  const JointMatrix* palette_;
  const TileStreams& streams_;
  SpreadMatrices<kCount> matrices_;
};

void skin_tiles(const SkinTilesJob& job) {
  const AttributesPresent wanted{job.writes_normals(), job.writes_tangents()};
  const TileStreams streams{*job.tiles, job.input(), job.out, wants_streams(*job.tiles, wanted, job.past_caches)};
  const auto skin = [&](auto normals, auto tangents, auto cofactor) {
    for (const TileRun& run : job.tiles->runs)
      with_joint_count(run, [&](auto count) {
        // Few meshes have tangents but no normals, and few jobs ask for cofactors. They use the kernel for any number
        // of joints.
        constexpr int kCount = (tangents && !normals) || cofactor ? 0 : static_cast<int>(count);
        skin_run<LinearLanes<kCount, normals, tangents, cofactor>>(streams, run, job.palette.data());
      });
  };
  with_attributes(wanted, [&](auto normals, auto tangents) {
    if (normals && job.normal_rule == NormalRule::cofactor)
      skin(normals, tangents, normals);
    else
      skin(normals, tangents, std::false_type{});
  });
  if (streams.past_caches) hwy::FlushStream();  // makes the output visible to threads that this one signals afterwards
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {

/// True if the attributes have memory for all tiles, where they are not empty.
bool may_replace(const TiledInput& morphed, const VertexTiles& tiles) noexcept {
  const auto fits = [&](std::span<const TilePlane> planes, std::size_t per_tile) {
    return planes.empty() || planes.size() >= per_tile * tiles.tile_count();
  };
  return have_memory(morphed.positions, morphed.normals, morphed.tangents) && fits(morphed.positions, 3) &&
         fits(morphed.normals, 3) && fits(morphed.tangents, 4);
}

}  // namespace

ErrorCode check(const SkinTilesJob& job) noexcept {
  if (job.tiles == nullptr || !have_memory(job.palette, job.out.positions, job.out.normals, job.out.tangents))
    return ErrorCode::size_mismatch;
  const std::size_t count = job.tiles->vertex_count;
  const bool fits = job.out.positions.size() >= count && (!job.writes_normals() || job.out.normals.size() >= count) &&
                    (!job.writes_tangents() || job.out.tangents.size() >= count);
  if (!fits || !may_replace(job.morphed, *job.tiles)) return ErrorCode::size_mismatch;
  return job.palette.size() < job.tiles->joint_count ? ErrorCode::index_out_of_range : ErrorCode::ok;
}

SINEW_DISPATCH_RUN(SkinTilesJob, skin_tiles)

}  // namespace sinew
#endif
