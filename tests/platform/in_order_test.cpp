// SPDX-License-Identifier: MIT
// This program links in_order_threads.cpp, so its run_in_order() is the one of builds without oneTBB.
#include "importer/tool/batch/in_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace sinew::test {
namespace {

using std::chrono::milliseconds;

/// Waits until it holds, a minute at most.
template <class Holds>
void wait_until(const Holds& holds) {
  for (int tries = 0; !holds() && tries < 60'000; ++tries) std::this_thread::sleep_for(milliseconds(1));
}

tool::JobOutcome outcome_of(std::string text) { return {tool::ExitCode::done, std::move(text), {}}; }

TEST(in_order_threads, shows_outcomes_in_order_and_gives_each_job_a_thread) {
  for (const std::size_t jobs : {1u, 2u, 4u}) {
    std::atomic<std::size_t> running = 0, most_running = 0;
    std::size_t shown = 0;
    tool::run_in_order(
        300, jobs,
        [&](std::size_t i) {
          const std::size_t now = ++running;
          for (std::size_t old = most_running; old < now && !most_running.compare_exchange_weak(old, now);) {
          }
          if (i < jobs) wait_until([&] { return most_running == jobs; });
          if (i % 17 == 0) std::this_thread::sleep_for(milliseconds(2));  // others wait for this one
          --running;
          return outcome_of(std::to_string(i));
        },
        [&](std::size_t i, tool::JobOutcome&& outcome) {
          EXPECT_EQ(i, shown++);
          EXPECT_EQ(outcome.results, std::to_string(i));
        });
    EXPECT_EQ(shown, 300u);
    EXPECT_EQ(most_running, jobs);
  }
}

TEST(in_order_threads, begins_nothing_while_outcomes_that_wait_hold_too_much_text) {
  constexpr std::size_t kBytes = 1000, kMost = 20'000, kJobs = 3;
  std::atomic<std::size_t> finished = 0, shown = 0;
  std::size_t most_waiting = 0;
  tool::run_in_order(
      200, kJobs,
      [&](std::size_t i) {
        if (i == 0) wait_until([&] { return finished * kBytes > kMost; });  // all others wait for it
        if (i == 0) std::this_thread::sleep_for(milliseconds(50));
        ++finished;
        return outcome_of(std::string(kBytes, 'a'));
      },
      [&](std::size_t, tool::JobOutcome&&) { most_waiting = std::max<std::size_t>(most_waiting, finished - shown++); },
      kMost);
  EXPECT_EQ(shown, 200u);
  EXPECT_GT(most_waiting, 4 * kJobs);
  EXPECT_LE(most_waiting, kMost / kBytes + 2 * kJobs);
}

TEST(in_order_threads, holds_no_more_outcomes_than_allowed) {
  constexpr std::size_t kJobs = 2, kCount = 3 * tool::kWaitingPerJob;
  std::atomic<std::size_t> begun = 0, shown = 0;
  std::size_t most_held = 0;
  tool::run_in_order(
      kCount, kJobs,
      [&](std::size_t i) {
        ++begun;
        if (i == 0) wait_until([&] { return begun >= kJobs * tool::kWaitingPerJob; });
        if (i == 0) std::this_thread::sleep_for(milliseconds(50));
        return outcome_of({});
      },
      [&](std::size_t, tool::JobOutcome&&) { most_held = std::max<std::size_t>(most_held, begun - shown++); });
  EXPECT_EQ(shown, kCount);
  EXPECT_EQ(most_held, kJobs * tool::kWaitingPerJob);
}

TEST(in_order_threads, throws_what_work_or_show_has_thrown) {
  const auto fail = [](std::size_t i) { return i == 5 ? throw std::runtime_error("work") : tool::JobOutcome{}; };
  const auto show = [](std::size_t i, tool::JobOutcome&&) {
    if (i == 3) throw std::runtime_error("show");
  };
  const auto work = [](std::size_t) { return tool::JobOutcome{}; };
  EXPECT_THROW(tool::run_in_order(50, 3, fail, [](std::size_t, tool::JobOutcome&&) {}), std::runtime_error);
  EXPECT_THROW(tool::run_in_order(50, 3, work, show), std::runtime_error);
  tool::run_in_order(0, 3, fail, show);
  EXPECT_GE(tool::cores_to_use(), 1u);
}

}  // namespace
}  // namespace sinew::test
