// SPDX-License-Identifier: MIT
#include "importer/tool/cost/overview/frame_parts.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string>

#include "importer/tool/cost/measure.h"
#include "runtime/base/contract.h"
#include "runtime/plan/compile_plan.h"
#include "runtime/plan/run_plan.h"

namespace sinew::cost {
namespace {

constexpr int kFramesUntilWarm = 8;

constexpr std::array<const char*, kStageCount> kPartOfStage = {kSamplePart,
                                                               "mirror",
                                                               "blend",
                                                               "add layers",
                                                               "pose programs",
                                                               "interpolate poses",
                                                               "corrective shapes",
                                                               "materials and lights",
                                                               "joint matrices",
                                                               "skinning matrices",
                                                               "skinning matrices",
                                                               "skinning matrices",
                                                               "windings",
                                                               kMorphPart,
                                                               kSkinPart,
                                                               kSkinPart,
                                                               kSkinPart,
                                                               "geometry cache",
                                                               "flat normals",
                                                               "bounds"};

/// Passes of the viewer that a reader knows by other names.
constexpr std::array<std::array<const char*, 2>, 14> kPartOfPass = {{{"upload", "upload"},
                                                                     {"collect", "upload"},
                                                                     {"shadow", "shadows"},
                                                                     {"normal_depth", "depth and normals"},
                                                                     {"ssao", "ambient occlusion"},
                                                                     {"blur_horizontal", "ambient occlusion"},
                                                                     {"blur_vertical", "ambient occlusion"},
                                                                     {"opaque", "surfaces"},
                                                                     {"transparent", "surfaces"},
                                                                     {"weighted", "surfaces"},
                                                                     {"behind", "surfaces"},
                                                                     {"tonemap", "display"},
                                                                     {"exposure", "display"},
                                                                     {"overlay", "display"}}};

void add_to_part(std::vector<FramePart>& parts, const std::string& name, double us) {
  if (!(us > 0.0)) return;
  const auto same = std::find_if(parts.begin(), parts.end(), [&](const FramePart& part) { return part.name == name; });
  if (same != parts.end())
    same->us += us;
  else
    parts.push_back({name, us});
}

std::string part_of_pass(const std::string& pass) {
  for (const auto& [name, part] : kPartOfPass)
    if (pass == name) return part;
  return pass;
}

}  // namespace

std::vector<FramePart> evaluation_parts(const Scene& scene, std::uint32_t clip, const Effort& effort) {
  if (clip == kNone) return {};
  Needs needs;
  needs.out.stage_times = true;
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer frame(plan);
  std::array<std::vector<double>, kStageCount> times_us;
  const int frames = kFramesUntilWarm + 16 * effort.repetitions;
  for (int i = 0; i < frames; ++i) {
    const ClipLayer layer{.clip = clip, .time_s = (i + 0.5) / frames * scene.clips[clip].duration_s()};
    const ErrorCode code = run_plan(plan, {.layers = {&layer, 1}}, frame);
    CONTRACT(code == ErrorCode::ok);  // the scene is checked, and the clip is one of its own
    if (i >= kFramesUntilWarm)
      for (std::size_t s = 0; s < kStageCount; ++s)
        times_us[s].push_back(1e-3 * static_cast<double>(frame.result().stage_ns[s]));
  }
  std::vector<FramePart> parts;
  for (std::size_t s = 0; s < kStageCount; ++s) add_to_part(parts, kPartOfStage[s], middle_of(times_us[s]).median);
  return parts;
}

std::vector<FramePart> drawing_parts(std::string_view plan) {
  std::vector<FramePart> parts;
  std::istringstream lines{std::string(plan)};
  bool draws = false;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line[0] != ' ') draws = line.starts_with("drawing") || line.starts_with("passes");
    std::istringstream words(line);
    std::string name, state, count, unit;
    double us = 0.0;
    if (draws && words >> name >> state >> count >> us >> unit && state == "on" && unit == "us")
      add_to_part(parts, part_of_pass(name), us);
  }
  return parts;
}

}  // namespace sinew::cost
