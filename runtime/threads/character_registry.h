// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <memory_resource>
#include <span>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/threads/follow_order.h"
#include "runtime/threads/roster.h"

namespace sinew {

/// The characters of a job thread by their ids. Only the thread that submits uses it. Frames in flight use copies of
/// its roster, so characters may be added, removed and given new plans meanwhile. The memory of removed characters is
/// freed when no frame uses it any more.
class CharacterRegistry {
 public:
  /// An index in the low bits, and the generation of that index above: an id is never used for two characters.
  using Id = std::uint32_t;

  /// in   frame_buffers  of each character, 2 or 3
  ///      part_bytes     see Roster::append
  CharacterRegistry(std::uint8_t frame_buffers, std::size_t part_bytes, std::pmr::memory_resource& memory) noexcept
      : frame_buffers_(frame_buffers), part_bytes_(part_bytes), memory_(memory) {}

  std::span<const Id> ids() const noexcept { return ids_; }  ///< in the order in which they were added
  bool has(Id id) const noexcept;
  bool was_given(Id id) const noexcept;  ///< also true for ids of characters that were removed

  Id add(const Plan& plan);
  ErrorCode remove(Id id);
  ErrorCode replace(Id id, const Plan& plan);
  ErrorCode follow(Id follower, Id leader, std::uint32_t joint, const FollowPlace& place);
  ErrorCode stop_following(Id follower, const FollowPlace& place);
  std::size_t link_count() const noexcept { return links_.size(); }

  /// An input of the caller.
  struct GivenInput {
    Id id;
    const FrameInput& input;
    std::size_t ops_before_cut;
  };
  ErrorCode check_input(const GivenInput& given) const noexcept;
  /// Inputs assigned from now on belong to frame `number`. Frees characters that no frame after `finished` uses.
  void begin_frame(std::uint64_t number, std::uint64_t finished) noexcept;
  /// Copies an input that check_input() accepts. Later frames use the copy, too, until another input is assigned.
  void assign_input(const GivenInput& given);
  /// All characters with their newest inputs.     cost  O(1), O(characters) after they have changed; allocates nothing
  const Roster& roster() noexcept;

  /// True if every character has a frame buffer to write into; always true for three buffers.
  bool can_write() const noexcept;
  /// The newest published result, unchanged until the next call for the character; null before the first.
  const FrameResult* latest(Id id) noexcept;
  /// The pose of a character at the cut of the frame that waits; null if it does not stop there.
  const CutPose* cut_pose(Id id) const noexcept;

 private:
  static constexpr std::uint32_t kIndexBits = 20;
  static constexpr Id kMostIndices = Id{1} << kIndexBits;

  struct Slot {
    std::unique_ptr<Character> now;     // null = no character has the index
    std::unique_ptr<Character> before;  // the replaced one, shown until `now` has a result
    Id generation = 0;
    std::uint32_t entry = 0;  // index in the roster, while the roster is current
  };
  /// A character that left. Frames up to `last_frame` may still run it.
  struct Retired {
    std::unique_ptr<Character> character;
    std::uint64_t last_frame;
  };

  static std::uint32_t index_of(Id id) noexcept { return id & (kMostIndices - 1); }
  Slot& slot_of(Id id) noexcept { return slots_[index_of(id)]; }
  const Slot& slot_of(Id id) const noexcept { return slots_[index_of(id)]; }
  void make_room_to_retire(std::size_t count);
  void retire(std::unique_ptr<Character>& character) noexcept;
  void append_to_roster(const FollowOrder::Position& position) noexcept;

  std::uint8_t frame_buffers_;
  std::size_t part_bytes_;
  std::pmr::memory_resource& memory_;
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_indices_;
  std::vector<Id> ids_;
  std::vector<Retired> retired_;
  std::size_t shown_in_place_ = 0;  // slots with a `before`, for which retired_ has room
  std::vector<FollowLink> links_;   // sorted by follower
  FollowOrder order_;
  std::vector<std::uint32_t> indices_;  // of ids_, for the order
  std::uint64_t frame_ = 0;             // number of the newest frame that was begun
  Roster roster_;
  bool is_current_ = true;  // the roster fits the characters
};

}  // namespace sinew
