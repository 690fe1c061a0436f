// SPDX-License-Identifier: MIT
#include "runtime/deform/flat_normals.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/deform/flat_normals.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <cmath>

#include "runtime/deform/simd/lane_memory-inl.h"
#include "runtime/deform/simd/triples-inl.h"
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

/// Triangles with arbitrary vertices, as lists of three indices.
struct CornerFaces {
  const std::uint32_t* indices;

  HWY_INLINE std::size_t corner(std::size_t t, std::size_t c) const { return indices[3 * t + c]; }
};

/// The scalar path. The cross product in double keeps the normal of tiny, huge and narrow triangles. Returns false if
/// the triangle has no area.
bool write_careful_normal(const FaceArrays& arrays, std::size_t a, std::size_t b, std::size_t c) {
  const Vec3<double> from(arrays.positions[a]);
  const Vec3<double> u = Vec3<double>(arrays.positions[b]) - from, v = Vec3<double>(arrays.positions[c]) - from;
  const Vec3<double> n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  if (!(length > 0.0)) return false;
  arrays.normals[a] = arrays.normals[b] = arrays.normals[c] = glm::vec3(n * (arrays.sign / length));
  return true;
}

/// Vectors from the second and third corner to the first.
struct Edges {
  Lanes3 u, v;
};

/// Pointers to the three runs of corners of a FlatStream, and to the runs of their normals.
struct FaceStream {
  const glm::vec3 *a, *b, *c;
  glm::vec3 *na, *nb, *nc;

  FaceStream(const FaceArrays& arrays, const FlatStream& stream)
      : a(arrays.positions + stream.first[0]),
        b(arrays.positions + stream.first[1]),
        c(arrays.positions + stream.first[2]),
        na(arrays.normals + stream.first[0]),
        nb(arrays.normals + stream.first[1]),
        nc(arrays.normals + stream.first[2]) {}

  HWY_INLINE Edges edges(std::size_t t) const {
    const Triples from = load_triples(a + t);
    return {lanes_of(minus(from, load_triples(b + t))), lanes_of(minus(from, load_triples(c + t)))};
  }
  HWY_INLINE void store(const Lanes3& n, std::size_t t) const {
    const Triples normals = triples_of(n);
    store_triples(normals, na + t);
    store_triples(normals, nb + t);
    store_triples(normals, nc + t);
  }
};

#if HWY_TARGET == HWY_SCALAR

Edges load_edges(const FaceArrays& arrays, const CornerFaces& faces, std::size_t t) {
  const Lanes3 a = load3(arrays.positions + faces.corner(t, 0));
  return {minus(a, load3(arrays.positions + faces.corner(t, 1))),
          minus(a, load3(arrays.positions + faces.corner(t, 2)))};
}

void store_normals(const Lanes3& n, const FaceArrays& arrays, const CornerFaces& faces, std::size_t t) {
  for (std::size_t c = 0; c < 3; ++c) store3(n, arrays.normals + faces.corner(t, c));
}

#else

using BlockTag = hn::Full128<float>;
using Block = hn::Vec<BlockTag>;

/// Joins the 128-bit blocks of a quarter tile. `block(b)` returns the block of vertex b of the quarter.
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

/// Calls `body(b, block)` for the 128-bit blocks of a quarter tile.
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

/// Corner `c` of the tile of triangles from `t` on. It reads four floats per vertex, so it must not be used for the
/// last vertex of a mesh.
HWY_INLINE Lanes3 load_corners(const FaceArrays& arrays, const CornerFaces& faces, std::size_t t, std::size_t c) {
  const auto quarter = [&](std::size_t q) HWY_ATTR {
    return join_blocks([&](std::size_t b) HWY_ATTR {
      return hn::LoadU(BlockTag(), &arrays.positions[faces.corner(t + q * kBlocks + b, c)].x);
    });
  };
  const Lanes4 all = transpose(quarter(0), quarter(1), quarter(2), quarter(3));
  return {all.x, all.y, all.z};
}

HWY_INLINE Edges load_edges(const FaceArrays& arrays, const CornerFaces& faces, std::size_t t) {
  const Lanes3 a = load_corners(arrays, faces, t, 0);
  return {minus(a, load_corners(arrays, faces, t, 1)), minus(a, load_corners(arrays, faces, t, 2))};
}

