// SPDX-License-Identifier: MIT
#include "runtime/threads/job_thread.h"

#include <gtest/gtest.h>
#if __has_include(<tbb/global_control.h>)
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "runtime/lod/update_rate.h"
#include "tests/plan/frame_hash.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/allocation_counter.h"
#include "tests/threads/crowd.h"
#include "tests/threads/thread_executor.h"

namespace sinew::test {
namespace {

TEST(job_thread, shows_nothing_before_the_first_frame_and_then_the_newest) {
  Crowd crowd(1);
  JobThread jobs;
  crowd.add_to(jobs);
  EXPECT_EQ(jobs.latest(0), nullptr);
  EXPECT_TRUE(jobs.done(0));
  for (Ticket expected = 1; expected <= 20; ++expected) {
    const auto ticket = jobs.submit(crowd.inputs(expected));
    ASSERT_EQ(ticket, expected);
    jobs.wait(*ticket);
    EXPECT_TRUE(jobs.done(*ticket));
    EXPECT_FALSE(jobs.done(*ticket + 1));
    ASSERT_NE(jobs.latest(0), nullptr);
    EXPECT_EQ(jobs.latest(0)->frame, expected);
    EXPECT_EQ(hash_of(*jobs.latest(0)), crowd.hash_without_threads(0, expected));
  }
}

TEST(job_thread, gives_the_same_bits_for_every_executor_and_thread_count) {
  constexpr std::size_t kCharacters = 17;
  Crowd crowd(kCharacters);
  std::vector<std::uint64_t> expected;
  for (std::size_t c = 0; c < kCharacters; ++c) expected.push_back(crowd.hash_without_threads(c, 3));
  const auto check = [&](JobThreadOptions options, const std::string& name) {
    JobThread jobs(std::move(options));
    crowd.add_to(jobs);
    for (std::uint64_t frame = 0; frame <= 3; ++frame) jobs.wait(*jobs.submit(crowd.inputs(frame)));
    for (std::uint32_t c = 0; c < kCharacters; ++c)
      EXPECT_EQ(hash_of(*jobs.latest(c)), expected[c]) << name << ", character " << c;
  };
  check(spread(), "the default");
#if __has_include(<tbb/global_control.h>)
  {
    const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 16);  // maybe more than exist
    check(spread(), "oneTBB, 16 threads");
  }
#endif
  check({}, "inline");
  for (const std::size_t threads : {1, 2, 3, 4, 8, 16}) {
    ThreadPool pool(threads);
    check(spread(pool.executor()), std::to_string(threads) + " threads");
    check({.executor = pool.executor(), .inline_below_bytes = 0, .part_bytes = 2 * crowd.plan_of(0).frame_bytes()},
          std::to_string(threads) + " threads, in parts");
  }
  check(spread([](std::size_t count, const auto& body) {
          while (count-- > 0) body(count);
        }),
        "backwards");
}

TEST(job_thread, P16_a_crowd_of_little_memory_runs_without_the_executor) {
  std::atomic<int> calls{0};
  const Executor counting = [&](std::size_t count, const auto& body) {
    ++calls;
    for (std::size_t i = 0; i < count; ++i) body(i);
  };
  Crowd crowd(4);
  std::size_t bytes = 0;
  for (std::size_t c = 0; c < 4; ++c) bytes += crowd.plan_of(c).frame_bytes();
  for (const std::size_t below : {bytes + 1, bytes}) {
    JobThread jobs({.executor = counting, .inline_below_bytes = below, .part_bytes = 1});
    crowd.add_to(jobs);
    jobs.wait(*jobs.submit(crowd.inputs(0)));
    EXPECT_EQ(calls, below > bytes ? 0 : 1);
  }
}

TEST(job_thread, P16_the_executor_is_handed_small_characters_together_and_large_ones_alone) {
  std::size_t parts = 0;
  const Executor counting = [&](std::size_t count, const auto& body) {
    parts = count;
    for (std::size_t i = 0; i < count; ++i) body(i);
  };
  constexpr std::size_t kCharacters = 9;
  Crowd crowd(kCharacters);
  std::size_t largest = 0, smallest = ~std::size_t{0};
  for (std::size_t c = 0; c < 3; ++c) {
    largest = std::max(largest, crowd.plan_of(c).frame_bytes());
    smallest = std::min(smallest, crowd.plan_of(c).frame_bytes());
  }
  const auto parts_of = [&](std::size_t part_bytes) {
    JobThread jobs({.executor = counting, .inline_below_bytes = 0, .part_bytes = part_bytes});
    crowd.add_to(jobs);
    parts = 0;
    jobs.wait(*jobs.submit(crowd.inputs(0)));
    for (std::uint32_t c = 0; c < kCharacters; ++c) EXPECT_EQ(jobs.latest(c)->frame, 1u);
    return parts;
  };
  EXPECT_EQ(parts_of(smallest), kCharacters);
  EXPECT_GE(parts_of(largest + 1), 2u);
  EXPECT_LE(parts_of(largest + 1), (kCharacters + 1) / 2) << "two at least in each part but the last";
  EXPECT_EQ(parts_of(std::size_t{1} << 40), 0u) << "one part needs no executor";
}

TEST(job_thread, a_result_stays_unchanged_until_the_reader_asks_again) {
  Crowd crowd(2);
  JobThread jobs(spread());
  crowd.add_to(jobs);
  jobs.wait(*jobs.submit(crowd.inputs(0)));
  const FrameResult* shown = jobs.latest(1);
  const std::uint64_t hash = hash_of(*shown);
  for (std::uint64_t frame = 1; frame < 30; ++frame) {  // the worker overtakes the reader many times
    jobs.wait(*jobs.submit(crowd.inputs(frame)));
    EXPECT_EQ(hash_of(*shown), hash);
    EXPECT_EQ(shown->frame, 1u);
  }
  EXPECT_EQ(jobs.latest(1)->frame, 30u);
}

TEST(job_thread, a_fast_reader_sees_whole_frames_that_never_go_back) {
  Crowd crowd(3);
  JobThread jobs(spread());
  crowd.add_to(jobs);
  constexpr Ticket kFrames = 25;
  std::vector<std::uint64_t> expected[3];
  for (std::size_t c = 0; c < 3; ++c)
    for (Ticket n = 0; n <= kFrames; ++n) expected[c].push_back(crowd.hash_without_threads(c, n));
  Ticket last = *jobs.submit(crowd.inputs(1));
  std::uint64_t newest[3] = {}, looks = 0;
  while (newest[2] < kFrames) {
    if (jobs.done(last) && last < kFrames) last = *jobs.submit(crowd.inputs(last + 1));
    for (std::uint32_t c = 0; c < 3; ++c, ++looks) {
      const FrameResult* shown = jobs.latest(c);
      if (!shown) continue;
      ASSERT_GE(shown->frame, newest[c]);
      newest[c] = shown->frame;
      ASSERT_EQ(hash_of(*shown), expected[c][shown->frame]);
    }
  }
  EXPECT_GE(looks, 25u);
}

TEST(job_thread, takes_one_frame_in_advance_and_is_busy_then) {
  Crowd crowd(2);
  std::mutex gate;
  JobThread jobs(spread([&](std::size_t count, const auto& body) {
    const std::lock_guard lock(gate);
    for (std::size_t i = 0; i < count; ++i) body(i);
  }));
  crowd.add_to(jobs);
  Ticket last = 0;
  {
    const std::lock_guard lock(gate);
    ASSERT_EQ(jobs.submit(crowd.inputs(0)), Ticket{1});
    for (;;) {  // until the worker runs frame 1 and frame 2 waits
      const auto next = jobs.submit(crowd.inputs(1));
      if (!next) {
        EXPECT_EQ(next.error(), ErrorCode::busy);
        if (last != 0) break;
        std::this_thread::yield();
        continue;
      }
      last = *next;
    }
    EXPECT_EQ(last, 2u);
    EXPECT_FALSE(jobs.done(1));
  }
  jobs.wait(last);
  EXPECT_EQ(jobs.latest(0)->frame, 2u);
}

TEST(job_thread, P19_a_paused_crowd_is_not_run_again) {
  Crowd crowd(6);
  JobThread jobs(spread());
  crowd.add_to(jobs);
  const auto inputs = crowd.inputs(5);
  jobs.wait(*jobs.submit(inputs));
  std::vector<const FrameResult*> first;
  std::vector<std::uint64_t> first_hash;
  for (std::uint32_t c = 0; c < inputs.size(); ++c) {
    first.push_back(jobs.latest(c));
    first_hash.push_back(hash_of(*first[c]));
  }
  for (Ticket expected = 2; expected <= 8; ++expected) {
    jobs.wait(*jobs.submit(inputs));
    for (std::uint32_t c = 0; c < inputs.size(); ++c) {
      EXPECT_EQ(jobs.latest(c), first[c]) << "nothing was written";
      EXPECT_EQ(first[c]->frame, 1u);
      EXPECT_EQ(hash_of(*first[c]), first_hash[c]);
    }
  }
  jobs.wait(*jobs.submit(crowd.inputs(6)));
  for (std::uint32_t c = 0; c < inputs.size(); ++c) EXPECT_EQ(jobs.latest(c)->frame, 9u);
}

TEST(job_thread, P19_of_a_crowd_that_is_held_only_those_whose_turn_it_is_are_run) {
  constexpr std::uint32_t kCount = 8;
  const Scene scene = arm_scene();
  const Plan plan = compile_plan(lend(scene), {});
  JobThread jobs(spread());
  std::vector<HeldInput> held;
  for (std::uint32_t c = 0; c < kCount; ++c) {
    jobs.add_character(plan);
    held.emplace_back(plan);
  }
  for (std::uint64_t number = 0; number < 24; ++number) {
    const ClipLayer layer{0, 0.01 * static_cast<double>(number)};
    FrameInput now;
    now.layers = {&layer, 1};
    std::vector<FrameInput> inputs;
    for (std::uint32_t c = 0; c < kCount; ++c)
      inputs.push_back(held[c].next(now, UpdateLevel::every_fourth, number, c));
    jobs.wait(*jobs.submit(inputs));
    int ran = 0;
    for (std::uint32_t c = 0; c < kCount; ++c) ran += jobs.latest(c)->frame == number + 1;
    EXPECT_EQ(ran, number == 0 ? 8 : 2) << number;
  }
}

TEST(job_thread, keeps_alive_the_scenes_of_its_characters) {
  JobThread jobs(spread());
  std::weak_ptr<const Scene> watched;
  {
    const std::shared_ptr<const Scene> scene = share(random_scene(0));
    watched = scene;
    jobs.add_character(compile_plan(scene, {}));
  }
  EXPECT_FALSE(watched.expired());
  const ClipLayer layer{0, 0.5};
  const FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = {}};
  const auto ticket = jobs.submit({&input, 1});
  ASSERT_TRUE(ticket);
  jobs.wait(*ticket);
  EXPECT_EQ(jobs.last_error(), ErrorCode::ok);
  EXPECT_NE(jobs.latest(0), nullptr);
}

