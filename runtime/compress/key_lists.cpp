// SPDX-License-Identifier: MIT
#include "runtime/compress/key_lists.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <type_traits>
#include <utility>

#include "runtime/animation/track_sample.h"
#include "runtime/compress/fit_keys.h"
#include "runtime/compress/remove_keys.h"

namespace sinew {
namespace {

using Keys = std::vector<std::uint32_t>;

/// Tracks that keep the same keys of the same list.
struct SharedList {
  Keys keys;
  std::size_t bytes_per_key = 0;     ///< bytes of the values of all tracks, per key
  std::vector<std::size_t> members;  ///< indices of tracks
};

/// The bytes that a file saves if two lists become one; negative if it grows.
std::int64_t saved(const SharedList& a, const SharedList& b, const Keys& both) {
  const auto bytes = [](std::size_t keys, std::size_t per_key) { return static_cast<std::int64_t>(keys * per_key); };
  return static_cast<std::int64_t>(FileBytes::kTimes) +
         bytes(a.keys.size() + b.keys.size() - both.size(), sizeof(float)) -
         bytes(both.size() - a.keys.size(), a.bytes_per_key) - bytes(both.size() - b.keys.size(), b.bytes_per_key);
}

Keys together(const Keys& a, const Keys& b) {
  Keys both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

/// Merges the pair of lists that saves most, again and again.
void merge(std::vector<SharedList>& lists) {
  for (;;) {
    std::int64_t most = 0;
    std::pair<std::size_t, std::size_t> best;
    for (std::size_t a = 0; a < lists.size(); ++a)
      for (std::size_t b = a + 1; b < lists.size(); ++b) {
        // The keys that one list has more than the other are a lower bound of what merging adds.
        const bool first_has_fewer = lists[a].keys.size() < lists[b].keys.size();
        const SharedList &fewer = first_has_fewer ? lists[a] : lists[b], &more = first_has_fewer ? lists[b] : lists[a];
        if ((more.keys.size() - fewer.keys.size()) * fewer.bytes_per_key >=
            FileBytes::kTimes + fewer.keys.size() * sizeof(float))
          continue;
        const std::int64_t bytes = saved(lists[a], lists[b], together(lists[a].keys, lists[b].keys));
        if (bytes <= most) continue;
        most = bytes;
        best = {a, b};
      }
    if (most == 0) return;
    SharedList &into = lists[best.first], &from = lists[best.second];
    into.keys = together(into.keys, from.keys);
    into.bytes_per_key += from.bytes_per_key;
    into.members.insert(into.members.end(), from.members.begin(), from.members.end());
    lists.erase(lists.begin() + static_cast<std::ptrdiff_t>(best.second));
  }
}

/// Gives lists all `count` keys of their source back, if one list of all keys takes fewer bytes than they do.
void keep_all(std::size_t count, std::vector<SharedList>& lists) {
  SharedList all;
  for (std::uint32_t key = 0; key < count; ++key) all.keys.push_back(key);
  std::int64_t gain = -static_cast<std::int64_t>(FileBytes::kTimes + count * sizeof(float));
  std::vector<bool> joins(lists.size());
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const std::int64_t bytes = static_cast<std::int64_t>(FileBytes::kTimes + lists[i].keys.size() * sizeof(float)) -
                               static_cast<std::int64_t>((count - lists[i].keys.size()) * lists[i].bytes_per_key);
    joins[i] = bytes > 0;
    gain += std::max<std::int64_t>(bytes, 0);
  }
  if (gain <= 0) return;
  std::vector<SharedList> kept;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    if (!joins[i]) kept.push_back(std::move(lists[i]));
    if (joins[i]) all.members.insert(all.members.end(), lists[i].members.begin(), lists[i].members.end());
  }
  kept.push_back(std::move(all));
  lists = std::move(kept);
}

/// Bytes of the values of one key.
std::size_t bytes_per_key(const Animation& animation, std::size_t number) {
  return with_track(animation, number, [](const auto& track) {
    return track.empty() ? 0 : track.values.size() / track.key_count() * sizeof(track.values[0]);
  });
}

/// Number of entries of `values` for each key.
template <class V>
std::size_t entries_per_key(const Track<V>& track) {
  return track.interpolation == Interpolation::cubic_spline ? 3 : 1;
}
std::size_t entries_per_key(const WeightTrack& track) {
  return (track.interpolation == Interpolation::cubic_spline ? 3 : 1) * track.target_count;
}
template <class V>
std::size_t entries_per_value(const Track<V>&) {
  return 1;
}
std::size_t entries_per_value(const WeightTrack& track) { return track.target_count; }

/// Makes a track of one value at all times, that of a key. It is linear, since a cubic track needs two keys.
template <class TrackType>
void rest(TrackType& track, std::uint32_t key) {
  const auto per_value = static_cast<std::ptrdiff_t>(entries_per_value(track));
  const auto at = track.values.begin() + per_value * static_cast<std::ptrdiff_t>(value_row(track.interpolation, key));
  track.values = std::vector(at, at + per_value);
  track.times_s.resize(1);
  track.interpolation = Interpolation::linear;
}

/// Extends a track to the first or last key time of `source`. A track of one value repeats the value there. A track
/// that was left out becomes a track of one value again. Any other track gets the key of `source`.
template <class TrackType>
void add_end(TrackType& track, const TrackType& source, const KeptKeys& kept, bool first) {
  if (kept.left_out && track.empty()) {
    track = source;
    rest(track, kept.keys.front());
    if (first) return;
  }
  const auto count = static_cast<std::ptrdiff_t>(entries_per_key(kept.rests ? track : source));
  const auto from =
      kept.rests || first ? (kept.rests ? track.values : source.values).begin() : source.values.end() - count;
  const std::vector key(from, from + count);
  track.values.insert(first ? track.values.begin() : track.values.end(), key.begin(), key.end());
  track.times_s.insert(first ? track.times_s.begin() : track.times_s.end(),
                       first ? source.times_s.front() : source.times_s.back());
}

/// Calls `use(times_s)` for the key times of every track.
void each_times(const Animation& animation, const auto& use) {
  const auto use_filled = [&](const auto& track) {
    if (!track.empty()) use(track.times_s);
  };
  for (std::size_t t = 0; t < track_count(animation); ++t) with_track(animation, t, use_filled);
  for (const PropertyTrack& property : animation.properties) use_filled(property.values);
}

void keep_end(const Animation& animation, std::span<const KeptKeys> tracks, bool first, Animation& out) {
  const auto reach = [&](const std::vector<float>& times_s) { return first ? -times_s.front() : times_s.back(); };
  const auto farthest = [&](const Animation& of) {
    float far = -std::numeric_limits<float>::infinity();
    each_times(of, [&](const std::vector<float>& times_s) { far = std::max(far, reach(times_s)); });
    return far;
  };
  const float needed = farthest(animation);
  if (farthest(out) >= needed) return;
  const auto keys_in_file = [&](const KeptKeys& track) {  // a track that is not there costs most
    return times_of(out, track.track).empty() ? std::numeric_limits<std::size_t>::max() : track.keys.size();
  };
  const KeptKeys* best = nullptr;
  for (const KeptKeys& track : tracks)
    if (reach(times_of(animation, track.track)) >= needed && (!best || keys_in_file(track) < keys_in_file(*best)))
      best = &track;
  with_track(out, best->track, [&]<class TrackType>(TrackType& track) {
    with_track(animation, best->track, [&]<class Source>(const Source& source) {
      if constexpr (std::is_same_v<TrackType, Source>) add_end(track, source, *best, first);
    });
  });
}

}  // namespace

