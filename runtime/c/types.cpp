// SPDX-License-Identifier: MIT
#include "runtime/c/types.h"

#include <cstdint>

#include "runtime/base/result.h"
#include "runtime/c/boundary.h"
#include "runtime/math/affine.h"
#include "runtime/math/joint_matrix.h"

namespace sinew::c {

static_assert(
    error_from(ErrorCode::ok) == SINEW_OK && error_from(ErrorCode::size_mismatch) == SINEW_SIZE_MISMATCH &&
    error_from(ErrorCode::overlapping_buffers) == SINEW_OVERLAPPING_BUFFERS &&
    error_from(ErrorCode::index_out_of_range) == SINEW_INDEX_OUT_OF_RANGE &&
    error_from(ErrorCode::parents_not_first) == SINEW_PARENTS_NOT_FIRST &&
    error_from(ErrorCode::times_not_increasing) == SINEW_TIMES_NOT_INCREASING &&
    error_from(ErrorCode::too_few_keys) == SINEW_TOO_FEW_KEYS &&
    error_from(ErrorCode::not_finite) == SINEW_NOT_FINITE && error_from(ErrorCode::unsupported) == SINEW_UNSUPPORTED &&
    error_from(ErrorCode::coincident_poses) == SINEW_COINCIDENT_POSES &&
    error_from(ErrorCode::rank_deficient) == SINEW_RANK_DEFICIENT && error_from(ErrorCode::busy) == SINEW_BUSY &&
    error_from(ErrorCode::not_normalised) == SINEW_NOT_NORMALISED && error_from(ErrorCode::no_plan) == SINEW_NO_PLAN &&
    error_from(ErrorCode::wrong_plan) == SINEW_WRONG_PLAN && error_from(ErrorCode::moved_from) == SINEW_MOVED_FROM &&
    error_from(ErrorCode::too_many_layers) == SINEW_TOO_MANY_LAYERS &&
    error_from(ErrorCode::wrong_page) == SINEW_WRONG_PAGE &&
    error_from(ErrorCode::not_in_needs) == SINEW_NOT_IN_NEEDS &&
    error_from(ErrorCode::negative_weight) == SINEW_NEGATIVE_WEIGHT &&
    error_from(ErrorCode::not_a_fraction) == SINEW_NOT_A_FRACTION &&
    error_from(ErrorCode::two_times) == SINEW_TWO_TIMES && error_from(ErrorCode::too_large) == SINEW_TOO_LARGE &&
    error_from(ErrorCode::no_cut) == SINEW_NO_CUT);
static_assert(sizeof(sinew_affine) == sizeof(Affine) && sizeof(sinew_joint_matrix) == sizeof(JointMatrix));
static_assert(SINEW_VERSION_MAJOR == SINEW_PROJECT_MAJOR && SINEW_VERSION_MINOR == SINEW_PROJECT_MINOR &&
                  SINEW_VERSION_PATCH == SINEW_PROJECT_PATCH,
              "runtime/c/types.h and CMakeLists.txt name different versions");

}  // namespace sinew::c

std::uint32_t sinew_version(void) { return SINEW_VERSION; }

const char* sinew_describe(sinew_error error) {
  switch (error) {
    case SINEW_NULL_ARGUMENT: return "a pointer that must not be null is";
    case SINEW_WRONG_STRUCT_SIZE: return "a struct_size is not that of any version that this library knows";
    case SINEW_OUT_OF_MEMORY: return "out of memory";
    case SINEW_BAD_FILE: return "the file breaks a rule of its format";
    case SINEW_UNBOUND: return "clips move what the skeleton or the scene does not have";
    default: return sinew::describe(static_cast<sinew::ErrorCode>(error)).data();  // literals, which end in a zero
  }
}
