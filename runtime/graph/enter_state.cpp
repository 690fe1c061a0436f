// SPDX-License-Identifier: MIT
#include "runtime/graph/enter_state.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "runtime/graph/start_in_sync.h"

namespace sinew {
namespace {

std::int64_t wrapped(std::int64_t position, std::int64_t period) noexcept {
  if (period == 0) return 0;
  const std::int64_t rest = position % period;
  return rest < 0 ? rest + period : rest;
}

void start_clip(const LiveGraph& live, const GraphClipNode& clip, MotionState& state) noexcept {
  const std::int64_t period = live.clips().entries()[clip.clip].period;
  const double offset = std::round(decimal_of(clip.offset_s) * static_cast<double>(kTicksPerSecond));
  const double most = static_cast<double>(kNever >> kClipBits);
  const std::int64_t position =
      static_cast<std::int64_t>(std::clamp(offset, -most, most)) * (std::int64_t{1} << kClipBits);
  state = {};
  state.position = clip.loop ? wrapped(position, period) : std::clamp(position, std::int64_t{0}, period);
}

/// The first entry rule that holds now.
GraphIndex entry_of(const LiveGraph& live, const GraphMachine& machine) noexcept {
  const GraphTables& t = live.tables();
  const auto holds = [&](const GraphTransition& rule) {
    for (std::size_t c = 0; c < rule.condition_count; ++c)
      if (!holds_now(live, t.conditions[rule.first_condition + c])) return false;
    return true;
  };
  const GraphTransition* best = nullptr;
  for (std::size_t i = 0; i < machine.entry_count; ++i) {
    const GraphTransition& rule = t.transitions[machine.first_entry + i];
    if ((best == nullptr || rule.priority <= best->priority) && holds(rule)) best = &rule;
  }
  return best == nullptr ? machine.initial : best->to;
}

void enter(const LiveGraph& live, const GraphMachine& machine, const MachineSlots& slots, std::size_t index,
           const SlotState& slot) noexcept {
  slots.slot(index) = slot;
  start_node(live, live.tables().states[machine.first_state + slot.state].node, slots.inside(index));
}

/// Forgets slots [first, first + count).
void forget(const MachineSlots& slots, std::size_t first, std::size_t count) noexcept {
  const std::size_t behind = first + count;
  std::memmove(slots.at(first), slots.at(behind), (slots.depth() - behind) * slots.stride);
  slots.head().depth = static_cast<std::uint16_t>(slots.depth() - count);
  if (first == 0) slots.slot(0).whole = 1;
}

std::size_t slot_that_weighs_least(const LiveGraph& live, const MachineSlots& slots) noexcept {
  if (live.first_playing(slots, slots.depth()) > 0) return 0;  // its offset has decayed most
  std::size_t least = 0;
  float rest = 1.0f, lowest = 2.0f;
  for (std::size_t i = slots.depth(); i-- > 0;) {
    const float fade = i == 0 ? 1.0f : live.fade_of(slots.slot(i), 0);
    if (rest * fade < lowest && i + 1 < slots.depth()) {
      lowest = rest * fade;
      least = i;
    }
    rest *= 1.0f - fade;
  }
  return least;
}

}  // namespace

void start_node(const LiveGraph& live, GraphIndex node, std::byte* base) noexcept {
  const GraphTables& t = live.tables();
  const std::size_t s = t.nodes[node].settings;
  std::byte* const own = base + live.graph().offset_of(node);
  switch (t.nodes[node].kind) {
    case GraphNodeKind::clip: return start_clip(live, t.clips[s], block_at<MotionState>(own));
    case GraphNodeKind::blend_space: block_at<MotionState>(own) = {}; return;
    case GraphNodeKind::select: {
      block_at<SelectState>(own) = {.child = live.choice_of(t.selects[s])};
      return start_node(live, t.children[t.selects[s].first_child + block_at<SelectState>(own).child],
                        own + sizeof(SelectState));
    }
    case GraphNodeKind::layers: {
      start_node(live, t.layers[s].base, base);
      for (std::size_t i = 0; i < t.layers[s].layer_count; ++i)
        start_node(live, t.layer_list[t.layers[s].first_layer + i].node, base);
      return;
    }
    case GraphNodeKind::machine: {
      const MachineSlots slots = live.slots_of(node, base);
      slots.head() = {.depth = 1};
      return enter(live, t.machines[s], slots, 0, {.state = entry_of(live, t.machines[s]), .whole = 1});
    }
    case GraphNodeKind::external: return;
  }
}

bool follow_choices(const LiveGraph& live, GraphIndex node, std::byte* base) noexcept {
  const GraphTables& t = live.tables();
  const std::size_t s = t.nodes[node].settings;
  bool changed = false;
  switch (t.nodes[node].kind) {
    case GraphNodeKind::select: {
      std::byte* const own = base + live.graph().offset_of(node);
      SelectState& state = block_at<SelectState>(own);
      if (live.choice_of(t.selects[s]) != state.child) {
        start_node(live, node, base);
        return true;
      }
      return follow_choices(live, t.children[t.selects[s].first_child + state.child], own + sizeof(SelectState));
    }
    case GraphNodeKind::layers: {
      changed = follow_choices(live, t.layers[s].base, base);
      for (std::size_t i = 0; i < t.layers[s].layer_count; ++i)
        changed |= follow_choices(live, t.layer_list[t.layers[s].first_layer + i].node, base);
      return changed;
    }
    case GraphNodeKind::machine: {
      const MachineSlots slots = live.slots_of(node, base);
      for (std::size_t i = live.first_playing(slots, slots.depth()); i < slots.depth(); ++i)
        changed |=
            follow_choices(live, t.states[t.machines[s].first_state + slots.slot(i).state].node, slots.inside(i));
      return changed;
    }
    default: return false;
  }
}

void take_transition(const LiveGraph& live, const LiveMachine& machine, const NextTransition& next,
                     std::uint64_t& triggers) noexcept {
  const GraphTables& t = live.tables();
  const MachineSlots& slots = machine.slots;
  SlotState slot{.state = next.to, .transition = next.transition, .from = next.from};
  GraphTicks duration = 0;
  GraphSync sync = GraphSync::none;
  auto kind = GraphTransitionKind::cross_fade;
  if (next.transition != kNoGraphIndex) {
    const GraphTransition& transition = t.transitions[next.transition];
    duration = live.graph().duration_of(next.transition);
    sync = transition.sync;
    kind = live.kind_of(transition);
    for (std::size_t c = 0; c < transition.condition_count; ++c) {
      const GraphCondition& condition = t.conditions[transition.first_condition + c];
      if (condition.kind == GraphConditionKind::trigger) triggers |= std::uint64_t{1} << condition.parameter;
    }
  }
  SyncSource source;  // found first, since entering may drop the slot of the state that is left
  if (sync != GraphSync::none)
    source = find_sync_source(live, t.states[machine.machine->first_state + slots.top().state].node,
                              slots.inside(slots.depth() - 1));
  if (duration == 0 || machine.machine->fades == 0) {
    slots.head().depth = 0;
    slot.whole = 1;
  } else if (slots.depth() > machine.machine->fades) {
    forget(slots, slot_that_weighs_least(live, slots), 1);
  }
  const std::size_t index = slots.depth();
  slots.head().depth = static_cast<std::uint16_t>(index + 1);
  enter(live, *machine.machine, slots, index, slot);
  if (sync != GraphSync::none)
    start_in_sync(live, t.states[machine.machine->first_state + slot.state].node, slots.inside(index), source,
                  t.transitions[next.transition].start_by);
  if (slot.whole == 0 && kind != GraphTransitionKind::cross_fade) {
    std::memcpy(slots.started(index), slots.inside(index), slots.largest_state);
    for (std::size_t p = 0; p < t.parameters.size(); ++p)
      slots.started_parameters(index)[p] = live.value_of(static_cast<GraphIndex>(p));
  }
}

bool end_fades(const LiveGraph& live, const LiveMachine& machine) noexcept {
  const MachineSlots& slots = machine.slots;
  const auto is_over = [&](const SlotState& slot) { return slot.whole == 0 && slot.time >= live.duration_of(slot); };
  for (std::size_t i = slots.depth(); i-- > machine.first + 1;) {
    if (!is_over(slots.slot(i))) continue;
    slots.slot(i).whole = 1;
    // A cut stays in its slot, below the state that now covers it.
    const std::size_t kept = machine.first == 0 ? 0 : machine.first + 1;
    if (i > kept) forget(slots, kept, i - kept);
    return true;
  }
  for (std::size_t i = 1; i < slots.depth(); ++i) {
    if (!live.is_cut(slots.slot(i))) continue;
    if (!is_over(slots.slot(i))) return false;
    forget(slots, 0, i);
    return true;
  }
  return false;
}

}  // namespace sinew