void share_key_times(const Animation& animation, std::vector<KeptKeys>& tracks) {
  std::map<std::vector<float>, std::map<Keys, SharedList>> sources;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (tracks[i].rests) continue;
    SharedList& list = sources[times_of(animation, tracks[i].track)][tracks[i].keys];
    list.keys = tracks[i].keys;
    list.bytes_per_key += bytes_per_key(animation, tracks[i].track);
    list.members.push_back(i);
  }
  for (auto& [times_s, by_keys] : sources) {
    if (by_keys.size() > kMostLists) continue;
    std::vector<SharedList> lists;
    for (auto& [keys, list] : by_keys) lists.push_back(std::move(list));
    merge(lists);
    keep_all(times_s.size(), lists);
    for (const SharedList& list : lists)
      for (const std::size_t member : list.members) tracks[member].keys = list.keys;
  }
}

const std::vector<float>& times_of(const Animation& animation, std::size_t track) {
  return with_track(animation, track, [](const auto& keys) -> const std::vector<float>& { return keys.times_s; });
}

void set_keys(const Animation& animation, const KeptKeys& kept, Animation& out) {
  with_track(out, kept.track, [&]<class TrackType>(TrackType& track) {
    with_track(animation, kept.track, [&]<class Source>(const Source& source) {
      if constexpr (std::is_same_v<TrackType, Source>) track = source;
    });
    if (kept.left_out) {
      track.times_s.clear();
      track.values.clear();
    } else if (kept.keys.size() < track.key_count()) {
      kept.rests ? rest(track, kept.keys.front()) : keep_keys({&track}, kept.keys);
    }
  });
}

Animation with_keys(const Animation& animation, std::span<const KeptKeys> tracks) {
  Animation out = animation;
  for (const KeptKeys& kept : tracks) set_keys(animation, kept, out);
  for (const bool first : {true, false}) keep_end(animation, tracks, first, out);
  return out;
}

}  // namespace sinew
