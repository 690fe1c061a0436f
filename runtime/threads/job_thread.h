// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <memory_resource>
#include <optional>
#include <span>

#include <tl/expected.hpp>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/plan/run_plan.h"

namespace sinew {

/// Names one submitted frame: 1 for the first, rising by one per submit. FrameResult::frame of its results is the same.
using Ticket = std::uint64_t;

/// Runs `body(i)` exactly once for every i in [0, count), on any threads, and returns when all are done. It must not
/// throw. An engine passes its own job system here. Results are the same bits whichever thread runs which i. Each i
/// evaluates several characters, some microseconds of work, so the executor need not group them.
using Executor = std::function<void(std::size_t count, const std::function<void(std::size_t)>& body)>;

struct JobThreadOptions {
  /// Empty = oneTBB, or sinew's own pool in builds without it. If own_thread is false, empty = the thread that polls.
  Executor executor;
  /// A frame is one task, and is not handed to the executor, if the sum of Plan::frame_bytes() of all characters is
  /// below this. That sum grows with the work. Waking sleeping threads takes as long as this much work.
  std::size_t inline_below_bytes = std::size_t{1} << 19;
  /// A task takes consecutive characters until the sum of their Plan::frame_bytes() reaches this.
  std::size_t part_bytes = std::size_t{1} << 17;
  /// Allocates frame buffers and copies of inputs; null = operator new. Must outlive the job thread. Only the thread
  /// that submits calls it: when characters are added, replaced or removed, and in the destructor.
  std::pmr::memory_resource* frame_memory = nullptr;
  bool own_thread = true;  ///< false: no thread is made, frames run where the engine calls poll() or runs tasks
  /// 3 or 2, per character. With 2 a character takes a third less memory, and submit returns busy until the frame
  /// before is finished and latest() has taken its result of every character.
  std::uint8_t frame_buffers = 3;
};

SINEW_API ErrorCode check(const JobThreadOptions& options) noexcept;  ///< unsupported: neither 2 nor 3 frame buffers

/// Evaluates frames of many characters beside the caller's thread. Each character has three frame buffers: one being
/// written, one finished, one being read. So the worker never waits for the reader, and the reader never waits for the
/// worker unless it calls wait().
///
/// Without a thread of its own a submitted frame waits for the engine. This is for engines whose jobs are fibres, or
/// that have only one thread. poll() runs the frame, or take_task() hands it out in pieces for any threads or fibres.
/// The last task to end publishes the results. No call but wait() and the destructor blocks.
///
/// Characters may be added, removed and given other plans at any time. Such changes apply from the next submit on, not
/// to frames that are queued or running.
/// owns  one worker thread unless own_thread is false, the frame buffers of all characters
/// thread-safe  poll, take_task, tasks, done and wait from any thread; all else from one
class SINEW_API JobThread {
  struct State;

 public:
  /// Names a character. No id is used for two characters. They count from 0 until one is removed.
  using Character = std::uint32_t;

  /// The input of one character.
  struct CharacterInput {
    Character character = 0;
    FrameInput input;
  };

  explicit JobThread(JobThreadOptions options = {});
  /// Finishes the frame in flight and drops the queued one. Without a thread of its own it drops the tasks that were
  /// not taken; tasks that were taken must have ended.
  ~JobThread();
  JobThread(const JobThread&) = delete;
  JobThread& operator=(const JobThread&) = delete;

  /// Adds a character that runs `plan`, which must be a compiled one, and shares it.
  Character add_character(const Plan& plan);
  /// Removes a character. Its last result stays until the next submit. Its followers then follow nobody.
  /// err  unknown_character
  ErrorCode remove_character(Character character);
  /// Gives a character another plan, for example of another level of detail or outfit. Its last result is shown until
  /// the first frame of the new plan is done. Its input stays, if the plan has room for it.
  /// err  unknown_character, index_out_of_range and not_in_needs (followers need a joint that the plan does not show)
  ErrorCode replace_plan(Character character, const Plan& plan);
  /// Places the root of a character's input on a joint of another character in the same frame: a rider on a horse, a
  /// prop in a hand. While the leader is out of view, its followers are not run.
  /// eq   root' = M_joint root,   M_joint the world matrix of the leader's joint
  /// err  unknown_character, follows_itself (the leader follows the character, by any number of steps),
  ///      index_out_of_range (joint), not_in_needs (the leader's plan has no Needs::out.joints)
  ErrorCode follow(Character follower, Character leader, std::uint32_t joint);
  /// err  unknown_character
  ErrorCode stop_following(Character follower);
  /// All characters, in the order in which they were added; valid until one is added or removed.
  std::span<const Character> characters() const noexcept;
  std::size_t character_count() const noexcept { return characters().size(); }

  /// Queues one frame: inputs[i] is what characters()[i] shows. Inputs are copied; nothing is allocated.
  /// err  size_mismatch (not one input for each character; more weights, instances or sources than its plan has),
  ///      too_many_layers (more than Needs::in.layer_room), busy (a frame is already queued; see also frame_buffers)
  Result<Ticket> submit(std::span<const FrameInput> inputs);
  /// Queues one frame in which these inputs are new. All other characters keep their last input, so the pages and
  /// procedures that it refers to must stay valid. A character that never had an input is not run.
  /// err  those above, unknown_character
  Result<Ticket> submit(std::span<const CharacterInput> changed);

  Ticket last_submitted() const noexcept;  ///< 0 = none yet
  bool done(Ticket ticket) const noexcept;
  /// Blocks until the frame is done. Without a thread of its own it runs the pending frame as poll() does, then waits
  /// for tasks that other threads have taken.
  void wait(Ticket ticket) const;

  /// Evaluates some characters of one frame. A task is a small value: two machine words.
  class SINEW_API Task {
   public:
    Task() = default;  ///< an empty task, which must not be run
    /// Runs the characters. Each task is called exactly once, on any thread; a frame is done when its last task is.
    void operator()() const noexcept;

   private:
    friend class JobThread;
    Task(State& state, std::size_t index) noexcept : state_(&state), index_(index) {}
    State* state_ = nullptr;
    std::size_t index_ = 0;
  };

  /// Without a thread of its own: takes the next task of the frame in flight, or the first one of the queued frame.
  /// Returns std::nullopt while all tasks are taken. A task that was taken and never run leaves its frame unfinished.
  std::optional<Task> take_task() noexcept;

  /// Without a thread of its own: runs the pending frame on this thread, or by the executor if one was given.
  /// out  true if there was something to run
  bool poll();

  /// Newest finished frame of a character of this job thread; stays valid and unchanged until the next call of latest()
  /// for that character. A character whose input is unchanged is not run: it keeps its result, with the number of the
  /// frame that made it. So characters that rest or are held (update_rate.h) cost nothing. Null before the first frame
  /// is done, and for characters that were removed.
  const FrameResult* latest(Character character) noexcept;

  /// The first error of a character in the last finished frame, ok if none failed. A character that failed keeps
  /// showing its last good frame.
  ErrorCode last_error() const noexcept;

 private:
  std::unique_ptr<State> state_;
};

}  // namespace sinew
