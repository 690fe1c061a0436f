// SPDX-License-Identifier: MIT
#include "runtime/graph/graph_builder.h"

#include "runtime/base/contract.h"
#include "runtime/graph/fade_curve.h"

namespace sinew {
namespace {

template <class Table>
GraphIndex size_of(const Table& table) noexcept {
  return static_cast<GraphIndex>(table.size());
}

}  // namespace

std::uint32_t GraphBuilder::text(std::string_view name) {
  const auto offset = static_cast<std::uint32_t>(tables_.names.size());
  tables_.names += name;
  tables_.names += '\0';
  return offset;
}

GraphIndex GraphBuilder::parameter(std::string_view name, GraphParameterKind kind, float initial) {
  tables_.parameters.push_back({text(name), initial, kind});
  return static_cast<GraphIndex>(tables_.parameters.size() - 1);
}

GraphIndex GraphBuilder::computed(std::string_view name, std::span<const GraphFormulaStep> steps) {
  const GraphIndex made = number(name);
  tables_.formulas.push_back({made, size_of(tables_.formula_steps), static_cast<GraphIndex>(steps.size())});
  tables_.formula_steps.insert(tables_.formula_steps.end(), steps.begin(), steps.end());
  return made;
}

GraphIndex GraphBuilder::curve(float start_slope, float end_slope, std::span<const GraphFadeKey> points) {
  const std::vector<GraphFadeKey> keys = fade_curve_keys(start_slope, end_slope, points);
  tables_.curves.push_back({size_of(tables_.curve_keys), static_cast<GraphIndex>(keys.size())});
  tables_.curve_keys.insert(tables_.curve_keys.end(), keys.begin(), keys.end());
  return static_cast<GraphIndex>(tables_.curves.size() - 1);
}

GraphIndex GraphBuilder::clip_name(std::string_view name) {
  for (std::size_t i = 0; i < tables_.clip_names.size(); ++i)
    if (tables_.name_at(tables_.clip_names[i]) == name) return static_cast<GraphIndex>(i);
  tables_.clip_names.push_back(text(name));
  return static_cast<GraphIndex>(tables_.clip_names.size() - 1);
}

GraphIndex GraphBuilder::node(std::string_view name, GraphNodeKind kind, std::size_t settings) {
  tables_.nodes.push_back({text(name), static_cast<GraphIndex>(settings), kind});
  return static_cast<GraphIndex>(tables_.nodes.size() - 1);
}

GraphIndex GraphBuilder::clip(std::string_view clip, GraphClipNode settings, std::string_view name) {
  settings.clip = clip_name(clip);
  tables_.clips.push_back(settings);
  return node(name.empty() ? clip : name, GraphNodeKind::clip, tables_.clips.size() - 1);
}

GraphIndex GraphBuilder::blend_space(std::string_view name, GraphBlendSpace settings,
                                     std::span<const GraphBlendPoint> points) {
  settings.first_point = size_of(tables_.points);
  settings.point_count = static_cast<GraphIndex>(points.size());
  tables_.points.insert(tables_.points.end(), points.begin(), points.end());
  tables_.spaces.push_back(settings);
  return node(name, GraphNodeKind::blend_space, tables_.spaces.size() - 1);
}

GraphIndex GraphBuilder::select(std::string_view name, GraphIndex parameter, std::span<const GraphIndex> children) {
  tables_.selects.push_back({parameter, size_of(tables_.children), static_cast<GraphIndex>(children.size())});
  tables_.children.insert(tables_.children.end(), children.begin(), children.end());
  return node(name, GraphNodeKind::select, tables_.selects.size() - 1);
}

GraphIndex GraphBuilder::layers(std::string_view name, GraphIndex base, std::span<const GraphLayer> layers) {
  tables_.layers.push_back({base, size_of(tables_.layer_list), static_cast<GraphIndex>(layers.size())});
  tables_.layer_list.insert(tables_.layer_list.end(), layers.begin(), layers.end());
  return node(name, GraphNodeKind::layers, tables_.layers.size() - 1);
}

GraphIndex GraphBuilder::external(std::string_view name, GraphIndex pose) {
  return node(name, GraphNodeKind::external, pose);
}

GraphIndex GraphBuilder::machine(std::string_view name, GraphMachine settings) {
  tables_.machines.push_back(settings);
  machines_.emplace_back();
  return node(name, GraphNodeKind::machine, machines_.size() - 1);
}

GraphBuilder::Machine& GraphBuilder::machine_of(GraphIndex node) {
  CONTRACT(node < tables_.nodes.size() && tables_.nodes[node].kind == GraphNodeKind::machine);
  return machines_[tables_.nodes[node].settings];
}

GraphIndex GraphBuilder::state(GraphIndex machine, std::string_view name, GraphIndex node) {
  Machine& m = machine_of(machine);
  m.states.push_back({.name = text(name), .node = node});
  return static_cast<GraphIndex>(m.states.size() - 1);
}

GraphIndex GraphBuilder::arrow(GraphIndex machine, GraphIndex from, const GraphTransition& settings,
                               Conditions conditions) {
  Machine& m = machine_of(machine);
  m.arrows.push_back({from, settings, {conditions.begin(), conditions.end()}});
  return static_cast<GraphIndex>(m.arrows.size() - 1);
}

GraphIndex GraphBuilder::transition(GraphIndex machine, GraphIndex from, GraphTransition settings,
                                    Conditions conditions) {
  return arrow(machine, from, settings, conditions);
}

GraphIndex GraphBuilder::transition_from_any(GraphIndex machine, GraphTransition settings, Conditions conditions) {
  return arrow(machine, kNoGraphIndex, settings, conditions);
}

GraphIndex GraphBuilder::entry(GraphIndex machine, GraphTransition settings, Conditions conditions) {
  return arrow(machine, kEntry, settings, conditions);
}

GraphTables GraphBuilder::tables(GraphIndex root) const {
  GraphTables t = tables_;
  t.root = root;
  for (std::size_t m = 0; m < machines_.size(); ++m) {
    const auto append = [&](GraphIndex from) {
      for (const Arrow& arrow : machines_[m].arrows) {
        if (arrow.from != from) continue;
        GraphTransition transition = arrow.settings;
        transition.first_condition = size_of(t.conditions);
        transition.condition_count = size_of(arrow.conditions);
        t.conditions.insert(t.conditions.end(), arrow.conditions.begin(), arrow.conditions.end());
        t.transitions.push_back(transition);
      }
      return size_of(t.transitions);
    };
    GraphMachine& machine = t.machines[m];
    machine.first_state = size_of(t.states);
    machine.state_count = size_of(machines_[m].states);
    machine.first_any = size_of(t.transitions);
    machine.any_count = static_cast<GraphIndex>(append(kNoGraphIndex) - machine.first_any);
    machine.first_entry = size_of(t.transitions);
    machine.entry_count = static_cast<GraphIndex>(append(kEntry) - machine.first_entry);
    for (std::size_t s = 0; s < machines_[m].states.size(); ++s) {
      GraphMachineState state = machines_[m].states[s];
      state.first_transition = size_of(t.transitions);
      state.transition_count = static_cast<GraphIndex>(append(static_cast<GraphIndex>(s)) - state.first_transition);
      t.states.push_back(state);
    }
    // Transitions from a state that does not exist must not vanish. The invalid count makes find_fault refuse the
    // graph.
    for (const Arrow& arrow : machines_[m].arrows)
      if (arrow.from < kEntry && arrow.from >= machine.state_count) machine.any_count = kNoGraphIndex;
  }
  return t;
}

}  // namespace sinew
