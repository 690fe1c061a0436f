// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "importer/graph/graph_schema.h"
#include "importer/graph/graph_text.h"
#include "importer/graph/json_path.h"
#include "importer/graph/program_schema.h"
#include "importer/graph/trace_schema.h"

namespace sinew {

/// Reads members of objects as their schema describes them. Keeps the first fault.
class SchemaReader {
 public:
  using json = nlohmann::json;

  /// in   version_key  the member of the whole document that states the version of the format
  explicit SchemaReader(const char* version_key) : version_key_(version_key) {}

  GraphTextFault fault;
  bool failed = false;

  void fail(const JsonPath& path, std::string sentence) {
    if (!failed) fault = {path.text(), std::move(sentence)};
    failed = true;
  }

  void read(const json& from, const JsonPath& path, bool& to) {
    if (!from.is_boolean()) return fail(path, "is not true or false");
    to = from.get<bool>();
  }
  void read(const json& from, const JsonPath& path, float& to) {
    if (!from.is_number()) return fail(path, "is no number");
    const double value = from.get<double>();
    if (!(std::fabs(value) <= static_cast<double>(std::numeric_limits<float>::max())))
      return fail(path, "is too large a number");
    to = static_cast<float>(value);
  }
  void read(const json& from, const JsonPath& path, double& to) {
    if (!from.is_number() || !std::isfinite(from.get<double>())) return fail(path, "is no number");
    to = from.get<double>();
  }
  void read(const json& from, const JsonPath& path, std::int32_t& to) {
    if (!from.is_number_integer() || from.get<double>() < -1e9 || from.get<double>() > 1e9)
      return fail(path, "is no whole number of a sensible size");
    to = from.get<std::int32_t>();
  }
  void read(const json& from, const JsonPath& path, std::string& to) {
    if (!from.is_string()) return fail(path, "is no text");
    to = from.get<std::string>();
    if (to.find('\0') != std::string::npos) fail(path, "has a zero character");
  }
  template <class Word>
  requires std::is_enum_v<Word>
  void read(const json& from, const JsonPath& path, Word& to) {
    std::string word, words;
    read(from, path, word);
    const auto all = graph_schema::words_of(to);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (word == all[i]) {
        to = static_cast<Word>(i);
        return;
      }
      words += (i == 0 ? "" : ", ");
      words += all[i];
    }
    fail(path, "is none of " + words);
  }
  template <class T>
  void read(const json& from, const JsonPath& path, std::vector<T>& to) {
    if (!from.is_array()) return fail(path, "is no list");
    for (std::size_t i = 0; i < from.size() && !failed; ++i)
      read(from[i], {&path, std::to_string(i)}, to.emplace_back());
  }
  template <class T>
  void read(const json& from, const JsonPath& path, std::optional<T>& to) {
    to = T{};  // clang 14 refuses emplace() for a struct inside of another
    read(from, path, *to);
  }
  template <class T>
  void read(const json& from, const JsonPath& path, std::map<std::string, T>& to) {
    if (!from.is_object()) return fail(path, "is no object");
    for (const auto& [key, value] : from.items()) {
      if (failed) return;
      if (key.empty() || key.find('\0') != std::string::npos) return fail({&path, key}, "has no name");
      read(value, {&path, key}, to[key]);
    }
  }
  /// A joint of a mask may be its name alone.
  void read(const json& from, const JsonPath& path, GraphDocument::MaskJoint& to) {
    if (from.is_string()) return read(from, path, to.joint);
    read<GraphDocument::MaskJoint>(from, path, to);
  }
  template <class Object>
  requires std::is_class_v<Object>
  void read(const json& from, const JsonPath& path, Object& to) {
    if (!from.is_object()) return fail(path, "is no object");
    Members members{*this, from, path, {}};
    graph_schema::describe(members, to, static_cast<const Object*>(nullptr));
    for (const auto& [key, value] : from.items())
      if (!members.known.contains(key) && key != "editor" && !(path.parent == nullptr && key == version_key_))
        fail({&path, key}, "is not a known key here");
  }

 private:
  struct Members {
    SchemaReader& reader;
    const json& from;
    const JsonPath& path;
    std::set<std::string> known;

    template <class T>
    void required(const char* key, T& to, const char*) {
      if (!from.contains(key)) return reader.fail(path, std::string("has no \"") + key + "\"");
      optional(key, to, nullptr);
    }
    template <class T>
    void optional(const char* key, T& to, const char*) {
      known.insert(key);
      if (from.contains(key) && !reader.failed) reader.read(from[key], {&path, key}, to);
    }
  };

  const char* version_key_;
};

}  // namespace sinew
