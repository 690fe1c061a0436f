// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "runtime/threads/character.h"

namespace sinew {

/// The characters of one frame in the order in which they run, and their division into parts that run in parallel.
/// A follower comes after its leader, in the same part.
struct Roster {
  static constexpr std::uint32_t kNoLeader = std::numeric_limits<std::uint32_t>::max();

  struct Entry {
    Character* character = nullptr;
    const InputCopy* input = nullptr;  ///< null = none was given yet: the character does not run
    std::uint32_t leader = kNoLeader;  ///< index of an entry before this one, whose joint moves the root of the input
    std::uint32_t joint = 0;

    bool follows() const noexcept { return leader != kNoLeader; }
  };

  std::vector<Entry> entries;
  std::vector<std::size_t> part_end;  ///< [parts] index of the entry after the last one of each part
  std::size_t bytes = 0;              ///< Plan::frame_bytes() of all

  /// Adds an entry behind all others. Without a leader it begins a new part if the last one has at least `part_bytes`.
  void append(const Entry& entry, std::size_t part_bytes);
  void clear() noexcept;
  /// Afterwards neither appending up to `count` entries nor assigning a roster of that size allocates.
  void reserve(std::size_t count);
  bool has_room_for(const Roster& other) const noexcept {
    return entries.capacity() >= other.entries.size() && part_end.capacity() >= other.part_end.size();
  }

 private:
  std::size_t last_part_bytes_ = 0;
};

}  // namespace sinew
