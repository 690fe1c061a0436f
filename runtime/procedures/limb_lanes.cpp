// SPDX-License-Identifier: MIT
#include "runtime/procedures/limb_lanes.h"

#include "runtime/math/two_bones.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/procedures/limb_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "runtime/procedures/limb_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

using ik::PlainLimbs;
using ik::SolvedLimbs;

/// Limbs that come closer than this to a degenerate case are left to the general solver. Shares of lengths.
constexpr double kShort = 1e-4, kFolded = 1e-3, kOpposite = -0.99, kCancelled = 1e-3;

/// Limbs with quaternions whose square is farther from 1 are left to it too.
constexpr double kNearUnit = 1e-3;

/// Reads the lanes that start at lane `i`.
template <class D>
HWY_INLINE Vector<D> load(D d, const ik::LimbVectors& from, std::size_t i) {
  return {hn::Load(d, from.x + i), hn::Load(d, from.y + i), hn::Load(d, from.z + i)};
}

template <class D>
HWY_INLINE Rotation<D> load(D d, const ik::LimbRotations& from, std::size_t i) {
  return {hn::Load(d, from.x + i), hn::Load(d, from.y + i), hn::Load(d, from.z + i), hn::Load(d, from.w + i)};
}

template <class D>
HWY_INLINE void store(D d, const Rotation<D>& q, ik::LimbRotations& to, std::size_t i) {
  hn::Store(q.x, d, to.x + i);
  hn::Store(q.y, d, to.y + i);
  hn::Store(q.z, d, to.z + i);
  hn::Store(q.w, d, to.w + i);
}

/// A limb in the space of its parent, and the hinge of its middle joint in the space of the root joint (ik::Hinge).
template <class D>
struct HingedLimb {
  Vector<D> above[3];
  Rotation<D> root, middle;
  Vector<D> target, pole;
  Vector<D> upper, lower;
  Vector<D> axis, upper_across, lower_across;
  hn::Vec<D> along, lower_along, a, b;
  hn::Mask<D> is_plain;
};

/// The target and the pole in the space of the parent, by Cramer's rule.
template <class D>
HWY_INLINE void bring_to_parent(D d, const PlainLimbs& in, std::size_t i, HingedLimb<D>& limb) {
  for (int c = 0; c < 3; ++c) limb.above[c] = load(d, in.above[c], i);
  const auto& m = limb.above;
  const Vector<D> rows[3] = {cross<D>(m[1], m[2]), cross<D>(m[2], m[0]), cross<D>(m[0], m[1])};
  const hn::Vec<D> det = dot<D>(m[0], rows[0]);
  const hn::Vec<D> box = hn::Mul(hn::Mul(dot<D>(m[0], m[0]), dot<D>(m[1], m[1])), dot<D>(m[2], m[2]));
  limb.is_plain = hn::Gt(hn::Mul(det, det), hn::Mul(box, hn::Set(d, kShort * kShort)));
  const hn::Vec<D> per_det = hn::Div(hn::Set(d, 1.0), det);
  const auto back = [&](const Vector<D>& v) HWY_ATTR {
    return times<D>({dot<D>(rows[0], v), dot<D>(rows[1], v), dot<D>(rows[2], v)}, per_det);
  };
  limb.target = minus<D>(back(load(d, in.target, i)), load(d, in.place, i));
  limb.pole = back(load(d, in.pole, i));
}

/// A rotation of the pose, made unit. A limb whose quaternion is far from unit is not plain.
template <class D>
HWY_INLINE Rotation<D> near_unit(D d, const Rotation<D>& q, hn::Mask<D>& is_plain) {
  const hn::Vec<D> off = hn::Abs(hn::Sub(dot<D>(q, q), hn::Set(d, 1.0)));
  is_plain = hn::And(is_plain, hn::Lt(off, hn::Set(d, kNearUnit)));
  return unit_again<D>(d, unit_again<D>(d, q));
}

