// SPDX-License-Identifier: MIT
#pragma once
#include <hwy/highway.h>

#include <cassert>

/// Defines `run_unchecked(const Job&)`, which calls `kernel(job)` compiled for the best instruction set of this
/// machine. Highway compiles the kernel once per instruction set, in namespace sinew::HWY_NAMESPACE (its
/// foreach_target). The macro belongs inside namespace sinew, in the part of the file that is compiled once (HWY_ONCE).
#define SINEW_DISPATCH_RUN(Job, kernel)                                                           \
  namespace {                                                                                     \
  HWY_EXPORT(kernel);                                                                             \
  }                                                                                               \
  void run_unchecked(const Job& job) noexcept {                                                   \
    assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts"); \
    HWY_DYNAMIC_DISPATCH(kernel)(job);                                                            \
  }
