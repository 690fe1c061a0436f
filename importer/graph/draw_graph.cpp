// SPDX-License-Identifier: MIT
#include <string>

#include <nlohmann/json.hpp>

#include "importer/graph/graph_schema.h"
#include "importer/graph/graph_text.h"

namespace sinew {
namespace {

/// A number as JSON text has it: without zeros at its end.
std::string shown(float value) { return nlohmann::json(static_cast<double>(value)).dump().substr(0, 8); }

/// Text between quotes for GraphViz, in which "\n" breaks a line.
std::string dot_string(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n')
      out += "\\n";
    else
      out += c;
  }
  return out + '"';
}

std::string condition_text(const GraphDocument::Condition& c) {
  const std::string parameter = c.parameter;
  switch (c.kind) {
    case GraphConditionKind::above: return parameter + " > " + shown(c.value);
    case GraphConditionKind::below: return parameter + " < " + shown(c.value);
    case GraphConditionKind::equal: return parameter + " = " + shown(c.value);
    case GraphConditionKind::not_equal: return parameter + " != " + shown(c.value);
    case GraphConditionKind::on: return parameter;
    case GraphConditionKind::off: return "not " + parameter;
    case GraphConditionKind::trigger: return parameter + "!";
    case GraphConditionKind::time_in_state: return "after " + shown(c.value) + " s";
    case GraphConditionKind::played: return "played " + shown(c.value) + " times";
    case GraphConditionKind::phase: return "at phase " + shown(c.value);
  }
  return {};
}

std::string transition_text(const GraphDocument::Transition& t) {
  std::string text;
  for (const GraphDocument::Condition& condition : t.when)
    text += (text.empty() ? "" : "\nand ") + condition_text(condition);
  return text + (text.empty() ? "" : "\n") + shown(t.duration_s) + " s";
}

class Drawing {
 public:
  explicit Drawing(const GraphDocument& document) : document_(document) {}

  std::string draw() {
    text_ =
        "digraph graph_of_motion {\n  rankdir=LR;\n  node [shape=box, style=rounded, fontname=\"sans-serif\"];\n"
        "  edge [fontname=\"sans-serif\", fontsize=10];\n";
    for (const auto& [name, node] : document_.nodes)
      if (node.kind == GraphDocument::NodeKind::machine)
        machine(name, node);
      else
        text_ += "  " + node_id(name) + " [label=" + dot_string(name + "\n" + summary(node)) + "];\n";
    for (const auto& [name, node] : document_.nodes) children(name, node);
    text_ += "  pose [shape=plaintext];\n  " + node_id(document_.root) + " -> pose [style=bold];\n}\n";
    return text_;
  }

 private:
  static std::string node_id(const std::string& name) { return dot_string("node " + name); }
  static std::string state_id(const std::string& machine, const std::string& state) {
    return dot_string("state " + machine + "/" + state);
  }

  static std::string summary(const GraphDocument::Node& node) {
    switch (node.kind) {
      case GraphDocument::NodeKind::clip:
        return "clip " + node.clip + (node.speed_by.empty() ? "" : "\nspeed by " + node.speed_by) +
               (node.mirror ? "\nmirrored" : "");
      case GraphDocument::NodeKind::blend_space:
        return "blend space over " + node.x + (node.y.empty() ? "" : " and " + node.y);
      case GraphDocument::NodeKind::select: return "select by " + node.by;
      case GraphDocument::NodeKind::external: return "pose " + std::to_string(node.pose) + " of the caller";
      case GraphDocument::NodeKind::graph: return "graph of " + node.file;
      default: return graph_schema::words_of(node.kind)[static_cast<std::size_t>(node.kind)];
    }
  }

  void edge(const std::string& from, const std::string& to, const std::string& label, const char* style = "") {
    text_ += "  " + from + " -> " + to + " [label=" + dot_string(label) + style + "];\n";
  }

  /// A frame with a box for each state. A point in it stands for the machine, and another one for "any state".
  void machine(const std::string& name, const GraphDocument::Node& node) {
    text_ += "  subgraph " + dot_string("cluster " + name) + " {\n    label=" + dot_string(name) + ";\n    " +
             node_id(name) + " [shape=point];\n";
    for (const auto& [state, of_state] : node.states)
      text_ += "    " + state_id(name, state) + " [label=" + dot_string(state) +
               (state == node.initial ? ", penwidth=2" : "") + "];\n";
    if (!node.any.empty()) text_ += "    " + state_id(name, "\nany") + " [label=\"any state\", shape=plaintext];\n";
    text_ += "  }\n";
    for (const auto& [state, of_state] : node.states)
      for (const GraphDocument::Transition& t : of_state.transitions)
        edge(state_id(name, state), state_id(name, t.to), transition_text(t));
    for (const GraphDocument::Transition& t : node.any)
      edge(state_id(name, "\nany"), state_id(name, t.to), transition_text(t));
    for (const GraphDocument::Transition& t : node.entry)
      edge(node_id(name), state_id(name, t.to), "enters if " + transition_text(t), ", style=dashed");
  }

  void children(const std::string& name, const GraphDocument::Node& node) {
    constexpr const char* kUses = ", style=dotted, arrowhead=none";
    for (const auto& [state, of_state] : node.states) edge(node_id(of_state.node), state_id(name, state), "", kUses);
    for (const GraphDocument::Point& p : node.points)
      edge(node_id(p.node), node_id(name), node.y.empty() ? shown(p.x) : shown(p.x) + ", " + shown(p.y));
    for (std::size_t i = 0; i < node.children.size(); ++i)
      edge(node_id(node.children[i]), node_id(name), std::to_string(i));
    if (!node.base.empty()) edge(node_id(node.base), node_id(name), "base");
    for (const GraphDocument::Layer& layer : node.layers)
      edge(node_id(layer.node), node_id(name),
           std::string(graph_schema::words_of(layer.kind)[static_cast<std::size_t>(layer.kind)]) + " " +
               shown(layer.weight) + (layer.weight_by.empty() ? "" : " by " + layer.weight_by) +
               (layer.mask.empty() ? "" : ", " + layer.mask));
  }

  const GraphDocument& document_;
  std::string text_;
};

}  // namespace

std::string draw_graph(const GraphDocument& document) { return Drawing(document).draw(); }

}  // namespace sinew
