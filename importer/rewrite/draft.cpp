// SPDX-License-Identifier: MIT
#include "importer/rewrite/draft.h"

#include <algorithm>
#include <utility>

#include "importer/file/json_pointer.h"

namespace sinew::rewrite {
namespace {

bool lies_in(Bytes part, Bytes whole) {
  const std::less_equal<> before;
  return before(whole.data(), part.data()) && before(part.data() + part.size(), whole.data() + whole.size());
}

/// Locates a view: a range of its buffer, or a new block if a decoder made its bytes.
Part part_of(const gltf::Document& document, const gltf::BufferView& view, Draft& draft) {
  if (view.buffer != kNone && lies_in(view.bytes, document.buffers[view.buffer].bytes)) {
    const auto offset = static_cast<std::size_t>(view.bytes.data() - document.buffers[view.buffer].bytes.data());
    return {view.buffer, offset, view.bytes.size()};
  }
  draft.blocks.push_back(view.bytes);
  return {static_cast<std::uint32_t>(draft.blocks.size() - 1), 0, view.bytes.size()};
}

void add_name(Json& root, const char* list, const char* name) {
  Json& names = root[list];
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

void take_name(Json& root, const char* list, const char* name) {
  const auto names = root.find(list);
  if (names == root.end()) return;
  names->erase(std::remove(names->begin(), names->end(), name), names->end());
  if (names->empty()) root.erase(names);
}

}  // namespace

std::uint32_t Draft::add_view(Bytes bytes_that_stay) {
  parts.push_back({static_cast<std::uint32_t>(blocks.size()), 0, bytes_that_stay.size()});
  blocks.push_back(bytes_that_stay);
  json["bufferViews"].push_back({{"buffer", 0}, {"byteLength", bytes_that_stay.size()}});
  return static_cast<std::uint32_t>(parts.size() - 1);
}

std::uint32_t Draft::add_view(std::vector<std::byte> bytes) {
  made.push_back(std::move(bytes));
  return add_view(Bytes(made.back()));
}

Draft make_draft(const CarriedDocument& source) {
  Draft draft;
  draft.json = source.json;
  for (const auto& buffer : source.document.buffers) draft.blocks.push_back(buffer.bytes);
  const std::size_t in_file = list_of(draft, "bufferViews").size();
  for (std::size_t i = 0; i < source.document.buffer_views.size(); ++i) {
    const auto& view = source.document.buffer_views[i];
    if (i >= in_file) draft.json["bufferViews"].push_back({{"buffer", 0}, {"byteLength", view.bytes.size()}});
    if (view.bytes.empty() && view.byte_length > 0) {
      draft.losses.push_back({"buffer-unread", pointer("bufferViews", i), "its buffer is missing"});
      draft.spare_views.insert(static_cast<std::uint32_t>(i));
      draft.parts.emplace_back();
    } else {
      draft.parts.push_back(part_of(source.document, view, draft));
    }
  }
  return draft;
}

Json& list_of(Draft& draft, const char* name) {
  static thread_local Json nothing = Json::array();
  const auto found = draft.json.find(name);
  return found == draft.json.end() ? nothing : *found;
}

void erase_extension(Json& object, const char* name) {
  const auto all = object.find("extensions");
  if (all == object.end()) return;
  all->erase(name);
  if (all->empty()) object.erase(all);
}

void declare(Draft& draft, const char* extension, bool required) {
  add_name(draft.json, "extensionsUsed", extension);
  if (required) add_name(draft.json, "extensionsRequired", extension);
}

void undeclare(Draft& draft, const char* extension) {
  take_name(draft.json, "extensionsUsed", extension);
  take_name(draft.json, "extensionsRequired", extension);
}

}  // namespace sinew::rewrite
