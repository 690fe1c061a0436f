// SPDX-License-Identifier: MIT
// sinew-frame-study measures GPU times of pictures on this machine's Vulkan device. It draws many objects without and
// with ambient occlusion, and whole frames of built-in scenes and of files.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "runtime/plan/run_plan.h"
#include "tests/study/frame_study.h"
#include "viewer/app/loaded_scene.h"
#include "viewer/app/open/open_files.h"
#include "viewer/device/device_error.h"

namespace sinew::viewer {
namespace {

/// The least time; -1 if there are no times.
double least(const std::vector<double>& milliseconds) {
  return milliseconds.empty() ? -1.0 : *std::min_element(milliseconds.begin(), milliseconds.end());
}

void print(const DrawTrial& t) {
  const double without = least(t.without.opaque_ms), with = least(t.with.opaque_ms);
  std::printf("| %u | %.1f | %.1f | %.2f |\n", t.draws, without, with, with / without);
}

void print(const FrameTrial& t) {
  const double base = least(t.base.all_ms), full = least(t.full.all_ms);
  std::printf("| %s | %u | %llu | %.1f | %.1f | %.2f |\n", t.name.c_str(), t.draws,
              static_cast<unsigned long long>(t.triangles), base, full, full / base);
}

/// Measures the middle of the first clip of a file. Returns false, with a message, if the file cannot be read.
bool study_file(Device& device, const std::string& file, const FrameEffort& effort) {
  Options options;
  options.file = file;
  options.environment = "none";  // the study brings its own
  const auto log_line = [](const std::string& line) { std::fprintf(stderr, "sinew-frame-study: %s\n", line.c_str()); };
  const auto loaded_scenes = load_scenes(options, log_line, {});
  if (!loaded_scenes) {
    log_line(loaded_scenes.error().message);
    return false;
  }
  const Scene& scene = loaded_scenes->front().scene;
  const std::uint32_t clip = scene.animations.empty() ? kNone : 0;
  const Plan plan = compile_plan(lend(scene), needs_of(loaded_scenes->front(), {}));
  FrameBuffer buffer(plan);
  const ClipLayer layer{.clip = clip, .time_s = clip == kNone ? 0.0 : 0.5 * scene.animations[clip].duration_s};
  FrameInput input;
  if (clip != kNone) input.layers = {&layer, 1};
  if (run_plan(plan, input, buffer) != ErrorCode::ok) throw std::runtime_error("the frame cannot be evaluated");
  print(study_frame(device, loaded_scenes->front().name, scene, buffer.result(), clip_extent(scene, clip), effort));
  return true;
}

}  // namespace
}  // namespace sinew::viewer

int main(int argc, char** argv) {
  using namespace sinew::viewer;
  FrameEffort effort;
  std::vector<std::string> files;
  CLI::App program("What pictures take on this machine: GPU milliseconds, the least of some repetitions.",
                   "sinew-frame-study");
  program.add_option("FILE", files, "glTF files beside the built-in scenes");
  program.add_option("--width", effort.width, "Of the pictures (1280)")->check(CLI::Range(8u, 4096u));
  program.add_option("--height", effort.height, "Of the pictures (720)")->check(CLI::Range(8u, 4096u));
  program.add_option("--repetitions", effort.repetitions, "Of which the least time counts (10)")
      ->check(CLI::Range(1, 1000));
  CLI11_PARSE(program, argc, argv);
  try {
    Device device;
    std::printf("%s, %u x %u\n\n| draws | opaque pass, ms | with ambient occlusion | ratio |\n|---|---|---|---|\n",
                device.name().c_str(), effort.width, effort.height);
    for (const std::uint32_t draws : {19u, 115u}) print(study_draws(device, draws, effort));
    std::printf(
        "\n| frame | draws | triangles | base, ms | environment, shadows, 4 samples | ratio |\n"
        "|---|---|---|---|---|---|\n");
    bool all = true;
    for (const std::string& file : files) all &= study_file(device, file, effort);
    for (const FrameTrial& trial : study_built_in_frames(device, effort)) print(trial);
    return all ? 0 : 1;
  } catch (const DeviceError& error) {
    std::fprintf(stderr, "sinew-frame-study: there is no Vulkan device: %s\n", error.what());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sinew-frame-study: %s\n", error.what());
  }
  return 3;
}