HWY_INLINE void store_normal(Block xyz, glm::vec3& to) {
  const hn::CappedTag<float, 1> one;
  const hn::CappedTag<float, 2> two;
  hn::StoreU(hn::LowerHalf(two, xyz), two, &to.x);
  hn::StoreU(hn::LowerHalf(one, hn::UpperHalf(two, xyz)), one, &to.z);
}

/// Stores normals at the corners. Addresses are read first, because compilers would reload them after every store.
HWY_INLINE void store_normals(const Lanes3& n, const FaceArrays& arrays, const CornerFaces& faces, std::size_t t) {
  const Lanes4 all = transpose(n.x, n.y, n.z, n.x);
  const Wide quarters[4] = {all.x, all.y, all.z, all.w};
  glm::vec3* const normals = arrays.normals;
  for_each_quarter([&](auto q) HWY_ATTR {
    for_each_block(quarters[q], [&](std::size_t b, Block xyzx) HWY_ATTR {
      const std::size_t at = t + q * kBlocks + b;
      glm::vec3* const to[3] = {&normals[faces.corner(at, 0)], &normals[faces.corner(at, 1)],
                                &normals[faces.corner(at, 2)]};
      for (glm::vec3* const corner : to) store_normal(xyzx, *corner);
    });
  });
}

#endif  // HWY_TARGET

/// Triangles that need the scalar path. They are collected and computed together. If each tile handled its own,
/// branches would be mispredicted and square roots would not overlap.
class CarefulList {
 public:
  CarefulList(const FaceArrays& arrays, CornerFaces corners) : arrays_(arrays), corners_(corners) {}

  HWY_INLINE void add(const FlatStream& stream, std::size_t first, hn::Mask<TileTag> unsound) {
    add({&stream, first, lanes_of(unsound)});
  }
  HWY_INLINE void add(std::size_t first, hn::Mask<TileTag> unsound) { add({nullptr, first, lanes_of(unsound)}); }
  /// Makes room for `tile_count` more tiles. If the list is full, all collected triangles are computed now, so their
  /// fast normals must already be stored.
  HWY_INLINE void make_room(std::size_t tile_count) {
    if (HWY_UNLIKELY(count_ + tile_count > kRoom)) clear();
  }
  HWY_NOINLINE void clear() {
    for (const Tile& tile : std::span(tiles_).first(count_)) {
      for (unsigned left = tile.lanes; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        if (tile.stream != nullptr)
          redo(*tile.stream, tile.first + vertex_of_triple_lane(lane));
        else
          redo(corners_, tile.first + vertex_of_quarter_lane(lane));
      }
    }
    count_ = 0;
  }

 private:
  struct Tile {
    const FlatStream* stream;  ///< null = a triangle outside of streams
    std::size_t first;         ///< index of the tile's first triangle
    std::uint16_t lanes;
  };
  static constexpr std::size_t kRoom = 64;

  static HWY_INLINE std::uint16_t lanes_of(hn::Mask<TileTag> unsound) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(TileTag(), unsound, bytes);
    return static_cast<std::uint16_t>(bytes[0] | bytes[1] << 8);
  }

  HWY_INLINE void add(const Tile& tile) {
    tiles_[count_] = tile;
    count_ += tile.lanes != 0;
  }

  void redo(const FlatStream& stream, std::size_t t) const {
    redo(stream.first[0] + t, stream.first[1] + t, stream.first[2] + t);
  }
  void redo(CornerFaces faces, std::size_t t) const {
    redo(faces.corner(t, 0), faces.corner(t, 1), faces.corner(t, 2));
  }
  void redo(std::size_t a, std::size_t b, std::size_t c) const {
    if (write_careful_normal(arrays_, a, b, c)) return;
    for (const std::size_t v : {a, b, c}) arrays_.normals[v] = arrays_.rest_normals[v];
  }

  const FaceArrays arrays_;
  const CornerFaces corners_;
  std::size_t count_ = 0;
  Tile tiles_[kRoom];
};

/// Lanes where float is accurate enough. Edges and area must be in the range in which float keeps its digits, and the
/// edges must not be nearly parallel. An area that overflows fails the test for parallel edges.
HWY_INLINE hn::Mask<TileTag> is_sound(const Lanes3& u, const Lanes3& v, Wide squared_area) {
  const TileTag d;
  const Wide uu = dot(u, u), vv = dot(v, v);
  const auto keep_digits = hn::Gt(hn::Min(hn::Min(uu, vv), squared_area), hn::Set(d, 1e-30f));
  const Wide area = hn::Min(squared_area, hn::Set(d, 1e30f));
  return hn::And(keep_digits, hn::Gt(hn::Mul(area, hn::Set(d, 64.0f)), hn::Mul(uu, vv)));
}

