// SPDX-License-Identifier: MIT
#include "importer/rewrite/remove_unused.h"

#include <utility>

#include "importer/rewrite/references.h"

namespace sinew::rewrite {
namespace {

std::vector<std::size_t> count_uses(Draft& draft, Referenced kind, std::size_t entries) {
  std::vector<std::size_t> uses(entries, 0);
  for_each_reference(draft.json, [&](Referenced what, Json& index) {
    if (what == kind && index_of(index) < entries) ++uses[index_of(index)];
  });
  return uses;
}

/// The new index of each entry; kNone for removed ones: spare entries without a use.
std::vector<std::uint32_t> renumbered(const std::set<std::uint32_t>& spare, const std::vector<std::size_t>& uses) {
  std::vector<std::uint32_t> to(uses.size(), kNone);
  std::uint32_t next = 0;
  for (std::uint32_t i = 0; i < to.size(); ++i)
    if (uses[i] > 0 || !spare.contains(i)) to[i] = next++;
  return to;
}

bool moves(const std::vector<std::uint32_t>& to) {
  for (std::uint32_t i = 0; i < to.size(); ++i)
    if (to[i] != kNone && to[i] != i) return true;
  return false;
}

void keep_entries(Json& list, const std::vector<std::uint32_t>& to) {
  Json kept = Json::array();
  for (std::size_t i = 0; i < to.size(); ++i)
    if (to[i] != kNone) kept.push_back(std::move(list[i]));
  list = std::move(kept);
}

void renumber(Draft& draft, Referenced kind, const std::vector<std::uint32_t>& to) {
  if (!moves(to)) return;
  for (const std::string& name : extensions_with_unknown_numbers(draft.json))
    draft.losses.push_back({name, "/extensionsUsed", "may refer to entries that are renumbered"});
  for_each_reference(draft.json, [&](Referenced what, Json& index) {
    if (what == kind && index_of(index) < to.size()) index = to[index_of(index)];
  });
}

void remove_accessors(Draft& draft) {
  Json& accessors = list_of(draft, "accessors");
  const auto to = renumbered(draft.spare_accessors, count_uses(draft, Referenced::accessor, accessors.size()));
  for (std::size_t i = 0; i < to.size(); ++i) {
    if (to[i] != kNone) continue;
    if (const auto view = accessors[i].find("bufferView"); view != accessors[i].end())
      draft.spare_views.insert(index_of(*view));
    if (const auto sparse = accessors[i].find("sparse"); sparse != accessors[i].end())
      for (const char* part : {"indices", "values"})
        draft.spare_views.insert(index_of(sparse->at(part).at("bufferView")));
  }
  renumber(draft, Referenced::accessor, to);
  keep_entries(accessors, to);
}

void remove_views(Draft& draft) {
  Json& views = list_of(draft, "bufferViews");
  const auto to = renumbered(draft.spare_views, count_uses(draft, Referenced::view, views.size()));
  renumber(draft, Referenced::view, to);
  keep_entries(views, to);
  std::vector<Part> kept;
  for (std::size_t i = 0; i < to.size(); ++i)
    if (to[i] != kNone) kept.push_back(draft.parts[i]);
  draft.parts = std::move(kept);
}

}  // namespace

void remove_unused(Draft& draft) {
  if (!draft.spare_accessors.empty()) remove_accessors(draft);
  if (!draft.spare_views.empty()) remove_views(draft);
}

}  // namespace sinew::rewrite
