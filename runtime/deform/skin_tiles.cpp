// SPDX-License-Identifier: MIT
#include "runtime/deform/skin_tiles.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/deform/skin_tiles.cpp"
#include <hwy/foreach_target.h>

#include "runtime/deform/influence_dispatch.h"
#include "runtime/deform/simd/non_temporal_stores-inl.h"
#include "runtime/deform/simd/spread_matrices-inl.h"
#include "runtime/deform/simd/tile_planes-inl.h"
#include "runtime/deform/vertex_checks.h"
#include "runtime/math/normal_transform.h"
#include "runtime/pose/simd/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

/// A job's arrays.
struct TileStreams {
  const VertexTiles& tiles;
  const JointMatrix* palette;
  VertexInput moved;
  VertexOutput out;
  bool past_caches;  ///< stores may bypass the caches where they are aligned

  const std::uint16_t* joints_of(const TileRun& run) const { return tiles.joints.data() + run.first_joint; }
  bool any_moved() const { return !moved.positions.empty() || !moved.normals.empty() || !moved.tangents.empty(); }
};

/// Planes of a tile, and where packed vertices go.
struct TileAccess {
  const TilePlane* positions;
  const TilePlane* normals;
  const TilePlane* tangents;
  glm::vec3* positions_out;
  glm::vec3* normals_out;
  glm::vec4* tangents_out;
};

/// Stands between a vector of lanes and the arrays of vertices, if the vertices are not in a row, have moved, or go
/// past the caches.
struct Detour {
  TilePlane positions[3], normals[3], tangents[4];
  glm::vec3 positions_out[kTileSize], normals_out[kTileSize];
  glm::vec4 tangents_out[kTileSize];

  /// in   tile  of the tiles;   at  index of the first lane among all lanes
  HWY_NOINLINE TileAccess begin(const TileStreams& s, std::size_t at, const TilePlane* rest_positions,
                                const TilePlane* rest_normals, const TilePlane* rest_tangents) {
    const std::uint32_t* vertices = s.tiles.vertices.data() + at;
    const std::size_t lane = at % VertexTiles::kLanes;
    const auto moved_or = [&](const auto& moved, const TilePlane* rest, TilePlane* gathered) -> const TilePlane* {
      if (moved.empty()) return rest;
      gather(moved.data(), vertices, lane, gathered);
      return gathered;
    };
    return {moved_or(s.moved.positions, rest_positions, positions),
            moved_or(s.moved.normals, rest_normals, normals),
            moved_or(s.moved.tangents, rest_tangents, tangents),
            positions_out,
            normals_out,
            tangents_out};
  }
  HWY_NOINLINE void end(const TileStreams& s, const TileRun& run, std::size_t lane, bool has_normals,
                        bool has_tangents) const {
    const std::size_t at = std::size_t{run.first_tile} * VertexTiles::kLanes + lane;
    const bool streams = s.past_caches && lane < lanes_in_a_row(run);
    const std::uint32_t* vertices = s.tiles.vertices.data() + at;
    const std::uint32_t* fours = s.tiles.fours.data() + at / 4;
    scatter(positions_out, vertices, fours, streams, s.out.positions.data());
    if (has_normals) scatter(normals_out, vertices, fours, streams, s.out.normals.data());
    if (has_tangents) scatter(tangents_out, vertices, fours, streams, s.out.tangents.data());
  }
};

