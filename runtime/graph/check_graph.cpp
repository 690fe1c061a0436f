// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <vector>

#include "runtime/graph/check_formulas.h"
#include "runtime/graph/graph_definition.h"
#include "runtime/graph/state_blocks.h"

namespace sinew {
namespace {

/// Remembers the first fault.
class GraphChecker {
 public:
  explicit GraphChecker(const GraphTables& tables) : t_(tables), users_(tables.nodes.size(), 0) {}

  GraphFault fault() {
    check_sizes();
    for (std::size_t i = 0; i < t_.parameters.size(); ++i) check_parameter(i);
    for (std::size_t i = 0; i < t_.nodes.size(); ++i) check_node(i);
    node_ = kNoGraphIndex;
    for (std::size_t i = 0; i < t_.masks.size(); ++i) check_mask(i);
    if (is_sound()) fault_ = find_formula_fault(t_);
    if (is_sound()) fault_ = find_curve_fault(t_);
    if (fault_.code == ErrorCode::ok) check_tree();
    return fault_;
  }

 private:
  void expect(bool holds, ErrorCode code, GraphTable table, std::size_t index, const char* rule) {
    if (!holds && fault_.code == ErrorCode::ok) fault_ = {code, table, static_cast<std::uint32_t>(index), node_, rule};
  }
  bool is_sound() const { return fault_.code == ErrorCode::ok; }

  template <class Table>
  bool in_table(const Table& table, std::size_t first, std::size_t count) const {
    return first <= table.size() && count <= table.size() - first;
  }

  void check_sizes() {
    const std::size_t sizes[] = {
        t_.clip_names.size(), t_.parameters.size(), t_.nodes.size(),        t_.points.size(),      t_.children.size(),
        t_.layer_list.size(), t_.states.size(),     t_.transitions.size(),  t_.conditions.size(),  t_.clips.size(),
        t_.machines.size(),   t_.selects.size(),    t_.masks.size(),        t_.mask_joints.size(), t_.curves.size(),
        t_.curve_keys.size(), t_.formulas.size(),   t_.formula_steps.size()};
    for (const std::size_t size : sizes)
      expect(size < kNoGraphIndex, ErrorCode::too_large, GraphTable::graph, 0, "a table has 65535 entries or more");
    expect(!t_.nodes.empty() && t_.root < t_.nodes.size(), ErrorCode::index_out_of_range, GraphTable::graph, 0,
           "the root is no node");
  }

  void check_parameter(std::size_t i) {
    const GraphParameter& p = t_.parameters[i];
    expect(p.kind <= GraphParameterKind::trigger, ErrorCode::unsupported, GraphTable::parameter, i,
           "its kind is unknown");
    expect(std::isfinite(p.initial), ErrorCode::not_finite, GraphTable::parameter, i,
           "its initial value is not finite");
    expect(p.kind != GraphParameterKind::trigger || i < kMostGraphTriggers, ErrorCode::too_large, GraphTable::parameter,
           i, "a trigger is not among the first 64 parameters");
  }

  void check_mask(std::size_t i) {
    const GraphMask& mask = t_.masks[i];
    expect(i < PoseOp::kNoMask, ErrorCode::too_large, GraphTable::mask, i, "there are more than 255 masks");
    expect(in_table(t_.mask_joints, mask.first_joint, mask.joint_count), ErrorCode::index_out_of_range,
           GraphTable::mask, i, "its joints do not exist");
    if (!is_sound()) return;
    for (std::size_t j = mask.first_joint; j < std::size_t{mask.first_joint} + mask.joint_count; ++j)
      expect(t_.mask_joints[j].weight >= 0.0f && t_.mask_joints[j].weight <= 1.0f, ErrorCode::not_a_fraction,
             GraphTable::mask, i, "a weight is not between 0 and 1");
  }

  void expect_number(GraphIndex parameter, GraphTable table, std::size_t index, bool may_lack) {
    if (may_lack && parameter == kNoGraphIndex) return;
    expect(parameter < t_.parameters.size(), ErrorCode::index_out_of_range, table, index,
           "its parameter does not exist");
    if (parameter < t_.parameters.size())
      expect(t_.parameters[parameter].kind != GraphParameterKind::trigger, ErrorCode::unsupported, table, index,
             "its parameter is a trigger, which has no value");
  }

