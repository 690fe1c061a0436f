// SPDX-License-Identifier: MIT
#include "runtime/threads/crowd.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "runtime/base/prefetch.h"
#include "runtime/plan/cut_frame.h"

namespace sinew {
namespace {

constexpr std::size_t kLooksAhead = 4;                           // prefetch distance in characters
constexpr std::size_t kPastCachesBytes = std::size_t{16} << 20;  // frame memory of all characters that exceeds caches

/// World matrices of a character now: at the cut, or else of its last good frame. Empty if there are none.
std::span<const Affine> matrices_of(const Character& character) noexcept {
  if (character.later == Later::second_half) return character.cut.model;
  return character.last_good != nullptr ? character.last_good->result().model : std::span<const Affine>{};
}

/// World matrix of the joint that a link follows; empty if its leader has none.
std::optional<Affine> joint_of(const Roster& roster, const Roster::Link& link) noexcept {
  const Character& leader = *roster.entries[link.leader].character;
  const std::span<const Affine> model = matrices_of(leader);
  if (model.empty()) return std::nullopt;
  return world_of(leader.plan, model, link.joint);
}

/// The input of an entry, placed on the joints of its leaders as they are now.
/// err  those of FollowedInput::place
ErrorCode make_input(const Roster& roster, const Roster::Entry& entry, FrameInput& input) noexcept {
  input = entry.input->frame.view();
  bool has_places = false;
  for (const Roster::Link& link : roster.links_of(entry)) {
    has_places |= link.place.kind != FollowKind::root;
    if (link.place.kind != FollowKind::root) continue;
    if (const std::optional<Affine> joint = joint_of(roster, link)) input.root = *joint * input.root;
  }
  if (!has_places) return ErrorCode::ok;
  FollowedInput& followed = entry.character->followed;
  followed.copy_lists(input);
  for (const Roster::Link& link : roster.links_of(entry)) {
    if (link.place.kind == FollowKind::root) continue;
    if (const std::optional<Affine> joint = joint_of(roster, link))
      if (const ErrorCode error = followed.place(input, link.place, *joint); error != ErrorCode::ok) return error;
  }
  return ErrorCode::ok;
}

/// True for a follower with a leader that is not finished in this half of the frame.
bool waits_for_leader(const Roster& roster, const Roster::Entry& entry) noexcept {
  const std::span<const Roster::Link> links = roster.links_of(entry);
  return std::any_of(links.begin(), links.end(), [&](const Roster::Link& link) {
    return roster.entries[link.leader].character->later != Later::nothing;
  });
}

/// False if the root follows a leader that has never shown its joints, or is out of view.
bool has_root(const Roster& roster, const Roster::Entry& entry) noexcept {
  const std::span<const Roster::Link> links = roster.links_of(entry);
  return std::none_of(links.begin(), links.end(), [&](const Roster::Link& link) {
    return link.place.kind == FollowKind::root && matrices_of(*roster.entries[link.leader].character).empty();
  });
}

bool is_to_run(const Roster& roster, const Roster::Entry& entry) noexcept {
  if (entry.input->stops_at_cut()) return waits_for_leader(roster, entry) || has_root(roster, entry);
  if (!has_root(roster, entry)) return false;
  const FrameBuffer* last = entry.character->last_good;
  FrameInput input;
  return last == nullptr || make_input(roster, entry, input) != ErrorCode::ok || !holds_result_of(*last, input);
}

void look_at_input(const Roster& roster, const Roster::Entry& entry) noexcept {
  Character& character = *entry.character;
  character.error = ErrorCode::ok;
  const bool has_input = entry.input != nullptr;
  const bool waits = has_input && !entry.input->stops_at_cut() && waits_for_leader(roster, entry);
  character.later = waits ? Later::whole_frame : Later::nothing;
  character.is_to_run = has_input && !waits && is_to_run(roster, entry);
  if (character.is_to_run) character.slots.prepare_to_write();
}

void finish_frame(const Roster& roster, const Roster::Entry& entry) noexcept {
  Character& character = *entry.character;
  character.is_to_run = has_root(roster, entry);
  if (!character.is_to_run) return;
  FrameInput input;
  character.error = make_input(roster, entry, input);
  if (character.error == ErrorCode::ok) character.error = run_from_cut(character.plan, input, character.to_write());
  if (character.error == ErrorCode::ok) character.last_good = &character.to_write();
}

}  // namespace

void Crowd::make_room(std::size_t count, std::size_t link_count) {
  queued_.reserve(count, link_count);
  spare_.reserve(count, link_count);
}

void Crowd::queue(const Roster& roster) {
  if (!queued_.has_room_for(roster)) std::swap(queued_, spare_);
  queued_ = roster;
}

void Crowd::start(std::uint64_t number) noexcept {
  std::swap(queued_, running_);
  is_second_half_ = false;
  stops_.store(false, std::memory_order_relaxed);
  tasks_run_.store(0, std::memory_order_relaxed);
  started_.store(number, std::memory_order_release);
}

void Crowd::start_second_half() noexcept {
  is_second_half_ = true;
  stops_.store(false, std::memory_order_relaxed);
  tasks_run_.store(0, std::memory_order_relaxed);
  started_.store(started_.load(std::memory_order_relaxed), std::memory_order_release);
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

void Crowd::run_character(const Roster::Entry& entry, std::uint64_t number) noexcept {
  Character& character = *entry.character;
  FrameBuffer& buffer = character.to_write();
  buffer.count_from(number - 1);
  buffer.write_past_caches(running_.bytes >= kPastCachesBytes);
  if (character.last_good != nullptr) buffer.follow(*character.last_good);
  FrameInput input;
  character.error = make_input(running_, entry, input);
  if (character.error != ErrorCode::ok) return;
  if (!entry.input->stops_at_cut()) {
    character.error = run_plan(character.plan, input, buffer);
    if (character.error == ErrorCode::ok) character.last_good = &buffer;
    return;
  }
  character.error = run_to_cut(character.plan, input, buffer, character.cut, entry.input->ops_before_cut);
  if (character.error != ErrorCode::ok) return;
  character.later = Later::second_half;
  stops_.store(true, std::memory_order_relaxed);
}

void Crowd::run_second_half(std::size_t first, std::size_t end, std::uint64_t number) noexcept {
  for (std::size_t c = first; c < end; ++c) {
    const Roster::Entry& entry = running_.entries[c];
    const Later later = std::exchange(entry.character->later, Later::nothing);
    if (later == Later::second_half) finish_frame(running_, entry);
    if (later != Later::whole_frame) continue;
    look_at_input(running_, entry);
    if (entry.character->is_to_run) run_character(entry, number);
  }
}

/// Between two frames the memory of a large crowd leaves the caches. So a first loop prefetches characters and finds
/// those whose input has changed. The second loop then prefetches the next frame buffer while the one before it runs.
/// Followers are examined in the second loop only, because their leader has to run first.
void Crowd::run_part(std::size_t part) noexcept {
  const std::uint64_t number = started_.load(std::memory_order_acquire);
  const std::vector<Roster::Entry>& entries = running_.entries;
  const std::size_t first = part == 0 ? 0 : running_.part_end[part - 1], end = running_.part_end[part];
  if (is_second_half_) return run_second_half(first, end, number);
  for (std::size_t c = first; c < end; ++c) {
    if (c + kLooksAhead < entries.size()) {
      entries[c + kLooksAhead].character->prefetch();
      if (const StoredInput* input = entries[c + kLooksAhead].input) prefetch(input, sizeof(StoredInput));
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
    if (entries[c].character->is_to_run) run_character(entries[c], number);
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
