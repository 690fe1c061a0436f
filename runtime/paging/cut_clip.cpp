// SPDX-License-Identifier: MIT
#include "runtime/paging/cut_clip.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "runtime/base/contract.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/paging/key_slices.h"

namespace sinew {
namespace {

/// The last key at or before a time (with equal times the last of them); the first key if all are later.
std::size_t last_key_until(std::span<const float> times_s, double time_s) noexcept {
  const auto after = std::upper_bound(times_s.begin(), times_s.end(), time_s,
                                      [](double t, float key) { return t < static_cast<double>(key); });
  return after == times_s.begin() ? 0 : static_cast<std::size_t>(after - times_s.begin()) - 1;
}

/// The keys needed for times from first_s to last_s. If a key is exactly at last_s, none after it is needed.
KeyRange keys_between(std::span<const float> times_s, double first_s, double last_s) noexcept {
  const std::size_t first = last_key_until(times_s, first_s), last = last_key_until(times_s, last_s);
  const bool is_between_keys = static_cast<double>(times_s[last]) < last_s && last + 1 < times_s.size();
  return {first, last + 1 + (is_between_keys ? 1 : 0)};
}

/// The clip with only the keys `keys_of(group)` of each group.
template <class KeysOf>
Clip with_keys(const Clip& clip, const KeysOf& keys_of) {
  ClipLayout part = clip.layout();
  for (TimeGroup& group : part.groups) {
    const KeyRange keys = keys_of(group);
    for (TrackBlock& block : group.blocks) {
      KeySlices kept;
      kept.add(block, keys);
      kept.move_to(block);
    }
    std::vector<float> times_s;
    add_slice(group.times.times_s(), keys.first, keys.end, times_s);
    group.times = KeyTimes(std::move(times_s));
  }
  return clip_of(std::move(part));
}

}  // namespace

Clip cut_clip(const Clip& clip, double first_s, double last_s) {
  CONTRACT(first_s <= last_s);
  return with_keys(clip, [&](const TimeGroup& group) { return keys_between(group.times.times_s(), first_s, last_s); });
}

Clip first_keys(const Clip& clip) {
  return with_keys(clip, [](const TimeGroup&) { return KeyRange{0, 1}; });
}

}  // namespace sinew
