// SPDX-License-Identifier: MIT
#include "runtime/graph/carry_state.h"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "runtime/graph/enter_state.h"
#include "runtime/graph/graph_values.h"
#include "runtime/graph/live_graph.h"
#include "runtime/graph/update_graph.h"
#include "runtime/graph/whole_division.h"

namespace sinew {
namespace {

/// The transitions that lead from a state of a machine (kNoGraphIndex: from any state).
struct Ways {
  std::size_t first = 0, count = 0;
};

Ways ways_from(const GraphTables& t, const GraphMachine& machine, GraphIndex state) noexcept {
  if (state == kNoGraphIndex) return {machine.first_any, machine.any_count};
  const GraphMachineState& s = t.states[machine.first_state + state];
  return {s.first_transition, s.transition_count};
}

/// A machine of one of the two graphs.
struct Side {
  const GraphTables& t;
  const GraphMachine& machine;
  MachineSlots slots;

  std::string_view name_of(GraphIndex state) const noexcept {
    return t.name_at(t.states[machine.first_state + state].name);
  }
  GraphIndex find(std::string_view name) const noexcept {
    for (GraphIndex s = 0; s < machine.state_count; ++s)
      if (name_of(s) == name) return s;
    return kNoGraphIndex;
  }
  GraphIndex node_of(GraphIndex state) const noexcept { return t.states[machine.first_state + state].node; }
};

class StateCarrier {
 public:
  explicit StateCarrier(const CarryStateJob& job) noexcept
      : values_(job.graph->tables(), job.parameters),
        from_(*job.from),
        old_(job.from->tables()),
        live_(*job.graph, *job.clips, values_.all(), job.state.data()),
        new_(job.graph->tables()),
        // The const_cast is safe, because only the new state is written.
        from_state_(const_cast<std::byte*>(job.from_state.data())) {}

  void carry() noexcept {
    carry_header();
    carry(old_.root, from_state_, new_.root, live_.state());
  }

 private:
  bool have_one_name(GraphIndex old_node, GraphIndex new_node) const noexcept {
    return old_.nodes[old_node].kind == new_.nodes[new_node].kind &&
           old_.name_at(old_.nodes[old_node].name) == new_.name_at(new_.nodes[new_node].name);
  }

  GraphIndex find_parameter(GraphIndex old_parameter) const noexcept {
    return live_.graph().find_parameter(old_.name_at(old_.parameters[old_parameter].name));
  }

  void carry_header() noexcept {
    const GraphHeader& before = block_at<GraphHeader>(from_state_);
    GraphHeader& header = live_.header();
    header.now = before.now;
    header.rest_s = before.rest_s;
    for (std::size_t p = 0; p < std::min(old_.parameters.size(), kMostGraphTriggers); ++p) {
      if ((before.triggers >> p & 1u) == 0) continue;
      const GraphIndex now = find_parameter(static_cast<GraphIndex>(p));
      if (now != kNoGraphIndex && new_.parameters[now].kind == GraphParameterKind::trigger)
        header.triggers |= std::uint64_t{1} << now;
    }
    if (before.asked_machine == kNoGraphIndex) return;
    const GraphIndex machine = live_.graph().find_node(old_.name_at(old_.nodes[before.asked_machine].name));
    if (machine == kNoGraphIndex || new_.nodes[machine].kind != GraphNodeKind::machine) return;
    GraphIndex state = kNextState;
    if (before.asked_state != kNextState) {
      const Side old_side = side(from_, before.asked_machine, from_state_), new_side = side(machine, live_.state());
      state = new_side.find(old_side.name_of(before.asked_state));
    }
    if (state == kNoGraphIndex) return;
    header.asked_machine = machine;
    header.asked_state = state;
  }

