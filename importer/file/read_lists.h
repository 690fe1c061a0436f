// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "importer/file/json_tree.h"
#include "importer/file/tinygltf.h"

/// tinygltf reads a document from the text of its core properties (core_text.h), a slice of a list at a time: neither
/// the text nor tinygltf's own tree of it grows with the file. The text names no buffer and no image, so tinygltf loads
/// nothing, and has no `indices` of primitives, which tinygltf compares with accessors.
/// err   std::runtime_error where tinygltf refuses the text or leaves out entries: what it may refuse is checked before
namespace sinew {

/// What tinygltf says of everything outside the lists: asset, names of extensions, default scene.
tinygltf::Model read_head(const JsonNode& root);

/// What tinygltf says of the next entries of a list.
tinygltf::Model read_slice(const char* name, const JsonNode& list, std::size_t& next);

/// Throws where tinygltf left out entries.
void expect_all(const char* name, std::size_t expected, std::size_t read);

/// What `make(entry as tinygltf reads it, entry as JSON)` returns of each entry of a list of the document.
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

/// The entries as tinygltf reads them.
template <class Entry>
std::vector<Entry> read_list(const JsonNode& root, const char* name, std::vector<Entry> tinygltf::Model::*entries) {
  return read_list(root, name, entries, [](Entry&& entry, const JsonNode&) { return std::move(entry); });
}

}  // namespace sinew
