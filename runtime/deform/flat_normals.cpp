// SPDX-License-Identifier: MIT
#include "runtime/deform/flat_normals.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/deform/flat_normals.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <cmath>

#include "runtime/deform/simd/lane_memory-inl.h"
#include "runtime/pose/simd/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

struct FaceArrays {
  const glm::vec3* positions;
  const glm::vec3* rest_normals;
  glm::vec3* normals;
  float sign;
};

/// Triangles from one on: three vertices in a row from `indices[t]` on, or any three.
template <bool kRun>
struct Faces {
  const std::uint32_t* indices;

  HWY_INLINE std::size_t corner(std::size_t t, std::size_t c) const {
    return kRun ? std::size_t{indices[t]} + c : indices[3 * t + c];
  }
  HWY_INLINE Faces from(std::size_t t) const { return {indices + t * (kRun ? 1 : 3)}; }
};

/// The cross product in double, so that neither tiny, huge nor narrow triangles lose their normal. False without area.
bool write_careful_normal(const FaceArrays& arrays, std::size_t a, std::size_t b, std::size_t c) {
  const Vec3<double> from(arrays.positions[a]);
  const Vec3<double> u = Vec3<double>(arrays.positions[b]) - from, v = Vec3<double>(arrays.positions[c]) - from;
  const Vec3<double> n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  if (!(length > 0.0)) return false;
  arrays.normals[a] = arrays.normals[b] = arrays.normals[c] = glm::vec3(n * (arrays.sign / length));
  return true;
}

#if HWY_TARGET == HWY_SCALAR

template <bool kRun>
Lanes3 load_corners(const FaceArrays& arrays, Faces<kRun> faces, std::size_t c) {
  return load3(arrays.positions + faces.corner(0, c));
}

template <bool kRun>
void store_normals(const Lanes3& n, const FaceArrays& arrays, Faces<kRun> faces) {
  for (std::size_t c = 0; c < 3; ++c) store3(n, arrays.normals + faces.corner(0, c));
}

#else

using BlockTag = hn::Full128<float>;
using Block = hn::Vec<BlockTag>;

/// Joins the vectors of a quarter tile, `block(b)` for its vertex b.
template <class Load>
HWY_INLINE Wide join_blocks(const Load& block) {
#if HWY_MAX_BYTES >= 64
  const hn::Half<TileTag> half;
  return hn::Combine(TileTag(), hn::Combine(half, block(3), block(2)), hn::Combine(half, block(1), block(0)));
#elif HWY_MAX_BYTES >= 32
  return hn::Combine(TileTag(), block(1), block(0));
#else
  return block(0);
#endif
}

/// Calls `body(b, block)` for the blocks of a quarter tile.
template <class Body>
HWY_INLINE void for_each_block(Wide quarter, const Body& body) {
#if HWY_MAX_BYTES >= 64
  const auto low = hn::LowerHalf(quarter), high = hn::UpperHalf(hn::Half<TileTag>(), quarter);
  body(0, hn::LowerHalf(low));
  body(1, hn::UpperHalf(BlockTag(), low));
  body(2, hn::LowerHalf(high));
  body(3, hn::UpperHalf(BlockTag(), high));
#elif HWY_MAX_BYTES >= 32
  body(0, hn::LowerHalf(quarter));
  body(1, hn::UpperHalf(BlockTag(), quarter));
#else
  body(0, quarter);
#endif
}

/// Calls `body(b, store, first)` for the blocks of two quarters: `store(to)` writes a block of the first, then one of
/// the second.
template <class Body>
HWY_INLINE void for_each_block_pair(Wide firsts, Wide seconds, const Body& body) {
#if HWY_MAX_BYTES >= 32
  const hn::CappedTag<float, 8> pair;
  const auto do_half = [&](std::size_t b, hn::Vec<decltype(pair)> first, hn::Vec<decltype(pair)> second) HWY_ATTR {
    const auto low = hn::ConcatLowerLower(pair, second, first), high = hn::ConcatUpperUpper(pair, second, first);
    body(
        b, [&](float* to) HWY_ATTR { hn::StoreU(low, pair, to); }, hn::LowerHalf(low));
    body(
        b + 1, [&](float* to) HWY_ATTR { hn::StoreU(high, pair, to); }, hn::LowerHalf(high));
  };
#if HWY_MAX_BYTES >= 64
  do_half(0, hn::LowerHalf(firsts), hn::LowerHalf(seconds));
  do_half(2, hn::UpperHalf(pair, firsts), hn::UpperHalf(pair, seconds));
#else
  do_half(0, firsts, seconds);
#endif
#else
  const auto store = [&](float* to) HWY_ATTR {
    hn::StoreU(firsts, TileTag(), to);
    hn::StoreU(seconds, TileTag(), to + kTileSize);
  };
  body(0, store, firsts);
#endif
}

