// SPDX-License-Identifier: MIT
// Updates of motion graphs: locomotion as games have it, and machines of 10 and 100 states.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/graph/graph_builder.h"
#include "runtime/graph/update_graph.h"

namespace sinew {
namespace {

/// One character whose parameters stay, as most frames of a game are.
class Walker {
 public:
  /// in   in_step  clips have two beats, so blend spaces play in step by feet
  Walker(const GraphBuilder& builder, GraphIndex root, std::vector<float> values, bool in_step = false)
      : graph_(builder.build(root).value()), values_(std::move(values)) {
    std::vector<GraphClip> clips;
    for (std::uint32_t c = 0; c < graph_.tables().clip_names.size(); ++c)
      clips.push_back({.clip = c,
                       .duration_s = 0.8 + 0.05 * (c % 9),
                       .event_times_s = steps_,
                       .beats = in_step ? std::span<const SyncBeat>(beats_) : std::span<const SyncBeat>()});
    clips_ = GraphClipSet::make(graph_, clips).value();
    state_.resize(graph_.state_bytes() / sizeof(std::uint64_t) + 1);
    const ErrorCode code = run(StartGraphJob{&graph_, &clips_, values_, bytes()});
    benchmark::DoNotOptimize(code);
  }

  void measure(benchmark::State& state) {
    for (auto _ : state) advance(state);
    write_counters(state);
  }

  /// Restores a character and runs it again for 8 frames, for 64 characters.
  void measure_rollback(benchmark::State& state) {
    const std::vector<std::uint64_t> saved = state_;
    for (auto _ : state)
      for (int character = 0; character < 64; ++character) {
        state_ = saved;
        for (int frame = 0; frame < 8; ++frame) advance(state);
      }
    write_counters(state);
  }

 private:
  void advance(benchmark::State& state) {
    const ErrorCode code =
        run(UpdateGraphJob{&graph_, &clips_, values_, bytes(), 1.0 / 60.0, &program_, events_, &step_});
    if (code != ErrorCode::ok) state.SkipWithError("refused");
    benchmark::DoNotOptimize(program_.ops().data());
  }
  void write_counters(benchmark::State& state) {
    state.counters["per_item"] =
        benchmark::Counter(1.0, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["bytes"] = static_cast<double>(graph_.state_bytes());
    state.counters["ops"] = static_cast<double>(program_.ops().size());
  }

  std::span<std::byte> bytes() { return std::as_writable_bytes(std::span(state_)); }

  GraphDefinition graph_;
  GraphClipSet clips_;
  std::vector<double> steps_ = {0.1, 0.5};
  std::vector<SyncBeat> beats_ = {{0.1, 0}, {0.62, 1}};
  std::vector<float> values_;
  std::vector<std::uint64_t> state_;
  std::vector<GraphEvent> events_ = std::vector<GraphEvent>(64);
  PoseProgram program_;
  GraphStep step_;
};

/// idle, walk and run in one space of nine points, jumps and falls beside it, and an aim over it all.
Walker locomotion(bool in_step) {
  GraphBuilder b;
  const GraphIndex forward = b.number("forward"), aside = b.number("aside"), jump = b.trigger("jump"),
                   aims = b.flag("aims");
  std::vector<GraphBlendPoint> points;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      points.push_back({static_cast<float>(x), static_cast<float>(y), b.clip("move" + std::to_string(3 * y + x + 4))});
  const GraphIndex body = b.machine("body");
  const GraphIndex ground = b.state(body, "ground", b.blend_space("gaits", {.x = forward, .y = aside}, points));
  const GraphIndex air = b.state(body, "air", b.clip("jump", {.loop = false}));
  b.transition(body, ground, {.to = air}, {when_triggered(jump)});
  b.transition(body, air, {.to = ground}, {when_played(1)});
  const GraphIndex arms = b.machine("arms");
  const GraphIndex rest = b.state(arms, "rest", b.clip("rest")), aim = b.state(arms, "aim", b.clip("aim"));
  b.transition(arms, rest, {.to = aim}, {when_on(aims)});
  b.transition(arms, aim, {.to = rest}, {when_off(aims)});
  const GraphLayer layer{.node = arms, .mask = 0};
  const GraphIndex root = b.layers("all", body, std::vector{layer});
  return Walker(b, root, {0.4f, 0.3f, 0.0f, 1.0f}, in_step);
}

void update_locomotion(benchmark::State& state) { locomotion(false).measure(state); }
void update_in_step(benchmark::State& state) { locomotion(true).measure(state); }
void roll_back(benchmark::State& state) { locomotion(true).measure_rollback(state); }

void update_states(benchmark::State& state) {
  GraphBuilder b;
  const GraphIndex go = b.number("go");
  const GraphIndex machine = b.machine("machine");
  const auto count = static_cast<GraphIndex>(state.range(0));
  for (GraphIndex i = 0; i < count; ++i) b.state(machine, "state", b.clip("clip"));
  for (GraphIndex i = 0; i < count; ++i)
    b.transition(machine, i, {.to = static_cast<GraphIndex>((i + 1) % count)}, {when_above(go, 1.0f)});
  Walker(b, machine, {0.0f}).measure(state);
}

BENCHMARK(update_locomotion)->Name("graph/sinew/locomotion");
BENCHMARK(update_in_step)->Name("graph/sinew/locomotion_in_step");
BENCHMARK(roll_back)->Name("graph/sinew/rollback_8_frames_64_characters");
BENCHMARK(update_states)->Name("graph/sinew/states")->Arg(10)->Arg(100);

}  // namespace
}  // namespace sinew
