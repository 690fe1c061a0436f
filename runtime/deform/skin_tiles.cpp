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
  VertexOutput out;
  bool past_caches;  ///< stores may bypass the caches where they are aligned

  bool is_aligned(std::size_t vertex) const {
    const auto address = [](const void* at) { return reinterpret_cast<std::uintptr_t>(at); };
    return (address(out.positions.data() + vertex) | (out.normals.empty() ? 0 : address(out.normals.data() + vertex)) |
            (out.tangents.empty() ? 0 : address(out.tangents.data() + vertex))) %
               sizeof(Wide) ==
           0;
  }
  const std::uint16_t* joints_of(const TileRun& run) const { return tiles.joints.data() + run.first_joint; }
};

/// Pointers to the planes of a tile.
struct TileInputs {
  const TilePlane* positions;
  const TilePlane* normals;
  const TilePlane* tangents;
};

/// A buffer for one vector of skinned vertices. They are then copied to scattered places, or stored past the caches.
struct KeptVertices {
  HWY_ALIGN glm::vec3 positions[kTileSize];
  HWY_ALIGN glm::vec3 normals[kTileSize];
  HWY_ALIGN glm::vec4 tangents[kTileSize];

  HWY_NOINLINE void store(const TileStreams& s, const LaneVertices& at, bool has_normals, bool has_tangents) const {
    scatter(positions, at, s.past_caches, s.out.positions.data());
    if (has_normals) scatter(normals, at, s.past_caches, s.out.normals.data());
    if (has_tangents) scatter(tangents, at, s.past_caches, s.out.tangents.data());
  }
};

/// The scalar path for normals and tangents of a vector of lanes. It is needed if squares leave the range of float, the
/// side of a normal is in doubt, or a direction vanishes. The matrices have the same bits as for the positions.
HWY_NOINLINE void write_careful(const TileStreams& s, const TileRun& run, std::size_t lane_of_run, TileInputs tile,
                                bool normals, bool tangents, bool cofactor) {
  const TileTag d;
  const std::size_t lane = lane_of_run % VertexTiles::kLanes;
  const std::uint32_t* vertices = &s.tiles.vertices[std::size_t{run.first_tile} * VertexTiles::kLanes + lane_of_run];
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
                         [&](std::size_t i) { s.out.normals[vertices[i]] = careful(tile.normals, i, cofactor); });
  }
  if (tangents) {
    Lanes3 moved = transform_vectors(m, load_planes3(tile.tangents, lane));
    for_each_lane_not_in(normalise(moved), [&](std::size_t i) {
      s.out.tangents[vertices[i]] = glm::vec4(careful(tile.tangents, i, false), tile.tangents[3].lane[lane + i]);
    });
  }
}

/// Skins runs of tiles whose vertices have `kCount` joints; 0 = known at run time only.
template <int kCount, bool kNormals, bool kTangents, bool kCofactor>
struct SkinRun {
  const TileStreams& s;