  void use(GraphIndex node, GraphTable table, std::size_t index) {
    expect(node < t_.nodes.size(), ErrorCode::index_out_of_range, table, index, "its node does not exist");
    if (node < t_.nodes.size())
      expect(++users_[node] == 1, ErrorCode::unsupported, table, index, "its node is used elsewhere, too");
  }

  void check_node(std::size_t i) {
    node_ = static_cast<GraphIndex>(i);
    const std::size_t s = t_.nodes[i].settings;
    const auto has = [&](const auto& table) {
      expect(s < table.size(), ErrorCode::index_out_of_range, GraphTable::node, i, "its settings do not exist");
      return s < table.size();
    };
    switch (t_.nodes[i].kind) {
      case GraphNodeKind::clip: return has(t_.clips) ? check_clip(s) : void();
      case GraphNodeKind::blend_space: return has(t_.spaces) ? check_space(s) : void();
      case GraphNodeKind::select: return has(t_.selects) ? check_select(s) : void();
      case GraphNodeKind::layers: return has(t_.layers) ? check_layers(s) : void();
      case GraphNodeKind::machine: return has(t_.machines) ? check_machine(s) : void();
      case GraphNodeKind::external: return;
    }
    expect(false, ErrorCode::unsupported, GraphTable::node, i, "its kind is unknown");
  }

  void check_clip(std::size_t s) {
    const GraphClipNode& clip = t_.clips[s];
    expect(clip.clip < t_.clip_names.size(), ErrorCode::index_out_of_range, GraphTable::clip, s,
           "its clip does not exist");
    expect(std::fabs(clip.speed) <= kMostGraphSpeed, ErrorCode::too_large, GraphTable::clip, s,
           "its speed is not between -256 and 256");
    expect(std::isfinite(clip.offset_s), ErrorCode::not_finite, GraphTable::clip, s, "its offset is not finite");
    expect_number(clip.speed_parameter, GraphTable::clip, s, true);
  }

  void check_space(std::size_t s) {
    const GraphBlendSpace& space = t_.spaces[s];
    expect_number(space.x, GraphTable::space, s, false);
    expect_number(space.y, GraphTable::space, s, true);
    expect(space.point_count > 0 && in_table(t_.points, space.first_point, space.point_count),
           ErrorCode::index_out_of_range, GraphTable::space, s, "it has no points, or they do not exist");
    if (!is_sound()) return;
    expect(space.form <= BlendSpaceKind::radial, ErrorCode::unsupported, GraphTable::space, s, "its form is unknown");
    expect(space.point_count <= kMostPoints, ErrorCode::too_large, GraphTable::space, s, "it has more than 32 points");
    for (std::size_t i = space.first_point; i < std::size_t{space.first_point} + space.point_count; ++i) {
      const GraphBlendPoint& p = t_.points[i];
      expect(std::isfinite(p.x) && std::isfinite(p.y), ErrorCode::not_finite, GraphTable::point, i, "it is not finite");
      expect(space.y != kNoGraphIndex || i == space.first_point || t_.points[i - 1].x < p.x,
             ErrorCode::times_not_increasing, GraphTable::point, i, "points of a line do not rise");
      use(p.node, GraphTable::point, i);
      if (is_sound())
        expect(t_.nodes[p.node].kind == GraphNodeKind::clip, ErrorCode::unsupported, GraphTable::point, i,
               "a point of a blend space is not a clip");
    }
  }

  void check_select(std::size_t s) {
    const GraphSelect& select = t_.selects[s];
    expect_number(select.parameter, GraphTable::select, s, false);
    expect(select.child_count > 0 && in_table(t_.children, select.first_child, select.child_count),
           ErrorCode::index_out_of_range, GraphTable::select, s, "it has no children, or they do not exist");
    if (!is_sound()) return;
    for (std::size_t i = 0; i < select.child_count; ++i)
      use(t_.children[select.first_child + i], GraphTable::child, select.first_child + i);
  }

