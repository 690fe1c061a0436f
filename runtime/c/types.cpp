// SPDX-License-Identifier: MIT
#include "runtime/c/types.h"

#include <cstdint>

#include "runtime/base/result.h"

static_assert(SINEW_VERSION_MAJOR == SINEW_PROJECT_MAJOR && SINEW_VERSION_MINOR == SINEW_PROJECT_MINOR &&
                  SINEW_VERSION_PATCH == SINEW_PROJECT_PATCH,
              "runtime/c/types.h and CMakeLists.txt name different versions");

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
