// SPDX-License-Identifier: MIT
#include "runtime/pose/blend_poses.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/pose/blend_poses.cpp"
#include <hwy/foreach_target.h>

#include "runtime/pose/simd/pose_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

HWY_INLINE void add(Rotations& sum, const Rotations& q) {
  sum = {hn::Add(sum.x, q.x), hn::Add(sum.y, q.y), hn::Add(sum.z, q.z), hn::Add(sum.w, q.w)};
}

/// The weight, negated where a rotation is not on the side of the pivot; sign(0) = +1.
HWY_INLINE Lanes turned(Lanes weight, const Rotations& q, const Rotations& pivot) {
  const Floats d;
  return hn::Xor(weight, hn::IfThenElseZero(hn::Lt(dot4(pivot, q), hn::Zero(d)), hn::SignBit(d)));
}

/// The mean of the rotations from joint `j` on: the aligned sum by the total weight and by its length. The sum has at
/// least the pivot's share of the total as length, so there is always a direction.
template <class Terms>
HWY_INLINE Rotations mean_rotation(const Terms& terms, const Rotations& pivot, std::size_t stride, std::size_t j) {
  const auto weighted = [&](std::size_t i) HWY_ATTR {
    if (terms.is_pivot(i)) return scaled(pivot, terms.weight(i));
    const Rotations q = load_rotations(terms.planes(i), stride, j);
    return scaled(q, turned(terms.weight(i), q, pivot));
  };
  Rotations sum = weighted(0);
  for (std::size_t i = 1; i < terms.count(); ++i) add(sum, weighted(i));
  return normalised(terms.sums_to_one() ? sum : scaled(sum, terms.by_total()));
}

/// Translations and scales.
struct Vectors {
  Lanes tx, ty, tz, sx, sy, sz;
};

HWY_INLINE Vectors load_vectors(const float* planes, std::size_t stride, std::size_t j) {
  const Floats d;
  const float *t = planes + PoseSpan::tx * stride + j, *s = planes + PoseSpan::sx * stride + j;
  return {hn::LoadU(d, t), hn::LoadU(d, t + stride), hn::LoadU(d, t + 2 * stride),
          hn::LoadU(d, s), hn::LoadU(d, s + stride), hn::LoadU(d, s + 2 * stride)};
}
HWY_INLINE Vectors scaled(const Vectors& v, Lanes by) {
  return {hn::Mul(v.tx, by), hn::Mul(v.ty, by), hn::Mul(v.tz, by),
          hn::Mul(v.sx, by), hn::Mul(v.sy, by), hn::Mul(v.sz, by)};
}
HWY_INLINE void add(Vectors& sum, const Vectors& v) {
  sum = {hn::Add(sum.tx, v.tx), hn::Add(sum.ty, v.ty), hn::Add(sum.tz, v.tz),
         hn::Add(sum.sx, v.sx), hn::Add(sum.sy, v.sy), hn::Add(sum.sz, v.sz)};
}

/// The mean of the translations and scales from joint `j` on. Apart from the rotations: the sums of whole transforms
/// would not fit into sixteen registers.
template <class Terms>
HWY_INLINE Vectors mean_vectors(const Terms& terms, std::size_t stride, std::size_t j) {
  const auto weighted = [&](std::size_t i)
                            HWY_ATTR { return scaled(load_vectors(terms.planes(i), stride, j), terms.weight(i)); };
  Vectors sum = weighted(0);
  for (std::size_t i = 1; i < terms.count(); ++i) add(sum, weighted(i));
  return terms.sums_to_one() ? sum : scaled(sum, terms.by_total());
}

HWY_INLINE void store(const Vectors& v, float* planes, std::size_t stride, std::size_t j) {
  const Floats d;
  float *t = planes + PoseSpan::tx * stride + j, *s = planes + PoseSpan::sx * stride + j;
  hn::StoreU(v.tx, d, t);
  hn::StoreU(v.ty, d, t + stride);
  hn::StoreU(v.tz, d, t + 2 * stride);
  hn::StoreU(v.sx, d, s);
  hn::StoreU(v.sy, d, s + stride);
  hn::StoreU(v.sz, d, s + 2 * stride);
}

