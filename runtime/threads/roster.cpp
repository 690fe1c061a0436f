// SPDX-License-Identifier: MIT
#include "runtime/threads/roster.h"

#include "runtime/threads/make_room.h"

namespace sinew {

void Roster::reserve(std::size_t count, std::size_t link_count) {
  make_room(entries, count);
  make_room(links, link_count);
  make_room(part_end, count);
}

void Roster::append(const Entry& entry, bool begins_group, std::size_t part_bytes) {
  entries.push_back(entry);
  if (part_end.empty() || (begins_group && last_part_bytes_ >= part_bytes)) {
    part_end.push_back(0);
    last_part_bytes_ = 0;
  }
  part_end.back() = entries.size();
  bytes += entry.character->plan.frame_bytes();
  last_part_bytes_ += entry.character->plan.frame_bytes();
}

void Roster::clear() noexcept {
  entries.clear();
  links.clear();
  part_end.clear();
  bytes = 0;
  last_part_bytes_ = 0;
}

}  // namespace sinew