/// The scalar path for normals and tangents of a vector of lanes. Needed if squares leave the range of float, the side of
/// a normal is in doubt, or a direction vanishes. The matrices have the bits of those that move the positions.
/// in   tile  outputs begin with the vector
HWY_NOINLINE void write_careful(const TileStreams& s, const TileRun& run, std::size_t lane_of_run, TileAccess tile,
                                bool normals, bool tangents, bool cofactor) {
  const TileTag d;
  const std::size_t lane = lane_of_run % VertexTiles::kLanes;
  const TilePlane* weights =
      &s.tiles.positions[run.first_plane + lane_of_run / VertexTiles::kLanes * run.planes_per_tile() + 3];
  const SpreadMatrices<0> matrices(s.palette, s.joints_of(run), run.joint_count);
  const Lanes3 columns[4] = {matrices.column(0, weights, lane), matrices.column(1, weights, lane),
                             matrices.column(2, weights, lane), matrices.column(3, weights, lane)};
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
  if (normals) {
    Lanes3 moved = moved_normals(m, load_planes3(tile.normals, lane), cofactor);
    for_each_lane_not_in(normalise(moved),
                         [&](std::size_t i) { tile.normals_out[i] = careful(tile.normals, i, cofactor); });
  }
  if (tangents) {
    Lanes3 moved = transform_vectors(m, load_planes3(tile.tangents, lane));
    for_each_lane_not_in(normalise(moved), [&](std::size_t i) {
      tile.tangents_out[i] = glm::vec4(careful(tile.tangents, i, false), tile.tangents[3].lane[lane + i]);
    });
  }
}

/// Skins runs of tiles whose vertices have `kCount` joints; 0 = known at run time only.
template <int kCount, bool kNormals, bool kTangents, bool kCofactor>
struct SkinRun {
  const TileStreams& s;

  HWY_NOINLINE void operator()(const TileRun& run) const {
    const auto matrices = matrices_of(run);
    const std::size_t planes = kCount > 0 ? 2 + static_cast<std::size_t>(kCount) : run.planes_per_tile();
    const std::size_t lane_count = run.lane_count, first_lane = std::size_t{run.first_tile} * VertexTiles::kLanes;
    const std::size_t direct_lanes = s.past_caches || s.any_moved() ? 0 : lanes_in_a_row(run);
    const std::uint32_t* first_of = kTileSize == 1 ? &s.tiles.vertices[first_lane] : &s.tiles.fours[first_lane / 4];
    const VertexOutput out = s.out;  // a copy, which no store can change
    TileAccess tile = inputs(run);
    Detour detour;
    for (std::size_t lane = 0, in_tile = 0; lane < lane_count; lane += kTileSize) {
      const TilePlane* weights = tile.positions + 3;
      TileAccess at;
      const bool is_direct = lane < direct_lanes;
      if (HWY_LIKELY(is_direct)) {
        const std::size_t first = first_of[lane / std::min<std::size_t>(kTileSize, 4)];
        at = {tile.positions,
              tile.normals,
              tile.tangents,
              out.positions.data() + first,
              kNormals ? out.normals.data() + first : nullptr,
              kTangents ? out.tangents.data() + first : nullptr};
      } else {
        at = detour.begin(s, first_lane + lane, tile.positions, tile.normals, tile.tangents);
      }
      const bool sound = skin_lanes(matrices, weights, in_tile, at);
      if constexpr (kNormals || kTangents)
        if (HWY_UNLIKELY(!sound)) write_careful(s, run, lane, at, kNormals, kTangents, kCofactor);
      if (HWY_UNLIKELY(!is_direct)) detour.end(s, run, lane, kNormals, kTangents);
      in_tile += kTileSize;
      if (in_tile < VertexTiles::kLanes) continue;
      in_tile = 0;
      tile.positions += planes;
      if constexpr (kNormals) tile.normals += 3;
      if constexpr (kTangents) tile.tangents += 4;
    }
  }

