// SPDX-License-Identifier: MIT
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "runtime/threads/default_executor.h"

// The thread sanitizer cannot see inside the system's libtbb, so TBB's own templates would look like races. Builds with
// that sanitizer therefore do not instrument this file.
// Annotations below declare the one guarantee of TBB: the bodies see what the caller wrote, and the caller sees
// afterwards what the bodies wrote.
#ifdef SINEW_TELL_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace sinew {
namespace {

#ifdef SINEW_TELL_THREAD_SANITIZER
void hand_over(const void* place) noexcept { __tsan_release(const_cast<void*>(place)); }
void take_over(const void* place) noexcept { __tsan_acquire(const_cast<void*>(place)); }
#else
void hand_over(const void*) noexcept {}
void take_over(const void*) noexcept {}
#endif

}  // namespace

void run_in_parallel(std::size_t count, const std::function<void(std::size_t)>& body) {
  hand_over(&body);
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      take_over(&body);
      body(i);
      hand_over(&body);
    });
  });
  take_over(&body);
}

}  // namespace sinew