TEST(job_thread, characters_have_two_or_three_frame_buffers) {
  for (std::uint8_t count = 0; count < 5; ++count) {
    const bool is_usable = count == 2 || count == 3;
    EXPECT_EQ(check(JobThreadOptions{.own_thread = false, .frame_buffers = count}),
              is_usable ? ErrorCode::ok : ErrorCode::unsupported);
  }
  EXPECT_DEATH(JobThread({.own_thread = false, .frame_buffers = 1}), "contract broken: .*2 or 3 frame buffers");
}

TEST(job_thread, characters_that_were_not_added_and_default_plans_break_a_contract) {
  JobThreadOptions options;
  options.own_thread = false;
  JobThread jobs(options);
  EXPECT_DEATH(jobs.latest(0), "contract broken: .*a character that add_character");
  EXPECT_DEATH(jobs.add_character(Plan{}), "contract broken: .*a character needs a plan");
  EXPECT_EQ(jobs.add_character(compile_plan(random_scene(0), {})), 0u);
  EXPECT_EQ(jobs.latest(0), nullptr);
  EXPECT_DEATH(jobs.latest(1), "contract broken: .*a character that add_character");
}

TEST(job_thread, rejects_another_number_of_inputs) {
  Crowd crowd(2);
  JobThread jobs(spread());
  crowd.add_to(jobs);
  EXPECT_EQ(jobs.character_count(), 2u);
  EXPECT_EQ(jobs.submit(crowd.inputs(0).first(1)).error(), ErrorCode::size_mismatch);
}