  /// Carries a node whose state in the new graph has just been started.
  void carry(GraphIndex old_node, std::byte* old_base, GraphIndex new_node, std::byte* new_base) noexcept {
    if (!have_one_name(old_node, new_node)) return;
    const std::size_t old_settings = old_.nodes[old_node].settings, settings = new_.nodes[new_node].settings;
    std::byte* const old_own = old_base + from_.offset_of(old_node);
    std::byte* const own = new_base + live_.graph().offset_of(new_node);
    switch (new_.nodes[new_node].kind) {
      case GraphNodeKind::clip:
        return carry_clip(old_.clips[old_settings], block_at<MotionState>(old_own), new_.clips[settings],
                          block_at<MotionState>(own));
      case GraphNodeKind::blend_space: block_at<MotionState>(own) = block_at<MotionState>(old_own); return;
      case GraphNodeKind::select: return carry_select(old_.selects[old_settings], old_own, new_.selects[settings], own);
      case GraphNodeKind::layers:
        return carry_layers(old_.layers[old_settings], old_base, new_.layers[settings], new_base);
      case GraphNodeKind::machine: return carry_machine(old_node, old_base, new_node, new_base);
      case GraphNodeKind::external: return;
    }
  }

  void carry_clip(const GraphClipNode& old_clip, const MotionState& before, const GraphClipNode& clip,
                  MotionState& now) noexcept {
    if (old_.name_at(old_.clip_names[old_clip.clip]) != new_.name_at(new_.clip_names[clip.clip])) return;
    const std::int64_t period = live_.clips().entries()[clip.clip].period;
    now = before;
    if (period == 0)
      now.position = 0;
    else if (clip.loop)
      now.position -= divided_down(now.position, period) * period;
    else
      now.position = std::clamp(now.position, std::int64_t{0}, period);
  }

  /// Keeps the choice, which the next update compares with the parameter. A state that a transition has frozen never
  /// changes its choice.
  void carry_select(const GraphSelect& old_select, std::byte* old_own, const GraphSelect& select,
                    std::byte* own) noexcept {
    const GraphIndex old_child = old_.children[old_select.first_child + block_at<SelectState>(old_own).child];
    for (GraphIndex i = 0; i < select.child_count; ++i) {
      const GraphIndex child = new_.children[select.first_child + i];
      if (!have_one_name(old_child, child)) continue;
      block_at<SelectState>(own).child = i;
      start_node(live_, child, own + sizeof(SelectState));
      return carry(old_child, old_own + sizeof(SelectState), child, own + sizeof(SelectState));
    }
  }

  void carry_layers(const GraphLayers& old_layers, std::byte* old_base, const GraphLayers& layers,
                    std::byte* new_base) noexcept {
    carry(old_layers.base, old_base, layers.base, new_base);
    for (std::size_t i = 0; i < layers.layer_count; ++i)
      for (std::size_t k = 0; k < old_layers.layer_count; ++k)
        carry(old_.layer_list[old_layers.first_layer + k].node, old_base, new_.layer_list[layers.first_layer + i].node,
              new_base);
  }

  Side side(const GraphDefinition& graph, GraphIndex node, std::byte* base) const noexcept {
    const GraphTables& t = graph.tables();
    const GraphIndex machine = t.nodes[node].settings;
    return {t,
            t.machines[machine],
            {base + graph.offset_of(node), graph.slot_bytes(machine), graph.largest_state(machine)}};
  }
  Side side(GraphIndex node, std::byte* base) const noexcept { return side(live_.graph(), node, base); }

  /// The transition of the new machine that stands for a transition of the old one. It has the same ends. Among
  /// transitions with the same ends it has the same number.
  GraphIndex find_transition(const Side& before, const Side& now, const SlotState& slot) const noexcept {
    if (slot.transition == kNoGraphIndex) return kNoGraphIndex;
    const auto is_among = [&](Ways ways) {
      return slot.transition >= ways.first && slot.transition - ways.first < ways.count;
    };
    GraphIndex old_from = slot.from;
    if (old_from == kNoGraphIndex || !is_among(ways_from(old_, before.machine, old_from))) old_from = kNoGraphIndex;
    const Ways old_ways = ways_from(old_, before.machine, old_from);
    if (!is_among(old_ways)) return kNoGraphIndex;
    const GraphIndex from = old_from == kNoGraphIndex ? kNoGraphIndex : now.find(before.name_of(old_from));
    if (old_from != kNoGraphIndex && from == kNoGraphIndex) return kNoGraphIndex;
    const GraphIndex to = now.find(before.name_of(old_.transitions[slot.transition].to));
    std::size_t alike = 0;
    for (std::size_t i = old_ways.first; i < slot.transition; ++i)
      alike += old_.transitions[i].to == old_.transitions[slot.transition].to;
    const Ways ways = ways_from(new_, now.machine, from);
    for (std::size_t i = ways.first; i < ways.first + ways.count; ++i)
      if (new_.transitions[i].to == to && alike-- == 0) return static_cast<GraphIndex>(i);
    return kNoGraphIndex;
  }

