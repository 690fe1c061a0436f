// SPDX-License-Identifier: MIT
#include "runtime/jobs/local_to_model.h"

#include <algorithm>
#include <iterator>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/jobs/local_to_model.cpp"
#include <hwy/foreach_target.h>

#include "runtime/jobs/affine_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

/// A pose's stride is a multiple of 16 joints, so that whole vectors never reach past its planes.
using Floats = hn::CappedTag<float, 16>;
using Lanes = hn::Vec<Floats>;

/// Local matrices of one vector of joints, in the order in which transposing within blocks leaves them.
struct Tile {
  HWY_ALIGN float rows[3][16 * 4];

  static std::size_t place(std::size_t joint) {
    const std::size_t lanes = hn::Lanes(Floats());
    return lanes < 4 ? 4 * joint : joint % 4 * lanes + joint / 4 * 4;
  }
  RowsAt rows_of(std::size_t joint) const { return {rows[0] + place(joint), rows[1] + place(joint), rows[2] + place(joint)}; }
};

/// One row of every joint, from its components.
HWY_INLINE void store_row(Lanes x, Lanes y, Lanes z, Lanes w, float* row) {
  const Floats d;
#if HWY_TARGET == HWY_SCALAR
  hn::StoreInterleaved4(x, y, z, w, d, row);
#else
  const std::size_t lanes = hn::Lanes(d);
  const Lanes xz_low = hn::InterleaveLower(d, x, z), xz_high = hn::InterleaveUpper(d, x, z);
  const Lanes yw_low = hn::InterleaveLower(d, y, w), yw_high = hn::InterleaveUpper(d, y, w);
  hn::Store(hn::InterleaveLower(d, xz_low, yw_low), d, row);
  hn::Store(hn::InterleaveUpper(d, xz_low, yw_low), d, row + lanes);
  hn::Store(hn::InterleaveLower(d, xz_high, yw_high), d, row + 2 * lanes);
  hn::Store(hn::InterleaveUpper(d, xz_high, yw_high), d, row + 3 * lanes);
#endif
}

/// eq   T * R * S as affine_from_transform, one joint per lane, in single multiplications and additions (N27, N28)
HWY_INLINE void local_matrices(const PoseSpan& pose, std::size_t j, Tile& tile) {
  const Floats d;
  using P = PoseSpan;
  const Lanes x = hn::LoadU(d, pose.plane(P::rx) + j), y = hn::LoadU(d, pose.plane(P::ry) + j);
  const Lanes z = hn::LoadU(d, pose.plane(P::rz) + j), w = hn::LoadU(d, pose.plane(P::rw) + j);
  const Lanes sx = hn::LoadU(d, pose.plane(P::sx) + j), sy = hn::LoadU(d, pose.plane(P::sy) + j);
  const Lanes sz = hn::LoadU(d, pose.plane(P::sz) + j);
  const Lanes one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f);
  const Lanes xx = hn::Mul(x, x), yy = hn::Mul(y, y), zz = hn::Mul(z, z);
  const Lanes xy = hn::Mul(x, y), xz = hn::Mul(x, z), yz = hn::Mul(y, z);
  const Lanes wx = hn::Mul(w, x), wy = hn::Mul(w, y), wz = hn::Mul(w, z);
  store_row(hn::Mul(hn::Sub(one, hn::Mul(two, hn::Add(yy, zz))), sx), hn::Mul(hn::Mul(two, hn::Sub(xy, wz)), sy),
                        hn::Mul(hn::Mul(two, hn::Add(xz, wy)), sz), hn::LoadU(d, pose.plane(P::tx) + j), tile.rows[0]);
  store_row(hn::Mul(hn::Mul(two, hn::Add(xy, wz)), sx), hn::Mul(hn::Sub(one, hn::Mul(two, hn::Add(xx, zz))), sy),
                        hn::Mul(hn::Mul(two, hn::Sub(yz, wx)), sz), hn::LoadU(d, pose.plane(P::ty) + j), tile.rows[1]);
  store_row(hn::Mul(hn::Mul(two, hn::Sub(xz, wy)), sx), hn::Mul(hn::Mul(two, hn::Add(yz, wx)), sy),
                        hn::Mul(hn::Sub(one, hn::Mul(two, hn::Add(xx, yy))), sz), hn::LoadU(d, pose.plane(P::tz) + j), tile.rows[2]);
}

