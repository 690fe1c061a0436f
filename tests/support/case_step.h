// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

namespace sinew::test {

// clang tells by __has_feature that the address sanitizer is on; g++ 12 does not have __has_feature.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SINEW_SLOW_BUILD
#endif
#endif

/// Tests that damage every byte of a file take only every kCaseStep-th byte under the address sanitizer, since all
/// bytes would take minutes.
#ifdef SINEW_SLOW_BUILD
inline constexpr std::size_t kCaseStep = 7;
#else
inline constexpr std::size_t kCaseStep = 1;
#endif
#undef SINEW_SLOW_BUILD

}  // namespace sinew::test
