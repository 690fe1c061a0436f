// SPDX-License-Identifier: MIT
// Job threads without a thread of their own: the engine polls, or runs tasks on its own threads or fibres.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <limits>
#include <thread>

#include "tests/scenes/hand_scenes.h"
#include "tests/support/allocation_counter.h"
#include "tests/threads/crowd.h"

namespace sinew::test {
namespace {

/// Options under which each character is a task of its own, which any thread may take.
JobThreadOptions handed_out(Executor executor = {}) {
  JobThreadOptions options = spread(std::move(executor));
  options.own_thread = false;
  return options;
}

std::vector<JobThread::Task> take_all(JobThread& jobs) {
  std::vector<JobThread::Task> tasks;
  while (const auto task = jobs.take_task()) tasks.push_back(*task);
  return tasks;
}

std::size_t threads_of_this_process() {
  const std::filesystem::path tasks = "/proc/self/task";
  if (!std::filesystem::exists(tasks)) return 0;
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(tasks), {}));
}

TEST(job_tasks, a_loop_that_polls_gives_the_bits_of_a_frame_without_threads) {
  Crowd crowd(7);
  for (const bool in_parts : {true, false}) {
    JobThreadOptions options;
    if (in_parts) options = spread();
    options.own_thread = false;
    JobThread jobs(options);
    crowd.add_to(jobs);
    EXPECT_FALSE(jobs.poll()) << "nothing was submitted";
    for (Ticket expected = 1; expected <= 20; ++expected) {
      ASSERT_EQ(jobs.submit(crowd.inputs(expected)), expected);
      EXPECT_FALSE(jobs.done(expected));
      EXPECT_TRUE(jobs.poll());
      EXPECT_TRUE(jobs.done(expected));
      EXPECT_FALSE(jobs.poll());
      for (std::uint32_t c = 0; c < 7; ++c) {
        ASSERT_NE(jobs.latest(c), nullptr);
        EXPECT_EQ(jobs.latest(c)->frame, expected);
        EXPECT_EQ(hash_of(*jobs.latest(c)), crowd.hash_without_threads(c, expected)) << "character " << c;
      }
    }
  }
}

/// Runs in its own process: the system may still count threads of earlier tests after they were joined.
TEST(job_tasks, a_loop_that_polls_makes_no_thread) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto poll_some_frames = [] {
    Crowd crowd(7);
    const std::size_t threads_before = threads_of_this_process();
    JobThread jobs(handed_out());
    crowd.add_to(jobs);
    for (Ticket frame = 1; frame <= 20; ++frame)
      if (jobs.submit(crowd.inputs(frame)) != frame || !jobs.poll()) std::_Exit(2);
    std::_Exit(threads_of_this_process() == threads_before ? 0 : 1);
  };
  EXPECT_EXIT(poll_some_frames(), testing::ExitedWithCode(0), "");
}

TEST(job_tasks, a_frame_is_done_when_the_last_of_its_tasks_is_in_any_order) {
  Crowd crowd(5);
  JobThread jobs(handed_out());
  crowd.add_to(jobs);
  EXPECT_FALSE(jobs.take_task());
  ASSERT_TRUE(jobs.submit(crowd.inputs(1)));
  std::vector<JobThread::Task> tasks = take_all(jobs);
  ASSERT_EQ(tasks.size(), 5u);
  ASSERT_EQ(jobs.submit(crowd.inputs(2)), Ticket{2}) << "one frame waits";
  EXPECT_EQ(jobs.submit(crowd.inputs(3)).error(), ErrorCode::busy);
  for (; !tasks.empty(); tasks.pop_back()) {
    EXPECT_FALSE(jobs.done(1));
    EXPECT_EQ(jobs.latest(3), nullptr) << "all characters of a frame appear together";
    EXPECT_FALSE(jobs.take_task()) << "the next frame starts when this one is done";
    tasks.back()();
  }
  EXPECT_TRUE(jobs.done(1));
  for (std::uint32_t c = 0; c < 5; ++c) EXPECT_EQ(hash_of(*jobs.latest(c)), crowd.hash_without_threads(c, 1));
  tasks = take_all(jobs);
  EXPECT_EQ(tasks.size(), 5u);
  for (const JobThread::Task& task : tasks) task();
}

TEST(job_tasks, threads_that_steal_tasks_give_the_same_bits) {
  constexpr std::uint32_t kCharacters = 13;
  constexpr Ticket kFrames = 24;
  Crowd crowd(kCharacters);
  for (const int thread_count : {1, 2, 4, 8}) {
    JobThread jobs(handed_out());
    crowd.add_to(jobs);
    std::atomic<bool> stop{false};
    std::atomic<std::size_t> tasks_run{0};
    std::vector<std::thread> thieves;
    for (int t = 0; t < thread_count; ++t)
      thieves.emplace_back([&] {
        while (!stop) {
          if (const auto task = jobs.take_task()) {
            (*task)();
            ++tasks_run;
          } else {
            std::this_thread::yield();
          }
        }
      });
    for (Ticket frame = 1; frame <= kFrames; ++frame) {
      ASSERT_EQ(jobs.submit(crowd.inputs(frame)), frame);
      while (!jobs.done(frame)) std::this_thread::yield();
      for (std::uint32_t c = 0; c < kCharacters; ++c) {
        ASSERT_EQ(jobs.latest(c)->frame, frame);
        ASSERT_EQ(hash_of(*jobs.latest(c)), crowd.hash_without_threads(c, frame)) << thread_count << " threads";
      }
    }
    stop = true;
    for (std::thread& thief : thieves) thief.join();
    EXPECT_EQ(tasks_run, kCharacters * kFrames);
  }
}

