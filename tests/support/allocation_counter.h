// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

namespace sinew::test {

/// Number of calls of any form of `operator new` by this thread so far. Linking allocation_counter.cpp replaces the
/// program's global operators.
std::size_t allocation_count() noexcept;

/// As above, for calls by all threads.
std::size_t allocation_count_of_all_threads() noexcept;

/// Counts allocations of this thread since construction:  `AllocationCounter c; run(job); EXPECT_EQ(c.count(), 0u);`
class AllocationCounter {
 public:
  AllocationCounter() noexcept : before_(allocation_count()) {}
  std::size_t count() const noexcept { return allocation_count() - before_; }

 private:
  std::size_t before_;
};

/// Peak of the bytes allocated through `operator new` by all threads, minus those in use at construction. Only one
/// object may exist at a time.
class PeakMemory {
 public:
  PeakMemory() noexcept;
  std::size_t bytes() const noexcept;

 private:
  std::size_t before_;
};

}  // namespace sinew::test
