// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "importer/file/json_tree.h"
#include "importer/file/tinygltf.h"

/// tinygltf reads normalised text of a document's core properties (core_text.h). Lists are read in slices, so that
/// memory for text and tree does not grow with the file. The text contains no buffers or images, so tinygltf loads
/// nothing. It omits `indices` of primitives, which tinygltf would compare with accessors.
/// err   std::runtime_error if tinygltf refuses the text or drops entries; earlier checks prevent both
namespace sinew {

/// Reads everything outside the lists with tinygltf: asset, extension names, default scene.
tinygltf::Model read_head(const JsonNode& root);

/// Reads the next entries of a list with tinygltf.
tinygltf::Model read_slice(const char* name, const JsonNode& list, std::size_t& next);

/// Throws if tinygltf dropped entries.
void expect_all(const char* name, std::size_t expected, std::size_t read);

/// Reads a list and converts each entry with `make(entry read by tinygltf, entry as JSON)`.
template <class Entry, class Make>
auto read_list(const JsonNode& root, const char* name, std::vector<Entry> tinygltf::Model::*entries, Make make) {
  std::vector<std::invoke_result_t<Make, Entry&&, const JsonNode&>> out;
  const JsonNode* list = find_member(root, name);
  if (list == nullptr) return out;
  out.reserve(list->Size());
  for (std::size_t next = 0; next < list->Size();) {
    tinygltf::Model slice = read_slice(name, *list, next);
    expect_all(name, next, out.size() + (slice.*entries).size());
    for (Entry& entry : slice.*entries)
      out.push_back(make(std::move(entry), (*list)[static_cast<rapidjson::SizeType>(out.size())]));
  }
  return out;
}

/// Reads a list without conversion.
template <class Entry>
std::vector<Entry> read_list(const JsonNode& root, const char* name, std::vector<Entry> tinygltf::Model::*entries) {
  return read_list(root, name, entries, [](Entry&& entry, const JsonNode&) { return std::move(entry); });
}

}  // namespace sinew
