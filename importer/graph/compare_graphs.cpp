// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "importer/graph/graph_text.h"

namespace sinew {
namespace {

using nlohmann::json;

/// A list whose entries are known by the name in one of their members.
struct NamedList {
  const char *list, *member, *called;
};
constexpr std::array kNamedLists{NamedList{"transitions", "to", "transition to "},
                                 NamedList{"any", "to", "transition from any state to "},
                                 NamedList{"entry", "to", "entry rule of "}, NamedList{"layers", "node", "layer "},
                                 NamedList{"points", "node", "point "}};
constexpr std::array kNamedObjects{std::pair{"nodes", "node "},           std::pair{"states", "state "},
                                   std::pair{"parameters", "parameter "}, std::pair{"masks", "mask "},
                                   std::pair{"beats", "beat "},           std::pair{"variations", "variation "}};

std::string joined(const std::string& place, const std::string& part) {
  return place.empty() ? part : place + ", " + part;
}

/// The entries of a list by their names; a repeated name gets its number.
std::vector<std::pair<std::string, const json*>> entries_of(const json& list, const NamedList& names) {
  std::vector<std::pair<std::string, const json*>> entries;
  for (const json& entry : list) {
    const std::string name = entry.value(names.member, "");
    const auto same = std::count_if(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(entries.size()),
                                    [&](const json& other) { return other.value(names.member, "") == name; });
    entries.emplace_back(names.called + name + (same > 0 ? " (" + std::to_string(same + 1) + ")" : ""), &entry);
  }
  return entries;
}

class Comparison {
 public:
  std::vector<std::string> sentences;

  /// in   place  where both values are, in words;   key  of the member that holds them
  void compare(const std::string& place, const std::string& key, const json& before, const json& after) {
    if (before == after) return;
    if (before.is_object() && after.is_object()) return compare_objects(place, key, before, after);
    const auto names =
        std::find_if(kNamedLists.begin(), kNamedLists.end(), [&](const NamedList& n) { return key == n.list; });
    if (names != kNamedLists.end() && before.is_array() && after.is_array())
      return compare_lists(place, *names, before, after);
    sentences.push_back(place + ": " + key + " was " + before.dump() + " and is " + after.dump());
  }

 private:
  void compare_objects(const std::string& place, const std::string& key, const json& before, const json& after) {
    const auto names =
        std::find_if(kNamedObjects.begin(), kNamedObjects.end(), [&](const auto& n) { return key == n.first; });
    const bool named = names != kNamedObjects.end();
    for (const auto& [member, value] : before.items()) {
      const std::string here = named ? joined(place, names->second + member) : place;
      if (!after.contains(member))
        sentences.push_back(named ? here + ": is gone"
                                  : here + ": " + member + " was " + value.dump() + " and is unset");
      else
        compare(here, named ? "" : member, value, after[member]);
    }
    for (const auto& [member, value] : after.items()) {
      if (before.contains(member)) continue;
      const std::string here = named ? joined(place, names->second + member) : place;
      sentences.push_back(named ? here + ": is new, " + value.dump()
                                : here + ": " + member + " is new, " + value.dump());
    }
  }

  void compare_lists(const std::string& place, const NamedList& names, const json& before, const json& after) {
    const auto old_entries = entries_of(before, names), new_entries = entries_of(after, names);
    std::vector<std::string> kept_before, kept_after;
    const auto find = [](const auto& entries, const std::string& name) {
      return std::find_if(entries.begin(), entries.end(), [&](const auto& entry) { return entry.first == name; });
    };
    for (const auto& [name, entry] : old_entries) {
      const auto found = find(new_entries, name);
      if (found == new_entries.end()) {
        sentences.push_back(joined(place, name) + ": is gone");
        continue;
      }
      kept_before.push_back(name);
      compare(joined(place, name), "", *entry, *found->second);
    }
    for (const auto& [name, entry] : new_entries) {
      if (find(old_entries, name) != old_entries.end())
        kept_after.push_back(name);
      else
        sentences.push_back(joined(place, name) + ": is new, " + entry->dump());
    }
    if (kept_before != kept_after) sentences.push_back(place + ": the order of its " + names.list + " is another one");
  }
};

}  // namespace

std::vector<std::string> compare_graphs(const GraphDocument& before, const GraphDocument& after) {
  Comparison comparison;
  comparison.compare("graph", "", json::parse(write_graph(before)), json::parse(write_graph(after)));
  for (std::string& sentence : comparison.sentences)
    if (sentence.starts_with("graph, ")) sentence.erase(0, std::string("graph, ").size());
  return comparison.sentences;
}

}  // namespace sinew
