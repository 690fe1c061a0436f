// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

namespace sinew::test {

// clang's own question, which g++ 12 does not know.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SINEW_SLOW_BUILD
#endif
#endif

/// Tests of every byte look at each n-th where the address sanitizer makes them take minutes.
#ifdef SINEW_SLOW_BUILD
inline constexpr std::size_t kCaseStep = 7;
#else
inline constexpr std::size_t kCaseStep = 1;
#endif
#undef SINEW_SLOW_BUILD

}  // namespace sinew::test