TEST(job_thread, each_character_has_room_for_what_its_own_plan_declares) {
  const Scene scene = random_scene(0);
  const Plan one = compile_plan(lend(scene), {.in = {.max_layers = 1}}),
             two = compile_plan(lend(scene), {.in = {.max_layers = 2}});
  const ClipLayer layers[] = {{0, 0.5, 0.5f}, {0, 0.75, 0.5f}};
  const FrameInput single{.layers = std::span(layers, 1), .weights = {}, .root = {}},
      both{.layers = layers, .weights = {}, .root = {}};
  for (const bool wide_first : {false, true}) {
    JobThread jobs(spread());
    jobs.add_character(wide_first ? two : one);
    jobs.add_character(wide_first ? one : two);
    const FrameInput right[] = {wide_first ? both : single, wide_first ? single : both}, wrong[] = {right[1], right[0]};
    EXPECT_EQ(jobs.submit(wrong).error(), ErrorCode::too_many_layers);
    EXPECT_TRUE(jobs.submit(right));
  }
}

TEST(job_thread, an_error_is_told_and_the_character_keeps_its_last_good_frame) {
  Crowd crowd(3);
  JobThread jobs(spread());
  crowd.add_to(jobs);
  jobs.wait(*jobs.submit(crowd.inputs(0)));
  EXPECT_EQ(jobs.last_error(), ErrorCode::ok);
  const std::uint64_t hash = hash_of(*jobs.latest(1));

  std::vector<FrameInput> bad(crowd.inputs(1).begin(), crowd.inputs(1).end());
  const ClipLayer no_clip{99, 0.0, 1.0f}, no_time{0, std::numeric_limits<double>::infinity(), 1.0f};
  bad[1].layers = {&no_clip, 1};
  bad[2].layers = {&no_time, 1};
  jobs.wait(*jobs.submit(bad));
  EXPECT_EQ(jobs.last_error(), ErrorCode::index_out_of_range);  // the error of the first character that failed
  EXPECT_EQ(jobs.latest(0)->frame, 2u);
  EXPECT_EQ(jobs.latest(1)->frame, 1u);
  EXPECT_EQ(hash_of(*jobs.latest(1)), hash);

  jobs.wait(*jobs.submit(crowd.inputs(0)));  // characters 1 and 2 have this frame already
  EXPECT_EQ(jobs.last_error(), ErrorCode::ok);
  EXPECT_EQ(jobs.latest(1)->frame, 1u);

  jobs.wait(*jobs.submit(crowd.inputs(2)));
  EXPECT_EQ(jobs.last_error(), ErrorCode::ok);
  EXPECT_EQ(jobs.latest(1)->frame, 4u);
}

