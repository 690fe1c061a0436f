// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <iterator>

#include "importer/graph/compile_formulas.h"
#include "importer/graph/compile_masks.h"
#include "importer/graph/graph_text.h"
#include "importer/graph/json_path.h"
#include "runtime/graph/fade_curve.h"

namespace sinew {
namespace {

using Document = GraphDocument;

/// Index of a name in a sorted map.
template <class Map>
GraphIndex index_in(const Map& map, const std::string& name) {
  const auto found = map.find(name);
  return found == map.end() ? kNoGraphIndex : static_cast<GraphIndex>(std::distance(map.begin(), found));
}

template <class Table>
GraphIndex size_of(const Table& table) {
  return static_cast<GraphIndex>(std::min<std::size_t>(table.size(), kNoGraphIndex));
}

/// Fills the tables. Nodes and parameters have the order of their names.
class GraphCompiler {
 public:
  explicit GraphCompiler(const Document& document) : d_(document) {}

  GraphTables t;
  std::vector<std::string> curve_places;  ///< [curves] JSON pointers
  GraphTextFault fault;
  bool failed = false;

  void compile() {
    const JsonPath root, parameters(&root, "parameters"), nodes(&root, "nodes");
    for (const auto& [name, parameter] : d_.parameters)
      t.parameters.push_back({text(name), parameter.initial, parameter.kind});
    const JsonPath beats(&root, "beats");
    for (const auto& [name, beat] : d_.beats) {
      const JsonPath here(&beats, name);
      if (!beat.mirror.empty()) find(d_.beats, beat.mirror, {&here, "mirror"}, "beat");
    }
    if (const auto mask_fault = compile_masks(d_, t)) return fail(*mask_fault);
    for (const auto& [name, node] : d_.nodes) compile(node, text(name), {&nodes, name});
    t.root = node_index(d_.root, {&root, "root"});
    if (!failed)
      if (const auto formula_fault = compile_formulas(d_, t)) fail(*formula_fault);
  }

 private:
  void fail(const GraphTextFault& first) {
    if (!failed) fault = first;
    failed = true;
  }
  void fail(const JsonPath& path, std::string sentence) { fail({path.text(), std::move(sentence)}); }
  std::uint32_t text(const std::string& name) {
    const auto offset = static_cast<std::uint32_t>(t.names.size());
    t.names += name;
    t.names += '\0';
    return offset;
  }

  template <class Map>
  GraphIndex find(const Map& map, const std::string& name, const JsonPath& path, const char* thing) {
    const GraphIndex index = index_in(map, name);
    if (index == kNoGraphIndex) fail(path, "there is no " + std::string(thing) + " \"" + name + "\"");
    return index;
  }
  GraphIndex node_index(const std::string& name, const JsonPath& path) { return find(d_.nodes, name, path, "node"); }
  GraphIndex parameter_index(const std::string& name, const JsonPath& path) {
    return find(d_.parameters, name, path, "parameter");
  }
  GraphIndex parameter_or_none(const std::string& name, const JsonPath& path) {
    return name.empty() ? kNoGraphIndex : parameter_index(name, path);
  }

  GraphIndex clip_name(const std::string& name) {
    for (std::size_t i = 0; i < t.clip_names.size(); ++i)
      if (t.name_at(t.clip_names[i]) == name) return static_cast<GraphIndex>(i);
    t.clip_names.push_back(text(name));
    return static_cast<GraphIndex>(t.clip_names.size() - 1);
  }

  void compile(const Document::Node& node, std::uint32_t name, const JsonPath& path) {
    GraphIndex settings = 0;
    switch (node.kind) {
      case Document::NodeKind::clip:
        settings = size_of(t.clips);
        t.clips.push_back({.speed = node.speed,
                           .offset_s = node.offset_s,
                           .clip = clip_name(node.clip),
                           .speed_parameter = parameter_or_none(node.speed_by, {&path, "speed_by"}),
                           .loop = node.loop,
                           .mirror = node.mirror});
        break;
      case Document::NodeKind::blend_space:
        settings = size_of(t.spaces);
        compile_space(node, path);
        break;
      case Document::NodeKind::select: {
        settings = size_of(t.selects);
        const JsonPath children(&path, "children");
        t.selects.push_back({parameter_index(node.by, {&path, "by"}), size_of(t.children), size_of(node.children)});
        for (std::size_t i = 0; i < node.children.size(); ++i)
          t.children.push_back(node_index(node.children[i], {&children, std::to_string(i)}));
        break;
      }
      case Document::NodeKind::layers:
        settings = size_of(t.layers);
        compile_layers(node, path);
        break;
      case Document::NodeKind::machine:
        settings = size_of(t.machines);
        compile_machine(node, path);
        break;
      case Document::NodeKind::external:
        if (node.pose < 0 || node.pose >= kNoGraphIndex) fail({&path, "pose"}, "is no index of a pose");
        settings = static_cast<GraphIndex>(node.pose);
        break;
      case Document::NodeKind::graph: return fail({&path, "file"}, "a graph of another file must be read with it");
    }
    t.nodes.push_back({name, settings, static_cast<GraphNodeKind>(node.kind)});
  }

