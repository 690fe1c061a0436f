// SPDX-License-Identifier: MIT
// Characters that join, leave, change their plans and follow each other while frames run.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <memory_resource>
#include <optional>
#include <vector>

#include "runtime/math/affine.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/fixed_random.h"
#include "tests/threads/crowd.h"
#include "tests/threads/thread_executor.h"

namespace sinew::test {
namespace {

using Id = JobThread::Character;
using Changed = JobThread::CharacterInput;

JobThreadOptions polled(std::pmr::memory_resource* memory = nullptr, std::uint8_t buffers = 3) {
  JobThreadOptions options = spread();
  options.own_thread = false;
  options.frame_memory = memory;
  options.frame_buffers = buffers;
  return options;
}

class HeldBytes : public std::pmr::memory_resource {
 public:
  std::size_t bytes = 0;

 private:
  void* do_allocate(std::size_t byte_count, std::size_t alignment) override {
    bytes += byte_count;
    return std::pmr::new_delete_resource()->allocate(byte_count, alignment);
  }
  void do_deallocate(void* block, std::size_t byte_count, std::size_t alignment) override {
    bytes -= byte_count;
    std::pmr::new_delete_resource()->deallocate(block, byte_count, alignment);
  }
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }
};

/// Runs a frame with the input of one more character, or none.
void run_frame(JobThread& jobs, std::span<const Changed> changed = {}) { jobs.wait(*jobs.submit(changed)); }

TEST(changing_crowd, adding_waits_for_nobody) {
  Crowd crowd(3);
  JobThread jobs(polled());
  crowd.add_to(jobs);
  ASSERT_TRUE(jobs.submit(crowd.inputs(1)));
  const std::optional<JobThread::Task> in_flight = jobs.take_task();
  ASSERT_TRUE(in_flight);
  ASSERT_TRUE(jobs.submit(crowd.inputs(2)));
  const Id fourth = jobs.add_character(crowd.plan_of(3));
  EXPECT_FALSE(jobs.done(1));
  EXPECT_EQ(jobs.character_count(), 4u);
  EXPECT_EQ(jobs.latest(fourth), nullptr);
  (*in_flight)();
  jobs.wait(2);
  EXPECT_EQ(jobs.latest(2)->frame, 2u);
  EXPECT_EQ(jobs.latest(fourth), nullptr) << "both frames were submitted before";
  run_frame(jobs);
  EXPECT_EQ(jobs.latest(fourth), nullptr) << "it has no input";
  Crowd four(4);
  run_frame(jobs, std::vector<Changed>{{fourth, four.inputs(7)[3]}});
  EXPECT_EQ(hash_of(*jobs.latest(fourth)), four.hash_without_threads(3, 7));
}

TEST(changing_crowd, a_result_of_a_character_that_left_stays_until_the_next_submit) {
  Crowd crowd(3);
  HeldBytes memory;
  JobThread jobs(polled(&memory));
  crowd.add_to(jobs);
  jobs.wait(*jobs.submit(crowd.inputs(1)));
  const FrameResult* shown = jobs.latest(1);
  const std::uint64_t hash = hash_of(*shown);
  const std::size_t of_three = memory.bytes;
  ASSERT_TRUE(jobs.submit(crowd.inputs(2)));
  const std::optional<JobThread::Task> in_flight = jobs.take_task();
  ASSERT_TRUE(in_flight) << "the character that leaves is being run";
  EXPECT_EQ(jobs.remove_character(1), ErrorCode::ok);
  EXPECT_EQ(jobs.latest(1), nullptr);
  EXPECT_EQ(hash_of(*shown), hash);
  EXPECT_EQ(memory.bytes, of_three);
  EXPECT_EQ(jobs.remove_character(1), ErrorCode::unknown_character);
  EXPECT_EQ(jobs.replace_plan(1, crowd.plan_of(1)), ErrorCode::unknown_character);
  EXPECT_EQ(jobs.submit(std::vector<Changed>{{1, {}}}).error(), ErrorCode::unknown_character);
  EXPECT_EQ(jobs.submit(std::vector<Changed>{{77, {}}}).error(), ErrorCode::unknown_character);
  EXPECT_EQ(std::vector<Id>(jobs.characters().begin(), jobs.characters().end()), (std::vector<Id>{0, 2}));
  ASSERT_TRUE(jobs.submit(std::span<const Changed>{}));
  EXPECT_EQ(memory.bytes, of_three) << "the frame before still runs it";
  (*in_flight)();
  jobs.wait(3);
  ASSERT_TRUE(jobs.submit(std::span<const Changed>{}));
  EXPECT_LT(memory.bytes, of_three);
}

TEST(changing_crowd, memory_goes_back_when_no_frame_uses_it_and_ids_are_not_used_again) {
  Crowd crowd(2);
  HeldBytes memory;
  JobThread jobs(polled(&memory));
  crowd.add_to(jobs);
  jobs.wait(*jobs.submit(crowd.inputs(1)));
  const std::size_t of_two = memory.bytes;
  std::vector<Id> gone;
  for (int i = 0; i < 5000; ++i) {
    const Id id = jobs.add_character(crowd.plan_of(1));
    ASSERT_TRUE(gone.empty() || id != gone.back());
    gone.push_back(id);
    EXPECT_EQ(jobs.remove_character(id), ErrorCode::ok);
    if (i % 100 == 0) {
      run_frame(jobs);
      run_frame(jobs);
      EXPECT_EQ(memory.bytes, of_two) << i;
    }
  }
  std::sort(gone.begin(), gone.end());
  EXPECT_EQ(std::adjacent_find(gone.begin(), gone.end()), gone.end());
  for (const Id id : gone) EXPECT_EQ(jobs.latest(id), nullptr);
}

TEST(changing_crowd, another_plan_keeps_the_input_and_shows_the_last_result_until_its_first_frame) {
  Crowd crowd(3);
  HeldBytes memory;
  JobThread jobs(polled(&memory));
  crowd.add_to(jobs);
  jobs.wait(*jobs.submit(crowd.inputs(1)));
  const std::uint64_t before = hash_of(*jobs.latest(1));
  Needs needs = crowd.plan_of(1).needs();
  needs.skin.kind = Skinning::linear;
  needs.out.tangents = false;
  const Plan other = compile_plan(lend(crowd.plan_of(1).scene()), needs);
  FrameBuffer alone(other);
  ASSERT_EQ(run_plan(other, crowd.inputs(1)[1], alone), ErrorCode::ok);
  ASSERT_NE(hash_of(alone.result()), before);
  ASSERT_TRUE(jobs.submit(std::span<const Changed>{}));
  ASSERT_EQ(jobs.replace_plan(1, crowd.plan_of(1)), ErrorCode::ok) << "replaced once more before anybody saw it";
  ASSERT_EQ(jobs.replace_plan(1, other), ErrorCode::ok);
  EXPECT_EQ(hash_of(*jobs.latest(1)), before);
  jobs.wait(2);
  EXPECT_EQ(hash_of(*jobs.latest(1)), before);
  run_frame(jobs);
  EXPECT_EQ(hash_of(*jobs.latest(1)), hash_of(alone.result()));
  EXPECT_EQ(jobs.latest(0)->frame, 1u) << "the others did not run again";
  run_frame(jobs);
  run_frame(jobs);
  const std::size_t bytes = memory.bytes;
  ASSERT_EQ(jobs.replace_plan(1, other), ErrorCode::ok);
  run_frame(jobs);
  EXPECT_NE(jobs.latest(1), nullptr);
  run_frame(jobs);
  EXPECT_EQ(memory.bytes, bytes);
}

/// An arm whose clip turns joint 1, and a prop at its end.
struct Rider {
  Scene horse = arm_scene(), rider = arm_scene(), prop = prop_scene();
  Plan horse_plan = compile_plan(lend(horse), Needs{}), rider_plan = compile_plan(lend(rider), Needs{}),
       prop_plan = compile_plan(lend(prop), Needs{});
  ClipLayer layer{0, 0.0};