 private:
  HWY_INLINE auto matrices_of(const TileRun& run) const {
    return SpreadMatrices<kCount>(s.palette, s.joints_of(run), run.joint_count);
  }
  HWY_INLINE TileAccess inputs(const TileRun& run) const {
    TileAccess tile{};
    tile.positions = s.tiles.positions.data() + run.first_plane;
    if constexpr (kNormals) tile.normals = s.tiles.normals.data() + std::size_t{run.first_tile} * 3;
    if constexpr (kTangents) tile.tangents = s.tiles.tangents.data() + std::size_t{run.first_tile} * 4;
    return tile;
  }
  /// Column by column, so that everything fits into sixteen registers. True if all directions keep their digits.
  template <class Matrices>
  HWY_INLINE bool skin_lanes(const Matrices& matrices, const TilePlane* weights, std::size_t lane,
                             const TileAccess& tile) const {
    const auto column = [&](std::size_t c) HWY_ATTR { return matrices.column(c, weights, lane); };
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
    pack(plus_product(moved_p, m.c2, p.z), tile.positions_out);
    auto sound = hn::FirstN(TileTag(), kTileSize);
    if constexpr (kNormals) {
      moved_n = kCofactor ? moved_normals(m, n, true) : plus_product(moved_n, m.c2, n.z);
      sound = normalise(moved_n);
      pack(moved_n, tile.normals_out);
    }
    if constexpr (kTangents) {
      moved_t = plus_product(moved_t, m.c2, t.z);
      sound = hn::And(sound, normalise(moved_t));
      pack(Lanes4{moved_t.x, moved_t.y, moved_t.z, load_plane(tile.tangents[3], lane)}, tile.tangents_out);
    }
    return hn::AllTrue(TileTag(), sound);
  }
};

/// Runs of five joints and more blend in a loop.
template <class Body>
void with_joint_count(const TileRun& run, const Body& body) {
  switch (run.joint_count) {
    case 1: body(std::integral_constant<int, 1>()); break;
    case 2: body(std::integral_constant<int, 2>()); break;
    case 3: body(std::integral_constant<int, 3>()); break;
    case 4: body(std::integral_constant<int, 4>()); break;
    default: body(std::integral_constant<int, 0>()); break;
  }
}

bool wants_streams(const SkinTilesJob& job) {
  const std::size_t bytes = sizeof(glm::vec3) * (1 + job.writes_normals()) + sizeof(glm::vec4) * job.writes_tangents();
  // With four lanes arithmetic, not memory, limits the speed.
  return kTileSize > 1 && ((job.past_caches && kTileSize >= 8) || job.tiles->vertex_count * bytes >= kStreamedBytes);
}

void skin_tiles(const SkinTilesJob& job) {
  const TileStreams streams{*job.tiles, job.palette.data(), job.moved, job.out, wants_streams(job)};
  const auto skin = [&](auto normals, auto tangents, auto cofactor) {
    for (const TileRun& run : job.tiles->runs)
      with_joint_count(run, [&](auto count) {
        // Few meshes have tangents but no normals: they need no kernels of their own.
        constexpr int kCount = tangents && !normals ? 0 : static_cast<int>(count);
        SkinRun<kCount, normals, tangents, cofactor>{streams}(run);
      });
  };
  with_attributes({job.writes_normals(), job.writes_tangents()}, [&](auto normals, auto tangents) {
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

ErrorCode check(const SkinTilesJob& job) noexcept {
  if (job.tiles == nullptr || !have_memory(job.palette, job.moved.positions, job.moved.normals, job.moved.tangents,
                                           job.out.positions, job.out.normals, job.out.tangents))
    return ErrorCode::size_mismatch;
  const std::size_t count = job.tiles->vertex_count;
  const auto moved_fits = [count](std::size_t moved) { return moved == 0 || moved == count; };
  const bool fits = job.out.positions.size() >= count && (!job.writes_normals() || job.out.normals.size() >= count) &&
                    (!job.writes_tangents() || job.out.tangents.size() >= count) &&
                    moved_fits(job.moved.positions.size()) && moved_fits(job.moved.normals.size()) &&
                    moved_fits(job.moved.tangents.size());
  if (!fits) return ErrorCode::size_mismatch;
  return job.palette.size() < job.tiles->joint_count ? ErrorCode::index_out_of_range : ErrorCode::ok;
}

SINEW_DISPATCH_RUN(SkinTilesJob, skin_tiles)

}  // namespace sinew
#endif