  void carry_machine(GraphIndex old_node, std::byte* old_base, GraphIndex new_node, std::byte* new_base) noexcept {
    const Side before = side(from_, old_node, old_base), now = side(new_node, new_base);
    if (now.find(before.name_of(before.slots.top().state)) == kNoGraphIndex) return;
    std::size_t first = 0;
    if (before.slots.depth() > now.machine.fades + std::size_t{1})
      first = before.slots.depth() - (now.machine.fades + std::size_t{1});
    now.slots.head().depth = 0;
    for (std::size_t i = first; i < before.slots.depth(); ++i) carry_slot(before, i, now);
  }

  /// Puts a slot on top of the new machine's slots.
  void carry_slot(const Side& before, std::size_t index, const Side& now) noexcept {
    const SlotState& old_slot = before.slots.slot(index);
    const GraphIndex state = now.find(before.name_of(old_slot.state));
    if (state == kNoGraphIndex) return;
    SlotState slot = old_slot;
    slot.state = state;
    slot.transition = find_transition(before, now, old_slot);
    slot.from = old_slot.from == kNoGraphIndex ? kNoGraphIndex : now.find(before.name_of(old_slot.from));
    const bool fades = old_slot.whole == 0 && slot.transition != kNoGraphIndex &&
                       old_.transitions[old_slot.transition].kind == new_.transitions[slot.transition].kind;
    // A state that covers those below it in full still lies above the cuts among them.
    if (now.slots.depth() == 0 || !(fades || old_slot.whole != 0)) {
      slot.whole = 1;
      now.slots.head().depth = 0;
    }
    const std::size_t to = now.slots.depth();
    now.slots.head().depth = static_cast<std::uint16_t>(to + 1);
    now.slots.slot(to) = slot;
    carry_node(before, before.slots.inside(index), old_slot.state, now, now.slots.inside(to), state);
    if (slot.whole != 0 || new_.transitions[slot.transition].kind == GraphTransitionKind::cross_fade) return;
    carry_node(before, before.slots.started(index), old_slot.state, now, now.slots.started(to), state);
    for (std::size_t p = 0; p < new_.parameters.size(); ++p) now.slots.started_parameters(to)[p] = values_.all()[p];
    for (std::size_t p = 0; p < old_.parameters.size(); ++p)
      if (const GraphIndex now_p = find_parameter(static_cast<GraphIndex>(p)); now_p != kNoGraphIndex)
        now.slots.started_parameters(to)[now_p] = before.slots.started_parameters(index)[p];
  }

  /// Starts the node of a state and carries what plays in it.
  void carry_node(const Side& before, std::byte* old_base, GraphIndex old_state, const Side& now, std::byte* base,
                  GraphIndex state) noexcept {
    std::memset(base, 0, now.slots.largest_state);
    start_node(live_, now.node_of(state), base);
    carry(before.node_of(old_state), old_base, now.node_of(state), base);
  }

  GraphValues values_;
  const GraphDefinition& from_;
  const GraphTables& old_;
  LiveGraph live_;  // of the new graph; its lists are not used
  const GraphTables& new_;
  std::byte* from_state_;
};

}  // namespace

ErrorCode check(const CarryStateJob& job) noexcept {
  if (job.from == nullptr || job.from_state.size() < job.from->state_bytes()) return ErrorCode::size_mismatch;
  if (reinterpret_cast<std::uintptr_t>(job.from_state.data()) % alignof(GraphHeader) != 0)
    return ErrorCode::size_mismatch;
  if (reinterpret_cast<const GraphHeader*>(job.from_state.data())->signature != job.from->signature())
    return ErrorCode::wrong_plan;
  return check(StartGraphJob{job.graph, job.clips, job.parameters, job.state});
}

void run_unchecked(const CarryStateJob& job) noexcept {
  run_unchecked(StartGraphJob{job.graph, job.clips, job.parameters, job.state});
  StateCarrier(job).carry();
}

}  // namespace sinew
