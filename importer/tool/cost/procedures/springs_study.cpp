// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "importer/tool/cost/studies.h"
#include "importer/tool/cost/words.h"
#include "runtime/math/quaternion.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/procedures/springs/springs_job.h"
#include "samples/showcase/scene_builder.h"

namespace sinew::cost {
namespace {

constexpr std::uint32_t kHairs = 16, kLong = 4, kJoints = kHairs * kLong;
constexpr int kFineHz = 960, kLooks = 6;  // a fine step, and moments a second at which runs are compared
constexpr double kSeconds = 2.0;

using Places = std::vector<Vec3<double>>;

/// A head whose hairs of 0.4 m hang down. It goes round a figure of eight once a second.
class Hair {
 public:
  Hair() {
    showcase::SceneBuilder scene;
    scene.add_joint("head", kNone, {});
    for (std::uint32_t depth = 0; depth <= kLong; ++depth)
      for (std::uint32_t hair = 0; hair < kHairs; ++hair) {
        const float around = 2.0f * std::numbers::pi_v<float> * static_cast<float>(hair) / kHairs;
        const auto joint = 1 + depth * kHairs + hair;
        scene.add_joint(fmt::format("hair {} {}", hair, depth), depth == 0 ? 0 : joint - kHairs,
                        {.translation = depth == 0 ? glm::vec3(0.1f * std::cos(around), 0.0f, 0.1f * std::sin(around))
                                                   : glm::vec3(0.0f, -0.1f, 0.0f)});
        if (depth < kLong) setup_.joints.push_back({.joint = joint, .tail_m = {0.0, -0.1, 0.0}});
      }
    setup_.groups.resize(1);
    scene_ = scene.finish();
  }

  /// Runs all frames. Returns the tails at kLooks moments a second.
  /// in   tick_s  0: a step takes as long as a frame
  Places run(double tick_s, int fps) const {
    SpringSettings settings;
    settings.tick_s = tick_s > 0.0 ? tick_s : 1.0 / fps;
    settings.max_ticks = 64;
    const Springs springs = compile_springs(scene_.skeleton, setup_, settings).value();
    std::vector<std::uint64_t> state(springs.state_bytes() / 8), scratch(springs.scratch_bytes() / 8);
    PoseMemory pose(scene_.skeleton.joint_count());
    for (std::size_t j = 0; j < scene_.skeleton.joint_count(); ++j) pose.span().set(j, scene_.skeleton.rest[j]);
    Places tails(kJoints), seen;
    for (int frame = 0; frame <= static_cast<int>(kSeconds * fps); ++frame) {
      const double phase = 2.0 * std::numbers::pi * frame / fps;
      Affined root;
      root.row[0].w = 0.1 * std::sin(phase);
      root.row[2].w = 0.05 * std::sin(2.0 * phase);
      run_unchecked(SpringsJob{.springs = &springs,
                               .skeleton = &scene_.skeleton,
                               .pose = pose.span(),
                               .root = root,
                               .dt_s = frame == 0 ? 0.0 : 1.0 / fps,
                               .state = std::as_writable_bytes(std::span(state)),
                               .scratch = std::as_writable_bytes(std::span(scratch)),
                               .tails = tails});
      if (frame * kLooks % fps == 0) seen.insert(seen.end(), tails.begin(), tails.end());
    }
    return seen;
  }

 private:
  Scene scene_;
  SpringSetup setup_;
};

double farthest_tail_mm(const Places& a, const Places& b) {
  double farthest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) farthest = std::max(farthest, 1e3 * safe_length(a[i] - b[i]));
  return farthest;
}

struct StepRule {
  const char *name, *note;
  double tick_s;
};
constexpr StepRule kStepRules[] = {
    {"ticks of 1/60 s", "VRM's own rate, at which characters are tuned", 1.0 / 60.0},
    {"ticks of 1/120 s", "drag and pull are those of 1/60 s, spread over two ticks", 1.0 / 120.0},
    {"ticks of 1/240 s", "drag and pull are those of 1/60 s, spread over four ticks", 1.0 / 240.0},
    {"a step a frame", "with exact exponential drag, and without ticks: hair depends on the frame rate", 0.0}};

std::string hair_point(const char* rule, int fps) { return fmt::format("{}, {} Hz", rule, fps); }

/// The column of how far a run is from the run of its rule at 60 Hz.
constexpr const char* kOff = "off 60 Hz";
double off_of(const Point& point) {
  for (const Value& value : point.values)
    if (value.name == kOff) return value.value;
  return 0.0;
}

std::vector<std::string> findings_of_springs(const Group& group) {
  const Point &usual = default_of(group), *slow = find(group, hair_point(kStepRules[0].name, 30)),
              *step = find(group, hair_point(kStepRules[3].name, 30)),
              *fine = find(group, hair_point(kStepRules[2].name, 60));
  return {fmt::format("With {} hair at 30 Hz is {} from hair at 60 Hz; with {} it is {} off.", kStepRules[0].name,
                      length(off_of(*slow)), kStepRules[3].name, length(off_of(*step))),
          fmt::format("A second of {} takes {} and is up to {} from a fine step; {} are {} off, and that {}.",
                      kStepRules[0].name, time_of(group, usual), error_of(group, usual), kStepRules[2].name,
                      error_of(group, *fine), time_beside(group, *fine, usual))};
}

}  // namespace

Study study_springs(const Subject&) {
  Study study;
  Group& group = study.group;
  group.name = "springs";
  group.title = "Springs";
  group.question = "What does hair cost that swings alike at any frame rate?";
  group.about = fmt::format(
      "{} built-in hairs of {} joints and 0.4 m, on a head that goes round a figure of eight of 0.2 m once a second, "
      "for "
      "{} seconds. Truth is a step of 1/{} s. VRM's equation has its step in it, so files that are tuned at 1/60 s "
      "want "
      "ticks of 1/60 s.",
      kHairs, kLong, kSeconds, kFineHz);
  group.error_name = "farthest that a tail is from a fine step";
  group.error_unit = "mm";
  group.rounding = 1e-3;
  group.item = "joint and second";
  const auto hair = std::make_shared<Hair>();
  const Places truth = hair->run(1.0 / kFineHz, kFineHz);
  for (const StepRule& rule : kStepRules) {
    const Places usual = hair->run(rule.tick_s, 60);
    for (const int fps : {30, 60, 144}) {
      const Places found = hair->run(rule.tick_s, fps);
      Point point;
      point.name = hair_point(rule.name, fps);
      point.note = rule.note;
      point.error = farthest_tail_mm(found, truth);
      point.is_default = rule.tick_s == kStepRules[0].tick_s && fps == 60;
      point.values = {{kOff, farthest_tail_mm(found, usual), "mm"}};
      study.add(std::move(point), {static_cast<std::size_t>(kJoints * kSeconds),
                                   [hair, tick_s = rule.tick_s, fps] { hair->run(tick_s, fps); }});
    }
  }
  study.findings = findings_of_springs;
  return study;
}

}  // namespace sinew::cost
