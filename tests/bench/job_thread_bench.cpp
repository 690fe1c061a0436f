// SPDX-License-Identifier: MIT
#include <tbb/task_arena.h>

#include <cmath>
#include <utility>

#include "runtime/threads/job_thread.h"
#include "runtime/threads/default_executor.h"
#include "tests/bench/clip_characters.h"
#include "tests/bench/measure.h"

namespace sinew::bench {
namespace {

Scene skeleton_alone(const Character& character) {
  Scene scene;
  scene.skeleton = character.skeleton;
  scene.animations.push_back(character.animation);
  finish_scene(scene);
  return scene;
}

/// A crowd of poses on the job thread, each character at its own time. Every frame says which threads
/// it runs on.
class Crowd {
 public:
  Crowd(const Character& character, std::size_t count, std::size_t part_bytes)
      : scene_(skeleton_alone(character)),
        plan_(compile_plan(scene_, {})),
        jobs_({.executor = executor(), .inline_below_bytes = 0, .part_bytes = part_bytes}),
        layers_(count),
        inputs_(count) {
    for (std::size_t c = 0; c < count; ++c) jobs_.add_character(plan_);
  }
  /// in   arena  the threads; null = the worker alone
  void next(bool held, tbb::task_arena* arena) {
    arena_ = arena;
    if (!held) time_s_ += 1.0 / 60.0;
    for (std::size_t c = 0; c < inputs_.size(); ++c) {
      layers_[c] = {0, std::fmod(time_s_ + 0.618 * static_cast<double>(c), scene_.animations[0].duration_s), 1.0f};
      inputs_[c] = {.layers = {&layers_[c], 1}, .weights = {}, .root = {}};
    }
    jobs_.wait(*jobs_.submit(inputs_));
  }

 private:
  Executor executor() {
    return [this](std::size_t count, const std::function<void(std::size_t)>& body) {
      if (arena_ != nullptr) return arena_->execute([&] { run_in_parallel(count, body); });
      for (std::size_t i = 0; i < count; ++i) body(i);
    };
  }

  Scene scene_;
  Plan plan_;
  tbb::task_arena* arena_ = nullptr;  // of the frame in flight
  JobThread jobs_;
  std::vector<ClipLayer> layers_;
  std::vector<FrameInput> inputs_;
  double time_s_ = 0.0;
};

}  // namespace

/// `one_by_one` gives the executor one character per call, as if all were large.
void add_job_thread() {
  const Character& character = *characters().front();
  for (const std::size_t count : {std::size_t{16}, std::size_t{64}, std::size_t{1024}})
    for (const auto& [way, part_bytes] :
         {std::pair("sinew", JobThreadOptions{}.part_bytes), std::pair("one_by_one", std::size_t{1})}) {
      const auto crowd = std::make_shared<Crowd>(character, count, part_bytes);
      for (const bool held : {false, true})
        for (const std::size_t threads : thread_counts()) {
          const auto arena = threads > 1 ? std::make_shared<tbb::task_arena>(static_cast<int>(threads)) : nullptr;
          const std::string tail =
              std::to_string(count) + (held ? "/held/" : "/moving/") + std::to_string(threads) + "threads";
          Facts facts;
          facts.wall_time = true;
          add(
              std::string("job_thread/") + way + "/" + character.name + "/" + tail, count * character.joint_count(),
              [crowd, held, arena] { crowd->next(held, arena.get()); }, facts);
        }
    }
}

}  // namespace sinew::bench