/// Corner `c` of a tile of triangles. Reads four floats of each, so never of the last vertex of a mesh.
template <bool kRun>
HWY_INLINE Lanes3 load_corners(const FaceArrays& arrays, Faces<kRun> faces, std::size_t c) {
  const auto quarter = [&](std::size_t q) HWY_ATTR {
    return join_blocks([&](std::size_t b) HWY_ATTR {
      return hn::LoadU(BlockTag(), &arrays.positions[faces.corner(q * kBlocks + b, c)].x);
    });
  };
  const Lanes4 all = transpose(quarter(0), quarter(1), quarter(2), quarter(3));
  return {all.x, all.y, all.z};
}

/// (x y z x) to (y z x y) in each block.
HWY_INLINE Wide rotated(Wide quarter) {
  const hn::Repartition<std::uint8_t, TileTag> bytes;
  struct Table {
    HWY_ALIGN std::uint8_t of[4 * kTileSize];
    constexpr Table() : of() {
      for (std::size_t i = 0; i < 4 * kTileSize; ++i)
        of[i] = static_cast<std::uint8_t>((i % 16 / 4 + 1) % 3 * 4 + i % 4);
    }
  };
  static constexpr Table kTable;
  return hn::BitCast(TileTag(), hn::TableLookupBytes(hn::BitCast(bytes, quarter), hn::Load(bytes, kTable.of)));
}

using Pair = hn::Vec<hn::CappedTag<float, 2> >;
HWY_INLINE Pair low_pair(Block xyzx) { return hn::LowerHalf(hn::CappedTag<float, 2>(), xyzx); }
HWY_INLINE void store_third(Block xyzx, glm::vec3& to) {
  const hn::CappedTag<float, 1> one;
  hn::StoreU(hn::LowerHalf(one, hn::UpperHalf(hn::CappedTag<float, 2>(), xyzx)), one, &to.z);
}

/// Writes each normal to the three vertices of its triangle, in few stores, which take most of the time. Where they go
/// is read first: compilers would read it again after every store.
template <bool kRun>
HWY_INLINE void store_normals(const Lanes3& n, const FaceArrays& arrays, Faces<kRun> faces) {
  const Lanes4 all = transpose(n.x, n.y, n.z, n.x);
  const Wide quarters[4] = {all.x, all.y, all.z, all.w};
  glm::vec3* const normals = arrays.normals;
  for_each_quarter([&](auto q) HWY_ATTR {
    if constexpr (kRun) {
      for_each_block_pair(quarters[q], rotated(quarters[q]), [&](std::size_t b, auto store_pair, Block xyzx) HWY_ATTR {
        glm::vec3* const to = &normals[faces.corner(q * kBlocks + b, 0)];
        store_pair(&to->x);
        store_third(xyzx, to[2]);
      });
    } else {
      for_each_block(quarters[q], [&](std::size_t b, Block xyzx) HWY_ATTR {
        const std::size_t t = q * kBlocks + b;
        glm::vec3* const to[3] = {&normals[faces.corner(t, 0)], &normals[faces.corner(t, 1)],
                                  &normals[faces.corner(t, 2)]};
        for (glm::vec3* const corner : to) {
          hn::StoreU(low_pair(xyzx), hn::CappedTag<float, 2>(), &corner->x);
          store_third(xyzx, *corner);
        }
      });
    }
  });
}

#endif  // HWY_TARGET

/// Triangles that are left to the careful path. They are done together: branches of a tile on its own would be
/// mispredicted, and their square roots would not overlap.
template <bool kRun>
class CarefulList {
 public:
  CarefulList(const FaceArrays& arrays, Faces<kRun> faces, std::size_t count)
      : arrays_(arrays), faces_(faces), face_count_(count) {}

  /// `first` is the number of the tile's first triangle.
  HWY_INLINE void add(std::size_t first, hn::Mask<TileTag> unsound) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(TileTag(), unsound, bytes);
    const auto lanes = static_cast<std::uint16_t>(bytes[0] | bytes[1] << 8);
    tiles_[count_] = {first, lanes};
    count_ += lanes != 0;
  }
  /// Room for so many tiles; what they wrote before must be complete.
  HWY_INLINE void make_room(std::size_t tile_count) {
    if (HWY_UNLIKELY(count_ + tile_count > kRoom)) clear();
  }
  HWY_NOINLINE void clear() {
    for (std::size_t i = 0; i < count_; ++i)
      for (unsigned left = tiles_[i].lanes; left != 0; left &= left - 1) {
        const std::size_t face =
            tiles_[i].first + vertex_of_quarter_lane(static_cast<std::size_t>(std::countr_zero(left)));
        if (face < face_count_) redo(face);
      }
    count_ = 0;
  }

 private:
  struct Tile {
    std::size_t first;
    std::uint16_t lanes;
  };
  static constexpr std::size_t kRoom = 64;

  void redo(std::size_t t) const {
    const std::size_t corners[3] = {faces_.corner(t, 0), faces_.corner(t, 1), faces_.corner(t, 2)};
    if (write_careful_normal(arrays_, corners[0], corners[1], corners[2])) return;
    for (const std::size_t v : corners) arrays_.normals[v] = arrays_.rest_normals[v];
  }

  const FaceArrays arrays_;
  const Faces<kRun> faces_;
  const std::size_t face_count_;
  std::size_t count_ = 0;
  Tile tiles_[kRoom];
};