TEST(job_thread, P19_shapes_that_rest_while_their_character_walks_hold_since_the_first_frame) {
  const Scene face = face_scene();
  const Plan plan = compile_plan(lend(face), {});
  JobThread jobs;
  jobs.add_character(plan);
  std::size_t deformed = 0;
  for (Ticket frame = 1; frame <= 7; ++frame) {
    FrameInput input;
    input.root.row[0].w = static_cast<float>(frame);
    jobs.wait(*jobs.submit({&input, 1}));
    const FrameResult& shown = *jobs.latest(0);
    EXPECT_EQ(shown.frame, frame);
    EXPECT_EQ(shown.instances[0].world_from_mesh.row[0].w, static_cast<float>(frame));
    for (std::size_t p = 0; p < shown.primitives.size(); ++p) {
      if (!plan.primitives()[p].deformed()) continue;
      ++deformed;
      EXPECT_EQ(shown.primitives[p].since_frame, 1u) << "primitive " << p << ", frame " << frame;
    }
  }
  EXPECT_GT(deformed, 0u);
}

TEST(job_thread, characters_can_join_while_frames_are_in_flight) {
  Crowd crowd(6);
  JobThread jobs(spread());
  for (std::uint32_t c = 0; c < 6; ++c) {
    EXPECT_EQ(jobs.add_character(crowd.plan_of(c)), c);
    const std::span<const FrameInput> inputs = crowd.inputs(c).first(c + 1);
    while (jobs.submit(inputs) == tl::unexpected(ErrorCode::busy)) std::this_thread::yield();
  }
  jobs.wait(6);
  for (std::uint32_t c = 0; c < 6; ++c) EXPECT_EQ(hash_of(*jobs.latest(c)), crowd.hash_without_threads(c, 5));
}

