// SPDX-License-Identifier: MIT
#include "runtime/procedures/springs/spring_ticks.h"

#include <algorithm>

#include "runtime/procedures/springs/spring_collisions.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/procedures/springs/spring_ticks.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "runtime/procedures/springs/matrix_frames-inl.h"
#include "runtime/procedures/springs/spring_collisions-inl.h"
#include "runtime/procedures/springs/uniform_frames-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

using springs::Planes, springs::SpringSlots, springs::Ticks;

using Lanes = hn::CappedTag<double, springs::kSpringLanes>;
using Numbers = hn::Vec<Lanes>;
using Lines = Vector<Lanes>;
using Flags = hn::Mask<Lanes>;

/// Reads the frames of any slots. Frames that are the same or side by side, as most are, need no gather.
template <class Frames>
HWY_INLINE Frames frames_at(Planes<const double> frames, const std::int64_t* slots, std::size_t lanes) {
  const Lanes d;
  const hn::RebindToSigned<Lanes> di;
  const auto at = hn::LoadU(di, slots), first = hn::Set(di, slots[0]);
  const auto is_unused = hn::Not(hn::FirstN(di, lanes));
  const double* base = frames.data + slots[0];
  if (hn::AllTrue(di, hn::Or(is_unused, hn::Eq(at, hn::Add(first, hn::Iota(di, 0))))))
    return Frames::read_planes([&](std::size_t p) HWY_ATTR { return hn::LoadU(d, base + p * frames.stride); });
  if (hn::AllTrue(di, hn::Or(is_unused, hn::Eq(at, first))))
    return Frames::read_planes([&](std::size_t p) HWY_ATTR { return hn::Set(d, base[p * frames.stride]); });
  return Frames::read_planes([&](std::size_t p) HWY_ATTR { return hn::GatherIndex(d, frames.plane(p), at); });
}

/// One vector of joints at their goals.
template <class Frames>
struct Goals {
  std::size_t slot;   ///< of the first lane
  std::size_t lanes;  ///< lanes of this depth
  Flags swings;       ///< lanes of this depth that swing
  Frames above, goal;
  Lines scale, bone, axis;  ///< JointInput
};

template <class Frames>
class LaneTicks {
 public:
  explicit LaneTicks(const Ticks& ticks) : ticks_(ticks), memory_(ticks.memory), slots_(ticks.tables.slots) {}

  void reset() {
    for_each([&](const Goals<Frames>& at) HWY_ATTR {
      const Lines end = at.goal.point(d_, at.bone), tail = to_center(at, end);
      store_vector(d_, tail, memory_.tails, springs::tail::before, at.slot);
      store_vector(d_, tail, memory_.tails, springs::tail::now, at.slot);
      if (slots_.has_lagging)
        store_vector(d_, frames_of_chains(at).local_point(d_, end), memory_.tails, springs::tail::end, at.slot);
      return at.goal;
    });
  }

  bool tick(double threshold, bool shows) {
    Flags moves = hn::FirstN(d_, 0);
    for_each([&](const Goals<Frames>& at) HWY_ATTR {
      namespace constant = springs::constant;
      const Lines now = tail(springs::tail::now, at), before = tail(springs::tail::before, at);
      const Numbers bone_length = at.goal.length_of(d_, at.bone, input(springs::input::length, at));
      const Lines axis = at.goal.direction_along(d_, at.bone, at.axis);
      const Numbers length = slots_.has_lagging ? lagging_length(at, bone_length) : bone_length;
      const Lines ahead =
          to_world(at, plus<Lanes>(now, times<Lanes>(minus<Lanes>(now, before), number(constant::kept, at))));
      const Lines pulled = plus<Lanes>(plus<Lanes>(ahead, times<Lanes>(axis, number(constant::pull, at))),
                                       load_vector(d_, constants(), constant::gravity, at.slot));
      Lines along = direction_or<Lanes>(d_, minus<Lanes>(pulled, at.goal.at), axis);
      Lines next = plus<Lanes>(at.goal.at, times<Lanes>(along, length));
      if (slots_.has_colliders)
        keep_out(d_, ticks_.tables, memory_.shapes, number(constant::group, at), at.swings,
                 number(constant::hit_radius, at), {at.goal.at, axis, length}, along, next);
      const auto turned = swung(d_, at.above, at.goal, goal_rotation(at), at.axis, axis, along);
      const Lines result = to_center(at, next), step = minus<Lanes>(result, now);
      store_vector(d_, result, memory_.next, springs::tail::now - springs::tail::now, at.slot);
      if (slots_.has_lagging)
        store_vector(d_, frames_of_chains(at).local_point(d_, turned.frame.point(d_, at.bone)), memory_.next,
                     springs::tail::end - springs::tail::now, at.slot);
      const Numbers most = hn::Mul(hn::Set(d_, threshold), hn::Mul(bone_length, bone_length));
      moves = hn::Or(moves, hn::AndNot(hn::Le(dot<Lanes>(step, step), most), at.swings));
      if (shows) show(at, turned.local, plus<Lanes>(at.goal.at, times<Lanes>(along, bone_length)));
      return turned.frame;
    });
    return !hn::AllFalse(d_, moves);
  }