template <class D>
HWY_INLINE HingedLimb<D> hinged_limb(D d, const PlainLimbs& in, std::size_t i) {
  HingedLimb<D> limb;
  bring_to_parent(d, in, i, limb);
  limb.root = near_unit(d, load(d, in.root, i), limb.is_plain);
  limb.middle = near_unit(d, load(d, in.middle, i), limb.is_plain);
  limb.upper = load(d, in.upper, i);
  limb.lower = rotated<D>(limb.middle, load(d, in.lower, i));
  const hn::Vec<D> uu = dot<D>(limb.upper, limb.upper), ll = dot<D>(limb.lower, limb.lower);
  const Vector<D> bend = cross<D>(limb.upper, limb.lower), given = load(d, in.axis, i);
  const hn::Mask<D> is_given = hn::Gt(dot<D>(given, given), hn::Zero(d));
  const Vector<D> axis = either<D>(is_given, rotated<D>(limb.middle, given), bend);
  const hn::Vec<D> square = dot<D>(axis, axis);
  const hn::Vec<D> least = hn::IfThenElse(
      is_given, hn::Set(d, 1e-20), hn::Mul(hn::Mul(uu, ll), hn::Set(d, two_bones::kStraight * two_bones::kStraight)));
  limb.axis = times<D>(axis, per_root(d, square));
  const hn::Vec<D> upper_along = dot<D>(limb.upper, limb.axis);
  limb.lower_along = dot<D>(limb.lower, limb.axis);
  limb.along = hn::Add(upper_along, limb.lower_along);
  limb.upper_across = minus<D>(limb.upper, times<D>(limb.axis, upper_along));
  limb.lower_across = minus<D>(limb.lower, times<D>(limb.axis, limb.lower_along));
  const hn::Vec<D> aa = dot<D>(limb.upper_across, limb.upper_across), bb = dot<D>(limb.lower_across, limb.lower_across);
  limb.a = hn::Sqrt(aa);
  limb.b = hn::Sqrt(bb);
  const hn::Vec<D> shortest = hn::Set(d, kShort * kShort), both = hn::Add(uu, ll);
  limb.is_plain = hn::And(limb.is_plain, hn::Gt(square, least));
  limb.is_plain = hn::And(limb.is_plain, hn::Gt(hn::Min(aa, bb), hn::Mul(both, shortest)));
  limb.is_plain = hn::And(limb.is_plain, hn::And(hn::Gt(both, hn::Set(d, 1e-16)), hn::Lt(both, hn::Set(d, 1e16))));
  return limb;
}

/// Cosine and sine of a bend, times a b.
template <class D>
struct Bend {
  hn::Vec<D> cosine, sine;
};

/// eq   two_bones::corner
/// in   per_distance  1 / distance
template <class D>
HWY_INLINE Bend<D> bend_for(D d, hn::Vec<D> a, hn::Vec<D> b, hn::Vec<D> distance, hn::Vec<D> per_distance) {
  const hn::Vec<D> one = hn::Set(d, 1.0), half = hn::Set(d, 0.5), sum = hn::Add(a, b);
  const hn::Vec<D> r = hn::Min(hn::Max(hn::Mul(hn::Sub(a, b), per_distance), hn::Neg(one)), one);
  const hn::Vec<D> x = hn::Mul(half, hn::Add(hn::Mul(sum, r), distance));
  const hn::Vec<D> outer = hn::Mul(hn::Add(sum, distance), hn::Max(hn::Sub(sum, distance), hn::Zero(d)));
  const hn::Vec<D> y = hn::Mul(half, hn::Sqrt(hn::Mul(outer, hn::Mul(hn::Add(one, r), hn::Sub(one, r)))));
  return {hn::Sub(hn::Mul(x, hn::Sub(distance, x)), hn::Mul(y, y)), hn::Mul(y, distance)};
}

