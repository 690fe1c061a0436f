// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstring>
#include <new>
#include <string_view>

#include <rapidjson/document.h>
#include <nlohmann/json.hpp>

namespace sinew {

/// Allocator of JSON trees. It uses operator new, so that running out of memory is an exception as elsewhere.
struct JsonMemory {
  static const bool kNeedFree = true;
  void* Malloc(std::size_t size) { return size == 0 ? nullptr : ::operator new(size); }
  void* Realloc(void* old, std::size_t old_size, std::size_t size) {
    void* grown = Malloc(size);
    if (old_size > 0 && size > 0) std::memcpy(grown, old, old_size < size ? old_size : size);
    ::operator delete(old);
    return grown;
  }
  static void Free(void* memory) noexcept { ::operator delete(memory); }
};

/// JSON as it comes from the file. A glTF file has many small objects, so a tree lies in a few large blocks and is
/// freed as a whole.
using JsonPool = rapidjson::MemoryPoolAllocator<JsonMemory>;
using JsonBuilder = rapidjson::GenericDocument<rapidjson::UTF8<>, JsonPool, JsonMemory>;
using JsonNode = JsonBuilder::ValueType;

struct JsonTree {
  explicit JsonTree(std::size_t piece_bytes) : pool(piece_bytes, &memory) {}
  JsonTree(const JsonTree&) = delete;
  JsonTree& operator=(const JsonTree&) = delete;

  JsonMemory memory;
  JsonPool pool;
  JsonNode root;
};

/// The value of a name, null where there is none. Of several values with one name the last counts.
JsonNode* find_member(JsonNode& object, std::string_view name) noexcept;
inline const JsonNode* find_member(const JsonNode& object, std::string_view name) noexcept {
  return find_member(const_cast<JsonNode&>(object), name);
}

inline std::string_view text_of(const JsonNode& string) noexcept {
  return {string.GetString(), string.GetStringLength()};
}

/// Converts the parts of a document that outlive the tree, and back.
nlohmann::json to_json(const JsonNode& node);
JsonNode from_json(const nlohmann::json& value, JsonPool& pool);

}  // namespace sinew