  void compile_space(const Document::Node& node, const JsonPath& path) {
    t.spaces.push_back({.x = parameter_index(node.x, {&path, "x"}),
                        .y = parameter_or_none(node.y, {&path, "y"}),
                        .first_point = size_of(t.points),
                        .point_count = size_of(node.points),
                        .form = node.form,
                        .angle_factor = node.angle_factor});
    const JsonPath points(&path, "points");
    for (std::size_t i = 0; i < node.points.size(); ++i) {
      const JsonPath point(&points, std::to_string(i));
      t.points.push_back({node.points[i].x, node.points[i].y, node_index(node.points[i].node, {&point, "node"})});
    }
  }

  void compile_layers(const Document::Node& node, const JsonPath& path) {
    t.layers.push_back({node_index(node.base, {&path, "base"}), size_of(t.layer_list), size_of(node.layers)});
    const JsonPath layers(&path, "layers");
    for (std::size_t i = 0; i < node.layers.size(); ++i) {
      const Document::Layer& layer = node.layers[i];
      const JsonPath here(&layers, std::to_string(i));
      std::uint8_t mask = PoseOp::kNoMask;
      if (!layer.mask.empty())
        mask =
            static_cast<std::uint8_t>(std::min<GraphIndex>(find(d_.masks, layer.mask, {&here, "mask"}, "mask"), 254));
      t.layer_list.push_back({.weight = layer.weight,
                              .node = node_index(layer.node, {&here, "node"}),
                              .weight_parameter = parameter_or_none(layer.weight_by, {&here, "weight_by"}),
                              .mask = mask,
                              .kind = layer.kind});
    }
  }

  void compile_machine(const Document::Node& node, const JsonPath& path) {
    GraphMachine machine;
    if (node.fades < 0 || node.fades > kMostGraphFades) fail({&path, "fades"}, "is not between 0 and 8");
    machine.fades = static_cast<std::uint8_t>(node.fades);
    machine.initial = find(node.states, node.initial, {&path, "initial"}, "state");
    machine.first_state = size_of(t.states);
    machine.state_count = size_of(node.states);
    machine.first_any = compile_transitions(node, node.any, {&path, "any"});
    machine.any_count = size_of(node.any);
    machine.first_entry = compile_transitions(node, node.entry, {&path, "entry"});
    machine.entry_count = size_of(node.entry);
    const JsonPath states(&path, "states");
    for (const auto& [name, state] : node.states) {
      const JsonPath here(&states, name);
      GraphMachineState to{.name = text(name), .node = node_index(state.node, {&here, "node"})};
      to.first_transition = compile_transitions(node, state.transitions, {&here, "transitions"});
      to.transition_count = size_of(state.transitions);
      t.states.push_back(to);
    }
    t.machines.push_back(machine);
  }

  GraphIndex compile_transitions(const Document::Node& machine, const std::vector<Document::Transition>& transitions,
                                 const JsonPath& path) {
    const GraphIndex first = size_of(t.transitions);
    for (std::size_t i = 0; i < transitions.size(); ++i) {
      const Document::Transition& from = transitions[i];
      const JsonPath here(&path, std::to_string(i)), when(&here, "when");
      t.transitions.push_back({.duration_s = from.duration_s,
                               .priority = from.priority,
                               .to = find(machine.states, from.to, {&here, "to"}, "state"),
                               .first_condition = size_of(t.conditions),
                               .condition_count = size_of(from.when),
                               .curve = compile_curve(from, here),
                               .fade = from.fade,
                               .kind = from.kind,
                               .interruption = from.interruption,
                               .sync = from.sync,
                               .start_by = from.start_by,
                               .ordered = from.ordered,
                               .to_self = from.to_self});
      for (std::size_t c = 0; c < from.when.size(); ++c) {
        const JsonPath condition(&when, std::to_string(c));
        compile_condition(from.when[c], condition);
      }
    }
    return first;
  }

  GraphIndex compile_curve(const Document::Transition& from, const JsonPath& path) {
    if (!from.curve) return kNoGraphIndex;
    if (from.fade != GraphFade::smooth) fail({&path, "fade"}, "is not used by a transition with a curve of its own");
    std::vector<GraphFadeKey> points;
    for (const Document::CurveKey& key : from.curve->keys) points.push_back({key.at, key.share, 0.0f});
    const auto keys = fade_curve_keys(from.curve->start_slope, from.curve->end_slope, points);
    t.curves.push_back({size_of(t.curve_keys), size_of(keys)});
    t.curve_keys.insert(t.curve_keys.end(), keys.begin(), keys.end());
    curve_places.push_back(JsonPath(&path, "curve").text());
    return static_cast<GraphIndex>(t.curves.size() - 1);  // tables of 65535 entries are refused later
  }

