// SPDX-License-Identifier: MIT
// The program holds runtime/threads/thread_executor.cpp, so that run_in_parallel is the one of builds without oneTBB.
#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <thread>
#include <vector>

#include "runtime/threads/default_executor.h"

namespace sinew::test {
namespace {

TEST(own_threads, run_every_item_once_from_several_callers) {
  constexpr std::size_t kItems = 1000;
  std::vector<std::vector<std::atomic<int>>> runs;
  for (int caller = 0; caller < 3; ++caller) runs.emplace_back(kItems);
  std::vector<std::thread> callers;
  for (auto& counts : runs)
    callers.emplace_back([&counts] {
      for (int round = 0; round < 20; ++round) run_in_parallel(kItems, [&](std::size_t i) { ++counts[i]; });
    });
  for (std::thread& caller : callers) caller.join();
  for (const auto& counts : runs)
    for (const auto& count : counts) ASSERT_EQ(count, 20);
}

TEST(own_threads, an_empty_loop_calls_nothing) {
  run_in_parallel(0, [](std::size_t) { FAIL(); });
}

/// The items of one loop wait for each other, so one thread alone would wait for ever.
TEST(own_threads, two_items_run_at_a_time) {
  std::atomic<int> begun = 0;
  run_in_parallel(2, [&](std::size_t) {
    ++begun;
    while (begun < 2) std::this_thread::yield();
  });
  EXPECT_EQ(begun, 2);
}

/// A thread inside an outer item must not begin another outer item while it waits for the inner loop.
TEST(own_threads, a_thread_that_waits_for_an_inner_loop_begins_no_outer_item) {
  std::atomic<int> nested = 0, inner_items = 0;
  run_in_parallel(64, [&](std::size_t) {
    thread_local int depth = 0;
    if (++depth > 1) ++nested;
    run_in_parallel(16, [&](std::size_t) { ++inner_items; });
    --depth;
  });
  EXPECT_EQ(nested, 0);
  EXPECT_EQ(inner_items, 64 * 16);
}

}  // namespace
}  // namespace sinew::test
