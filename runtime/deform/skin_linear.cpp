// SPDX-License-Identifier: MIT
#include "runtime/deform/skin_linear.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/deform/skin_linear.cpp"
#include <hwy/foreach_target.h>

#include "runtime/deform/simd/blend_columns-inl.h"
#include "runtime/deform/simd/careful_directions-inl.h"
#include "runtime/deform/simd/lane_matrix-inl.h"
#include "runtime/deform/simd/lane_order-inl.h"
#include "runtime/deform/simd/rows-inl.h"
#include "runtime/deform/vertex_checks.h"
#include "runtime/pose/simd/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

/// Skins rows of tiles. Normals and tangents are normalised a few tiles later: a square root and a division take as
/// long as the rest of a tile. Processors do not look far enough ahead to overlap them with the next tile.
template <int kCount, bool kNormals, bool kTangents, bool kCofactor>
struct SkinRow {
  using Row = TileRow<kCount>;
  PaletteBases palette;

#if HWY_TARGET == HWY_SCALAR

  void operator()(const Row& row) const {
    for (std::size_t t = 0; t < row.tile_count; ++t) skin_tile(row, t);
  }

 private:
  void skin_tile(const Row& row, std::size_t t) const {
    const TileInput in = row.in(t);
    const TileOutput out = row.out(t);
    const LaneMatrix m = blend_lane_matrix(palette, row.joints(t));
    store3(transform_points(m, load3(in.positions)), out.positions);
    if constexpr (kNormals) {
      Lanes3 n = moved_normals(m, load3(in.normals), kCofactor);
      const auto sound = normalise(n);
      store3(n, out.normals);
      for_each_lane_not_in(sound, [&](std::size_t v) { careful_normal_of(row, t, v); });
    }
    if constexpr (kTangents) {
      const Lanes4 tangent = load4(in.tangents);
      Lanes3 moved = transform_vectors(m, {tangent.x, tangent.y, tangent.z});
      const auto sound = normalise(moved);
      store4({moved.x, moved.y, moved.z, tangent.w}, out.tangents);
      for_each_lane_not_in(sound, [&](std::size_t v) { careful_tangent_of(row, t, v); });
    }
  }

#else

  HWY_INLINE void operator()(const Row& row) const {
    for (std::size_t t = 0; t < row.tile_count;) {
      const std::size_t begin = t;
      if constexpr (kCount == 1) {
        if (begins_run(row, t)) {
          t = end_of_run(row, t);
          follow_one_joint(Row(row), begin, t);
          continue;
        }
      }
      t = end_of_others(row, t);
      skin_tiles(row, begin, t);
    }
  }

 private:
  static constexpr std::size_t kKept =
      kTangents ? 2 : 8;  ///< tiles per batch; fewer with tangents, since stores then alternate between more arrays

  /// Consecutive vertices with one and the same joint are moved by its matrix directly. Shorter runs do not pay for
  /// twelve broadcasts and a mispredicted branch. The importer orders such vertices one after another.
  static constexpr std::size_t kMinFollowers = 16;

  /// True if the row may use kernels with one vertex per lane. These have no non-temporal stores for tangents, and with
  /// four lanes none for any attribute.
  static HWY_INLINE bool may_run_in_lanes(const Row& row) { return (kInTriples && !kTangents) || !row.past_caches; }

