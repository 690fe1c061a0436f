// SPDX-License-Identifier: MIT
#include "importer/graph/join_graphs.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "importer/graph/formula_text.h"
#include "importer/graph/json_path.h"

namespace sinew {
namespace {

using Document = GraphDocument;

std::string pointer_to(const char* list, const std::string& name) {
  const JsonPath root, all(&root, list);
  return JsonPath(&all, name).text();
}

const std::string& renamed(const Document::Names& names, const std::string& name) {
  const auto found = names.find(name);
  return found == names.end() ? name : found->second;
}

class GraphJoin {
 public:
  GraphJoin(JoinedGraph& to, const std::string& name, const JoinedGraph& from, const std::string& file)
      : to_(to), name_(name), from_(from), file_(file), reference_(to.document.nodes.at(name)) {}

  std::optional<GraphTextFault> fault;

  void join() {
    check_names();
    for (const auto& [name, parameter] : from_.document.parameters) join_parameter(name, parameter);
    for (const auto& [name, beat] : from_.document.beats) join_beat(name, beat);
    for (const auto& [name, joints] : from_.document.masks) {
      for (GraphDocument::MaskJoint& entry : to_.document.masks[prefixed(name)] = joints)
        if (!entry.mask.empty()) entry.mask = prefixed(entry.mask);
      set_origin("masks", prefixed(name), name);
    }
    for (const auto& [name, clips] : from_.document.variations) join_variation(name, clips);
    if (fault) return;
    if (!from_.document.nodes.contains(from_.document.root))
      return fail({"file"}, "has no node \"" + from_.document.root + "\", which is its root");
    for (const auto& [name, node] : from_.document.nodes) {
      const std::string here = name == from_.document.root ? name_ : prefixed(name);
      if (here != name_ && to_.document.nodes.contains(here))
        return fail({}, "there is a node \"" + here + "\" already");
      to_.document.nodes[here] = node_of(node);
      set_origin("nodes", here, name);
    }
  }

 private:
  /// in   keys  below the node that refers to the graph
  void fail(const std::vector<std::string>& keys, const std::string& sentence) {
    if (fault) return;
    std::string place = pointer_to("nodes", name_);
    for (const std::string& key : keys) {
      const JsonPath root;
      place += JsonPath(&root, key).text();
    }
    fault = GraphTextFault{place, file_ + ": " + sentence};
  }

  std::string prefixed(const std::string& name) const { return name.empty() ? name : name_ + '/' + name; }
  std::string node_name(const std::string& name) const { return name == from_.document.root ? name_ : prefixed(name); }
  const std::string& parameter_name(const std::string& name) const { return renamed(reference_.parameters, name); }

  void set_origin(const char* list, const std::string& here, const std::string& there) {
    const std::string pointer = pointer_to(list, there);
    const auto deeper = from_.origins.find(pointer);
    to_.origins[pointer_to(list, here)] =
        deeper == from_.origins.end() ? JoinedGraph::Origin{file_, pointer} : deeper->second;
  }

  bool plays(const std::string& clip) const {
    return std::any_of(from_.document.nodes.begin(), from_.document.nodes.end(), [&](const auto& node) {
      return node.second.kind == Document::NodeKind::clip && node.second.clip == clip;
    });
  }

  void check_names() {
    for (const auto& [old, name] : reference_.parameters) {
      if (!from_.document.parameters.contains(old))
        fail({"parameters", old}, "has no parameter \"" + old + "\"");
      else if (!to_.document.parameters.contains(name))
        fail({"parameters", old}, "there is no parameter \"" + name + "\"");
    }
    for (const auto& [old, name] : reference_.clips)
      if (!plays(old)) fail({"clips", old}, "plays no clip \"" + old + "\"");
  }

  void join_parameter(const std::string& name, const Document::Parameter& parameter) {
    const std::string& here = parameter_name(name);
    const auto [entry, is_new] = to_.document.parameters.try_emplace(here, parameter);
    if (is_new) {
      entry->second.formula = rename_in_formula(parameter.formula, reference_.parameters);
      set_origin("parameters", here, name);
    } else if (entry->second.kind != parameter.kind) {
      fail({"file"}, "its parameter \"" + name + "\" is of another kind than \"" + here + "\" here");
    }
  }

  void join_beat(const std::string& name, const Document::Beat& beat) {
    const auto [entry, is_new] = to_.document.beats.try_emplace(name, beat);
    const Document::Beat& here = entry->second;
    if (is_new)
      set_origin("beats", name, name);
    else if (here.event != beat.event || here.foot != beat.foot || here.mirror != beat.mirror)
      fail({"file"}, "its beat \"" + name + "\" is another one than that here");
  }

  void join_variation(const std::string& name, const Document::Names& clips) {
    for (const auto& [old, clip] : clips) {
      const std::string& here = renamed(reference_.clips, old);
      const auto [entry, is_new] = to_.document.variations[name].try_emplace(here, clip);
      if (!is_new && entry->second != clip)
        fail({"file"}, "its variation \"" + name + "\" plays another clip for \"" + here + "\" than that here");
    }
  }

  std::vector<Document::Transition> transitions_of(std::vector<Document::Transition> transitions) const {
    for (Document::Transition& transition : transitions)
      for (Document::Condition& condition : transition.when) condition.parameter = parameter_name(condition.parameter);
    return transitions;
  }

  Document::Node node_of(Document::Node node) const {
    node.clip = renamed(reference_.clips, node.clip);
    for (std::string* parameter : {&node.speed_by, &node.x, &node.y, &node.by}) *parameter = parameter_name(*parameter);
    for (Document::Point& point : node.points) point.node = node_name(point.node);
    for (std::string& child : node.children) child = node_name(child);
    node.base = node_name(node.base);
    for (Document::Layer& layer : node.layers) {
      layer.node = node_name(layer.node);
      layer.weight_by = parameter_name(layer.weight_by);
      layer.mask = prefixed(layer.mask);
    }
    for (auto& [name, state] : node.states) {
      state.node = node_name(state.node);
      state.transitions = transitions_of(std::move(state.transitions));
    }
    node.any = transitions_of(std::move(node.any));
    node.entry = transitions_of(std::move(node.entry));
    return node;
  }

  JoinedGraph& to_;
  const std::string name_;
  const JoinedGraph& from_;
  const std::string& file_;
  const Document::Node reference_;  // a copy, since its place is taken
};

}  // namespace

std::optional<GraphTextFault> join_graph(JoinedGraph& to, const std::string& name, const JoinedGraph& from,
                                         const std::string& file) {
  GraphJoin join(to, name, from, file);
  join.join();
  return join.fault;
}

}  // namespace sinew
