// SPDX-License-Identifier: MIT
#include "tests/bench/instance_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/instance_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sinew::bench::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using Lanes = hn::Vec<Floats>;
using Offsets = hn::Vec<hn::RebindToSigned<Floats>>;

struct Matrix {
  Lanes row[3][4];
};

/// eq   T * R * S
HWY_INLINE Matrix local_matrix(const float* pose, std::size_t stride, Offsets at) {
  const Floats d;
  const auto plane = [&](std::size_t p) HWY_ATTR { return hn::GatherIndex(d, pose + p * stride, at); };
  const Lanes x = plane(3), y = plane(4), z = plane(5), w = plane(6), sx = plane(7), sy = plane(8), sz = plane(9);
  const Lanes one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f);
  const auto diagonal = [&](Lanes a, Lanes b)
                            HWY_ATTR { return hn::Sub(one, hn::Mul(two, hn::Add(hn::Mul(a, a), hn::Mul(b, b)))); };
  const auto sum = [&](Lanes a, Lanes b, Lanes c)
                       HWY_ATTR { return hn::Mul(two, hn::Add(hn::Mul(a, b), hn::Mul(w, c))); };
  const auto difference = [&](Lanes a, Lanes b, Lanes c)
                              HWY_ATTR { return hn::Mul(two, hn::Sub(hn::Mul(a, b), hn::Mul(w, c))); };
  return {{{hn::Mul(diagonal(y, z), sx), hn::Mul(difference(x, y, z), sy), hn::Mul(sum(x, z, y), sz), plane(0)},
           {hn::Mul(sum(x, y, z), sx), hn::Mul(diagonal(x, z), sy), hn::Mul(difference(y, z, x), sz), plane(1)},
           {hn::Mul(difference(x, z, y), sx), hn::Mul(sum(y, z, x), sy), hn::Mul(diagonal(x, y), sz), plane(2)}}};
}

/// Matrices of one vector of instances, read from `poses` and written to `model`. `kept` holds the matrices of all
/// joints for their children, followed by the matrix above the roots.
void compose(const Skeleton& skeleton, const float* poses, std::size_t pose_pitch, Affine* model, float* kept) {
  const Floats d;
  const hn::RebindToSigned<Floats> di;
  const std::size_t joints = skeleton.joint_count(), stride = PoseSpan::stride_for(joints);
  const auto instance = hn::Iota(di, 0);
  const auto from = hn::Mul(instance, hn::Set(di, static_cast<std::int32_t>(pose_pitch)));
  const auto to = hn::Mul(instance, hn::Set(di, static_cast<std::int32_t>(12 * joints)));
  for (std::size_t i = 0; i < 12; ++i)
    hn::Store(hn::Set(d, i % 5 == 0 ? 1.0f : 0.0f), d, kept + (joints * 12 + i) * hn::Lanes(d));
  for (std::size_t j = 0; j < joints; ++j) {
    const Matrix local = local_matrix(poses + j, stride, from);
    const std::size_t parent = skeleton.parents[j] == kNone ? joints : skeleton.parents[j];
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 4; ++c) {
        const auto above = [&](std::size_t k)
                               HWY_ATTR { return hn::Load(d, kept + (parent * 12 + r * 4 + k) * hn::Lanes(d)); };
        Lanes out = hn::Add(hn::Add(hn::Mul(above(0), local.row[0][c]), hn::Mul(above(1), local.row[1][c])),
                            hn::Mul(above(2), local.row[2][c]));
        if (c == 3) out = hn::Add(out, above(3));
        hn::Store(out, d, kept + (j * 12 + r * 4 + c) * hn::Lanes(d));
        hn::ScatterIndex(out, d, &model[j].row[r].x + c, to);
      }
  }
}

void local_to_model(const Skeleton& skeleton, const float* poses, std::size_t pose_pitch, std::size_t instance_count,
                    Affine* model, float* kept) {
  const std::size_t lanes = hn::Lanes(Floats());
  for (std::size_t i = 0; i + lanes <= instance_count; i += lanes)
    compose(skeleton, poses + i * pose_pitch, pose_pitch, model + i * skeleton.joint_count(), kept);
}

}  // namespace
}  // namespace sinew::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew::bench {
namespace {
HWY_EXPORT(local_to_model);
}  // namespace

void InstanceLanes::local_to_model(const float* poses, std::size_t pose_pitch, Affine* model) {
  HWY_DYNAMIC_DISPATCH(local_to_model)(skeleton_, poses, pose_pitch, instance_count_, model, kept_[0].floats);
}

}  // namespace sinew::bench
#endif
