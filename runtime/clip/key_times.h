// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "runtime/animation/track_sample.h"
#include "runtime/base/shared_array.h"

namespace sinew {

/// The key times of one group of tracks, with a table of uniform buckets for the search. A search costs O(1) if keys
/// are evenly spaced and O(log K) at worst, for forward play and for jumps alike. Copies share the times and the
/// table.
class KeyTimes {
 public:
  /// in   times_s[K]  K >= 1, finite, never decreasing
  explicit KeyTimes(SharedArray<float> times_s) : times_s_(std::move(times_s)) {
    const double first = static_cast<double>(times_s_.front()), span = static_cast<double>(times_s_.back()) - first;
    const std::size_t buckets = span > 0.0 ? times_s_.size() : 1;
    buckets_per_s_ = span > 0.0 ? static_cast<double>(buckets) / span : 0.0;
    first_key_.assign(buckets + 1, 0);
    std::uint32_t* const first_key = first_key_.own();
    for (const float t : times_s_) ++first_key[bucket_of(static_cast<double>(t)) + 1];
    for (const std::uint32_t keys : first_key_)
      search_steps_ = std::max<std::size_t>(search_steps_, std::bit_width(keys));
    for (std::size_t b = 1; b <= buckets; ++b) first_key[b] += first_key[b - 1];
  }

  /// Same result as locate_key(times_s(), time_s).
  KeyPosition locate(double time_s) const noexcept {
    if (!(time_s >= static_cast<double>(times_s_.front()))) return {};
    if (time_s >= static_cast<double>(times_s_.back())) return {times_s_.size() - 1, true, 0.0, 0.0};
    // bucket_of is monotonic in spite of rounding. So keys in earlier buckets are earlier than time_s, and keys in
    // later buckets are later. The result is in this bucket, or it is the last key before it.
    const std::size_t b = bucket_of(time_s);
    // A fixed number of steps without a branch on key times, so uneven keys cause no mispredictions.
    std::size_t low = first_key_[b], left = first_key_[b + 1] - low;
    for (std::size_t step = 0; step < search_steps_; ++step) {
      const std::size_t half = (left + 1) / 2;
      const bool later = left > 0 && static_cast<double>(times_s_[low + half - 1]) <= time_s;
      low += later ? half : 0;
      left = later ? left - half : half - (left > 0);
    }
    return position_after(times_s_, low - 1, time_s);
  }

  std::span<const float> times_s() const noexcept { return times_s_; }
  std::size_t key_count() const noexcept { return times_s_.size(); }
  /// Number of comparisons in a search. It is constant, since a search does not depend on earlier ones.
  std::size_t search_steps() const noexcept { return search_steps_; }
  std::size_t byte_size() const noexcept {
    return (times_s_.size() * sizeof(float)) + first_key_.size() * sizeof(std::uint32_t);
  }

 private:
  std::size_t bucket_of(double time_s) const noexcept {
    const double b = (time_s - static_cast<double>(times_s_.front())) * buckets_per_s_;
    return std::min(static_cast<std::size_t>(b), first_key_.size() - 2);
  }

  SharedArray<float> times_s_;
  SharedArray<std::uint32_t> first_key_;  ///< [buckets + 1] number of keys in all earlier buckets
  double buckets_per_s_ = 0.0;
  std::size_t search_steps_ = 0;  ///< steps of a binary search in the fullest bucket
};

}  // namespace sinew