  FrameInput posed(double time_s) {
    layer.time_s = time_s;
    return {.layers = {&layer, 1}, .weights = {}, .root = {}};
  }
  static Affine joint_of(const Plan& plan, const FrameInput& input, std::size_t joint) {
    FrameBuffer frame(plan);
    EXPECT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
    return frame.result().model[joint];
  }
};

TEST(changing_crowd, a_prop_follows_a_joint_of_a_rider_on_a_horse_in_the_same_frame) {
  for (const bool own_thread : {true, false}) {
    Rider r;
    JobThreadOptions options = spread();
    options.own_thread = own_thread;
    JobThread jobs(options);
    const Id prop = jobs.add_character(r.prop_plan), rider = jobs.add_character(r.rider_plan),
             horse = jobs.add_character(r.horse_plan);
    ASSERT_EQ(jobs.follow(prop, rider, 2), ErrorCode::ok);
    ASSERT_EQ(jobs.follow(rider, horse, 2), ErrorCode::ok);
    FrameInput held;
    held.root.row[0].w = 0.5f;
    FrameInput alone = held;
    for (int i = 1; i <= 8; ++i) {
      FrameInput walk = r.posed(0.1 * i);
      walk.root.row[2].w = static_cast<float>(i);
      const Affine saddle = Rider::joint_of(r.horse_plan, walk, 2);
      FrameInput sits = r.posed(0.1 * i);
      sits.root = saddle * sits.root;
      alone.root = Rider::joint_of(r.rider_plan, sits, 2) * held.root;
      const std::vector<Changed> inputs{{prop, held}, {rider, r.posed(0.1 * i)}, {horse, walk}};
      run_frame(jobs, inputs);
      ASSERT_EQ(jobs.last_error(), ErrorCode::ok);
      FrameBuffer expected(r.prop_plan);
      ASSERT_EQ(run_plan(r.prop_plan, alone, expected), ErrorCode::ok);
      EXPECT_EQ(hash_of(*jobs.latest(prop)), hash_of(expected.result())) << i;
    }
    run_frame(jobs);
    EXPECT_EQ(jobs.latest(prop)->frame, 8u) << "nobody moved";
    ASSERT_EQ(jobs.remove_character(rider), ErrorCode::ok);
    run_frame(jobs);
    EXPECT_EQ(jobs.latest(prop)->model[0], held.root) << "it follows nobody";
    ASSERT_EQ(jobs.follow(prop, horse, 0), ErrorCode::ok);
    run_frame(jobs);
    EXPECT_NE(jobs.latest(prop)->model[0], held.root);
    ASSERT_EQ(jobs.stop_following(prop), ErrorCode::ok);
    run_frame(jobs);
    EXPECT_EQ(jobs.latest(prop)->model[0], held.root);
  }
}

TEST(changing_crowd, nobody_follows_itself_nor_a_joint_that_is_not_shown) {
  Rider r;
  JobThread jobs(polled());
  const Id a = jobs.add_character(r.horse_plan), b = jobs.add_character(r.rider_plan),
           c = jobs.add_character(r.prop_plan);
  EXPECT_EQ(jobs.follow(a, a, 0), ErrorCode::follows_itself);
  EXPECT_EQ(jobs.follow(b, a, 2), ErrorCode::ok);
  EXPECT_EQ(jobs.follow(c, b, 2), ErrorCode::ok);
  EXPECT_EQ(jobs.follow(a, c, 0), ErrorCode::follows_itself);
  EXPECT_EQ(jobs.follow(a, c, 9), ErrorCode::index_out_of_range);
  EXPECT_EQ(jobs.follow(a, 99, 0), ErrorCode::unknown_character);
  EXPECT_EQ(jobs.follow(99, a, 0), ErrorCode::unknown_character);
  EXPECT_EQ(jobs.stop_following(99), ErrorCode::unknown_character);
  EXPECT_EQ(jobs.replace_plan(a, r.prop_plan), ErrorCode::index_out_of_range) << "b needs joint 2";
  Needs no_joints;
  no_joints.out.joints = false;
  const Plan hidden = compile_plan(lend(r.horse), no_joints);
  EXPECT_EQ(jobs.replace_plan(a, hidden), ErrorCode::not_in_needs);
  const Id d = jobs.add_character(hidden);
  EXPECT_EQ(jobs.follow(a, d, 0), ErrorCode::not_in_needs);
  EXPECT_EQ(jobs.stop_following(b), ErrorCode::ok);
  EXPECT_EQ(jobs.follow(a, c, 0), ErrorCode::ok) << "b does not follow a any more";
}

TEST(changing_crowd, followers_wait_for_a_leader_without_input_and_stay_while_it_sleeps) {
  Rider r;
  JobThread jobs(polled());
  const Id horse = jobs.add_character(r.horse_plan), prop = jobs.add_character(r.prop_plan);
  ASSERT_EQ(jobs.follow(prop, horse, 2), ErrorCode::ok);
  run_frame(jobs, std::vector<Changed>{{prop, {}}});
  EXPECT_EQ(jobs.latest(prop), nullptr);
  run_frame(jobs, std::vector<Changed>{{horse, r.posed(0.5)}});
  ASSERT_NE(jobs.latest(prop), nullptr);
  const Affine at = jobs.latest(prop)->model[0];
  FrameInput asleep = r.posed(0.9);
  asleep.asleep = true;
  run_frame(jobs, std::vector<Changed>{{horse, asleep}});
  EXPECT_EQ(jobs.latest(prop)->model[0], at);
  run_frame(jobs, std::vector<Changed>{{horse, r.posed(0.9)}});
  EXPECT_NE(jobs.latest(prop)->model[0], at);
}

TEST(changing_crowd, the_last_of_two_inputs_of_a_character_counts) {
  Crowd crowd(1), other(1);
  JobThread jobs(polled());
  crowd.add_to(jobs);
  ASSERT_TRUE(jobs.submit(crowd.inputs(1)));
  const std::optional<JobThread::Task> in_flight = jobs.take_task();
  ASSERT_TRUE(jobs.submit(std::vector<Changed>{{0, crowd.inputs(2)[0]}, {0, other.inputs(3)[0]}}));
  EXPECT_EQ(jobs.submit(std::vector<Changed>{{0, crowd.inputs(4)[0]}}).error(), ErrorCode::busy);
  (*in_flight)();
  EXPECT_EQ(hash_of(*jobs.latest(0)), crowd.hash_without_threads(0, 1)) << "inputs of frames in flight stay";
  jobs.wait(2);
  EXPECT_EQ(hash_of(*jobs.latest(0)), other.hash_without_threads(0, 3));
}

/// Everything that can be done to a crowd, at random. All results are those of a fresh buffer that saw the same input.
void drive(std::uint64_t seed, JobThreadOptions options) {
  Crowd crowd(6);
  JobThread jobs(std::move(options));
  FixedRandom random(seed);
  struct Model {
    const Plan* plan;
    std::optional<std::size_t> frame, place;  // of crowd.inputs
    std::optional<Id> leader;
  };
  std::map<Id, Model> model;
  const auto any = [&] {
    return std::next(model.begin(), random.below(static_cast<std::uint32_t>(model.size())))->first;
  };
  std::map<Id, Affine> root_of;
  for (std::size_t frame = 1; frame < 120; ++frame) {
    for (int change = 0; change < 2; ++change) {
      const std::uint32_t what = random.below(6);
      if (what == 0 || model.empty()) {
        const std::size_t place = random.below(6);
        model[jobs.add_character(crowd.plan_of(place))] = {.plan = &crowd.plan_of(place), .place = place};
      } else if (what == 1 && model.size() > 2) {
        const Id gone = any();
        ASSERT_EQ(jobs.remove_character(gone), ErrorCode::ok);
        model.erase(gone);
        for (auto& [id, one] : model)
          if (one.leader == gone) one.leader.reset();
      } else if (what == 2) {
        const Id id = any();
        Model& one = model[id];
        // The scenes differ, so inputs of one may not fit another: only the same plan anew.
        ASSERT_EQ(jobs.replace_plan(id, *one.plan), ErrorCode::ok);
      } else if (what == 3) {
        const Id follower = any(), leader = any();
        if (jobs.follow(follower, leader, 1) == ErrorCode::ok) model[follower].leader = leader;
      } else if (what == 4) {
        const Id id = any();
        ASSERT_EQ(jobs.stop_following(id), ErrorCode::ok);
        model[id].leader.reset();
      }
    }
    const std::span<const FrameInput> inputs = crowd.inputs(frame);
    std::vector<Changed> changed;
    for (auto& [id, one] : model)
      if (random.below(2) == 0) {
        changed.push_back({id, inputs[*one.place]});
        one.frame = frame;
      }
    const Result<Ticket> ticket = jobs.submit(changed);
    ASSERT_TRUE(ticket) << describe(ticket.error());
    jobs.wait(*ticket);
    ASSERT_EQ(jobs.last_error(), ErrorCode::ok);
    // Leaders first: a character is ready when its leader is.
    std::map<Id, std::optional<Affine>> joint;
    while (joint.size() < model.size())
      for (const auto& [id, one] : model) {
        if (joint.count(id) > 0 || (one.leader && joint.count(*one.leader) == 0)) continue;
        if (!one.frame || (one.leader && !joint[*one.leader])) {
          joint[id].reset();
          ASSERT_TRUE(one.leader || jobs.latest(id) == nullptr);
          continue;
        }
        FrameInput input = crowd.inputs(*one.frame)[*one.place];
        if (one.leader) input.root = *joint[*one.leader] * input.root;
        FrameBuffer fresh(*one.plan);
        ASSERT_EQ(run_plan(*one.plan, input, fresh), ErrorCode::ok);
        ASSERT_NE(jobs.latest(id), nullptr);
        ASSERT_EQ(hash_of(*jobs.latest(id)), hash_of(fresh.result())) << "seed " << seed << " frame " << frame;
        joint[id] = fresh.result().model[1];
      }
  }
}

TEST(changing_crowd, all_changes_at_random_give_the_bits_of_frames_without_threads) {
  ThreadPool pool(3);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    drive(seed, spread(pool.executor()));
    drive(seed, polled());
    drive(seed, polled(nullptr, 2));
    drive(seed, {});
  }
}

