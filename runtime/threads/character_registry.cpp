// SPDX-License-Identifier: MIT
#include "runtime/threads/character_registry.h"

#include <algorithm>
#include <utility>

#include "runtime/base/contract.h"
#include "runtime/threads/make_room.h"

namespace sinew {
namespace {

/// Checks that a plan shows a joint that followers need.
ErrorCode check_leader(const Plan& plan, std::uint32_t joint) noexcept {
  if (!plan.needs().out.joints) return ErrorCode::not_in_needs;
  return joint < plan.scene().skeleton.joint_count() ? ErrorCode::ok : ErrorCode::index_out_of_range;
}

}  // namespace

bool CharacterRegistry::has(Id id) const noexcept {
  return index_of(id) < slots_.size() && slot_of(id).now != nullptr && slot_of(id).generation == id >> kIndexBits;
}

bool CharacterRegistry::was_given(Id id) const noexcept {
  return has(id) || (index_of(id) < slots_.size() && id >> kIndexBits < slot_of(id).generation);
}

CharacterRegistry::Id CharacterRegistry::add(const Plan& plan) {
  auto character = std::make_unique<Character>(plan, frame_buffers_, memory_);
  if (free_indices_.empty()) {
    CONTRACT(slots_.size() < kMostIndices && "a job thread has fewer than a million characters at a time");
    const std::size_t count = slots_.size() + 1;
    make_room(slots_, count);
    make_room(ids_, count);
    make_room(free_indices_, count);  // so that removing a character allocates nothing
    make_room(index_of_entry_, count);
    roster_.reserve(count);
    slots_.emplace_back();
    free_indices_.push_back(static_cast<std::uint32_t>(slots_.size() - 1));
  }
  const std::uint32_t index = free_indices_.back();
  free_indices_.pop_back();
  Slot& slot = slots_[index];
  slot.now = std::move(character);
  slot.leader = kNobody;
  const Id id = slot.generation << kIndexBits | index;
  ids_.push_back(id);
  is_current_ = false;
  return id;
}

void CharacterRegistry::make_room_to_retire(std::size_t count) {
  make_room(retired_, retired_.size() + shown_in_place_ + count);
}

void CharacterRegistry::retire(std::unique_ptr<Character>& character) noexcept {
  if (character != nullptr) retired_.push_back({std::move(character), frame_});
}

ErrorCode CharacterRegistry::remove(Id id) {
  if (!has(id)) return ErrorCode::unknown_character;
  make_room_to_retire(1);  // from here on nothing throws
  Slot& slot = slot_of(id);
  if (slot.before != nullptr) --shown_in_place_;
  retire(slot.before);
  retire(slot.now);
  // An index whose generations are used up is not used again.
  if (++slot.generation < Id{1} << (32 - kIndexBits)) free_indices_.push_back(index_of(id));
  ids_.erase(std::find(ids_.begin(), ids_.end(), id));
  is_current_ = false;
  return ErrorCode::ok;
}

ErrorCode CharacterRegistry::replace(Id id, const Plan& plan) {
  if (!has(id)) return ErrorCode::unknown_character;
  for (const Id follower : ids_)
    if (slot_of(follower).leader == id)
      if (const ErrorCode error = check_leader(plan, slot_of(follower).joint); error != ErrorCode::ok) return error;
  auto next = std::make_unique<Character>(plan, frame_buffers_, memory_);
  make_room_to_retire(2);  // from here on nothing throws
  Slot& slot = slot_of(id);
  if (slot.now->input_of_frame != 0) {
    const FrameInput input = slot.now->inputs[slot.now->newest_input].view();
    if (next->inputs[0].check_room(input) == ErrorCode::ok) {
      next->inputs[0].assign(input);
      next->input_of_frame = slot.now->input_of_frame;
    }
  }
  if (slot.before == nullptr) {
    slot.before = std::move(slot.now);
    ++shown_in_place_;
  }
  retire(slot.now);  // a plan that was replaced before any frame of it was shown
  slot.now = std::move(next);
  is_current_ = false;
  return ErrorCode::ok;
}

ErrorCode CharacterRegistry::follow(Id follower, Id leader, std::uint32_t joint) {
  if (!has(follower) || !has(leader)) return ErrorCode::unknown_character;
  if (const ErrorCode error = check_leader(slot_of(leader).now->plan, joint); error != ErrorCode::ok) return error;
  for (Id above = leader; above != kNobody && has(above); above = slot_of(above).leader)
    if (above == follower) return ErrorCode::follows_itself;
  slot_of(follower).leader = leader;
  slot_of(follower).joint = joint;
  is_current_ = false;
  return ErrorCode::ok;
}

ErrorCode CharacterRegistry::stop_following(Id follower) {
  if (!has(follower)) return ErrorCode::unknown_character;
  slot_of(follower).leader = kNobody;
  is_current_ = false;
  return ErrorCode::ok;
}

ErrorCode CharacterRegistry::check_input(Id id, const FrameInput& input) const noexcept {
  return has(id) ? slot_of(id).now->inputs[0].check_room(input) : ErrorCode::unknown_character;
}

void CharacterRegistry::begin_frame(std::uint64_t number, std::uint64_t finished) noexcept {
  frame_ = number;
  std::erase_if(retired_, [finished](const Retired& retired) { return retired.last_frame <= finished; });
}

void CharacterRegistry::assign_input(Id id, const FrameInput& input) {
  Slot& slot = slot_of(id);
  Character& character = *slot.now;
  if (character.input_of_frame != frame_) character.newest_input ^= 1;  // else this submit lists the character twice
  character.input_of_frame = frame_;
  InputCopy& copy = character.inputs[character.newest_input];
  copy.assign(input);
  if (is_current_) roster_.entries[slot.entry].input = &copy;
}

/// Makes the list of followers of each character, in the order in which they were added.
void CharacterRegistry::list_followers() noexcept {
  constexpr std::uint32_t kEnd = kMostIndices;
  for (const Id id : ids_) slot_of(id).first_follower = kEnd;
  for (std::size_t i = ids_.size(); i-- > 0;) {
    Slot& slot = slot_of(ids_[i]);
    if (!has(slot.leader)) slot.leader = kNobody;  // the leader was removed
    if (slot.leader == kNobody) continue;
    slot.next_follower = slot_of(slot.leader).first_follower;
    slot_of(slot.leader).first_follower = index_of(ids_[i]);
  }
}

const Roster& CharacterRegistry::roster() noexcept {
  if (is_current_) return roster_;
  list_followers();
  roster_.clear();
  index_of_entry_.clear();
  const auto append = [&](std::uint32_t index, std::uint32_t leader) {
    Slot& slot = slots_[index];
    const Character& character = *slot.now;
    slot.entry = static_cast<std::uint32_t>(roster_.entries.size());
    roster_.append({.character = slot.now.get(),
                    .input = character.input_of_frame != 0 ? &character.inputs[character.newest_input] : nullptr,
                    .leader = leader,
                    .joint = slot.joint},
                   part_bytes_);
    index_of_entry_.push_back(index);
  };
  for (const Id id : ids_) {
    if (slot_of(id).leader != kNobody) continue;
    // All direct and indirect followers come after their leader.
    std::size_t next = roster_.entries.size();
    append(index_of(id), Roster::kNoLeader);
    for (; next < roster_.entries.size(); ++next)
      for (std::uint32_t f = slots_[index_of_entry_[next]].first_follower; f != kMostIndices;
           f = slots_[f].next_follower)
        append(f, static_cast<std::uint32_t>(next));
  }
  is_current_ = true;
  return roster_;
}

bool CharacterRegistry::can_write() const noexcept {
  return std::all_of(ids_.begin(), ids_.end(), [&](Id id) { return slot_of(id).now->slots.can_write(); });
}

const FrameResult* CharacterRegistry::latest(Id id) noexcept {
  if (!has(id)) return nullptr;
  Slot& slot = slot_of(id);
  const auto newest = [](Character& character) -> const FrameResult* {
    character.slots.take_newest();
    return character.slots.ever_read() ? &character.buffers[character.slots.reading()].result() : nullptr;
  };
  if (const FrameResult* result = newest(*slot.now)) {
    if (slot.before != nullptr) --shown_in_place_;
    retire(slot.before);
    return result;
  }
  return slot.before != nullptr ? newest(*slot.before) : nullptr;
}

}  // namespace sinew