  static HWY_INLINE bool have_one_joint(const std::uint16_t* joints, std::size_t count) {
    const hn::CappedTag<std::uint16_t, kTileSize> d;
    auto same = hn::Eq(hn::LoadU(d, joints), hn::Set(d, *joints));
    for (std::size_t v = kTileSize; v < count; v += kTileSize)
      same = hn::And(same, hn::Eq(hn::LoadU(d, joints + v), hn::Set(d, *joints)));
    return hn::AllTrue(d, same);
  }
  static HWY_INLINE bool begins_run(const Row& row, std::size_t t) {
    constexpr bool kPays =
        kCount == 1 && (kTileSize > 4 || kNormals);  // four lanes without normals: 19 instructions instead of 17
    if (!kPays || !may_run_in_lanes(row) || row.tile_count - t < kMinFollowers / kTileSize) return false;
    const std::uint16_t* joints = row.joints(t).first.joints;
    return joints[0] == joints[kMinFollowers - 1] && have_one_joint(joints, kMinFollowers);
  }
  /// Index after the last consecutive tile, from `t` on, that follows the single joint of the first tile.
  static HWY_INLINE std::size_t end_of_run(const Row& row, std::size_t t) {
    const std::uint16_t joint = *row.joints(t).first.joints;
    for (t += kMinFollowers / kTileSize; t < row.tile_count; ++t) {
      const std::uint16_t* joints = row.joints(t).first.joints;
      if (*joints != joint || !have_one_joint(joints, kTileSize)) break;
    }
    return t;
  }
  /// Index after the last consecutive tile, from `t` on, that begins no run. At least t + 1, at most t + kKept.
  static HWY_INLINE std::size_t end_of_others(const Row& row, std::size_t t) {
    const std::size_t most = std::min(row.tile_count, t + kKept);
    for (++t; t < most && !begins_run(row, t);) ++t;
    return t;
  }

  HWY_NOINLINE void follow_one_joint(const Row& row, std::size_t begin, std::size_t end) const {
    const LaneMatrix m = lane_matrix(palette.palette[*row.joints(begin).first.joints]);
    for (std::size_t t = begin; t < end; ++t) {
      const std::size_t v = t * kTileSize;
      const Lanes3 p = load_ordered(row.all_in.positions + v);
      store_ordered(transform_points(m, p), row.all_out.positions + v, row.past_caches);
      if constexpr (kNormals) {
        Lanes3 n = moved_normals(m, load_ordered(row.normals_in(t)), kCofactor);
        const auto sound = normalise(n);
        store_ordered(n, row.normals_out(t), row.past_caches);
        for_each_lane_not_in(sound, [&](std::size_t lane) { careful_normal_of(row, t, vertex_of_ordered_lane(lane)); });
      }
      if constexpr (kTangents) {
        const Lanes4 tangent = load4(row.tangents_in(t));
        Lanes3 moved = transform_vectors(m, {tangent.x, tangent.y, tangent.z});
        const auto sound = normalise(moved);
        store4({moved.x, moved.y, moved.z, tangent.w}, row.tangents_out(t));
        for_each_lane_not_in(sound, [&](std::size_t lane) { careful_tangent_of(row, t, vertex_of_lane(lane)); });
      }
    }
  }

  HWY_INLINE void skin_tiles(const Row& row, std::size_t first, std::size_t end) const {
    KeptQuarters normals[kNormals ? kKept : 1], tangents[kTangents ? kKept : 1];
    for (std::size_t t = first; t < end; ++t)
      move(row, t, normals[kNormals ? t - first : 0], tangents[kTangents ? t - first : 0]);
    auto sound = hn::FirstN(TileTag(), kTileSize);
    for (std::size_t t = first; t < end; ++t) {
      if constexpr (kNormals) sound = hn::And(sound, write_normals(normals[t - first], row, t));
      if constexpr (kTangents) sound = hn::And(sound, write_tangents(tangents[t - first], row, t));
    }
    if (HWY_UNLIKELY(!hn::AllTrue(TileTag(), sound)))
      write_careful(PaletteBases(palette), row.template with_count<0>(), first, end, kNormals ? normals : nullptr,
                    kTangents ? tangents : nullptr, kCofactor);
  }