/// Puts the matrices that the file gives verbatim in place of T * R * S (G50).
void use_fixed_matrices(const Skeleton& skeleton, std::size_t first, std::size_t count, Tile& tile) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t fixed = skeleton.fixed_matrix_of[first + i];
    if (fixed == kNone) continue;
    for (std::size_t r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) tile.rows[r][Tile::place(i) + static_cast<std::size_t>(c)] = skeleton.fixed_matrices[fixed].row[r][c];
  }
}

#if HWY_TARGET == HWY_SCALAR || HWY_MAX_BYTES < 64

HWY_INLINE void store_rows(const Rows& rows, Affine& m) {
#if HWY_TARGET == HWY_SCALAR
  m = rows;
#else
  for (int r = 0; r < 3; ++r) hn::StoreU(rows.row[r], RowTag(), &m.row[r].x);
#endif
}

#else

/// Matrices are written in order, so that a whole vector may run over the one that comes next.
HWY_INLINE void store_rows(Rows rows, bool is_last, Affine& m) {
  const Floats d;
  if (is_last) hn::BlendedStore(rows, hn::FirstN(d, 12), d, &m.row[0].x);
  else hn::StoreU(rows, d, &m.row[0].x);
}

#endif

/// The last model matrices, each on a cache line of its own: a parent that was stored a moment ago is read back from one store.
struct Recent {
  static constexpr std::size_t kCount = 64;
  HWY_ALIGN float rows[kCount][16];
};

/// Model matrices of a tile of joints; parents come before them.
HWY_INLINE void multiply_tile(const LocalToModelJob& job, const Tile& tile, std::size_t first, std::size_t count, [[maybe_unused]] Recent& recent) {
  const std::uint32_t* parents = job.skeleton->parents.data();
#if HWY_TARGET != HWY_SCALAR && HWY_MAX_BYTES >= 64
  const Floats d;
  Rows rows = hn::Load(d, recent.rows[(first + Recent::kCount - 1) % Recent::kCount]);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t joint = first + i, parent = parents[joint];
    if (parent == kNone) rows = load_rows(job.root);
    else if (joint - parent > Recent::kCount) rows = load_rows(job.model[parent]);
    else if (joint - parent > 1) rows = hn::Load(d, recent.rows[parent % Recent::kCount]);
    rows = product(rows, tile.rows_of(i));
    hn::Store(rows, d, recent.rows[joint % Recent::kCount]);
    store_rows(rows, joint + 1 == job.model.size(), job.model[joint]);
  }
#else
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t parent = parents[first + i];
    store_rows(product(parent == kNone ? job.root : job.model[parent], tile.rows_of(i)), job.model[first + i]);
  }
#endif
}

#if HWY_TARGET != HWY_SCALAR && HWY_MAX_BYTES >= 64

/// Composes joints one at a time; a matrix that is not to be written is not touched.
class SomeJoints {
 public:
  explicit SomeJoints(const LocalToModelJob& job) : job_(job) { std::fill(std::begin(holders_), std::end(holders_), kNone); }

