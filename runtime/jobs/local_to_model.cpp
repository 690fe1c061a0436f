// SPDX-License-Identifier: MIT
#include "runtime/jobs/local_to_model.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/jobs/local_to_model.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

/// A pose's stride is a multiple of 16 joints, so that whole vectors never reach past its planes.
using Floats = hn::CappedTag<float, 16>;
using Lanes = hn::Vec<Floats>;

/// Local matrices of one vector of joints: row r of joint i starts at rows[r][4 * i].
struct Tile {
  HWY_ALIGN float rows[3][16 * 4];
};

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
  hn::StoreInterleaved4(hn::Mul(hn::Sub(one, hn::Mul(two, hn::Add(yy, zz))), sx), hn::Mul(hn::Mul(two, hn::Sub(xy, wz)), sy),
                        hn::Mul(hn::Mul(two, hn::Add(xz, wy)), sz), hn::LoadU(d, pose.plane(P::tx) + j), d, tile.rows[0]);
  hn::StoreInterleaved4(hn::Mul(hn::Mul(two, hn::Add(xy, wz)), sx), hn::Mul(hn::Sub(one, hn::Mul(two, hn::Add(xx, zz))), sy),
                        hn::Mul(hn::Mul(two, hn::Sub(yz, wx)), sz), hn::LoadU(d, pose.plane(P::ty) + j), d, tile.rows[1]);
  hn::StoreInterleaved4(hn::Mul(hn::Mul(two, hn::Sub(xz, wy)), sx), hn::Mul(hn::Mul(two, hn::Add(yz, wx)), sy),
                        hn::Mul(hn::Sub(one, hn::Mul(two, hn::Add(xx, yy))), sz), hn::LoadU(d, pose.plane(P::tz) + j), d, tile.rows[2]);
}

/// Puts the matrices that the file gives verbatim in place of T * R * S (G50).
void use_fixed_matrices(const Skeleton& skeleton, std::size_t first, std::size_t count, Tile& tile) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t fixed = skeleton.fixed_matrix_of[first + i];
    if (fixed == kNone) continue;
    for (std::size_t r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) tile.rows[r][4 * i + static_cast<std::size_t>(c)] = skeleton.fixed_matrices[fixed].row[r][c];
  }
}

/// eq   model = parent * local, each row summed in the order x, y, z, translation as affine.h does (N28)
HWY_INLINE void multiply(const Affine& parent, const Tile& tile, std::size_t i, Affine& model) {
#if HWY_TARGET == HWY_SCALAR
  Affine local;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) local.row[r][c] = tile.rows[r][4 * i + static_cast<std::size_t>(c)];
  model = parent * local;
#else
  const hn::FixedTag<float, 4> d;
  const auto b0 = hn::Load(d, tile.rows[0] + 4 * i), b1 = hn::Load(d, tile.rows[1] + 4 * i), b2 = hn::Load(d, tile.rows[2] + 4 * i);
  for (int r = 0; r < 3; ++r) {
    const float* a = &parent.row[r].x;
    const auto linear = hn::Add(hn::Add(hn::Mul(hn::Set(d, a[0]), b0), hn::Mul(hn::Set(d, a[1]), b1)), hn::Mul(hn::Set(d, a[2]), b2));
    const auto moved = hn::Add(linear, hn::Set(d, a[3]));
    hn::StoreU(hn::ConcatUpperLower(d, hn::OddEven(moved, linear), linear), d, &model.row[r].x);
  }
#endif
}

void model_matrices(const LocalToModelJob& job) {
  const Skeleton& skeleton = *job.skeleton;
  const std::size_t joints = skeleton.joint_count(), lanes = hn::Lanes(Floats());
  const bool any_fixed = !skeleton.fixed_matrices.empty();
  Tile tile;
  for (std::size_t first = 0; first < joints; first += lanes) {
    const std::size_t count = HWY_MIN(lanes, joints - first);
    local_matrices(job.local, first, tile);
    if (any_fixed) use_fixed_matrices(skeleton, first, count, tile);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t parent = skeleton.parents[first + i];
      multiply(parent == kNone ? job.root : job.model[parent], tile, i, job.model[first + i]);
    }
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
  const auto* pose_begin = reinterpret_cast<const std::byte*>(job.local.planes);
  const auto* pose_end = pose_begin + PoseSpan::plane_count * job.local.stride * sizeof(float);
  const auto out = std::as_bytes(job.model);
  if (out.data() < pose_end && pose_begin < out.data() + out.size()) return ErrorCode::overlapping_buffers;
  return ErrorCode::ok;
}

void run(const LocalToModelJob& job) noexcept { HWY_DYNAMIC_DISPATCH(model_matrices)(job); }

}  // namespace sinew
#endif  // HWY_ONCE
