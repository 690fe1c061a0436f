// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/threads/character.h"
#include "runtime/threads/follow_place.h"

namespace sinew {

/// The characters of one frame in the order in which they run, and their division into parts that run in parallel.
/// A follower comes after its leaders, in the same part.
struct Roster {
  struct Entry {
    Character* character = nullptr;
    const StoredInput* input = nullptr;  ///< null = none was given yet: the character does not run
    std::uint32_t first_link = 0, link_count = 0;

    bool follows() const noexcept { return link_count != 0; }
  };
  /// A place in an entry's input that follows a joint of an entry before it.
  struct Link {
    std::uint32_t leader = 0, joint = 0;
    FollowPlace place;
  };

  std::vector<Entry> entries;
  std::vector<Link> links;
  std::vector<std::size_t> part_end;  ///< [parts] index of the entry after the last one of each part
  std::size_t bytes = 0;              ///< Plan::frame_bytes() of all

  std::span<const Link> links_of(const Entry& entry) const noexcept {
    return std::span(links).subspan(entry.first_link, entry.link_count);
  }
  /// Adds an entry behind all others. If it begins a group of characters that follow each other, it begins a new part
  /// where the last one has at least `part_bytes`.
  void append(const Entry& entry, bool begins_group, std::size_t part_bytes);
  void clear() noexcept;
  /// Afterwards neither appending up to `count` entries with `link_count` links in total nor assigning a roster of that
  /// size allocates.
  void reserve(std::size_t count, std::size_t link_count);
  bool has_room_for(const Roster& other) const noexcept {
    return entries.capacity() >= other.entries.size() && part_end.capacity() >= other.part_end.size() &&
           links.capacity() >= other.links.size();
  }

 private:
  std::size_t last_part_bytes_ = 0;
};

}  // namespace sinew
