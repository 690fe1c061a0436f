// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "importer/file/document.h"
#include "importer/file/json_tree.h"

namespace sinew {

/// Typed access to the properties of one checked object. Absent properties have glTF's defaults.
class JsonFields {
 public:
  explicit JsonFields(const JsonNode& object) : object_(object) {}

  const JsonNode* find(std::string_view name) const { return find_member(object_, name); }

  double number(std::string_view name, double fallback) const {
    const JsonNode* value = find(name);
    return value == nullptr ? fallback : value->GetDouble();
  }

  /// An integer below 2^53; also accepts "3.0".
  std::uint64_t size(std::string_view name) const { return static_cast<std::uint64_t>(number(name, 0.0)); }

  std::uint32_t index(std::string_view name, std::uint32_t fallback = kNone) const {
    const JsonNode* value = find(name);
    return value == nullptr ? fallback : as_index(*value);
  }

  bool flag(std::string_view name) const {
    const JsonNode* value = find(name);
    return value != nullptr && value->GetBool();
  }

  std::string text(std::string_view name, const char* fallback = "") const {
    const JsonNode* value = find(name);
    return value != nullptr && value->IsString() ? std::string(text_of(*value)) : fallback;
  }

  /// An index as tinygltf's types hold it.
  int signed_index(std::string_view name, int fallback = gltf::kAbsent) const {
    const JsonNode* value = find(name);
    return value == nullptr ? fallback : static_cast<int>(value->GetDouble());
  }

  /// A member as JSON, for later code; null if absent.
  gltf::Json part(std::string_view name) const {
    const JsonNode* value = find(name);
    return value == nullptr ? gltf::Json() : to_json(*value);
  }

  /// A list of entries converted by `read(entry)`.
  template <class Read>
  auto list(std::string_view name, Read read) const {
    std::vector<decltype(read(object_))> out;
    if (const JsonNode* values = find(name)) {
      out.reserve(values->Size());
      for (const JsonNode& value : values->GetArray()) out.push_back(read(value));
    }
    return out;
  }

  std::vector<double> numbers(std::string_view name) const {
    return list(name, [](const JsonNode& value) { return value.GetDouble(); });
  }
  std::vector<int> signed_indices(std::string_view name) const {
    return list(name, [](const JsonNode& value) { return static_cast<int>(value.GetDouble()); });
  }
  std::vector<std::string> texts(std::string_view name) const {
    return list(name,
                [](const JsonNode& value) { return value.IsString() ? std::string(text_of(value)) : std::string(); });
  }

  static std::uint32_t as_index(const JsonNode& value) { return static_cast<std::uint32_t>(value.GetDouble()); }

 private:
  const JsonNode& object_;
};

}  // namespace sinew
