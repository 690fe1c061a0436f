// SPDX-License-Identifier: MIT
#include "runtime/graph/next_moment.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "runtime/graph/whole_division.h"

namespace sinew {
namespace {

/// Ticks until a motion has played this many rounds since it started.
GraphTicks until_played(const LiveMotion& motion, double rounds, GraphTicks horizon) noexcept {
  if (motion.period == 0) return 0;
  const std::int64_t step = std::abs(motion.step);
  double left;
  if (motion.loop) {
    const double whole = std::floor(rounds);
    double played = motion.state->rounds, phase = static_cast<double>(motion.state->position);
    if (motion.step < 0) {
      played = -played;
      phase = -phase;
    }
    left = (whole - played) * static_cast<double>(motion.period) +
           (std::round((rounds - whole) * static_cast<double>(motion.period)) - phase);
  } else {
    const std::int64_t played = motion.step < 0 ? motion.period - motion.state->position : motion.state->position;
    left = std::round(std::min(rounds, 1.0) * static_cast<double>(motion.period)) - static_cast<double>(played);
  }
  if (left <= 0.0) return 0;
  if (step == 0 || left > static_cast<double>(step) * static_cast<double>(horizon)) return kNever;
  return divided_up(static_cast<std::int64_t>(left), step);
}

/// Ticks, at least `earliest`, until a motion passes a phase.
GraphTicks until_phase(const LiveMotion& motion, double phase, GraphTicks earliest, GraphTicks horizon) noexcept {
  if (motion.period == 0 || motion.step == 0 || earliest > horizon) return kNever;
  const std::int64_t sign = motion.step < 0 ? -1 : 1, step = motion.step * sign;
  const std::int64_t place = motion.state->position * sign;
  std::int64_t target = nearest_whole(phase * static_cast<double>(motion.period)) * sign;
  const std::int64_t before = place + step * (earliest - 1);
  if (motion.loop)
    target += (divided_down(before - target, motion.period) + 1) * motion.period;
  else if (target <= before)
    return kNever;
  return divided_up(target - place, step);
}

/// Finds the transition that is taken first among candidates.
class Choice {
 public:
  Choice(const LiveGraph& live, std::span<const LiveMotion> motions, GraphTicks horizon) noexcept
      : live_(live), motions_(motions), horizon_(horizon) {}

  /// Candidates: transitions [first, first + count) of a state that plays in `slot`. They can be taken from tick
  /// `earliest` on, and before tick `end`.
  struct List {
    std::size_t first, count;
    const SlotState* slot;
    std::uint16_t driver;
    GraphTicks earliest, end;
    int rank;                                 ///< at the same moment, lists with smaller rank win
    GraphIndex not_to;                        ///< transitions to this state are skipped
    const GraphTransition* before = nullptr;  ///< if set, only transitions with a smaller priority count
    bool may_enter_itself = false;
  };

  void consider(const List& list) noexcept {
    for (std::size_t i = list.first; i < list.first + list.count; ++i) {
      const GraphTransition& t = live_.tables().transitions[i];
      if (t.to == list.not_to && !(list.may_enter_itself && t.to_self)) continue;
      if (list.before != nullptr && t.priority >= list.before->priority) continue;
      const GraphTicks in = ready_in(t, list);
      if (in > horizon_ || in >= list.end) continue;
      // Of transitions with equal time, rank and priority, the last wins.
      if (next_.transition == kNoGraphIndex ||
          std::tuple(in, list.rank, t.priority) <= std::tuple(next_.in, rank_, priority_)) {
        next_ = {in, static_cast<GraphIndex>(i), list.slot->state, t.to};
        rank_ = list.rank;
        priority_ = t.priority;
      }
    }
  }

  const NextTransition& next() const noexcept { return next_; }

 private:
  GraphTicks ready_in(const GraphTransition& t, const List& list) const noexcept {
    GraphTicks in = list.earliest;
    const GraphCondition* phase = nullptr;
    for (std::size_t c = 0; c < t.condition_count; ++c) {
      const GraphCondition& condition = live_.tables().conditions[t.first_condition + c];
      if (condition.kind == GraphConditionKind::phase)
        phase = &condition;
      else
        in = std::max(in, holds_in(condition, list));
      if (in > horizon_) return kNever;
    }
    if (phase == nullptr) return in;
    return list.driver == kNoMotion ? kNever
                                    : until_phase(motions_[list.driver], decimal_of(phase->value), in, horizon_);
  }

  GraphTicks holds_in(const GraphCondition& condition, const List& list) const noexcept {
    switch (condition.kind) {
      case GraphConditionKind::time_in_state:
        return std::max(GraphTicks{0}, ticks_of(decimal_of(condition.value)) - list.slot->time);
      case GraphConditionKind::played:
        if (list.driver == kNoMotion) return 0;
        return until_played(motions_[list.driver], decimal_of(condition.value), horizon_);
      default: return holds_now(live_, condition) ? 0 : kNever;
    }
  }