  void check_layers(std::size_t s) {
    const GraphLayers& layers = t_.layers[s];
    use(layers.base, GraphTable::layers, s);
    expect(in_table(t_.layer_list, layers.first_layer, layers.layer_count), ErrorCode::index_out_of_range,
           GraphTable::layers, s, "its layers do not exist");
    if (!is_sound()) return;
    for (std::size_t i = layers.first_layer; i < std::size_t{layers.first_layer} + layers.layer_count; ++i) {
      const GraphLayer& layer = t_.layer_list[i];
      use(layer.node, GraphTable::layer, i);
      expect(std::isfinite(layer.weight), ErrorCode::not_finite, GraphTable::layer, i, "its weight is not finite");
      expect(layer.weight >= 0.0f, ErrorCode::negative_weight, GraphTable::layer, i, "its weight is below 0");
      expect_number(layer.weight_parameter, GraphTable::layer, i, true);
      expect(layer.kind <= GraphLayerKind::additive, ErrorCode::unsupported, GraphTable::layer, i,
             "its kind is unknown");
    }
  }

  void check_machine(std::size_t s) {
    const GraphMachine& m = t_.machines[s];
    expect(m.state_count > 0 && in_table(t_.states, m.first_state, m.state_count), ErrorCode::index_out_of_range,
           GraphTable::machine, s, "it has no states, or they do not exist");
    expect(m.initial < m.state_count, ErrorCode::index_out_of_range, GraphTable::machine, s,
           "its initial state does not exist");
    expect(m.fades <= kMostGraphFades, ErrorCode::too_large, GraphTable::machine, s,
           "it has more than 8 fades at once");
    check_transitions(m, m.first_any, m.any_count, GraphTable::machine, s);
    check_transitions(m, m.first_entry, m.entry_count, GraphTable::machine, s);
    if (!is_sound()) return;
    for (std::size_t i = m.first_state; i < std::size_t{m.first_state} + m.state_count; ++i) {
      use(t_.states[i].node, GraphTable::state, i);
      check_transitions(m, t_.states[i].first_transition, t_.states[i].transition_count, GraphTable::state, i);
    }
    if (is_sound()) check_reach(m);
  }

  void check_transitions(const GraphMachine& m, std::size_t first, std::size_t count, GraphTable table, std::size_t s) {
    expect(in_table(t_.transitions, first, count), ErrorCode::index_out_of_range, table, s,
           "its transitions do not exist");
    if (!is_sound()) return;
    for (std::size_t i = first; i < first + count; ++i) {
      const GraphTransition& t = t_.transitions[i];
      const auto want = [&](bool holds, ErrorCode code, const char* rule) {
        expect(holds, code, GraphTable::transition, i, rule);
      };
      want(t.to < m.state_count, ErrorCode::index_out_of_range, "its target is no state of the machine");
      want(t.duration_s >= 0.0f && t.duration_s <= 3600.0f, ErrorCode::too_large, "it does not last 0 to 3600 s");
      want(t.fade <= GraphFade::ease_out && t.interruption <= GraphInterruption::target_then_source &&
               t.sync <= GraphSync::locked && t.start_by <= SyncStart::time_left &&
               t.kind <= GraphTransitionKind::dead_blend,
           ErrorCode::unsupported, "its kind, fade, interruption or synchronisation is unknown");
      want(t.curve == kNoGraphIndex || t.curve < t_.curves.size(), ErrorCode::index_out_of_range,
           "its curve does not exist");
      want(t.curve == kNoGraphIndex || t.kind == GraphTransitionKind::cross_fade, ErrorCode::unsupported,
           "only a cross-fade has a curve of its own");
      want(in_table(t_.conditions, t.first_condition, t.condition_count), ErrorCode::index_out_of_range,
           "its conditions do not exist");
      if (!is_sound()) return;
      for (std::size_t c = t.first_condition; c < std::size_t{t.first_condition} + t.condition_count; ++c)
        check_condition(c);
    }
  }

  void check_condition(std::size_t c) {
    const GraphCondition& condition = t_.conditions[c];
    expect(condition.kind <= GraphConditionKind::phase, ErrorCode::unsupported, GraphTable::condition, c,
           "its kind is unknown");
    expect(std::isfinite(condition.value), ErrorCode::not_finite, GraphTable::condition, c, "its value is not finite");
    switch (condition.kind) {
      case GraphConditionKind::time_in_state:
      case GraphConditionKind::played:
        expect(condition.value >= 0.0f && condition.value <= 1e6f, ErrorCode::too_large, GraphTable::condition, c,
               "its value is not between 0 and 1000000");
        return;
      case GraphConditionKind::phase:
        expect(condition.value >= 0.0f && condition.value < 1.0f, ErrorCode::not_a_fraction, GraphTable::condition, c,
               "its phase is not in [0, 1)");
        return;
      case GraphConditionKind::trigger:
        expect(condition.parameter < t_.parameters.size() &&
                   t_.parameters[condition.parameter].kind == GraphParameterKind::trigger,
               ErrorCode::index_out_of_range, GraphTable::condition, c, "its parameter is no trigger");
        return;
      default: expect_number(condition.parameter, GraphTable::condition, c, false);
    }
  }

