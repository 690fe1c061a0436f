// SPDX-License-Identifier: MIT
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "importer/graph/graph_schema.h"
#include "importer/graph/graph_text.h"
#include "runtime/graph/graph_time.h"

namespace sinew {
namespace {

// Members keep the order of the schema: `kind` and `node` come first.
using Ordered = nlohmann::ordered_json;

Ordered written(bool value) { return value; }
Ordered written(float value) { return decimal_of(value); }
Ordered written(std::int32_t value) { return value; }
Ordered written(const std::string& value) { return value; }
template <class Word>
requires std::is_enum_v<Word> Ordered written(Word value) {
  return graph_schema::words_of(value)[static_cast<std::size_t>(value)];
}
template <class Object>
requires std::is_class_v<Object> Ordered written(const Object& object);
template <class T>
Ordered written(const std::vector<T>& values) {
  Ordered list = Ordered::array();
  for (const T& value : values) list.push_back(written(value));
  return list;
}
template <class T>
Ordered written(const std::map<std::string, T>& values) {
  Ordered object = Ordered::object();
  for (const auto& [name, value] : values) object[name] = written(value);
  return object;
}

template <class T>
Ordered written(const std::optional<T>& value) {
  return value ? written(*value) : Ordered();
}

/// All members, in the order of the schema.
struct Collected {
  std::vector<std::pair<const char*, Ordered>> members;
  std::vector<bool> is_required;

  template <class T>
  void required(const char* key, const T& value, const char*) {
    members.emplace_back(key, written(value));
    is_required.push_back(true);
  }
  template <class T>
  void optional(const char* key, const T& value, const char*) {
    members.emplace_back(key, written(value));
    is_required.push_back(false);
  }
};

template <class Object>
Object defaults_of(const Object&) {
  return {};
}
GraphDocument::Node defaults_of(const GraphDocument::Node& node) {
  GraphDocument::Node defaults;
  defaults.kind = node.kind;  // which decides on the members
  return defaults;
}

template <class Object>
requires std::is_class_v<Object> Ordered written(const Object& object) {
  Collected all, standard;
  const Object defaults = defaults_of(object);
  graph_schema::describe(all, object, static_cast<const Object*>(nullptr));
  graph_schema::describe(standard, defaults, static_cast<const Object*>(nullptr));
  if constexpr (std::is_same_v<Object, GraphDocument::MaskJoint>)
    if (object.mask.empty() && object.weight == defaults.weight && object.below == defaults.below) return object.joint;
  Ordered to = Ordered::object();
  for (std::size_t i = 0; i < all.members.size(); ++i)
    if (all.is_required[i] || all.members[i].second != standard.members[i].second)
      to[all.members[i].first] = all.members[i].second;
  return to;
}

/// Lists the members of an object in rows of a table.
struct Rows {
  std::string& text;
  std::string object;

  template <class T>
  void row(const char* key, const T& value, const char* about, const char* standard) {
    text += "| " + object + " | `" + key + "` | " + about;
    if constexpr (std::is_enum_v<T>) {
      text += ": ";
      bool first = true;
      for (const char* word : graph_schema::words_of(value)) {
        text += std::string(first ? "`" : ", `") + word + "`";
        first = false;
      }
    }
    text += std::string(" | ") + standard + " |\n";
  }
  template <class T>
  void required(const char* key, const T& value, const char* about) {
    row(key, value, about, "required");
  }
  template <class T>
  void optional(const char* key, const T& value, const char* about) {
    std::string standard;
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      const Ordered text_of = written(value);
      standard = text_of.is_string() ? text_of.get<std::string>() : text_of.dump();
    }
    row(key, value, about, standard.c_str());
  }
};

template <class Object>
void list_members(std::string& text, const char* name, const Object& object = {}) {
  Rows rows{text, name};
  graph_schema::describe(rows, object, static_cast<const Object*>(nullptr));
}

}  // namespace

std::string write_graph(const GraphDocument& document) {
  Ordered all = Ordered::object();
  all["graph"] = graph_schema::kVersion;
  const Ordered members = written(document);
  for (const auto& [key, value] : members.items()) all[key] = value;
  return all.dump(2, ' ', false, Ordered::error_handler_t::replace) + '\n';
}

std::string describe_graph_format() {
  std::string text = "| object | key | meaning | default |\n|---|---|---|---|\n";
  list_members<GraphDocument>(text, "graph");
  list_members<GraphDocument::Parameter>(text, "parameter");
  for (std::size_t kind = 0; kind < graph_schema::words_of(GraphDocument::NodeKind{}).size(); ++kind) {
    GraphDocument::Node node;
    node.kind = static_cast<GraphDocument::NodeKind>(kind);
    const bool is_reference = node.kind == GraphDocument::NodeKind::graph;
    list_members(text, is_reference ? "graph (node)" : graph_schema::words_of(node.kind)[kind], node);
  }
  list_members<GraphDocument::Point>(text, "point");
  list_members<GraphDocument::Layer>(text, "layer");
  list_members<GraphDocument::MaskJoint>(text, "mask");
  list_members<GraphDocument::Beat>(text, "beat");
  list_members<GraphDocument::State>(text, "state");
  list_members<GraphDocument::Transition>(text, "transition");
  list_members<GraphDocument::Curve>(text, "curve");
  list_members<GraphDocument::CurveKey>(text, "key");
  list_members<GraphDocument::Condition>(text, "condition");
  return text;
}

}  // namespace sinew