  HWY_NOINLINE void operator()(const TileRun& run) const {
    const SpreadMatrices<kCount> matrices(s.palette, s.joints_of(run), run.joint_count);
    const std::size_t planes = kCount > 0 ? 2 + static_cast<std::size_t>(kCount) : run.planes_per_tile();
    const std::size_t lane_count = run.lane_count, row_lanes = lanes_in_a_row(run);
    const std::uint32_t* vertices = &s.tiles.vertices[std::size_t{run.first_tile} * VertexTiles::kLanes];
    const std::size_t direct_lanes = s.past_caches && s.is_aligned(*vertices) ? 0 : row_lanes;
    const std::uint32_t* fours = &s.tiles.fours[std::size_t{run.first_tile} * VertexTiles::kLanes / 4];
    const VertexOutput out = s.out;  // a copy, which no store can change
    const TilePlane* positions = s.tiles.positions.data() + run.first_plane;
    const TilePlane* normals = kNormals ? s.tiles.normals.data() + std::size_t{run.first_tile} * 3 : nullptr;
    const TilePlane* tangents = kTangents ? s.tiles.tangents.data() + std::size_t{run.first_tile} * 4 : nullptr;
    KeptVertices kept;
    for (std::size_t lane = 0, in_tile = 0; lane < lane_count; lane += kTileSize) {
      glm::vec3 *positions_out = kept.positions, *normals_out = kept.normals;
      glm::vec4* tangents_out = kept.tangents;
      const bool is_direct = lane < direct_lanes;
      if (HWY_LIKELY(is_direct)) {
        const std::size_t first = kTileSize == 1 ? vertices[lane] : fours[lane / 4];
        positions_out = out.positions.data() + first;
        if constexpr (kNormals) normals_out = out.normals.data() + first;
        if constexpr (kTangents) tangents_out = out.tangents.data() + first;
      }
      const bool sound = skin_lanes(matrices, positions + 3, in_tile, {positions, normals, tangents}, positions_out,
                                    normals_out, tangents_out);
      if (HWY_UNLIKELY(!is_direct))
        kept.store(s, {vertices + lane, fours + lane / 4, lane_count - lane, lane < row_lanes}, kNormals, kTangents);
      if constexpr (kNormals || kTangents)
        if (HWY_UNLIKELY(!sound))
          write_careful(s, run, lane, TileInputs{positions, normals, tangents}, kNormals, kTangents, kCofactor);
      in_tile += kTileSize;
      if (in_tile < VertexTiles::kLanes) continue;
      in_tile = 0;
      positions += planes;
      if constexpr (kNormals) normals += 3;
      if constexpr (kTangents) tangents += 4;
    }
  }

 private:
  /// Skins one vector of lanes, column by column, so that everything fits into sixteen registers. Returns true if all
  /// directions keep their digits.
  HWY_INLINE bool skin_lanes(const SpreadMatrices<kCount>& matrices, const TilePlane* weights, std::size_t lane,
                             const TileInputs& tile, glm::vec3* positions_out, [[maybe_unused]] glm::vec3* normals_out,
                             [[maybe_unused]] glm::vec4* tangents_out) const {
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
    pack(plus_product(moved_p, m.c2, p.z), positions_out);
    auto sound = hn::FirstN(TileTag(), kTileSize);
    if constexpr (kNormals) {
      moved_n = kCofactor ? moved_normals(m, n, true) : plus_product(moved_n, m.c2, n.z);
      sound = normalise(moved_n);
      pack(moved_n, normals_out);
    }
    if constexpr (kTangents) {
      moved_t = plus_product(moved_t, m.c2, t.z);
      sound = hn::And(sound, normalise(moved_t));
      pack(Lanes4{moved_t.x, moved_t.y, moved_t.z, load_plane(tile.tangents[3], lane)}, tangents_out);
    }
    return hn::AllTrue(TileTag(), sound);
  }
};

/// Calls `body` with the number of joints as a std::integral_constant; 0 stands for five joints and more.
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
  const TileStreams streams{*job.tiles, job.palette.data(), job.out, wants_streams(job)};
  const auto skin = [&](auto normals, auto tangents, auto cofactor) {
    for (const TileRun& run : job.tiles->runs)
      with_joint_count(run, [&](auto count) {
        // Few meshes have tangents but no normals, so they use the general kernel for any number of joints.
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
  if (job.tiles == nullptr || !have_memory(job.palette, job.out.positions, job.out.normals, job.out.tangents))
    return ErrorCode::size_mismatch;
  const std::size_t count = job.tiles->vertex_count;
  const bool fits = job.out.positions.size() >= count && (!job.writes_normals() || job.out.normals.size() >= count) &&
                    (!job.writes_tangents() || job.out.tangents.size() >= count);
  if (!fits) return ErrorCode::size_mismatch;
  return job.palette.size() < job.tiles->joint_count ? ErrorCode::index_out_of_range : ErrorCode::ok;
}

SINEW_DISPATCH_RUN(SkinTilesJob, skin_tiles)

}  // namespace sinew
#endif
