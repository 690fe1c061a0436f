// SPDX-License-Identifier: MIT
// sinew-occlusion-study measures the time of ambient occlusion on this machine's Vulkan device and its difference from
// ray casting, and prints JSON. `sinew cost` runs it, so that the tool does not need Vulkan and the viewer not Embree.
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "runtime/plan/run_plan.h"
#include "viewer/app/clip_extent.h"
#include "viewer/app/exhibit.h"
#include "viewer/app/orbit_camera.h"
#include "viewer/app/scene_choice.h"
#include "tests/study/occlusion_json.h"
#include "tests/study/occlusion_study.h"

namespace sinew::viewer {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMoment = 0.4;  // fraction of the clip at which the pose is taken

View view_of(const Exhibit& exhibit, const ClipExtent& bounds, double aspect) {
  OrbitCamera camera;
  camera.fov_y_rad = exhibit.fov_y_rad;
  if (exhibit.camera) {
    const glm::dvec3 eye(exhibit.camera->eye);
    return look_at(eye, exhibit.camera->target, camera.fov_y_rad, near_plane_for(eye, bounds.reached));
  }
  camera.frame(bounds.outline.points(), aspect);
  return camera.view(bounds.reached);
}

OcclusionStudy study_of(Device& device, const Exhibit& exhibit, std::uint32_t clip, const OcclusionEffort& effort) {
  const Plan plan = compile_plan(exhibit.scene, needs_of(exhibit, {}));
  FrameBuffer frame(plan);
  const ClipLayer layer{clip, clip == kNone ? 0.0 : kMoment * exhibit.scene.animations[clip].duration_s, 1.0f};
  FrameInput input;
  if (clip != kNone) input.layers = {&layer, 1};
  if (run_plan(plan, input, frame) != ErrorCode::ok) throw std::runtime_error("the frame cannot be evaluated");
  const ClipExtent bounds = clip_extent(exhibit.scene, clip);
  const View view = view_of(exhibit, bounds, static_cast<double>(effort.width) / effort.height);
  return study_occlusion(device, exhibit.scene, frame.result(), view, ambient_occlusion_for(bounds.largest), effort);
}

/// Runs the study.
/// out  the study as JSON, or {"left_out": why}; returns an exit code other than 0 when the command line or the file is
///      at fault
int answer(const Options& options, bool quick, Json& out) {
  auto exhibits = load_exhibits(options, [](const std::string&) {}, {});
  if (!exhibits) {
    std::fprintf(stderr, "sinew-occlusion-study: %s\n", exhibits.error().message.c_str());
    return exhibits.error().exit_code;
  }
  const Exhibit& exhibit = exhibits->front();
  std::uint32_t clip = exhibit.scene.animations.empty() ? kNone : 0;
  if (options.clip) {
    const auto chosen = choose_clip(exhibit.scene, *options.clip);
    if (!chosen) {
      std::fprintf(stderr, "sinew-occlusion-study: %s\n", describe_missing_clip(exhibit.scene, *options.clip).c_str());
      return 2;
    }
    clip = *chosen;
  }
  try {
    Device device;
    const OcclusionStudy study = study_of(device, exhibit, clip, quick ? OcclusionEffort::quick() : OcclusionEffort{});
    out = study.pixels > 0 ? json_of(study) : Json{{"left_out", "the file shows no opaque surface"}};
  } catch (const DeviceError& error) {
    out = {{"left_out", std::string("there is no Vulkan device: ") + error.what()}};
  }
  return 0;
}

}  // namespace
}  // namespace sinew::viewer

int main(int argc, char** argv) {
  using namespace sinew::viewer;
  Options options;
  bool quick = false;
  CLI::App program("What ambient occlusion costs on this machine, and how far it is from ray casting: JSON on stdout.",
                   "sinew-occlusion-study");
  program.add_option("FILE", options.file, "A .gltf or .glb file; without it a built-in scene");
  program.add_option("--clip", options.clip, "Index or name of the clip, or none; the first is the default");
  program.add_flag("--quick", quick, "A small picture and few repetitions");
  CLI11_PARSE(program, argc, argv);
  try {
    nlohmann::ordered_json out;
    if (const int code = answer(options, quick, out); code != 0) return code;
    std::cout << out.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
    return std::cout.flush() ? 0 : 3;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sinew-occlusion-study: %s\n", error.what());
  }
  return 3;
}