/// Normals of a tile, kept in memory until they are stored.
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

/// Computes the normals of the tile of triangles from `t` on. Returns the lanes that need the scalar path.
HWY_INLINE hn::Mask<TileTag> find_normals(const FaceArrays& arrays, const CornerFaces& faces, std::size_t t,
                                          KeptNormals& normals) {
  const TileTag d;
  const auto [u, v] = load_edges(arrays, faces, t);
  const Lanes3 n = cross(u, v);
  const Wide squared = dot(n, n);
  normals.keep(times(n, hn::Div(hn::Set(d, arrays.sign), hn::Sqrt(squared))));
  return hn::Not(is_sound(u, v, squared));
}

/// Computes the normals of a stream. The last tile ends with the stream, so it may compute some triangles again.
void flatten(const FaceArrays& arrays, const FlatStream& stream, CarefulList& careful) {
  const FaceStream faces(arrays, stream);
  const std::size_t count = stream.count, last = count - kTileSize;
  const Wide sign = hn::Set(TileTag(), arrays.sign);
  for (std::size_t t = 0; t < count; t += kTileSize) {
    const std::size_t first = std::min(t, last);
    careful.make_room(1);
    const auto [u, v] = faces.edges(first);
    const Lanes3 n = cross(u, v);
    const Wide squared = dot(n, n);
    faces.store(times(n, hn::Div(sign, hn::Sqrt(squared))), first);
    careful.add(stream, first, hn::Not(is_sound(u, v, squared)));
  }
}

/// Computes the normals of triangles outside of streams. They are stored a few tiles later. With many small stores,
/// processors do not look far enough ahead to overlap a square root and a division with the next tile.
void flatten(const FaceArrays& arrays, CornerFaces faces, std::size_t count, CarefulList& careful) {
  constexpr std::size_t kKept = 4;
  KeptNormals kept[kKept];
  for (std::size_t begin = 0; begin < count; begin += kKept * kTileSize) {
    const std::size_t end = std::min(count, begin + kKept * kTileSize);
    careful.make_room(kKept);
    for (std::size_t t = begin; t < end; t += kTileSize)
      careful.add(t, find_normals(arrays, faces, t, kept[(t - begin) / kTileSize]));
    for (std::size_t t = begin; t < end; t += kTileSize)
      store_normals(kept[(t - begin) / kTileSize].load(), arrays, faces, t);
  }
}

void flat_normals(const FlatNormalsJob& job) {
  const FlatFaces& faces = *job.faces;
  const FaceArrays arrays{job.positions.data(), job.rest_normals.data(), job.normals.data(), job.turned ? -1.0f : 1.0f};
  for (const std::uint32_t v : faces.at_rest) job.normals[v] = job.rest_normals[v];
  const CornerFaces corners{faces.corners.data()};
  CarefulList careful(arrays, corners);
  for (const FlatStream& stream : faces.streams) flatten(arrays, stream, careful);
  flatten(arrays, corners, faces.corners.size() / 3, careful);
  careful.clear();
  for (std::size_t i = 0; i < faces.alone.size(); i += 3)
    write_careful_normal(arrays, faces.alone[i], faces.alone[i + 1], faces.alone[i + 2]);
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
ErrorCode check(const FlatNormalsJob& job) noexcept {
  const std::size_t count = job.positions.size();
  if (job.faces == nullptr || job.rest_normals.size() != count || job.normals.size() != count)
    return ErrorCode::size_mismatch;
  if (!have_memory(job.positions, job.rest_normals, job.normals)) return ErrorCode::size_mismatch;
  const auto all_below = [](std::span<const std::uint32_t> vertices, std::size_t limit) {
    return std::all_of(vertices.begin(), vertices.end(), [limit](std::uint32_t v) { return v < limit; });
  };
  for (const FlatStream& stream : job.faces->streams)
    for (const std::uint32_t first : stream.first)
      if (std::size_t{first} + stream.count > count) return ErrorCode::index_out_of_range;
  const bool inside = all_below(job.faces->corners, count > 0 ? count - 1 : 0) && all_below(job.faces->alone, count) &&
                      all_below(job.faces->at_rest, count);
  return inside ? ErrorCode::ok : ErrorCode::index_out_of_range;
}

SINEW_DISPATCH_RUN(FlatNormalsJob, flat_normals)
}  // namespace sinew
#endif
