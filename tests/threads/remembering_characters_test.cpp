// SPDX-License-Identifier: MIT
// Characters of a job thread, driven through any inputs, show what a fresh buffer shows that saw only the last one.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <deque>
#include <map>
#include <optional>

#include "runtime/threads/job_thread.h"
#include "tests/plan/frame_equality.h"
#include "tests/scenes/random_inputs.h"
#include "tests/threads/crowd.h"

namespace sinew::test {
namespace {

constexpr std::size_t kCharacters = 3;

/// Some characters on a job thread, each with a scene and a plan of its own.
class Drive {
 public:
  Drive(std::uint64_t seed, JobThreadOptions options) : jobs_(std::move(options)) {
    for (std::size_t c = 0; c < kCharacters; ++c) {
      const Scene& scene = scenes_.emplace_back(busy_scene(seed + c));
      plans_.push_back(compile_plan(scene, busy_needs(seed + c, scene)));
      inputs_.emplace_back(plans_.back());
      jobs_.add_character(plans_.back());
    }
    hash_since_.resize(kCharacters);
  }

  /// Two frames may be on their way at once, and some results are never looked at.
  void step(std::uint32_t seed) {
    FixedRandom random(seed);
    std::vector<FrameInput> views;
    for (std::size_t c = 0; c < kCharacters; ++c) {
      inputs_[c].step(seed + static_cast<std::uint32_t>(c));
      views.push_back(inputs_[c].view());
    }
    if (const Result<Ticket> ticket = jobs_.submit(views)) submitted_ = {*ticket, inputs_};
    if (submitted_.ticket == 0 || random.below(3) == 0) return;
    jobs_.wait(submitted_.ticket);
    RC_ASSERT(jobs_.last_error() == ErrorCode::ok);
    for (std::size_t c = 0; c < kCharacters; ++c)
      if (random.below(4) > 0) look_at(c);
  }

 private:
  struct Submitted {
    Ticket ticket = 0;
    std::vector<RandomInputs> inputs;
  };

  void look_at(std::size_t c) {
    const FrameResult* result = jobs_.latest(static_cast<JobThread::Character>(c));
    RC_ASSERT(result != nullptr);
    FrameBuffer fresh(plans_[c]);
    RC_ASSERT(run_plan(plans_[c], submitted_.inputs[c].view(), fresh) == ErrorCode::ok);
    RC_ASSERT(first_difference(*result, fresh.result()) == "");
    RC_ASSERT(result->frame <= submitted_.ticket);
    for (std::size_t p = 0; p < result->primitives.size(); ++p) check_stamp(hash_since_[c][p], result->primitives[p]);
  }

  /// A number of a frame stands for one set of vertices.
  static void check_stamp(std::map<std::uint64_t, std::uint64_t>& hash_since, const DeformedPrimitive& shape) {
    if (shape.since_frame != 0)
      RC_ASSERT(hash_since.try_emplace(shape.since_frame, hash_shape(shape)).first->second == hash_shape(shape));
  }

  std::deque<Scene> scenes_;
  std::vector<Plan> plans_;
  std::vector<RandomInputs> inputs_;
  JobThread jobs_;  // ends before what it shows
  Submitted submitted_;
  std::vector<std::map<std::size_t, std::map<std::uint64_t, std::uint64_t>>> hash_since_;  // [characters][primitives]
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
