// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include <tl/expected.hpp>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/plan/cut_pose.h"
#include "runtime/plan/run_plan.h"
#include "runtime/threads/follow_place.h"
#include "runtime/threads/job_thread_options.h"

namespace sinew {

/// Names one submitted frame: 1 for the first, rising by one per submit. FrameResult::frame of its results is the same.
using Ticket = std::uint64_t;

/// Evaluates frames of many characters beside the caller's thread. Each character has three frame buffers: one being
/// written, one finished, one being read. So the worker never waits for the reader, and the reader never waits for the
/// worker unless it calls wait().
///
/// Without a thread of its own a submitted frame waits for the engine, whose jobs may be fibres. poll() runs the frame,
/// or take_task() hands it out in pieces for any threads or fibres. The last task to end publishes the results. No call
/// but wait() and the destructor blocks.
///
/// Frames may stop at a cut (CharacterInput::ops_before_cut): the caller looks at poses and changes them, then the
/// frame goes on. Results are those of run_from_cut (cut_frame.h), and all are published together:
///     const Ticket ticket = *jobs.submit(changed);
///     while (!jobs.wait(ticket)) {  // true: done; false: the frame waits at its cut
///       for (Body& body : bodies) body.place(*jobs.cut_pose(body.character));
///       jobs.resume();
///     }
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
    /// Operations of the program that run before the cut, as in run_to_cut; kMostPoseOps = all. 0 = no cut. Needs
    /// Needs::in.cut. A kept input stops again in each frame, unless it is asleep.
    std::size_t ops_before_cut = 0;
  };

  explicit JobThread(JobThreadOptions options = {});
  /// Finishes the frame in flight, or drops it at its cut, and drops the queued one. Without a thread of its own it
  /// drops the tasks that were not taken; tasks that were taken must have ended.
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
  /// Places the root of a character's input, an override or the target of a procedure on a joint of another character
  /// in the same frame (follow_place.h). Each place has one leader at most; the last call counts. While the leader of
  /// its root is out of view, a follower is not run; other places then keep what the input says. Characters that
  /// follow each other, by any number of steps, run one after the other.
  /// err  unknown_character, follows_itself (the leader follows the character, by any number of steps),
  ///      index_out_of_range (joint), not_in_needs (the leader's plan has no Needs::out.joints), size_mismatch (a
  ///      procedure without a matrix). last_error() tells of inputs that lack the place: index_out_of_range,
  ///      unsupported (an override in local space), rank_deficient (the follower's root has no inverse)
  ErrorCode follow(Character follower, Character leader, std::uint32_t joint, const FollowPlace& place = {});
  /// err  unknown_character
  ErrorCode stop_following(Character follower, const FollowPlace& place = {});
  /// All characters in the order of adding; valid until one is added or removed.
  std::span<const Character> characters() const noexcept;
  std::size_t character_count() const noexcept { return characters().size(); }

  /// Queues one frame: inputs[i] is what characters()[i] shows. Inputs are copied; nothing is allocated.
  /// err  size_mismatch (not one input for each character; more weights, instances or sources than its plan has),
  ///      too_many_layers (more than Needs::in.layer_room), busy (a frame is already queued; see also frame_buffers)
  Result<Ticket> submit(std::span<const FrameInput> inputs);
  /// Queues one frame in which these inputs are new. All other characters keep their last input, so the pages and
  /// procedures that it refers to must stay valid. A character that never had an input is not run.
  /// err  those above, unknown_character, not_in_needs (a cut)
  Result<Ticket> submit(std::span<const CharacterInput> changed);

  Ticket last_submitted() const noexcept;  ///< 0 = none yet
  bool done(Ticket ticket) const noexcept;
  /// Blocks until the frame is done, or it or the frame before it waits at its cut. Without a thread of its own it runs
  /// the pending frame as poll() does, then waits for tasks that other threads have taken.
  /// out  done(ticket)
  bool wait(Ticket ticket) const;

  /// The pose of a character whose frame waits at its cut; the caller may write it until resume(). Null if no frame
  /// waits, or the character does not stop there, was removed or got another plan since. Up to the cut a follower uses
  /// joints of its leader at the cut if the leader stops too, else those of its last result. The second half uses the
  /// final joints, for the root and for the operations that are left.
  const CutPose* cut_pose(Character character) const noexcept;
  /// Lets the frame that waits at its cut go on. Followers of characters that stopped run now.
  /// err  no_cut (no frame waits). A pose with NaN or infinity is reported by last_error() as not_finite
  ErrorCode resume() noexcept;

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