/// Poses and weights of one vector of joints, whose weights differ from joint to joint.
class LaneTerms {
 public:
  HWY_INLINE LaneTerms(const BlendPosesJob& job, std::size_t j)
      : job_(job),
        j_(j),
        pivot_(load_rotations(job.rest.planes, job.rest.stride, j)),
        largest_(hn::Zero(Floats())),
        total_(largest_),
        rest_weight_(largest_) {
    const Floats d;
    const Lanes zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const Rotations rest = pivot_;
    Lanes contributors = zero;
    for (std::size_t i = 0; i < job.layers.size(); ++i) {
      const BlendLayer& layer = job.layers[i];
      const Lanes w = weight_of(layer, j);
      if (i < kKept) kept_[i] = w;
      pivot_ = choose(hn::Gt(w, largest_), load_rotations(layer.pose.planes, layer.pose.stride, j), pivot_);
      largest_ = hn::Max(largest_, w);
      total_ = hn::Add(total_, w);
      contributors = hn::Add(contributors, hn::IfThenElseZero(hn::Gt(w, zero), one));
    }
    rest_weight_ = hn::Max(hn::Sub(one, total_), zero);
    total_ = hn::Add(total_, rest_weight_);
    pivot_ = choose(hn::Gt(rest_weight_, largest_), rest, pivot_);
    alone_ = hn::Or(hn::Eq(contributors, zero),
                    hn::And(hn::Eq(contributors, one), hn::Lt(rest_weight_, hn::Set(d, kNegligible))));
  }

  std::size_t count() const { return job_.layers.size() + 1; }
  HWY_INLINE const float* planes(std::size_t i) const {
    return i == job_.layers.size() ? job_.rest.planes : job_.layers[i].pose.planes;
  }
  HWY_INLINE Lanes weight(std::size_t i) const {
    if (i == job_.layers.size()) return rest_weight_;
    return i < kKept ? kept_[i] : weight_of(job_.layers[i], j_);
  }
  bool is_pivot(std::size_t) const { return false; }  // of all lanes
  bool sums_to_one() const { return false; }
  HWY_INLINE Lanes by_total() const { return hn::Div(hn::Set(Floats(), 1.0f), total_); }
  const Rotations& pivot() const { return pivot_; }
  /// Where nothing is to be blended: one layer counts, or none, and rest takes its place.
  hn::Mask<Floats> alone() const { return alone_; }

 private:
  static constexpr std::size_t kKept = 8;  ///< weights that are worked out once

  const BlendPosesJob& job_;
  std::size_t j_;
  Rotations pivot_;
  Lanes largest_, total_, rest_weight_, kept_[kKept];
  hn::Mask<Floats> alone_;
};

/// The transform of the layer with the largest weight, of rest where no layer has any.
HWY_INLINE TransformLanes heaviest(const BlendPosesJob& job, std::size_t j) {
  TransformLanes found = load(job.rest, j);
  Lanes largest = hn::Zero(Floats());
  for (const BlendLayer& layer : job.layers) {
    const Lanes w = weight_of(layer, j);
    found = choose(hn::Gt(w, largest), load(layer.pose, j), found);
    largest = hn::Max(largest, w);
  }
  return found;
}

/// Blends one vector of joints from `j` on. Where nothing is to be blended, the one transform that counts comes out bit
/// for bit.
void blend_lanes(const BlendPosesJob& job, std::size_t j) {
  const Floats d;
  const LaneTerms terms(job, j);
  if (hn::AllTrue(d, terms.alone())) return store(heaviest(job, j), job.pose, j);
  const std::size_t stride = job.pose.stride;
  const Rotations q = mean_rotation(terms, terms.pivot(), stride, j);
  const Vectors v = mean_vectors(terms, stride, j);
  const TransformLanes blended{v.tx, v.ty, v.tz, q.x, q.y, q.z, q.w, v.sx, v.sy, v.sz};
  store(hn::AllFalse(d, terms.alone()) ? blended : choose(terms.alone(), heaviest(job, j), blended), job.pose, j);
}

