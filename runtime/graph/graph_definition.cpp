// SPDX-License-Identifier: MIT
#include "runtime/graph/graph_definition.h"

#include <algorithm>
#include <span>
#include <utility>

#include "runtime/graph/graph_layout.h"
#include "runtime/graph/state_blocks.h"

namespace sinew {
namespace {

/// FNV-1a hash of everything that decides how the bytes of a state are read.
class Signature {
 public:
  void add(std::uint32_t value) noexcept {
    for (int byte = 0; byte < 4; ++byte) hash_ = (hash_ ^ (value >> (8 * byte) & 0xFFu)) * 16777619u;
  }
  std::uint32_t value() const noexcept { return hash_ | 1u; }  // never 0, so a block of zeros fits no graph

 private:
  std::uint32_t hash_ = 2166136261u;
};

std::uint32_t signature_of(const GraphTables& t, const GraphLayout& layout) {
  Signature s;
  s.add(layout.demand.bytes);
  s.add(t.root);
  for (std::size_t i = 0; i < t.nodes.size(); ++i) {
    s.add(static_cast<std::uint32_t>(t.nodes[i].kind));
    s.add(t.nodes[i].settings);
    s.add(layout.offsets[i]);
  }
  for (const GraphClipNode& clip : t.clips) s.add(clip.clip);
  for (const GraphMachineState& state : t.states) s.add(state.node);
  for (const GraphTransition& transition : t.transitions) s.add(transition.to);
  s.add(static_cast<std::uint32_t>(t.parameters.size()));
  return s.value();
}

const char* word_of(GraphTable table) noexcept {
  switch (table) {
    case GraphTable::graph: return "graph";
    case GraphTable::parameter: return "parameter";
    case GraphTable::node: return "node";
    case GraphTable::clip: return "clip";
    case GraphTable::space: return "blend space";
    case GraphTable::point: return "point";
    case GraphTable::select: return "select";
    case GraphTable::child: return "child";
    case GraphTable::layers: return "layers";
    case GraphTable::layer: return "layer";
    case GraphTable::machine: return "machine";
    case GraphTable::state: return "state";
    case GraphTable::transition: return "transition";
    case GraphTable::condition: return "condition";
    case GraphTable::mask: return "mask";
    case GraphTable::formula: return "formula";
    case GraphTable::curve: return "curve";
  }
  return "?";
}

}  // namespace

std::string describe(const GraphFault& fault, const GraphTables& tables) {
  if (fault.code == ErrorCode::ok) return {};
  std::string text = word_of(fault.table);
  const auto quote = [&](std::uint32_t name) { text.append(" '").append(tables.name_at(name)).append("'"); };
  if (fault.table != GraphTable::graph) text.append(" ").append(std::to_string(fault.index));
  if (fault.table == GraphTable::state && fault.index < tables.states.size()) quote(tables.states[fault.index].name);
  if (fault.table == GraphTable::parameter && fault.index < tables.parameters.size())
    quote(tables.parameters[fault.index].name);
  if (fault.node < tables.nodes.size()) {
    text.append(" (node");
    quote(tables.nodes[fault.node].name);
    text.append(")");
  }
  return text.append(": ").append(fault.rule);
}

tl::expected<GraphDefinition, GraphFault> GraphDefinition::make(GraphTables tables) {
  if (const GraphFault fault = find_fault(tables); fault.code != ErrorCode::ok) return tl::make_unexpected(fault);
  GraphLayout layout = lay_out(tables);
  const auto too_much = [&](const char* rule) {
    return tl::make_unexpected(GraphFault{ErrorCode::too_large, GraphTable::graph, 0, tables.root, rule});
  };
  const GraphDemand& demand = layout.demand;
  if (demand.ops + 1 > kMostPoseOps) return too_much("more than 254 pose operations can be live at once");
  if (demand.machines > kMostLiveMachines) return too_much("more than 64 machines can be live at once");
  GraphDefinition graph;
  graph.state_bytes_ = demand.bytes;
  graph.room_.ops = demand.ops + 1;
  graph.room_.slots = demand.slots;
  graph.room_.kept = demand.kept;
  graph.room_.overlays_in_model_space = demand.in_model_space;
  for (const GraphNode& node : tables.nodes)
    if (node.kind == GraphNodeKind::external)
      graph.room_.externals = std::max<std::uint32_t>(graph.room_.externals, node.settings + 1u);
  for (const GraphLayer& layer : tables.layer_list)
    if (layer.mask != PoseOp::kNoMask) graph.room_.masks = std::max<std::uint32_t>(graph.room_.masks, layer.mask + 1u);
  graph.signature_ = signature_of(tables, layout);
  graph.offsets_ = std::move(layout.offsets);
  graph.largest_states_ = std::move(layout.largest_states);
  graph.slot_bytes_ = std::move(layout.slot_bytes);
  for (const GraphTransition& transition : tables.transitions)
    graph.durations_.push_back(ticks_of(decimal_of(transition.duration_s)));
  graph.tables_ = std::move(tables);
  std::size_t space = 0;
  if (const ErrorCode code = graph.prepare_spaces(space); code != ErrorCode::ok)
    return tl::make_unexpected(GraphFault{code, GraphTable::space, static_cast<std::uint32_t>(space), kNoGraphIndex,
                                          "its points or its angle factor are beyond the range of blend spaces"});
  return graph;
}

ErrorCode GraphDefinition::prepare_spaces(std::size_t& space) {
  for (const GraphBlendPoint& point : tables_.points) places_.emplace_back(point.x, point.y);
  for (space = 0; space < tables_.spaces.size(); ++space) {
    const GraphBlendSpace& s = tables_.spaces[space];
    const std::size_t first = numbers_.size();
    first_numbers_.push_back(first);
    numbers_.resize(first + blend_space_numbers(form_of(s), s.point_count));
    const ErrorCode code =
        prepare_blend_space(form_of(s), std::span<const glm::vec2>(places_).subspan(s.first_point, s.point_count),
                            s.angle_factor, std::span(numbers_).subspan(first));
    if (code != ErrorCode::ok) return code;
  }
  return ErrorCode::ok;
}

bool GraphDefinition::is_computed(GraphIndex parameter) const noexcept {
  return std::any_of(tables_.formulas.begin(), tables_.formulas.end(),
                     [&](const GraphFormula& formula) { return formula.parameter == parameter; });
}

GraphIndex GraphDefinition::find_parameter(std::string_view name) const noexcept {
  for (std::size_t i = 0; i < tables_.parameters.size(); ++i)
    if (tables_.name_at(tables_.parameters[i].name) == name) return static_cast<GraphIndex>(i);
  return kNoGraphIndex;
}

GraphIndex GraphDefinition::find_node(std::string_view name) const noexcept {
  for (std::size_t i = 0; i < tables_.nodes.size(); ++i)
    if (tables_.name_at(tables_.nodes[i].name) == name) return static_cast<GraphIndex>(i);
  return kNoGraphIndex;
}

}  // namespace sinew