  void compile_condition(const Document::Condition& from, const JsonPath& path) {
    const bool of_time = from.kind >= GraphConditionKind::time_in_state;
    if (of_time && !from.parameter.empty()) fail({&path, "parameter"}, "is not used by a condition of time");
    t.conditions.push_back(
        {from.value, of_time ? kNoGraphIndex : parameter_index(from.parameter, {&path, "parameter"}), from.kind});
  }

  const Document& d_;
};

bool lies_in(std::uint32_t index, std::size_t first, std::size_t count) {
  return index >= first && index - first < count;
}

/// The place of a transition below its machine: "/any/2", "/states/walk/transitions/0".
std::string place_of_transition(const GraphTables& t, const GraphMachine& machine, std::uint32_t index) {
  const auto numbered = [&](const char* list, std::size_t first) { return list + std::to_string(index - first); };
  if (lies_in(index, machine.first_any, machine.any_count)) return numbered("/any/", machine.first_any);
  if (lies_in(index, machine.first_entry, machine.entry_count)) return numbered("/entry/", machine.first_entry);
  for (std::size_t s = machine.first_state; s < std::size_t{machine.first_state} + machine.state_count; ++s)
    if (lies_in(index, t.states[s].first_transition, t.states[s].transition_count)) {
      const JsonPath root, states(&root, "states"), state(&states, std::string(t.name_at(t.states[s].name)));
      return state.text() + numbered("/transitions/", t.states[s].first_transition);
    }
  return {};
}

/// The place below its node.
std::string place_in_node(const GraphTables& t, const GraphFault& fault, std::size_t settings) {
  switch (fault.table) {
    case GraphTable::point: return "/points/" + std::to_string(fault.index - t.spaces[settings].first_point);
    case GraphTable::child: return "/children/" + std::to_string(fault.index - t.selects[settings].first_child);
    case GraphTable::layer: return "/layers/" + std::to_string(fault.index - t.layers[settings].first_layer);
    case GraphTable::state: {
      const JsonPath root, states(&root, "states");
      return JsonPath(&states, std::string(t.name_at(t.states[fault.index].name))).text();
    }
    case GraphTable::transition: return place_of_transition(t, t.machines[settings], fault.index);
    case GraphTable::condition:
      for (std::uint32_t i = 0; i < t.transitions.size(); ++i)
        if (lies_in(fault.index, t.transitions[i].first_condition, t.transitions[i].condition_count))
          return place_of_transition(t, t.machines[settings], i) + "/when/" +
                 std::to_string(fault.index - t.transitions[i].first_condition);
      return {};
    default: return {};
  }
}

GraphTextFault text_fault(const GraphCompiler& compiler, const GraphFault& fault) {
  const GraphTables& t = compiler.t;
  const JsonPath root;
  if (fault.table == GraphTable::curve && fault.index < compiler.curve_places.size())
    return {compiler.curve_places[fault.index], fault.rule};
  if (fault.table == GraphTable::formula && fault.index < t.formulas.size()) {
    const JsonPath parameters(&root, "parameters");
    const JsonPath parameter(&parameters, std::string(t.name_at(t.parameters[t.formulas[fault.index].parameter].name)));
    return {JsonPath(&parameter, "formula").text(), fault.rule};
  }
  if (fault.table == GraphTable::parameter) {
    const JsonPath parameters(&root, "parameters");
    return {JsonPath(&parameters, std::string(t.name_at(t.parameters[fault.index].name))).text(), fault.rule};
  }
  if (fault.table == GraphTable::mask) {
    const JsonPath masks(&root, "masks");
    return {JsonPath(&masks, std::string(t.name_at(t.masks[fault.index].name))).text(), fault.rule};
  }
  if (fault.node >= t.nodes.size()) return {"", fault.rule};
  const JsonPath nodes(&root, "nodes");
  const std::string node = JsonPath(&nodes, std::string(t.name_at(t.nodes[fault.node].name))).text();
  return {node + place_in_node(t, fault, t.nodes[fault.node].settings), fault.rule};
}

}  // namespace

GraphTextResult<GraphDefinition> compile_graph(const GraphDocument& document) {
  GraphCompiler compiler(document);
  compiler.compile();
  if (compiler.failed) return tl::make_unexpected(compiler.fault);
  auto graph = GraphDefinition::make(compiler.t);
  if (!graph) return tl::make_unexpected(text_fault(compiler, graph.error()));
  return std::move(*graph);
}

}  // namespace sinew
