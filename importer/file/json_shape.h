// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "importer/file/json_tree.h"
#include "importer/issue_log.h"

namespace sinew {

/// What a JSON property must look like. Tables of JsonProperty describe a document (gltf_shape.cpp).
enum class JsonKind : std::uint8_t { boolean, number, integer, string, object, array, index_map, extensions };

struct JsonObjectShape;

struct JsonValueShape {
  JsonKind kind;
  double lower = std::numeric_limits<double>::lowest(), upper = std::numeric_limits<double>::max();  ///< numbers
  std::span<const std::string_view> words{};  ///< strings: the allowed ones, empty = any
  std::span<const std::int64_t> numbers{};    ///< integers: the allowed ones, empty = any
  const JsonObjectShape* object = nullptr;    ///< of objects, null = any content
  const JsonValueShape* element = nullptr;    ///< of arrays
  std::size_t length = 0;                     ///< of arrays, 0 = any
};

struct JsonProperty {
  std::string_view name;
  JsonValueShape value;
  bool required = false;
};

/// An object. Properties that the table does not name may hold anything.
struct JsonObjectShape {
  std::span<const JsonProperty> properties;
};

/// Compares a value with its description and reports every difference with its place.
/// err      json-type, json-missing
/// warning  empty-array, json-duplicate, extension-value (an entry of `extensions` that is no object)
/// cost     O(value)
void check_shape(const JsonNode& value, const JsonValueShape& shape, const std::string& place, IssueLog& log);
void check_shape(const nlohmann::json& value, const JsonValueShape& shape, const std::string& place, IssueLog& log);

}  // namespace sinew
