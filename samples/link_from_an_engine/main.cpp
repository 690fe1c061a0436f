// SPDX-License-Identifier: MIT
// How an engine uses sinew: read an asset file, and compile a plan once. Then submit frames to the job thread, and read
// the newest finished one without waiting. `sinew compile lift.gltf -o lift.sinew` makes the file; no importer is
// linked.
#include <sinew/asset_file.h>
#include <sinew/job_thread.h>
#include <sinew/plan.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace {

/// The bytes of a file. An engine would map the file into memory instead.
std::vector<char> bytes_of(const char* path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

tl::expected<sinew::Scene, sinew::AssetFileError> load(const char* path) {
  const std::vector<char> bytes = bytes_of(path);
  const auto file = sinew::AssetFile::open(std::as_bytes(std::span(bytes)));
  if (!file) return tl::unexpected(file.error());
  return sinew::read_scene(*file);  // the scene owns its data: the bytes are not needed any longer
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: link_from_an_engine FILE.sinew\n");
    return 2;
  }
  auto loaded = load(argv[1]);
  if (!loaded) {
    std::fprintf(stderr, "%s: %s\n", argv[1], describe(loaded.error()).c_str());
    return 1;
  }

  // One plan serves all characters of this scene. It computes bounds but no tangents.
  sinew::Needs needs;
  needs.out.bounds = true;
  needs.out.tangents = false;
  const sinew::Plan plan = compile_plan(std::move(*loaded), needs);
  const sinew::Scene& scene = plan.scene();
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
    sinew::FrameInput shifted = playing;  // a copy, three metres to the right
    shifted.root.row[0].w = 3.0f;
    const sinew::FrameInput inputs[] = {playing, shifted};
    const auto ticket = jobs.submit(inputs);
    if (!ticket) {
      std::fprintf(stderr, "%s\n", describe(ticket.error()).data());
      return 1;
    }
    jobs.wait(*ticket);  // an engine would draw the previous frame instead
    for (const auto character : {first, second}) {
      const sinew::FrameResult& result = *jobs.latest(character);
      if (result.model.empty()) continue;
      const auto at = translation_of(result.model.front());
      std::printf("%.2f s, character %u: first joint at %.3f %.3f %.3f m\n", time_s, character, at.x, at.y, at.z);
    }
  }
  return 0;
}
