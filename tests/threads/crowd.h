// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "runtime/threads/job_thread.h"
#include "tests/plan/frame_hash.h"
#include "tests/scenes/random_scene.h"

namespace sinew::test {

/// A crowd of characters from three scenes, each at its own time.
class Crowd {
 public:
  explicit Crowd(std::size_t count) : layers_(count), inputs_(count) {
    RandomSceneOptions options;
    options.triangles = 12;
    for (std::uint64_t seed = 0; seed < 3; ++seed) scenes_.push_back(random_scene(seed, options));
    Needs needs;
    needs.out.bounds = true;
    for (const Scene& scene : scenes_) {
      plans_.push_back(compile_plan(lend(scene), needs));
      needs.skin.kind = Skinning::dual_quaternion;
    }
  }

  const Plan& plan_of(std::size_t c) const { return plans_[c % plans_.size()]; }
  void add_to(JobThread& jobs) const {
    for (std::size_t c = 0; c < inputs_.size(); ++c) jobs.add_character(plan_of(c));
  }
  std::span<const FrameInput> inputs(std::uint64_t frame) {
    for (std::size_t c = 0; c < inputs_.size(); ++c) {
      layers_[c] = {static_cast<std::uint32_t>(c % 2),
                    std::fmod(0.13 * static_cast<double>(c) + static_cast<double>(frame) / 60.0, 2.0),
                    c % 3 == 0 ? 0.5f : 1.0f};
      inputs_[c] = {.layers = {&layers_[c], 1}, .weights = {}, .root = {}};
      inputs_[c].root.row[0].w = static_cast<float>(c);
    }
    return inputs_;
  }
  std::uint64_t hash_without_threads(std::size_t c, std::uint64_t frame) {
    FrameBuffer buffer(plan_of(c));
    EXPECT_EQ(run_plan(plan_of(c), inputs(frame)[c], buffer), ErrorCode::ok);
    return hash_of(buffer.result());
  }

 private:
  std::vector<Scene> scenes_;
  std::vector<Plan> plans_;
  std::vector<ClipLayer> layers_;
  std::vector<FrameInput> inputs_;
};

/// Options under which each character is a part of its own, and none runs on the worker.
inline JobThreadOptions spread(Executor executor = {}) {
  return {.executor = std::move(executor), .inline_below_bytes = 0, .part_bytes = 1};
}

}  // namespace sinew::test
