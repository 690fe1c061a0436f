// SPDX-License-Identifier: MIT
// The scalar path for normals and tangents of linear skinning. These functions are not inlined, and callers pass
// copies: otherwise the loops over tiles would spill their registers around the call.
#if defined(SINEW_CAREFUL_DIRECTIONS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_CAREFUL_DIRECTIONS_INL_H_
#undef SINEW_CAREFUL_DIRECTIONS_INL_H_
#else
#define SINEW_CAREFUL_DIRECTIONS_INL_H_
#endif

#include "runtime/deform/simd/blend_matrix-inl.h"
#include "runtime/deform/simd/quarter_lanes-inl.h"
#include "runtime/math/normal_transform.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// The scalar path for the normal of vertex `v` of a tile. It is needed if squares leave the range of float, the side
/// of the normal is in doubt, or the normal vanishes. The blended matrix has the same bits as for the position.
inline glm::vec3 careful_normal(const PaletteBases& palette, const TileInfluences<0>& tile, std::size_t v,
                                const glm::vec3& n, bool cofactor) {
  JointMatrix blended = palette.palette[*tile.at(v).joints];
  if (tile.first.count() > 1) {
    const MatrixVectors parts = blend_matrix_vectors(palette, tile, v);
    for (std::size_t p = 0; p < MatrixVectors::kCount; ++p)
      hn::StoreU(parts.part[p], TileTag(), &blended.column[0].x + p * kTileSize);
  }
  const Affine m = affine_from(blended);
  return cofactor ? transform_normal_outward(linear_part(m), n) : normalised_or(transform_vector(m, n), n);
}

HWY_NOINLINE inline void write_careful_normal(const PaletteBases& palette, const TileRow<0>& row, std::size_t t,
                                              std::size_t v, bool cofactor) {
  row.out(t).normals[v] = careful_normal(palette, row.joints(t), v, row.in(t).normals[v], cofactor);
}
HWY_NOINLINE inline void write_careful_tangent(const PaletteBases& palette, const TileRow<0>& row, std::size_t t,
                                               std::size_t v) {
  const glm::vec4 tangent = row.in(t).tangents[v];
  row.out(t).tangents[v] = glm::vec4(careful_normal(palette, row.joints(t), v, glm::vec3(tangent), false), tangent.w);
}

#if HWY_TARGET != HWY_SCALAR

/// The lanes of normals or tangents that keep their digits.
HWY_INLINE hn::Mask<TileTag> soundness(const KeptQuarters& kept) {
  Wide quarters[4];
  kept.load(quarters);
  return normalise(quarters);
}

/// Computes the lanes of the tiles [first, end) that are not sound by the scalar path.
/// in   normals, tangents  of these tiles; null = not wanted
HWY_NOINLINE inline void write_careful(const PaletteBases& palette, const TileRow<0>& row, std::size_t first,
                                       std::size_t end, const KeptQuarters* normals, const KeptQuarters* tangents,
                                       bool cofactor) {
  for (std::size_t t = first; t < end; ++t) {
    if (normals)
      for_each_lane_not_in(soundness(normals[t - first]), [&](std::size_t lane) {
        write_careful_normal(palette, row, t, vertex_of_quarter_lane(lane), cofactor);
      });
    if (tangents)
      for_each_lane_not_in(soundness(tangents[t - first]), [&](std::size_t lane) {
        write_careful_tangent(palette, row, t, vertex_of_quarter_lane(lane));
      });
  }
}

#endif

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
