// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/cut_frame.h"
#include "runtime/c/frame.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Frames of many characters, evaluated beside the caller's thread. One thread submits and reads results.
typedef struct sinew_jobs sinew_jobs;

/// The engine's job system: calls body(body_context, i) once for every i in [0, count), on any threads, and returns
/// when all are done.
typedef struct sinew_executor {
  void* context;
  void (*run)(void* context, size_t count, void (*body)(void* body_context, size_t i), void* body_context);
} sinew_executor;

typedef struct sinew_jobs_options {
  size_t struct_size;
  sinew_executor executor;    ///< run null = oneTBB; with own_thread 0, null = the thread that polls
  sinew_allocator allocator;  ///< allocates frame memory; allocate null = operator new
  size_t inline_below_bytes;  ///< frames are not handed to the executor if the frame memory of all characters is below
                              ///< this
  size_t part_bytes;          ///< consecutive characters form one part for the executor until their memory reaches this
  uint32_t own_thread;        ///< 0: no thread is made, frames run where the engine polls or runs tasks
  uint32_t frame_buffers;  ///< of each character, 3 or 2. With 2, submit returns SINEW_BUSY until the frame before is
                           ///< finished and sinew_jobs_latest has taken its result of every character
} sinew_jobs_options;
SINEW_API sinew_jobs_options sinew_default_jobs_options(void);

/// Creates the jobs, at first without characters.
/// in   options  null = the defaults; copied, but the objects it points to must outlive the jobs
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_UNSUPPORTED (frame_buffers), SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_jobs_create(const sinew_jobs_options* options, sinew_jobs** out);
/// Finishes the frame in flight. Without a thread of its own it drops the tasks that were not taken, and tasks that
/// were taken must have been run.
SINEW_API void sinew_jobs_destroy(sinew_jobs* jobs);

/// Adds a character that runs `plan`.
/// in   plan  must outlive the jobs
/// err  SINEW_NULL_ARGUMENT, SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_jobs_add_character(sinew_jobs* jobs, const sinew_plan* plan, uint32_t* character);
/// These functions change characters while frames run, without waiting. Changes apply from the next submit on. The last
/// result of a removed character stays until the next submit. Its followers then follow nobody.
/// err  SINEW_NULL_ARGUMENT, SINEW_UNKNOWN_CHARACTER, SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_jobs_remove_character(sinew_jobs* jobs, uint32_t character);
/// The character's last result is shown until the first frame of the new plan is done. Its input stays, if the plan has
/// room for it.
/// in   plan  must outlive the jobs
/// err  those above, SINEW_INDEX_OUT_OF_RANGE and SINEW_NOT_IN_NEEDS (followers need a joint that the plan does not
///      show)
SINEW_API sinew_error sinew_jobs_replace_plan(sinew_jobs* jobs, uint32_t character, const sinew_plan* plan);
/// Makes the root of the follower's input relative to a joint of the leader in the same frame: a rider, a prop.
/// err  SINEW_NULL_ARGUMENT, SINEW_UNKNOWN_CHARACTER, SINEW_FOLLOWS_ITSELF, SINEW_INDEX_OUT_OF_RANGE (joint),
///      SINEW_NOT_IN_NEEDS (the leader's plan has no SINEW_NEED_JOINTS)
SINEW_API sinew_error sinew_jobs_follow(sinew_jobs* jobs, uint32_t follower, uint32_t leader, uint32_t joint);
SINEW_API sinew_error sinew_jobs_stop_following(sinew_jobs* jobs, uint32_t follower);
typedef enum sinew_follow_kind {
  SINEW_FOLLOW_ROOT = 0,            ///< root' = M root
  SINEW_FOLLOW_JOINT_OVERRIDE = 1,  ///< transform' = R^-1 M transform, of an override in model space
  SINEW_FOLLOW_PROCEDURE = 2        ///< *matrix = R^-1 M: the target of a look-at or of inverse kinematics
} sinew_follow_kind;
/// The place in a follower's input that follows a joint of another character. M is the world matrix of the joint, R the
/// world matrix of the follower's root. Versions of the override or procedure then also stand for M and R.
typedef struct sinew_follow_place {
  size_t struct_size;
  uint32_t kind;         ///< a value of sinew_follow_kind
  uint32_t list;         ///< index into the lists of overrides or procedures of the follower's program inputs
  uint32_t entry;        ///< index into the joints of that list of overrides
  sinew_affine* matrix;  ///< procedures: the matrix that the procedure reads, of this place alone. Frames write it
                         ///< before the procedure runs, so only the procedure may use it while frames run
} sinew_follow_place;
/// As sinew_jobs_follow for any place of the follower's input. Each place has one leader at most; the last call counts.
/// While the leader is out of view, places other than the root keep what the input says.
/// in   place  null = the root
/// err  those of sinew_jobs_follow, SINEW_NULL_ARGUMENT (also a procedure without a matrix), SINEW_WRONG_STRUCT_SIZE,
///      SINEW_UNSUPPORTED (kind). sinew_jobs_last_error tells of inputs that lack the place: SINEW_INDEX_OUT_OF_RANGE,
///      SINEW_UNSUPPORTED (an override in local space), SINEW_RANK_DEFICIENT (the root has no inverse)
SINEW_API sinew_error sinew_jobs_follow_at(sinew_jobs* jobs, uint32_t follower, uint32_t leader, uint32_t joint,
                                           const sinew_follow_place* place);
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_UNSUPPORTED (kind), SINEW_UNKNOWN_CHARACTER
SINEW_API sinew_error sinew_jobs_stop_following_at(sinew_jobs* jobs, uint32_t follower,
                                                   const sinew_follow_place* place);