  /// in   next  joint that is composed after this one: only over its matrix a whole vector may run
  HWY_INLINE void compose(const Tile& tile, std::size_t i, std::uint32_t joint, std::uint32_t next) {
    const Floats d;
    const std::uint32_t parent = job_.skeleton->parents[joint];
    const std::size_t slot = parent % Recent::kCount, own = joint % Recent::kCount;
    const Rows above = parent == kNone             ? load_rows(job_.root)
                       : holders_[slot] == parent ? hn::Load(d, recent_.rows[slot])
                                                  : load_rows(job_.model[parent]);
    const Rows rows = product(above, tile.rows_of(i));
    hn::Store(rows, d, recent_.rows[own]);
    holders_[own] = joint;
    store_rows(rows, next != joint + 1, job_.model[joint]);
  }

 private:
  const LocalToModelJob& job_;
  Recent recent_;
  std::uint32_t holders_[Recent::kCount];  // the joints whose matrices are in the slots
};

#else

/// Composes joints one at a time.
class SomeJoints {
 public:
  explicit SomeJoints(const LocalToModelJob& job) : job_(job) {}

  HWY_INLINE void compose(const Tile& tile, std::size_t i, std::uint32_t joint, std::uint32_t) {
    const std::uint32_t parent = job_.skeleton->parents[joint];
    store_rows(product(parent == kNone ? job_.root : job_.model[parent], tile.rows_of(i)), job_.model[joint]);
  }

 private:
  const LocalToModelJob& job_;
};

#endif

void some_model_matrices(const LocalToModelJob& job) {
  const std::size_t joints = job.skeleton->joint_count(), lanes = hn::Lanes(Floats());
  const bool any_fixed = !job.skeleton->fixed_matrices.empty();
  const std::span<const std::uint32_t> only = job.only;
  Tile tile;
  SomeJoints some(job);
  for (std::size_t k = 0; k < only.size();) {
    const std::size_t first = only[k] / lanes * lanes;
    local_matrices(job.local, first, tile);
    if (any_fixed) use_fixed_matrices(*job.skeleton, first, HWY_MIN(lanes, joints - first), tile);
    for (; k < only.size() && only[k] < first + lanes; ++k) some.compose(tile, only[k] - first, only[k], k + 1 < only.size() ? only[k + 1] : kNone);
  }
}

void model_matrices(const LocalToModelJob& job) {
  if (!job.only.empty()) return some_model_matrices(job);
  const Skeleton& skeleton = *job.skeleton;
  const std::size_t joints = skeleton.joint_count(), lanes = hn::Lanes(Floats());
  const bool any_fixed = !skeleton.fixed_matrices.empty();
  Tile tile;
  Recent recent;
  for (std::size_t first = 0; first < joints; first += lanes) {
    const std::size_t count = HWY_MIN(lanes, joints - first);
    local_matrices(job.local, first, tile);
    if (any_fixed) use_fixed_matrices(skeleton, first, count, tile);
    multiply_tile(job, tile, first, count, recent);
  }
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {

HWY_EXPORT(model_matrices);

}  // namespace

ErrorCode check(const LocalToModelJob& job) noexcept {
  if (!job.skeleton) return ErrorCode::size_mismatch;
  const std::size_t count = job.skeleton->joint_count();
  if (job.local.joint_count < count || job.model.size() < count) return ErrorCode::size_mismatch;
  if (job.local.stride != PoseSpan::stride_for(job.local.joint_count)) return ErrorCode::size_mismatch;
  if (count > 0 && !job.local.planes) return ErrorCode::size_mismatch;
  if (!job.only.empty() && job.only.back() >= count) return ErrorCode::index_out_of_range;
  const auto* pose_begin = reinterpret_cast<const std::byte*>(job.local.planes);
  const auto* pose_end = pose_begin + PoseSpan::plane_count * job.local.stride * sizeof(float);
  const auto out = std::as_bytes(job.model);
  if (out.data() < pose_end && pose_begin < out.data() + out.size()) return ErrorCode::overlapping_buffers;
  return ErrorCode::ok;
}

void run(const LocalToModelJob& job) noexcept { HWY_DYNAMIC_DISPATCH(model_matrices)(job); }

}  // namespace sinew
#endif  // HWY_ONCE
