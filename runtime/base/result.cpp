// SPDX-License-Identifier: MIT
#include "runtime/base/result.h"

namespace sinew {

std::string_view describe(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::ok: return "no error";
    case ErrorCode::size_mismatch: return "a buffer is too short, or parallel buffers differ in length";
    case ErrorCode::overlapping_buffers: return "an output buffer overlaps an input";
    case ErrorCode::index_out_of_range: return "an index points past the end of its array";
    case ErrorCode::parents_not_first: return "a joint comes before its parent";
    case ErrorCode::times_not_increasing: return "key times decrease or are not finite";
    case ErrorCode::too_few_keys: return "a track has fewer keys than its interpolation needs";
    case ErrorCode::not_finite: return "a number is NaN or infinite";
    case ErrorCode::unsupported: return "this combination is not supported";
    case ErrorCode::coincident_poses: return "two sample poses coincide";
    case ErrorCode::rank_deficient: return "a system of equations has no unique solution";
    case ErrorCode::busy: return "the job thread has no free slot for another frame";
    case ErrorCode::not_normalised:
      return "a rotation is not a unit quaternion, or the weights of a vertex do not sum to 1";
    case ErrorCode::no_plan: return "the plan is a default one, which compile_plan did not make";
    case ErrorCode::wrong_plan: return "a frame buffer was made for another plan";
    case ErrorCode::moved_from: return "the frame buffer was moved from and has no memory";
    case ErrorCode::too_many_layers: return "there are more layers than the plan's needs have room for";
    case ErrorCode::wrong_page: return "a page is cut from a clip with other joints, weights or properties";
    case ErrorCode::not_in_needs: return "the input uses a feature that the plan's needs do not declare";
    case ErrorCode::negative_weight: return "a weight is below 0";
    case ErrorCode::not_a_fraction: return "a number is outside [0, 1]";
    case ErrorCode::two_times: return "one vertex source is asked for two times in one frame";
    case ErrorCode::no_cut: return "no first half of a frame was run, which the second half could follow";
    case ErrorCode::unknown_character: return "the job thread has no such character, or it was removed";
    case ErrorCode::follows_itself: return "a character would follow itself, directly or by way of others";
    case ErrorCode::outside_of_clip: return "a time is before the start or after the end of the clip";
    case ErrorCode::too_large: return "a number is so large that results could overflow";
  }
  return "unknown error";
}

}  // namespace sinew
