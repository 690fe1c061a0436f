// SPDX-License-Identifier: MIT
// sinew-occlusion-study measures the time of ambient occlusion on this machine's Vulkan device and its difference from
// ray casting, and prints JSON. `sinew cost` starts this program, so that the tool does not need Vulkan and the viewer
// not Embree.
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "runtime/plan/run_plan.h"
#include "tests/study/occlusion_json.h"
#include "tests/study/occlusion_study.h"
#include "viewer/app/camera/orbit_camera.h"
#include "viewer/app/clip_extent.h"
#include "viewer/app/loaded_scene.h"
#include "viewer/app/open/open_files.h"
#include "viewer/app/scene_choice.h"

namespace sinew::viewer {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMoment = 0.4;  // fraction of the clip at which the pose is taken

View view_of(const LoadedScene& loaded, const ClipExtent& bounds, double aspect) {
  OrbitCamera camera;
  camera.fov_y_rad = loaded.fov_y_rad;
  if (loaded.camera) {
    const glm::dvec3 eye(loaded.camera->eye);
    return look_at(eye, loaded.camera->target, camera.fov_y_rad, near_plane_for(eye, bounds.reached));
  }
  camera.frame(bounds.outline.points(), aspect);
  return camera.view(bounds.reached);
}

OcclusionStudy study_of(Device& device, const LoadedScene& loaded, std::uint32_t clip, const OcclusionEffort& effort) {
  const Plan plan = compile_plan(lend(loaded.scene), needs_of(loaded, {}));
  FrameBuffer frame(plan);
  const ClipLayer layer{clip, clip == kNone ? 0.0 : kMoment * loaded.scene.animations[clip].duration_s, 1.0f};
  FrameInput input;
  if (clip != kNone) input.layers = {&layer, 1};
  if (run_plan(plan, input, frame) != ErrorCode::ok) throw std::runtime_error("the frame cannot be evaluated");
  const ClipExtent bounds = clip_extent(loaded.scene, clip);
  const View view = view_of(loaded, bounds, static_cast<double>(effort.width) / effort.height);
  return study_occlusion(device, loaded.scene, frame.result(), view, ambient_occlusion_for(bounds.largest), effort);
}

/// Runs the study.
/// out  the study as JSON, or {"left_out": reason}; returns a nonzero exit code for a faulty command line or file
int answer(const Options& options, bool quick, Json& out) {
  auto loaded_scenes = load_scenes(options, [](const std::string&) {}, {});
  if (!loaded_scenes) {
    std::fprintf(stderr, "sinew-occlusion-study: %s\n", loaded_scenes.error().message.c_str());
    return loaded_scenes.error().exit_code;
  }
  const LoadedScene& loaded = loaded_scenes->front();
  std::uint32_t clip = loaded.scene.animations.empty() ? kNone : 0;
  if (options.clip) {
    const auto chosen = choose_clip(loaded.scene, *options.clip);
    if (!chosen) {
      std::fprintf(stderr, "sinew-occlusion-study: %s\n", describe_missing_clip(loaded.scene, *options.clip).c_str());
      return 2;
    }
    clip = *chosen;
  }
  try {
    Device device;
    const OcclusionStudy study = study_of(device, loaded, clip, quick ? OcclusionEffort::quick() : OcclusionEffort{});
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
