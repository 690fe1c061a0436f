// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <memory>

#include <fmt/format.h>

#include "importer/tool/cost/other_body.h"
#include "importer/tool/cost/studies.h"
#include "importer/tool/cost/words.h"
#include "runtime/math/quaternion.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/pose/sample_clip.h"
#include "runtime/retarget/hold_feet.h"
#include "runtime/retarget/humanoid_bones.h"
#include "runtime/retarget/retarget_animation.h"
#include "runtime/retarget/retarget_pose.h"

namespace sinew::cost {
namespace {

constexpr const char* kCopied = "plain copy";

/// Both bodies, and the poses that are retargeted for timing.
struct Bodies {
  Bodies(const Subject& subject, OtherBody made)
      : source(subject.scene.skeleton), other(std::move(made)), animation(*subject.animation()) {
    for (const double time_s : timed_moments(animation.duration_s)) {
      PoseMemory& pose = poses.emplace_back(source.joint_count());
      run_unchecked(SampleClipJob{
          .clip = &subject.scene.clips[subject.clip], .time_s = time_s, .pose = pose.span(), .weights = {}});
    }
  }

  const Skeleton& source;
  OtherBody other;
  const Animation& animation;
  std::vector<PoseMemory> poses;
  PoseMemory scratch{source.joint_count()}, out{source.joint_count()};
};

/// Maps joints that are the same bone, and the root joints. Names are not used, although both bodies share them.
SkeletonMap map_by(const Bodies& bodies, TranslationRule rule) {
  SkeletonMapOptions options{.pairs = {}, .limbs = LimbDirections::of_source, .translations = rule, .chains = {}};
  const std::vector<std::uint32_t> bones = find_humanoid_bones(bodies.source);
  for (const std::uint32_t joint : bones)
    if (joint != kNone) options.pairs.push_back({joint, joint});
  if (const std::uint32_t root = find_root_joint(bodies.source, bones[humanoid_bone("hips")]); root != kNone)
    options.pairs.push_back({root, root});
  return make_skeleton_map(bodies.source, bodies.other.skeleton, options);
}

/// How far joints are from the paths of the source's joints, scaled by the height ratio. Both paths count from the rest
/// pose.
double path_error_mm(const Bodies& bodies, double ratio, const Animation& retargeted,
                     std::span<const std::uint32_t> joints, std::span<const double> moments) {
  const Skeleton &source = bodies.source, &target = bodies.other.skeleton;
  const ModelPose source_rest = model_pose(source, rest_pose(source)), rest = model_pose(target, rest_pose(target));
  double largest = 0.0;
  for (const double time_s : moments) {
    const ModelPose from = model_pose(source, true_local_pose(source, bodies.animation, time_s)),
                    to = model_pose(target, true_local_pose(target, retargeted, time_s));
    for (const std::uint32_t j : joints) {
      const Vec3<double> path = translation_of(from[j]) - translation_of(source_rest[j]),
                         own = translation_of(to[j]) - translation_of(rest[j]);
      largest = std::max(largest, safe_length(own - path * ratio));
    }
  }
  return 1e3 * largest;
}

Point point_of(const Bodies& bodies, const Animation& retargeted, const SkeletonMap& map, const FeetMap& feet,
               std::span<const double> moments) {
  const FootSlide slide = measure_foot_slide(feet, bodies.animation, bodies.source, retargeted, bodies.other.skeleton);
  Point point;
  point.error = 1e3 * slide.largest;
  point.values = {{"hands", path_error_mm(bodies, map.height_ratio, retargeted, bodies.other.hands, moments), "mm"},
                  {"feet", path_error_mm(bodies, map.height_ratio, retargeted, bodies.other.feet, moments), "mm"}};
  return point;
}

struct Rule {
  const char *name, *note;
  TranslationRule rule;
};
constexpr Rule kRules[] = {
    {"hips by height", "the path of the hips is scaled by the ratio of their heights, bones keep their length",
     TranslationRule::hips_by_height},
    {"by length", "each joint is scaled by the lengths of its bone in both bodies", TranslationRule::by_length},
    {"keep", "all joints, also the hips, keep their place against their parent", TranslationRule::keep}};

void add_rule(Study& study, const std::shared_ptr<Bodies>& bodies, const Rule& rule, bool held,
              std::span<const double> moments) {
  const Skeleton &source = bodies->source, &target = bodies->other.skeleton;
  struct Tables {
    RetargetTables tables;
    FeetMap feet;
    float ground = 0.0f;
  };
  const SkeletonMap map = map_by(*bodies, rule.rule);
  const auto own = std::make_shared<Tables>();
  own->tables = make_retarget_tables(map, source, target);
  own->feet = make_feet_map(map, source, target);
  own->ground = static_cast<float>(find_ground(own->feet, bodies->animation, source));
  Animation retargeted = retarget_animation(bodies->animation, map, source, target);
  if (held) hold_feet(own->feet, bodies->animation, source, target, retargeted);
  Point point = point_of(*bodies, retargeted, map, own->feet, moments);
  point.name = fmt::format("{}{}", rule.name, held ? ", held feet" : "");
  point.note = rule.note;
  point.is_default = rule.rule == TranslationRule::hips_by_height && !held;
  const auto work = [bodies, own, held] {
    for (PoseMemory& pose : bodies->poses) {
      run_unchecked(RetargetPoseJob{&own->tables, pose.span(), bodies->scratch.span(), bodies->out.span()});
      if (held) run_unchecked(HoldFeetJob{&own->feet, own->ground, pose.span(), bodies->out.span()});
    }
  };
  study.add(std::move(point), {bodies->poses.size() * source.joint_count(), work});
}

/// Adds the variant without retargeting: the local transforms of one body are used on the other, which gets its bone
/// lengths.
void add_copy(Study& study, const std::shared_ptr<Bodies>& bodies, std::span<const double> moments) {
  const SkeletonMap map = map_by(*bodies, TranslationRule::hips_by_height);
  const FeetMap feet = make_feet_map(map, bodies->source, bodies->other.skeleton);
  Animation copied = bodies->animation;
  copied.weights.clear();
  copied.properties.clear();
  Point point = point_of(*bodies, copied, map, feet, moments);
  point.name = kCopied;
  point.note = "local transforms as they are: moved bones take the lengths of the other body";
  point.other_aim = true;
  const auto work = [bodies] {
    for (PoseMemory& pose : bodies->poses)
      std::memcpy(bodies->out.span().planes, pose.span().planes,
                  PoseSpan::floats_for(bodies->source.joint_count()) * sizeof(float));
  };
  study.add(std::move(point), {bodies->poses.size() * bodies->source.joint_count(), work});
}

std::vector<std::string> findings_of_retargeting(const Group& group) {
  const Point &free = default_of(group), *held = find(group, free.name + ", held feet"), *copy = find(group, kCopied);
  return {fmt::format("A pose on another body takes {}, {} times a plain copy of its numbers; holding the feet {}.",
                      time_of(group, free), number(free.time_ns / copy->time_ns), time_beside(group, *held, free)),
          fmt::format("Feet on the ground stray up to {} from the source's paths, scaled by heights, and {} when they "
                      "are held.",
                      error_of(group, free), error_of(group, *held))};
}

}  // namespace

Study study_retargeting(const Subject& subject) {
  Study study;
  Group& group = study.group;
  group.name = "retargeting";
  group.title = "Retargeting";
  group.question = "What does a clip cost on a body of other proportions, and how far do its feet slide?";
  group.error_name = "farthest that a foot on the ground slides";
  group.error_unit = "mm";
  group.item = "joint";
  if (subject.animation() == nullptr) return left_out(std::move(study), "The file has no clip.");
  auto body = other_body(subject.scene.skeleton);
  if (!body) return left_out(std::move(study), "The names of the joints are not those of a human body.");
  const auto bodies = std::make_shared<Bodies>(subject, *std::move(body));
  group.about = fmt::format(
      "{}, on a body on the same joints: three quarters as large, its legs a tenth shorter than that and its arms a "
      "tenth longer. Truth are the paths of hands and feet in the file, from where they rest, scaled by the height of "
      "the hips.",
      sentence(subject.clip_name()));
  std::vector<double> moments = times_of_large_errors(*subject.animation(), subject.effort.key_intervals);
  moments.push_back(subject.animation()->duration_s);
  for (const Rule& rule : kRules)
    for (const bool held : {false, true}) add_rule(study, bodies, rule, held, moments);
  add_copy(study, bodies, moments);
  study.findings = findings_of_retargeting;
  return study;
}

}  // namespace sinew::cost