  void show_between(double fraction) {
    for_each([&](const Goals<Frames>& at) HWY_ATTR {
      Lines now = tail(springs::tail::now, at);
      if (fraction != 0.0) {
        const Lines next = load_vector(d_, Planes<const double>{memory_.next.data, memory_.next.stride}, 0, at.slot);
        now = plus<Lanes>(times<Lanes>(now, hn::Set(d_, 1.0 - fraction)), times<Lanes>(next, hn::Set(d_, fraction)));
      }
      const Lines from_head = minus<Lanes>(to_world(at, now), at.goal.at);
      const Lines local = direction_or<Lanes>(d_, at.goal.local_direction(d_, from_head), at.axis);
      const Rotation<Lanes> swing = shortest_turn<Lanes>(d_, at.axis, local);
      const Numbers length = at.goal.length_of(d_, at.bone, input(springs::input::length, at));
      const Lines along = direction_or<Lanes>(d_, from_head, at.goal.direction_along(d_, at.bone, at.axis));
      show(at, product<Lanes>(goal_rotation(at), swing), plus<Lanes>(at.goal.at, times<Lanes>(along, length)));
      return at.goal.turned(d_, swing);
    });
  }

 private:
  /// Calls swing(goals) for all joints, parents first. swing returns the frames of the joints that swing.
  template <class Swing>
  HWY_INLINE void for_each(const Swing& swing) {
    for (std::size_t depth = 0; depth + 1 < slots_.depths.size(); ++depth)
      for (std::size_t s = slots_.depths[depth], end = slots_.depths[depth + 1]; s < end; s += hn::Lanes(d_)) {
        Goals<Frames> at;
        at.slot = s;
        at.lanes = HWY_MIN(end - s, hn::Lanes(d_));
        at.swings = hn::And(hn::FirstN(d_, at.lanes), hn::Gt(number(springs::constant::swings, at), hn::Zero(d_)));
        at.above = frames_at<Frames>(frames(), slots_.parent.data() + s, at.lanes);
        at.scale = load_vector(d_, ticks_.inputs, springs::input::scale, s);
        at.bone = load_vector(d_, ticks_.inputs, springs::input::bone, s);
        at.axis = load_vector(d_, ticks_.inputs, springs::input::axis, s);
        at.goal = at.above.child(d_, load_vector(d_, ticks_.inputs, springs::input::translation, s), goal_rotation(at));
        const Frames frame = swing(at).or_else(at.swings, at.goal).scaled_by(at.scale);
        frame.write_planes([&](std::size_t p, Numbers lanes)
                               HWY_ATTR { hn::StoreU(lanes, d_, memory_.frames.plane(p) + s); });
      }
  }

  /// Distances of the new heads from the tails of the tick before, or the lengths of bones that do not lag.
  HWY_INLINE Numbers lagging_length(const Goals<Frames>& at, Numbers bone_length) const {
    const Lines end = frames_of_chains(at).point(d_, tail(springs::tail::end, at)),
                bone = minus<Lanes>(end, at.goal.at);
    const Flags lags = hn::Gt(number(springs::constant::lagging, at), hn::Zero(d_));
    return hn::IfThenElse(lags, hn::Sqrt(dot<Lanes>(bone, bone)), bone_length);
  }

  /// Writes rotations and ends of bones. A joint that is carried along keeps its goal.
  HWY_INLINE void show(const Goals<Frames>& at, const Rotation<Lanes>& local, const Lines& end) const {
    const Rotation<Lanes> goal = goal_rotation(at);
    const Planes<double>& shown = memory_.shown;
    store_vector(d_, either<Lanes>(at.swings, {local.x, local.y, local.z}, {goal.x, goal.y, goal.z}), shown,
                 springs::shown::rotation, at.slot);
    hn::StoreU(hn::IfThenElse(at.swings, local.w, goal.w), d_, shown.plane(springs::shown::rotation + 3) + at.slot);
    store_vector(d_, either<Lanes>(at.swings, end, at.goal.at), shown, springs::shown::end, at.slot);
  }

