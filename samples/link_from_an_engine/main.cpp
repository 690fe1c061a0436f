// SPDX-License-Identifier: MIT
// What an engine does with sinew: import once, plan once, then give frames to the job thread and read the newest
// finished one, never waiting for it.
#include <sinew/importer/import_gltf.h>
#include <sinew/runtime/threads/job_thread.h>

#include <cstdio>
#include <string>
#include <vector>

namespace {

/// A triangle on a node that a clip lifts by one metre within one second; the buffer is a data URI.
constexpr const char* kLift =
    R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
 "nodes": [{"mesh": 0, "name": "lift"}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
 "animations": [{"name": "up", "samplers": [{"input": 1, "output": 2}],
                 "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}],
 "accessors": [
  {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
  {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]},
  {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 8},
                 {"buffer": 0, "byteOffset": 44, "byteLength": 24}],
 "buffers": [{"byteLength": 68, "uri": "data:application/octet-stream;base64,)"
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAAAAAACAPwAAAAA=\"}]}";

sinew::ImportResult<sinew::ImportedFile> load(int argc, char** argv) {
  if (argc == 2) return sinew::import_gltf(argv[1]);
  const std::string text = kLift;
  return sinew::import_gltf(std::as_bytes(std::span(text)), "built-in.gltf");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2) {
    std::fprintf(stderr, "usage: link_from_an_engine [FILE]\n");
    return 2;
  }
  const auto file = load(argc, argv);
  if (!file) {
    std::fprintf(stderr, "%s\n", describe(file.error().file, file.error().issue).c_str());
    return 1;
  }
  const sinew::Scene& scene = file->scene;

  // One plan for all characters that show this scene: bounds are asked for, tangents are not.
  sinew::Needs needs;
  needs.bounds = true;
  needs.tangents = false;
  const sinew::Plan plan = compile_plan(scene, needs);
  for (const sinew::PlanStage& stage : plan.stages())
    std::printf("%-20s %s: %s\n", stage.stage.c_str(), stage.runs ? "runs" : "left out", stage.reason.c_str());

  sinew::JobThread jobs;
  const auto first = jobs.add_character(plan);
  const auto second = jobs.add_character(plan);
  for (int frame = 0; frame <= 4; ++frame) {
    const double time_s = 0.25 * frame;
    const sinew::ClipLayer layer{.clip = 0, .time_s = time_s, .weight = 1.0f};
    sinew::FrameInput playing;
    if (!scene.clips.empty()) playing.layers = {&layer, 1};
    sinew::FrameInput shifted = playing;  // the same, three metres to the right
    shifted.root.row[0].w = 3.0f;
    const sinew::FrameInput inputs[] = {playing, shifted};
    const auto ticket = jobs.submit(inputs);
    if (!ticket) {
      std::fprintf(stderr, "%s\n", describe(ticket.error()).data());
      return 1;
    }
    jobs.wait(*ticket);  // an engine would draw the frame before instead
    for (const auto character : {first, second}) {
      const sinew::FrameResult& result = *jobs.latest(character);
      if (result.model.empty()) continue;
      const auto at = translation_of(result.model.front());
      std::printf("%.2f s, character %u: first joint at %.3f %.3f %.3f m\n", time_s, character, at.x, at.y, at.z);
    }
  }
  if (argc == 2) return 0;
  const float lifted_m = translation_of(jobs.latest(second)->model.front()).y;
  return lifted_m == 1.0f ? 0 : 1;  // at the last key the stored value itself
}
