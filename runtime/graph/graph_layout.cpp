// SPDX-License-Identifier: MIT
#include "runtime/graph/graph_layout.h"

#include <algorithm>
#include <cstddef>

#include "runtime/graph/state_blocks.h"

namespace sinew {
namespace {

/// Cap for sizes: larger numbers exceed every limit anyway.
constexpr std::uint32_t kTooMany = 1u << 20;

std::uint32_t product(std::uint32_t a, std::uint32_t b) noexcept {
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(std::uint64_t{a} * b, kTooMany));
}

class Layouter {
 public:
  explicit Layouter(const GraphTables& tables) : t_(tables) {
    layout_.offsets.resize(tables.nodes.size());
    layout_.largest_states.resize(tables.machines.size());
    layout_.slot_bytes.resize(tables.machines.size());
  }

  GraphLayout layout() {
    layout_.demand = place(t_.root, sizeof(GraphHeader));
    layout_.demand.bytes += sizeof(GraphHeader);
    return std::move(layout_);
  }

 private:
  GraphDemand place(GraphIndex node, std::uint32_t offset) {
    layout_.offsets[node] = offset;
    const std::size_t s = t_.nodes[node].settings;
    switch (t_.nodes[node].kind) {
      case GraphNodeKind::clip: return {sizeof(MotionState), 1, 1, 1, 0, 0, false};
      case GraphNodeKind::blend_space: {
        const std::uint32_t points = t_.spaces[s].point_count;
        return {sizeof(MotionState), points, points, points, 0, 0, false};
      }
      case GraphNodeKind::select: return place_select(t_.selects[s]);
      case GraphNodeKind::layers: return place_layers(t_.layers[s], offset);
      case GraphNodeKind::machine: return place_machine(s);
      case GraphNodeKind::external: break;
    }
    return {0, 1, 1, 1, 0, 0, false};
  }

  static void take_larger(GraphDemand& most, const GraphDemand& other) {
    most.bytes = std::max(most.bytes, other.bytes);
    most.ops = std::max(most.ops, other.ops);
    most.operands = std::max(most.operands, other.operands);
    most.slots = std::max(most.slots, other.slots);
    most.machines = std::max(most.machines, other.machines);
    most.kept = std::max(most.kept, other.kept);
    most.in_model_space |= other.in_model_space;
  }

  GraphDemand place_select(const GraphSelect& select) {
    GraphDemand most;
    for (std::size_t i = 0; i < select.child_count; ++i)
      take_larger(most, place(t_.children[select.first_child + i], 0));
    most.bytes += sizeof(SelectState);
    return most;
  }

  GraphDemand place_layers(const GraphLayers& layers, std::uint32_t offset) {
    GraphDemand all = place(layers.base, offset);
    ++all.ops;
    for (std::size_t i = 0; i < layers.layer_count; ++i) {
      const GraphLayer& layer = t_.layer_list[layers.first_layer + i];
      const GraphDemand one = place(layer.node, offset + all.bytes);
      all.bytes += one.bytes;
      all.ops = std::min(all.ops + one.ops + 2, kTooMany);
      all.slots = std::max(all.slots, one.slots + 1);
      all.machines += one.machines;
      all.kept += one.kept;
      all.in_model_space |= one.in_model_space || layer.kind == GraphLayerKind::overlay_model;
    }
    all.operands = 1;
    return all;
  }

  /// Kind of transition that needs most room: inertialize if the machine has any, else dead_blend, else cross_fade.
  GraphTransitionKind most_demanding_kind(const GraphMachine& machine) const {
    auto most = GraphTransitionKind::cross_fade;
    const auto look = [&](std::size_t first, std::size_t count) {
      for (std::size_t i = first; i < first + count; ++i) {
        const GraphTransitionKind kind = t_.transitions[i].kind;
        if (kind != GraphTransitionKind::cross_fade && most != GraphTransitionKind::inertialize) most = kind;
      }
    };
    look(machine.first_any, machine.any_count);
    for (std::size_t i = 0; i < machine.state_count; ++i)
      look(t_.states[machine.first_state + i].first_transition, t_.states[machine.first_state + i].transition_count);
    return most;
  }

  /// A transition without a cross-fade writes the states that it leaves twice: at its start, and one step before. An
  /// inertialization also writes the state that it enters four times (write_program.cpp).
  static void add_transitions(GraphDemand& all, const GraphDemand& state, GraphTransitionKind kind,
                              std::uint32_t fades) {
    const std::uint32_t copies = kind == GraphTransitionKind::inertialize ? 6 : 2;
    all.ops = std::min(all.ops + 1 + 2 * fades + product(fades * copies, state.ops + 1), kTooMany);
    all.kept = std::min(all.kept + fades + product(fades * copies, state.kept), kTooMany);
    all.slots = std::max({all.slots, 2 + product(fades, state.operands) + state.slots, 6 + state.slots});
  }

  GraphDemand place_machine(std::size_t s) {
    const GraphMachine& machine = t_.machines[s];
    GraphDemand most;
    for (std::size_t i = 0; i < machine.state_count; ++i)
      take_larger(most, place(t_.states[machine.first_state + i].node, 0));
    layout_.largest_states[s] = most.bytes;
    std::uint32_t slot = static_cast<std::uint32_t>(sizeof(SlotState)) + most.bytes;
    const GraphTransitionKind kind = most_demanding_kind(machine);
    if (kind != GraphTransitionKind::cross_fade) slot += most.bytes + kept_parameter_bytes(t_.parameters.size());
    layout_.slot_bytes[s] = slot;
    const std::uint32_t live = machine.fades + 1u;
    GraphDemand all = most;
    all.bytes = sizeof(MachineState) + product(live, slot);
    all.ops = product(live, most.ops);
    all.operands = product(live, most.operands);
    all.slots = product(live - 1, most.operands) + most.slots;
    all.machines = 1 + product(live, most.machines);
    all.kept = product(live, most.kept);
    if (kind != GraphTransitionKind::cross_fade) add_transitions(all, most, kind, machine.fades);
    return all;
  }

  const GraphTables& t_;
  GraphLayout layout_;
};

}  // namespace

GraphLayout lay_out(const GraphTables& tables) { return Layouter(tables).layout(); }

}  // namespace sinew