/// Poses and weights that are the same for all joints: of layers without masks, at most kMost poses with rest.
class EqualTerms {
 public:
  static constexpr std::size_t kMost = 16;
  static constexpr bool kPlanesAtOnce = false;

  explicit EqualTerms(const BlendPosesJob& job) {
    float largest = 0.0f, sum = 0.0f;
    for (const BlendLayer& layer : job.layers) {
      if (layer.weight < kNegligible) continue;
      if (layer.weight > largest) {
        largest = layer.weight;
        pivot_ = count_;
      }
      sum += layer.weight;
      put(layer.pose.planes, layer.weight);
    }
    const float rest_weight = std::max(1.0f - sum, 0.0f), total = sum + rest_weight;
    sums_to_one_ = total == 1.0f;
    by_total_ = 1.0f / total;
    if (rest_weight > largest) pivot_ = count_;
    if (rest_weight > 0.0f) put(job.rest.planes, rest_weight);
    if (count_ != 2 || pivot_ == 0) return;
    std::swap(planes_[0], planes_[1]);  // sums of two are the same either way
    std::swap(weights_[0], weights_[1]);
    pivot_ = 0;
  }

  std::size_t count() const { return count_; }
  const float* planes(std::size_t i) const { return planes_[i]; }
  HWY_INLINE Lanes weight(std::size_t i) const { return hn::Set(Floats(), weights_[i]); }
  std::size_t pivot() const { return pivot_; }
  bool is_pivot(std::size_t i) const { return i == pivot_; }
  bool sums_to_one() const { return sums_to_one_; }
  HWY_INLINE Lanes by_total() const { return hn::Set(Floats(), by_total_); }

 private:
  void put(const float* planes, float weight) {
    planes_[count_] = planes;
    weights_[count_++] = weight;
  }

  const float* planes_[kMost];
  float weights_[kMost], by_total_;
  bool sums_to_one_;
  std::size_t count_ = 0, pivot_ = 0;
};

/// The same of a known number of poses, and which of them is the pivot: loops over them are unrolled, and what they
/// need stays in registers.
template <std::size_t kCount, std::size_t kPivot>
class CountedTerms {
 public:
  static constexpr bool kPlanesAtOnce = kCount < 4;  ///< their addresses fit into registers

  HWY_INLINE explicit CountedTerms(const EqualTerms& terms)
      : sums_to_one_(terms.sums_to_one()), by_total_(terms.by_total()) {
    for (std::size_t i = 0; i < kCount; ++i) {
      planes_[i] = terms.planes(i);
      weights_[i] = terms.weight(i);
    }
  }

  static constexpr std::size_t count() { return kCount; }
  const float* planes(std::size_t i) const { return planes_[i]; }
  HWY_INLINE Lanes weight(std::size_t i) const { return weights_[i]; }
  static constexpr std::size_t pivot() { return kPivot; }
  static constexpr bool is_pivot(std::size_t i) { return i == kPivot; }
  bool sums_to_one() const { return sums_to_one_; }
  HWY_INLINE Lanes by_total() const { return by_total_; }

 private:
  const float* planes_[kCount];
  bool sums_to_one_;
  Lanes weights_[kCount], by_total_;
};

/// The mean of the floats from `begin` to `end` of each pose; short vectors go in pairs.
template <class Terms>
HWY_INLINE void blend_floats(const Terms& terms, std::size_t begin, std::size_t end, float* out) {
  const Floats d;
  constexpr std::size_t kLanes = hn::MaxLanes(d), kAtOnce = kLanes > 4 ? 1 : 2;
  const auto weighted = [&](std::size_t i, std::size_t at)
                            HWY_ATTR { return hn::Mul(hn::LoadU(d, terms.planes(i) + at), terms.weight(i)); };
  for (std::size_t first = begin; first < end; first += kAtOnce * kLanes) {
    HWY_UNROLL(2)
    for (std::size_t k = 0; k < kAtOnce; ++k) {
      const std::size_t at = first + k * kLanes;
      Lanes sum = weighted(0, at);
      for (std::size_t i = 1; i < terms.count(); ++i) sum = hn::Add(sum, weighted(i, at));
      hn::StoreU(terms.sums_to_one() ? sum : hn::Mul(sum, terms.by_total()), d, out + at);
    }
  }
}

