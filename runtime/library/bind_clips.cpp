// SPDX-License-Identifier: MIT
#include "runtime/library/bind_clips.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "runtime/clip/rebind_clip.h"

namespace sinew {
namespace {

/// The index of each name in another list, kNone if it is missing or ambiguous.
struct Match {
  std::vector<std::uint32_t> target;
  std::vector<bool> is_ambiguous;
};

Match each_to_itself(std::size_t count) {
  Match match{std::vector<std::uint32_t>(count), std::vector<bool>(count)};
  for (std::uint32_t i = 0; i < count; ++i) match.target[i] = i;
  return match;
}

struct Named {
  std::uint32_t first = 0, count = 0;
};

std::unordered_map<std::string_view, Named> by_name(const SharedArray<std::string>& names) {
  std::unordered_map<std::string_view, Named> found;
  for (std::uint32_t i = 0; i < names.size(); ++i)
    if (!names[i].empty()) ++found.try_emplace(names[i], Named{i, 0}).first->second.count;
  return found;
}

Match match_names(const SharedArray<std::string>& from, const SharedArray<std::string>& to) {
  Match match{std::vector<std::uint32_t>(from.size(), kNone), std::vector<bool>(from.size())};
  const auto here = by_name(from), there = by_name(to);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const auto found = there.find(from[i]);
    if (found == there.end()) continue;
    match.is_ambiguous[i] = found->second.count > 1 || here.at(from[i]).count > 1;
    if (!match.is_ambiguous[i]) match.target[i] = found->second.first;
  }
  return match;
}

/// Matches weights or property components. No signature tells if their lists are equal, so the names are compared.
Match match_lists(const SharedArray<std::string>& from, const SharedArray<std::string>& to) {
  const bool all_named = std::none_of(from.begin(), from.end(), [](const std::string& name) { return name.empty(); });
  return from.shares_with(to) || (all_named && from == to) ? each_to_itself(from.size()) : match_names(from, to);
}

/// Appends the names that `names` does not contain yet, each once.
void append_new(std::vector<std::string>& names, const std::vector<std::string>& more) {
  std::unordered_set<std::string> there(names.begin(), names.end());
  for (const std::string& name : more)
    if (there.insert(name).second) names.push_back(name);
}

/// Sets `all` to (all or moved), entry by entry.
void unite(std::vector<bool>& all, const std::vector<bool>& moved) {
  all.resize(moved.size());
  for (std::size_t i = 0; i < moved.size(); ++i) all[i] = all[i] || moved[i];
}

/// Lists channels that are moved but have no target. Names that occur twice in `names` are listed twice.
void list_unbound(const std::vector<bool>& moved, const SharedArray<std::string>& names, const Match& match,
                  const char* kind, Unbound& unbound) {
  for (std::size_t i = 0; i < moved.size(); ++i) {
    if (!moved[i] || match.target[i] != kNone) continue;
    if (match.is_ambiguous[i])
      unbound.ambiguous.push_back(names[i]);
    else
      unbound.missing.push_back(names[i].empty() ? kind + std::to_string(i) + " without a name" : names[i]);
  }
}

}  // namespace

void Unbound::add(const Unbound& more) {
  append_new(missing, more.missing);
  append_new(ambiguous, more.ambiguous);
}

BoundClips bind_clips(std::span<const Clip> clips, const ClipChannels& from, const ClipChannels& to) {
  const Match joints =
      from.signature == to.signature ? each_to_itself(from.joints.size()) : match_names(from.joints, to.joints);
  const Match weights = match_lists(from.weights, to.weights), numbers = match_lists(from.numbers, to.numbers);
  const ClipTargets targets{joints.target, weights.target, numbers.target};
  BoundClips bound;
  ClipMotion all;
  for (const Clip& clip : clips) {
    const ClipMotion motion = motion_of(clip, from.rest);
    unite(all.joints, motion.joints);
    unite(all.weights, motion.weights);
    unite(all.numbers, motion.numbers);
    bound.clips.push_back(rebind_clip(clip, from.rest, targets, to.rest));
  }
  Unbound found;
  list_unbound(all.joints, from.joints, joints, "joint ", found);
  list_unbound(all.weights, from.weights, weights, "morph weight ", found);
  list_unbound(all.numbers, from.numbers, numbers, "property ", found);
  bound.unbound.add(found);
  return bound;
}

}  // namespace sinew