/// The direction that the side of the limb takes: that of the pose after the shortest turn, or that of the pole.
/// eq   ik::aimed_frame, ik::pole_side. Of a side perpendicular to `now`, the shortest turn to `wish` is
///      side - (now + wish) (wish . side) / (1 + now . wish)
template <class D>
HWY_INLINE Vector<D> side_for(D d, const PlainLimbs& in, std::size_t i, const Vector<D>& now, const Vector<D>& side,
                              const Vector<D>& wish, HingedLimb<D>& limb) {
  const hn::Vec<D> one = hn::Set(d, 1.0), zero = hn::Zero(d), cosine = dot<D>(now, wish);
  const hn::Vec<D> part = hn::Div(dot<D>(wish, side), hn::Add(one, cosine));
  const Vector<D> kept = minus<D>(side, times<D>(plus<D>(now, wish), part));
  const hn::Vec<D> pole_square = dot<D>(limb.pole, limb.pole);
  const hn::Mask<D> has_pole = hn::Gt(pole_square, zero);
  const Vector<D> pole = times<D>(limb.pole, per_root(d, hn::IfThenElse(has_pole, pole_square, one)));
  const Vector<D> beside = minus<D>(pole, times<D>(wish, dot<D>(wish, pole)));
  const hn::Vec<D> fading = hn::Max(hn::Sub(hn::Load(d, in.pole_fade + i), hn::Sqrt(dot<D>(beside, beside))), zero);
  const hn::Vec<D> share = hn::Mul(hn::Mul(fading, fading), hn::Load(d, in.per_fade + i));
  const hn::Mask<D> needs_kept = hn::Or(hn::Not(has_pole), hn::Gt(share, zero));
  const Vector<D> blended = either<D>(hn::Gt(share, zero), plus<D>(beside, times<D>(kept, share)), beside);
  const Vector<D> asked = either<D>(has_pole, blended, kept);
  const hn::Vec<D> square = dot<D>(asked, asked);
  limb.is_plain = hn::And(limb.is_plain, hn::Or(hn::Not(needs_kept), hn::Gt(cosine, hn::Set(d, kOpposite))));
  limb.is_plain = hn::And(limb.is_plain, hn::Gt(square, hn::Set(d, kCancelled * kCancelled)));
  limb.is_plain = hn::And(limb.is_plain, hn::Or(hn::Not(has_pole), hn::Gt(pole_square, hn::Set(d, 1e-20))));
  return times<D>(asked, per_root(d, square));
}

/// The error that is left with the rotations that the pose stores.
template <class D>
HWY_INLINE void measure(D d, const HingedLimb<D>& limb, const Rotation<D>& root, const Rotation<D>& middle,
                        std::size_t i, SolvedLimbs& out) {
  const Rotation<D> bend = product<D>(unit_again<D>(d, middle), conjugate<D>(limb.middle));
  const Vector<D> tip = rotated<D>(unit_again<D>(d, root), plus<D>(limb.upper, rotated<D>(bend, limb.lower)));
  const auto length_above = [&](const Vector<D>& v) HWY_ATTR {
    const auto& m = limb.above;
    const Vector<D> model = plus<D>(plus<D>(times<D>(m[0], v.x), times<D>(m[1], v.y)), times<D>(m[2], v.z));
    return hn::Sqrt(dot<D>(model, model));
  };
  hn::Store(length_above(minus<D>(tip, limb.target)), d, out.metres_left + i);
  hn::Store(hn::Add(length_above(rotated<D>(limb.root, limb.upper)), length_above(rotated<D>(limb.root, limb.lower))),
            d, out.length + i);
}

