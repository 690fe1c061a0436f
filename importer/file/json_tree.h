// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstring>
#include <new>
#include <string_view>

#include <rapidjson/document.h>
#include <nlohmann/json.hpp>

namespace sinew {

/// Allocator of JSON trees. Uses operator new, so that running out of memory throws std::bad_alloc.
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

/// The JSON tree of a file. A glTF file has many small objects, so the tree is allocated in a few large blocks and
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

/// The member with a name; null if there is none. Of duplicate names, the last one counts.
JsonNode* find_member(JsonNode& object, std::string_view name) noexcept;
inline const JsonNode* find_member(const JsonNode& object, std::string_view name) noexcept {
  return find_member(const_cast<JsonNode&>(object), name);
}

inline std::string_view text_of(const JsonNode& string) noexcept {
  return {string.GetString(), string.GetStringLength()};
}

/// Converts between tree nodes and nlohmann::json, for parts of a document that outlive the tree.
nlohmann::json to_json(const JsonNode& node);
JsonNode from_json(const nlohmann::json& value, JsonPool& pool);

}  // namespace sinew
