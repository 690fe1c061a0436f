// SPDX-License-Identifier: MIT
#include "runtime/pose/mirror_pose.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/pose/mirror_pose.cpp"
#include <hwy/foreach_target.h>

#include "runtime/pose/simd/dispatch.h"
#include "runtime/pose/simd/pose_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

/// Copies every float from its source, negated if the highest bit of its index is set.
HWY_INLINE void copy_all(const MirrorPoseJob& job) {
  const Floats d;
  const Indices of_index;
  const Lanes sign_bit = hn::Set(d, -0.0f);
  const std::size_t count = job.tables->copies.size();
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const IndexLanes from = load_indices(job.tables->copies, i);
    const Lanes sign = hn::And(hn::BitCast(d, from), sign_bit);
    const IndexLanes at = hn::And(from, hn::Set(of_index, 0x7fffffff));
    hn::StoreU(hn::Xor(hn::GatherIndex(d, job.pose.planes, at), sign), d, job.mirrored.planes + i);
  }
}

/// The sum of a row's products. Separate multiplications and additions: all targets give the same bits.
template <std::size_t kCount>
HWY_INLINE Lanes row_sum(const float* factors, std::size_t plane, const Lanes (&in)[kCount]) {
  const Floats d;
  Lanes sum = hn::Mul(hn::LoadU(d, factors), in[0]);
  for (std::size_t i = 1; i < kCount; ++i) sum = add_product(sum, in[i], hn::LoadU(d, factors + i * plane));
  return sum;
}

/// Recomputes `kCount` planes, starting at `first`, for the joints that need sums of products.
/// in   finish(out)  postprocesses the sums of one vector of joints
template <std::size_t kCount, class Finish>
HWY_INLINE void sum_all(const MirrorPoseJob& job, const MirroredSums& sums, PoseSpan::Plane first,
                        const Finish& finish) {
  const Floats d;
  const std::size_t count = sums.joints.size(), stride = job.pose.stride;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const IndexLanes from = load_indices(sums.sources, i), to = load_indices(sums.joints, i);
    Lanes in[kCount], out[kCount];
    for (std::size_t c = 0; c < kCount; ++c) in[c] = hn::GatherIndex(d, job.pose.plane(first) + c * stride, from);
    for (std::size_t r = 0; r < kCount; ++r) out[r] = row_sum(sums.factors.data() + r * kCount * count + i, count, in);
    finish(out, i);
    for (std::size_t c = 0; c < kCount; ++c) hn::ScatterIndex(out[c], d, job.mirrored.plane(first) + c * stride, to);
  }
}

void mirror(const MirrorPoseJob& job) {
  const MirrorTables& tables = *job.tables;
  copy_all(job);
  sum_all<3>(job, tables.translation, PoseSpan::tx, [&](Lanes(&out)[3], std::size_t i) HWY_ATTR {
    const std::size_t count = tables.translation.joints.size();
    const float* offsets = tables.translation.factors.data() + 9 * count + i;
    for (std::size_t c = 0; c < 3; ++c) out[c] = hn::Add(out[c], hn::LoadU(Floats(), offsets + c * count));
  });
  sum_all<4>(job, tables.rotation, PoseSpan::rx, [](Lanes(&out)[4], std::size_t) HWY_ATTR {
    const Rotations unit = normalised(Rotations{out[0], out[1], out[2], out[3]});
    out[0] = unit.x;
    out[1] = unit.y;
    out[2] = unit.z;
    out[3] = unit.w;
  });
  sum_all<3>(job, tables.scale, PoseSpan::sx, [](Lanes(&)[3], std::size_t) HWY_ATTR {});
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {

constexpr std::size_t kGroup = 16;
constexpr std::uint32_t kNegated = 0x80000000u;

template <std::size_t kCount>
bool all_copied(const std::array<MirrorRow<kCount>, kCount>& rows) noexcept {
  return std::all_of(rows.begin(), rows.end(), [](const MirrorRow<kCount>& row) { return copied_entry(row) != 0; });
}

/// The place of one property in a pose, and the joints that need sums for it.
struct PropertyTables {
  std::size_t stride, first_plane;
  std::vector<std::uint32_t>& copies;
  MirroredSums& sums;

  /// Adds joint `p`: its property is copied from the source, or becomes one of the sums.
  template <std::size_t kCount>
  void add(std::uint32_t p, std::uint32_t source, const std::array<MirrorRow<kCount>, kCount>& rows, bool has_offset) {
    if (has_offset || !all_copied(rows)) {
      sums.joints.push_back(p);
      sums.sources.push_back(source);
      return;
    }
    for (std::size_t r = 0; r < kCount; ++r) {
      const int entry = copied_entry(rows[r]);
      const std::size_t plane = first_plane + static_cast<std::size_t>(entry > 0 ? entry - 1 : -entry - 1);
      copies[(first_plane + r) * stride + p] =
          static_cast<std::uint32_t>(plane * stride + source) | (entry < 0 ? kNegated : 0u);
    }
  }

  /// Pads the groups and writes `entry_count` planes of factors.
  template <class Entry>
  void finish(std::size_t entry_count, const Entry& entry) {
    while (sums.joints.size() % kGroup != 0) {
      sums.joints.push_back(sums.joints.back());
      sums.sources.push_back(sums.sources.back());
    }
    for (std::size_t e = 0; e < entry_count; ++e)
      for (const std::uint32_t p : sums.joints) sums.factors.push_back(static_cast<float>(entry(p, e)));
  }
};

}  // namespace

MirrorTables make_mirror_tables(std::span<const MirroredJoint> joints) {
  MirrorTables tables;
  tables.joint_count = joints.size();
  const std::size_t stride = PoseSpan::stride_for(joints.size());
  tables.copies.resize(PoseSpan::floats_for(joints.size()));
  for (std::uint32_t i = 0; i < tables.copies.size(); ++i) tables.copies[i] = i;
  PropertyTables translation{stride, PoseSpan::tx, tables.copies, tables.translation};
  PropertyTables rotation{stride, PoseSpan::rx, tables.copies, tables.rotation};
  PropertyTables scale{stride, PoseSpan::sx, tables.copies, tables.scale};
  for (std::uint32_t p = 0; p < joints.size(); ++p) {
    const MirroredJoint& joint = joints[p];
    translation.add(p, joint.source, joint.translation, joint.offset != Vec3<double>(0.0));
    rotation.add(p, joint.source, joint.rotation, false);
    scale.add(p, joint.source, joint.scale, false);
  }
  translation.finish(12, [&](std::uint32_t p, std::size_t e) {
    return e < 9 ? joints[p].translation[e / 3][e % 3] : joints[p].offset[static_cast<int>(e) - 9];
  });
  rotation.finish(16, [&](std::uint32_t p, std::size_t e) { return joints[p].rotation[e / 4][e % 4]; });
  scale.finish(9, [&](std::uint32_t p, std::size_t e) { return joints[p].scale[e / 3][e % 3]; });
  return tables;
}

ErrorCode check(const MirrorPoseJob& job) noexcept {
  if (job.tables == nullptr) return ErrorCode::size_mismatch;
  const std::size_t joints = job.tables->joint_count;
  if (!is_pose_of(job.pose, joints) || !is_pose_of(job.mirrored, joints)) return ErrorCode::size_mismatch;
  return joints > 0 && job.pose.planes == job.mirrored.planes ? ErrorCode::size_mismatch : ErrorCode::ok;
}

SINEW_DISPATCH_RUN(MirrorPoseJob, mirror)

}  // namespace sinew
#endif  // HWY_ONCE
