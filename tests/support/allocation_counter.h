// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

namespace sinew::test {

/// Number of calls of any form of `operator new` by this thread so far. A program that links this has its global
/// operators replaced (allocation_counter.cpp).
std::size_t allocation_count() noexcept;

/// The same for all threads together.
std::size_t allocation_count_of_all_threads() noexcept;

/// Allocations of this thread since construction:  `AllocationCounter c; run(job); EXPECT_EQ(c.count(), 0u);`
class AllocationCounter {
 public:
  AllocationCounter() noexcept : before_(allocation_count()) {}
  std::size_t count() const noexcept { return allocation_count() - before_; }

 private:
  std::size_t before_;
};

/// The most bytes that were in use at once through `operator new`, over all threads and beyond what was in use when
/// this was made. One at a time.
class PeakMemory {
 public:
  PeakMemory() noexcept;
  std::size_t bytes() const noexcept;

 private:
  std::size_t before_;
};

}  // namespace sinew::test
