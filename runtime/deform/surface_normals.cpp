// SPDX-License-Identifier: MIT
#include "runtime/deform/surface_normals.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/deform/surface_normals.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>

#include "runtime/deform/simd/lane_memory-inl.h"
#include "runtime/math/quaternion.h"
#include "runtime/pose/simd/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

// A vector is a block of four floats, (x y z -).
#if HWY_TARGET == HWY_SCALAR

using Block = glm::vec4;
Block load_vector(const glm::vec3* p) { return glm::vec4(*p, 0.0f); }
Block load_last_vector(const glm::vec3* p) { return load_vector(p); }
Block load_sum(const glm::vec4* p) { return *p; }
void store_sum(const Block& a, glm::vec4* to) { *to = a; }
Block plus(const Block& a, const Block& b) { return a + b; }
Block minus(const Block& a, const Block& b) { return a - b; }
Block rotated(const Block& a) { return glm::vec4(a.y, a.z, a.x, a.w); }
/// eq   a b - c e
Block difference(const Block& a, const Block& b, const Block& c, const Block& e) { return a * b - c * e; }

#else

using BlockTag = hn::Full128<float>;
using Block = hn::Vec<BlockTag>;

/// Reads four floats, one more than the vector has.
HWY_INLINE Block load_vector(const glm::vec3* p) { return hn::LoadU(BlockTag(), &p->x); }
/// Reads only three floats, for the last vertex of a mesh.
HWY_INLINE Block load_last_vector(const glm::vec3* p) {
  HWY_ALIGN const float lanes[4] = {p->x, p->y, p->z, 0.0f};
  return hn::Load(BlockTag(), lanes);
}
HWY_INLINE Block load_sum(const glm::vec4* p) { return hn::LoadU(BlockTag(), &p->x); }
HWY_INLINE void store_sum(Block a, glm::vec4* to) { hn::StoreU(a, BlockTag(), &to->x); }
HWY_INLINE Block plus(Block a, Block b) { return hn::Add(a, b); }
HWY_INLINE Block minus(Block a, Block b) { return hn::Sub(a, b); }
/// (x y z -) to (y z x -)
HWY_INLINE Block rotated(Block a) {
  const hn::Repartition<std::uint8_t, BlockTag> bytes;
  HWY_ALIGN static constexpr std::uint8_t kFrom[16] = {4, 5, 6, 7, 8, 9, 10, 11, 0, 1, 2, 3, 12, 13, 14, 15};
  return hn::BitCast(BlockTag(), hn::TableLookupBytes(hn::BitCast(bytes, a), hn::Load(bytes, kFrom)));
}
/// eq   a b - c e
HWY_INLINE Block difference(Block a, Block b, Block c, Block e) { return hn::NegMulAdd(c, e, hn::Mul(a, b)); }

#endif

/// eq   u x v, with its components in the order (z x y -)
HWY_INLINE Block rotated_cross(const Block& u, const Block& v) { return difference(u, rotated(v), rotated(u), v); }

/// Adds the cross products of triangles to the sums of their points.
class TriangleSums {
 public:
  explicit TriangleSums(const SurfaceNormalsJob& job)
      : corners_(job.faces->corners.data()),
        point_of_(job.faces->point_of_vertex.data()),
        positions_(job.positions.data()),
        last_(job.positions.size() - 1),
        sums_(job.sums.data()) {}

  HWY_INLINE void add(std::size_t triangle) const {
    const std::uint32_t* const corners = corners_ + 3 * triangle;
    const Block a = vertex(corners[0]);
    const Block n = rotated_cross(minus(vertex(corners[1]), a), minus(vertex(corners[2]), a));
    for (std::size_t k = 0; k < 3; ++k) {
      glm::vec4* const sum = sums_ + point_of_[corners[k]];
      store_sum(plus(load_sum(sum), n), sum);
    }
  }

 private:
  HWY_INLINE Block vertex(std::uint32_t v) const {
    return HWY_LIKELY(v != last_) ? load_vector(positions_ + v) : load_last_vector(positions_ + v);
  }

  const std::uint32_t *corners_, *point_of_;
  const glm::vec3* positions_;
  std::size_t last_;
  glm::vec4* sums_;
};

/// Adds the triangles of all faces. Neighbouring triangles share points, so each sum would wait for the previous sum.
/// The list is therefore cut into four parts, and triangles are taken from each part in turn.
void add_triangles(const SurfaceNormalsJob& job) {
  const std::size_t count = job.faces->count(), part = count / 4;
  if (count == 0) return;
  const TriangleSums sums(job);
  for (std::size_t t = 0; t < part; ++t)
    for (std::size_t k = 0; k < 4; ++k) sums.add(t + k * part);
  for (std::size_t t = 4 * part; t < count; ++t) sums.add(t);
}

/// Normalises a rotated sum in double; zero if the point has no area.
glm::vec4 careful_normal(const glm::vec4& rotated_sum, float sign) {
  const Vec3<double> n = normalised_or(Vec3<double>(rotated_sum.y, rotated_sum.z, rotated_sum.x), Vec3<double>(0.0));
  return glm::vec4(glm::vec3(static_cast<double>(sign) * n), 0.0f);
}

/// Normalises a tile of sums in place, to (x y z -); zero for points without area.
void normalise_tile(glm::vec4* tile, float sign) {
  const TileTag d;
  const Lanes4 sums = load4(tile);
  const Lanes3 n{sums.y, sums.z, sums.x};
  const Wide squared = dot(n, n);
  const Lanes3 unit = times(n, hn::Div(hn::Set(d, sign), hn::Sqrt(squared)));
  const auto is_sound = keeps_digits(squared);
  if (HWY_LIKELY(hn::AllTrue(d, is_sound))) return store4({unit.x, unit.y, unit.z, hn::Zero(d)}, tile);
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, is_sound, bits);
  glm::vec4 careful[kTileSize];
  for (std::size_t i = 0; i < kTileSize; ++i) careful[i] = careful_normal(tile[i], sign);
  store4({unit.x, unit.y, unit.z, hn::Zero(d)}, tile);
  for (std::size_t lane = 0; lane < kTileSize; ++lane)
    if ((bits[lane / 8] >> lane % 8 & 1) == 0) tile[vertex_of_lane(lane)] = careful[vertex_of_lane(lane)];
}

void surface_normals(const SurfaceNormalsJob& job) {
  std::fill(job.sums.begin(), job.sums.end(), glm::vec4(0.0f));
  add_triangles(job);
  const std::size_t count = job.faces->point_count;
  for (std::size_t p = 0; p < count; p += kTileSize) normalise_tile(&job.sums[p], job.turned ? -1.0f : 1.0f);
  for (std::size_t v = 0; v < job.normals.size(); ++v) {
    const glm::vec3 n(job.sums[job.faces->point_of_vertex[v]]);
    job.normals[v] = n != glm::vec3(0.0f) ? n : job.rest_normals[v];
  }
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
ErrorCode check(const SurfaceNormalsJob& job) noexcept {
  const std::size_t count = job.positions.size();
  if (job.faces == nullptr || job.faces->point_of_vertex.size() != count) return ErrorCode::size_mismatch;
  if (job.rest_normals.size() != count || job.normals.size() != count || job.sums.size() < surface_sums(*job.faces))
    return ErrorCode::size_mismatch;
  if (!have_memory(job.positions, job.rest_normals, job.sums, job.normals)) return ErrorCode::size_mismatch;
  return check_indices(*job.faces, count);
}

SINEW_DISPATCH_RUN(SurfaceNormalsJob, surface_normals)
}  // namespace sinew
#endif
