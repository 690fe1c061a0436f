// SPDX-License-Identifier: MIT
#include "importer/tool/cost/rotation/rotation_lanes.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "importer/tool/cost/rotation/rotation_lanes.cpp"
#include <hwy/foreach_target.h>

#include "runtime/pose/simd/track_places-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::cost::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using sinew::HWY_NAMESPACE::Floats;
using sinew::HWY_NAMESPACE::for_each_place;
using sinew::HWY_NAMESPACE::KeyRow;
using sinew::HWY_NAMESPACE::Lanes;

constexpr std::size_t kArcPlane = 4;  // its sign says if the next key must be negated to be in the same hemisphere

struct Rotations {
  Lanes x, y, z, w;
};

HWY_INLINE Lanes dot(const Rotations& a, const Rotations& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Add(hn::Mul(a.z, b.z), hn::Mul(a.w, b.w)));
}

HWY_INLINE Rotations sum(const Rotations& a, Lanes wa, const Rotations& b, Lanes wb) {
  const auto mix = [&](Lanes p, Lanes q) HWY_ATTR { return hn::Add(hn::Mul(p, wa), hn::Mul(q, wb)); };
  return {mix(a.x, b.x), mix(a.y, b.y), mix(a.z, b.z), mix(a.w, b.w)};
}

HWY_INLINE Rotations times(const Rotations& a, Lanes f) {
  return {hn::Mul(a.x, f), hn::Mul(a.y, f), hn::Mul(a.z, f), hn::Mul(a.w, f)};
}

HWY_INLINE Rotations unit(const Rotations& a) {
  return times(a, hn::Div(hn::Set(Floats(), 1.0f), hn::Sqrt(dot(a, a))));
}

/// The keys on both sides of the time, the later one in the hemisphere of the earlier one.
struct Keys {
  Rotations from, to;
};

HWY_INLINE Rotations key_of(const KeyRow& row, std::size_t lane) {
  return {row.load(0, lane), row.load(1, lane), row.load(2, lane), row.load(3, lane)};
}

HWY_INLINE Keys keys_of(const KeyRow& begin, const KeyRow& end, std::size_t lane) {
  const Lanes side = hn::CopySign(hn::Set(Floats(), 1.0f), begin.load(kArcPlane, lane));
  return {key_of(begin, lane), times(key_of(end, lane), side)};
}

/// Calls `between(keys)` for all lanes and stores the result.
template <class Between>
HWY_INLINE void for_each_arc(const TrackBlock& block, std::size_t key, const TrackOutput& out, const Between& between) {
  const KeyRow begin(block, key), end(block, key + 1);
  for_each_place(block, out, [&](const auto& place) HWY_ATTR {
    const Rotations q = between(keys_of(begin, end, place.lane()));
    place.store(0, q.x);
    place.store(1, q.y);
    place.store(2, q.z);
    place.store(3, q.w);
  });
}

/// eq   normalise((1 - s) q + s r)
void nlerp_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) {
  const Floats d;
  const Lanes s = hn::Set(d, at.s), r = hn::Set(d, at.r);
  for_each_arc(block, at.key, out, [&](const Keys& k) HWY_ATTR { return unit(sum(k.from, r, k.to, s)); });
}

/// eq   nlerp at corrected_parameter(s, q . r)   (approximate_slerp.h)
void corrected_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) {
  const Floats d;
  const float m = at.s - 0.5f;
  const Lanes square = hn::Set(d, m * m), bend = hn::Set(d, at.s * m * (at.s - 1.0f)), s = hn::Set(d, at.s),
              one = hn::Set(d, 1.0f);
  const auto step = [&](Lanes sum, Lanes x, float c) HWY_ATTR { return hn::Add(hn::Mul(sum, x), hn::Set(d, c)); };
  for_each_arc(block, at.key, out, [&](const Keys& k) HWY_ATTR {
    const Lanes c = dot(k.from, k.to);
    const Lanes a = step(step(step(hn::Set(d, -1.427425f), c, 3.601f), c, -3.231142f), c, 1.045469f);
    const Lanes b = step(step(hn::Set(d, 0.207251f), c, -1.056303f), c, 0.850154f);
    const Lanes warped = hn::Add(s, hn::Mul(bend, hn::Add(hn::Mul(a, square), b)));
    return unit(sum(k.from, hn::Sub(one, warped), k.to, warped));
  });
}