  HWY_INLINE void move(const Row& row, std::size_t t, KeptQuarters& normals, KeptQuarters& tangents) const {
    const TileInfluences<kCount> joints = row.joints(t);
    Wide positions[4];
    for_each_quarter([&](auto q) HWY_ATTR {
      const Columns m = blend_columns(palette, joints, q);
      positions[q] = transform_points(m, load_spread<q>(row.all_in.positions + t * kTileSize));
      if constexpr (kNormals) normals.keep(q, moved_normals(m, load_spread<q>(row.normals_in(t)), kCofactor));
      if constexpr (kTangents)
        tangents.keep(q, transform_vectors(m, spread(hn::LoadU(TileTag(), &row.tangents_in(t)[q * kBlocks].x))));
    });
    store_packed(positions, row.all_out.positions + t * kTileSize, row.past_caches);
  }

  HWY_INLINE hn::Mask<TileTag> write_normals(const KeptQuarters& kept, const Row& row, std::size_t t) const {
    Wide normals[4];
    kept.load(normals);
    const auto sound = normalise(normals);
    store_packed(normals, row.normals_out(t), row.past_caches);
    return sound;
  }

  HWY_INLINE hn::Mask<TileTag> write_tangents(const KeptQuarters& kept, const Row& row, std::size_t t) const {
    const TileTag d;
    static constexpr LaneTable kHandedness([](std::size_t i) { return i % 4 == 3 ? -1 : 0; });
    const auto handedness = hn::MaskFromVec(hn::BitCast(d, hn::Load(hn::RebindToSigned<TileTag>(), kHandedness.lanes)));
    Wide tangents[4];
    kept.load(tangents);
    const auto sound = normalise(tangents);
    for_each_quarter([&](auto q) HWY_ATTR {
      const Wide source = hn::LoadU(d, &row.tangents_in(t)[q * kBlocks].x);
      const Wide tangent = hn::IfThenElse(handedness, source, tangents[q]);
      float* to = &row.tangents_out(t)[q * kBlocks].x;
      if (row.past_caches)
        hn::Stream(tangent, d, to);
      else
        hn::StoreU(tangent, d, to);
    });
    return sound;
  }

#endif

  HWY_NOINLINE void careful_normal_of(const Row& row, std::size_t t, std::size_t v) const {
    write_careful_normal(PaletteBases(palette), row.template with_count<0>(), t, v, kCofactor);
  }
  HWY_NOINLINE void careful_tangent_of(const Row& row, std::size_t t, std::size_t v) const {
    write_careful_tangent(PaletteBases(palette), row.template with_count<0>(), t, v);
  }
};

void skin_linear(const SkinLinearJob& job) {
  const AttributesPresent wanted = present(job.vertices, job.out);
  const NonTemporalStores streamed(job.out, wanted, job.past_caches);
  const auto skin = [&](auto normals, auto tangents, auto cofactor) {
    for_each_group(job.influences, [&](const InfluenceGroup& group, auto each_count) {
      constexpr int kEach = each_count;
      constexpr bool kRare = cofactor || (tangents && !normals);
      constexpr int kCount = kKernelCount<kEach, kRare>;
      for_each_row<kCount>(job.influences, group, job.vertices, job.out,
                           SkinRow<kCount, normals, tangents, cofactor>{PaletteBases(job.palette.data())}, streamed);
    });
  };
  with_attributes(wanted, [&](auto normals, auto tangents) {
    if (normals && job.normal_rule == NormalRule::cofactor)
      skin(normals, tangents, normals);
    else
      skin(normals, tangents, std::false_type{});
  });
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
ErrorCode check(const SkinLinearJob& job) noexcept {
  if (!have_memory(job.palette)) return ErrorCode::size_mismatch;
  return check_skinning(job.influences, job.vertices, job.out, job.palette.size());
}

namespace {
HWY_EXPORT(skin_linear);
}

void skin_linear_groups(const SkinLinearJob& job) noexcept { HWY_DYNAMIC_DISPATCH(skin_linear)(job); }

void run_unchecked(const SkinLinearJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  skin_linear_groups(job);
}

}  // namespace sinew
#endif
