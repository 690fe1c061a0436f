// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "runtime/clip/clip_layout.h"
#include "runtime/clip/slerp_series.h"

namespace sinew {

/// The keys first to end - 1 of a group.
struct KeyRange {
  std::size_t first, end;
};

template <class T>
void add_slice(std::span<const T> from, std::size_t first, std::size_t end, std::vector<T>& to) {
  to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(first),
            from.begin() + static_cast<std::ptrdiff_t>(end));
}

/// Assembles the keys of one block from slices of other blocks. All blocks are equal except for their keys.
class KeySlices {
 public:
  void add(const TrackBlock& block, KeyRange keys) {
    const PackedRows& packed = block.packed;
    if (packed.empty()) {
      const std::size_t row = std::size_t{block.plane_count} * block.lane_count;
      return add_slice(std::span(block.rows.data(), block.rows.size()), keys.first * row, keys.end * row, rows_);
    }
    add_slice(std::span(packed.bits.data(), packed.bits.size()), keys.first * packed.row_bytes,
              keys.end * packed.row_bytes, bits_);
    for (std::size_t key = keys.first; key < keys.end && !packed.power.empty(); ++key)
      power_.push_back(packed.power[std::min(key, packed.power.size() - 1)]);
  }

  /// in   block  one of those that were added
  void drop_last(const TrackBlock& block, std::size_t count) {
    rows_.resize(rows_.size() - (block.packed.empty() ? count * block.plane_count * block.lane_count : 0));
    bits_.resize(bits_.size() - count * block.packed.row_bytes);
    power_.resize(power_.size() - (block.packed.power.empty() ? 0 : count));
  }

  void move_to(TrackBlock& block) {
    if (block.packed.empty()) {
      rows_.resize(rows_.size() + kLanePadding, 0.0f);
      block.rows = SharedArray<float>(std::move(rows_));
      return;
    }
    bits_.resize(bits_.size() + kReadAhead, 0);
    block.packed.bits = SharedArray<std::uint8_t>(std::move(bits_));
    // A single entry if all are kUsualSlerpPower, as in PackedRows::power.
    if (std::all_of(power_.begin(), power_.end(), [](std::uint8_t power) { return power == kUsualSlerpPower; }))
      power_.resize(std::min(power_.size(), std::size_t{1}));
    block.packed.power = std::move(power_);
  }

 private:
  std::vector<float> rows_;
  std::vector<std::uint8_t> bits_, power_;
};

}  // namespace sinew
