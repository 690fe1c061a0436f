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

/// Schema of a JSON value. Tables of JsonProperty describe a document (gltf_shape.cpp).
enum class JsonKind : std::uint8_t { boolean, number, integer, string, object, array, index_map, extensions };

struct JsonObjectShape;

struct JsonValueShape {
  JsonKind kind;
  /// For numbers: their allowed range.
  double lower = std::numeric_limits<double>::lowest(), upper = std::numeric_limits<double>::max();
  std::span<const std::string_view> words{};  ///< strings: allowed values; empty = any
  std::span<const std::int64_t> numbers{};    ///< integers: allowed values; empty = any
  const JsonObjectShape* object = nullptr;    ///< objects: schema; null = any content
  const JsonValueShape* element = nullptr;    ///< arrays: schema of the elements
  std::size_t length = 0;                     ///< arrays: required length; 0 = any
};

struct JsonProperty {
  std::string_view name;
  JsonValueShape value;
  bool required = false;
};

/// Schema of an object. Properties not in the table are not checked.
struct JsonObjectShape {
  std::span<const JsonProperty> properties;
};

/// Checks a value against its schema and reports every violation with its location.
/// err      json-type, json-missing
/// warning  empty-array, json-duplicate, extension-value (an entry of `extensions` that is not an object)
/// cost     O(value)
void check_shape(const JsonNode& value, const JsonValueShape& shape, const std::string& place, IssueLog& log);
void check_shape(const nlohmann::json& value, const JsonValueShape& shape, const std::string& place, IssueLog& log);

}  // namespace sinew