/// The means of all translations and scales: all planes in one loop, or plane after plane where each plane of each pose
/// would take more addresses than there are registers.
template <class Terms>
HWY_INLINE void blend_vectors(const Terms& terms, float* out, std::size_t stride, std::size_t joints) {
  using P = PoseSpan;
  if constexpr (Terms::kPlanesAtOnce) {
    for (std::size_t j = 0; j < joints; j += hn::Lanes(Floats())) store(mean_vectors(terms, stride, j), out, stride, j);
  } else {
    for (const std::size_t plane : {P::tx, P::ty, P::tz, P::sx, P::sy, P::sz})
      blend_floats(terms, plane * stride, plane * stride + joints, out);
  }
}

template <class Terms>
HWY_INLINE void blend_equally(const BlendPosesJob& job, const Terms& terms) {
  const std::size_t stride = job.pose.stride, joints = job.pose.joint_count;
  float* planes = job.pose.planes;
  const float* pivot = terms.planes(terms.pivot());
  for (std::size_t j = 0; j < joints; j += hn::Lanes(Floats()))
    store(mean_rotation(terms, load_rotations(pivot, stride, j), stride, j), planes, stride, j);
  blend_vectors(terms, planes, stride, joints);
}

template <std::size_t kCount, std::size_t kPivot>
HWY_NOINLINE void blend_counted(const BlendPosesJob& job, const EqualTerms& terms) {
  blend_equally(job, CountedTerms<kCount, kPivot>(terms));
}

/// The same means as blend_lanes, reading each pose once.
void blend_without_masks(const BlendPosesJob& job) {
  using Blend = void (*)(const BlendPosesJob&, const EqualTerms&);
  constexpr Blend three[] = {blend_counted<3, 0>, blend_counted<3, 1>, blend_counted<3, 2>},
                  four[] = {blend_counted<4, 0>, blend_counted<4, 1>, blend_counted<4, 2>, blend_counted<4, 3>};
  const EqualTerms terms(job);
  switch (terms.count()) {
    case 1:
      std::memmove(job.pose.planes, terms.planes(0), PoseSpan::plane_count * job.pose.stride * sizeof(float));
      break;
    case 2: blend_counted<2, 0>(job, terms); break;
    case 3: three[terms.pivot()](job, terms); break;
    case 4: four[terms.pivot()](job, terms); break;
    default: blend_equally(job, terms); break;
  }
}

void blend_all(const BlendPosesJob& job) {
  bool masked = job.layers.size() >= EqualTerms::kMost;
  for (const BlendLayer& layer : job.layers) masked = masked || !layer.joint_weights.empty();
  if (!masked) return blend_without_masks(job);
  for (std::size_t j = 0; j < job.pose.joint_count; j += hn::Lanes(Floats())) blend_lanes(job, j);
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {

HWY_EXPORT(blend_all);

bool is_weight(float w) noexcept { return std::isfinite(w) && w >= 0.0f; }

}  // namespace

ErrorCode check(const BlendPosesJob& job) noexcept {
  const std::size_t joints = job.pose.joint_count;
  if (!is_pose_of(job.pose, joints) || !is_pose_of(job.rest, joints)) return ErrorCode::size_mismatch;
  if (!have_memory(job.layers)) return ErrorCode::size_mismatch;
  for (const BlendLayer& layer : job.layers) {
    if (!is_pose_of(layer.pose, joints) || !have_memory(layer.joint_weights)) return ErrorCode::size_mismatch;
    if (!layer.joint_weights.empty() && layer.joint_weights.size() != joints) return ErrorCode::size_mismatch;
    if (!is_weight(layer.weight)) return ErrorCode::not_finite;
    if (!std::all_of(layer.joint_weights.begin(), layer.joint_weights.end(), is_weight)) return ErrorCode::not_finite;
  }
  return ErrorCode::ok;
}

void run_unchecked(const BlendPosesJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  HWY_DYNAMIC_DISPATCH(blend_all)(job);
}

}  // namespace sinew
#endif  // HWY_ONCE
