// SPDX-License-Identifier: MIT
#include "runtime/jobs/local_to_model.h"

#include <algorithm>
#include <cstring>
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
  RowsAt rows_at(std::size_t place) const { return {rows[0] + place, rows[1] + place, rows[2] + place}; }
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

/// Puts the matrices that the file gives verbatim in place of T * R * S (G50). A row goes in as one store: it is read back at once.
void use_fixed_matrices(const Skeleton& skeleton, std::size_t first, std::size_t count, Tile& tile) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t fixed = skeleton.fixed_matrix_of[first + i];
    if (fixed == kNone) continue;
    for (int r = 0; r < 3; ++r) std::memcpy(tile.rows[r] + Tile::place(i), &skeleton.fixed_matrices[fixed].row[r], sizeof(glm::vec4));
  }
}

/// Local matrices of the tile that begins with joint `first`.
HWY_INLINE void fill(const LocalToModelJob& job, std::size_t first, Tile& tile) {
  local_matrices(job.local, first, tile);
  const Skeleton& skeleton = *job.skeleton;
  if (!skeleton.fixed_matrices.empty()) use_fixed_matrices(skeleton, first, HWY_MIN(hn::Lanes(Floats()), skeleton.joint_count() - first), tile);
}

#if HWY_TARGET == HWY_SCALAR || HWY_MAX_BYTES < 64

struct Recent {
  explicit Recent(const LocalToModelJob&) {}
};

/// Composes joints, parents first.
class Composer {
 public:
  Composer(const LocalToModelJob& job, Recent&) : job_(job), parents_(job.skeleton->parents.data()) {}

  HWY_INLINE void compose(const RowsAt& local, std::uint32_t joint) const {
    const std::uint32_t parent = parents_[joint];
    const Rows rows = product(parent == kNone ? job_.root : job_.model[parent], local);
#if HWY_TARGET == HWY_SCALAR
    job_.model[joint] = rows;
#else
    for (int r = 0; r < 3; ++r) hn::StoreU(rows.row[r], RowTag(), &job_.model[joint].row[r].x);
#endif
  }

 private:
  const LocalToModelJob& job_;
  const std::uint32_t* parents_;
};

#else

/// The last model matrices, each on a cache line of its own: a parent that was stored a moment ago is read back from one store.
struct Recent {
  static constexpr std::uint32_t kCount = 64;
  HWY_ALIGN float rows[kCount][16];
  std::uint32_t joints[kCount];  // whose they are

  /// The root stands for the parent kNone until its place is taken.
  HWY_INLINE explicit Recent(const LocalToModelJob& job) {
    std::fill(std::begin(joints), std::end(joints), kNone);
    hn::Store(load_rows(job.root), Floats(), rows[kNone % kCount]);
  }
  HWY_INLINE bool has(std::uint32_t joint) const { return joints[joint % kCount] == joint; }
  HWY_INLINE Rows of(std::uint32_t joint) const { return hn::Load(Floats(), rows[joint % kCount]); }
  HWY_INLINE void keep(std::uint32_t joint, Rows model) {
    hn::Store(model, Floats(), rows[joint % kCount]);
    joints[joint % kCount] = joint;
  }
};

/// Composes joints, parents first. What it has in single variables stays in registers, `recent` being elsewhere.
class Composer {
 public:
  HWY_INLINE Composer(const LocalToModelJob& job, Recent& recent)
      : recent_(recent), model_(job.model.data()), parents_(job.skeleton->parents.data()), root_(load_rows(job.root)), rows_(root_) {}

  HWY_INLINE void compose(const RowsAt& local, std::uint32_t joint) {
    const std::uint32_t parent = parents_[joint];
    if (parent != last_) rows_ = HWY_LIKELY(recent_.has(parent)) ? recent_.of(parent) : far_rows(parent);
    rows_ = product(rows_, local);
    last_ = joint;
    recent_.keep(joint, rows_);
    hn::BlendedStore(rows_, hn::FirstN(Floats(), 12), Floats(), &model_[joint].row[0].x);
  }

 private:
  HWY_INLINE Rows far_rows(std::uint32_t parent) const { return parent == kNone ? root_ : load_rows(model_[parent]); }

  Recent& recent_;
  Affine* model_;
  const std::uint32_t* parents_;
  Rows root_, rows_;  // of joint last_
  std::uint32_t last_ = kNone;
};

#endif

void some_model_matrices(const LocalToModelJob& job) {
  const std::size_t lanes = hn::Lanes(Floats());
  const std::span<const std::uint32_t> only = job.only;
  Tile tile;
  Recent recent(job);
  Composer composer(job, recent);
  for (std::size_t k = 0; k < only.size();) {
    const std::size_t first = only[k] / lanes * lanes;
    fill(job, first, tile);
    for (; k < only.size() && only[k] < first + lanes; ++k) composer.compose(tile.rows_at(Tile::place(only[k] - first)), only[k]);
  }
}

/// Joints of one tile; four in a row are at one step from each other.
HWY_INLINE void compose_tile(Composer& composer, const Tile& tile, std::size_t first, std::size_t count) {
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4)
    for (std::size_t k = 0; k < 4; ++k) composer.compose(tile.rows_at(Tile::place(i) + k * hn::Lanes(Floats())), static_cast<std::uint32_t>(first + i + k));
  for (; i < count; ++i) composer.compose(tile.rows_at(Tile::place(i)), static_cast<std::uint32_t>(first + i));
}

/// Local matrices are made some tiles ahead of the joints' chains, which wait for each other's products.
void model_matrices(const LocalToModelJob& job) {
  if (!job.only.empty()) return some_model_matrices(job);
  constexpr std::size_t kAhead = 64;
  const std::size_t joints = job.skeleton->joint_count(), lanes = hn::Lanes(Floats());
  Tile tiles[kAhead / hn::MaxLanes(Floats())];
  Recent recent(job);
  Composer composer(job, recent);
  for (std::size_t begin = 0; begin < joints; begin += kAhead) {
    const std::size_t end = HWY_MIN(joints, begin + kAhead);
    for (std::size_t first = begin; first < end; first += lanes) fill(job, first, tiles[(first - begin) / lanes]);
    const Tile* tile = tiles;
    for (std::size_t first = begin; first < end; first += lanes) compose_tile(composer, *tile++, first, HWY_MIN(lanes, end - first));
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