  HWY_INLINE Planes<const double> frames() const { return {memory_.frames.data, memory_.frames.stride}; }
  HWY_INLINE Planes<const double> constants() const { return {slots_.constants.data(), slots_.stride}; }
  HWY_INLINE Numbers number(std::size_t plane, const Goals<Frames>& at) const {
    return hn::LoadU(d_, constants().plane(plane) + at.slot);
  }
  HWY_INLINE Numbers input(std::size_t plane, const Goals<Frames>& at) const {
    return hn::LoadU(d_, ticks_.inputs.plane(plane) + at.slot);
  }
  HWY_INLINE Lines tail(std::size_t plane, const Goals<Frames>& at) const {
    return load_vector(d_, Planes<const double>{memory_.tails.data, memory_.tails.stride}, plane, at.slot);
  }
  HWY_INLINE Rotation<Lanes> goal_rotation(const Goals<Frames>& at) const {
    return load_rotation(d_, ticks_.inputs, springs::input::goal, at.slot);
  }
  HWY_INLINE Frames frames_of_chains(const Goals<Frames>& at) const {
    return frames_at<Frames>(frames(), slots_.frame.data() + at.slot, at.lanes);
  }
  HWY_INLINE Frames centers(const Goals<Frames>& at) const {
    return frames_at<Frames>(frames(), slots_.center.data() + at.slot, at.lanes);
  }
  HWY_INLINE Lines to_world(const Goals<Frames>& at, const Lines& p) const {
    return slots_.has_centers ? centers(at).point(d_, p) : p;
  }
  HWY_INLINE Lines to_center(const Goals<Frames>& at, const Lines& p) const {
    return slots_.has_centers ? centers(at).local_point(d_, p) : p;
  }

  static constexpr Lanes d_{};
  const Ticks& ticks_;
  const SpringMemory& memory_;
  const SpringSlots& slots_;
};

void reset_in_lanes(const Ticks& ticks) {
  ticks.is_uniform ? LaneTicks<UniformFrames<Lanes>>(ticks).reset() : LaneTicks<MatrixFrames<Lanes>>(ticks).reset();
}
bool tick_in_lanes(const Ticks& ticks, double threshold, bool shows) {
  return ticks.is_uniform ? LaneTicks<UniformFrames<Lanes>>(ticks).tick(threshold, shows)
                          : LaneTicks<MatrixFrames<Lanes>>(ticks).tick(threshold, shows);
}
void show_in_lanes(const Ticks& ticks, double fraction) {
  ticks.is_uniform ? LaneTicks<UniformFrames<Lanes>>(ticks).show_between(fraction)
                   : LaneTicks<MatrixFrames<Lanes>>(ticks).show_between(fraction);
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {
HWY_EXPORT(reset_in_lanes);
HWY_EXPORT(tick_in_lanes);
HWY_EXPORT(show_in_lanes);
}  // namespace

namespace springs {

void place_inputs(const Ticks& ticks, const FrameWeights& weights) noexcept {
  const SpringMemory& memory = ticks.memory;
  const std::size_t identity = ticks.tables.slots.identity();
  for (std::size_t f = 0; f < identity; ++f) {
    const InputFrame frame = interpolated(memory.earlier[f], memory.before[f], memory.now[f], weights);
    place(frame, ticks.is_uniform, memory.frames, f);
    if (!memory.shapes.empty()) memory.matrices[f] = matrix_of(frame);
  }
  place({}, ticks.is_uniform, memory.frames, identity);
  for (std::size_t c = 0; c < memory.shapes.size(); ++c) {
    const SpringColliderRecord& collider = ticks.tables.colliders[c];
    memory.shapes[c] = world_shape(collider.shape, memory.matrices[collider.frame]);
  }
}

void reset_tails(const Ticks& ticks) noexcept { HWY_DYNAMIC_DISPATCH(reset_in_lanes)(ticks); }
bool run_tick(const Ticks& ticks, double threshold, bool shows) noexcept {
  return HWY_DYNAMIC_DISPATCH(tick_in_lanes)(ticks, threshold, shows);
}
void show_tails(const Ticks& ticks, double fraction) noexcept { HWY_DYNAMIC_DISPATCH(show_in_lanes)(ticks, fraction); }

void commit_tick(const Ticks& ticks) noexcept {
  const Planes<double>&tails = ticks.memory.tails, &next = ticks.memory.next;
  std::copy_n(tails.plane(tail::now), 3 * tails.stride, tails.plane(tail::before));
  std::copy_n(next.plane(0), (ticks.tables.slots.has_lagging ? 6 : 3) * tails.stride, tails.plane(tail::now));
}

}  // namespace springs
}  // namespace sinew
#endif  // HWY_ONCE
