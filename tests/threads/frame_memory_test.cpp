// SPDX-License-Identifier: MIT
// The memory that a job thread takes for its characters. Running frames allocates nothing.
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <memory_resource>

#include "tests/scenes/hand_scenes.h"
#include "tests/support/allocation_counter.h"
#include "tests/threads/crowd.h"
#include "tests/threads/thread_executor.h"

namespace sinew::test {
namespace {

class CountedMemory : public std::pmr::memory_resource {
 public:
  std::size_t bytes = 0, calls = 0;

 private:
  void* do_allocate(std::size_t byte_count, std::size_t alignment) override {
    bytes += byte_count;
    ++calls;
    return std::pmr::new_delete_resource()->allocate(byte_count, alignment);
  }
  void do_deallocate(void* block, std::size_t byte_count, std::size_t alignment) override {
    bytes -= byte_count;
    std::pmr::new_delete_resource()->deallocate(block, byte_count, alignment);
  }
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }
};

JobThreadOptions with_buffers(std::uint8_t count, bool own_thread, std::pmr::memory_resource* memory = nullptr) {
  JobThreadOptions options = spread();
  options.frame_buffers = count;
  options.own_thread = own_thread;
  options.frame_memory = memory;
  return options;
}

TEST(frame_memory, two_frame_buffers_take_two_thirds) {
  Crowd crowd(4);
  std::size_t frame_bytes = 0;
  for (std::size_t c = 0; c < 4; ++c) frame_bytes += crowd.plan_of(c).frame_bytes();
  std::size_t bytes[4] = {};
  for (const std::uint8_t buffers : {std::uint8_t{2}, std::uint8_t{3}}) {
    CountedMemory memory;
    {
      JobThread jobs(with_buffers(buffers, true, &memory));
      crowd.add_to(jobs);
      bytes[buffers] = memory.bytes;
      EXPECT_GE(memory.bytes, buffers * frame_bytes);
    }
    EXPECT_EQ(memory.bytes, 0u);
  }
  EXPECT_EQ(bytes[3] - bytes[2], frame_bytes);
}

TEST(frame_memory, two_frame_buffers_give_the_same_bits) {
  Crowd crowd(5);
  for (const bool own_thread : {true, false}) {
    JobThread jobs(with_buffers(2, own_thread));
    crowd.add_to(jobs);
    for (Ticket frame = 1; frame <= 30; ++frame) {
      ASSERT_EQ(jobs.submit(crowd.inputs(frame)), frame);
      jobs.wait(frame);
      for (std::uint32_t c = 0; c < 5; ++c) {
        ASSERT_EQ(jobs.latest(c)->frame, frame);
        ASSERT_EQ(hash_of(*jobs.latest(c)), crowd.hash_without_threads(c, frame));
      }
    }
  }
}

TEST(frame_memory, with_two_frame_buffers_submit_is_busy_until_every_result_is_taken) {
  Crowd crowd(2);
  JobThread jobs(with_buffers(2, false));
  crowd.add_to(jobs);
  ASSERT_TRUE(jobs.submit(crowd.inputs(1)));
  EXPECT_EQ(jobs.submit(crowd.inputs(2)).error(), ErrorCode::busy) << "the frame before waits";
  const auto task = jobs.take_task();
  EXPECT_EQ(jobs.submit(crowd.inputs(2)).error(), ErrorCode::busy) << "the frame before runs";
  (*task)();
  jobs.wait(1);
  const FrameResult* shown[] = {jobs.latest(0), jobs.latest(1)};
  const std::uint64_t hash[] = {hash_of(*shown[0]), hash_of(*shown[1])};

  ASSERT_TRUE(jobs.submit(crowd.inputs(2))) << "into the other buffers";
  jobs.wait(2);
  for (int c = 0; c < 2; ++c) EXPECT_EQ(hash_of(*shown[c]), hash[c]) << "what is read stays";
  EXPECT_EQ(jobs.submit(crowd.inputs(3)).error(), ErrorCode::busy) << "both buffers of both characters are in use";
  EXPECT_EQ(jobs.latest(0)->frame, 2u);
  EXPECT_EQ(jobs.submit(crowd.inputs(3)).error(), ErrorCode::busy) << "character 1 is still read";
  EXPECT_EQ(hash_of(*shown[1]), hash[1]);
  EXPECT_EQ(jobs.latest(1)->frame, 2u);
  ASSERT_TRUE(jobs.submit(crowd.inputs(3)));
  jobs.wait(3);
  EXPECT_EQ(hash_of(*jobs.latest(0)), crowd.hash_without_threads(0, 3));
}

TEST(frame_memory, with_two_frame_buffers_a_crowd_that_nobody_looks_at_goes_on) {
  Crowd crowd(2);
  JobThread jobs(with_buffers(2, false));
  crowd.add_to(jobs);
  for (Ticket frame = 1; frame <= 5; ++frame) {
    ASSERT_TRUE(jobs.submit(crowd.inputs(frame)));
    jobs.wait(frame);
  }
  EXPECT_EQ(jobs.latest(1)->frame, 5u);
  EXPECT_EQ(hash_of(*jobs.latest(1)), crowd.hash_without_threads(1, 5));
}

TEST(frame_memory, no_frame_asks_for_memory_whatever_layers_its_plan_declares) {
  const Scene scene = random_scene(5);
  Needs needs;
  needs.in.additive = true;
  needs.in.max_layers = 2;
  needs.in.max_additive_layers = 5;
  const Plan plan = compile_plan(lend(scene), needs);
  CountedMemory memory;
  JobThread jobs(with_buffers(3, false, &memory));
  jobs.add_character(plan);
  std::vector<ClipLayer> layers{{0, 0.1, 0.6f}, {1, 0.2, 0.4f}};
  layers.resize(needs.in.layer_room(), {1, 0.3, 0.1f, kNone, LayerKind::add_to_start});
  const std::vector<float> weights(scene.weight_count(), 0.5f);
  const std::vector<std::uint8_t> out_of_view(scene.instances.size(), 0);
  FrameInput input;
  input.layers = layers;
  input.weights = weights;
  input.out_of_view = out_of_view;
  const std::size_t calls = memory.calls;
  const AllocationCounter counter;
  ASSERT_TRUE(jobs.submit({&input, 1}));
  EXPECT_TRUE(jobs.poll());
  EXPECT_EQ(jobs.last_error(), ErrorCode::ok);
  EXPECT_EQ(memory.calls, calls);
  EXPECT_EQ(counter.count(), 0u);

  layers.push_back(layers.back());
  input.layers = layers;
  EXPECT_EQ(jobs.submit({&input, 1}).error(), ErrorCode::too_many_layers) << "more layers than declared";
  EXPECT_EQ(memory.calls, calls);
  EXPECT_EQ(jobs.last_submitted(), 1u);
}

TEST(frame_memory, an_engine_with_an_executor_of_its_own_never_enters_onetbb) {
  const auto is_in_onetbb = [] {
    return tbb::this_task_arena::current_thread_index() != tbb::task_arena::not_initialized;
  };
  std::atomic<int> inside{0};
  std::thread([&] {
    tbb::parallel_for(0, 1, [](int) {});
    inside += is_in_onetbb();
  }).join();
  ASSERT_EQ(inside, 1) << "threads that entered oneTBB are told";
  inside = 0;
  Crowd crowd(6);
  JobThread jobs(spread([&](std::size_t count, const std::function<void(std::size_t)>& body) {
    inside += is_in_onetbb();
    while (count-- > 0) body(count);
    inside += is_in_onetbb();
  }));
  crowd.add_to(jobs);
  for (Ticket frame = 1; frame <= 3; ++frame) jobs.wait(*jobs.submit(crowd.inputs(frame)));
  EXPECT_EQ(inside, 0);
}

}  // namespace
}  // namespace sinew::test