/// All characters, in the order in which they were added; valid until one is added or removed.
SINEW_API sinew_indices sinew_jobs_characters(const sinew_jobs* jobs);

/// Queues one frame: inputs[i] is what the i-th of sinew_jobs_characters shows. Inputs are copied, except for pages and
/// the procedures of programs, which must not change until the frame is done. All inputs have the same struct_size,
/// which is the stride of the array.
/// out  ticket  names the frame: 1 for the first, rising by one; may be null
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_SIZE_MISMATCH (another number of characters, too many
///      weights, poses or masks of another size), SINEW_TOO_MANY_LAYERS, SINEW_UNSUPPORTED (kind of layer, space of an
///      override), SINEW_NOT_IN_NEEDS (interpolation, more of a program than the needs declare), SINEW_BUSY
SINEW_API sinew_error sinew_jobs_submit(sinew_jobs* jobs, const sinew_frame_input* inputs, size_t input_count,
                                        uint64_t* ticket);
/// The input of one character.
typedef struct sinew_character_input {
  const sinew_frame_input* input;
  uint32_t character;
  uint32_t ops_before_cut;  ///< operations of the program that run before the cut, SINEW_MOST_OPS = all; 0 = no cut.
                            ///< Needs SINEW_NEED_CUT. A kept input stops again in each frame, unless it is asleep
} sinew_character_input;

/// Queues one frame in which these inputs are new. All other characters keep their last input, so the pages and
/// procedures that it refers to must stay valid. A character that never had an input is not run.
/// err  those above, SINEW_UNKNOWN_CHARACTER, SINEW_NOT_IN_NEEDS (a cut)
SINEW_API sinew_error sinew_jobs_submit_changed(sinew_jobs* jobs, const sinew_character_input* changed, size_t count,
                                                uint64_t* ticket);
SINEW_API int sinew_jobs_done(const sinew_jobs* jobs, uint64_t ticket);
/// Blocks until the frame is done, or until it or the frame before it waits at its cut; sinew_jobs_done tells which.
/// in   ticket  returned by submit
SINEW_API sinew_error sinew_jobs_wait(const sinew_jobs* jobs, uint64_t ticket);

/// The pose of a character whose frame waits at its cut; it may be written until sinew_jobs_resume. A follower whose
/// leader stops as well shows matrices relative to the leader's joint at the cut.
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_NO_CUT (no frame waits, or the character does not stop
///      there, was removed or got another plan since)
SINEW_API sinew_error sinew_jobs_cut_pose(const sinew_jobs* jobs, uint32_t character, sinew_cut_pose* pose);
/// Lets the frame that waits at its cut go on. A pose with NaN or infinity is reported by sinew_jobs_last_error as
/// SINEW_NOT_FINITE.
/// err  SINEW_NULL_ARGUMENT, SINEW_NO_CUT (no frame waits)
SINEW_API sinew_error sinew_jobs_resume(sinew_jobs* jobs);

/// Without a thread of its own: runs the pending frame on this thread, or by the executor if one was given. Returns 1
/// if there was something to run.
SINEW_API int sinew_jobs_poll(sinew_jobs* jobs);

/// A task that evaluates some characters of one frame. It may be copied to any thread or fibre; its fields are private.
typedef struct sinew_task {
  void* inside[2];
} sinew_task;

/// Without a thread of its own: takes the next task of the submitted frame. Returns 1, or 0 while there is none. Each
/// task is run once, on any thread.
SINEW_API int sinew_jobs_take_task(sinew_jobs* jobs, sinew_task* task);
SINEW_API void sinew_task_run(const sinew_task* task);

/// The newest finished frame of a character, unchanged until the next call for that character. Null before the first
/// frame is done, and for characters that were removed.
SINEW_API const sinew_result* sinew_jobs_latest(sinew_jobs* jobs, uint32_t character);
/// The first error of a character in the last finished frame. A character that failed keeps showing its last good
/// frame.
SINEW_API sinew_error sinew_jobs_last_error(const sinew_jobs* jobs);

#ifdef __cplusplus
}
#endif