/// Lanes where float is exact enough: both edges and the area keep their digits, and the edges are not nearly parallel.
HWY_INLINE hn::Mask<TileTag> is_sound(const Lanes3& u, const Lanes3& v, Wide squared_area) {
  const TileTag d;
  const Wide uu = dot(u, u), vv = dot(v, v);
  const auto has_edges = hn::Gt(hn::Min(uu, vv), hn::Set(d, 1e-30f));
  const auto is_wide = hn::Gt(hn::Mul(squared_area, hn::Set(d, 64.0f)), hn::Mul(uu, vv));
  return hn::And(keeps_digits(squared_area), hn::And(has_edges, is_wide));
}

/// Normals of a tile, kept in memory for later.
struct KeptNormals {
  HWY_ALIGN float x[kTileSize], y[kTileSize], z[kTileSize];

  HWY_INLINE void keep(const Lanes3& n) {
    const TileTag d;
    hn::Store(n.x, d, x);
    hn::Store(n.y, d, y);
    hn::Store(n.z, d, z);
  }
  HWY_INLINE Lanes3 load() const {
    const TileTag d;
    return {hn::Load(d, x), hn::Load(d, y), hn::Load(d, z)};
  }
};

/// Normals of a tile of triangles. Returns the lanes that are left to the careful path.
template <bool kRun>
HWY_INLINE hn::Mask<TileTag> find_normals(const FaceArrays& arrays, Faces<kRun> faces, KeptNormals& normals) {
  const TileTag d;
  const Lanes3 a = load_corners(arrays, faces, 0);
  const Lanes3 u = minus(load_corners(arrays, faces, 1), a), v = minus(load_corners(arrays, faces, 2), a);
  const Lanes3 n = cross(u, v);
  const Wide squared = dot(n, n);
  normals.keep(times(n, hn::Div(hn::Set(d, arrays.sign), hn::Sqrt(squared))));
  return hn::Not(is_sound(u, v, squared));
}

/// Up to one tile of triangles, through copies: nothing past the vertices is read or written.
template <bool kRun>
hn::Mask<TileTag> flatten_last(const FaceArrays& arrays, Faces<kRun> faces, std::size_t count) {
  glm::vec3 positions[3 * kTileSize + 1], normals[3 * kTileSize];
  std::uint32_t own[kTileSize];
  for (std::size_t t = 0; t < kTileSize; ++t) {
    own[t] = static_cast<std::uint32_t>(3 * t);
    for (std::size_t c = 0; c < 3; ++c)
      positions[3 * t + c] = arrays.positions[faces.corner(std::min(t, count - 1), c)];
  }
  const FaceArrays copies{positions, nullptr, normals, arrays.sign};
  KeptNormals kept;
  const auto unsound = find_normals(copies, Faces<true>{own}, kept);
  store_normals(kept.load(), copies, Faces<true>{own});
  for (std::size_t t = 0; t < count; ++t)
    for (std::size_t c = 0; c < 3; ++c) arrays.normals[faces.corner(t, c)] = normals[3 * t + c];
  return unsound;
}

/// All triangles of a list. Normals are stored some tiles after they were found: processors do not look far enough
/// ahead to overlap a square root and a division with the next tile.
template <bool kRun>
void flatten(const FaceArrays& arrays, std::span<const std::uint32_t> indices) {
  constexpr std::size_t kKept = 4;
  const Faces<kRun> faces{indices.data()};
  const std::size_t count = indices.size() / (kRun ? 1 : 3);
  if (count == 0) return;
  CarefulList<kRun> careful(arrays, faces, count);
  KeptNormals kept[kKept];
  const std::size_t last = (count - 1) / kTileSize;
  for (std::size_t first = 0; first < last; first += kKept) {
    const std::size_t end = std::min(last, first + kKept);
    careful.make_room(kKept);
    for (std::size_t t = first; t < end; ++t)
      careful.add(t * kTileSize, find_normals(arrays, faces.from(t * kTileSize), kept[t - first]));
    for (std::size_t t = first; t < end; ++t) store_normals(kept[t - first].load(), arrays, faces.from(t * kTileSize));
  }
  careful.make_room(1);
  careful.add(last * kTileSize, flatten_last(arrays, faces.from(last * kTileSize), count - last * kTileSize));
  careful.clear();
}

void flat_normals(const FlatNormalsJob& job) {
  const FlatFaces& faces = *job.faces;
  const FaceArrays arrays{job.positions.data(), job.rest_normals.data(), job.normals.data(), job.turned ? -1.0f : 1.0f};
  if (faces.share_vertices) {
    std::copy(job.rest_normals.begin(), job.rest_normals.end(), job.normals.begin());
    for (std::size_t i = 0; i < faces.corners.size(); i += 3)
      write_careful_normal(arrays, faces.corners[i], faces.corners[i + 1], faces.corners[i + 2]);
    return;
  }
  for (const std::uint32_t v : faces.faceless) job.normals[v] = job.rest_normals[v];
  flatten<true>(arrays, faces.runs);
  flatten<false>(arrays, faces.corners);
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
SINEW_DISPATCH_RUN(FlatNormalsJob, flat_normals)
}  // namespace sinew
#endif
