// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>

#include <tl/expected.hpp>

namespace sinew {

/// Error codes of the runtime, for bad *calls*: wrong sizes, indices or orders in buffers, and NaN. The importer
/// reports bad *files* with a text and a position (importer/import_error.h). Bugs of the program break a contract
/// (base/contract.h).
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
};

/// One sentence per code, for logs.
std::string_view describe(ErrorCode code) noexcept;

template <class T>
using Result = tl::expected<T, ErrorCode>;

}  // namespace sinew
