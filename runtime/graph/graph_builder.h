// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/graph/graph_definition.h"

namespace sinew {

/// Builds the tables of a graph. A node must exist before another node or state uses it.
///
///     GraphBuilder b;
///     const GraphIndex speed = b.number("speed");
///     const GraphIndex body = b.machine("body");
///     const GraphIndex idle = b.state(body, "idle", b.clip("idle"));
///     const GraphIndex walk = b.state(body, "walk", b.clip("walk"));
///     b.transition(body, idle, {.to = walk}, {when_above(speed, 0.1f)});
///     b.transition(body, walk, {.to = idle}, {when_below(speed, 0.1f)});
///     const auto graph = b.build(body);
class SINEW_API GraphBuilder {
 public:
  using Conditions = std::span<const GraphCondition>;

  GraphIndex parameter(std::string_view name, GraphParameterKind kind, float initial = 0.0f);
  GraphIndex number(std::string_view name, float initial = 0.0f) {
    return parameter(name, GraphParameterKind::number, initial);
  }
  GraphIndex flag(std::string_view name) { return parameter(name, GraphParameterKind::flag); }
  GraphIndex trigger(std::string_view name) { return parameter(name, GraphParameterKind::trigger); }

  /// Makes a number that the graph computes.
  GraphIndex computed(std::string_view name, std::span<const GraphFormulaStep> steps);

  /// Adds a curve for fades: a cubic with these slopes at its ends, or through points between the ends.
  /// in   points  `at` increases within (0, 1); slopes are found here, so that the curve has no bumps of its own
  GraphIndex curve(float start_slope, float end_slope, std::span<const GraphFadeKey> points = {});

  /// Returns the index of a clip name, and adds the name if it is new.
  GraphIndex clip_name(std::string_view name);

  /// Adds a clip node. Its name defaults to that of the clip. `settings.clip` is ignored.
  GraphIndex clip(std::string_view clip, GraphClipNode settings = {}, std::string_view name = {});
  GraphIndex blend_space(std::string_view name, GraphBlendSpace settings, std::span<const GraphBlendPoint> points);
  GraphIndex select(std::string_view name, GraphIndex parameter, std::span<const GraphIndex> children);
  GraphIndex layers(std::string_view name, GraphIndex base, std::span<const GraphLayer> layers);
  GraphIndex external(std::string_view name, GraphIndex pose);

  /// in   settings  only `initial` and `fades` are used
  GraphIndex machine(std::string_view name, GraphMachine settings = {});
  /// The next three functions return an index within the machine.
  GraphIndex state(GraphIndex machine, std::string_view name, GraphIndex node);
  GraphIndex transition(GraphIndex machine, GraphIndex from, GraphTransition settings, Conditions conditions);
  GraphIndex transition_from_any(GraphIndex machine, GraphTransition settings, Conditions conditions);
  GraphIndex entry(GraphIndex machine, GraphTransition settings, Conditions conditions);

  GraphIndex transition(GraphIndex machine, GraphIndex from, GraphTransition settings,
                        std::initializer_list<GraphCondition> conditions) {
    return transition(machine, from, settings, Conditions(conditions.begin(), conditions.size()));
  }
  GraphIndex transition_from_any(GraphIndex machine, GraphTransition settings,
                                 std::initializer_list<GraphCondition> conditions) {
    return transition_from_any(machine, settings, Conditions(conditions.begin(), conditions.size()));
  }
  GraphIndex entry(GraphIndex machine, GraphTransition settings, std::initializer_list<GraphCondition> conditions) {
    return entry(machine, settings, Conditions(conditions.begin(), conditions.size()));
  }

  GraphTables tables(GraphIndex root) const;
  tl::expected<GraphDefinition, GraphFault> build(GraphIndex root) const { return GraphDefinition::make(tables(root)); }

 private:
  struct Arrow {
    GraphIndex from;  // state, kNoGraphIndex (any state) or kEntry
    GraphTransition settings;
    std::vector<GraphCondition> conditions;
  };
  struct Machine {
    std::vector<GraphMachineState> states;
    std::vector<Arrow> arrows;
  };
  static constexpr GraphIndex kEntry = 0xFFFE;

  std::uint32_t text(std::string_view name);
  GraphIndex node(std::string_view name, GraphNodeKind kind, std::size_t settings);
  GraphIndex arrow(GraphIndex machine, GraphIndex from, const GraphTransition& settings, Conditions conditions);
  Machine& machine_of(GraphIndex node);

  GraphTables tables_;
  std::vector<Machine> machines_;
};

inline GraphCondition when_above(GraphIndex parameter, float value) noexcept {
  return {value, parameter, GraphConditionKind::above};
}
inline GraphCondition when_below(GraphIndex parameter, float value) noexcept {
  return {value, parameter, GraphConditionKind::below};
}
inline GraphCondition when_on(GraphIndex flag) noexcept { return {0.0f, flag, GraphConditionKind::on}; }
inline GraphCondition when_off(GraphIndex flag) noexcept { return {0.0f, flag, GraphConditionKind::off}; }
inline GraphCondition when_triggered(GraphIndex trigger) noexcept {
  return {0.0f, trigger, GraphConditionKind::trigger};
}
inline GraphCondition when_in_state_for(float seconds) noexcept {
  return {seconds, kNoGraphIndex, GraphConditionKind::time_in_state};
}
inline GraphCondition when_played(float rounds) noexcept { return {rounds, kNoGraphIndex, GraphConditionKind::played}; }
inline GraphCondition when_at_phase(float phase) noexcept { return {phase, kNoGraphIndex, GraphConditionKind::phase}; }

}  // namespace sinew