  const LiveGraph& live_;
  std::span<const LiveMotion> motions_;
  GraphTicks horizon_;
  NextTransition next_;
  int rank_ = 0;
  std::int32_t priority_ = 0;
};

/// The transition for request_state: the transition with the smallest priority that leads to the state, regardless of
/// conditions.
NextTransition asked_for(const LiveGraph& live, const LiveMachine& machine, GraphIndex asked) noexcept {
  const GraphMachine& m = *machine.machine;
  const SlotState& top = machine.slots.top();
  NextTransition next{0, kNoGraphIndex, top.state, asked};
  std::int32_t priority = 0;
  const auto consider = [&](std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i) {
      const GraphTransition& t = live.tables().transitions[i];
      if (asked != kNextState && t.to != asked) continue;
      if (next.transition != kNoGraphIndex && t.priority > priority) continue;
      next.transition = static_cast<GraphIndex>(i);
      next.to = t.to;
      priority = t.priority;
    }
  };
  const GraphMachineState& state = live.tables().states[m.first_state + top.state];
  consider(state.first_transition, state.transition_count);
  if (next.transition == kNoGraphIndex && asked != kNextState) consider(m.first_any, m.any_count);
  if (next.to == kNextState) next.in = kNever;
  return next;
}

}  // namespace

bool holds_now(const LiveGraph& live, const GraphCondition& condition) noexcept {
  switch (condition.kind) {
    case GraphConditionKind::above: return live.value_of(condition.parameter) > condition.value;
    case GraphConditionKind::below: return live.value_of(condition.parameter) < condition.value;
    case GraphConditionKind::equal: return live.value_of(condition.parameter) == condition.value;
    case GraphConditionKind::not_equal: return live.value_of(condition.parameter) != condition.value;
    case GraphConditionKind::on: return live.value_of(condition.parameter) != 0.0f;
    case GraphConditionKind::off: return live.value_of(condition.parameter) == 0.0f;
    case GraphConditionKind::trigger: return (live.header().triggers >> condition.parameter & 1u) != 0;
    default: return false;
  }
}

NextTransition next_transition(const LiveGraph& live, std::span<const LiveMotion> motions, const LiveMachine& machine,
                               GraphTicks horizon) noexcept {
  const GraphHeader& header = live.header();
  if (header.asked_machine == machine.node) return asked_for(live, machine, header.asked_state);
  const GraphMachine& m = *machine.machine;
  const std::size_t depth = machine.slots.depth();
  const SlotState& top = machine.slots.top();
  const GraphMachineState& target = live.tables().states[m.first_state + top.state];
  const bool entered = top.transition != kNoGraphIndex;
  const GraphTicks stays = entered ? std::max(GraphTicks{0}, kShortestStay - top.time) : 0;

  Choice choice(live, motions, horizon);
  Choice::List own{target.first_transition,
                   target.transition_count,
                   &top,
                   machine.driver[depth - 1],
                   stays,
                   kNever,
                   0,
                   kNoGraphIndex};
  Choice::List any{m.first_any, m.any_count, &top, machine.driver[depth - 1], stays, kNever, 0, top.state};
  any.may_enter_itself = true;
  if (depth > 1 && top.whole == 0) {
    const GraphTransition& current = live.tables().transitions[top.transition];
    const GraphTicks left = live.duration_of(top) - top.time;
    const GraphInterruption by = current.interruption;
    const bool from_source = by == GraphInterruption::source || by == GraphInterruption::source_then_target ||
                             by == GraphInterruption::target_then_source;
    if (by == GraphInterruption::none) any.earliest = std::max(any.earliest, left);
    if (by == GraphInterruption::none || by == GraphInterruption::source) own.earliest = std::max(own.earliest, left);
    if (by == GraphInterruption::source_then_target) own.rank = 2;
    if (any.count > 0) choice.consider(any);
    std::size_t below = depth - 1;  // slot of the source state, plus one
    while (below > machine.first && machine.slots.slot(below - 1).state != top.from) --below;
    if (from_source && below > machine.first) {
      const GraphMachineState& source = live.tables().states[m.first_state + top.from];
      const int rank = by == GraphInterruption::target_then_source ? 2 : 0;
      GraphTicks seen = left;  // ticks until a fade above the source ends and hides it
      for (std::size_t i = below; i < depth; ++i)
        if (const SlotState& slot = machine.slots.slot(i); slot.whole == 0)
          seen = std::min(seen, live.duration_of(slot) - slot.time);
      Choice::List list{source.first_transition,
                        source.transition_count,
                        &machine.slots.slot(below - 1),
                        machine.driver[below - 1],
                        stays,
                        seen,
                        rank,
                        top.state};
      if (current.ordered) list.before = &current;
      choice.consider(list);
    }
  } else if (any.count > 0) {
    choice.consider(any);
  }
  if (own.count > 0) choice.consider(own);
  return choice.next();
}

GraphTicks next_fade_end(const LiveGraph& live, const LiveMachine& machine) noexcept {
  GraphTicks next = kNever;
  bool lowest = true;  // no cut found yet; only the end of the lowest cut changes the slots
  for (std::size_t i = 1; i < machine.slots.depth(); ++i) {
    const SlotState& slot = machine.slots.slot(i);
    if (live.is_cut(slot) ? !lowest : i < machine.first || slot.whole != 0) continue;
    if (live.is_cut(slot)) lowest = false;
    next = std::min(next, std::max(GraphTicks{0}, live.duration_of(slot) - slot.time));
  }
  return next;
}

}  // namespace sinew
