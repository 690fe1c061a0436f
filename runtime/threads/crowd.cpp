// SPDX-License-Identifier: MIT
#include "runtime/threads/crowd.h"

#include <algorithm>
#include <utility>

#include "runtime/base/prefetch.h"

namespace sinew {
namespace {

constexpr std::size_t kLooksAhead = 4;                           // prefetch distance in characters
constexpr std::size_t kPastCachesBytes = std::size_t{16} << 20;  // frame memory of all characters that exceeds caches

/// The input of an entry. A follower's root is relative to the joint of its leader.
FrameInput input_of(const Roster& roster, const Roster::Entry& entry) noexcept {
  FrameInput input = entry.input->view();
  if (!entry.follows()) return input;
  const Character& leader = *roster.entries[entry.leader].character;
  input.root = world_of(leader.plan, leader.last_good->result().model, entry.joint) * input.root;
  return input;
}

/// False for a follower whose leader has never shown its joints, or is out of view.
bool has_input(const Roster& roster, const Roster::Entry& entry) noexcept {
  if (entry.input == nullptr) return false;
  if (!entry.follows()) return true;
  const FrameBuffer* leader = roster.entries[entry.leader].character->last_good;
  return leader != nullptr && !leader->result().model.empty();
}

void look_at_input(const Roster& roster, const Roster::Entry& entry) noexcept {
  Character& character = *entry.character;
  character.is_to_run = has_input(roster, entry) && (character.last_good == nullptr ||
                                                     !holds_result_of(*character.last_good, input_of(roster, entry)));
  if (character.is_to_run) character.slots.prepare_to_write();
  character.error = ErrorCode::ok;
}

void run_character(const Roster& roster, const Roster::Entry& entry, std::uint64_t number) noexcept {
  Character& character = *entry.character;
  FrameBuffer& buffer = character.to_write();
  buffer.count_from(number - 1);
  buffer.write_past_caches(roster.bytes >= kPastCachesBytes);
  if (character.last_good != nullptr) buffer.follow(*character.last_good);
  character.error = run_plan(character.plan, input_of(roster, entry), buffer);
  if (character.error == ErrorCode::ok) character.last_good = &buffer;
}

}  // namespace

void Crowd::make_room(std::size_t count) {
  queued_.reserve(count);
  spare_.reserve(count);
}

void Crowd::queue(const Roster& roster) {
  if (!queued_.has_room_for(roster)) std::swap(queued_, spare_);
  queued_ = roster;
}

void Crowd::start(std::uint64_t number) noexcept {
  std::swap(queued_, running_);
  tasks_run_.store(0, std::memory_order_relaxed);
  started_.store(number, std::memory_order_release);
}

std::size_t Crowd::task_count() const noexcept {
  return running_.part_end.size() < 2 || running_.bytes < inline_below_bytes_ ? 1 : running_.part_end.size();
}

bool Crowd::run_task(std::size_t task) noexcept {
  const std::size_t count = task_count();
  if (count > 1)
    run_part(task);
  else
    for (std::size_t p = 0; p < running_.part_end.size(); ++p) run_part(p);
  return tasks_run_.fetch_add(1, std::memory_order_acq_rel) + 1 == count;
}

/// Between two frames the memory of a large crowd leaves the caches. So a first loop prefetches characters and finds
/// those whose input has changed. The second loop then prefetches the next frame buffer while the one before it runs.
/// Followers are examined in the second loop only, because their leader has to run first.
void Crowd::run_part(std::size_t part) noexcept {
  const std::uint64_t number = started_.load(std::memory_order_acquire);
  const std::vector<Roster::Entry>& entries = running_.entries;
  const std::size_t first = part == 0 ? 0 : running_.part_end[part - 1], end = running_.part_end[part];
  for (std::size_t c = first; c < end; ++c) {
    if (c + kLooksAhead < entries.size()) {
      entries[c + kLooksAhead].character->prefetch();
      prefetch(entries[c + kLooksAhead].input, sizeof(InputCopy));
    }
    if (!entries[c].follows()) look_at_input(running_, entries[c]);
  }
  const auto next_to_run = [&](std::size_t c) {
    while (c < end && !entries[c].follows() && !entries[c].character->is_to_run) ++c;
    return c;
  };
  for (std::size_t c = next_to_run(first), next = end; c < end; c = next) {
    next = next_to_run(c + 1);
    if (next < end && !entries[next].follows()) entries[next].character->to_write().prefetch();
    if (entries[c].follows()) look_at_input(running_, entries[c]);
    if (entries[c].character->is_to_run) run_character(running_, entries[c], number);
  }
}

ErrorCode Crowd::publish() noexcept {
  ErrorCode first = ErrorCode::ok;
  for (const Roster::Entry& entry : running_.entries) {
    Character& character = *entry.character;
    if (character.is_to_run && character.error == ErrorCode::ok) character.slots.publish();
    if (first == ErrorCode::ok) first = character.error;
  }
  return first;
}

}  // namespace sinew
