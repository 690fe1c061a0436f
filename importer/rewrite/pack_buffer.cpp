// SPDX-License-Identifier: MIT
#include "importer/rewrite/pack_buffer.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "importer/file/json_pointer.h"
#include "importer/file/meshopt_extension.h"

namespace sinew::rewrite {
namespace {

/// A contiguous range of a block that is covered by views, and its destination.
struct Run {
  std::uint32_t block = kNone;
  std::size_t begin = 0, end = 0, to = 0;
};

std::vector<std::uint32_t> by_place(const std::vector<Part>& parts) {
  std::vector<std::uint32_t> order(parts.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) { return std::tuple(parts[i].block, parts[i].offset, parts[i].length); };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  return order;
}

/// Sets the location of a view in the new buffer: in its compression extension, if it has one.
void set_place(Json& view, std::size_t offset, std::size_t length) {
  Json* place = &view;
  if (Json* stream = extension_of(view, "EXT_meshopt_compression")) place = stream;
  (*place)["buffer"] = 0;
  (*place)["byteLength"] = length;
  place->erase("byteOffset");
  if (offset > 0) (*place)["byteOffset"] = offset;
}

/// Moves the decoded ranges of compressed views to a fallback buffer without data, as EXT_meshopt_compression requires.
void add_fallback(Json& root) {
  constexpr const char* kName = "EXT_meshopt_compression";
  std::size_t size = 0;
  for (Json& view : root["bufferViews"])
    if (extension_of(view, kName) != nullptr) {
      if (size > 0) view["byteOffset"] = size;
      size += (view["byteLength"].get<std::size_t>() + 3) / 4 * 4;
    }
  if (size > 0) root["buffers"].push_back({{"byteLength", size}, {"extensions", {{kName, {{"fallback", true}}}}}});
}

/// Merges all buffer entries into one. It keeps the properties of the first; those of others are losses.
Json merged_buffer(Draft& draft) {
  Json merged = Json::object();
  Json& buffers = list_of(draft, "buffers");
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    Json own = buffers[i];
    while (const auto meshopt = meshopt_extension(own.value("extensions", Json()))) erase_extension(own, meshopt.name);
    for (const char* name : {"uri", "byteLength"}) own.erase(name);
    if (i == 0)
      merged = std::move(own);
    else if (!own.empty())
      draft.losses.push_back(
          {"buffer-properties", pointer("buffers", i), "the buffers become one, with the properties of the first"});
  }
  return merged;
}

}  // namespace

std::vector<std::byte> pack_buffer(Draft& draft) {
  std::vector<std::byte> out;
  const auto close = [&](const Run& run) {
    const auto bytes = draft.blocks[run.block].subspan(run.begin, run.end - run.begin);
    out.resize(run.to);
    out.insert(out.end(), bytes.begin(), bytes.end());
  };
  Json& views = list_of(draft, "bufferViews");
  Run run;
  for (const std::uint32_t i : by_place(draft.parts)) {
    const Part& part = draft.parts[i];
    if (part.block == kNone) {
      set_place(views[i], 0, 0);
      continue;
    }
    if (run.block != part.block || part.offset > run.end) {
      if (run.block != kNone) close(run);
      const std::size_t to = out.size() + (part.offset - out.size()) % 4;
      run = {part.block, part.offset, part.offset, to};
    }
    run.end = std::max(run.end, part.offset + part.length);
    set_place(views[i], run.to + (part.offset - run.begin), part.length);
  }
  if (run.block != kNone) close(run);
  Json merged = merged_buffer(draft);
  draft.json.erase("buffers");
  if (out.empty() && views.empty()) return out;
  if (out.empty()) out.resize(4);  // views without bytes also refer to the buffer, which must not be empty
  merged["byteLength"] = out.size();
  draft.json["buffers"] = Json::array({std::move(merged)});
  add_fallback(draft.json);
  return out;
}

}  // namespace sinew::rewrite