  /// A state that no transition leads to is a mistake: the state is superfluous, or a transition to it was forgotten.
  void check_reach(const GraphMachine& m) {
    std::vector<bool> reached(m.state_count, false);
    std::vector<std::size_t> open{m.initial};
    const auto follow = [&](std::size_t first, std::size_t count) {
      for (std::size_t i = first; i < first + count; ++i) open.push_back(t_.transitions[i].to);
    };
    follow(m.first_any, m.any_count);
    follow(m.first_entry, m.entry_count);
    while (!open.empty()) {
      const std::size_t state = open.back();
      open.pop_back();
      if (reached[state]) continue;
      reached[state] = true;
      const GraphMachineState& s = t_.states[m.first_state + state];
      follow(s.first_transition, s.transition_count);
    }
    for (std::size_t i = 0; i < m.state_count; ++i)
      expect(reached[i], ErrorCode::unsupported, GraphTable::state, m.first_state + i, "no transition leads to it");
  }

  /// Each node must have one user, except the root, which has none. Nodes that the root does not reach then lie on a
  /// cycle.
  void check_tree() {
    node_ = t_.root;
    expect(users_[t_.root] == 0, ErrorCode::unsupported, GraphTable::node, t_.root, "it lies on a cycle");
    for (std::size_t i = 0; i < users_.size() && is_sound(); ++i) {
      node_ = static_cast<GraphIndex>(i);
      expect(i == t_.root || users_[i] == 1, ErrorCode::unsupported, GraphTable::node, i, "nothing uses it");
    }
    if (!is_sound()) return;
    std::vector<bool> reached(t_.nodes.size(), false);
    mark(t_.root, reached, 0);
    for (std::size_t i = 0; i < reached.size(); ++i) {
      node_ = static_cast<GraphIndex>(i);
      expect(reached[i], ErrorCode::unsupported, GraphTable::node, i, "it lies on a cycle");
    }
  }

  void mark(GraphIndex node, std::vector<bool>& reached, int depth) {
    node_ = node;
    expect(depth < kMostDepth, ErrorCode::too_large, GraphTable::node, node, "nodes are nested more than 32 deep");
    if (!is_sound()) return;
    reached[node] = true;
    const std::size_t s = t_.nodes[node].settings;
    switch (t_.nodes[node].kind) {
      case GraphNodeKind::clip:
      case GraphNodeKind::external: return;
      case GraphNodeKind::blend_space:
        for (std::size_t i = 0; i < t_.spaces[s].point_count; ++i)
          reached[t_.points[t_.spaces[s].first_point + i].node] = true;
        return;
      case GraphNodeKind::select:
        for (std::size_t i = 0; i < t_.selects[s].child_count; ++i)
          mark(t_.children[t_.selects[s].first_child + i], reached, depth + 1);
        return;
      case GraphNodeKind::layers:
        mark(t_.layers[s].base, reached, depth + 1);
        for (std::size_t i = 0; i < t_.layers[s].layer_count; ++i)
          mark(t_.layer_list[t_.layers[s].first_layer + i].node, reached, depth + 1);
        return;
      case GraphNodeKind::machine:
        for (std::size_t i = 0; i < t_.machines[s].state_count; ++i)
          mark(t_.states[t_.machines[s].first_state + i].node, reached, depth + 1);
        return;
    }
  }

  static constexpr std::size_t kMostPoints = 32;
  static constexpr int kMostDepth = 32;

  const GraphTables& t_;
  std::vector<int> users_;  // [nodes]
  GraphFault fault_;
  GraphIndex node_ = kNoGraphIndex;  // node that is being checked
};

}  // namespace

GraphFault find_fault(const GraphTables& tables) { return GraphChecker(tables).fault(); }

}  // namespace sinew
