// SPDX-License-Identifier: MIT
// A motion graph as text moves a character over the ground: it stands, walks, runs a bend and stops. The root motion of
// the clips carries it, and events of the clips sound its steps. With an argument, plays at that many frames a second;
// way and steps are the same.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <vector>

#include "importer/graph/graph_text.h"
#include "runtime/graph/read_graph_state.h"
#include "runtime/graph/update_graph.h"
#include "runtime/math/axis_angle.h"

namespace {

using namespace sinew;

const char* const kGraph = R"({
  "graph": 1,
  "root": "body",
  "parameters": {"speed": {"kind": "number"}, "turn": {"kind": "number"}},
  "nodes": {
    "body": {"kind": "machine", "initial": "stands", "states": {
      "stands": {"node": "stand", "transitions": [
        {"to": "moves", "duration_s": 0.3, "when": [{"kind": "above", "parameter": "speed", "value": 0.1}]}]},
      "moves": {"node": "gaits", "transitions": [
        {"to": "stands", "duration_s": 0.4, "when": [{"kind": "below", "parameter": "speed", "value": 0.1}]}]}}},
    "stand": {"kind": "clip", "clip": "stand"},
    "gaits": {"kind": "blend_space", "x": "turn", "y": "speed", "form": "directional", "points": [
      {"x": 0, "y": 1.5, "node": "walk"}, {"x": 0, "y": 4, "node": "run"}, {"x": 2, "y": 4, "node": "bend"}]},
    "walk": {"kind": "clip", "clip": "walk"},
    "run": {"kind": "clip", "clip": "run"},
    "bend": {"kind": "clip", "clip": "bend"}
  }
})";

/// The way of a clip: so many metres ahead in a round, turning about the vertical by so much.
RootTrack way(float seconds, float metres, double turn_rad) {
  BoneAnimation root;
  root.translation = {Interpolation::linear, {0.0f, seconds}, {{0, 1, 0}, {0, 1, metres}}};
  root.rotation = {Interpolation::linear,
                   {0.0f, seconds},
                   {glm::quat(1, 0, 0, 0), quat_cast<float>(quat_from_axis_angle(Vec3<double>(0, 1, 0), turn_rad))}};
  return RootTrack::make(root, {}, {}, 1e-5);
}

struct Setting {
  double time_s;
  float speed, turn;
};
constexpr Setting kScript[] = {{1.0, 1.5f, 0.0f}, {4.0, 4.0f, 0.0f}, {6.0, 4.0f, 2.0f}, {8.0, 0.0f, 0.0f}};
constexpr int kSeconds = 10;

/// The places of the character and the number of steps that were heard.
struct Outcome {
  DualQuatd world;
  int steps = 0;
};

/// Plays the script; prints where the character is each second.
Outcome play(const GraphDefinition& graph, const GraphClipSet& clips, int fps, bool prints) {
  const GraphIndex speed = graph.find_parameter("speed"), turn = graph.find_parameter("turn");
  std::vector<float> values(graph.tables().parameters.size());
  std::vector<std::uint64_t> memory(graph.state_bytes() / sizeof(std::uint64_t));
  const std::span<std::byte> state = std::as_writable_bytes(std::span(memory));
  PoseProgram program;
  GraphStep step;
  std::array<GraphEvent, 16> events;
  Outcome out;
  DualQuatd& world = out.world;
  if (run(StartGraphJob{&graph, &clips, values, state}) != ErrorCode::ok) std::abort();
  for (int frame = 0; frame < kSeconds * fps; ++frame) {
    for (const Setting& setting : kScript)
      if (frame == static_cast<int>(setting.time_s * fps)) {
        values[speed] = setting.speed;
        values[turn] = setting.turn;
      }
    if (run(UpdateGraphJob{&graph, &clips, values, state, 1.0 / fps, &program, events, &step}) != ErrorCode::ok)
      std::abort();
    world = normalised(world * step.root_motion);
    // Where clips blend, each tells its own steps. One is heard if its clip has most of the weight.
    for (const GraphEvent& event : std::span(events).first(step.event_count))
      out.steps += event.kind == GraphEventKind::clip && event.weight > 0.5f;
    // A frame would take program.ops() as FrameInput::program, and world * inverse of step.root_place as its root.
    if (!prints || (frame + 1) % fps != 0) continue;
    GraphStateView view;
    read_graph_state(graph, clips, values, state, {&view, 1});
    const Vec3<double> at = translation_of(world);
    const std::string_view name =
        graph.tables().name_at(graph.tables().states[view.state].name);  // of the only machine
    std::printf("%2d s  x %7.3f  z %7.3f  %.*s, %zu operations, %d steps\n", (frame + 1) / fps, at.x, at.z,
                static_cast<int>(name.size()), name.data(), program.ops().size(), out.steps);
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const int fps = argc == 2 ? std::atoi(argv[1]) : 60;
  if (argc > 2 || fps < 10 || fps > 1000) {
    std::fprintf(stderr, "usage: walk_and_run [FPS]      10 to 1000 frames a second, 60 unless given\n");
    return 2;
  }
  const auto document = read_graph(kGraph);
  const auto graph = document ? compile_graph(*document) : tl::make_unexpected(document.error());
  if (!graph) {
    std::fprintf(stderr, "walk_and_run: %s: %s\n", graph.error().json_pointer.c_str(), graph.error().sentence.c_str());
    return 1;
  }
  const RootTrack walk = way(1.0f, 1.5f, 0.0), run_way = way(0.7f, 2.8f, 0.0), bend = way(0.7f, 2.8f, 0.5);
  const std::vector<double> walk_steps = {0.1, 0.6}, run_steps = {0.1, 0.45};  // both feet touch the ground once
  std::vector<GraphClip> clips;
  for (const std::uint32_t offset : graph->tables().clip_names) {
    const std::string_view name = graph->tables().name_at(offset);
    const auto index = static_cast<std::uint32_t>(clips.size());
    if (name == "walk")
      clips.push_back({index, 1.0, walk_steps, &walk});
    else if (name == "stand")
      clips.push_back({index, 2.0});
    else
      clips.push_back({index, 0.7f, run_steps, name == "run" ? &run_way : &bend});
  }
  const GraphClipSet set = *GraphClipSet::make(clips);
  std::printf("a character's state takes %zu bytes\n", graph->state_bytes());
  const Outcome seen = play(*graph, set, fps, true), fine = play(*graph, set, 1000, false);
  // Speeds and lengths of the clips, and what the fades take.
  const Vec3<double> end = translation_of(seen.world);
  const double off_m = glm::length(end - translation_of(fine.world)), way_m = std::hypot(end.x, end.z);
  std::printf("%.3f m away, %.2g m from the end at 1000 frames a second; %d steps, %d there\n", way_m, off_m,
              seen.steps, fine.steps);
  return way_m > 10.0 && way_m < 22.0 && off_m < 1e-6 && seen.steps > 12 && seen.steps == fine.steps ? 0 : 1;
}