TEST(job_thread, can_be_destroyed_with_frames_in_flight_and_queued) {
  for (int round = 0; round < 40; ++round) {
    Crowd crowd(4);
    JobThread jobs(spread());
    crowd.add_to(jobs);
    for (int frame = 0; frame < round % 4; ++frame) (void)jobs.submit(crowd.inputs(0));
  }
}

TEST(job_thread, a_frame_after_warm_up_allocates_nothing_on_any_thread) {
  Crowd crowd(8);
  ThreadPool pool(3);
  JobThread jobs(spread(pool.executor()));
  crowd.add_to(jobs);
  jobs.wait(*jobs.submit(crowd.inputs(0)));
  const std::size_t before = allocation_count_of_all_threads();
  for (std::uint64_t frame = 1; frame < 20; ++frame) {
    jobs.wait(*jobs.submit(crowd.inputs(frame)));
    for (std::uint32_t c = 0; c < 8; ++c) (void)jobs.latest(c);
  }
  EXPECT_EQ(allocation_count_of_all_threads(), before);
}

// For the thread sanitizer: mixes submit, read and wait in every way, with both kinds of threads.
TEST(job_thread, holds_under_load) {
  for (const bool tbb : {true, false}) {
    Crowd crowd(12);
    ThreadPool pool(4);
    JobThread jobs(spread(tbb ? Executor{} : pool.executor()));
    crowd.add_to(jobs);
    std::uint64_t seen = 0;
    Ticket last = 0;
    for (int round = 0; round < 400; ++round) {
      if (const auto ticket = jobs.submit(crowd.inputs(static_cast<std::uint64_t>(round)))) last = *ticket;
      if (round % 7 == 0 && last > 0) jobs.wait(last);
      if (const FrameResult* shown = jobs.latest(static_cast<std::uint32_t>(round) % 12)) seen += hash_of(*shown) != 0;
      if (round % 5 == 0) std::this_thread::yield();
    }
    jobs.wait(last);
    EXPECT_GT(seen, 0u);
    EXPECT_EQ(jobs.last_error(), ErrorCode::ok);
    EXPECT_EQ(jobs.latest(11)->frame, last);
  }
}

}  // namespace
}  // namespace sinew::test
