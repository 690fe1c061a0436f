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

/// Checks that a character's memory holds the lists of this input, and that its plan allows cuts if the input has one.
ErrorCode check_room(const Character& character, const FrameInput& input, std::size_t ops_before_cut) noexcept {
  if (ops_before_cut != 0 && !character.plan.needs().in.cut) return ErrorCode::not_in_needs;
  return character.inputs[0].frame.check_room(input);
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
    make_room(indices_, count);
    order_.reserve(count);
    roster_.reserve(count, links_.size());
    slots_.emplace_back();
    free_indices_.push_back(static_cast<std::uint32_t>(slots_.size() - 1));
  }
  const std::uint32_t index = free_indices_.back();
  free_indices_.pop_back();
  Slot& slot = slots_[index];
  slot.now = std::move(character);
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
  std::erase_if(links_,
                [index = index_of(id)](const FollowLink& l) { return l.follower == index || l.leader == index; });
  is_current_ = false;
  return ErrorCode::ok;
}

ErrorCode CharacterRegistry::replace(Id id, const Plan& plan) {
  if (!has(id)) return ErrorCode::unknown_character;
  for (const FollowLink& link : links_)
    if (link.leader == index_of(id))
      if (const ErrorCode error = check_leader(plan, link.joint); error != ErrorCode::ok) return error;
  auto next = std::make_unique<Character>(plan, frame_buffers_, memory_);
  make_room_to_retire(2);  // from here on nothing throws
  Slot& slot = slot_of(id);
  if (slot.now->input_of_frame != 0) {
    const StoredInput& kept = slot.now->inputs[slot.now->newest_input];
    const FrameInput input = kept.frame.view();
    if (check_room(*next, input, kept.ops_before_cut) == ErrorCode::ok) {
      next->inputs[0].frame.assign(input);
      next->inputs[0].ops_before_cut = kept.ops_before_cut;
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

ErrorCode CharacterRegistry::follow(Id follower, Id leader, std::uint32_t joint, const FollowPlace& place) {
  if (!has(follower) || !has(leader)) return ErrorCode::unknown_character;
  if (place.kind == FollowKind::procedure && place.matrix == nullptr) return ErrorCode::size_mismatch;
  if (const ErrorCode error = check_leader(slot_of(leader).now->plan, joint); error != ErrorCode::ok) return error;
  if (follows(links_, slots_.size(), index_of(leader), index_of(follower))) return ErrorCode::follows_itself;
  make_room(links_, links_.size() + 1);
  roster_.reserve(ids_.size(), links_.size() + 1);  // from here on nothing throws
  (void)stop_following(follower, place);
  const FollowLink link{index_of(follower), index_of(leader), joint, place};
  const auto before = [](const FollowLink& a, const FollowLink& b) { return a.follower < b.follower; };
  links_.insert(std::upper_bound(links_.begin(), links_.end(), link, before), link);
  is_current_ = false;
  return ErrorCode::ok;
}

ErrorCode CharacterRegistry::stop_following(Id follower, const FollowPlace& place) {
  if (!has(follower)) return ErrorCode::unknown_character;
  std::erase_if(links_, [&](const FollowLink& link) {
    return link.follower == index_of(follower) && link.place.is_same_place(place);
  });
  is_current_ = false;
  return ErrorCode::ok;
}

ErrorCode CharacterRegistry::check_input(const GivenInput& given) const noexcept {
  if (!has(given.id)) return ErrorCode::unknown_character;
  return check_room(*slot_of(given.id).now, given.input, given.ops_before_cut);
}

void CharacterRegistry::begin_frame(std::uint64_t number, std::uint64_t finished) noexcept {
  frame_ = number;
  std::erase_if(retired_, [finished](const Retired& retired) { return retired.last_frame <= finished; });
}

void CharacterRegistry::assign_input(const GivenInput& given) {
  Slot& slot = slot_of(given.id);
  Character& character = *slot.now;
  if (character.input_of_frame != frame_) character.newest_input ^= 1;  // else this submit lists the character twice
  character.input_of_frame = frame_;
  StoredInput& stored = character.inputs[character.newest_input];
  stored.frame.assign(given.input);
  stored.ops_before_cut = given.ops_before_cut;
  if (is_current_) roster_.entries[slot.entry].input = &stored;
}

void CharacterRegistry::append_to_roster(const FollowOrder::Position& position) noexcept {
  Slot& slot = slots_[position.index];
  const Character& character = *slot.now;
  slot.entry = static_cast<std::uint32_t>(roster_.entries.size());
  const auto first_link = static_cast<std::uint32_t>(roster_.links.size());
  for (const FollowLink& link : links_of(links_, position.index))
    roster_.links.push_back({slots_[link.leader].entry, link.joint, link.place});
  roster_.append({.character = slot.now.get(),
                  .input = character.input_of_frame != 0 ? &character.inputs[character.newest_input] : nullptr,
                  .first_link = first_link,
                  .link_count = static_cast<std::uint32_t>(roster_.links.size()) - first_link},
                 position.begins_group, part_bytes_);
}

const Roster& CharacterRegistry::roster() noexcept {
  if (is_current_) return roster_;
  roster_.clear();
  indices_.clear();
  for (const Id id : ids_) indices_.push_back(index_of(id));
  for (const FollowOrder::Position& position : order_.sort(indices_, links_)) append_to_roster(position);
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

const CutPose* CharacterRegistry::cut_pose(Id id) const noexcept {
  if (!has(id)) return nullptr;
  const Character& character = *slot_of(id).now;
  return character.later == Later::second_half ? &character.cut : nullptr;
}

}  // namespace sinew