TEST(job_tasks, a_reader_beside_the_thieves_sees_whole_frames_that_never_go_back) {
  constexpr Ticket kFrames = 40;
  Crowd crowd(4);
  std::vector<std::uint64_t> expected[4];
  for (std::uint32_t c = 0; c < 4; ++c)
    for (Ticket n = 0; n <= kFrames; ++n) expected[c].push_back(crowd.hash_without_threads(c, n));
  JobThread jobs(handed_out());
  crowd.add_to(jobs);
  std::atomic<bool> stop{false};
  std::vector<std::thread> pollers;
  for (int t = 0; t < 3; ++t)
    pollers.emplace_back([&] {
      while (!stop)
        if (!jobs.poll()) std::this_thread::yield();
    });
  std::uint64_t newest[4] = {};
  for (Ticket submitted = 0; newest[0] < kFrames || newest[3] < kFrames;) {
    if (submitted < kFrames && jobs.submit(crowd.inputs(submitted + 1))) ++submitted;
    for (std::uint32_t c = 0; c < 4; ++c) {
      const FrameResult* shown = jobs.latest(c);
      if (shown == nullptr) continue;
      ASSERT_GE(shown->frame, newest[c]);
      newest[c] = shown->frame;
      ASSERT_EQ(hash_of(*shown), expected[c][shown->frame]);
    }
  }
  stop = true;
  for (std::thread& poller : pollers) poller.join();
}

TEST(job_tasks, an_executor_that_is_polled_is_called_on_the_thread_that_polls) {
  std::thread::id called_on;
  std::size_t handed = 0;
  Crowd crowd(6);
  JobThread jobs(handed_out([&](std::size_t count, const std::function<void(std::size_t)>& body) {
    called_on = std::this_thread::get_id();
    handed = count;
    while (count-- > 0) body(count);
  }));
  crowd.add_to(jobs);
  ASSERT_TRUE(jobs.submit(crowd.inputs(4)));
  std::thread::id polled_on;
  std::thread([&] {
    polled_on = std::this_thread::get_id();
    EXPECT_TRUE(jobs.poll());
  }).join();
  EXPECT_EQ(called_on, polled_on);
  EXPECT_EQ(handed, 6u);
  for (std::uint32_t c = 0; c < 6; ++c) EXPECT_EQ(hash_of(*jobs.latest(c)), crowd.hash_without_threads(c, 4));
}

TEST(job_tasks, an_error_ends_with_its_frame) {
  Crowd crowd(3);
  JobThread jobs(handed_out());
  crowd.add_to(jobs);
  const auto run = [&](std::span<const FrameInput> inputs) {
    ASSERT_TRUE(jobs.submit(inputs));
    for (const JobThread::Task& task : take_all(jobs)) task();
  };
  run(crowd.inputs(0));
  const std::uint64_t hash = hash_of(*jobs.latest(1));
  std::vector<FrameInput> bad(crowd.inputs(1).begin(), crowd.inputs(1).end());
  const ClipLayer no_clip{99, 0.0, 1.0f}, no_time{0, std::numeric_limits<double>::infinity(), 1.0f};
  bad[1].layers = {&no_clip, 1};
  bad[2].layers = {&no_time, 1};
  run(bad);
  EXPECT_EQ(jobs.last_error(), ErrorCode::index_out_of_range);
  EXPECT_EQ(jobs.latest(0)->frame, 2u);
  EXPECT_EQ(hash_of(*jobs.latest(1)), hash);
  run(crowd.inputs(2));
  EXPECT_EQ(jobs.last_error(), ErrorCode::ok);
  EXPECT_EQ(jobs.latest(1)->frame, 3u);
}

TEST(job_tasks, waiting_runs_what_is_pending) {
  Crowd crowd(3);
  JobThread jobs(handed_out());
  crowd.add_to(jobs);
  ASSERT_EQ(jobs.submit(crowd.inputs(1)), Ticket{1});
  jobs.wait(1);
  EXPECT_EQ(jobs.latest(2)->frame, 1u);
}

TEST(job_tasks, what_nobody_took_is_dropped_at_the_end) {
  Crowd crowd(3);
  JobThread jobs(handed_out());
  crowd.add_to(jobs);
  ASSERT_TRUE(jobs.submit(crowd.inputs(1)));
  (*jobs.take_task())();
  ASSERT_TRUE(jobs.submit(crowd.inputs(2)));
}

TEST(job_tasks, a_job_thread_of_its_own_hands_nothing_out) {
  Crowd crowd(2);
  JobThread jobs(spread());
  crowd.add_to(jobs);
  const Ticket ticket = *jobs.submit(crowd.inputs(1));
  EXPECT_FALSE(jobs.take_task());
  EXPECT_FALSE(jobs.poll());
  jobs.wait(ticket);
  EXPECT_EQ(hash_of(*jobs.latest(1)), crowd.hash_without_threads(1, 1));
}

TEST(job_tasks, polled_frames_allocate_nothing) {
  Crowd crowd(5);
  JobThread jobs(handed_out());
  crowd.add_to(jobs);
  const auto inputs = crowd.inputs(3);
  const AllocationCounter counter;
  ASSERT_TRUE(jobs.submit(inputs));
  EXPECT_TRUE(jobs.poll());
  EXPECT_NE(jobs.latest(4), nullptr);
  EXPECT_EQ(counter.count(), 0u) << "not in the first frame either";
}

}  // namespace
}  // namespace sinew::test
