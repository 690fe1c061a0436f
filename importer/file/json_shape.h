// SPDX-License-Identifier: MIT
#pragma once
#include <array>
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

class JsonObjectShape;

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
class JsonObjectShape {
 public:
  static constexpr std::size_t kMost = 32;

  template <std::size_t N>
  constexpr explicit(false) JsonObjectShape(const JsonProperty (&table)[N]) : properties(table) {
    static_assert(N <= kMost);
    for (std::size_t p = 0; p < N; ++p) {
      std::size_t slot = slot_of(table[p].name);
      while (slots_[slot] != 0) slot = (slot + 1) % kSlots;
      slots_[slot] = static_cast<std::uint8_t>(p + 1);
    }
  }

  /// The property with a name; kMost if there is none. A hash table with linear probing; its size is twice kMost, so
  /// that it always has a free slot.
  constexpr std::size_t find(std::string_view name) const noexcept {
    for (std::size_t slot = slot_of(name); slots_[slot] != 0; slot = (slot + 1) % kSlots)
      if (const std::size_t p = slots_[slot] - 1u; properties[p].name == name) return p;
    return kMost;
  }

  std::span<const JsonProperty> properties;

 private:
  static constexpr std::size_t kSlots = 2 * kMost;
  static constexpr std::size_t slot_of(std::string_view name) noexcept {
    const auto letter = [&](std::size_t i) { return static_cast<unsigned char>(name[i]); };
    return name.empty()
               ? 0
               : (name.size() * 5 + letter(0) + letter(name.size() / 2) * 3 + letter(name.size() - 1) * 7) % kSlots;
  }

  std::array<std::uint8_t, kSlots> slots_{};  ///< index of the property + 1; 0 = free
};

/// Checks a value against its schema and reports every violation with its location.
/// err      json-type, json-missing
/// warning  empty-array, json-duplicate, extension-value (an entry of `extensions` that is not an object)
/// cost     O(value)
void check_shape(const JsonNode& value, const JsonValueShape& shape, const std::string& place, IssueLog& log);
void check_shape(const nlohmann::json& value, const JsonValueShape& shape, const std::string& place, IssueLog& log);

}  // namespace sinew
