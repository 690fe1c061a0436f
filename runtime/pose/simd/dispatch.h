// SPDX-License-Identifier: MIT
#pragma once
#include <hwy/highway.h>

/// Defines `run(const Job&)` inside namespace sinew: it calls `kernel(job)` of the best instruction set that this
/// machine has. The kernel is compiled once per instruction set, in namespace sinew::HWY_NAMESPACE (Highway's
/// foreach_target); the macro belongs into the part of the file that is compiled once (HWY_ONCE).
#define SINEW_DISPATCH_RUN(Job, kernel) \
  namespace {                           \
  HWY_EXPORT(kernel);                   \
  }                                     \
  void run(const Job& job) noexcept { HWY_DYNAMIC_DISPATCH(kernel)(job); }
