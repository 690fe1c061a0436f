// SPDX-License-Identifier: MIT
#include "runtime/deform/blend_combinations.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/deform/blend_combinations.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "runtime/deform/influence_dispatch.h"
#include "runtime/deform/vertex_checks.h"
#include "runtime/pose/simd/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

/// Blends the matrices of a group. The sum has the order and the fused multiply-adds of blend_matrix-inl.h, and thus
/// the same bits.
template <int kCount>
void blend_group(const JointMatrix* palette, const VertexInfluences& influences, const InfluenceGroup& group,
                 JointMatrix* out) {
  const hn::CappedTag<float, 16> d;
  for (std::size_t k = 0; k < group.vertex_count; ++k) {
    const VertexJoints<kCount> joints = joints_of<kCount>(influences, group, k);
    for (std::size_t at = 0; at < 16; at += hn::Lanes(d)) {
      const auto column = [&](std::size_t i)
                              HWY_ATTR { return hn::Load(d, &palette[joints.joints[i]].column[0].x + at); };
      auto sum = column(0);
      if (joints.count() > 1) sum = hn::Mul(sum, hn::Set(d, joints.weights[0]));
      for (std::size_t i = 1; i < joints.count(); ++i) sum = hn::MulAdd(column(i), hn::Set(d, joints.weights[i]), sum);
      hn::Store(sum, d, &out[k].column[0].x + at);
    }
  }
}

void blend_combinations(const BlendCombinationsJob& job) {
  for_each_group(job.combinations, [&](const InfluenceGroup& group, auto count) {
    blend_group<count>(job.palette.data(), *job.combinations, group, &job.blended[group.first_vertex]);
  });
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
ErrorCode check(const BlendCombinationsJob& job) noexcept {
  if (job.combinations == nullptr || !have_memory(job.palette, job.blended)) return ErrorCode::size_mismatch;
  return check_influences(job.combinations, job.blended.size(), job.palette.size());
}

SINEW_DISPATCH_RUN(BlendCombinationsJob, blend_combinations)

}  // namespace sinew
#endif
