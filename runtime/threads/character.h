// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <vector>

#include "runtime/base/prefetch.h"
#include "runtime/plan/cut_pose.h"
#include "runtime/plan/input_copy.h"
#include "runtime/plan/run_plan.h"
#include "runtime/threads/followed_input.h"
#include "runtime/threads/triple_slots.h"

namespace sinew {

/// An input of a character, and the operations of its program that run before the cut (0 = no cut).
struct StoredInput {
  InputCopy frame;
  std::size_t ops_before_cut = 0;

  bool stops_at_cut() const noexcept { return ops_before_cut != 0 && !frame.is_asleep(); }
};

/// Work that a character leaves for the second half of a frame that waits at its cut.
enum class Later : std::uint8_t { nothing, second_half, whole_frame };

/// A character of a job thread: the frames of one plan, and the inputs that they are made from.
/// owns  all frame buffers and copies of inputs, from `memory`
struct Character {
  /// in   frame_buffers  2 or 3
  Character(const Plan& shown, std::uint8_t frame_buffers, std::pmr::memory_resource& memory)
      : followed(shown, memory),
        plan(shown),
        slots(frame_buffers),
        inputs{StoredInput{InputCopy(shown, memory)}, StoredInput{InputCopy(shown, memory)}} {
    buffers.reserve(frame_buffers);
    for (std::uint8_t b = 0; b < frame_buffers; ++b) buffers.emplace_back(shown, memory);
  }

  /// Prefetches the members that a frame reads first.
  void prefetch() const noexcept {
    const auto* begin = reinterpret_cast<const std::byte*>(this);
    sinew::prefetch(begin, static_cast<std::size_t>(reinterpret_cast<const std::byte*>(&inputs) - begin));
  }

  // Used only by the thread that runs the frame of this character.
  FrameBuffer& to_write() noexcept { return buffers[slots.writing()]; }
  const FrameBuffer* last_good = nullptr;
  ErrorCode error = ErrorCode::ok;  // error of the frame that has just run
  bool is_to_run = false;           // the input differs from that of the last good frame, or stops at the cut
  Later later = Later::nothing;
  FollowedInput followed;
  CutPose cut;  // valid between the halves, while `later` is second_half

  Plan plan;
  std::vector<FrameBuffer> buffers;
  TripleSlots slots;

  // Used only by the thread that submits. One input belongs to the newest submitted frame. The other is free when the
  // next frame is accepted: only one frame may be queued, so every frame that used it has finished.
  std::array<StoredInput, 2> inputs;
  std::uint8_t newest_input = 0;
  std::uint64_t input_of_frame = 0;  // the frame for which the newest input was given; 0 = none yet
};

}  // namespace sinew