TEST(changing_crowd, frames_after_a_change_allocate_nothing) {
  Crowd crowd(8);
  JobThread jobs(polled());
  crowd.add_to(jobs);
  jobs.wait(*jobs.submit(crowd.inputs(0)));
  std::vector<Changed> changed;
  for (std::uint64_t frame = 1; frame < 12; ++frame) {
    const std::span<const FrameInput> inputs = crowd.inputs(frame);
    changed.clear();
    for (const Id id : jobs.characters()) changed.push_back({id, inputs[id % 8]});
    const AllocationCounter allocations;
    jobs.wait(*jobs.submit(changed));
    for (const Id id : jobs.characters()) (void)jobs.latest(id);
    EXPECT_EQ(allocations.count(), 0u) << frame;
    if (frame % 3 == 0) {
      EXPECT_EQ(jobs.remove_character(jobs.characters()[2]), ErrorCode::ok);
    }
    if (frame % 4 == 0) {
      EXPECT_EQ(jobs.follow(jobs.characters()[0], jobs.characters()[1], 0), ErrorCode::ok);
    }
    if (frame % 5 == 0) {
      EXPECT_EQ(jobs.replace_plan(jobs.characters()[1], crowd.plan_of(1)), ErrorCode::ok);
    }
  }
}

}  // namespace
}  // namespace sinew::test