/// eq   sine_ratio(t, y)   (approximate_slerp.h)
HWY_INLINE Lanes sine_ratio(float t, Lanes y) {
  const Floats d;
  constexpr int kFactors = 6;
  Lanes total = hn::Set(d, 1.0f);
  for (int i = kFactors; i >= 1; --i) {
    const float scale = (i == kFactors ? 1.155f : 1.0f) / static_cast<float>(i * (2 * i + 1));
    const float factor = scale * (t * t - static_cast<float>(i * i));
    total = hn::Add(hn::Set(d, 1.0f), hn::Mul(hn::Mul(hn::Set(d, factor), y), total));
  }
  return hn::Mul(hn::Set(d, t), total);
}

/// eq   slerp along the half of the arc that holds s   (polynomial_slerp)
void polynomial_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) {
  const Floats d;
  const Lanes one = hn::Set(d, 1.0f), minus = hn::Set(d, -1.0f);
  const bool late = at.s >= 0.5f;
  const float u = late ? 2.0f * at.s - 1.0f : 2.0f * at.s, v = late ? 2.0f * at.r : 1.0f - u;
  for_each_arc(block, at.key, out, [&](const Keys& k) HWY_ATTR {
    const Rotations half = unit(sum(k.from, one, k.to, one)), apart = sum(half, one, k.from, minus);
    const Lanes y = hn::Mul(hn::Set(d, -0.5f), dot(apart, apart));
    return sum(late ? half : k.from, sine_ratio(v, y), late ? k.to : half, sine_ratio(u, y));
  });
}

void copy_key(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) {
  const KeyRow row(block, at.key);
  for_each_place(block, out, [&](const auto& place) HWY_ATTR {
    for (std::size_t c = 0; c < 4; ++c) place.store(c, row.load(c, place.lane()));
  });
}

}  // namespace sinew::cost::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew::cost {
namespace {

HWY_EXPORT(nlerp_block);
HWY_EXPORT(corrected_block);
HWY_EXPORT(polynomial_block);
HWY_EXPORT(copy_key);

void sample_block(const TrackBlock& block, const BetweenKeys& at, ArcRule rule, const TrackOutput& out) noexcept {
  switch (rule) {
    case ArcRule::nlerp: HWY_DYNAMIC_DISPATCH(nlerp_block)(block, at, out); break;
    case ArcRule::corrected_nlerp: HWY_DYNAMIC_DISPATCH(corrected_block)(block, at, out); break;
    case ArcRule::polynomial_slerp: HWY_DYNAMIC_DISPATCH(polynomial_block)(block, at, out); break;
  }
}

}  // namespace

void sample_rotations(const Clip& clip, double time_s, ArcRule rule, const PoseSpan& pose) noexcept {
  const ClipLayout& layout = clip.layout();
  layout.base_pose.copy_to(pose.planes);
  const TrackOutput out{pose.planes + first_plane(Property::rotation) * pose.stride, pose.stride};
  for (const TimeGroup& group : layout.groups) {
    const KeyPosition position = group.times.locate(time_s);
    const BetweenKeys at(position);
    for (const TrackBlock& block : group.blocks) {
      if (block.property != Property::rotation) continue;
      if (position.on_key)
        HWY_DYNAMIC_DISPATCH(copy_key)(block, at, out);
      else
        sample_block(block, at, rule, out);
    }
  }
}

}  // namespace sinew::cost
#endif  // HWY_ONCE