template <class D>
HWY_INLINE void solve_lanes(D d, const PlainLimbs& in, std::size_t i, bool measures, SolvedLimbs& out) {
  HingedLimb<D> limb = hinged_limb(d, in, i);
  const hn::Vec<D> one = hn::Set(d, 1.0), a = limb.a, b = limb.b, sum = hn::Add(a, b), difference = hn::Sub(a, b);

  // Distances between root and tip across the axis of the hinge. Without limits of the bend these are a + b and
  // |a - b|, without rounding.
  const hn::Vec<D> ab = hn::Mul(a, b), twice = hn::Add(ab, ab), along_square = hn::Mul(limb.along, limb.along);
  const hn::Vec<D> most = hn::Sub(hn::Mul(sum, sum), hn::Mul(twice, hn::Sub(one, hn::Load(d, in.least_cosine + i))));
  const hn::Vec<D> least = hn::Min(
      most, hn::Add(hn::Mul(difference, difference), hn::Mul(twice, hn::Add(one, hn::Load(d, in.most_cosine + i)))));
  const hn::Vec<D> wanted_square = dot<D>(limb.target, limb.target), wanted = hn::Sqrt(wanted_square);
  const hn::Vec<D> across = hn::Mul(hn::Sub(wanted, limb.along), hn::Add(wanted, limb.along));
  const hn::Vec<D> distance = hn::Sqrt(hn::Min(hn::Max(across, least), most));
  const hn::Vec<D> most_whole = hn::Add(most, along_square), free = hn::Load(d, in.free_share + i);
  const hn::Vec<D> folded = hn::Mul(sum, hn::Set(d, kFolded));
  limb.is_plain = hn::And(limb.is_plain, hn::Not(hn::Gt(wanted_square, hn::Mul(most_whole, hn::Mul(free, free)))));
  limb.is_plain = hn::And(limb.is_plain, hn::Gt(hn::Min(wanted, distance), folded));

  // The turn of the middle joint is the difference of the wanted bend and the bend of the pose.
  const hn::Vec<D> per_both = hn::Div(one, hn::Mul(distance, wanted));  // one division for two lengths
  const Bend<D> bend = bend_for(d, a, b, distance, hn::Mul(per_both, wanted));
  const hn::Vec<D> cosine_now = dot<D>(limb.upper_across, limb.lower_across),
                   sine_now = dot<D>(limb.axis, cross<D>(limb.upper_across, limb.lower_across));
  const hn::Vec<D> per_square = hn::Div(one, hn::Mul(ab, ab));
  const hn::Vec<D> cosine =
      hn::Mul(per_square, hn::Add(hn::Mul(bend.cosine, cosine_now), hn::Mul(bend.sine, sine_now)));
  const hn::Vec<D> sine = hn::Mul(per_square, hn::Sub(hn::Mul(bend.sine, cosine_now), hn::Mul(bend.cosine, sine_now)));
  const Rotation<D> middle = unit_again<D>(d, product<D>(turn_about<D>(d, limb.axis, cosine, sine), limb.middle));

  // The root joint turns the frame of the bent limb onto the wanted frame (ik::Frame).
  const Vector<D> tip = plus<D>(limb.upper, limb.lower);
  const Vector<D> beside = cross<D>(tip, limb.axis);
  limb.is_plain = hn::And(limb.is_plain, hn::Gt(dot<D>(beside, beside), hn::Mul(folded, folded)));
  const Vector<D> turned =
      plus<D>(times<D>(limb.lower_across, cosine), times<D>(cross<D>(limb.axis, limb.lower_across), sine));
  const Vector<D> tip_after = plus<D>(limb.upper, plus<D>(turned, times<D>(limb.axis, limb.lower_along)));
  Frame<D> before{tip, beside}, after{tip_after, cross<D>(tip_after, limb.axis)};
  make_unit<D>(d, before, after);
  const Vector<D> wish = times<D>(limb.target, hn::Mul(per_both, distance));
  const Vector<D> side =
      side_for(d, in, i, rotated<D>(limb.root, before.along), rotated<D>(limb.root, before.side), wish, limb);
  const Rotation<D> root = turn_between<D>(d, after, Frame<D>{wish, side});

  const Rotation<D> new_root = stored<D>(d, aligned<D>(d, load(d, in.root, i), root)),
                    new_middle = stored<D>(d, aligned<D>(d, load(d, in.middle, i), middle));
  store(d, new_root, out.root, i);
  store(d, new_middle, out.middle, i);
  hn::Store(hn::IfThenElseZero(limb.is_plain, one), d, out.is_solved + i);
  if (!measures) return;
  const hn::Vec<D> low = hn::Mul(hn::Add(least, along_square), hn::Set(d, 1.0 - 2e-9)),
                   high = hn::Mul(most_whole, hn::Set(d, 1.0 + 2e-9));
  const hn::Mask<D> can_reach = hn::And(hn::Ge(wanted_square, low), hn::Le(wanted_square, high));
  hn::Store(hn::IfThenElseZero(can_reach, one), d, out.can_reach + i);
  measure(d, limb, new_root, new_middle, i, out);
}

void solve_all_limbs(const PlainLimbs& limbs, std::size_t count, bool measures, SolvedLimbs& solved) {
  if (count == 1) return solve_lanes(hn::CappedTag<double, 1>(), limbs, 0, measures, solved);
  const hn::CappedTag<double, ik::kLimbLanes> d;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) solve_lanes(d, limbs, i, measures, solved);
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {
HWY_EXPORT(solve_all_limbs);
}

void ik::solve_limbs(const PlainLimbs& limbs, std::size_t count, bool measures, SolvedLimbs& solved) noexcept {
  HWY_DYNAMIC_DISPATCH(solve_all_limbs)(limbs, count, measures, solved);
}

}  // namespace sinew
#endif  // HWY_ONCE
