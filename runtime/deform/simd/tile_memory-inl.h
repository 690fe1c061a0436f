// SPDX-License-Identifier: MIT
// Inputs and outputs of a tile of vertices.
#if defined(SINEW_TILE_MEMORY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_TILE_MEMORY_INL_H_
#undef SINEW_TILE_MEMORY_INL_H_
#else
#define SINEW_TILE_MEMORY_INL_H_
#endif

#include <algorithm>
#include <bit>

#include "runtime/deform/influence_dispatch.h"
#include "runtime/deform/simd/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Influences of a tile. Each vertex starts `stride` entries after the one before: kCount, or runtime_stride if kCount
/// is 0.
template <int kCount>
struct TileInfluences {
  VertexJoints<kCount> first;
  std::size_t runtime_stride;

  HWY_INLINE VertexJoints<kCount> at(std::size_t k) const {
    const std::size_t skip = k * (kCount > 0 ? static_cast<std::size_t>(kCount) : runtime_stride);
    return {first.joints + skip, first.weights + skip, first.runtime_count};
  }

  /// Byte offset of joint `i` of vertex `k` in a palette. Wide tiles load four indices at once, because loads limit the
  /// speed of blending. A rotation then turns an index into a byte offset; a shift would need a copy of the four
  /// indices. In narrow tiles a rotation would need that copy too, so they load each index.
  template <std::size_t kEntrySize>
  HWY_INLINE std::size_t offset(std::size_t k, std::size_t i) const {
    if constexpr (!kFourAtOnce) return at(k).joints[i] * kEntrySize;
    static_assert(std::has_single_bit(kEntrySize));
    const std::size_t number = k * kCount + i, number_of_four = kCount % 4 == 0 ? i % 4 : number % 4;
    std::uint64_t four;
    hwy::CopyBytes<sizeof(four)>(first.joints + (number - number_of_four), &four);
    return std::rotr(four, static_cast<int>(16 * number_of_four) - std::countr_zero(kEntrySize)) &
           (0xffff * kEntrySize);
  }
  /// Palette entry of joint `i` of vertex `k`.
  template <class Entry>
  HWY_INLINE const Entry* entry(const Entry* palette, std::size_t k, std::size_t i) const {
    return reinterpret_cast<const Entry*>(reinterpret_cast<const char*>(palette) + offset<sizeof(Entry)>(k, i));
  }

 private:
  static constexpr bool kFourAtOnce = kCount > 0 && kTileSize > 4 && std::endian::native == std::endian::little;
};

/// Attributes of a tile, as pointers to its first vertex. A null output means that the attribute is not wanted.
template <class V3, class V4>
struct TileAttributes {
  V3* positions;
  V3* normals;
  V4* tangents;

  HWY_INLINE TileAttributes from(std::size_t vertex) const {
    return {positions + vertex, normals ? normals + vertex : nullptr, tangents ? tangents + vertex : nullptr};
  }
};
using TileInput = TileAttributes<const glm::vec3, const glm::vec4>;
using TileOutput = TileAttributes<glm::vec3, glm::vec4>;

/// Padded copies of an incomplete tile, so that SIMD code reads and writes nothing past the arrays.
struct TileCopies {
  static constexpr std::size_t kMostInfluences = 8;  ///< of a vertex whose influences are copied

  glm::vec3 positions[kTileSize], normals[kTileSize], out_positions[kTileSize], out_normals[kTileSize];
  glm::vec4 tangents[kTileSize], out_tangents[kTileSize];
  std::uint16_t joints[kTileSize * kMostInfluences];
  float weights[kTileSize * kMostInfluences];

  static bool has_room(std::size_t influence_count) { return influence_count <= kMostInfluences; }

  TileInput load(const TileInput& in, std::size_t count) {
    fill(in.positions, count, positions);
    if (in.normals) fill(in.normals, count, normals);
    if (in.tangents) fill(in.tangents, count, tangents);
    return {positions, normals, tangents};
  }
  /// Where there is no room, nothing is copied. All vertices then use the influences of the first vertex, so a tile may
  /// hold one vertex only.
  TileInfluences<0> load(const VertexJoints<0>& in, std::size_t count) {
    const std::size_t each = in.count();
    if (!has_room(each)) return {in, 0};
    for (std::size_t k = 0; k < kTileSize; ++k) {
      const std::size_t from = std::min(k, count - 1) * each;
      std::copy_n(in.joints + from, each, joints + k * each);
      std::copy_n(in.weights + from, each, weights + k * each);
    }
    return {{joints, weights, each}, each};
  }
  TileOutput in_place_of(const TileOutput& out) {
    return {out_positions, out.normals ? out_normals : nullptr, out.tangents ? out_tangents : nullptr};
  }
  void store(const TileOutput& out, std::size_t count) const {
    std::copy_n(out_positions, count, out.positions);
    if (out.normals) std::copy_n(out_normals, count, out.normals);
    if (out.tangents) std::copy_n(out_tangents, count, out.tangents);
  }

 private:
  template <class V, std::size_t kRoom>
  static void fill(const V* from, std::size_t count, V (&to)[kRoom]) {
    for (std::size_t k = 0; k < kRoom; ++k) to[k] = from[std::min(k, count - 1)];
  }
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
