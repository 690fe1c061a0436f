// SPDX-License-Identifier: MIT
// Characters of a job thread, driven by any inputs, show the same as a fresh buffer that saw only the last input.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <deque>
#include <map>
#include <vector>

#include "runtime/threads/job_thread.h"
#include "tests/plan/frame_equality.h"
#include "tests/plan/reference_held_input.h"
#include "tests/threads/crowd.h"

namespace sinew::test {
namespace {

constexpr std::size_t kCharacters = 3;

/// One character with its own plan; its inputs are held between updates.
struct Driven {
  Plan plan;
  RandomInputs inputs{plan};
  HeldInput held{plan};
  ReferenceHeldInput reference_held{inputs};
  UpdateLevel level = UpdateLevel::every;
  bool is_gone = false;  ///< replaced by another character; it sleeps
  std::map<std::size_t, std::map<std::uint64_t, std::uint64_t>> hash_since;  ///< [primitives]
};

/// Characters on a job thread. Sometimes one changes to another plan of its scene, as engines do it: by a new
/// character.
class Drive {
 public:
  Drive(std::uint64_t seed, JobThreadOptions options) : jobs_(std::move(options)) {
    for (std::size_t c = 0; c < kCharacters; ++c) add(scenes_.emplace_back(busy_scene(seed + c)), seed + c);
  }

  /// Two frames may be in flight at once, and some results are never read.
  void step(std::uint32_t seed) {
    FixedRandom random(seed);
    if (random.below(64) == 0 && driven_.size() < 2 * kCharacters) replace_one(random);
    std::vector<FrameInput> views;
    for (std::size_t c = 0; c < driven_.size(); ++c)
      views.push_back(next_input(c, seed + static_cast<std::uint32_t>(c)));
    ++number_;
    if (const Result<Ticket> ticket = jobs_.submit(views)) submitted_ = {*ticket, shown_now()};
    if (submitted_.ticket == 0 || random.below(3) == 0) return;
    jobs_.wait(submitted_.ticket);
    RC_ASSERT(jobs_.last_error() == ErrorCode::ok);
    for (std::size_t c = 0; c < submitted_.shown.size(); ++c)
      if (random.below(4) > 0) look_at(c);
  }

 private:
  struct Shown {
    ReferenceHeldInput input;
    bool is_gone;
  };
  struct Submitted {
    Ticket ticket = 0;
    std::vector<Shown> shown;
  };

  void add(const Scene& scene, std::uint64_t seed) {
    const Driven& added = driven_.emplace_back(Driven{.plan = compile_plan(lend(scene), busy_needs(seed, scene))});
    jobs_.add_character(added.plan);
  }

  void replace_one(FixedRandom& random) {
    Driven& one = driven_[random.below(static_cast<std::uint32_t>(driven_.size()))];
    if (one.is_gone) return;
    one.is_gone = true;
    add(one.plan.scene(), random.below(1000));
  }

  FrameInput next_input(std::size_t c, std::uint32_t seed) {
    Driven& one = driven_[c];
    one.inputs.step(seed);
    if (seed % 7 == 0) one.level = static_cast<UpdateLevel>(seed / 7 % 3);
    const auto phase = static_cast<std::uint32_t>(c);
    one.reference_held.next(one.inputs, one.level, number_, phase);
    FrameInput input = one.held.next(one.inputs.view(), one.level, number_, phase);
    input.asleep |= one.is_gone;
    return input;
  }

  std::vector<Shown> shown_now() const {
    std::vector<Shown> shown;
    for (const Driven& one : driven_) shown.push_back({one.reference_held, one.is_gone});
    return shown;
  }

  void look_at(std::size_t c) {
    const FrameResult* result = jobs_.latest(static_cast<JobThread::Character>(c));
    RC_ASSERT(result != nullptr);
    FrameBuffer fresh(driven_[c].plan);
    FrameInput input = submitted_.shown[c].input.view();
    input.asleep |= submitted_.shown[c].is_gone;
    RC_ASSERT(run_plan(driven_[c].plan, input, fresh) == ErrorCode::ok);
    RC_ASSERT(first_difference(*result, fresh.result()) == "");
    RC_ASSERT(result->frame <= submitted_.ticket);
    for (std::size_t p = 0; p < result->primitives.size(); ++p)
      check_stamp(driven_[c].hash_since[p], result->primitives[p]);
  }

  /// A since_frame number stands for one set of vertices.
  static void check_stamp(std::map<std::uint64_t, std::uint64_t>& hash_since, const DeformedPrimitive& shape) {
    if (shape.since_frame != 0)
      RC_ASSERT(hash_since.try_emplace(shape.since_frame, hash_shape(shape)).first->second == hash_shape(shape));
  }

  std::deque<Scene> scenes_;
  std::deque<Driven> driven_;
  JobThread jobs_;  // declared after the scenes that it shows, so that it is destroyed before them
  Submitted submitted_;
  std::uint64_t number_ = 0;
};

void drive(std::uint64_t seed, JobThreadOptions options) {
  const auto steps = *rc::gen::resize(200, rc::gen::arbitrary<std::vector<std::uint32_t>>());
  Drive character(seed, std::move(options));
  for (const std::uint32_t step : steps) character.step(step);
}

RC_GTEST_PROP(remembering_characters, P19_beside_the_caller_with_three_buffers, (std::uint64_t seed)) {
  drive(seed, spread());
}

RC_GTEST_PROP(remembering_characters, P19_polled_with_two_buffers, (std::uint64_t seed)) {
  drive(seed, {.own_thread = false, .frame_buffers = 2});
}

}  // namespace
}  // namespace sinew::test
