// SPDX-License-Identifier: MIT
#include "importer/rewrite/compact_views.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "importer/read/accessor.h"
#include "importer/rewrite/references.h"
#include "importer/rewrite/streams.h"

namespace sinew::rewrite {
namespace {

/// Bytes of a view that accessors use, and their place in the new view.
struct Range {
  std::size_t begin = 0, end = 0, to = 0;
};

std::size_t offset_of(const Json& accessor) { return accessor.value("byteOffset", std::size_t{0}); }

std::size_t size_of(const Json& accessor) {
  const auto type = static_cast<gltf::ComponentType>(accessor["componentType"].get<int>());
  return accessor["count"].get<std::size_t>() * component_count(accessor) * component_bytes(type);
}

/// The ranges of all accessors of a view. Ranges that overlap become one.
std::vector<Range> ranges_of(const std::vector<std::uint32_t>& users, const Json& accessors) {
  std::vector<Range> all;
  for (const std::uint32_t user : users) {
    const std::size_t begin = offset_of(accessors[user]);
    all.push_back({begin, begin + size_of(accessors[user]), 0});
  }
  std::sort(all.begin(), all.end(), [](const Range& a, const Range& b) { return a.begin < b.begin; });
  std::vector<Range> joined;
  for (const Range& range : all) {
    if (!joined.empty() && range.begin < joined.back().end)
      joined.back().end = std::max(joined.back().end, range.end);
    else
      joined.push_back(range);
  }
  std::size_t size = 0;
  for (Range& range : joined) {
    range.to = (size + 3) / 4 * 4 + range.begin % 4;
    size = range.to + range.end - range.begin;
  }
  return joined;
}

bool shares_bytes(std::uint32_t view, const std::vector<Part>& parts) {
  const Part& own = parts[view];
  for (std::uint32_t other = 0; other < parts.size(); ++other)
    if (other != view && parts[other].block == own.block && parts[other].offset < own.offset + own.length &&
        own.offset < parts[other].offset + parts[other].length)
      return true;
  return false;
}

void compact(std::uint32_t view, const std::vector<std::uint32_t>& users, Draft& draft) {
  Json& accessors = draft.json["accessors"];
  const std::vector<Range> ranges = ranges_of(users, accessors);
  const Bytes before = draft.bytes_of(view);
  const std::size_t size = ranges.back().to + ranges.back().end - ranges.back().begin;
  if (size >= before.size() || ranges.back().end > before.size()) return;
  std::vector<std::byte> after(size);
  for (const Range& range : ranges)
    std::copy(before.begin() + static_cast<std::ptrdiff_t>(range.begin),
              before.begin() + static_cast<std::ptrdiff_t>(range.end),
              after.begin() + static_cast<std::ptrdiff_t>(range.to));
  for (const std::uint32_t user : users) {
    Json& accessor = accessors[user];
    const std::size_t offset = offset_of(accessor);
    const auto range = std::prev(std::upper_bound(ranges.begin(), ranges.end(), offset,
                                                  [](std::size_t at, const Range& r) { return at < r.begin; }));
    accessor.erase("byteOffset");
    if (const std::size_t to = range->to + offset - range->begin; to > 0) accessor["byteOffset"] = to;
  }
  draft.made.push_back(std::move(after));
  draft.parts[view] = {static_cast<std::uint32_t>(draft.blocks.size()), 0, size};
  draft.blocks.emplace_back(draft.made.back());
}

}  // namespace

void compact_views(const std::set<std::uint32_t>& views, Draft& draft) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> users;
  const Json& accessors = list_of(draft, "accessors");
  for (std::uint32_t a = 0; a < accessors.size(); ++a)
    if (const auto view = accessors[a].find("bufferView");
        view != accessors[a].end() && views.contains(index_of(*view)))
      users[index_of(*view)].push_back(a);
  std::map<std::uint32_t, std::size_t> uses;
  for_each_reference(draft.json, [&](Referenced kind, Json& index) {
    if (kind == Referenced::view) ++uses[index_of(index)];
  });
  for (const auto& [view, of_view] : users) {
    const Json& json = draft.json["bufferViews"][view];
    if (uses[view] != of_view.size() || json.contains("byteStride") || json.contains("extensions") ||
        draft.parts[view].block == kNone || shares_bytes(view, draft.parts))
      continue;
    compact(view, of_view, draft);
  }
}

}  // namespace sinew::rewrite
