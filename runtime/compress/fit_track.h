// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/animation/track_sample.h"
#include "runtime/compress/key_lists.h"
#include "runtime/compress/track_keys.h"

namespace sinew {

/// Chooses the keys of one track in one part of an animation. At all times of the part `error_squared(t, value)` stays
/// within the square of a limit.
template <class V, class ErrorSquared>
class TrackFit {
 public:
  using Value = decltype(value_of(Track<V>{}, 0));

  /// in   at_s    times of the part, rising
  ///      without   the value that the target has without a track
  ///      first, last   the part is the first, or the last, of the animation
  TrackFit(const Track<V>& track, const Value& without, std::span<const double> at_s, bool first, bool last,
           double limit, const ErrorSquared& error_squared)
      : track_(track),
        without_(without),
        at_s_(at_s),
        first_(first),
        last_(last),
        limit_squared_(limit * limit),
        error_squared_(error_squared) {}

  /// Adds the keys that the part needs to `kept.keys`.
  void run(KeptKeys& kept) const {
    if (first_ && last_)
      if (const std::uint32_t key = middle_key(track_); holds_value(0, at_s_.size(), value_of(track_, key))) {
        kept.keys = {key};
        kept.rests = true;
        kept.left_out = holds_value(0, at_s_.size(), without_);
        return;
      }
    if (kept.keys.empty()) kept.keys.push_back(first_key());
    walk(kept.keys, stop());
    if (last_) drop_last(kept.keys);
  }

  /// The value that the kept keys give at a time of the part. `segment` is a hint: the index of the last kept key at or
  /// before the time. It moves forward with rising times.
  Value value_at(const KeptKeys& kept, std::size_t t, std::size_t& segment) const {
    if (kept.left_out) return without_;
    const std::vector<std::uint32_t>& keys = kept.keys;
    while (segment + 1 < keys.size() && time_of(keys[segment + 1]) <= at_s_[t]) ++segment;
    const double begin_s = time_of(keys[segment]);
    if (kept.rests || segment + 1 == keys.size() || at_s_[t] <= begin_s) return value_of(track_, keys[segment]);
    const double end_s = time_of(keys[segment + 1]), fraction = between(begin_s, end_s, at_s_[t]);
    return between_keys<double>(track_, keys[segment], keys[segment + 1], fraction, end_s - begin_s);
  }

 private:
  static constexpr std::size_t kLongest = 4096;  // keys that a step may leave out

  double time_of(std::size_t key) const { return static_cast<double>(track_.times_s[key]); }
  std::size_t first_at_or_after(double time_s) const {
    return static_cast<std::size_t>(std::lower_bound(at_s_.begin(), at_s_.end(), time_s) - at_s_.begin());
  }
  std::size_t first_after(double time_s) const {
    return static_cast<std::size_t>(std::upper_bound(at_s_.begin(), at_s_.end(), time_s) - at_s_.begin());
  }
  bool is_jump(std::size_t key) const {
    return key + 1 < track_.key_count() && !(track_.times_s[key + 1] > track_.times_s[key]);
  }

  template <class ValueAt>
  bool all_near(std::size_t from, std::size_t to, const ValueAt& value) const {
    if (from >= to) return true;
    const std::size_t middle = from + (to - from) / 2;
    if (!(error_squared_(middle, value(middle)) <= limit_squared_)) return false;
    for (std::size_t t = from; t < to; ++t)
      if (t != middle && !(error_squared_(t, value(t)) <= limit_squared_)) return false;
    return true;
  }
  bool holds_value(std::size_t from, std::size_t to, const Value& value) const {
    return all_near(from, to, [&](std::size_t) { return value; });
  }
  bool can_skip(std::size_t a, std::size_t b) const {
    const double begin_s = time_of(a), end_s = time_of(b);
    return all_near(first_after(begin_s), first_at_or_after(end_s), [&](std::size_t t) {
      return between_keys<double>(track_, a, b, between(begin_s, end_s, at_s_[t]), end_s - begin_s);
    });
  }

  /// The last key whose value may stand for all keys before it.
  std::uint32_t first_key() const {
    return static_cast<std::uint32_t>(last_that_holds(0, track_.key_count() - 1, [&](std::size_t key) {
      return time_of(key) < at_s_.back() && holds_value(0, first_at_or_after(time_of(key)), value_of(track_, key));
    }));
  }

  /// The last key of the track, or the first one that is not before the end of the part.
  std::size_t stop() const {
    const std::size_t end = track_.key_count() - 1;
    if (last_) return end;
    const auto at = std::lower_bound(track_.times_s.begin(), track_.times_s.end(), static_cast<float>(at_s_.back()));
    return std::min(end, static_cast<std::size_t>(at - track_.times_s.begin()));
  }

  /// From each key takes the longest step that stays within the limit. Both sides of a jump stay.
  void walk(std::vector<std::uint32_t>& keys, std::size_t stop) const {
    while (keys.back() < stop) {
      const std::size_t a = keys.back();
      std::size_t most = is_jump(a) ? a + 1 : std::min(stop, a + kLongest);
      for (std::size_t key = a + 1; key < most; ++key)
        if (is_jump(key)) most = key;
      const auto skips = [&](std::size_t b) { return can_skip(a, b); };
      keys.push_back(static_cast<std::uint32_t>(last_that_holds(a + 1, most, skips)));
    }
  }

  /// Drops keys at the end, if the value of the kept key before them may stand for theirs.
  void drop_last(std::vector<std::uint32_t>& keys) const {
    while (keys.size() > 1) {
      const std::uint32_t before = keys[keys.size() - 2];
      if (time_of(before) < at_s_.front() ||
          !holds_value(first_at_or_after(time_of(before)), at_s_.size(), value_of(track_, before)))
        return;
      keys.pop_back();
    }
  }

  const Track<V>& track_;
  Value without_;
  std::span<const double> at_s_;
  bool first_, last_;
  double limit_squared_;
  const ErrorSquared& error_squared_;
};

}  // namespace sinew
