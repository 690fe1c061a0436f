// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>

namespace tl {
template <class T, class E>
class expected;
}

#include "runtime/base/api.h"

namespace sinew {

/// Error codes of the runtime, for bad *calls*: wrong sizes, indices or orders in buffers, and NaN. Each has one cause;
/// why_refused (plan/run_plan.h) also names the field of a frame's input. The importer reports bad *files* with a text
/// and a position (importer/import_error.h). Bugs of the program break a contract (base/contract.h).
enum class ErrorCode {
  ok,
  size_mismatch,         ///< a buffer is shorter than the job needs, or two parallel buffers differ in length
  overlapping_buffers,   ///< an output buffer overlaps an input that the job still reads
  index_out_of_range,    ///< an index points past the array that it refers to
  parents_not_first,     ///< a joint comes before its parent
  times_not_increasing,  ///< key times decrease, or a time is not finite
  too_few_keys,          ///< no key at all, or fewer than two for a cubic spline
  not_finite,            ///< a number is NaN or infinite
  unsupported,           ///< the requested combination does not exist
  coincident_poses,      ///< two sample poses have the same driver rotations
  rank_deficient,        ///< a system of equations has no unique solution within rounding
  busy,                  ///< the job thread has no free slot for another frame
  not_normalised,        ///< a rotation is not a unit quaternion, or the weights of a vertex do not sum to 1
  no_plan,               ///< the plan is a default one: compile_plan did not make it
  wrong_plan,            ///< the frame buffer, or the one given to FrameBuffer::follow, was made for another plan
  moved_from,            ///< the frame buffer was moved from and has no memory
  too_many_layers,       ///< more layers than the plan's needs have room for
  wrong_page,            ///< the page of a layer is cut from a clip with other joints, weights or properties
  not_in_needs,          ///< the input uses a feature that the plan's needs do not declare
  negative_weight,       ///< a weight is below 0
  not_a_fraction,        ///< a number is outside [0, 1]
  two_times,             ///< one vertex source is asked for two times in one frame
  too_large,             ///< a finite number is so large that results could overflow
  no_cut,                ///< the second half of a frame was called without its first half
  unknown_character,     ///< the job thread has no such character, or it was removed
  follows_itself,        ///< a character would follow itself, directly or through the characters that it follows
  outside_of_clip,       ///< a time is before the start or after the end of the clip
};

/// One sentence per code, for logs.
SINEW_API std::string_view describe(ErrorCode code) noexcept;

/// A value or an ErrorCode. Headers with functions that return a Result include <tl/expected.hpp>; here the type is
/// only declared.
template <class T>
using Result = tl::expected<T, ErrorCode>;

}  // namespace sinew
